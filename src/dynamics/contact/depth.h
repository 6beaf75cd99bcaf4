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

/// m, of the thinner of the two colliders that touch; infinite where neither has a far side.
inline Real least_thickness(const World& world, const Pair& pair) {
  const Colliders& colliders = world.scene.colliders;
  return std::min(thickness(*colliders.shape[pair.a]), thickness(*colliders.shape[pair.b]));
}
inline Real least_thickness(const World& world, const RowGeometry& g) {
  return least_thickness(world, world.pairs.place(g.pair).pair);
}

/// m, the dial's tolerance, but no more than a share of what is thin.
inline Real tolerable_depth(const World& world, const Pair& pair) {
  return std::min(world.scene.dials[Dial::position_tolerance], kTolerableDepth * least_thickness(world, pair));
}
inline Real tolerable_depth(const World& world, const RowGeometry& g) {
  return tolerable_depth(world, world.pairs.place(g.pair).pair);
}

/// m/s^2, what pulls harder of two that touch.   @param gravity  m/s^2, the world's
inline Real pull_on(const Scene& scene, const Row& row, Real gravity) {
  const auto of = [&](bool moves, std::uint32_t body) {
    return moves ? std::fabs(scene.gravity_factor_of(body)) * gravity : 0;
  };
  return scene.attributes.bodies(AttributeId::gravity_factor) == 0
             ? gravity
             : std::max(of(row.moves_a, row.a), of(row.moves_b, row.b));
}
inline Real pull_on(const Scene& scene, const Row& row) { return pull_on(scene, row, scene.gravity.norm()); }

}  // namespace carom::dynamics
