// What a snapshot holds of a joint's axes and of its drive to an orientation. Of kinds that have them alone.
#pragma once

#include "dynamics/joint/axes.h"
#include "dynamics/snapshot/bytes.h"

namespace carom::dynamics::snapshot {

template <class Io>
Real bound_of(Io& io, Real now) {  // may be infinite
  const Real x = io.value(now);
  io.demand(x >= 0);
  return x;
}

template <class Enum, class Io>
Enum named(Io& io, Enum now) {
  const auto v = io.value(static_cast<std::uint8_t>(now));
  io.demand(v < static_cast<std::uint8_t>(Enum::count));
  return static_cast<Enum>(v);
}

template <class Io>
AxisPull pull_of_axis(Io& io, const AxisPull& now) {
  AxisPull p;
  p.gains = named(io, now.gains);
  p.stiffness = io.real(now.stiffness), p.damping = io.real(now.damping);
  io.demand(p.stiffness >= 0 && p.damping >= 0);
  return p;
}

/// An axis that has limits of effort or speed says so in a bit of its mode; others take no bytes for them.
constexpr std::uint8_t kHasPace = 128;

template <class Io>
JointAxis one_axis(Io& io, const JointAxis& now) {
  JointAxis a;
  const bool has = now.effort_limit < kInfinity || now.speed_limit < kInfinity;
  const auto mode = io.value(static_cast<std::uint8_t>(static_cast<unsigned>(now.mode) | (has ? kHasPace : 0u)));
  io.demand((mode & ~kHasPace) < static_cast<int>(AxisMode::count));
  a.mode = static_cast<AxisMode>(mode & ~kHasPace), a.drive = named(io, now.drive);
  a.lower = io.real(now.lower), a.upper = io.real(now.upper);
  a.stop = pull_of_axis(io, now.stop), a.gains = pull_of_axis(io, now.gains), a.spring = pull_of_axis(io, now.spring);
  a.target = io.real(now.target), a.speed = io.real(now.speed), a.effort = io.real(now.effort);
  a.max_force = bound_of(io, now.max_force), a.rest = io.real(now.rest);
  a.friction = bound_of(io, now.friction), a.armature = io.real(now.armature);
  if (mode & kHasPace) a.effort_limit = bound_of(io, now.effort_limit), a.speed_limit = bound_of(io, now.speed_limit);
  io.demand(a.armature >= 0);
  io.demand(a.mode != AxisMode::limited || a.lower <= a.upper);
  return a;
}

/// @param axes  of the joint, which has some of its own
template <class Io, class A>
void all_axes(Io& io, A& axes) {
  for (std::uint32_t k = 0; k < kAxes; ++k) {
    const JointAxis axis = one_axis(io, axes.axis[k]);
    keep(io, axes.axis[k], axis);
    for (auto& p : axes.p[k]) {
      const Real v = io.real(p);
      keep(io, p, v);
    }
  }
}

template <class Io, class T>
void turn_drive(Io& io, T& now) {
  TurnDrive d;
  d.mode = named(io, now.mode);
  d.gains = pull_of_axis(io, now.gains);
  d.target = io.quat(now.target);
  d.velocity = io.vec(now.velocity), d.effort = io.vec(now.effort);
  for (int k = 0; k < 3; ++k) d.max_force[k] = bound_of(io, now.max_force[k]);
  d.p = io.vec(now.p);
  const Real n2 = d.target.squared_norm();
  io.demand(n2 > 0.9 && n2 < 1.1);
  keep(io, now, d);
}

inline bool same_pull(const AxisPull& a, const AxisPull& b) {
  return a.gains == b.gains && same_bits(a.stiffness, b.stiffness) && same_bits(a.damping, b.damping);
}
inline bool same_turn_drive(const TurnDrive& a, const TurnDrive& b) {
  return a.mode == b.mode && same_pull(a.gains, b.gains) && same_bits(a.target, b.target) &&
         same_bits(a.velocity, b.velocity) && same_bits(a.effort, b.effort) && same_bits(a.max_force, b.max_force) &&
         same_bits(a.p, b.p);
}

}  // namespace carom::dynamics::snapshot
