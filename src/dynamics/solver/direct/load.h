// What the direct solver knows of bodies and contacts, from where they are.
#pragma once

#include "dynamics/solver/direct.h"

namespace carom::dynamics {

/// Masses, in the body's present orientation.
void load_mass(const World& world, ConeBody& body);
enum class LoadWhat { all, not_curved };
/// Where contacts are, and what depends on that. Bodies have the velocities of the state.
/// @param rows, contacts  ascending, all or none of a pair's
void load_contacts(const World& world, std::span<const std::uint32_t> rows, const ConeBody* bodies,
                   ConeContact* contacts, LoadWhat what);
/// Bodies and contacts of a group.
void load_group(const World& world, std::size_t group);
/// Likewise of all, as the step begins; but not of those that stand unchanged.   @param h  s, substep
void load_groups(const World& world, SolverMemory& memory, Real h);

}  // namespace carom::dynamics
