// Up to four contact points, kept from step to step: refreshed, dropped, added to, chosen from.
#include <algorithm>

#include "collision/manifold/choice.h"
#include "collision/manifold/match.h"

namespace carom::collision {
namespace {

// A kept point whose normal differs from the newest by more than this (cosine; 20 degrees) belonged to another face.
constexpr Real kSameNormal = 0.94;

/// Kept points at the new poses, with the newest normal; those that opened, slid away or lie on another face are left
/// out.
/// @param fresh  space for them, which the pool then points into
void refresh(const Frame& a, const Frame& b, const Vec3& normal, const ManifoldSettings& settings,
             const Manifold& manifold, ContactPoint (&fresh)[Manifold::kMaxPoints], Pool& pool) {
  for (int i = 0; i < manifold.count; ++i) {
    ContactPoint& p = fresh[i];
    p = manifold.point[i];
    if (!(p.normal.dot(normal) > kSameNormal)) continue;
    const Vec3 gap = b.apply(p.on_b) - a.apply(p.on_a);
    p.normal = normal;
    p.separation = normal.dot(gap);
    if (!(p.separation <= settings.contact_distance)) continue;
    const Vec3 drift = gap - p.separation * normal;
    if (!(drift.squared_norm() <= settings.cache_distance * settings.cache_distance)) continue;
    pool.add(p, p.age + 1);
  }
}

/// A new point takes the place, and the age, of the kept one that it is; others are added.
void merge(const Candidates& found, const ManifoldSettings& settings, Pool& pool) {
  const int kept = pool.count;
  for (int i = 0; i < found.count; ++i) {
    const ContactPoint& p = found.point[i];
    if (!(p.separation <= settings.contact_distance)) continue;
    int at = 0;
    while (at < kept && !same_point(*pool.point[at], p, merge_distance(settings))) ++at;
    if (at == kept)
      pool.add(p, 0);
    else
      pool.point[at] = &p;
  }
}

/// The whole patch: old points lend their age to their successors, no more. Successors come first, so that a choice
/// between equals falls on them.
void replace(const Candidates& found, const ManifoldSettings& settings, const Manifold& manifold, Pool& pool) {
  bool is_new[Candidates::kMax] = {};
  for (int i = 0; i < found.count; ++i) {
    const ContactPoint& p = found.point[i];
    if (!(p.separation <= settings.contact_distance)) continue;
    int old = 0;
    while (old < manifold.count && !same_point(manifold.point[old], p, merge_distance(settings))) ++old;
    is_new[i] = old == manifold.count;
    if (!is_new[i]) pool.add(p, manifold.point[old].age + 1);
  }
  for (int i = 0; i < found.count; ++i)
    if (is_new[i]) pool.add(found.point[i], 0);
}

}  // namespace

void update_cache(const Frame& a, const Frame& b, const Candidates& found, const ManifoldSettings& settings,
                  Manifold& manifold) {
  const ContactPoint* const nearest = deepest(found, settings.contact_distance);
  if (!nearest) {  // the nearest points are too far apart, so are all others
    manifold.count = 0;
    return;
  }
  Pool pool;
  if (found.whole) {
    replace(found, settings, manifold, pool);
    store(a, settings, pool, 0, manifold);
    manifold.has_more_corners |= found.on_rim && manifold.count == Manifold::kMaxPoints;
    return;
  }
  ContactPoint fresh[Manifold::kMaxPoints];
  refresh(a, b, nearest->normal, settings, manifold, fresh, pool);
  merge(found, settings, pool);
  store(a, settings, pool, 0, manifold);
}

}  // namespace carom::collision
