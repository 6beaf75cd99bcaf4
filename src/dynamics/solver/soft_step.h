// Small steps and soft contacts: the solver for piles, stacks and games.
//
// A substep of length h starts from the impulses of the one before, solves once with soft contacts, moves, and solves
// once more without them. A soft contact is a spring and damper, integrated implicitly and given as its frequency f and
// damping ratio z rather than its stiffness, so that it behaves alike for light bodies and heavy ones:
//   w = 2 pi f,  a = h w (2 z + h w)
//   the normal velocity sought:   -rate s,              rate = w / (2 z + h w)         s < 0: separation
//   the impulse for it:           -a/(1 + a) m_n (u_n + rate s) - p_n / (1 + a)
// The spring may only press, and undoes penetration at push_speed at most. Relaxing takes back the velocity that the
// spring gave: it stays in the pose. Frequencies above a quarter of the substep rate can't be resolved and are lowered
// to it; against what does not move contacts are twice as stiff.   @source [Catto2024], [Catto2005], [Macklin2019]
#pragma once

#include "dynamics/solver/solver.h"
#include "dynamics/solver/wide_contacts.h"

namespace carom::dynamics {

struct Softness {
  Real bias_rate;      // 1/s
  Real mass_scale;     // in 0..1: of the impulse that would do it at once
  Real impulse_scale;  // in 0..1: of the impulse so far, taken back
};

/// @param frequency  Hz, >= 0   @param damping  ratio, >= 0   @param h  s
Softness softness(Real frequency, Real damping, Real h);
/// s^2, what a soft contact sinks by for each m/s^2 that it bears, of the thickness that the thinner of the two has.
/// @param give  s^2, of two that are thick   @param pull  m/s^2, gravity   @param thickness  m
Real soft_give(Real give, Real pull, Real thickness);

/// Velocities of a substep, of what the direct solver does not solve; bodies that turn far are led back before and on
/// after.
void solve_softly(const World& world, Solver::Solves to, const StepTime& time);
/// Contacts of bodies in WideContacts::swept_again once more, from the velocities that they have there.
void sweep_again(const World& world, Real h);

}  // namespace carom::dynamics
