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

/// Force and twist of a patch.
template <class Number>
struct Rub {
  using Lanes = LanesOf<Number>;
  Lanes t, s, w;  // N s, N m s

  /// Shortened to the bound.   @param most, most_w  mu N, mu M
  CAROM_LANES_INLINE void bound(Lanes most, Lanes most_w) {
    const Lanes one = all<Number>(1), none = all<Number>(0), per = inverse_or_zero(most), per_w = inverse_or_zero(most_w);
    const Lanes x_t = per * t, x_s = per * s, y = per_w * w;
    const Lanes beyond = beyond2(x_t * x_t + x_s * x_s, y * y, one, all<Number>(kPatchBend.value));
    const Lanes shorten = one / square_root(beyond);
    t = most > none ? shorten * t : none;
    s = most > none ? shorten * s : none;
    w = most_w > none ? shorten * w : none;
  }
};

/// Coulomb's law of a patch that slides: what stops first spin, as far as that can be borne alone, then slip, if both can
/// be borne together. Else both shortened to the bound; and on from there against slip and spin that are left, along the
/// normal of the bound, by a step that no response outdoes: so what slides fast is rubbed against its motion.
template <class Number>
CAROM_LANES_INLINE Rub<Number> rub_sliding(const Both<Number>& both, const LaneVecOf<Number>& tangent_s,
                                           LanesOf<Number> most, LanesOf<Number> most_w,
                                           const DriveLanesOf<Number>* drives) {
  using Lanes = LanesOf<Number>;
  const PairLanesOf<Number>& pair = both.pair;
  const Lanes none = all<Number>(0), bend = all<Number>(kPatchBend.value);
  Rub<Number> stops;
  const Lanes spin = Slip<Number>(both, tangent_s, drives).w;
  stops.w = pair.m_w > none ? larger(smaller(pair.p_w - pair.m_w * spin, most_w), -most_w) : none;
  Both<Number> tried = both;
  tried.twist((stops.w - pair.p_w) * pair.n);
  const Slip<Number> u(tried, tangent_s, drives);
  stops.t = pair.p_t - (pair.m_tt * u.t + pair.m_ts * u.s);
  stops.s = pair.p_s - (pair.m_ts * u.t + pair.m_ss * u.s);
  Rub<Number> p = stops;
  p.bound(most, most_w);
  const auto bears = (p.t == stops.t) & (p.s == stops.s) & (p.w == stops.w);
  tried.twist((p.w - stops.w) * pair.n);
  tried.push(pair.r_a, pair.r_b, (p.t - pair.p_t) * pair.t + (p.s - pair.p_s) * tangent_s);
  const Slip<Number> left(tried, tangent_s, drives);
  // The normal where it was, which is nearer to where it slides than what would stop it.
  const Lanes share = most * most + bend * (pair.p_t * pair.p_t + pair.p_s * pair.p_s),
              share_w = most_w * most_w + bend * (pair.p_w * pair.p_w);
  const Lanes back = inverse_or_zero(larger(share * pair.k_slide, share_w * inverse_or_zero(pair.m_w)));
  p.t -= pair.k_slide > none ? back * share * left.t : none;
  p.s -= pair.k_slide > none ? back * share * left.s : none;
  p.w -= pair.m_w > none ? back * share_w * left.w : none;
  p.bound(most, most_w);
  return {bears ? stops.t : p.t, bears ? stops.s : p.s, bears ? stops.w : p.w};
}

/// Coulomb's law of a pair. Of what sticks: the impulses that stop twist and slip, shortened each to what the normal
/// impulses allow. Of what slides: rub_sliding(). Four that stick do not look at the other; what sticks beside
/// what slides is answered by the same arithmetic.
template <int kCount, class Number>
CAROM_LANES_INLINE void rub(Both<Number>& both, PairLanesOf<Number>& pair, const PointLanesOf<Number>* points,
                            const DriveLanesOf<Number>* drives) {
  using Lanes = LanesOf<Number>;
  const LaneVecOf<Number> s = cross(pair.n, pair.t);
  Lanes load = points[0].p_n, moment = points[0].reach * points[0].p_n;
  for (int k = 1; k < kCount; ++k) {
    load += points[k].p_n;
    moment += points[k].reach * points[k].p_n;
  }
  const Lanes most = pair.friction * load, most_w = pair.friction * moment;
  const auto slide = pair.slide > all<Number>(0);
  Rub<Number> sliding = {};
  if (kCount > 1 && pair.slides) sliding = rub_sliding(both, s, most, most_w, drives);
  if constexpr (kCount > 1) {  // one point has no reach, and bears no twist
    Lanes spin = dot(both.spin(), pair.n);
    if (pair.driven) spin += drives[pair.driven - 1].w;
    Lanes p_w = larger(smaller(pair.p_w - pair.m_w * spin, most_w), -most_w);
    if (pair.slides) p_w = slide ? sliding.w : p_w;
    both.twist((p_w - pair.p_w) * pair.n);
    pair.p_w = p_w;
  }
  const Slip<Number> u(both, s, drives);
  Lanes p_t = pair.p_t - (pair.m_tt * u.t + pair.m_ts * u.s), p_s = pair.p_s - (pair.m_ts * u.t + pair.m_ss * u.s);
  const Lanes size2 = p_t * p_t + p_s * p_s;
  const auto outside = size2 > most * most;
  const Lanes shorten = outside ? most / square_root(outside ? size2 : all<Number>(1)) : all<Number>(1);
  p_t = shorten * p_t;
  p_s = shorten * p_s;
  if (kCount > 1 && pair.slides) p_t = slide ? sliding.t : p_t, p_s = slide ? sliding.s : p_s;
  both.push(pair.r_a, pair.r_b, (p_t - pair.p_t) * pair.t + (p_s - pair.p_s) * s);
  pair.p_t = p_t;
  pair.p_s = p_s;
}

}  // namespace
}  // namespace carom::dynamics
