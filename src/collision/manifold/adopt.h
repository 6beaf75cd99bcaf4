// Ages and places of contact points from one whole patch to the next.
#pragma once

#include "collision/manifold/choice.h"

namespace carom::collision {

/// Replace a manifold by the points of a new patch. Each old point hands its age to the new point nearest to it, on
/// either shape, or made of the same features; where there are more than four, the choice between equals stays with
/// those. No two points are merged, however small the shapes are.
/// @param points  [count] at most Pool::kMax; those farther apart than the contact distance are left out
void adopt(const Frame& a, const ContactPoint* points, int count, const ManifoldSettings& settings, Manifold& manifold);

}  // namespace carom::collision
