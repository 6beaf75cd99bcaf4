// A group's forest as a whole: from the leaves to the roots and back, @see tree_node.h.
#pragma once

#include "dynamics/solver/direct/cone_problem.h"

namespace carom::dynamics {

/// Which node is held to which, as bodies are eliminated. Of each node but for where it is.
/// @param nodes  by place, from `first` on
void plant(std::span<TreeNode> nodes, std::span<const TreeJoint> joints, Elimination& order, std::uint32_t first);

/// What the forest is made of, where bodies and their masses are now.
void articulate(ConeProblem& problem);

/// Of articulate(), limits and drives alone: their rows are new, and bodies have hardly turned since.
void free_drives(ConeProblem& problem);

/// Lead velocities of bodies to the nearest, by their masses, at which all locks of the forest have what is asked.
void obey_locks(ConeProblem& problem);

/// ConeBody::step: how arms of the forest's locks bend over the substep: where bodies are displaced to after the move, over
/// its length. Of what goes round evenly to the fourth order in its turn.   @param h  s, substep
void find_bends(ConeProblem& problem, Real h);

/// ConeBody::step: the velocities that the momentum in ConeBody::gradient gives, and what pushes along S.
void respond(ConeProblem& problem);

/// Impulse p of a row, as momentum of its bodies; of a limit or drive of the forest along S, which is all that it does.
inline void push_row(ConeProblem& problem, const ConeLink& c, Real p) {
  if (!c.is_of_child) return add_impulse<&ConeBody::gradient>(problem, c, p);
  TreeNode& node = problem.tree[c.child];
  for (int k = 0; k < node.freedom; ++k) node.pushed[k] += p * c.of_child[k];
}
/// m/s or rad/s, of ConeBody::step, that a row has.
inline Real step_of(const ConeProblem& problem, const ConeLink& c) {
  if (!c.is_of_child) return relative<&ConeBody::step>(problem.bodies, c);
  const TreeNode& node = problem.tree[c.child];
  Real u = 0;
  for (int k = 0; k < node.freedom; ++k) u += c.of_child[k] * node.q[k];
  return u;
}

/// ConeLink::p of locks in the forest: what bodies have gained since ConeBody::unheld beyond what all other rows gave.
void find_lock_impulses(ConeProblem& problem);

}  // namespace carom::dynamics
