// Overlap: yes and no with proofs that are checked, ties of symmetric pairs, touch, targets, cost below a distance's.
#include "carom_test.h"
#include "collision/cast/overlap.h"
#include "random_pairs.h"

using namespace carom;
using namespace carom::test;

namespace {

OverlapResult ask(const Shape& a, const Shape& b, const Frame& b_in_a, Real target = 0, int cap = 128) {
  SupportFault fault;
  return overlap(a, b, b_in_a, target, 0, cap, fault);
}

/// How far a point is from a shape: the largest n . x - h(n) over many directions, a bound from below of the distance.
Real outside(const Shape& s, const Vec3& x, Random& random) {
  Real worst = -kInfinity;
  for (int i = 0; i < 60; ++i) {
    const Vec3 n = random.direction();
    worst = std::max(worst, n.dot(x - support_point(s, n)));
  }
  return worst;
}

}  // namespace

static void verdicts_agree_with_the_distance_and_their_proofs_hold(void**) {
  Random random(71);
  int apart = 0, over = 0, cheap = 0, dear = 0;
  for (int k = 0; k < 2000; ++k) {
    const int i = k % 9, j = k / 9 % 9;
    const ShapePair p = random_pair(random, i, j, std::pow(10.0, -random.uniform(0, 9)) * (k % 2 ? 0.3 : -0.3));
    const Real target = k % 5 ? 0 : 0.1;
    QueryResult d;
    SupportFault fault;
    generic_distance(p.a, p.b, p.b_in_a, QuerySettings(), nullptr, d, fault);
    const OverlapResult r = ask(p.a, p.b, p.b_in_a, target);
    dear += d.support_calls;
    cheap += r.support_calls;
    assert_true(r.outcome == Overlap::apart || r.outcome == Overlap::overlapping);
    if (r.outcome == Overlap::apart) {
      ++apart;
      assert_true(d.upper > target && r.separation_bound > target && r.separation_bound <= d.upper);
      // The plane, looked at again.
      const Real sup_a = r.normal.dot(support_point(p.a, r.normal));
      const Vec3 n_b = -p.b_in_a.rotate_inverse(r.normal);
      const Real sup_b = -n_b.dot(support_point(p.b, n_b)) + r.normal.dot(p.b_in_a.p);
      assert_true(sup_b - sup_a >= r.separation_bound - 1e-13);
    } else {
      ++over;
      assert_true(d.lower < target);
      assert_true(outside(p.a, r.point, random) <= 0.5 * target + 1e-12);
      assert_true(outside(p.b, p.b_in_a.apply_inverse(r.point), random) <= 0.5 * target + 1e-12);
    }
  }
  assert_true(apart > 700 && over > 700);
  assert_true(4 * cheap < 3 * dear);  // although half of these pairs are nearer to touching than 1e-5 m
}

static void concentric_and_symmetric_pairs_overlap(void**) {
  const Shape shapes[] = {box(Vec3(1, 1, 1)), box(Vec3(1, 2, 3)), sphere(1),
                          cylinder(1, 1),     cone(1, 1),         ellipsoid(Vec3(1, 2, 3))};
  for (const Shape& a : shapes)
    for (const Shape& b : shapes)
      for (const Frame& f : {at(0, 0, 0), at(0.5, 0, 0), at(0, 0.25, 0), at(0, 0, -0.5)})
        assert_true(ask(a, b, f).outcome == Overlap::overlapping);
}

static void touch_is_neither_and_a_hair_is_enough(void**) {
  const Shape cube = box(Vec3(0.5, 0.5, 0.5)), ball = sphere(0.5);
  for (const Shape* a : {&cube, &ball}) {
    assert_true(ask(*a, *a, at(1, 0, 0)).outcome == Overlap::touching);
    for (const Real hair : {1e-3, 1e-6, 1e-9, 1e-12, 1e-13}) {
      assert_true(ask(*a, *a, at(1 + hair, 0, 0)).outcome == Overlap::apart);
      assert_true(ask(*a, *a, at(1 - hair, 0, 0)).outcome == Overlap::overlapping);
    }
  }
}

static void flat_shapes_touch_at_most(void**) {
  const Shape plate = box(Vec3(1, 0, 1)), cube = box(Vec3(1, 1, 1));
  assert_true(ask(plate, plate, at(0, 0, 0)).outcome == Overlap::touching);
  assert_true(ask(plate, plate, at(0, 1e-12, 0)).outcome == Overlap::apart);
  assert_true(ask(plate, cube, at(0, 0.5, 0)).outcome == Overlap::overlapping);
  assert_true(ask(plate, plate, at(0, 0.05, 0), 0.1).outcome == Overlap::overlapping);
}

static void a_point_in_a_shape(void**) {
  const Shape s = box(Vec3(1, 2, 3));
  SupportFault fault;
  assert_true(overlap_with_point(s, Vec3(0.9, 1.9, -2.9), 0, 0, 128, fault).outcome == Overlap::overlapping);
  assert_true(overlap_with_point(s, Vec3(0.9, 2.1, -2.9), 0, 0, 128, fault).outcome == Overlap::apart);
  assert_true(overlap_with_point(s, Vec3(0.9, 2.1, -2.9), 0.2, 0, 128, fault).outcome == Overlap::overlapping);
  assert_true(overlap_with_point(s, Vec3(1, 2, 3), 0, 0, 128, fault).outcome == Overlap::touching);
}

static void the_cap_says_neither(void**) {
  Random random(72);
  for (int k = 0; k < 200; ++k) {
    const ShapePair p = random_pair(random, 7, 7, k % 2 ? 1e-7 : -1e-7);
    for (int cap = 1; cap < 8; ++cap) {
      const OverlapResult r = ask(p.a, p.b, p.b_in_a, 0, cap);
      assert_true(r.support_calls <= cap);
      if (r.outcome == Overlap::apart) assert_true(k % 2);
    }
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(verdicts_agree_with_the_distance_and_their_proofs_hold),
      cmocka_unit_test(concentric_and_symmetric_pairs_overlap),
      cmocka_unit_test(touch_is_neither_and_a_hair_is_enough),
      cmocka_unit_test(flat_shapes_touch_at_most),
      cmocka_unit_test(a_point_in_a_shape),
      cmocka_unit_test(the_cap_says_neither),
  };
  return cmocka_run_group_tests_name("collision/overlap", tests, nullptr, nullptr);
}
