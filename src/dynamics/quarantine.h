// Quarantine: one body's nonsense stays its own.
#pragma once

#include "dynamics/effects.h"

namespace carom::dynamics {

// Beyond these a state is not a scene but an accident. Squares and products of a few of them stay far from overflow
// (1e308), which is what lets every other stage compute without checks. Larger bounds would admit overflow in the
// narrow phase; smaller ones would refuse valid astronomy: light travels 3e8 m/s, and 1e15 m is 0.1 light years, where
// a double resolves 0.1 m.
inline constexpr Real kMaxPosition = 1e15;  // m
inline constexpr Real kMaxSpeed = 1e9;      // m/s
inline constexpr Real kMaxSpin = 1e9;       // rad/s

// Written so that NaN fails.
inline bool sane_position(const Vec3& x) {
  return std::fabs(x.x()) <= kMaxPosition && std::fabs(x.y()) <= kMaxPosition && std::fabs(x.z()) <= kMaxPosition;
}
inline bool sane_velocity(const Velocities& s, std::uint32_t i) {
  return s.v[i].squared_norm() <= kMaxSpeed * kMaxSpeed;
}
inline bool sane_spin(const Velocities& s, std::uint32_t i) { return s.omega[i].squared_norm() <= kMaxSpin * kMaxSpin; }

/// Put a body's pose right by what a solver found. A correction that would take it out of the finite world is none:
/// what it came of is seen, and stopped, when the body moves.
/// @param shift  m   @param turn  rad, world
inline void correct_pose(Poses& s, std::uint32_t i, const Vec3& shift, const Vec3& turn) {
  const Vec3 x = s.x[i] + shift;
  if (!sane_position(x) || !(turn.squared_norm() <= kMaxSpin * kMaxSpin)) return;
  s.x[i] = x;
  if (turn != Vec3::zero()) s.q[i] = normalized(exp_map(turn) * s.q[i]);
}

/// What a body in quarantine leaves behind.
using Quarantining = Writes<Velocities, HostForces, Quarantine, Revisions, FaultViews>;
/// Stop a body where it is, mark it, and report the fault. From the next step on it is held still and touches nothing,
/// until a host gives it a pose.
void quarantine(Quarantining to, std::uint32_t body);

/// Stage admit: of the bodies that a host wrote to, quarantine those whose state makes no sense. A pose that is not
/// finite becomes the nearest thing to it: components that are not finite become 0, those too large the bound.
void admit(const World& world, Poses& poses, Quarantining to, const StepTime& time);

}  // namespace carom::dynamics
