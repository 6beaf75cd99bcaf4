// Time of impact: when two shapes that travel and turn first touch.
#pragma once

#include "collision/cast/cast.h"

namespace carom::collision {

/// A motion at constant velocity and angular velocity: the centre goes straight, the shape turns about it.
struct RigidMotion {
  Pose at;                       // of the shape, at time 0
  Vec3 centre = Vec3::zero();    // m, at time 0: what the shape turns about
  Vec3 velocity = Vec3::zero();  // m/s, of the centre
  Vec3 omega = Vec3::zero();     // rad/s, in the frame of the poses

  /// exp(omega t) turns the shape, velocity t moves the centre.
  Pose after(Real t) const {
    const Quat turn = exp_map(omega * t);
    return {normalized(turn * at.q), centre + velocity * t + turn * (at.p - centre)};
  }
};

/// First time in [0, duration] at which the separation is down to settings.target, by conservative advancement.
///
/// From a separating plane of normal n, the gap falls no faster than n . (v_A - v_B) + |n x w_A| r_A + |n x w_B| r_B, r
/// the farthest that a point of the core lies from its centre of rotation; so no contact before gap / that. The next
/// plane is asked for there.
/// @param duration  s, >= 0, finite
/// @param settings  cap: distance queries. Contact is declared once the separation is within tolerance of the target; a
///                  time by which the target itself is crossed is then looked for, a thousand tolerances of way ahead:
///                  found, it ends the bracket and slack is rounding; not found (a graze, a touch), slack is the
///                  tolerance
/// @param result    undecided: the cap came first; nothing touches before `lower`
/// @accuracy        brackets hold, rounding included; a half-space must not turn
/// @source          [Mirtich1996]
/// @oracle          tests/unit/collision/cast/test_time_of_impact
void time_of_impact(const Shape& a, const RigidMotion& motion_a, const Shape& b, const RigidMotion& motion_b,
                    Real duration, const CastSettings& settings, CastResult& result, SupportFault& fault);

/// Whether a plane that is known, as of a time of impact just before, keeps two farther apart than settings.target in all
/// of [0, duration]: two to six support evaluations, where a distance query takes some thirty.
/// @param normal  unit, from A to B, in the frame of the poses; that of a half-space, if one of them is
/// @param point   m, in that frame: where the smaller of the two reaches farthest towards the other, at time 0
/// @accuracy      true is proven, rounding included; false says nothing
/// @oracle        tests/unit/collision/cast/test_time_of_impact
bool is_kept_apart(const Shape& a, const RigidMotion& motion_a, const Shape& b, const RigidMotion& motion_b,
                   Real duration, const CastSettings& settings, const Vec3& normal, Vec3& point);

}  // namespace carom::collision
