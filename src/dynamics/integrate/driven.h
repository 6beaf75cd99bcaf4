// How a body that a host moves goes within a step.
//
// A host says one velocity for a whole step, and another for the next: of a lift that brakes, a lorry in a bend, a
// tray that shakes. If the body changed its velocity as a step begins, all at once, what stands on it would have one
// substep to follow what takes a step: friction and weight would have to do n times as much as the motion asks for,
// n the number of substeps, and what they can't do is left behind in each step. So a change that goes on from one step
// to the next is spread evenly over a step, about the velocity that the host said. The body ends the step where that
// velocity leads, and each substep changes its own as much as any other:
//
//   v(t) = v + a (t - dt/2),  a = the change from the step before over dt, as far as that step changed it alike
//
// A change that comes alone (a start, a stop, a jerk) is what it says, a jump: a = 0. Likewise of the spin, about which
// the last substep is put right, as turns about several axes do not add up. Velocities in the state are those of
// substeps while these go on, and the host's before and after.
//
// @oracle tests/oracle/test_driven
#pragma once

#include "dynamics/effects.h"

namespace carom::dynamics {

/// A body that is led so in this step.
struct LedBody {
  std::uint32_t slot;
  int substeps = 0;  // that have begun
  Vec3 v, omega;     // m/s, rad/s, world: the host's
  Vec3 a, alpha;     // m/s^2, rad/s^2
  Quat end;          // where the step's turn leads

  /// m/s, rad/s, in one of n substeps of h.
  Vec3 v_in(int substep, int n, Real h) const { return v + h * (substep - Real(n + 1) / 2) * a; }
  Vec3 omega_in(int substep, int n, Real h) const { return omega + h * (substep - Real(n + 1) / 2) * alpha; }
};

/// Stage refresh: what hosts changed since the last step, and who is led. Allocates.
void find_led(const World& world, SolverMemory& to, const StepTime& time);
/// Before the substeps: velocities of the first, for all that is made ready by them.
void begin_leading(const World& world, Velocities& to, const StepTime& time);
/// Within begin_substep(): velocities of the substep.
void lead(const World& world, Velocities& to, const StepTime& time);
/// After the substeps, or where they broke off: the host's again.
void stop_leading(const World& world, Velocities& to, const StepTime& time);
/// Of a body that is led; null: it is not.
const LedBody* led_body(const World& world, std::uint32_t body);

}  // namespace carom::dynamics
