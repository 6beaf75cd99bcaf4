// What the direct solver knows of bodies and contacts, from where they are.
#pragma once

#include "dynamics/solver/direct.h"

namespace carom {

/// Masses, in the body's present orientation.
void load_mass(const World& world, ConeBody& body);
/// Where a contact is, and what depends on that. Bodies have the velocities of the state.
void load_contact(const World& world, std::uint32_t row, const ConeBody* bodies, ConeContact& contact);
/// Bodies and contacts, as the step begins.
void load_groups(World& world, DirectGroups& d);

}  // namespace carom
