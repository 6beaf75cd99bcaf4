// When two contact points, of this step and the last, are the same point.
#pragma once

#include "collision/manifold/manifold.h"

namespace carom::collision {

/// m: points nearer to each other than this are one. A quarter of the drift that a kept point may have, so that a point
/// that slides is replaced by its successor well before it is dropped, and corners of a small box stay four.
inline Real merge_distance(const ManifoldSettings& settings) { return settings.cache_distance / 4; }

/// The same known features met, or the points lie side by side on either shape.
inline bool same_point(const ContactPoint& p, const ContactPoint& q, Real distance) {
  if (p.feature != 0 && p.feature == q.feature) return true;
  const Real d2 = distance * distance;
  return (p.on_a - q.on_a).squared_norm() <= d2 || (p.on_b - q.on_b).squared_norm() <= d2;
}

}  // namespace carom::collision
