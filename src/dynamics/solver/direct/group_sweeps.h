// Sweeps over the rows of a group that is too large to be factored, or could not be solved within its work.
#pragma once

#include "dynamics/solver/direct/cone_problem.h"

namespace carom::dynamics {

/// Row by row, from the impulses that act already: each takes energy or leaves it, with contacts as soft as those of
/// solver soft_step. Joints of a forest hold in the end.
/// @param give  of a contact's response, by which it yields
void sweep(ConeProblem& problem, int times, Real give);

}  // namespace carom::dynamics
