// Poses that single-precision engines lose contacts at (mujoco_warp #1526, #1527, #1546, mujoco #3476): boxes that just
// overlap face to face, and a pair that is carried elsewhere. Numbers of our own, of the same kind.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "carom_test.h"
#include "dynamics/contact/contact.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

Real as_float(Real x) { return static_cast<Real>(static_cast<float>(x)); }
Vec3 as_float(const Vec3& v) { return {as_float(v.x()), as_float(v.y()), as_float(v.z())}; }

/// Contacts of two bodies as they stand.
struct Met {
  int points = 0;
  Real deepest = kInfinity;  // m, the least separation
  Real shallowest = -kInfinity;
};
Met meet(const Shape& lower, const Vec3& lower_at, const Shape& upper, const Vec3& upper_at, const Quat& turned) {
  TestWorld t(Vec3::zero());
  t.add(t.keep(lower), lower_at, BodyType::fixed);
  t.add(t.keep(upper), upper_at, BodyType::dynamic, turned);
  t.world.step(1e-12);
  Met met;
  for (const RowGeometry& g : t.world.contacts->geometry) {
    ++met.points;
    met.deepest = std::min(met.deepest, g.separation), met.shallowest = std::max(met.shallowest, g.separation);
  }
  return met;
}

}  // namespace

/// Centred boxes, the upper one just in the lower: four points, each as deep as the centres say.
static void boxes_face_to_face_keep_their_contact(void**) {
  for (const Real away : {0.0, 1.0, 37.0, 1000.0})
    for (const Real half : {0.05, 0.1, 0.4, 5.0})
      for (const Real depth : {1e-6, 2.5e-4, 9e-4}) {  // a step parts what is deeper than a hundredth
        const Vec3 lower = as_float(Vec3(away, away / 3 + half, -away)),
                   upper = as_float(Vec3(away, away / 3 + 3 * half - depth, -away));
        const Real separation = upper.y() - lower.y() - 2 * half;
        const Shape one = box(Vec3::constant(half));
        const Met met = meet(one, lower, one, upper, Quat::identity());
        assert_int_equal(met.points, 4);
        assert_true(std::fabs(met.deepest - separation) < 1e-12 * (1 + away) &&
                    std::fabs(met.shallowest - separation) < 1e-12 * (1 + away));
      }
}

/// One box leans by less than its faces sink: no point is deeper than its lowest corner.
static void faces_that_kiss_at_a_corner_have_no_phantoms(void**) {
  for (const Real lean : {1e-7, 1e-5, 1e-3})
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0.6, 0, 0.8), Vec3(0.7071, 0.01, 0.7071)}) {
      const Real half = 0.0355, depth = 5.6e-5;
      const Quat turned = exp_map(lean * axis);
      Real lowest = kInfinity;
      for (int i = 0; i < 8; ++i)
        lowest =
            std::min(lowest, (turned * Vec3(i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? half : -half)).y());
      const Shape one = box(Vec3::constant(half));
      const Met met = meet(one, Vec3::zero(), one, Vec3(0, half - lowest - depth, 0), turned);
      assert_true(met.points >= 1 && std::fabs(met.deepest + depth) < 1e-9);
    }
}

/// A box that is small for the one below it, up to a thousand times.
static void a_small_box_on_a_large_one(void**) {
  for (const Real large : {1.0, 25.0, 100.0}) {
    const Met met = meet(box(Vec3(large, 0.25, large)), Vec3(0, 0.25, 0), box(Vec3::constant(0.1)),
                         Vec3(as_float(0.3 * large), 0.6 - 1e-5, as_float(-0.2 * large)), Quat::identity());
    assert_int_equal(met.points, 4);
    assert_true(std::fabs(met.deepest + 1e-5) < 1e-12 * (1 + large));
  }
}

/// Hulls of five vertices: what they overlap by does not depend on where they are.
static void an_overlap_is_the_same_elsewhere(void**) {
  const Shape one = hull(
      {Vec3(0.1, 0, 0), Vec3(-0.06, 0, 0.08), Vec3(-0.05, 0, -0.09), Vec3(0.01, 0.12, 0.01), Vec3(-0.01, -0.11, 0.02)});
  const Quat turned = exp_map(Vec3(0.3, -0.8, 0.5));
  const Vec3 apart(0.04, 0.1, -0.02);
  const Met home = meet(one, Vec3::zero(), one, apart, turned);
  assert_true(home.points >= 1 && home.deepest < -1e-3);
  for (const Vec3& by : {Vec3(0, 1, 0), Vec3(1, 1, 1), Vec3(-64, 16, 128), Vec3(4096, -2048, 1024)}) {
    const Met away = meet(one, by, one, by + apart, turned);
    std::printf("  by %g: %d points, %.3e m\n", by.norm(), away.points, away.deepest - home.deepest);
    assert_int_equal(away.points, home.points);
    assert_true(std::fabs(away.deepest - home.deepest) < 4 * kEpsilon * by.norm() + 1e-9);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(boxes_face_to_face_keep_their_contact),
      cmocka_unit_test(faces_that_kiss_at_a_corner_have_no_phantoms),
      cmocka_unit_test(a_small_box_on_a_large_one),
      cmocka_unit_test(an_overlap_is_the_same_elsewhere),
  };
  return cmocka_run_group_tests_name("oracle/float_poses", tests, nullptr, nullptr);
}
