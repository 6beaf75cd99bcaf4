// Masses of contacts in lanes: what a kernel multiplies velocities by. Part of contact_sweeps.h; all that stands here
// is local to the file that includes it.
#pragma once

#include "dynamics/solver/contact_kernels.h"
#include "dynamics/solver/float_limits.h"
#include "dynamics/solver/lane_sides.h"

namespace carom::dynamics {
namespace {

template <class Number>
CAROM_LANES_INLINE LaneVecOf<Number> normal_of(const PairLanesOf<Number>& pair, const PointLanesOf<Number>& p) {
  return pair.one_normal ? pair.n : p.n;
}

/// Where the coupling of two points stands.
constexpr int coupling_of(int k, int l) { return k < l ? l * (l - 1) / 2 + k : k * (k - 1) / 2 + l; }

/// Of a symmetric response in the plane, the most that it gives in any direction.
template <class Lanes>
CAROM_LANES_INLINE Lanes most_response(Lanes tt, Lanes ts, Lanes ss) {
  const Lanes half = (tt - ss) / 2;
  return (tt + ss) / 2 + square_root(half * half + ts * ts);
}

/// Masses where bodies are locked. What nothing can move has none: along a direction whose response is but rounding of
/// what it would be without locks nothing is asked for, and in a plane that gives way in one direction alone only that
/// one counts.
template <class Number>
void prepare_locked(const LaneRunOf<Number>& run, PairLanesOf<Number>& pair) {
  using Lanes = LanesOf<Number>;
  using LaneVec = LaneVecOf<Number>;
  constexpr Number kRounding = sizeof(Number) == sizeof(double) ? Number(1e-9) : Number(1e-5);
  const LockLanesOf<Number>& locks = run.locks[pair.locked - 1];
  const LaneVec mass = pair.inv_mass_a * locks.free_a + pair.inv_mass_b * locks.free_b;
  const Lanes whole = kRounding * (pair.inv_mass_a + pair.inv_mass_b);
  const auto response = [&](const LaneVec& d, const LaneVec& x, const LaneVec& e, const LaneVec& y)
      __attribute__((always_inline)) {
    const LaneVec r_a = pair.r_a + d, r_b = pair.r_b + d, q_a = pair.r_a + e, q_b = pair.r_b + e;
    return dot(x, each(mass, y)) + dot(cross(r_a, x), pair.inv_inertia_a * cross(q_a, y)) +
           dot(cross(r_b, x), pair.inv_inertia_b * cross(q_b, y));
  };
  const LaneVec middle = {all<Number>(0), all<Number>(0), all<Number>(0)}, s = cross(pair.n, pair.t);
  const Lanes k_tt = response(middle, pair.t, middle, pair.t), k_ts = response(middle, pair.t, middle, s),
              k_ss = response(middle, s, middle, s);
  const Lanes trace = k_tt + k_ss, det = k_tt * k_ss - k_ts * k_ts;
  const auto full = det > kRounding * (trace * trace), some = trace > whole;
  const Lanes of_both = full ? inverse_or_zero(det) : all<Number>(0);
  const Lanes once = inverse_or_zero(trace), of_one = full ? all<Number>(0) : some ? once * once : all<Number>(0);
  pair.m_tt = of_both * k_ss + of_one * k_tt;
  pair.m_ts = of_one * k_ts - of_both * k_ts;
  pair.m_ss = of_both * k_tt + of_one * k_ss;
  if (pair.slides) pair.k_slide = some ? most_response(k_tt, k_ts, k_ss) : all<Number>(0);
  const LaneSymmetricOf<Number>&i_a = pair.inv_inertia_a, &i_b = pair.inv_inertia_b;
  const Lanes k_w = dot(pair.n, i_a * pair.n) + dot(pair.n, i_b * pair.n);
  const Lanes turns = kRounding * ((i_a.xx + i_a.yy + i_a.zz) + (i_b.xx + i_b.yy + i_b.zz));
  pair.m_w = k_w > turns ? inverse_or_zero(k_w) : all<Number>(0);
  PointLanesOf<Number>* const points = run.points + pair.first;
  const int count = static_cast<int>(pair.points);
  for (int k = 0; k < count; ++k) {
    const LaneVec n_k = normal_of(pair, points[k]);
    for (int l = 0; l < k; ++l)
      pair.coupling[coupling_of(k, l)] = response(points[k].d, n_k, points[l].d, normal_of(pair, points[l]));
    const Lanes k_n = response(points[k].d, n_k, points[k].d, n_k);
    points[k].m_n = k_n > whole ? inverse_or_zero(k_n) : all<Number>(0);
    points[k].p_n = k_n > whole ? points[k].p_n : all<Number>(0);
  }
}

template <class Number>
bool prepare(const LaneRunOf<Number>& run) {
  using Lanes = LanesOf<Number>;
  using LaneVec = LaneVecOf<Number>;
  Bearable<Number> bearable;
  for (std::size_t i = 0; i < run.count; ++i) {
    PairLanesOf<Number>& pair = run.pairs[i];
    bearable.look_at(pair, run.points + pair.first);
    if (pair.locked) {
      prepare_locked(run, pair);
      continue;
    }
    const LaneSymmetricOf<Number>&inertia_a = pair.inv_inertia_a, &inertia_b = pair.inv_inertia_b;
    const Lanes linear = pair.inv_mass_a + pair.inv_mass_b;
    const LaneVec s = cross(pair.n, pair.t);
    const LaneVec t_a = cross(pair.r_a, pair.t), t_b = cross(pair.r_b, pair.t), s_a = cross(pair.r_a, s),
                  s_b = cross(pair.r_b, s), it_a = inertia_a * t_a, it_b = inertia_b * t_b;
    const Lanes k_tt = linear + dot(t_a, it_a) + dot(t_b, it_b), k_ts = dot(s_a, it_a) + dot(s_b, it_b),
                k_ss = linear + dot(s_a, inertia_a * s_a) + dot(s_b, inertia_b * s_b);
    const Lanes k_w = dot(pair.n, inertia_a * pair.n) + dot(pair.n, inertia_b * pair.n);
    bearable.responses(pair, linear, k_tt + k_ss, k_w);
    const Lanes inverse = inverse_or_zero(k_tt * k_ss - k_ts * k_ts);
    pair.m_tt = inverse * k_ss;
    pair.m_ts = -inverse * k_ts;
    pair.m_ss = inverse * k_tt;
    pair.m_w = inverse_or_zero(k_w);
    if (pair.slides) pair.k_slide = most_response(k_tt, k_ts, k_ss);
    PointLanesOf<Number>* const points = run.points + pair.first;
    const int count = static_cast<int>(pair.points);
    for (int k = 0; k < count; ++k) {
      const LaneVec n_k = normal_of(pair, points[k]);
      const LaneVec n_a = inertia_a * cross(pair.r_a + points[k].d, n_k),
                    n_b = inertia_b * cross(pair.r_b + points[k].d, n_k);
      for (int l = 0; l <= k; ++l) {
        const LaneVec n_l = normal_of(pair, points[l]);
        const Lanes coupling = linear * dot(n_k, n_l) + dot(n_a, cross(pair.r_a + points[l].d, n_l)) +
                               dot(n_b, cross(pair.r_b + points[l].d, n_l));
        if (l < k)
          pair.coupling[coupling_of(k, l)] = coupling;
        else
          points[k].m_n = inverse_or_zero(coupling);
      }
    }
  }
  return bearable.all();
}

}  // namespace
}  // namespace carom::dynamics
