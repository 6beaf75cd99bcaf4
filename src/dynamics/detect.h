// The two collision stages of the page: broad and narrow phase on the world's colliders.
#pragma once

#include "collision/narrow/narrow_phase.h"
#include "dynamics/effects.h"

namespace carom {

/// How the dials want pairs to be asked.
NarrowSettings narrow_settings(const Dials& dials);

/// Stage broad: pairs of colliders whose bounds overlap.
void find_pairs(World& world, const StepTime& time);

/// Stage narrow: manifolds of those pairs. Shapes whose support function misbehaved are muted from here on.
void find_contacts(World& world, const StepTime& time);

}  // namespace carom
