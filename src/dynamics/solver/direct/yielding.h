// The convex problem of a substep: every row yields a little, so that it has one solution, whatever touches and is joined.
//
//     least over v of  |v - v_free|^2_M / 2 + sum over contacts of give/2 |p|^2 + sum over locks of R/2 |p - p_last|^2
//
// Contacts yield by `give` of their response, and bear friction up to mu times the normal impulse of the last substep:
// that is known, so friction and normal impulses do not ask for each other. At fixed poses kinetic energy is no more
// after than before, but for what drives and springs give (README.md has the proof). It shares out what the law leaves
// undetermined, as what a door that hangs and stands bears at its hinge, and has a solution where the law has none, as
// where surfaces close on a body. The exact law is then solved from there, where it can be (ConeGroup::find()).
#pragma once

#include "dynamics/solver/direct/cone_problem.h"

namespace carom::dynamics {

/// ConeContact::most_friction, by what was borne in the last substep.
void bound_friction(ConeProblem& problem);

/// Newton's method on it, from the impulses that act. One that is cut short keeps the impulses of its steps: what they
/// do to the bodies is what was found, to the bit.
/// @param give  of a contact's response   @param tolerance  m/s
/// @param forgets  1: contacts yield from where they bear nothing; less: by so much, from what acts already
/// @return      steps taken
std::uint32_t solve_yielding(ConeProblem& problem, Real give, Real forgets, Real tolerance);

/// From a solution that yields on: rounds in which each contact keeps to what it bore in the round before, friction as it is
/// known: by what was borne in the last substep, of what begins to bear by the round before. What a contact gives shrinks by the softness of what it
/// bears on. Where a round leaves most of the error, what is light bears what is heavy: the next one is as much harder as that tells.
/// It is taken back where Newton's method does not come to its end in it.
/// @param tolerable  m/s: what is no faster needs no harder round
/// @param give  as of that solution: one matrix serves while the same contacts stick   @return its residual is of known friction
ConeSolution solve_closer(ConeProblem& problem, Real give, Real tolerance, Real tolerable);

/// Friction of such a solution, which bounds of the last substep held, within the cones of what bears now.
void bound_by_cones(ConeProblem& problem);

/// Sum of k p^2 of contacts, kg m^2/s^2.
Real borne(const ConeProblem& problem);

/// Whether impulses are far larger than what they do to the bodies asks for.
bool is_wedged(const ConeProblem& problem);

/// Whether surfaces move by themselves where contacts are: those of what impulses do not move, belts, and patches that
/// slide (spread() reckons what their spin does as the surface's).
bool is_driven(const ConeProblem& problem);

/// Whether bodies leave faster than surfaces that meet them could throw them (kThrow).
bool throws(const ConeProblem& problem);

/// Whether contacts and joints gave energy, beyond what a solution within a residual may.
/// @param residual  m/s
bool gives_energy(ConeProblem& problem, Real residual);

/// What kinetic energy after the convex problem is above the bound that README.md proves, with an allowance for Newton's tolerance
/// and for rounding. Above 0 it is a bug of ours where ConeProblem::is_proven.
/// @param problem  impulses of locks are found   @return J
Real excess_energy(const ConeProblem& problem);

/// How much of the impulses that a substep starts from is worth keeping: all, unless they would give energy where the
/// bodies are by now; then as much as takes the most.
/// @param problem  gradient: momentum that rows give each body; before: velocities without   @return 0 to 1
Real share_that_helps(ConeProblem& problem);

/// Locks no longer ask for the bend of their arms.   @return whether any did
bool drop_bends(ConeProblem& problem);

/// As if nothing touched and nothing were joined.
void drop_impulses(ConeProblem& problem);

}  // namespace carom::dynamics
