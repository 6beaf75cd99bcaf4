// How fast the coordinates of a joint change.
#pragma once

#include "dynamics/joint/joint.h"
#include "dynamics/world.h"

namespace carom::dynamics {

/// Rates of what place_of() and axes_at() tell, by coordinate and by axis. m/s or rad/s
struct JointSpeeds {
  std::array<Real, kCoordinates> coordinate;
  std::array<Real, kAxes> axis;
};

/// From the present poses and velocities.
///   with r what parts the points in A's frame, w the spin of B relative to A there, t = q_a^-1 q_b, n = t x:
///   r' = R_a^T (v_b - v_a) - w_a x r,   t' = (0, w) t / 2,   n' = w x n
/// Where a coordinate has no rate (points that agree, axes that agree or oppose each other) it is that at which it
/// begins to grow, and 0 where a twist is not told.
/// @accuracy  rounding of velocities, times 1 / cos(swing / 2) of a twist
/// @oracle    tests/abi/test_joint_bulk: central differences of the coordinates
JointSpeeds speeds_of(const World& world, const Joint& joint);

/// Rates of measured joints, in the order of their slots.
void measure_rates(const World& world, Array<AxisRates>& rates);
/// By how much a step has changed them. Finite, whatever they are.   @param begun  as the step began
void note_accelerations(const World& world, const Array<AxisRates>& begun, Real dt, Joints& joints);

}  // namespace carom::dynamics
