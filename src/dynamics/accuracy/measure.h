// How far two ends of a step are apart, over what is borne.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/pose.h"
#include "dynamics/accuracy/control.h"

namespace carom::dynamics::accuracy {

/// What is borne in a step: of places and turns, and of velocities, which go on for accuracy_horizon.
struct Borne {
  Real inv_place = 0, inv_turn = 0;  // 1/m, 1/rad; 0: not asked for
  int most = 2;                      // substeps
  Real work = 0;                     // contact points times substeps
  int least_soft = 1;                // where contacts are springs: of fewer they would be softer ones
  Borne(const Dials& dials, Real dt)
      : most(std::max(2, dials.whole(Dial::accuracy_substeps))), work(dials[Dial::accuracy_work]) {
    least_soft = static_cast<int>(std::min(std::ceil(4 * dials[Dial::contact_frequency] * dt), Real(most)));
    if (dials[Dial::accuracy_place] > 0) inv_place = 1 / (dials[Dial::accuracy_place] * dt);
    if (dials[Dial::accuracy_turn] > 0) inv_turn = 1 / (dials[Dial::accuracy_turn] * dt);
  }
  /// Substeps at most of an island with so many contact points.   @param as_ever  those without an accuracy
  int most_of(std::uint32_t points, int as_ever) const {
    if (points == 0 || Real(most) * points <= work) return most;
    return std::min(most, std::max({2, as_ever, static_cast<int>(work / points)}));
  }
};

struct BodyEnd {
  Vec3 x, v, omega;  // m, m/s, rad/s
  Quat q;
};

inline bool is_finite(const BodyEnd& e) {
  return e.x.all_finite() && e.v.all_finite() && e.omega.all_finite() && finite(e.q.squared_norm());
}

/// kg m^2/s, world.
inline Vec3 momentum_of(const BodyEnd& e, const Mat3& inertia) { return e.q * (inertia * (e.q.conjugate() * e.omega)); }

/// Adds a body to an island's. A turn goes on by its momentum: an omega that belongs to another facing is no error of
/// it.
/// @param inertia, inv_inertia  body axes; 0 of what does not turn   @param horizon  s, for which velocities go on
inline void add_apart(Shares& to, const BodyEnd& one, const BodyEnd& other, const Mat3& inertia,
                      const Mat3& inv_inertia, Real horizon, const Borne& borne) {
  const Quat turn = one.q * other.q.conjugate();
  const Real angle = 2 * Vec3(turn.x(), turn.y(), turn.z()).norm();
  const Real place = std::max((one.x - other.x).norm(), horizon * (one.v - other.v).norm());
  const Vec3 gained = one.q.conjugate() * (momentum_of(one, inertia) - momentum_of(other, inertia));
  const Real turned = std::max(angle, horizon * (inv_inertia * gained).norm());
  to.place = std::max(to.place, place * borne.inv_place);
  to.turn = std::max(to.turn, turned * borne.inv_turn);
}

}  // namespace carom::dynamics::accuracy
