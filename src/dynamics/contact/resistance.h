// Rolling and spinning resistance: a contact between soft or rough surfaces bears a moment.
//
// Where a contact presses with the impulse p, its bodies exchange a moment: about the normal up to spinning * p,
// against their relative spin, and in the tangent plane up to rolling * p, against their relative rolling. Both
// coefficients are lengths: how far from the middle of the contact the normal force may act, and the mean arm of
// friction over the patch that touches. Below these bounds nothing rolls and nothing spins.
//
// The moment of the last substep acts before the solver, as any torque would; once the solver knows how hard contacts
// press, the moments are put right, one pair after the other. So any solver will do, and what holds still is found over
// some substeps: a ball of moment of inertia I that is put on a slope rolls g sin h^2 (m r^2 / I) down before it is
// held.
#pragma once

#include "dynamics/contact/contact.h"

namespace carom::dynamics {

/// Stage functions of the page.
/// Resisting pairs of this step and the moments that they start from; nothing where no material resists.
void find_resistance(const World& world, const StepTime& time);
/// Let the moments act that were found last.
void hold_moments(const World& world, Velocities& to, const StepTime& time);
/// Moments of this substep, within what its contacts bear.
void resist(const World& world, Velocities& to, const StepTime& time);

/// The moment impulse after which a pair neither rolls nor spins, or resists as much as it can.
/// @param moment  N m s, on B, that acts already   @param omega  rad/s, of B relative to A, while it acts
/// @param k       1/(kg m^2), world: change of omega per moment impulse
/// @param n       unit, world   @param rolling, spinning  N m s, bounds
/// @return N m s, world, on B
Vec3 resisting_moment(const Vec3& moment, const Vec3& omega, const Mat3& k, const Vec3& n, Real rolling, Real spinning);

}  // namespace carom::dynamics
