// The two collision stages of the page: broad and narrow phase on the world's colliders.
#pragma once

#include "collision/broad/broad_phase.h"
#include "collision/narrow/narrow_phase.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {

/// How the dials want pairs to be asked.
NarrowSettings narrow_settings(const Dials& dials);
/// As contacts are found in a step: finer by its square where it is shorter than 1/60 s, else errors of distances and
/// normals would not fall with the step.   @param dt  s
NarrowSettings narrow_settings(const Dials& dials, Real dt);

/// Points of a pair as it stands, as ManifoldKind::clip has them. Left as they are where there are none.
void find_manifold(const PatchPair& pair, const NarrowSettings& settings, QueryMemory& memory, Manifold& manifold,
                   NarrowReport& report, SupportFault& fault);

/// The strategy of the dial, made when first asked for.
BroadPhase& broad_phase(const World& world, BroadPhases& all);

/// Disable a shape in this world, from the next step on, and say so.
void disable(const World& world, Revisions& scene, FaultViews& views, const SupportFault& fault);

/// Stage broad: pairs of colliders whose bounds overlap.
void find_pairs(const World& world, BroadPhases& broad, ClearingSleepers to, Events& events, StepReport& report,
                const StepTime& time);

/// Stage narrow: manifolds of those pairs. Shapes whose support function misbehaved are disabled from here on.
void find_contacts(const World& world, PairTable& pairs, Revisions& scene, FaultViews& views, StepReport& report,
                   const StepTime& time);

}  // namespace carom::dynamics
