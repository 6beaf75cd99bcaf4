// Which pairs slide as a step begins, and how far from the middle of its load a patch bears.
#pragma once

#include "core/constant.h"
#include "dynamics/contact/contact.h"

namespace carom::dynamics {

inline constexpr Constant<Real> kCreeps{
    "friction_creeps", 0.01, "m/s",
    "slip at any point of a pair below which it is taken to stick, its friction acting at the middle of its points: "
    "above the slip of bodies that come to rest, well below visible sliding",
    "smaller: friction of piles that settle moves about with their loads, and they settle later; larger: slow rollers "
    "and pucks get friction where they do not touch"};
inline constexpr ConstantRow kPatchFrictionConstants[] = {kCreeps};

/// Of a pair with more points than one, and friction, that may slip.
void look_for_slide(const World& world, std::uint32_t first, std::uint32_t count, const Vec3* surface);
/// Whether a pair with more points than one may slide whose surfaces slip by something more than its bodies do; else
/// find_slide() said so already.
/// @param more2  (m/s)^2, bound on what is more
bool may_slide(const World& world, std::uint32_t first, std::uint32_t count, Real more2);

/// Set what a pair's first row says of its friction. A pair slides if it slips at one of its points. Only of what
/// slides does it matter where between them friction acts, and how sliding and spinning share it. What sticks keeps one
/// place, whatever its loads do. One point has but one place, and what is yet to meet bears nothing. What overlaps by
/// more than points are looked for apart has no patch: it parts.
/// @param surface  m/s, [count], what B's does relative to A's by itself; null: nothing
inline void find_slide(const World& world, std::uint32_t first, std::uint32_t count, const Vec3* surface) {
  Row& row = world.contacts->rows[first];
  row.slides = row.slides_by_load = false;
  if (count > 1 && row.friction > 0) look_for_slide(world, first, count, surface);
}

/// A flat patch presses all over: where its load is even, the mean distance of its places from their middle is this
/// share of that of its corners. Friction resists a spin with mu N times that distance. Solvers that bear friction
/// point by point draw its points in towards the middle of the load by this share.
/// @param corners   points of the manifold
/// @param are_more  the patch has more corners than the four that were kept, all of them on a rim
/// @return  1/2 for a line; 0.47 for a triangle, 0.541 for a square (1/2 for a long plank), 2/3 for a disc, and an
///          octagon 0.63: what has more corners than four is taken for something between these
/// @oracle  tests/oracle/test_friction
inline Real twist_share(int corners, bool are_more) {
  constexpr Real kOf[] = {1, 1, 0.5, 0.47, 0.54};
  return are_more ? Real(0.65) : kOf[corners];
}

}  // namespace carom::dynamics
