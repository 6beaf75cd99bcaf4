// What stands: a solution made one that lasts.
#pragma once

#include "dynamics/solver/direct/cone_problem.h"

namespace carom::dynamics {

/// Of a solution in which all lies still: velocities that are within its tolerance are undone too, where that leaves
/// the impulses within their cones, and contacts start the next substep from impulses that balance what loads give in
/// one. So velocities stay what they are, which is next to nothing, step after step. The solution's own impulses would
/// not do: they undid what had gathered before, and would undo it again and again.
/// @param tolerance  m/s, of the solution   @return factorisations taken; 0: such impulses were not found
std::uint32_t rest(ConeProblem& problem, Real tolerance);

}  // namespace carom::dynamics
