// How deep two may rest in each other.
#pragma once

#include <algorithm>

#include "core/constant.h"
#include "dynamics/contact/contact.h"

namespace carom::dynamics {

inline constexpr Constant<Real> kTolerableDepth{
    "tolerable_depth", 0.02, "1",
    "of the thickness of the thinner of two that touch, the depth to which they are left in each other, if "
    "position_tolerance is more",
    "larger: cards and needles that arrive fast rest inside what they lie on; smaller: work for overlaps that are not "
    "seen"};
inline constexpr ConstantRow kDepthConstants[] = {kTolerableDepth};

/// m, the dial's tolerance, but no more than a share of what is thin.
inline Real tolerable_depth(const World& world, const RowGeometry& g) {
  const Colliders& colliders = world.scene.colliders;
  const Pair& pair = world.pairs.place(g.pair).pair;
  const Real thin = std::min(thickness(*colliders.shape[pair.a]), thickness(*colliders.shape[pair.b]));
  return std::min(world.scene.dials[Dial::position_tolerance], kTolerableDepth * thin);
}

}  // namespace carom::dynamics
