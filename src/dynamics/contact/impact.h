// Impacts: contacts that are hit harder than the restitution speed throw their bodies apart, each at the moment of the
// substep at which it happens, in the order of those moments. What is left is for the solver.
//
// Within a substep two bodies that nothing holds move on parabolas, whatever the integrator calls their velocity: with
// s the gap and c the closing speed as the substep begins, a the part of the forces in it,
//   gap(t) = s - c t - a t^2/2,    closing(t) = c + a t,    touch: closing^2 = c^2 + 2 a s.
// The impulse that turns the closing speed of that moment into e times as much of parting changes the velocity that is
// stored by as much as the velocity of that moment; the pose at the end of the substep only by what is left of it. So
// the flight after an impact has the energy of the one before if e = 1, and e^2 of it relative to the ground if not,
// at any step and whatever the integrator; the pose is that of the closed form.
//
// A contact found too late, already overlapping, is hit in the past: at most one step ago, before which it would have
// been found.
#pragma once

#include "dynamics/contact/contact.h"

namespace carom::dynamics {

/// Within begin_substep(): velocities and gaps before the forces of this substep, at rows that bounce.
void measure_approach(const World& world);

/// Stage functions of the page.
/// Impacts of this substep. Velocities and poses after it are such that the bodies, moved by them over the whole
/// substep, end where impacts leave them; predicted poses of integrators are brought up to date, separations measured.
void solve_impacts(const World& world, Poses& poses, Velocities& motion, StepReport& report, const StepTime& time);

/// When and how fast two points meet.
struct Touch {
  Real time;   // s, since the substep began
  Real speed;  // m/s; 0: they do not meet
};
/// The first contact that is not over.
/// @param gap, closing, accel  m, m/s, m/s^2: as the substep begins, closing counts as positive
/// @param since  s, of the last impact of either body; negative: there was none, and a contact may be as long ago
Touch find_touch(Real gap, Real closing, Real accel, Real since);

}  // namespace carom::dynamics
