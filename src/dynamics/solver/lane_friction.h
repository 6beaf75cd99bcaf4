// Friction of contacts in lanes. Part of contact_sweeps.h; all that stands here is local to the file that includes it.
//
// A patch that slides and spins bears a force f in its plane and a twist w about the middle of its load. Coulomb's law
// at every place of it bounds both together [Goyal1991]:
//
//     x^2 + y^2 + c x^2 y^2 <= 1,    x = |f| / (mu N),    y = w / (mu M),
//
// N the load and M its moment, the load times its mean distance from the middle. Velocities are normal to the bound:
// v : omega = x (1 + c y^2) / N : y (1 + c x^2) / M. With c = 0 (an ellipsoid) a disc of even pressure that spins fast
// is stopped in half the way; c of 0.5 is exact for it where it hardly slides, 0.8 where it hardly spins; see
// kPatchBend.
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

/// Force and twist of a patch.
template <class Number>
struct FrictionImpulse {
  using Lanes = LanesOf<Number>;
  Lanes t, s, w;  // N s, N m s
};

/// The bound on what a patch bears.
template <class Number>
struct Bound {
  using Lanes = LanesOf<Number>;
  Lanes most, most_w;  // mu N, mu M: N s, N m s

  /// How far beyond it something is, squared: what its parts are divided by, squared, to lie on the bound; below 1
  /// within.
  CAROM_LANES_INLINE Lanes beyond2(const FrictionImpulse<Number>& p) const {
    const Lanes per = inverse_or_zero(most), per_w = inverse_or_zero(most_w);
    const Lanes x_t = per * p.t, x_s = per * p.s, y = per_w * p.w, x2 = x_t * x_t + x_s * x_s, y2 = y * y;
    const Lanes sum = x2 + y2, both = all<Number>(kPatchBend.value) * (x2 * y2);
    return (sum + square_root(sum * sum + 4 * both)) / 2;
  }
  /// Shortened to it, by what beyond2() says.
  CAROM_LANES_INLINE FrictionImpulse<Number> bounded(const FrictionImpulse<Number>& p, Lanes beyond2) const {
    const Lanes one = all<Number>(1), none = all<Number>(0);
    const Lanes shorten = one / square_root(larger(beyond2, one));
    return {most > none ? shorten * p.t : none, most > none ? shorten * p.s : none,
            most_w > none ? shorten * p.w : none};
  }
  CAROM_LANES_INLINE FrictionImpulse<Number> bounded(const FrictionImpulse<Number>& p) const {
    return bounded(p, beyond2(p));
  }
};

/// What a patch bears next, from what it bore: impulses on both bodies.
template <class Number>
CAROM_LANES_INLINE void change(Both<Number>& both, const LaneVecOf<Number>& tangent_s,
                               const FrictionImpulse<Number>& from, const FrictionImpulse<Number>& to) {
  const PairLanesOf<Number>& pair = both.pair;
  const LaneVecOf<Number> p = (to.t - from.t) * pair.t + (to.s - from.s) * tangent_s, w = (to.w - from.w) * pair.n;
  both.apply(p, cross(pair.r_a, p) + w, cross(pair.r_b, p) + w);
}

/// From a force and a twist on the bound: on against slip and spin that are left, along the normal of the bound, by a
/// step that no response outdoes, so that what slides fast is rubbed against its motion.   @param left  of bodies that
/// bear p
template <class Number>
CAROM_LANES_INLINE FrictionImpulse<Number> against(const PairLanesOf<Number>& pair, const Bound<Number>& bound,
                                                   const FrictionImpulse<Number>& p, const Slip<Number>& left) {
  using Lanes = LanesOf<Number>;
  const Lanes none = all<Number>(0), bend = all<Number>(kPatchBend.value);
  // The normal where it was, which is nearer to where it slides than what would stop it.
  const Lanes share = bound.most * bound.most + bend * (pair.p_t * pair.p_t + pair.p_s * pair.p_s),
              share_w = bound.most_w * bound.most_w + bend * (pair.p_w * pair.p_w);
  const Lanes back = inverse_or_zero(larger(share * pair.k_slide, share_w * inverse_or_zero(pair.m_w)));
  const auto some = back > none;  // else squares of impulses are beyond all numbers
  const Lanes give = (some & (pair.k_slide > none)) ? back * share : none,
              give_w = (some & (pair.m_w > none)) ? back * share_w : none;
  return bound.bounded({p.t - give * left.t, p.s - give * left.s, p.w - give_w * left.w});
}

/// Coulomb's law of a pair: the impulses that stop first twist, then slip, shortened each to what the normal impulses
/// allow. What slides and can't bear both together has them shortened to the bound on both, and goes on from there.
/// Four that stick do not look at it, and what sticks beside what slides keeps its bits.
template <int kCount, class Number>
CAROM_SHARED_PART void solve_friction(Both<Number>& both, PairLanesOf<Number>& pair, const PointLanesOf<Number>* points,
                                      const DriveLanesOf<Number>* drives) {
  using Lanes = LanesOf<Number>;
  const Lanes one = all<Number>(1), none = all<Number>(0);
  const LaneVecOf<Number> s = cross(pair.n, pair.t);
  const int count = points_of<kCount>(pair);
  Lanes load = points[0].p_n, moment = points[0].reach * points[0].p_n;
  for (int k = 1; k < count; ++k) {
    load += points[k].p_n;
    moment += points[k].reach * points[k].p_n;
  }
  const Bound<Number> bound = {pair.friction * load, pair.friction * moment};
  FrictionImpulse<Number> stops = {none, none, none};
  if (count > 1) {  // one point has no reach, and bears no twist
    Lanes spin = dot(both.spin(), pair.n);
    if (pair.driven) spin += drives[pair.driven - 1].w;
    stops.w = larger(smaller(pair.p_w - pair.m_w * spin, bound.most_w), -bound.most_w);
    both.twist((stops.w - pair.p_w) * pair.n);
  }
  const Slip<Number> u(both, s, drives);
  stops.t = pair.p_t - (pair.m_tt * u.t + pair.m_ts * u.s);
  stops.s = pair.p_s - (pair.m_ts * u.t + pair.m_ss * u.s);
  const Lanes size2 = stops.t * stops.t + stops.s * stops.s;
  const auto outside = size2 > bound.most * bound.most;
  const Lanes shorten = outside ? bound.most / square_root(outside ? size2 : one) : one;
  FrictionImpulse<Number> p = {shorten * stops.t, shorten * stops.s, stops.w};
  const FrictionImpulse<Number> borne = {pair.p_t, pair.p_s, stops.w};
  if (count > 1 && pair.slides) {
    stops.w = pair.m_w > none ? stops.w : none;  // what can't turn leaves its force the whole bound
    const Lanes beyond2 = bound.beyond2(stops), slide = beyond2 > one ? pair.slide : none;
    if (some_slide(slide)) {
      const auto slides = slide > none;
      const auto where = [&](const FrictionImpulse<Number>& sliding) __attribute__((always_inline)) {
        return FrictionImpulse<Number>{slides ? sliding.t : p.t, slides ? sliding.s : p.s, slides ? sliding.w : p.w};
      };
      const FrictionImpulse<Number> first = where(bound.bounded(stops, beyond2));
      change(both, s, borne, first);
      p = where(against(pair, bound, first, Slip<Number>(both, s, drives)));
      change(both, s, first, p);
      pair.p_t = p.t, pair.p_s = p.s, pair.p_w = p.w;
      return;
    }
  }
  both.push(pair.r_a, pair.r_b, (p.t - borne.t) * pair.t + (p.s - borne.s) * s);
  pair.p_t = p.t;
  pair.p_s = p.s;
  if (count > 1) pair.p_w = p.w;
}

}  // namespace
}  // namespace carom::dynamics
