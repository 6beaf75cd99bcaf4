// What floats can bear of rows in lanes. Part of contact_sweeps.h; all that stands here is local to the file that
// includes it. @see float_range.h
#pragma once

#include "dynamics/solver/contact_lanes.h"

namespace carom::dynamics {
namespace {

/// Doubles bear anything.
template <class Number>
struct Bearable {
  CAROM_LANES_INLINE void look_at(const PairLanesOf<Number>&, const PointLanesOf<Number>*) {}
  CAROM_LANES_INLINE void responses(const PairLanesOf<Number>&, LanesOf<Number>, LanesOf<Number>, LanesOf<Number>) {}
  CAROM_LANES_INLINE bool all() const { return true; }
};

template <>
struct Bearable<float> {
  using Lanes = LanesOf<float>;
  static constexpr float kFar = 1e4f;  // m
  static constexpr float kMostFriction = 1e6f;
  static constexpr float kMostResponse = 1e4f;  // of a push at a point, times that of one at the centres of mass
  static constexpr float kSlender = 1e-5f;      // least response to a twist, of the largest about any axis

  decltype(Lanes{} < Lanes{}) fine = Lanes{} <= Lanes{};

  CAROM_LANES_INLINE void look_at(const PairLanesOf<float>& pair, const PointLanesOf<float>* points) {
    fine &= (dot(pair.r_a, pair.r_a) <= kFar * kFar) & (dot(pair.r_b, pair.r_b) <= kFar * kFar);
    fine &= (pair.radius_a <= kFar) & (pair.radius_b <= kFar) & (pair.friction <= kMostFriction);
    for (std::uint32_t k = 0; k < pair.points; ++k)
      fine &= (points[k].reach <= kFar) & (points[k].gap <= kFar) & (points[k].gap >= -kFar);
  }
  /// What makes the masses: differences of numbers that are too unlike are nothing but rounding.
  /// @param linear  1/kg   @param plane  1/kg, of both tangents together   @param twist  1/(kg m^2)
  CAROM_LANES_INLINE void responses(const PairLanesOf<float>& pair, Lanes linear, Lanes plane, Lanes twist) {
    fine &= plane <= kMostResponse * linear;
    if (pair.points == 1) return;
    const LaneSymmetricOf<float>&a = pair.inv_inertia_a, &b = pair.inv_inertia_b;
    fine &= twist >= kSlender * ((a.xx + a.yy + a.zz) + (b.xx + b.yy + b.zz));
  }
  CAROM_LANES_INLINE bool all() const {
    bool yes = true;
    for (int i = 0; i < kLanes; ++i) yes &= fine[i] != 0;
    return yes;
  }
};

}  // namespace
}  // namespace carom::dynamics
