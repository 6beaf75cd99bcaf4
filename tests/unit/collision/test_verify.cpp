// Invalid plugins and valid functions before the questions of verify.h: every invalid plugin is caught with its
// witness, no valid one is.
#include <cstring>
#include <functional>

#include "carom_test.h"
#include "collision/directions.h"
#include "collision/verify.h"
#include "collision/volume.h"
#include "core/pose.h"
#include "shapes.h"

using namespace carom;
using namespace carom::test;

namespace {

Shape undeclared(SupportFn support, std::initializer_list<double> params = {1, 1, 1}) {
  Shape s(std::pmr::get_default_resource());
  s.support = support;
  s.params.assign(params.begin(), params.end());
  return s;
}

void each_valid_shape(const std::function<void(const Shape&)>& visit) {
  Random random(1);
  for (int trial = 0; trial < 30; ++trial) {
    const auto size = [&] { return std::pow(10.0, random.uniform(-6, 6)); };
    const auto three = [&] {
      const Real a = size(), b = size(), c = size();
      return Vec3(a, b, c);
    };
    visit(sphere(size()));
    visit(capsule(size(), size()));
    visit(box(three()));
    visit(cylinder(size(), size()));
    visit(cone(size(), size()));
    visit(ellipsoid(three()));
    std::vector<Vec3> points;
    // (the test hull does not scale its direction: 1e300 times a coordinate must stay finite)
    const Vec3 stretch = three(), offset = trial % 2 ? Vec3(30 * stretch) : Vec3(0, 0, 0);
    const int count = 1 + static_cast<int>(random.uniform(0, 100));
    for (int i = 0; i < count; ++i) points.push_back(stretch.times(random.direction()) + offset);
    visit(hull(points));
  }
}

Real length(const double* d) { return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]); }

// Invalid plugins: each is a unit ball, box or so with one thing wrong.
std::int32_t ball(const double* p, const double* d, double* out) { return ellipsoid_support(nullptr, p, 3, d, out); }
std::int32_t returns_nonzero(void*, const double* p, std::uint64_t, const double* d, double* out) {
  ball(p, d, out);
  return d[0] > 0.99 ? 1 : 0;
}
std::int32_t sometimes_nan(void*, const double* p, std::uint64_t, const double* d, double* out) {
  ball(p, d, out);
  if (d[1] < -0.9) out[2] = NAN;
  return 0;
}
std::int32_t infinite(void*, const double* p, std::uint64_t, const double* d, double* out) {
  ball(p, d, out);
  if (d[2] < -0.9) out[2] = -INFINITY;
  return 0;
}
std::int32_t counts_its_calls(void*, const double* p, std::uint64_t, const double* d, double* out) {
  static double calls = 0;
  ball(p, d, out);
  out[0] += 1e-15 * (calls += 1);  // far below any tolerance, but other bits
  return 0;
}
std::int32_t remembers_the_last_direction(void*, const double* p, std::uint64_t, const double* d, double* out) {
  static double last[3] = {1, 0, 0};
  ball(p, d, out);
  for (int i = 0; i < 3; ++i) out[i] += 1e-15 * last[i];
  std::memcpy(last, d, sizeof last);
  return 0;
}
std::int32_t as_long_as_the_direction(void*, const double*, std::uint64_t, const double* d, double* out) {
  std::memcpy(out, d, 3 * sizeof *d);  // the unit ball for unit directions only
  return 0;
}
std::int32_t squares_before_it_scales(void*, const double* p, std::uint64_t, const double* d, double* out) {
  const Real n = length(d);  // 0 for 1e-300, infinite for 1e300
  for (int i = 0; i < 3; ++i) out[i] = p[i] * d[i] / n;
  return 0;
}
std::int32_t unbounded(void*, const double*, std::uint64_t, const double* d, double* out) {
  for (int i = 0; i < 3; ++i) out[i] = 1e10 * d[i] / length(d);
  return 0;
}
// radius 1 to 1.5, dents between spikes
std::int32_t a_star(void*, const double*, std::uint64_t, const double* d, double* out) {
  const Real m = std::max({std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2])}), u[3] = {d[0] / m, d[1] / m, d[2] / m};
  const Real n = length(u), spike = std::fabs(u[0] * u[1] * u[2]) / (n * n * n);
  for (int i = 0; i < 3; ++i) out[i] = (1 + 2.5 * spike) * u[i] / n;
  return 0;
}
std::int32_t inside_out(void*, const double* p, std::uint64_t, const double* d, double* out) {
  box_support(nullptr, p, 3, d, out);
  for (int i = 0; i < 3; ++i) out[i] = -out[i];
  return 0;
}
std::int32_t radial_box(void*, const double*, std::uint64_t, const double* d,
                        double* out) {  // where the ray leaves the box: not its support
  const Real m = std::max({std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2])});
  for (int i = 0; i < 3; ++i) out[i] = d[i] / m;
  return 0;
}
std::int32_t forgets_a_corner(void*, const double* p, std::uint64_t, const double* d, double* out) {
  box_support(nullptr, p, 3, d, out);
  if (d[0] > 0 && d[1] > 0 && d[2] > 0) out[2] = -out[2];
  return 0;
}
std::int32_t shifted_by_direction(void*, const double* p, std::uint64_t, const double* d,
                                  double* out) {  // two different balls
  ball(p, d, out);
  out[0] += d[0] > 0 ? -0.01 : 0.01;
  return 0;
}
std::int32_t normalised_ellipsoid(void*, const double* p, std::uint64_t, const double* d,
                                  double* out) {  // the classic r d / |d|
  const Real m = std::max({std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2])}), u[3] = {d[0] / m, d[1] / m, d[2] / m};
  for (int i = 0; i < 3; ++i) out[i] = p[i] * u[i] / length(u);
  return 0;
}

}  // namespace

static void valid_shapes_of_all_sizes_and_aspects_pass(void**) {
  each_valid_shape([](const Shape& s) {
    const Verdict v = verify_support(s);
    assert_true(v.valid);
    assert_string_equal(v.reason, "");
  });
}

static void their_true_declarations_pass(void**) {
  each_valid_shape([](const Shape& s) {
    assert_true(verify_form(s, s.form).valid);
    assert_true(verify_mass(s, mass_from_form(s.form, s.radius, s.half_height, s.half, s.vertices)).valid);
  });
}

static void every_invalid_is_caught_for_what_it_does(void**) {
  const struct {
    SupportFn support;
    std::initializer_list<double> params;
    const char* reason;
  } invalid_plugins[] = {
      {returns_nonzero, {1, 1, 1}, "nonzero"},
      {sometimes_nan, {1, 1, 1}, "not finite"},
      {infinite, {1, 1, 1}, "not finite"},
      {counts_its_calls, {1, 1, 1}, "repeatable"},
      {remembers_the_last_direction, {1, 1, 1}, "repeatable"},
      {as_long_as_the_direction, {1, 1, 1}, "length"},
      {squares_before_it_scales, {1, 1, 1}, "not finite"},
      {unbounded, {1, 1, 1}, "1e9 m"},
      {a_star, {1, 1, 1}, "convex"},
      {inside_out, {1, 1, 1}, "convex"},
      {radial_box, {1, 1, 1}, "convex"},
      {forgets_a_corner, {1, 1, 1}, "convex"},
      {shifted_by_direction, {1, 1, 1}, "convex"},
      {normalised_ellipsoid, {1, 2, 3}, "convex"},
  };
  for (const auto& invalid_plugin : invalid_plugins) {
    const Shape s = undeclared(invalid_plugin.support, invalid_plugin.params);
    const Verdict v = verify_support(s);
    assert_false(v.valid);
    assert_non_null(std::strstr(v.reason, invalid_plugin.reason));
    assert_true(length(v.dir) > 0 || std::fabs(v.dir[0]) + std::fabs(v.dir[1]) + std::fabs(v.dir[2]) > 0);
  }
}

static void the_witness_is_what_the_function_said_bit_for_bit(void**) {
  for (SupportFn support : {sometimes_nan, unbounded, a_star, radial_box, normalised_ellipsoid, returns_nonzero}) {
    const Shape s = undeclared(support, {1, 2, 3});
    const Verdict v = verify_support(s);
    double out[3];
    support(s.user, s.params.data(), 3, v.dir, out);
    assert_memory_equal(out, v.out, sizeof out);
  }
}

static void a_missing_support_function_is_no_crash(void**) { assert_false(verify_support(undeclared(nullptr)).valid); }

static void an_error_of_rounding_is_no_lie_and_one_of_1e_6_is(void**) {
  // A ball whose radius depends on the direction by epsilon: valid as long as epsilon is below kSloppiness.
  static double epsilon;
  const SupportFn wobbly = [](void*, const double* p, std::uint64_t, const double* d, double* out) {
    ball(p, d, out);
    const Real m = std::max({std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2])}), u[3] = {d[0] / m, d[1] / m, d[2] / m};
    for (int i = 0; i < 3; ++i) out[i] *= 1 + epsilon * std::fabs(u[0] * u[1] * u[2]);
    return 0;
  };
  const Shape s = undeclared(wobbly);
  epsilon = 1e-14;
  assert_true(verify_support(s).valid);
  assert_true(verify_form(sphere(1), Form::sphere).valid);
  // A dent of depth e in a ball of radius 1 breaks convexity as seen from directions closer than sqrt(2 e): the 256
  // directions are some 0.2 apart, so dents below a few per cent hide between them, and it takes the form to see 1e-6.
  epsilon = 0.2;
  assert_false(verify_support(s).valid);
  Shape declared = undeclared(wobbly);
  declared.half = Vec3(1, 1, 1);
  epsilon = 1e-6;
  assert_false(verify_form(declared, Form::ellipsoid).valid);
  epsilon = 1e-14;
  assert_true(verify_form(declared, Form::ellipsoid).valid);
}

static void no_shape_passes_for_another(void**) {
  // Same numbers, same bounds, every pair of forms: only the right one is confirmed.
  const Shape shapes[] = {
      sphere(1),
      capsule(1, 0.5),
      box(Vec3(1, 1, 1)),
      cylinder(1, 1),
      cone(1, 1),
      ellipsoid(Vec3(1, 1, 1)),
      hull({Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})};
  for (const Shape& s : shapes)
    for (const Form form :
         {Form::sphere, Form::capsule, Form::box, Form::polytope, Form::cylinder, Form::cone, Form::ellipsoid}) {
      Shape claim = undeclared(s.support);
      claim.params = s.params;
      claim.core_radius = s.core_radius;
      claim.radius = 1;
      claim.half_height = form == Form::capsule ? 0.5 : 1;
      claim.half = Vec3(1, 1, 1);
      const double square[] = {1, 1, 1, -1, 1, 1, 1, -1, 1, -1, -1, 1, 1, 1, -1, -1, 1, -1, 1, -1, -1, -1, -1, -1};
      claim.vertices = s.form == Form::polytope ? std::span<const double>(s.vertices) : std::span<const double>(square);
      const bool ball_either_way =
          (s.form == Form::sphere && form == Form::ellipsoid) || (s.form == Form::ellipsoid && form == Form::sphere);
      const bool cube_either_way = s.form == Form::box && form == Form::polytope;
      assert_true(verify_form(claim, form).valid == (form == s.form || ball_either_way || cube_either_way));
    }
  assert_false(verify_form(sphere(1), Form::none).valid);
  assert_false(verify_form(sphere(1), Form::half_space).valid);
}

static void a_declared_number_off_by_1e_8_of_the_size_is_seen(void**) {
  Shape s = cylinder(0.5, 2);
  s.half_height += 2e-8 * 4;  // the cap shows 2e-8 of the extent 4; asked to 1e-9
  assert_false(verify_form(s, Form::cylinder).valid);
  s = sphere(3);
  s.core_radius *= 1 + 1e-8;
  assert_false(verify_form(s, Form::sphere).valid);
  s = hull({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)});
  std::vector<double> other(s.params.begin(), s.params.end());
  other[0] = -1e-8;
  s.vertices = other;
  assert_false(verify_form(s, Form::polytope).valid);
}

static void a_wrong_mass_is_caught_where_the_bracket_excludes_it(void**) {
  const Shape s = box(Vec3(1, 2, 3));
  const MassProperties right = mass_from_form(Form::box, 0, 0, s.half, {});
  assert_true(verify_mass(s, right).valid);
  MassProperties wrong = right;
  wrong.volume *= 1 + 1e-6;
  assert_false(verify_mass(s, wrong).valid);
  wrong = right;
  wrong.centroid.x() += 1e-6;
  assert_false(verify_mass(s, wrong).valid);
  wrong = right;
  wrong.inertia(0, 1) = wrong.inertia(1, 0) += 1e-5;
  assert_false(verify_mass(s, wrong).valid);
  for (const Real bad : {Real(NAN), kInfinity, -1.0}) {
    wrong = right;
    wrong.volume = bad;
    assert_false(verify_mass(s, wrong).valid);
    wrong = right;
    wrong.inertia(1, 1) = bad;
    assert_false(verify_mass(s, wrong).valid);
  }
  // A ball known to 10 %: a cube's mass is caught, its own passes.
  const Shape b = sphere(1);
  assert_true(verify_mass(b, mass_from_form(Form::sphere, 1, 0, Vec3::zero(), {})).valid);
  assert_false(verify_mass(b, mass_from_form(Form::box, 0, 0, Vec3(1, 1, 1), {})).valid);
  assert_false(verify_mass(b, mass_from_form(Form::sphere, 1.05, 0, Vec3::zero(), {})).valid);
}

static void the_asking_directions_are_unit_distinct_and_leave_no_gap(void**) {
  const auto dirs = asking_directions();
  for (int i = 0; i < kDirections; ++i) {
    assert_true(std::fabs(dirs[i].norm() - 1) <= 4 * kEpsilon);
    for (int j = 0; j < i; ++j) assert_true((dirs[i] - dirs[j]).norm() > 1e-3);
  }
  Random random(2);
  for (int trial = 0; trial < 20000; ++trial) {
    const Vec3 u = random.direction();
    Real best = -1;
    for (const Vec3& d : dirs) best = std::max(best, d.dot(u));
    assert_true(best >= std::cos(0.17));
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(valid_shapes_of_all_sizes_and_aspects_pass),
      cmocka_unit_test(their_true_declarations_pass),
      cmocka_unit_test(every_invalid_is_caught_for_what_it_does),
      cmocka_unit_test(the_witness_is_what_the_function_said_bit_for_bit),
      cmocka_unit_test(a_missing_support_function_is_no_crash),
      cmocka_unit_test(an_error_of_rounding_is_no_lie_and_one_of_1e_6_is),
      cmocka_unit_test(no_shape_passes_for_another),
      cmocka_unit_test(a_declared_number_off_by_1e_8_of_the_size_is_seen),
      cmocka_unit_test(a_wrong_mass_is_caught_where_the_bracket_excludes_it),
      cmocka_unit_test(the_asking_directions_are_unit_distinct_and_leave_no_gap),
  };
  return cmocka_run_group_tests_name("collision/verify", tests, nullptr, nullptr);
}
