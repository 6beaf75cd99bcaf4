// Capsules beside capsules and on boxes: the second point where they lie, and cores that cross.
#include <algorithm>

#include "carom_test.h"
#include "pair_cases.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kReach = 0.01;  // m: the default contact distance
constexpr Real kRightAngle = 1.57079632679489661923;

Candidates contacts(const Shape& a, const Shape& b, const Vec3& phi, const Vec3& at, Real reach = kReach) {
  Candidates found;
  pair_entry(a.form, b.form).routine(a, b, Frame(exp_map(phi).matrix(), at), reach, found);
  return found;
}

/// Whether some point of A lies at height y (along A's y).
bool touches_at(const Candidates& found, Real y, Real tol) {
  return std::any_of(found.point, found.point + found.count,
                     [&](const ContactPoint& p) { return std::fabs(p.on_a.y() - y) <= tol; });
}

}  // namespace

static void capsules_side_by_side_touch_at_both_ends_of_the_common_stretch(void**) {
  const Shape pill = capsule(0.2, 0.5), stub = capsule(0.1, 0.1);
  for (const Real tilt : {0.0, 1e-17, 1e-12, 1e-9, 1e-6, 1e-3}) {
    const Candidates found = contacts(pill, pill, Vec3(0, 0, tilt), Vec3(0.399, 0.3, 0));
    assert_true(found.count >= 2);
    assert_true(touches_at(found, -0.2, 2e-3) && touches_at(found, 0.5, 2e-3));
    for (int k = 0; k < found.count; ++k)
      assert_true(std::fabs(found.point[k].separation + 1e-3) <= tilt + 8 * kEpsilon);
    const Candidates within = contacts(pill, stub, Vec3(2 * kRightAngle, 0, tilt), Vec3(0.299, 0.3, 0));  // upside down
    assert_true(touches_at(within, 0.2, 2e-3) && touches_at(within, 0.4, 2e-3));
  }
  // One behind the other, on one line: one point between their ends.
  const Candidates behind = contacts(pill, pill, Vec3::zero(), Vec3(0, 1.399, 0));
  assert_int_equal(behind.count, 1);
  assert_true((behind.point[0].normal - Vec3::unit_y()).norm() <= 4 * kEpsilon);
  assert_true(std::fabs(behind.point[0].separation + 1e-3) <= 8 * kEpsilon);
}

static void cores_that_cross_part_square_to_both(void**) {
  const Shape pill = capsule(0.2, 0.5);
  for (const Real angle : {1e-6, 1e-3, 0.5, kRightAngle}) {
    for (const Real gap : {0.0, 1e-15, 1e-12, 1e-9}) {
      const Candidates found = contacts(pill, pill, Vec3(0, 0, angle), Vec3(0, 0, gap), kInfinity);
      assert_true(std::fabs(deepest(found)->separation + 0.4) <= 2e-8);
      assert_true(std::fabs(std::fabs(deepest(found)->normal.z()) - 1) <= 1e-6);
    }
  }
  const Candidates same = contacts(pill, pill, Vec3::zero(), Vec3::zero(), kInfinity);
  assert_true(std::fabs(deepest(same)->separation + 0.4) <= 8 * kEpsilon);
  assert_true(std::fabs(deepest(same)->normal.y()) <= 8 * kEpsilon);
}

static void a_capsule_lies_on_a_box_with_two_points(void**) {
  const Shape table = box(Vec3(1, 1, 1)), pill = capsule(0.2, 0.5);
  for (const Real tilt : {0.0, 1e-12, 1e-6, 1e-3}) {
    for (const Real x : {0.0, 0.8}) {  // all of it above the face; overhanging by 0.3
      const Candidates found = contacts(table, pill, Vec3(0, 0, kRightAngle + tilt), Vec3(x, 1.199, 0.4));
      assert_int_equal(found.count, 2);
      Real lo = kInfinity, hi = -kInfinity;
      for (int k = 0; k < 2; ++k) {
        lo = std::min(lo, found.point[k].on_a.x()), hi = std::max(hi, found.point[k].on_a.x());
        assert_true(found.point[k].normal.y() > 1 - 1e-6);
        assert_true(std::fabs(found.point[k].separation + 1e-3) <= 0.5 * tilt + 1e-9);
      }
      assert_true(std::fabs(lo - (x - 0.5)) <= 1e-3 && std::fabs(hi - std::min(x + 0.5, 1.0)) <= 1e-3);
    }
  }
  assert_int_equal(contacts(table, pill, Vec3::zero(), Vec3(0, 1.7, 0)).count, 1);             // standing
  assert_int_equal(contacts(table, pill, Vec3(0, 0, 0.7), Vec3(1.2, 1.05, 0)).count, 1);       // across an edge
  assert_int_equal(contacts(table, pill, Vec3(0, 0, kRightAngle), Vec3(0, 1.3, 0)).count, 0);  // out of reach
}

static void a_core_through_a_box_takes_the_shortest_way_out(void**) {
  const Shape table = box(Vec3(1, 0.3, 2)), spear = capsule(0.05, 3);
  // Along x through the middle: up or down, 0.3 + 0.05.
  const Candidates along = contacts(table, spear, Vec3(0, 0, kRightAngle), Vec3(0, 0.1, 0), kInfinity);
  assert_true(std::fabs(deepest(along)->separation + 0.25) <= 8 * kEpsilon);
  assert_true(deepest(along)->normal.y() > 1 - 8 * kEpsilon);
  // Along y near the side x = 1: out sideways, at right angles to the edges along z.
  const Candidates across = contacts(table, spear, Vec3(0, 0, 0.3), Vec3(0.9, 0, 0), kInfinity);
  const ContactPoint& p = *deepest(across);
  assert_true(std::fabs(p.normal.dot(exp_map(Vec3(0, 0, 0.3)) * Vec3::unit_y())) <= 16 * kEpsilon);
  // The edge x = 1, y = -0.3 lies (0.1, -0.3) from the axis: out along (cos 0.3, sin 0.3) until it has passed it.
  const Real depth = (1 - 0.9) * std::cos(0.3) + 0.3 * std::sin(0.3) + 0.05;
  assert_true(std::fabs(p.separation + depth) <= 16 * kEpsilon);
}

static void a_sphere_on_a_corner_an_edge_a_face_and_inside(void**) {
  const Shape cube = box(Vec3(1, 1, 1)), ball = sphere(0.5);
  const Real third = 0.5 / std::sqrt(3.0), half = 0.5 / std::sqrt(2.0);
  for (const Vec3& at : {Vec3(1 + third, 1 + third, 1 + third), Vec3(1 + half, -1 - half, 0.3), Vec3(0.2, 0.3, -1.5)}) {
    const Candidates found = contacts(cube, ball, Vec3(0.3, 0.2, 0.1), at);
    assert_int_equal(found.count, 1);
    assert_true(std::fabs(found.point[0].separation) <= 4 * kEpsilon);
  }
  const Candidates inside = contacts(cube, ball, Vec3::zero(), Vec3(0.2, -0.4, 0.3));
  assert_true(std::fabs(inside.point[0].separation + 1.1) <= 4 * kEpsilon);
  assert_true(inside.point[0].normal == -Vec3::unit_y());
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(capsules_side_by_side_touch_at_both_ends_of_the_common_stretch),
      cmocka_unit_test(cores_that_cross_part_square_to_both),
      cmocka_unit_test(a_capsule_lies_on_a_box_with_two_points),
      cmocka_unit_test(a_core_through_a_box_takes_the_shortest_way_out),
      cmocka_unit_test(a_sphere_on_a_corner_an_edge_a_face_and_inside),
  };
  return cmocka_run_group_tests_name("collision/pairs_capsule", tests, nullptr, nullptr);
}
