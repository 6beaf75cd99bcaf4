// Classical fourth-order Runge-Kutta on the quaternion alone, under the momentum that stays.
//   q' = 1/2 omega(q/|q|) q,   omega(q) = q I^-1 q^-1 L   (a pure quaternion, world)          @source [Hairer1993
//   §II.1]
// The field leaves |q| constant, so renormalising the stages costs no order. Energy drifts, by h^5 a step.
#include "dynamics/integrate/rotation/top.h"

namespace carom::dynamics {
namespace {

void advance_by_runge_kutta(const World& world, Velocities& to, const Participants& participants, Real h) {
  carry_tops(world, to, participants, h, [](const Principal& top, Real step, const Vec3& l, const Vec3&, Quat& q) {
    const auto rate = [&](const Quat& at) {
      const Vec3 half = 0.5 * spin_of(top, at, l);
      return Quat(0, half.x(), half.y(), half.z()) * at;
    };
    const auto along = [&](Real far, const Quat& slope) {
      Quat r;
      r = q + far * slope;
      return normalized(r);
    };
    const Quat k1 = rate(q), k2 = rate(along(step / 2, k1)), k3 = rate(along(step / 2, k2)), k4 = rate(along(step, k3));
    q += (step / 6) * (k1 + 2 * (k2 + k3) + k4);
  });
}

}  // namespace

const Rotation kRotationRungeKutta4 = {"rk4", advance_by_runge_kutta};

}  // namespace carom::dynamics
