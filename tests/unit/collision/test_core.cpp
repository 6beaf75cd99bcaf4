// The engine's own support points are those of the declared shapes; a plugin is asked where there is no such form, and
// believed where its answer is one.
#include "carom_test.h"
#include "collision/core.h"
#include "random_pairs.h"

using namespace carom;
using namespace carom::test;

namespace {

/// Directions all over, along the axes, and a hair's breadth beside them; zeros of both signs among the components.
std::vector<Vec3> directions(Random& random) {
  std::vector<Vec3> d;
  for (int i = 0; i < 3; ++i)
    for (const Real sign : {1.0, -1.0})
      for (const Real off : {0.0, -0.0, 1e-320, 1e-150, 1e-100, 1e-16, 1e-12, 1e-8}) {
        Vec3 n = sign * Vec3::unit(i);
        n[(i + 1) % 3] = off;
        n[(i + 2) % 3] = -off;
        d.push_back(n.normalized());
      }
  for (int i = 0; i < 200; ++i) d.push_back(random.direction());
  return d;
}

/// By how much a point lies outside a core, as a share of its size.
Real outside(const Shape& s, const Vec3& p) {
  const Real side = std::hypot(p.x(), p.z());
  switch (s.form) {
    case Form::sphere:
      return p.norm() / s.radius;
    case Form::capsule:
      return (side + std::max(0.0, std::fabs(p.y()) - s.half_height)) / s.half_height;
    case Form::cylinder:
      return std::max(side / s.radius - 1, std::fabs(p.y()) / s.half_height - 1);
    case Form::cone:
      return std::max(side / s.radius - 0.5 * (1 - p.y() / s.half_height), std::fabs(p.y()) / s.half_height - 1);
    case Form::ellipsoid:
      return p.over(s.half).norm() - 1;
    default:
      return p.abs().over(s.half).max_entry() - 1;
  }
}

std::int32_t never(void*, const double*, std::uint64_t, const double*, double*) { return 9; }

}  // namespace

static void every_closed_form_attains_what_its_function_attains(void**) {
  Random random(1);
  for (int trial = 0; trial < 60; ++trial) {
    const auto size = [&] { return std::pow(10.0, random.uniform(-6, 6)); };
    const Real a = size(), b = trial % 2 ? a * random.uniform(0.3, 3) : size(), c = size();
    for (const Shape& s :
         {sphere(a), capsule(a, b), box(Vec3(a, b, c)), cylinder(a, b), cone(a, b), ellipsoid(Vec3(a, b, c))}) {
      const bool corners = s.form == Form::sphere || s.form == Form::capsule || s.form == Form::box;
      for (const Vec3& n : directions(random)) {
        Vec3 asked, own;
        s.support(s.user, s.params.data(), s.params.size(), n.data(), asked.data());
        Core core(s);
        assert_true(core.support(n, own));
        // Four roundings a component at most (a square root, a quotient, two products), relative to the component; so
        // much may a point lie outside, and half of that again for this test's own division.
        assert_true(outside(s, own) <= 6 * kUnitRoundoff);
        // The value is a sum of terms n_i x_i, of which n_i h_i bounds each, h the half sides.
        const Real terms = n.abs().dot(s.bounds.hi);
        assert_true(n.dot(own) >= n.dot(asked) - 12 * kUnitRoundoff * terms);
        if (corners && n.product() != 0) assert_true(own == asked);
      }
    }
  }
}

static void zeros_of_either_sign_count_as_positive(void**) {
  const Shape brick = box(Vec3(1, 2, 3)), pill = capsule(1, 2), drum = cylinder(1, 2);
  for (const Real zero : {0.0, -0.0}) {
    Vec3 out;
    assert_true(Core(brick).support(Vec3(zero, zero, -1), out) && out == Vec3(1, 2, -3));
    assert_true(Core(pill).support(Vec3(1, zero, 0), out) && out == Vec3(0, 2, 0));
    assert_true(Core(drum).support(Vec3(1, zero, 0), out) && out == Vec3(1, 2, 0));
  }
}

static void a_known_form_does_not_need_its_function(void**) {
  Random random(2);
  std::vector<Vec3> corners;
  for (int i = 0; i < 200; ++i) corners.push_back(random.direction());
  Shape shapes[] = {sphere(1),      capsule(1, 2), box(Vec3(1, 2, 3)),
                    cylinder(1, 2), cone(1, 2),    ellipsoid(Vec3(1, 2, 3)),
                    hull(corners)};
  for (Shape& s : shapes) {
    s.support = never;
    Vec3 out;
    assert_true(Core(s).support(Vec3(0.6, 0, 0.8), out));
  }
  // Undeclared; declared, but swollen by a radius of its own; a polytope that was not arranged: these are asked.
  Shape bare = box(Vec3(1, 1, 1)), swollen = box(Vec3(1, 1, 1)), loose = hull(corners);
  bare.form = Form::none;
  swollen.core_radius = 0.1;
  loose.farthest = FarthestVertex(std::pmr::get_default_resource());
  for (Shape* s : {&bare, &swollen, &loose}) {
    s->support = never;
    Core core(*s);
    Vec3 out;
    SupportFault fault;
    assert_false(core.support(Vec3::unit_x(), out));
    core.blame(Vec3::unit_x(), out, fault);
    assert_int_equal(fault.kind, SupportFault::returned);
    assert_ptr_equal(fault.shape, s);
  }
}

static void a_hull_gives_one_of_its_vertices(void**) {
  Random random(3);
  for (const int count : {1, 4, 30, 300}) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) points.push_back(random.direction());
    const Shape s = hull(points);
    for (const Vec3& n : directions(random)) {
      Vec3 asked, own;
      s.support(s.user, s.params.data(), s.params.size(), n.data(), asked.data());
      assert_true(Core(s).support(n, own));
      assert_true(std::find(points.begin(), points.end(), own) != points.end());
      // 11 u (farthest_vertex.h) and this test's two products of three terms, 3 u each, for points within 1.
      assert_true(n.dot(own) >= n.dot(asked) - 17 * kUnitRoundoff);
    }
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(every_closed_form_attains_what_its_function_attains),
      cmocka_unit_test(zeros_of_either_sign_count_as_positive),
      cmocka_unit_test(a_known_form_does_not_need_its_function),
      cmocka_unit_test(a_hull_gives_one_of_its_vertices),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
