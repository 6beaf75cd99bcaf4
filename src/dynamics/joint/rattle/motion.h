// How a body of an island moves between impulses, and what these do to it.
#pragma once

#include "dynamics/body_state.h"
#include "dynamics/integrate/rotation/split_turn.h"
#include "dynamics/joint/rattle/rattle.h"

namespace carom::dynamics::rattle {

/// rad/s, of the momentum of a body that faces like q.
inline Vec3 spin_of_body(const RattleBody& b, const Quat& q, const Vec3& l) {
  return b.turns ? b.top.unsorted(spin_of(b.top, b.top.sorted(q), b.top.sorted(l))) : Vec3(Vec3::zero());
}

inline Mat3 turned(const Mat3& m, const Mat3& r) { return r * m * r.transpose(); }

/// Whether it turns about one axis of the world alone, so that its inertia about that is the same wherever it faces.
inline bool turns_about_one(const RattleBody& b) { return (b.locks & kAngularLocks) != 0; }

/// 1/(kg m^2), world, of a body that faces as r has it.
inline Mat3 response_at(const RattleBody& b, const Mat3& r) {
  return turns_about_one(b) ? inverse_of_free(turned(b.inertia, r), b.locks) : turned(b.inv_inertia, r);
}

/// m/s, of an impulse of p along d; m/s^2 of such a force.
inline Vec3 speed_of(const RattleBody& b, const Vec3& d, Real p = 1) {
  const Vec3 v = (b.inv_mass * p) * d;
  return b.locks ? Vec3(free_axes(b.locks).times(v)) : v;
}

/// A free body over h from where it is, with velocities v1 and l1: x1, q1, r1. Symmetric, and exact but for the turn of
/// a body with three unlike moments, which is of second order.
inline void fly(RattleBody& b, Real h) {
  b.x1 = b.x + h * b.v1;
  if (!b.turns) return;
  if (turns_about_one(b)) {
    b.q1 = normalized(unscaled_exp(h * (b.inv_world * b.l1)) * b.q);
  } else if (b.top.dy == 0 && b.top.dz == 0) {
    b.q1 = normalized(unscaled_exp((h * b.top.base) * b.l1) * b.q);
  } else {
    Quat q = b.top.sorted(b.q);
    const Vec3 l = b.top.sorted(b.l1);
    Vec3 p = q.conjugate() * l;
    if (b.top.dy == 0 || b.top.dz == 0) {  // a rod, a plate: two turns, exactly
      q = unscaled_exp((h * b.top.base) * l) * q;
      b.top.dz == 0 ? turn_y(h * b.top.dy * p.y(), q, p) : turn_z(h * b.top.dz * p.z(), q, p);
    } else {
      turn_split(b.top, h, l, p, q, kOne);
    }
    b.q1 = b.top.unsorted(normalized(q));
  }
  b.r1 = b.q1.matrix();
}

/// It is there now.
inline void arrive(RattleBody& b) {
  b.x = b.x1, b.v = b.v1, b.l = b.l1;
  if (!b.turns) return;
  b.q = b.q1, b.r = b.r1;
  b.inv_world = response_at(b, b.r);
  b.omega = b.inv_world * b.l;
}

/// The plan of a body that a host moves, t after the step began.
inline void travel(const World& world, RattleBody& b, Real t) {
  const State& s = world.state;
  b.x1 = s.x[b.slot] + t * s.v[b.slot];
  b.q1 = normalized(exp_map(t * s.omega[b.slot]) * s.q[b.slot]);
  b.r1 = b.q1.matrix();
}

}  // namespace carom::dynamics::rattle
