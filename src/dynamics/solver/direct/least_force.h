// Impulses that the law leaves undetermined, and solutions that may not stand.
//
// A door that hangs on a hinge and touches the floor is borne by either: any load from none to infinite obeys the law,
// and friction with it. Two surfaces that close on a body ask for what no velocity can do: their impulses grow without
// end. So two rules stand beside the law:
//
//  - **Least force.** Where joints and contacts share a load it is that of contacts which yield a little, u + e p in
//    place of u: unique, finite, and as small as the load allows (kGiveOfContacts). The exact law is then solved from
//    there, by rounds that move impulses no farther than they must.
//  - **No gain.** Contacts and friction take energy, relative to the surfaces that carry them. A solution that gives is
//    not one; neither are impulses that all but cancel each other (kWedged).
#pragma once

#include "dynamics/solver/direct/cone_problem.h"

namespace carom::dynamics {

/// As solve_cones(), by the rule of least force: with contacts that yield, then without. Where the exact law has no
/// solution within reach, what contacts that yield bear stands, and is_wedged says so.
ConeSolution solve_with_least_force(ConeProblem& problem, Real tolerance, std::uint32_t most_steps);

/// Whether impulses are far larger than what they do to the bodies asks for.
bool is_wedged(const ConeProblem& problem);

/// As solve_cones(), with contacts that yield by a share of their response.
ConeSolution solve_yielding(ConeProblem& problem, Real share, Real tolerance, std::uint32_t most_steps);

/// Whether bodies leave faster than surfaces that meet them could throw them (kThrow).
bool throws(const ConeProblem& problem);

/// How much of the impulses that a substep starts from is worth keeping: all, unless they would give energy where the
/// bodies are by now; then as much as takes the most.
/// @param problem  gradient: momentum that contacts give each body; before: velocities without   @return 0 to 1
Real share_that_helps(const ConeProblem& problem);

/// Whether contacts and joints gave energy, beyond what a solution within a residual may.
/// @param residual  m/s
bool gives_energy(ConeProblem& problem, Real residual);

/// Locks no longer ask for the bend of their arms.   @return whether any did
bool drop_bends(ConeProblem& problem);

/// As if nothing touched and nothing were joined.
void drop_impulses(ConeProblem& problem);

/// Joints as a problem of their own, whatever contacts bear.
void hold_joints(ConeProblem& problem);

/// A solution that cannot: from no impulses on, contact by contact, each of which takes energy or leaves it, with
/// contacts as soft as those of solver soft_step. As good as some sweeps are, and bounded.
void solve_by_sweeps(ConeProblem& problem);

/// Sweeps of that kind, from the impulses that act already.
void sweep(ConeProblem& problem, int times);

}  // namespace carom::dynamics
