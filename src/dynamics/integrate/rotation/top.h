// What all rotation methods share: the momentum that a spin has, the spin that a momentum gives, and the loop.
#pragma once

#include "core/turn.h"
#include "dynamics/integrate/rotation/principal.h"
#include "dynamics/integrate/rotation/rotation.h"

namespace carom::dynamics {

/// omega of a top with a given momentum at an orientation.
///   I^-1 = 1/I_x + diag(0, dy, dz)   =>   omega = L/I_x + q (0, dy p_y, dz p_z),   p = q^-1 L
/// @param q  unit, principal axes -> world   @param l  kg m^2/s, world   @param p  the same in principal axes
/// @return   rad/s, world
inline Vec3 spin_of(const Principal& top, const Quat& q, const Vec3& l, const Vec3& p) {
  return top.base * l + q * Vec3(0, top.dy * p.y(), top.dz * p.z());
}
inline Vec3 spin_of(const Principal& top, const Quat& q, const Vec3& l) {
  return spin_of(top, q, l, q.conjugate() * l);
}

/// exp_map() without the unit length: (cos, sin) of half the angle times a common factor near 1. No root is drawn for
/// small turns.
inline Quat unscaled_exp(const Vec3& phi) {
  const Real z = phi.squared_norm() / 4;
  if (!(z < 0.09)) return exp_map(phi);
  const Real s = 0.5 * (1 - z * (4.0 / 33 - z / 495));  // as in turn_by(), without the factor x
  const Real c = 1 - z * (5.0 / 11 - z * (2.0 / 99 - z / 10395));
  return Quat(c, s * phi.x(), s * phi.y(), s * phi.z());
}

// What spin_of() rounds by: two rotations, 8 u each with a length of q off by 4 u, a sum of terms up to 2 |omega|.
inline constexpr Real kMomentumAgrees = 64 * kUnitRoundoff;

/// Carries a top over h by turn(top, h, l, p, q): q (unit, principal -> world) becomes the orientation at the end,
/// of any length; l is the momentum in the world, p in principal axes at the start.
///
/// Momentum. omega stands in the state, L does not follow from it to the last bit, and 3,600 steps of rounding there
/// and back cost three digits of it. So L is kept beside omega, and taken for as long as it gives the omega that is
/// found: whoever else has written omega or q (a contact, a torque, a host) has changed them by more than rounding, or
/// not at all.
template <class Method>
void carry_top(const World& world, Velocities& to, std::uint32_t i, Real h, Method&& turn) {
  const State& s = world.state;
  Plan& plan = *world.plan;
  const Principal& top = plan.principal[i];
  Quat q = top.sorted(s.q[i]);
  Vec3 l = top.sorted(s.momentum[i]), p = q.conjugate() * l;
  const Vec3 omega = top.sorted(s.omega[i]);
  if (!((spin_of(top, q, l, p) - omega).squared_norm() < kMomentumAgrees * kMomentumAgrees * omega.squared_norm())) {
    p = top.moment.times(q.conjugate() * omega);
    l = q * p;
    to.momentum[i] = top.unsorted(l);
  }
  turn(top, h, l, p, q);
  q = normalized(q);
  plan.predicted.q[i] = top.unsorted(q);
  plan.predicted.omega[i] = to.omega[i] = top.unsorted(spin_of(top, q, l));
}
/// Likewise each of them.
template <class Method>
void carry_tops(const World& world, Velocities& to, const Participants& participants, Real h, Method&& turn) {
  participants.each(world.jobs, [&](std::uint32_t i) { carry_top(world, to, i, h, turn); });
}

}  // namespace carom::dynamics
