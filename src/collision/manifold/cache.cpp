// Up to four contact points, kept from step to step: refreshed, dropped, added to, chosen from.
#include <algorithm>

#include "collision/manifold/manifold.h"
#include "collision/manifold/match.h"

namespace carom {
namespace {

// A kept point whose normal differs from the newest by more than this (cosine; 20 degrees) belonged to another face.
constexpr Real kSameNormal = 0.94;
// How much side a point must add to be worth a unit of height over the deepest one (rise per run, 3 degrees): points
// that hover do not carry. Steeper: corners that hover displace ones that touch. Flatter: a tilt of a jitter leaves an
// edge in place of a face.
constexpr Real kTilt = 0.05;
// Depths within this share of the contact distance are equal: the choice then stays with the older point.
constexpr Real kSameDepth = 0.01;
constexpr int kMaxPool = Manifold::kMaxPoints + Candidates::kMax;

/// Points to choose from: where they are, and how old.
struct Pool {
  int count = 0;
  const ContactPoint* point[kMaxPool];
  std::uint32_t age[kMaxPool];

  void add(const ContactPoint& p, std::uint32_t a) {
    point[count] = &p;
    age[count++] = a;
  }
};

/// Kept points at the new poses, with the newest normal; those that opened, slid away or lie on another face are left
/// out.
/// @param fresh  room for them, which the pool then points into
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
    if (!(drift.squaredNorm() <= settings.cache_distance * settings.cache_distance)) continue;
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

/// The four of a pool that hold depth and area. All scores are lengths: how far a point widens what is chosen so far
/// (a point, a line, a triangle, seen along the normal), less its height over the deepest divided by kTilt.
class Choice {
 public:
  Choice(const Frame& a, const Pool& pool, Real same_depth) : pool_(pool) {
    const Vec3 normal = a.rotate_inverse(pool.point[0]->normal);
    const Vec3 e1 = any_perpendicular(normal), e2 = normal.cross(e1);
    Real deepest = kInfinity;
    for (int i = 0; i < pool.count; ++i) {
      x_[i] = e1.dot(pool.point[i]->on_a), y_[i] = e2.dot(pool.point[i]->on_a);
      deepest = std::min(deepest, pool.point[i]->separation);
    }
    for (int i = 0; i < pool.count; ++i) cost_[i] = std::max(Real(0), pool.point[i]->separation - deepest) / kTilt;
    int first = 0;
    while (pool.point[first]->separation > deepest + same_depth) ++first;
    take(first);
    take_best([&](int i) { return distance(chosen_[0], i); });
    take_best([&](int i) { return std::fabs(beside(chosen_[0], chosen_[1], i)); });
    if (beside(chosen_[0], chosen_[1], chosen_[2]) < 0) std::swap(chosen_[1], chosen_[2]);  // counter-clockwise
    take_best([&](int i) {
      return -std::min(
          {beside(chosen_[0], chosen_[1], i), beside(chosen_[1], chosen_[2], i), beside(chosen_[2], chosen_[0], i)});
    });
    std::sort(chosen_, chosen_ + Manifold::kMaxPoints);  // in the order of the pool: a point keeps its place
  }

  int operator[](int k) const { return chosen_[k]; }

 private:
  Real distance(int i, int j) const {
    return std::sqrt((x_[j] - x_[i]) * (x_[j] - x_[i]) + (y_[j] - y_[i]) * (y_[j] - y_[i]));
  }
  /// m: how far k lies to the left of the line from i to j.
  Real beside(int i, int j, int k) const {
    const Real dx = x_[j] - x_[i], dy = y_[j] - y_[i], length = std::sqrt(dx * dx + dy * dy);
    return length > 0 ? (dx * (y_[k] - y_[i]) - dy * (x_[k] - x_[i])) / length : 0;
  }
  void take(int i) {
    chosen_[count_++] = i;
    taken_[i] = true;
  }
  template <class Score>
  void take_best(const Score& score) {
    int best = -1;
    Real most = -kInfinity;
    for (int i = 0; i < pool_.count; ++i) {
      if (taken_[i]) continue;
      const Real s = score(i) - cost_[i];
      if (best < 0 || s > most) best = i, most = s;
    }
    take(best);
  }

  const Pool& pool_;
  int count_ = 0;
  int chosen_[Manifold::kMaxPoints] = {};
  bool taken_[kMaxPool] = {};
  Real x_[kMaxPool], y_[kMaxPool], cost_[kMaxPool];
};

void store(const Frame& a, const ManifoldSettings& settings, const Pool& pool, Manifold& manifold) {
  const auto put = [&](int to, int from) {
    manifold.point[to] = *pool.point[from];
    manifold.point[to].age = pool.age[from];
  };
  manifold.count = std::min(pool.count, Manifold::kMaxPoints);
  if (pool.count <= Manifold::kMaxPoints) {
    for (int k = 0; k < pool.count; ++k) put(k, k);
    return;
  }
  const Choice choice(a, pool, kSameDepth * settings.contact_distance);
  for (int k = 0; k < Manifold::kMaxPoints; ++k) put(k, choice[k]);
}

}  // namespace

void update_cache(const Frame& a, const Frame& b, const Candidates& found, const ManifoldSettings& settings,
                  Manifold& manifold) {
  int deepest = -1;
  for (int i = 0; i < found.count; ++i)
    if (found.point[i].separation <= settings.contact_distance &&
        (deepest < 0 || found.point[i].separation < found.point[deepest].separation))
      deepest = i;
  if (deepest < 0) {  // the nearest points are too far apart, so are all others
    manifold.count = 0;
    return;
  }
  Pool pool;
  if (found.whole) {
    replace(found, settings, manifold, pool);
    store(a, settings, pool, manifold);
    return;
  }
  ContactPoint fresh[Manifold::kMaxPoints];
  refresh(a, b, found.point[deepest].normal, settings, manifold, fresh, pool);
  merge(found, settings, pool);
  store(a, settings, pool, manifold);
}

}  // namespace carom
