// Contact points of a pair: at most four, kept from step to step.
#pragma once

#include <memory>
#include <utility>

#include "core/pose.h"

namespace carom::collision {

struct ContactPoint {
  Vec3 on_a = Vec3::zero();      // m, frame of collider A's shape
  Vec3 on_b = Vec3::zero();      // m, frame of collider B's shape
  Vec3 normal = Vec3::unit_y();  // unit, WORLD frame, from A to B
  Real separation = 0;           // m, negative in overlap, at the last refresh
  std::uint32_t feature = 0;     // which features met, to match points between steps; 0: unknown
  std::uint32_t age = 0;         // steps since it was added
};

/// The same point with A and B exchanged.
inline ContactPoint exchanged(ContactPoint p) {
  std::swap(p.on_a, p.on_b);
  p.normal = -p.normal;
  return p;
}

struct Manifold {
  static constexpr int kMaxPoints = 4;
  int count = 0;
  bool has_more_corners = false;  // the patch has more than kMaxPoints
  ContactPoint point[kMaxPoints];
};

/// What one call of the narrow phase found: up to 8 candidates, before a manifold chooses.
struct Candidates {
  static constexpr int kMax = 8;
  int count = 0;
  bool whole = false;     // a specific routine found every point of the patch: nothing older need be kept
  bool on_rim = false;    // likewise; four of its points stand for a whole rim
  Real gap = -kInfinity;  // m: where no candidate was found, the distance is not less, to rounding
  union {                 // not made before they are found: that would take as long as a routine
    ContactPoint point[kMax];
  };

  Candidates() {}
  Candidates(const Candidates& o) : count(o.count), whole(o.whole), on_rim(o.on_rim), gap(o.gap) {
    std::uninitialized_copy_n(o.point, o.count, point);
  }
  Candidates& operator=(const Candidates&) = delete;
  ContactPoint& add() { return *std::construct_at(point + count++); }
};

/// The deepest of the points that are near enough, the first of equals; null if there is none. @param reach  m
inline const ContactPoint* deepest(const Candidates& found, Real reach = kInfinity) {
  const ContactPoint* best = nullptr;
  for (const ContactPoint* p = found.point; p < found.point + found.count; ++p)
    if (p->separation <= reach && (!best || p->separation < best->separation)) best = p;
  return best;
}

enum class ManifoldKind : std::uint32_t { single, cache, patch, clip };

/// Kinds that find the whole patch of a pair in one step.
inline bool one_shot(ManifoldKind kind) { return kind >= ManifoldKind::patch; }

struct ManifoldSettings {
  ManifoldKind kind = ManifoldKind::cache;
  Real cache_distance = 0.02;    // m: a kept point that slid or opened further than this is dropped
  Real contact_distance = 0.02;  // m: candidates farther apart than this are not kept
  bool sunk_alike = false;       // points in overlap bear alike, however deep: both ends of a rod that lies in a ground
  Real keep_distance = 1e-3;     // m: how far two bodies may move before their patch is looked for anew
};

/// ManifoldKind::single: the deepest candidate alone.
void keep_deepest(const Candidates& found, const ManifoldSettings& settings, Manifold& manifold);

/// ManifoldKind::cache: refresh the kept points for the new poses, drop those that opened or slid away, merge the
/// candidates in, and choose the four that hold the deepest point and the largest area.
void update_cache(const Frame& a, const Frame& b, const Candidates& found, const ManifoldSettings& settings,
                  Manifold& manifold);

}  // namespace carom::collision
