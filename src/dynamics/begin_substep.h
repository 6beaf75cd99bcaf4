// What a substep saves of its beginning, once, for all who ask for it.
#pragma once

#include "dynamics/effects.h"

namespace carom::dynamics {

/// Stage functions of the step. Reserves Plan::begun, where a stage will ask for it; allocates.
void reserve_begun(const World& world, const StepTime& time);
/// Before the forces of a substep: bodies that a host moves are led on; velocities of bodies that hang on joints, that slide in small groups or that are
/// swept; paths of those; approach at rows that bounce. Of other bodies nothing is read.
void begin_substep(const World& world, Velocities& to, const StepTime& time);

}  // namespace carom::dynamics
