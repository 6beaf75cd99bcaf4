// Who may touch whom, as far as a host says so: filters of colliders and pairs of bodies that are excepted. Stages
// without participants are not entered: a world in which no filter is set pays nothing.
#pragma once

#include "dynamics/effects.h"

namespace carom::dynamics {

/// Row of the table: colliders with a filter of their own.
namespace filtering {
void find(const Scene&, const State&, Participants&);
}

/// Whether filters and exceptions let two colliders touch.
bool lets_touch(const Scene& scene, std::uint32_t a, std::uint32_t b);
/// Whether anybody is held apart at all, as of this step's plan.
bool any_held_apart(const World& world);
/// Drop the pairs that are to be held apart, in their order.
void drop_filtered(const World& world, Array<Pair>& pairs);

}  // namespace carom::dynamics
