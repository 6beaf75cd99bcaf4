// Scenes of islands that joints alone hold, and how they are asked for.
#pragma once

#include <algorithm>
#include <cmath>

#include "dynamics/joint/rattle/rattle.h"
#include "joint_scenes.h"

namespace carom::test {

inline constexpr Real kPi = 3.14159265358979323846;
inline constexpr int kOrders[] = {2, 4, 6};

inline void by_rattle(TestWorld& t, int order, int substeps = 1) {
  t.world.set_dial(Dial::joint_order, order);
  t.world.set_dial(Dial::substeps, substeps);
}
inline std::size_t held(const TestWorld& t) {
  std::size_t count = 0;
  rattle::each_held(*t.world.rattle, [&](const RattleIsland&) { ++count; });
  return count;
}

/// Period of a pendulum of amplitude a: 4 K(sin a/2) / w0, by the arithmetic-geometric mean.
inline Real period(Real w0, Real amplitude) {
  Real a = 1, b = std::cos(amplitude / 2);
  for (int i = 0; i < 40; ++i) {
    const Real m = (a + b) / 2;
    b = std::sqrt(a * b), a = m;
  }
  return 2 * kPi / (w0 * a);
}

/// A thin rod of 1 m hung by one end, let go at an angle from straight down. @return the rod
inline std::uint32_t hang_rod(TestWorld& t, Real angle, JointKind kind = JointKind::hinge) {
  const Vec3 down(std::sin(angle), -std::cos(angle), 0);
  const Quat q = turn_between(Vec3(0, -1, 0), down);
  const std::uint32_t rod = add_body(t, 0.5 * down, 1, Vec3(1.0 / 12, 1e-3, 1.0 / 12), BodyType::dynamic, q);
  join(t, kind, kInvalid, rod, Vec3::zero(), x_along(Vec3(0, 0, 1)));
  return rod;
}

inline std::uint32_t hang_two(TestWorld& t, Real a, Real b, JointKind kind) {
  Vec3 at = Vec3::zero();
  std::uint32_t before = kInvalid;
  for (const Real angle : {a, b}) {
    const Vec3 down(std::sin(angle), -std::cos(angle), 0);
    const std::uint32_t rod = add_body(t, at + 0.25 * down, 1, Vec3(0.25 / 12, 1e-3, 0.25 / 12), BodyType::dynamic,
                                       turn_between(Vec3(0, -1, 0), down));
    join(t, kind, before, rod, at, x_along(Vec3(0, 0, 1)));
    before = rod;
    at += 0.5 * down;
  }
  return before;
}

}  // namespace carom::test
