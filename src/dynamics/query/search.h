// What the questions share: the way to a box, the best result so far, and who is asked at all.
#pragma once

#include <algorithm>

#include "collision/cast/heading.h"
#include "collision/volume.h"
#include "dynamics/query/index.h"
#include "dynamics/query/query.h"

namespace carom::dynamics {

/// What rounding may do to a way, in lengths that enter it; as QueryTree has it.
inline constexpr Real kWayRounding = 0x1p-42;

/// A way that a point, or a box about it, goes: [0, length] m along a unit vector.
struct Way {
  Vec3 from = Vec3::zero(), unit = Vec3::unit_x();
  Real length = 0;  // m, may be infinite
  Real speed = 0;   // m per unit of time
  Aabb extent;      // m, about the point

  /// @param motion  any length; of none, the way ends where it begins
  Way(const Vec3& start, const Vec3& motion, Real max, const Aabb& swept) : from(start), extent(swept) {
    const Heading heading(motion);
    if (!(heading.speed > 0)) return;
    unit = heading.unit, speed = heading.speed;
    length = speed * max;
  }
  bool in_reach() const { return QueryTree::reaches(from) && QueryTree::reaches(extent); }
  Real time(Real s, Real max) const { return speed > 0 ? std::clamp(s / speed, Real(0), max) : 0; }

  /// m, at which a box is met, none of it earlier; infinite: never
  Real entry(const Aabb& box) const {
    const Vec3 far = box.lo.abs().max(box.hi.abs());
    const Real more = kWayRounding * (far.max_entry() + from.abs().max_entry() + extent.hi.abs().max_entry() +
                                      extent.lo.abs().max_entry());
    Real in = 0, out = length;
    for (int k = 0; k < 3; ++k) {
      const Real lo = box.lo[k] - extent.hi[k] - from[k] - more, hi = box.hi[k] - extent.lo[k] - from[k] + more;
      if (unit[k] == 0) {
        if (lo > 0 || hi < 0) return kInfinity;
        continue;
      }
      const Real a = lo / unit[k], b = hi / unit[k];
      in = std::max(in, std::min(a, b));
      out = std::min(out, std::max(a, b));
    }
    return in <= out ? in : kInfinity;
  }
};

/// No result comes before its bounds are met: an estimate is put there, and so is one whose support function
/// misbehaved.
inline void keep_within(const Way& way, Real max, const Aabb& bounds, CastResult& r) {
  const bool bad = r.status == QueryStatus::fault;
  if (!bad && r.outcome != CastOutcome::undecided) return;
  const Real entry = way.entry(bounds);
  const Real first = entry < kInfinity ? way.time(entry, max) : bad ? kInfinity : r.time;
  if (bad) {
    r = CastResult();
    r.status = QueryStatus::fault;
    r.outcome = first < kInfinity ? CastOutcome::undecided : CastOutcome::miss;
    r.time = first < kInfinity ? first : max;
  } else {
    r.time = std::max(r.time, first);
  }
}

/// Ask all that a way may meet: ask(slot) says up to where, in m, others are still of interest.
template <class Ask>
void along(const QueryIndex& index, const Way& way, Ask&& ask) {
  if (!way.in_reach()) {
    index.each([&](std::uint32_t slot) { ask(slot); });
    return;
  }
  float limit = QueryTree::above(way.length);
  const auto asked = [&](std::uint32_t slot) { limit = std::min(limit, QueryTree::above(ask(slot))); };
  index.each_beside(asked);
  index.tree().search(QueryTree::Line(index.tree(), way.from, way.unit, way.extent), limit, asked);
}

/// Ask all within a distance of a box: ask(slot) says up to which, in m.
template <class Ask>
void around(const QueryIndex& index, const Aabb& box, Real distance, Ask&& ask) {
  if (!QueryTree::reaches(box)) {
    index.each([&](std::uint32_t slot) { ask(slot); });
    return;
  }
  const auto limited = [](Real d) { return d > 0 ? QueryTree::above(d * d) : QueryTree::above(0); };
  float limit = limited(distance);
  const auto asked = [&](std::uint32_t slot) { limit = std::min(limit, limited(ask(slot))); };
  index.each_beside(asked);
  index.tree().search(QueryTree::Box(index.tree(), box), limit, asked);
}

/// The nearer of two results by a measure, of equals that of the lower slot.
inline bool before(Real one, std::uint32_t slot, Real other, std::uint32_t other_slot) {
  return one < other || (one == other && slot < other_slot);
}

inline bool by_time(const WorldHit& a, const WorldHit& b) {
  return before(a.cast.time, a.collider, b.cast.time, b.collider);
}

/// How much later than its bounds a result that was given the same time may be, m: brackets have a width, and grazes
/// are uncertain by the root of rounding.
inline Real width_of_brackets(const QueryIndex& index, const CastSettings& settings) {
  return std::max(settings.tolerance, Real(1e-6)) * index.largest_radius();
}

}  // namespace carom::dynamics
