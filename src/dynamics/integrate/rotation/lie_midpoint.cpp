// Implicit midpoint rule on the rotation group: one turn, about the axis and at the rate of mid-step.
//   phi = h omega(exp(phi/2) q0),   q1 = exp(phi) q0,   omega(q) = q I^-1 q^-1 L
// The equation for phi is solved by three fixed-point sweeps, each of which gains a factor of h |omega| / 2 times the
// unlikeness of the moments: what is left is of order h^4 a step, below the method's own error but not symmetric, so
// that energy drifts a little.   @source [Hairer2006 §IV.8]
#include "dynamics/integrate/rotation/top.h"

namespace carom::dynamics {
namespace {

constexpr int kMidpointSweeps = 3;

void advance_by_midpoint(const World& world, Velocities& to, const Participants& participants, Real h) {
  carry_tops(world, to, participants, h, [](const Principal& top, Real step, const Vec3& l, const Vec3& p, Quat& q) {
    Vec3 phi = step * spin_of(top, q, l, p);
    for (int sweep = 0; sweep < kMidpointSweeps; ++sweep)
      phi = step * spin_of(top, normalized(unscaled_exp(0.5 * phi) * q), l);
    q = unscaled_exp(phi) * q;
  });
}

}  // namespace

const Rotation kLieMidpoint = {"lie_midpoint", advance_by_midpoint};

}  // namespace carom::dynamics
