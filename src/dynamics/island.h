// Contact groups: which contacts and joints hang together through bodies that they can move.
#pragma once

#include "dynamics/contact/contact.h"

namespace carom::dynamics {

/// Stage group: by union-find over rows between two dynamic bodies. Static, kinematic
/// and quarantined bodies cut the chain. With the dial off, all rows are one group. Order: groups by their lowest row,
/// those of joints alone after them, rows ascending.
void find_groups(const World& world, StepReport& report, const StepTime& time);

/// The body that a dynamic body's group is named after, of those that hang together by the last partition into groups:
/// the lowest slot. @param body  one that a row moves
std::uint32_t island_of(Contacts& contacts, std::uint32_t body);

/// The group of such a body.
std::uint32_t group_of(Contacts& contacts, std::uint32_t body);

/// Root of a body's tree of a union-find; halves the path, so that later searches are short.
std::uint32_t root_of(Array<std::uint32_t>& parent, std::uint32_t body);

/// The partition alone, from contact pairs and links.   @oracle tests/unit/dynamics/test_island (breadth-first
/// twin)
void partition_rows(Contacts& contacts, std::size_t body_slots, bool grouped, Jobs* jobs = nullptr);

}  // namespace carom::dynamics
