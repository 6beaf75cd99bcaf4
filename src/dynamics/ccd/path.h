// How a body moves within a substep, as a sweep sees it: straight on and about one axis from one pose to another.
#pragma once

#include "collision/scenery/ask.h"
#include "dynamics/ccd/parts.h"
#include "dynamics/state.h"

namespace carom::dynamics {

/// The rotation vector of a turn, of all those that are whole turns apart the one nearest to another.
///   exp_map(phi) = turn,   phi = angle axis + 2 pi k axis
/// @param turn  unit   @param near  [3] rad   @return [3] rad
/// @accuracy    8 eps of the angle; no sine of the C library's
/// @oracle      tests/unit/dynamics/test_ccd
Vec3 rotation_vector(const Quat& turn, const Vec3& near);

/// From time t of a substep on.
struct Path {
  Real t = 0;                 // s
  Vec3 x = Vec3::zero();      // m, world: centre of mass, at t
  Quat q = Quat::identity();  // body -> world, at t
  Vec3 u = Vec3::zero();      // m/s, world
  Vec3 w = Vec3::zero();      // rad/s, world

  Vec3 place(Real time) const { return x + (time - t) * u; }
  Quat orientation(Real time) const { return w == Vec3::zero() ? q : normalized(exp_map((time - t) * w) * q); }
  void go_on_from(Real time) {
    const Quat there = orientation(time);
    x = place(time), q = there, t = time;
  }
  void stay() { u = w = Vec3::zero(); }

  /// The part from a time on, whose zero is that time.
  RigidMotion motion(const SweptPart& part, Real from) const {
    RigidMotion m;
    const Quat there = orientation(from);
    m.centre = place(from);
    m.at = {there * part.local.q, m.centre + there * part.local.p};
    m.velocity = u, m.omega = w;
    return m;
  }
  Frame frame(const SweptPart& part, Real time) const {
    const Quat there = orientation(time);
    return Frame(Pose{there * part.local.q, place(time) + there * part.local.p});
  }
  /// What a ball about the centre sweeps. @param radius  m
  Aabb swept(Real from, Real to, Real radius) const {
    const Vec3 a = place(from), b = place(to), r = Vec3::constant(radius);
    return {a.min(b) - r, a.max(b) + r};
  }
};

/// That of a substep, as velocities tell it: to where a body is, and without its velocities.   @param h  s
Path path_to(const State& s, std::uint32_t body, Real h);

}  // namespace carom::dynamics
