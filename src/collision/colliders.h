// The table of colliders: what broad and narrow phase read. One row per slot, structure of arrays; dynamics fills it.
#pragma once

#include "collision/shape.h"
#include "core/invalid.h"
#include "core/pose.h"

namespace carom::collision {

/// Whom a collider may touch. Two do if each one's mask has a bit of the other's categories, unless they are of one group
/// other than 0: of a positive one they always do, of a negative one never.
struct Filter {
  std::uint64_t category = 1, mask = ~std::uint64_t(0);
  std::int32_t group = 0;
  bool operator==(const Filter&) const = default;
};
inline bool let_touch(const Filter& a, const Filter& b) {
  if (a.group != 0 && a.group == b.group) return a.group > 0;
  return (a.category & b.mask) && (b.category & a.mask);
}

struct Colliders {
  enum Disable : std::uint8_t { kFaulty = 1, kForbidden = 2 };
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
        disabled(m),
        live(m),
        active(m),
        next(m),
        filter(m),
        sensor(m) {}

  // Fixed while a step runs:
  Array<const Shape*> shape;      // null in a free slot
  Array<Pose> local;              // shape -> body frame (origin as the host gave it)
  Array<std::uint32_t> body;      // slot of the body it hangs on
  Array<std::uint32_t> material;  // slot, or kNoMaterial
  Array<Real> density;            // kg/m^3
  // Moved by every step:
  Array<Frame> frame;            // shape -> world
  Array<Real> travel;            // m: no point of it has come farther since the collider was made; @see place()
  Array<Aabb> bounds;            // m, world, grown by what the scene asks for (contact distance, motion of the step)
  Array<Real> reach;             // m: a fast collider meets others that are this much farther than the contact distance
  Array<std::uint8_t> movable;   // 0: its body is static; kPushed: forces move it; kDriven: it is kinematic
  Array<std::uint8_t> disabled;  // makes no pairs: kFaulty (its shape or body is in quarantine), kForbidden
  Array<std::uint32_t> live;     // slots in use, ascending
  Array<std::uint32_t> active;   // those of them that the broad phase goes through (not asleep), ascending
  Array<std::uint32_t>
      next;              // the body's next collider, ascending by slot, or kInvalid (the first: Scene::first_collider)
  Array<Filter> filter;  // empty until a collider has one of its own

  Array<std::uint8_t> sensor;  // 1: tells of overlap and is never solved; empty until there is one

  static constexpr std::uint8_t kPushed = 1, kDriven = 2;

  bool is_sensor(std::uint32_t slot) const { return slot < sensor.size() && sensor[slot]; }
  Filter filter_of(std::uint32_t slot) const { return slot < filter.size() ? filter[slot] : Filter(); }

  static constexpr std::uint32_t kNoMaterial = 0xFFFFFFFFu;
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

/// Whether somebody notices what touches a collider: it is pushed, or it senses.
inline bool notices(const Colliders& c, std::uint32_t slot) {
  return c.movable[slot] == Colliders::kPushed || c.is_sensor(slot);
}

/// Whether two colliders may touch at all: different bodies, one of them able to move, one that notices, neither disabled.
inline bool may_touch(const Colliders& c, std::uint32_t a, std::uint32_t b) {
  const int moves = c.movable[a] | c.movable[b];
  return c.body[a] != c.body[b] && moves && ((moves & Colliders::kPushed) || c.is_sensor(a) || c.is_sensor(b)) &&
         !(c.disabled[a] | c.disabled[b]);
}

}  // namespace carom::collision
