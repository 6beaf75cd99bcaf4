// The shape plugins that come with Carom, as built: table, support function against closed forms, honesty at every
// size.
#include <carom/plugin.h>
#include <dlfcn.h>

#include <cstring>
#include <functional>
#include <string>

#include "carom_test.h"
#include "collision/verify.h"
#include "collision/volume.h"
#include "core/pose.h"
#include "shapes.h"

using namespace carom;
using namespace carom::test;

namespace {

using Params = std::vector<double>;
using Exact = long double;  // 64-bit mantissa, and no overflow at 1e300 squared

struct Direction {
  double d[3];
};

/// h(u) for unit u in extended precision.
using Value = std::function<Exact(const Params& p, const Exact u[3])>;

struct Case {
  const char* name;
  std::size_t params;  // 0: the hull, any number of triples
  Value value;
};

Exact across(const Exact u[3]) { return std::sqrt(u[0] * u[0] + u[2] * u[2]); }
Exact triple(const Params& p, const Exact u[3], std::size_t at = 0) {
  return p[at] * u[0] + p[at + 1] * u[1] + p[at + 2] * u[2];
}

const Case kCases[] = {
    {"sphere", 1, [](const Params& p, const Exact*) { return Exact(p[0]); }},
    {"capsule", 2, [](const Params& p, const Exact* u) { return p[1] * std::fabs(u[1]) + p[0]; }},
    {"box", 3,
     [](const Params& p, const Exact* u) {
       return p[0] * std::fabs(u[0]) + p[1] * std::fabs(u[1]) + p[2] * std::fabs(u[2]);
     }},
    {"cylinder", 2, [](const Params& p, const Exact* u) { return p[1] * std::fabs(u[1]) + p[0] * across(u); }},
    {"cone", 2, [](const Params& p, const Exact* u) { return std::max(p[1] * u[1], p[0] * across(u) - p[1] * u[1]); }},
    {"ellipsoid", 3,
     [](const Params& p, const Exact* u) {
       return std::sqrt((p[0] * u[0]) * (p[0] * u[0]) + (p[1] * u[1]) * (p[1] * u[1]) + (p[2] * u[2]) * (p[2] * u[2]));
     }},
    {"hull", 0,
     [](const Params& p, const Exact* u) {
       Exact h = triple(p, u);
       for (std::size_t i = 3; i < p.size(); i += 3) h = std::max(h, triple(p, u, i));
       return h;
     }},
    {"template", 2, [](const Params& p, const Exact* u) { return std::max(p[0] * across(u), p[1] * std::fabs(u[1])); }},
};

const carom_shape_plugin& plugin(const std::string& name) {
  void* library =
      dlopen((std::string(CAROM_PLUGIN_DIR) + "/" + name + ".so").c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (library == nullptr) print_error("%s\n", dlerror());
  assert_non_null(library);
  const auto* p = static_cast<const carom_shape_plugin*>(dlsym(library, CAROM_SHAPE_PLUGIN_SYMBOL));
  assert_non_null(p);
  return *p;
}

/// What the engine makes of a plugin's declarations.
Shape shape_of(const carom_shape_plugin& plugin, const Params& params) {
  Shape s(std::pmr::get_default_resource());
  s.support = plugin.support;
  s.params.assign(params.begin(), params.end());
  if (plugin.geometry == nullptr) return s;
  const carom_geometry& g = *plugin.geometry;
  s.form = static_cast<Form>(g.form);
  if (g.core_radius_param != CAROM_NO_PARAM) s.core_radius = params[g.core_radius_param];
  const auto arg = [&](int i) { return g.form_arg[i] == CAROM_NO_PARAM ? 0 : params[g.form_arg[i]]; };
  if (s.form == Form::box || s.form == Form::ellipsoid) {
    s.half = Vec3(arg(0), arg(1), arg(2));
  } else if (s.form == Form::polytope) {
    s.vertices = std::span<const double>(s.params).subspan(g.form_arg[0]);
  } else {
    s.radius = arg(0);
    s.half_height = arg(1);
  }
  return s;
}

/// Parameters over fourteen decades and with aspects up to 1e8.
Params some_params(const Case& c, Random& random) {
  const auto size = [&] { return std::pow(10.0, random.uniform(-6, 6)); };
  const Real base = std::pow(10.0, random.uniform(-6, -2));
  const bool slender = random.uniform(0, 1) < 0.3;
  Params p;
  if (c.params == 0) {
    const Vec3 stretch(size(), size(), size());
    for (int i = 0; i < 20; ++i) {
      const Vec3 v = stretch.times(random.direction());
      p.insert(p.end(), {v.x(), v.y(), v.z()});
    }
  }
  for (std::size_t i = 0; i < c.params; ++i) p.push_back(slender ? (i == 0 ? base * 1e8 : base) : size());
  return p;
}

/// Directions of every length: random ones, axes, coordinate planes, and ones with a component that nearly vanishes.
std::vector<Direction> some_directions(Random& random, int count) {
  std::vector<Direction> dirs;
  for (int i = 0; i < count; ++i) {
    Vec3 d = random.direction();
    if (i % 5 == 1) d[i % 3] = 0;
    if (i % 5 == 2) d[i % 3] *= 1e-12;
    if (i % 5 == 3) d[i % 3] = -0.0, d[(i + 1) % 3] = 0;
    const Real length = i % 2 ? 1 : std::pow(10.0, random.uniform(-300, 300));
    dirs.push_back({{length * d.x(), length * d.y(), length * d.z()}});
  }
  for (const Real tiny : {1e-300, 5e-324})
    for (int k = 0; k < 3; ++k)
      for (const Real sign : {1.0, -1.0}) {
        Direction nearly{{tiny, tiny, tiny}}, denormal{{0, -0.0, 0}};
        nearly.d[k] = sign;
        denormal.d[k] = sign * tiny;
        dirs.push_back(nearly);
        dirs.push_back(denormal);
      }
  return dirs;
}

void unit(const Direction& d, Exact u[3]) {
  const Exact x = d.d[0], y = d.d[1], z = d.d[2], n = std::sqrt(x * x + y * y + z * z);
  u[0] = x / n, u[1] = y / n, u[2] = z / n;
}

}  // namespace

static void every_plugin_has_a_well_formed_table(void**) {
  for (const Case& c : kCases) {
    const carom_shape_plugin& p = plugin(c.name);
    assert_int_equal(p.struct_size, sizeof(carom_shape_plugin));
    assert_int_equal(p.abi_major, CAROM_PLUGIN_ABI_MAJOR);
    assert_int_equal(p.abi_minor, CAROM_PLUGIN_ABI_MINOR);
    assert_int_equal(p.flags, 0);
    assert_string_equal(p.id, (std::string("carom.") + c.name).c_str());
    assert_int_equal(p.param_count, c.params == 0 ? 3 : c.params);
    assert_int_equal(p.param_tail_group, c.params == 0 ? 3 : 0);
    assert_int_equal(p.param_tail_min, c.params == 0 ? 1 : 0);
    for (std::uint32_t i = 0; i < p.param_count; ++i) {
      assert_true(p.params[i].name[0] != 0 && p.params[i].unit[0] != 0);
      assert_true(p.params[i].min < p.params[i].max);
    }
    assert_true((p.geometry == nullptr) == (std::strcmp(c.name, "template") == 0));
    if (p.geometry == nullptr) continue;
    assert_int_equal(p.geometry->struct_size, sizeof(carom_geometry));
    for (int i = 0; i < 4; ++i) {
      assert_true(p.geometry->form_arg[i] == CAROM_NO_PARAM || p.geometry->form_arg[i] < p.param_count);
      assert_true(p.geometry->mass_arg[i] == CAROM_NO_PARAM || p.geometry->mass_arg[i] < p.param_count);
    }
  }
}

static void support_values_are_right_to_rounding_for_every_length_of_direction_and_size_of_shape(void**) {
  Random random(1);
  for (const Case& c : kCases) {
    const carom_shape_plugin& plug = plugin(c.name);
    for (int trial = 0; trial < 60; ++trial) {
      const Params p = some_params(c, random);
      const Real core_radius = shape_of(plug, p).core_radius;
      for (const Direction& d : some_directions(random, 200)) {
        double out[3];
        assert_int_equal(plug.support(nullptr, p.data(), p.size(), d.d, out), 0);
        Exact u[3], got = core_radius, terms = core_radius;
        unit(d, u);
        for (int i = 0; i < 3; ++i) got += u[i] * out[i], terms += std::fabs(u[i] * out[i]);
        // A coordinate is the end of at most eight operations of relative error u; the direction's own components enter
        // exactly. A tie decided by rounding (cone, hull) costs the difference of the two candidates: a few u of the
        // same terms.
        const Exact expected = c.value(p, u), slack = 8 * kEpsilon * (terms + std::fabs(expected));
        assert_true(std::fabs(got - expected) <= slack);
      }
    }
  }
}

static void a_cone_chooses_between_tip_and_rim_to_the_last_digits(void**) {
  // The directions at right angles to the slanted side, tilted by a little: the wrong choice costs that little times
  // the size.
  Random random(5);
  for (const Case& c : kCases) {
    const bool cone = std::strcmp(c.name, "cone") == 0;
    if (!cone && std::strcmp(c.name, "template") != 0) continue;
    for (int trial = 0; trial < 300; ++trial) {
      const Params p = some_params(c, random);
      const Real turn = random.uniform(0, 6.28), slant = cone ? 2 * p[1] : p[1];
      const Real tilt = std::pow(10.0, random.uniform(-15, -3)) * (trial % 2 ? 1 : -1);
      const Direction d{{slant * std::cos(turn), p[0] * (1 + tilt), slant * std::sin(turn)}};
      double out[3];
      plugin(c.name).support(nullptr, p.data(), 2, d.d, out);
      Exact u[3], got = 0, terms = 0;
      unit(d, u);
      for (int i = 0; i < 3; ++i) got += u[i] * out[i], terms += std::fabs(u[i] * out[i]);
      assert_true(std::fabs(got - c.value(p, u)) <= 8 * kEpsilon * terms);  // as above
    }
  }
}

static void no_answer_lies_outside_the_set(void**) {
  Random random(2);
  for (const Case& c : kCases) {
    const carom_shape_plugin& plug = plugin(c.name);
    for (int trial = 0; trial < 10; ++trial) {
      const Params p = some_params(c, random);
      const Real core_radius = shape_of(plug, p).core_radius;
      const auto dirs = some_directions(random, 60);
      for (const Direction& a : dirs) {
        double out[3];
        plug.support(nullptr, p.data(), p.size(), a.d, out);
        for (const Direction& b : dirs) {
          Exact u[3], along = core_radius, terms = core_radius;
          unit(b, u);
          for (int i = 0; i < 3; ++i) along += u[i] * out[i], terms += std::fabs(u[i] * out[i]);
          assert_true(along <= c.value(p, u) + 8 * kEpsilon * terms);
        }
      }
    }
  }
}

static void the_same_question_gets_the_same_bits_and_so_does_its_double(void**) {
  Random random(3);
  for (const Case& c : kCases) {
    const carom_shape_plugin& plug = plugin(c.name);
    const Params p = some_params(c, random);
    std::vector<Vec3> first;
    const auto dirs = some_directions(random, 300);
    for (int round = 0; round < 2; ++round)
      for (std::size_t i = 0; i < dirs.size(); ++i) {
        Vec3 out;
        plug.support(nullptr, p.data(), p.size(), dirs[i].d, out.data());
        if (round == 0) first.push_back(out);
        assert_memory_equal(out.data(), first[i].data(), 3 * sizeof(double));
      }
    for (int i = 0; i < 300; ++i) {  // a power of two changes no mantissa as long as nothing is denormal
      const Vec3 d = random.direction();
      Vec3 out, scaled;
      plug.support(nullptr, p.data(), p.size(), d.data(), out.data());
      for (const Real scale : {0x1p-900, 0x1p-3, 2.0, 0x1p900}) {
        const Vec3 far = scale * d;
        plug.support(nullptr, p.data(), p.size(), far.data(), scaled.data());
        assert_memory_equal(out.data(), scaled.data(), 3 * sizeof(double));
      }
    }
  }
}

static void the_engine_believes_every_plugin_and_its_declarations(void**) {
  Random random(4);
  for (const Case& c : kCases) {
    const carom_shape_plugin& plug = plugin(c.name);
    std::vector<Params> all;
    for (int trial = 0; trial < 10; ++trial) all.push_back(some_params(c, random));
    if (c.params != 0) {  // the corners of what the plugin says is legal
      Params least, most;
      for (std::size_t i = 0; i < c.params; ++i)
        least.push_back(plug.params[i].min), most.push_back(plug.params[i].max);
      all.push_back(least);
      all.push_back(most);
      all.push_back(least);
      all.back()[0] = most[0];
      all.push_back(most);
      all.back()[0] = least[0];
    }
    for (const Params& p : all) {
      Shape s = shape_of(plug, p);
      SupportFault fault;
      const Verdict v = verify_support(s);
      if (!v.valid) print_error("%s: %s\n", c.name, v.reason);
      assert_true(v.valid);
      assert_true(derive_bounds(s, fault));
      assert_true(finite(s.bounds.lo) && finite(s.bounds.hi) && std::isfinite(s.bounding_radius));
      if (s.form != Form::none) {
        assert_true(verify_form(s, s.form).valid);
        const Verdict m = verify_mass(s, mass_from_form(s.form, s.radius, s.half_height, s.half, s.vertices));
        if (!m.valid) print_error("%s: %s\n", c.name, m.reason);
        assert_true(m.valid);
      }
      const MassProperties m = mass_from_support(s, 0.01, 400, fault);
      assert_int_equal(fault.kind, SupportFault::none);
      assert_true(m.volume > 0 && std::isfinite(m.volume) && m.inertia.all_finite() && finite(m.centroid));
    }
  }
}

static void the_template_is_measured_from_its_support_function_alone(void**) {
  // Two cones of height h on one disc: V = 2/3 pi r^2 h; each has I = 3/20 m r^2 + m h^2 / 10 across its base's centre.
  const Real r = 0.6, h = 1.4, pi = 3.14159265358979323846;
  const Shape s = shape_of(plugin("template"), {r, h});
  SupportFault fault;
  const MassProperties m = mass_from_support(s, 0, 2000, fault);
  const Real volume = 2 * pi * r * r * h / 3, along = 3 * volume * r * r / 10,
             over = volume * (3 * r * r / 20 + h * h / 10);
  assert_true(m.volume_min <= volume && volume <= m.volume_max);
  assert_true((m.volume_max - m.volume_min) / volume <
              1e-3);  // one curved direction: 1 / N^2 (see test_volume), N some hundreds
  assert_true(m.centroid.norm() <= m.centroid_error);
  const Mat3 exact = Mat3::diagonal(Vec3(over, along, over));
  assert_true((m.inertia - exact).norm() <= std::sqrt(3) * m.inertia_error);  // Frobenius <= sqrt 3 times spectral
  assert_true(m.inertia_error <= 0.01 * over);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(every_plugin_has_a_well_formed_table),
      cmocka_unit_test(support_values_are_right_to_rounding_for_every_length_of_direction_and_size_of_shape),
      cmocka_unit_test(a_cone_chooses_between_tip_and_rim_to_the_last_digits),
      cmocka_unit_test(no_answer_lies_outside_the_set),
      cmocka_unit_test(the_same_question_gets_the_same_bits_and_so_does_its_double),
      cmocka_unit_test(the_engine_believes_every_plugin_and_its_declarations),
      cmocka_unit_test(the_template_is_measured_from_its_support_function_alone),
  };
  return cmocka_run_group_tests_name("collision/plugins", tests, nullptr, nullptr);
}
