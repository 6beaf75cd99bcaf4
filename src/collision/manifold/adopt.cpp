// Old points matched to new ones, one to one.
#include "collision/manifold/adopt.h"

#include "collision/manifold/match.h"

namespace carom::collision {
namespace {

// A new point takes an old one's place if it widens the patch by this share of its width: below, which of two nearly
// equal sets is kept stays as it was.
constexpr Real kLoyalty = 0.02;
// Old and new are the same point within this share of the patch's width (and within merge_distance).
constexpr Real kNear = 0.2;

Real distance2(const ContactPoint& p, const ContactPoint& q) {
  return std::min((p.on_a - q.on_a).squared_norm(), (p.on_b - q.on_b).squared_norm());
}

/// The new point that an old one became, or -1.
int successor(const ContactPoint& old, const ContactPoint* points, int count, const bool* taken, Real limit2) {
  int best = -1;
  for (int i = 0; i < count; ++i) {
    if (taken[i]) continue;
    if (old.feature != 0 && old.feature == points[i].feature) return i;
    const Real d2 = distance2(old, points[i]);
    if (d2 <= limit2) limit2 = d2, best = i;
  }
  return best;
}

/// What adopt() does with a point that is alone, as all are of what is round.
void adopt_one(const ContactPoint& point, const ManifoldSettings& settings, Manifold& manifold) {
  if (!(point.separation <= settings.contact_distance)) {
    manifold.count = 0;
    return;
  }
  const bool taken = false;
  const Real merge = merge_distance(settings);
  std::uint32_t age = 0;
  for (int k = 0; k < manifold.count && age == 0; ++k)
    if (successor(manifold.point[k], &point, 1, &taken, merge * merge) == 0) age = manifold.point[k].age + 1;
  manifold.count = 1, manifold.has_more_corners = false;
  manifold.point[0] = point;
  manifold.point[0].age = age;
}

}  // namespace

void adopt(const Frame& a, const ContactPoint* points, int count, const ManifoldSettings& settings,
           Manifold& manifold) {
  if (count == 1) return adopt_one(*points, settings, manifold);
  bool taken[Pool::kMax] = {};
  Real width2 = 0;
  int near = 0;
  for (int i = 0; i < count; ++i) {
    taken[i] = !(points[i].separation <= settings.contact_distance);
    near += !taken[i];
    width2 = std::max(width2, (points[i].on_a - points[0].on_a).squared_norm());
  }
  if (near == 0) {
    manifold.count = 0;
    return;
  }
  const Real merge = merge_distance(settings);
  const Real limit2 = width2 > 0 ? std::min(merge * merge, kNear * kNear * width2) : merge * merge;
  Pool pool;
  for (int k = 0; k < manifold.count; ++k) {
    const int i = successor(manifold.point[k], points, count, taken, limit2);
    if (i < 0) continue;
    taken[i] = true;
    pool.add(points[i], manifold.point[k].age + 1);
  }
  for (int i = 0; i < count; ++i)
    if (!taken[i]) pool.add(points[i], 0);
  store(a, settings, pool, kLoyalty, manifold);
}

}  // namespace carom::collision
