// Friction of contacts in lanes. Part of contact_sweeps.h; all that stands here is local to the file that includes it.
//
// A patch that slides and spins bears a force f in its plane and a twist w about the middle of its load. Coulomb's law
// at every place of it bounds both together [Goyal1991]:
//
//     x^2 + y^2 + c x^2 y^2 <= 1,    x = |f| / (mu N),    y = w / (mu M),
//
// N the load and M its moment, the load times its mean distance from the middle. Velocities are normal to the bound:
// v : omega = x (1 + c y^2) / N : y (1 + c x^2) / M. With c = 0 (an ellipsoid) a disc of even pressure that spins fast
// is stopped in half the way; c of 0.5 is exact for it where it hardly slides, 0.8 where it hardly spins; see kPatchBend.
#pragma once

#include "dynamics/solver/both_sides.h"
#include "dynamics/solver/contact_kernels.h"
#include "dynamics/solver/sweep_constants.h"

namespace carom::dynamics {
namespace {

template <class Number>
struct Slip {
  LanesOf<Number> t, s, w;  // m/s along the tangents, rad/s

  CAROM_LANES_INLINE Slip(const Both<Number>& both, const LaneVecOf<Number>& tangent_s,
                          const DriveLanesOf<Number>* drives) {
    const PairLanesOf<Number>& pair = both.pair;
    const LaneVecOf<Number> u = both.relative(pair.r_a, pair.r_b);
    t = dot(u, pair.t), s = dot(u, tangent_s), w = dot(both.spin(), pair.n);
    if (!pair.driven) return;
    const DriveLanesOf<Number>& drive = drives[pair.driven - 1];
    t += drive.t, s += drive.s, w += drive.w;
  }
};

/// How far a force and a twist are beyond the bound: what they are divided by to lie on it, squared; 1 within.
template <class Lanes>
CAROM_LANES_INLINE Lanes beyond2(Lanes x2, Lanes y2, Lanes one, Lanes bend) {
  const Lanes sum = x2 + y2, both = bend * (x2 * y2);
  return sum + both > one ? (sum + square_root(sum * sum + 4 * both)) / 2 : one;
}

/// One point: a force alone, within the disc.
template <class Number>
CAROM_LANES_INLINE void rub_point(Both<Number>& both, PairLanesOf<Number>& pair, const PointLanesOf<Number>& point,
                                  const DriveLanesOf<Number>* drives) {
  using Lanes = LanesOf<Number>;
  const LaneVecOf<Number> s = cross(pair.n, pair.t);
  const Slip<Number> u(both, s, drives);
  const Lanes most = pair.friction * point.p_n, most2 = most * most;
  Lanes p_t = pair.p_t - (pair.m_tt * u.t + pair.m_ts * u.s), p_s = pair.p_s - (pair.m_ts * u.t + pair.m_ss * u.s);
  const auto sticks = p_t * p_t + p_s * p_s <= most2;
  const Lanes back = inverse_or_zero(pair.k_slide);  // the same both ways: friction is against the slip
  p_t = sticks ? p_t : pair.p_t - back * u.t;
  p_s = sticks ? p_s : pair.p_s - back * u.s;
  const Lanes size2 = p_t * p_t + p_s * p_s;
  const auto outside = size2 > most2;
  const Lanes shorten = outside ? most / square_root(outside ? size2 : all<Number>(1)) : all<Number>(1);
  p_t = shorten * p_t;
  p_s = shorten * p_s;
  both.push(pair.r_a, pair.r_b, (p_t - pair.p_t) * pair.t + (p_s - pair.p_s) * s);
  pair.p_t = p_t;
  pair.p_s = p_s;
}

template <class Mask>
CAROM_LANES_INLINE bool in_all(const Mask& mask) {
  return (mask[0] != 0) & (mask[1] != 0) & (mask[2] != 0) & (mask[3] != 0);
}

/// Force and twist of a patch.
template <class Number>
struct Rub {
  using Lanes = LanesOf<Number>;
  Lanes t, s, w;  // N s, N m s

  /// Shortened to the bound.   @param most, most_w  mu N, mu M   @param per2, per_w2  one over their squares
  CAROM_LANES_INLINE void bound(Lanes most, Lanes most_w, Lanes per2, Lanes per_w2) {
    const Lanes one = all<Number>(1), none = all<Number>(0);
    const Lanes beyond = beyond2((t * t + s * s) * per2, w * w * per_w2, one, all<Number>(kPatchBend.value));
    const Lanes shorten = one / square_root(beyond);
    t = most > none ? shorten * t : none;
    s = most > none ? shorten * s : none;
    w = most_w > none ? shorten * w : none;
  }
};

/// Coulomb's law of a patch: what stops slip and spin, if it can be borne. Else the twist as far as it can be, with it
/// the force that stops the slip, both shortened to the bound; and on from there against slip and spin that are left,
/// along the normal of the bound, by a step that no response outdoes: so what slips fast is rubbed against its motion.
template <int kCount, class Number>
CAROM_LANES_INLINE void rub(Both<Number>& both, PairLanesOf<Number>& pair, const PointLanesOf<Number>* points,
                            const DriveLanesOf<Number>* drives) {
  if constexpr (kCount == 1) {
    rub_point(both, pair, points[0], drives);
  } else {
    using Lanes = LanesOf<Number>;
    const Lanes none = all<Number>(0), bend = all<Number>(kPatchBend.value);
    Lanes load = points[0].p_n, moment = points[0].reach * points[0].p_n;
    for (int k = 1; k < kCount; ++k) {
      load += points[k].p_n;
      moment += points[k].reach * points[k].p_n;
    }
    const Lanes most = pair.friction * load, most_w = pair.friction * moment;
    const LaneVecOf<Number> s = cross(pair.n, pair.t);
    const Slip<Number> u(both, s, drives);
    const Lanes stops = pair.p_w - (pair.m_tw * u.t + pair.m_sw * u.s + pair.m_w * u.w);
    Rub<Number> p;
    p.w = larger(smaller(stops, most_w), -most_w);
    const Lanes u_w = u.w + (stops - p.w) * pair.per_m_w;  // as much spin as this twist would stop
    p.t = pair.p_t - (pair.m_tt * u.t + pair.m_ts * u.s + pair.m_tw * u_w);
    p.s = pair.p_s - (pair.m_ts * u.t + pair.m_ss * u.s + pair.m_sw * u_w);
    const Lanes force2 = p.t * p.t + p.s * p.s, twist2 = p.w * p.w, most2 = most * most, most_w2 = most_w * most_w;
    const auto bears = (force2 * most_w2 + twist2 * (most2 + bend * force2) < most2 * most_w2) |
                       ((force2 <= none) & (twist2 <= none));
    if (!in_all(bears)) {
      const Rub<Number> stuck = p;
      const Lanes per = inverse_or_zero(most), per_w = inverse_or_zero(most_w);
      const Lanes per2 = per * per, per_w2 = per_w * per_w;
      p.bound(most, most_w, per2, per_w2);
      const Lanes d_t = p.t - pair.p_t, d_s = p.s - pair.p_s, d_w = p.w - pair.p_w;
      const Lanes v_t = u.t + (pair.k_tt * d_t + pair.k_ts * d_s + pair.k_tw * d_w),
                  v_s = u.s + (pair.k_ts * d_t + pair.k_ss * d_s + pair.k_sw * d_w),
                  v_w = u.w + (pair.k_tw * d_t + pair.k_sw * d_s + pair.k_w * d_w);
      const Lanes share = most2 + bend * (pair.p_t * pair.p_t + pair.p_s * pair.p_s),
                  share_w = most_w2 + bend * (pair.p_w * pair.p_w);
      const Lanes back = inverse_or_zero(larger(share * pair.k_slide, share_w * pair.k_w));
      p.t -= pair.k_slide > none ? back * share * v_t : none;
      p.s -= pair.k_slide > none ? back * share * v_s : none;
      p.w -= pair.k_w > none ? back * share_w * v_w : none;
      p.bound(most, most_w, per2, per_w2);
      p.t = bears ? stuck.t : p.t;
      p.s = bears ? stuck.s : p.s;
      p.w = bears ? stuck.w : p.w;
    }
    const LaneVecOf<Number> push = (p.t - pair.p_t) * pair.t + (p.s - pair.p_s) * s,
                            twist = (p.w - pair.p_w) * pair.n;
    both.apply(push, cross(pair.r_a, push) + twist, cross(pair.r_b, push) + twist);
    pair.p_t = p.t;
    pair.p_s = p.s;
    pair.p_w = p.w;
  }
}

}  // namespace
}  // namespace carom::dynamics
