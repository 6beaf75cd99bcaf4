// Six-axis joints for tests of the inside.
#pragma once

#include <algorithm>

#include "dynamics/joint/axis_parts.h"
#include "dynamics/joint/turns.h"
#include "joint_scenes.h"

namespace carom::test {

inline constexpr int kEverySolver[] = {kSoftChoice, kDirectChoice, kAutoChoice};
inline constexpr Real kStep = 1.0 / 60;
inline const Quat kOblique = normalized(Quat(0.7, 0.3, -0.5, 0.4));

inline std::uint32_t join_axes(TestWorld& t, std::uint32_t a, std::uint32_t b, const Vec3& at,
                               const Quat& axes = kOblique) {
  return join(t, JointKind::six_axis, a, b, at, axes);
}
inline JointAxis locked_at(Real offset = 0) {
  JointAxis a;
  a.mode = AxisMode::locked, a.lower = offset;
  return a;
}
inline void set_all(TestWorld& t, std::uint32_t j, std::uint32_t but, const JointAxis& axis, bool places = true,
                    bool turns = true) {
  for (std::uint32_t k = 0; k < kAxes; ++k)
    if (k != but && (k < kPlaces ? places : turns)) t.world.set_joint_axis(j, k, axis);
}
/// As a pose alone tells it.
inline std::array<Real, kAxes> axes_told(const JointEnds& ends) {
  return axes_at(ends, told_angles(ends.a.q.conjugate() * ends.b.q, SwingPlane::none));
}
inline Real axis_of(const TestWorld& t, std::uint32_t j, std::uint32_t k) {
  const JointPlace place = place_of(t.world, joint(t, j));
  return axes_at(place, place.turned)[k];
}
inline bool is_direct(int solver) { return solver >= kDirectChoice; }
inline Real off_joint(const TestWorld& t, std::uint32_t j) {
  const JointPlace p = place_of(t.world, joint(t, j));
  return std::max(p.gap, p.angle);
}

}  // namespace carom::test
