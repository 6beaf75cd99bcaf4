// What stood, and is asked again what it was asked in the last step, is not solved again.
//
// A solution is a function of its problem. Where a step left a group as it found it, to the bit, all velocities nought
// and all impulses those that it started from, and the next step asks the same of it, its solution is known. Whether it
// is the same is told by prints (64-bit hashes) of all that a solution is made from: of the problem as the step begins,
// and in each substep of what loads have made of the velocities. So whatever changes is noticed, whoever changed it, and
// nothing need be told to this file. It keeps no state that a snapshot must have: a world that lacks it solves once, to
// the same bits.
//
// @oracle tests/stability/unchanged
#pragma once

#include "dynamics/solver/direct/cone_problem.h"
#include "dynamics/world.h"

namespace carom::dynamics {

/// What all groups of a step have in common: dials, gravity, lengths of steps.   @param h  s, substep
std::uint64_t print_of_step(const World& world, Real h);
/// The problem of a group as a step begins; 0: it is none that is kept.   @param rows  of its contacts
std::uint64_t print_of_problem(const World& world, std::span<const ConeBody> bodies,
                               std::span<const std::uint32_t> rows, std::uint64_t of_step);
/// What its bodies do before contacts act.
std::uint64_t print_of_motion(const World& world, std::span<const ConeBody> bodies);

}  // namespace carom::dynamics
