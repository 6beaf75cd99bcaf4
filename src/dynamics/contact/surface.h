// Surfaces that move though their collider stays: conveyor belts, turntables, tracks.
//
// Such a surface changes the law of friction in one place: what friction brings to rest is the velocity of the bodies
// at the point plus that of their surfaces,
//   u' = u + s_b - s_a,    s(x) = R (linear + angular x R^-1 (x - p)),   the part of it in the contact's plane,
// R and p the frame of the collider as the step began. The normal part of s moves nothing: a belt does not push what
// stands at its end. So a box dropped on a belt slips at mu g until it is as fast as the belt, then rides.
//
// @oracle tests/oracle/test_surface_velocity
#pragma once

#include "dynamics/contact/contact.h"

namespace carom::dynamics {

/// What a collider's surface does of itself, where it is by now; nothing where a host forbids that.
struct Surface {
  Vec3 linear, angular;  // m/s, rad/s, world
  Vec3 origin;           // m, world

  Surface(const World& world, std::uint32_t collider, std::uint32_t body);
  bool any() const { return linear != Vec3::zero() || angular != Vec3::zero(); }
  /// m/s, world   @param x  m, world
  Vec3 at(const Vec3& x) const { return linear + angular.cross(x - origin); }
};

/// Stage group: driven pairs of this step and the velocities of their surfaces; nothing where no collider has one.
void find_surfaces(const World& world, const StepTime& time);

}  // namespace carom::dynamics
