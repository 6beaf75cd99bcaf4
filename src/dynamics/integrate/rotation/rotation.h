// Rotation methods: how a body whose inertia is not the same about every axis turns when nothing acts on it.
//
// The participants are those of the effect `gyroscopic`: spheres and cubes keep their omega and are turned by the
// exponential map. Under the dial values none, explicit and implicit everybody is; there the effect is a torque or a
// flow of omega alone (force/gyroscopic.cpp). A method of this folder integrates orientation and omega together:
//
//   q0, omega0  ->  L = q0 I q0^-1 omega0  ->  q1  ->  omega1 = q1 I^-1 q1^-1 L
//
// so all of them keep the angular momentum L, and differ in how well they turn the body under it:
//
//   rk4             q' = omega(q) q / 2 by Runge-Kutta                              order 4
//   lie_midpoint    q1 = exp(h omega(q at mid-step)) q0                             order 2, nearly symplectic
//   splitting       turns about L and two principal axes, each of them exact        order 2, symplectic
//   splitting_4/6   the same, composed of 5 and 7 such steps, some of them back     order 4, 6, symplectic
#pragma once

#include "dynamics/effects.h"

namespace carom::dynamics {

struct Rotation {
  const char* name;
  /// Over h: omega of each participant, and its predicted pose: the orientation, and the omega that belongs to it.
  void (*advance)(const World& world, Velocities& to, const Participants& tops, Real h);
};

extern const Rotation kRotationRungeKutta4, kLieMidpoint, kSplitting, kSplitting4, kSplitting6;

/// The method of the dial, or null where rotation is left to the effect's force or flow.
const Rotation* rotation_method(std::uint32_t choice);

/// Whether the method turns a body in this step.
inline bool turns_by_method(const Plan& plan, std::uint32_t body) {
  return plan.rotation_method && plan.turns_by_method[body];
}

/// Advance whoever a method carries, if there is one. For integrators, at their place among forces and flows.
void turn_tops(const World& world, Velocities& to, Real h);

}  // namespace carom::dynamics
