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

/// Coulomb's law of a patch: what stops slip and spin, if it can be borne; else as much as can be, against both.
template <int kCount, class Number>
CAROM_LANES_INLINE void rub(Both<Number>& both, PairLanesOf<Number>& pair, const PointLanesOf<Number>* points,
                            const DriveLanesOf<Number>* drives) {
  if constexpr (kCount == 1) {
    rub_point(both, pair, points[0], drives);
  } else {
    using Lanes = LanesOf<Number>;
    const Lanes one = all<Number>(1), none = all<Number>(0), bend = all<Number>(kPatchBend.value);
    Lanes load = points[0].p_n, moment = points[0].reach * points[0].p_n;
    for (int k = 1; k < kCount; ++k) {
      load += points[k].p_n;
      moment += points[k].reach * points[k].p_n;
    }
    const Lanes most = pair.friction * load, most_w = pair.friction * moment;
    const Lanes per = inverse_or_zero(most), per_w = inverse_or_zero(most_w), per2 = per * per, per_w2 = per_w * per_w;
    const LaneVecOf<Number> s = cross(pair.n, pair.t);
    const Slip<Number> u(both, s, drives);
    Lanes p_t = pair.p_t - (pair.m_tt * u.t + pair.m_ts * u.s + pair.m_tw * u.w),
          p_s = pair.p_s - (pair.m_ts * u.t + pair.m_ss * u.s + pair.m_sw * u.w),
          p_w = pair.p_w - (pair.m_tw * u.t + pair.m_sw * u.s + pair.m_w * u.w);
    Lanes x2 = (p_t * p_t + p_s * p_s) * per2, y2 = p_w * p_w * per_w2;
    const auto sticks = (x2 + y2 + bend * (x2 * y2) <= one) & (most_w > none);
    // What slips goes on along the normal of the bound at what it bears, by a step that no response outdoes.
    const Lanes share = most * most + bend * (pair.p_t * pair.p_t + pair.p_s * pair.p_s),
                share_w = most_w * most_w + bend * (pair.p_w * pair.p_w);
    const Lanes back = inverse_or_zero(share * pair.k_slide + share_w * pair.k_spin);
    const Lanes by = pair.k_slide > none ? back * share : none, by_w = pair.k_spin > none ? back * share_w : none;
    p_t = sticks ? p_t : pair.p_t - by * u.t;
    p_s = sticks ? p_s : pair.p_s - by * u.s;
    p_w = sticks ? p_w : pair.p_w - by_w * u.w;
    x2 = (p_t * p_t + p_s * p_s) * per2, y2 = p_w * p_w * per_w2;
    const Lanes shorten = one / square_root(beyond2(x2, y2, one, bend));
    p_t = most > none ? shorten * p_t : none;
    p_s = most > none ? shorten * p_s : none;
    p_w = most_w > none ? shorten * p_w : none;
    const LaneVecOf<Number> push = (p_t - pair.p_t) * pair.t + (p_s - pair.p_s) * s,
                            twist = (p_w - pair.p_w) * pair.n;
    both.apply(push, cross(pair.r_a, push) + twist, cross(pair.r_b, push) + twist);
    pair.p_t = p_t;
    pair.p_s = p_s;
    pair.p_w = p_w;
  }
}

}  // namespace
}  // namespace carom::dynamics
