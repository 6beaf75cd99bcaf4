// The table of colliders: what broad and narrow phase read. One row per slot, structure of arrays; dynamics fills it.
#pragma once

#include <algorithm>

#include "collision/shape.h"
#include "core/pose.h"

namespace carom {

struct Colliders {
  explicit Colliders(Memory* m)
      : shape(m),
        local(m),
        body(m),
        material(m),
        density(m),
        frame(m),
        travel(m),
        bounds(m),
        reach(m),
        movable(m),
        muted(m),
        live(m),
        active(m),
        next(m),
        apart(m) {}

  // Fixed while a step runs:
  Array<const Shape*> shape;      // null in a free slot
  Array<Pose> local;              // shape -> body frame (origin as the host gave it)
  Array<std::uint32_t> body;      // slot of the body it hangs on
  Array<std::uint32_t> material;  // slot, or kNoMaterial
  Array<Real> density;            // kg/m^3
  // Moved by every step:
  Array<Frame> frame;           // shape -> world
  Array<Real> travel;           // m: no point of it has come farther since the collider was made; @see place()
  Array<Aabb> bounds;           // m, world, grown by what the scene asks for (contact distance, motion of the step)
  Array<Real> reach;            // m: a fast collider meets others that are this much farther than the contact distance
  Array<std::uint8_t> movable;  // 1: its body can move (dynamic or kinematic); 0: static
  Array<std::uint8_t> muted;    // 1: makes no pairs (its shape or body is in quarantine)
  Array<std::uint32_t> live;    // slots in use, ascending
  Array<std::uint32_t> active;  // those of them that the broad phase goes through (not asleep), ascending
  Array<std::uint32_t>
      next;  // the body's next collider, ascending by slot, or kNone (the first: Scene::first_collider)

  Array<std::uint64_t> apart;  // body_pair()s whose colliders may not touch, ascending, some more than once

  static constexpr std::uint64_t body_pair(std::uint32_t lower, std::uint32_t higher) {
    return (std::uint64_t{lower} << 32) | higher;
  }
  bool keeps_apart(std::uint32_t a, std::uint32_t b) const {
    return std::binary_search(apart.begin(), apart.end(),
                              body_pair(std::min(body[a], body[b]), std::max(body[a], body[b])));
  }

  static constexpr std::uint32_t kNoMaterial = 0xFFFFFFFFu;
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  std::size_t slots() const { return shape.size(); }

  /// Put a collider where it is now; how far it came is added up, rounded up.
  void place(std::uint32_t slot, const Frame& now) {
    const Shape& s = *shape[slot];
    const Real way = way_bound(frame[slot], now, s.form == Form::half_space ? kInfinity : s.bounding_radius);
    if (way != 0) travel[slot] = (travel[slot] + way) * (1 + 4 * kUnitRoundoff);
    frame[slot] = now;
  }
};

/// A pair of collider slots, a < b.
struct Pair {
  std::uint32_t a, b;
  std::uint64_t key() const { return (static_cast<std::uint64_t>(a) << 32) | b; }
  bool operator<(const Pair& o) const { return key() < o.key(); }
  bool operator==(const Pair& o) const { return a == o.a && b == o.b; }
};

/// Whether two colliders may touch at all: different bodies, one of them able to move, neither muted, not kept apart.
inline bool may_touch(const Colliders& c, std::uint32_t a, std::uint32_t b) {
  return c.body[a] != c.body[b] && (c.movable[a] | c.movable[b]) && !(c.muted[a] | c.muted[b]) &&
         (c.apart.empty() || !c.keeps_apart(a, b));
}

}  // namespace carom
