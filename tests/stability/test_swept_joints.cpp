// Joints hold where a sweep stops one of their bodies: dolls that are thrown at walls, at posts, at each other.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "carom_test.h"
#include "joint_scenes.h"
#include "shapes.h"

using namespace carom;
using namespace carom::test;

namespace {

void start(TestWorld& t, const std::vector<std::uint32_t>& bodies, const Vec3& v) {
  for (const std::uint32_t b : bodies) t.world.set_velocity(b, v, Vec3::zero());
}

/// Trunk, head, two arms and two legs of two limbs each, upright about a point.
std::vector<std::uint32_t> doll(TestWorld& t, const Vec3& at) {
  const Shape *trunk = t.keep(box({0.15, 0.25, 0.1})), *head = t.keep(sphere(0.1)), *limb = t.keep(capsule(0.05, 0.12));
  std::vector<std::uint32_t> bodies = {t.add(trunk, at), t.add(head, at + Vec3(0, 0.38, 0))};
  join(t, JointKind::ball, bodies[0], bodies[1], at + Vec3(0, 0.27, 0));
  for (const Real side : {-1.0, 1.0})
    for (const Real up : {0.2, -0.35}) {
      const Vec3 from = at + Vec3(up > 0 ? 0.22 * side : 0.1 * side, up, 0);
      const std::uint32_t upper = t.add(limb, from - Vec3(0, 0.2, 0)), lower = t.add(limb, from - Vec3(0, 0.58, 0));
      join(t, JointKind::ball, bodies[0], upper, from);
      join(t, JointKind::hinge, upper, lower, from - Vec3(0, 0.39, 0), x_along(Vec3(1, 0, 0)));
      bodies.push_back(upper), bodies.push_back(lower);
    }
  return bodies;
}

struct Course {
  Real gap = 0;     // m or rad
  Real gained = 0;  // of the kinetic energy of the beginning
};
Course follow(TestWorld& t, int steps, Real dt) {
  Course c;
  const Real first = energy_of(t);
  for (int i = 0; i < steps; ++i) {
    t.run(1, dt);
    c.gap = std::max(c.gap, worst_gap(t)), c.gained = std::max(c.gained, energy_of(t) / first - 1);
  }
  return c;
}

/// A thin wall that nothing gets through.
void wall(TestWorld& t, Real x) { t.add(t.keep(box({0.02, 3, 3})), Vec3(x + 0.02, 0, 0), BodyType::fixed); }

}  // namespace

static void dolls_thrown_at_a_wall_hold_together(void**) {
  for (const Real speed : {8.0, 25.0, 80.0})
    for (const Real dt : {1.0 / 30, 1.0 / 60, 1.0 / 240}) {
      TestWorld t;
      t.world.set_gravity(Vec3::zero());
      wall(t, 1);
      const std::vector<std::uint32_t> bodies = doll(t, Vec3(0, 0, 0));
      start(t, bodies, Vec3(speed, 0, 0.1 * speed));
      const Course c = follow(t, static_cast<int>(1 / dt), dt);
      std::printf("%g m/s, 1/%.0f s: gap %.1e, gained %.1e\n", speed, 1 / dt, c.gap, c.gained);
      assert_true(c.gap < 1e-3);
      assert_true(c.gained < 1e-3);
      for (const std::uint32_t b : bodies) assert_true(t.world.state.x[b].x() < 1);
    }
}

/// None of them, nor the pair, is what it was written for.
static void what_else_is_joined_holds_together(void**) {
  const auto see = [](const char* what, TestWorld& t, Real seconds, Real dt) {
    const Course c = follow(t, static_cast<int>(seconds / dt), dt);
    std::printf("%s, 1/%.0f s: gap %.1e, gained %.1e\n", what, 1 / dt, c.gap, c.gained);
    assert_true(c.gap < 1e-3);
    assert_true(c.gained < 1e-2);
  };
  for (const Real dt : {1.0 / 30, 1.0 / 60, 1.0 / 120}) {
    {
      TestWorld t;  // two that fly at each other
      t.world.set_gravity(Vec3::zero());
      start(t, doll(t, Vec3(-1, 0, 0)), Vec3(15, 0, 0));
      start(t, doll(t, Vec3(1, 0.2, 0.1)), Vec3(-20, 0, 0));
      see("two dolls", t, 1, dt);
    }
    {
      TestWorld t;  // from 60 m onto the ground
      t.ground();
      start(t, doll(t, Vec3(0, 2, 0)), Vec3(5, -34, 0));
      see("a fall", t, 1, dt);
    }
    {
      TestWorld t;  // a chain that winds round a post
      t.world.set_gravity(Vec3::zero());
      t.add(t.keep(box({0.02, 3, 0.02})), Vec3(0.55, 0, -0.5), BodyType::fixed);
      const Shape* link = t.keep(capsule(0.02, 0.04));
      std::uint32_t before = kInvalid;
      for (int i = 0; i < 10; ++i) {
        const std::uint32_t b = t.add(link, Vec3(0.1 * i + 0.06, 0, 0), BodyType::dynamic, x_along(Vec3(0, 1, 0)));
        join(t, JointKind::ball, before, b, Vec3(0.1 * i, 0, 0));
        t.world.set_velocity(b, Vec3(0, 0, -3.0 * (i + 1)), Vec3::zero());
        before = b;
      }
      see("a chain", t, 1, dt);
    }
    {
      TestWorld t;  // a light plate on a heavy block that is driven into a wall
      t.world.set_gravity(Vec3::zero());
      wall(t, 1);
      const std::vector<std::uint32_t> both = {t.add(t.keep(box({0.5, 0.5, 0.5})), Vec3(-0.2, 0, 0)),
                                               t.add(t.keep(box({0.02, 0.3, 0.3})), Vec3(0.4, 0, 0))};
      join(t, JointKind::slider, both[0], both[1], Vec3(0.3, 0, 0), x_along(Vec3(0, 1, 0)));
      start(t, both, Vec3(50, 1, 0));
      see("a plate", t, 1, dt);
    }
  }
}

/// What weighs nothing, and hangs on what is stopped, changes nothing.
static void a_bead_on_a_hand_is_nothing(void**) {
  const auto end = [](Real bead) {
    TestWorld t;
    t.world.set_gravity(Vec3::zero());
    wall(t, 1);
    const std::vector<std::uint32_t> bodies = doll(t, Vec3(0, 0, 0));
    start(t, bodies, Vec3(20, 0, 2));
    if (bead > 0) {
      const std::uint32_t on = add_body(t, t.world.state.x[bodies.back()], bead, Vec3::constant(bead));
      join(t, JointKind::weld, bodies.back(), on, t.world.state.x[bodies.back()]);
      start(t, {on}, Vec3(20, 0, 2));
    }
    t.run(4, 1.0 / 60);
    return t.world.state.x[bodies[0]];
  };
  const Real change = (end(1e-15) - end(0)).norm();
  std::printf("a bead of 1e-15 kg: %.1e m\n", change);
  assert_true(change < 1e-9);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(dolls_thrown_at_a_wall_hold_together),
      cmocka_unit_test(what_else_is_joined_holds_together),
      cmocka_unit_test(a_bead_on_a_hand_is_nothing),
  };
  return cmocka_run_group_tests_name("stability/swept_joints", tests, nullptr, nullptr);
}
