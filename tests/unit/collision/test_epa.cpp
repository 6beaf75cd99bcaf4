// EPA: closed forms in overlap, differences without volume, and what may not change under swap, motion, scale and
// tolerance.
#include <vector>

#include "carom_test.h"
#include "collision/narrow/query.h"
#include "random_pairs.h"

using namespace carom;
using namespace carom::test;

namespace {

QueryResult ask(const Shape& a, const Shape& b, const Frame& b_in_a, Real tolerance = 1e-6, int epa_cap = 256) {
  QuerySettings settings;
  settings.tolerance = tolerance;
  settings.epa_cap = epa_cap;
  QueryResult result;
  SupportFault fault;
  generic_distance(a, b, b_in_a, settings, nullptr, result, fault);
  return result;
}

bool holds(const QueryResult& r, Real truth) { return r.lower <= truth && truth <= r.upper; }
bool meet(const QueryResult& r, const QueryResult& s, Real slack) {
  return r.lower <= s.upper + slack && s.lower <= r.upper + slack;
}

}  // namespace

static void aligned_boxes_part_along_the_shallowest_axis(void**) {
  const Shape a = box(Vec3(1, 2, 3)), b = box(Vec3(0.5, 1, 0.25));
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = random.in_cube(1).times(Vec3(1.4, 2.9, 3.2));
    const Vec3 overlap = Vec3(1.5, 3, 3.25) - p.abs();
    const int axis = overlap.min_axis();
    const Real depth = overlap[axis];
    const QueryResult r = ask(a, b, Frame(Mat3::identity(), p));
    assert_true(holds(r, -depth) && r.upper - r.lower <= 1e-6 * b.bounding_radius);
    // The normal is unique where the second axis is deeper by more than the gap allows.
    Vec3 rest = overlap;
    rest[axis] = kInfinity;
    if (rest.min_entry() - depth > 1e-4) assert_true(r.normal[axis] * p[axis] >= (1 - 1e-6) * std::fabs(p[axis]));
    // Sliding B along the normal by the depth brings the witness points together, up to the gap and the directions
    // across.
    const Vec3 between = p + r.point_b - r.point_a;
    assert_true(std::fabs(r.normal.dot(between) - r.separation) <= 1e-6 * b.bounding_radius);
  }
}

static void one_inside_the_other_adds_up(void**) {
  assert_true(holds(ask(box(Vec3(1, 2, 3)), box(Vec3(0.1, 0.2, 0.3)), at(0, 0, 0)), -1.1));
  assert_true(holds(ask(sphere(1), box(Vec3(0.2, 0.3, 0.4)), at(0, 0, 0)), -1.2));
  assert_true(holds(ask(sphere(1), sphere(0.5), at(0, 0, 0)), -1.5));
  assert_true(holds(ask(capsule(0.5, 1), capsule(0.25, 2), at(0, 0, 0)), -0.75));
  assert_true(holds(ask(cylinder(1, 2), cylinder(0.5, 3), at(0, 0, 0)), -1.5));
  assert_true(holds(ask(ellipsoid(Vec3(1, 2, 3)), ellipsoid(Vec3(0.1, 0.2, 0.3)), at(0, 0, 0)), -1.1));
  assert_true(holds(ask(cone(1, 1), sphere(0), at(0, -0.9, 0)), -0.1));
}

static void a_ring_of_equal_answers_still_gives_the_value(void**) {
  // Coaxial: every direction across is as good, EPA would refine them all; the bound from below is exact along the
  // first few.
  const QueryResult r = ask(cylinder(0.3, 1), sphere(0), at(0, 0, 0));
  assert_true(holds(r, -0.3) && std::fabs(r.separation + 0.3) <= 1e-14);
  // Cone on cone, tip past tip by 0.1: the flank's normal is at 1 : 0.5 to the axis, depth 0.1 * 0.5 / sqrt(1.25).
  Mat3 over = Mat3::diagonal(Vec3(1, -1, -1));
  const QueryResult tips = ask(cone(1, 1), cone(1, 1), Frame(over, Vec3(0, 1.9, 0)));
  const Real truth = -0.1 / std::sqrt(1.25) * 0.5;
  assert_true(holds(tips, truth) && std::fabs(tips.separation - truth) <= 1e-6 * std::sqrt(2.0));
}

static void differences_without_volume_are_touching(void**) {
  const Shape triangle = hull({Vec3(1, 0, 0), Vec3(-1, 0, 1), Vec3(-1, 0, -1)});
  const Shape stick = hull({Vec3(1, 0, 0), Vec3(-1, 0, 0)});
  const Shape dot = hull({Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, 0)});
  const Shape* const flats[] = {&triangle, &stick, &dot};
  for (const Shape* a : flats) {
    for (const Shape* b : flats) {
      for (const Real shift : {0.0, 0.25}) {
        if (shift > 0 && (a == &dot && b == &dot)) continue;
        const QueryResult r = ask(*a, *b, at(shift, 0, 0));
        assert_true(holds(r, 0) && r.upper - r.lower <= 1e-13);
        assert_true(carom::finite(r.normal) && std::fabs(r.normal.norm() - 1) <= 4 * kEpsilon);
      }
    }
  }
  // Crossing segments: the difference is a parallelogram, and what is left of the depth are the radii.
  const Mat3 quarter = Mat3(0, -1, 0, 1, 0, 0, 0, 0, 1);
  const QueryResult crossed = ask(capsule(0.5, 1), capsule(0.25, 1), Frame(quarter, Vec3(0, 0, 0)));
  assert_true(holds(crossed, -0.75) && crossed.upper - crossed.lower <= 1e-13);
  assert_true(std::fabs(std::fabs(crossed.normal.z()) - 1) <= 1e-12);
}

static void touching_is_told_to_rounding(void**) {
  const Shape cube = box(Vec3(1, 1, 1));
  for (int digits = 1; digits <= 16; ++digits) {
    for (const Real sign : {1.0, -1.0}) {
      const Real gap = sign * std::pow(10.0, -digits);
      // The offset is rounded: the truth is what is left of it.
      const Real x = 2 + gap;
      for (const Vec3& p : {Vec3(x, 0, 0), Vec3(x, 0.3, 0.1), Vec3(x, 1.9, -1.9)}) {
        const QueryResult r = ask(cube, cube, Frame(Mat3::identity(), p), 1e-12);
        assert_true(holds(r, x - 2) && r.upper - r.lower <= 1e-12 * std::sqrt(3.0));
      }
    }
  }
}

static void swap_motion_and_scale_change_nothing(void**) {
  Random random(53);
  for (int i = 0; i < 300; ++i) {
    const ShapePair p = random_pair(random, i % kFamilyCount, (i / 3) % kFamilyCount, random.uniform(-0.3, 0.1));
    const Real size = std::min(p.a.bounding_radius, p.b.bounding_radius), asked = 1e-6 * size;
    const QueryResult r = ask(p.a, p.b, p.b_in_a);
    // Two brackets of the same number meet; what the pose lost by being rounded is added: 4 eps of its offset and the
    // sizes.
    const Real reach = p.b_in_a.p.norm() + p.a.bounding_radius + p.b.bounding_radius;
    const Frame a_in_b(p.b_in_a.r.transpose(), -(p.b_in_a.r.transpose() * p.b_in_a.p));
    const QueryResult swapped = ask(p.b, p.a, a_in_b);
    assert_true(meet(r, swapped, 4 * kEpsilon * reach));
    // Both moved along in the world, far from its origin: the difference of positions has lost eps of 1000 m.
    const Frame a_w(random_rotation(random).matrix(), 1000 * random.direction());
    const QueryResult moved = ask(p.a, p.b, relative(a_w, a_w * p.b_in_a));
    assert_true(meet(r, moved, 8 * kEpsilon * (1000 + reach)));
    // EPA may be capped (rings); otherwise the bracket is as narrow as asked.
    for (const QueryResult* q : {&r, &swapped, &moved})
      assert_true(q->status == QueryStatus::capped || q->upper - q->lower <= asked);
  }
}

static void a_smaller_tolerance_is_never_worse(void**) {
  Random random(59);
  for (int i = 0; i < 60; ++i) {
    const ShapePair p = random_pair(random, 5 + i % 3, 5 + (i / 3) % 3, random.uniform(-0.3, 0.3));
    const Real size = std::min(p.a.bounding_radius, p.b.bounding_radius);
    const QueryResult best = ask(p.a, p.b, p.b_in_a, 1e-12, 512);
    Real width = kInfinity;
    for (const Real tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10}) {
      const QueryResult r = ask(p.a, p.b, p.b_in_a, tolerance);
      assert_true(meet(r, best, 0));
      assert_true(r.upper - r.lower <= width);
      assert_true(r.status == QueryStatus::capped ||
                  std::fabs(r.separation - best.separation) <= tolerance * size + (best.upper - best.lower));
      width = r.upper - r.lower;
    }
  }
}

static void a_cap_keeps_the_bracket_true(void**) {
  Random random(61);
  for (int i = 0; i < 100; ++i) {
    const ShapePair p = random_pair(random, 7, 5, -0.2);
    const QueryResult full = ask(p.a, p.b, p.b_in_a, 1e-9, 512);
    for (const int cap : {1, 4, 12}) {
      const QueryResult capped = ask(p.a, p.b, p.b_in_a, 1e-9, cap);
      assert_true(capped.epa_iterations <= cap);
      assert_true(meet(full, capped, 0));
      assert_int_equal(static_cast<int>(capped.status), static_cast<int>(QueryStatus::capped));
    }
  }
}

static void the_three_simplex_dials_and_both_methods_meet(void**) {
  Random random(67);
  for (int i = 0; i < 300; ++i) {
    const ShapePair p = random_pair(random, i % kFamilyCount, (i / 4) % kFamilyCount, random.uniform(-0.2, 0.2));
    const QueryResult reference = ask(p.a, p.b, p.b_in_a);
    for (const Simplex simplex : {Simplex::johnson, Simplex::voronoi, Simplex::voronoi_last}) {
      QuerySettings settings;
      settings.simplex = simplex;
      settings.method = Method::hybrid;
      settings.margin = 0x1p-8;  // a power of two: taking it off again costs no bit
      QueryResult r;
      SupportFault fault;
      generic_distance(p.a, p.b, p.b_in_a, settings, nullptr, r, fault);
      r.lower += 2 * settings.margin;
      r.upper += 2 * settings.margin;
      assert_true(meet(reference, r, kEpsilon));
    }
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(aligned_boxes_part_along_the_shallowest_axis),
      cmocka_unit_test(one_inside_the_other_adds_up),
      cmocka_unit_test(a_ring_of_equal_answers_still_gives_the_value),
      cmocka_unit_test(differences_without_volume_are_touching),
      cmocka_unit_test(touching_is_told_to_rounding),
      cmocka_unit_test(swap_motion_and_scale_change_nothing),
      cmocka_unit_test(a_smaller_tolerance_is_never_worse),
      cmocka_unit_test(a_cap_keeps_the_bracket_true),
      cmocka_unit_test(the_three_simplex_dials_and_both_methods_meet),
  };
  return cmocka_run_group_tests_name("collision/epa", tests, nullptr, nullptr);
}
