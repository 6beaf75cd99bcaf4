// Four bodies on one side of four pairs or joints, as lanes: their numbers read and written. Part of contact_sweeps.h
// and joint_sweeps.h; all that stands here is local to the file that includes it.
#pragma once

#include "dynamics/solver/contact_lanes.h"

namespace carom::dynamics {
namespace {

static_assert(offsetof(BodyVelocity, omega) == 3 * sizeof(double) && offsetof(BodyShift, u) == 3 * sizeof(double) &&
              offsetof(BodyShift, w) == 6 * sizeof(double));
/// The numbers of four bodies, as lanes.
template <class Body>
struct BodyRows {
  const double* row[kLanes];

  CAROM_LANES_INLINE BodyRows(const Body* all_bodies, const std::uint32_t* body) {
    for (int i = 0; i < kLanes; ++i) row[i] = reinterpret_cast<const double*>(all_bodies + body[i]);
  }
  CAROM_LANES_INLINE LanePair two(int at) const { return gather(row, at); }
};
/// Component by component.
template <class Number>
CAROM_LANES_INLINE LaneVecOf<Number> each(const LaneVecOf<Number>& a, const LaneVecOf<Number>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

/// Velocities of the four bodies on one side.
struct Side {
  LaneVec v, omega;

  CAROM_SHORT_PART void load(const BodyVelocity* all_bodies, const std::uint32_t* body) {
    const BodyRows rows(all_bodies, body);
    const LanePair p = rows.two(0), q = rows.two(2), r = rows.two(4);
    v = {p.first, p.second, q.first};
    omega = {q.second, r.first, r.second};
  }
  /// @param first_moved  bodies below are not written
  CAROM_SHORT_PART void store(BodyVelocity* all_bodies, std::uint32_t first_moved, const std::uint32_t* body) const {
    const LaneRows p(v.x, v.y), q(v.z, omega.x), r(omega.y, omega.z);
    for (int i = 0; i < kLanes; ++i) {
      if (body[i] < first_moved) continue;
      double* const to = reinterpret_cast<double*>(all_bodies + body[i]);
      p.put(i, to), q.put(i, to + 2), r.put(i, to + 4);
    }
  }
};

}  // namespace
}  // namespace carom::dynamics
