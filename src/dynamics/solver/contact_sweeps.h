// Sweeps over contacts in lanes: the arithmetic behind ContactKernels. Included by one file for each width of
// registers, compiled for it; all that stands here is local to that file.
#pragma once

#include "dynamics/solver/contact_kernels.h"

namespace carom {
namespace {

constexpr int kInnerSweeps = 2;  // there and back

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

/// Velocities of the four bodies on one side.
struct Side {
  LaneVec v, omega;

  CAROM_LANES_INLINE void load(const BodyVelocity* all_bodies, const std::uint32_t* body) {
    const BodyRows rows(all_bodies, body);
    const LanePair p = rows.two(0), q = rows.two(2), r = rows.two(4);
    v = {p.first, p.second, q.first};
    omega = {q.second, r.first, r.second};
  }
  CAROM_LANES_INLINE void store(const LaneRun& run, const std::uint32_t* body) const {
    const LaneRows p(v.x, v.y), q(v.z, omega.x), r(omega.y, omega.z);
    for (int i = 0; i < kLanes; ++i) {
      if (body[i] < run.first_moved) continue;
      double* const to = reinterpret_cast<double*>(run.velocity + body[i]);
      p.put(i, to), q.put(i, to + 2), r.put(i, to + 4);
    }
  }
};

/// Both sides of four pairs, and what an impulse does to them.
struct Both {
  Side a, b;
  const PairLanes& pair;

  CAROM_LANES_INLINE Both(const PairLanes& p, const BodyVelocity* bodies) : pair(p) {
    a.load(bodies, p.a);
    b.load(bodies, p.b);
  }
  CAROM_LANES_INLINE void store(const LaneRun& run) const {
    a.store(run, pair.a);
    b.store(run, pair.b);
  }
  CAROM_LANES_INLINE LaneVec relative(const LaneVec& r_a, const LaneVec& r_b) const {
    return (b.v + cross(b.omega, r_b)) - (a.v + cross(a.omega, r_a));
  }
  /// @param moment_a, moment_b  N m s, of the impulse about the centres of mass
  CAROM_LANES_INLINE void apply(const LaneVec& impulse, const LaneVec& moment_a, const LaneVec& moment_b) {
    a.v = a.v - pair.inv_mass_a * impulse;
    a.omega = a.omega - pair.inv_inertia_a * moment_a;
    b.v = b.v + pair.inv_mass_b * impulse;
    b.omega = b.omega + pair.inv_inertia_b * moment_b;
  }
  CAROM_LANES_INLINE void push(const LaneVec& r_a, const LaneVec& r_b, const LaneVec& impulse) {
    apply(impulse, cross(r_a, impulse), cross(r_b, impulse));
  }
  CAROM_LANES_INLINE void twist(const LaneVec& moment) {
    a.omega = a.omega - pair.inv_inertia_a * moment;
    b.omega = b.omega + pair.inv_inertia_b * moment;
  }
};

/// Coulomb's law in the plane: the impulses that stop twist and slip, shortened to what the normal impulses allow.
CAROM_LANES_INLINE void rub(Both& both, PairLanes& pair, const PointLanes* points) {
  Lanes load = all(0), moment = all(0);
  for (std::uint32_t k = 0; k < pair.points; ++k) {
    load += points[k].p_n;
    moment += points[k].reach * points[k].p_n;
  }
  const Lanes most_w = pair.friction * moment;
  const Lanes p_w = larger(smaller(pair.p_w - pair.m_w * dot(both.b.omega - both.a.omega, pair.n), most_w), -most_w);
  both.twist((p_w - pair.p_w) * pair.n);
  pair.p_w = p_w;

  const LaneVec u = both.relative(pair.r_a, pair.r_b), s = cross(pair.n, pair.t);
  const Lanes u_t = dot(u, pair.t), u_s = dot(u, s);
  Lanes p_t = pair.p_t - (pair.m_tt * u_t + pair.m_ts * u_s), p_s = pair.p_s - (pair.m_ts * u_t + pair.m_ss * u_s);
  const Lanes most = pair.friction * load, size2 = p_t * p_t + p_s * p_s;
  const LaneMask outside = size2 > most * most;
  const Lanes shorten = outside ? most / square_root(outside ? size2 : all(1)) : all(1);
  p_t = shorten * p_t;
  p_s = shorten * p_s;
  both.push(pair.r_a, pair.r_b, (p_t - pair.p_t) * pair.t + (p_s - pair.p_s) * s);
  pair.p_t = p_t;
  pair.p_s = p_s;
}

/// The normal law at all points of four pairs together: no pull, and no closing faster than the separation allows.
/// Points of one pair depend on each other so much that one sweep over them leaves the bodies rocking; a few sweeps on
/// the numbers that couple them cost less than one on the bodies.
template <bool kPush>
CAROM_LANES_INLINE void press(Both& both, PointLanes* points, double inv_h, double push_speed) {
  const PairLanes& pair = both.pair;
  const std::uint32_t n = pair.points;
  Lanes lack[kPairPoints], mass[kPairPoints], back[kPairPoints], impulse[kPairPoints];
  for (std::uint32_t k = 0; k < n; ++k) {
    const PointLanes& p = points[k];
    const Lanes u_n = dot(both.relative(p.r_a, p.r_b), p.n), s = p.separation;
    const LaneMask open = s > 0;
    if constexpr (kPush) {
      lack[k] = u_n + (open ? s * inv_h : larger(pair.bias_rate * s, all(-push_speed)));
      mass[k] = (open ? all(1) : pair.mass_scale) * p.m_n;
      back[k] = open ? all(0) : pair.impulse_scale;
    } else {
      lack[k] = u_n + (open ? s * inv_h : all(0));
      mass[k] = p.m_n;
      back[k] = all(0);
    }
    impulse[k] = p.p_n;
  }
  const auto visit = [&](std::uint32_t k) {
    const Lanes next = larger(impulse[k] - (mass[k] * lack[k] + back[k] * impulse[k]), all(0)), d = next - impulse[k];
    impulse[k] = next;
    for (std::uint32_t l = 0; l < n; ++l) lack[l] += pair.coupling[k][l] * d;
  };
  const int sweeps = n > 1 ? kInnerSweeps : 1;
  for (int i = 0; i < sweeps; ++i) {
    for (std::uint32_t k = 0; k < n; ++k) visit(k);
    if (n > 1)
      for (std::uint32_t k = n; k-- > 0;) visit(k);
  }
  LaneVec sum = {all(0), all(0), all(0)}, turn_a = sum, turn_b = sum;
  for (std::uint32_t k = 0; k < n; ++k) {
    PointLanes& p = points[k];
    const LaneVec push = (impulse[k] - p.p_n) * p.n;
    p.p_n = impulse[k];
    p.most = larger(p.most, impulse[k]);
    sum = sum + push;
    turn_a = turn_a + cross(p.r_a, push);
    turn_b = turn_b + cross(p.r_b, push);
  }
  both.apply(sum, turn_a, turn_b);
}

/// How far the four bodies on one side have come.
struct SideShift {
  LaneVec x, u;
  Lanes w;

  CAROM_LANES_INLINE SideShift(const BodyShift* all_bodies, const std::uint32_t* body) {
    const BodyRows rows(all_bodies, body);
    const LanePair p = rows.two(0), q = rows.two(2), r = rows.two(4);
    x = {p.first, p.second, q.first};
    u = {q.second, r.first, r.second};
    w = rows.two(6).first;
  }
  /// rotated - r.
  CAROM_LANES_INLINE LaneVec turn(const LaneVec& r) const {
    const LaneVec c2 = all(2) * cross(u, r);
    return w * c2 + cross(u, c2);
  }
};

void prepare(const LaneRun& run) {
  for (std::size_t i = 0; i < run.count; ++i) {
    PairLanes& pair = run.pairs[i];
    const LaneSymmetric &inertia_a = pair.inv_inertia_a, &inertia_b = pair.inv_inertia_b;
    const Lanes linear = pair.inv_mass_a + pair.inv_mass_b;
    const LaneVec s = cross(pair.n, pair.t);
    const LaneVec t_a = cross(pair.r_a, pair.t), t_b = cross(pair.r_b, pair.t), s_a = cross(pair.r_a, s),
                  s_b = cross(pair.r_b, s), it_a = inertia_a * t_a, it_b = inertia_b * t_b;
    const Lanes k_tt = linear + dot(t_a, it_a) + dot(t_b, it_b), k_ts = dot(s_a, it_a) + dot(s_b, it_b),
                k_ss = linear + dot(s_a, inertia_a * s_a) + dot(s_b, inertia_b * s_b);
    const Lanes inverse = inverse_or_zero(k_tt * k_ss - k_ts * k_ts);
    pair.m_tt = inverse * k_ss;
    pair.m_ts = -inverse * k_ts;
    pair.m_ss = inverse * k_tt;
    pair.m_w = inverse_or_zero(dot(pair.n, inertia_a * pair.n) + dot(pair.n, inertia_b * pair.n));
    PointLanes* const points = run.points + pair.first;
    for (std::uint32_t k = 0; k < pair.points; ++k) {
      const PointLanes& p = points[k];
      const LaneVec n_a = inertia_a * cross(p.r_a, p.n), n_b = inertia_b * cross(p.r_b, p.n);
      for (std::uint32_t l = 0; l < pair.points; ++l) {
        const PointLanes& q = points[l];
        pair.coupling[k][l] = linear * dot(p.n, q.n) + dot(n_a, cross(q.r_a, q.n)) + dot(n_b, cross(q.r_b, q.n));
      }
      points[k].m_n = inverse_or_zero(pair.coupling[k][k]);
    }
  }
}

void warm_start(const LaneRun& run) {
  for (std::size_t i = 0; i < run.count; ++i) {
    const PairLanes& pair = run.pairs[i];
    Both both(pair, run.velocity);
    both.push(pair.r_a, pair.r_b, pair.p_t * pair.t + pair.p_s * cross(pair.n, pair.t));
    both.twist(pair.p_w * pair.n);
    for (std::uint32_t k = 0; k < pair.points; ++k) {
      const PointLanes& p = run.points[pair.first + k];
      both.push(p.r_a, p.r_b, p.p_n * p.n);
    }
    both.store(run);
  }
}

void solve(const LaneRun& run, double inv_h, double push_speed) {
  for (std::size_t i = 0; i < run.count; ++i) {
    PairLanes& pair = run.pairs[i];
    PointLanes* const points = run.points + pair.first;
    Both both(pair, run.velocity);
    rub(both, pair, points);
    press<true>(both, points, inv_h, push_speed);
    both.store(run);
  }
}

/// Separations at all points of four pairs, at the present poses.
CAROM_LANES_INLINE void separate(const LaneRun& run, const PairLanes& pair, PointLanes* points) {
  const SideShift a(run.shift, pair.a), b(run.shift, pair.b);
  const LaneVec moved = b.x - a.x;
  for (std::uint32_t k = 0; k < pair.points; ++k) {
    PointLanes& p = points[k];
    p.separation = p.gap + dot(moved + (b.turn(p.r_b) - a.turn(p.r_a)), p.n);
  }
}

CAROM_LANES_INLINE void add_to_sums(PairLanes& pair, PointLanes* points) {
  pair.sum_t += pair.p_t;
  pair.sum_s += pair.p_s;
  pair.sum_w += pair.p_w;
  for (std::uint32_t k = 0; k < pair.points; ++k) points[k].sum_n += points[k].p_n;
}

void relax(const LaneRun& run, double inv_h) {
  for (std::size_t i = 0; i < run.count; ++i) {
    PairLanes& pair = run.pairs[i];
    PointLanes* const points = run.points + pair.first;
    separate(run, pair, points);
    Both both(pair, run.velocity);
    // Normals first: friction is then bound by the loads themselves, of which the springs of solve() gave a part away.
    press<false>(both, points, inv_h, 0);
    rub(both, pair, points);
    add_to_sums(pair, points);
    both.store(run);
  }
}

void sweep(const LaneRun& run, double inv_h) {
  for (std::size_t i = 0; i < run.count; ++i) {
    PairLanes& pair = run.pairs[i];
    PointLanes* const points = run.points + pair.first;
    Both both(pair, run.velocity);
    rub(both, pair, points);
    press<false>(both, points, inv_h, 0);
    both.store(run);
  }
}

void book(const LaneRun& run) {
  for (std::size_t i = 0; i < run.count; ++i) add_to_sums(run.pairs[i], run.points + run.pairs[i].first);
}

void part(const LaneRun& run, double share, double slop) {
  for (std::size_t i = 0; i < run.count; ++i) {
    const PairLanes& pair = run.pairs[i];
    Both both(pair, run.velocity);
    for (std::uint32_t k = 0; k < pair.points; ++k) {
      PointLanes& p = run.points[pair.first + k];
      const Lanes wanted = share * larger(-(p.separation + slop), all(0));
      const Lanes next = larger(p.push + p.m_n * (wanted - dot(both.relative(p.r_a, p.r_b), p.n)), all(0)),
                  d = next - p.push;
      p.push = next;
      both.push(p.r_a, p.r_b, d * p.n);
    }
    both.store(run);
  }
}

void measure(const LaneRun& run) {
  for (std::size_t i = 0; i < run.count; ++i) {
    const PairLanes& pair = run.pairs[i];
    PointLanes* const points = run.points + pair.first;
    separate(run, pair, points);
    for (std::uint32_t k = 0; k < pair.points; ++k) points[k].push = all(0);
  }
}

void bounce(const LaneRun& run, double speed) {
  for (std::size_t i = 0; i < run.count; ++i) {
    const PairLanes& pair = run.pairs[i];
    Both both(pair, run.velocity);
    for (std::uint32_t k = 0; k < pair.points; ++k) {
      PointLanes& p = run.points[pair.first + k];
      const LaneMask hit = (p.approach < -speed) & (p.most > 0) & (pair.restitution > 0);
      const Lanes u_n = dot(both.relative(p.r_a, p.r_b), p.n);
      const Lanes next = larger(p.p_n - p.m_n * (u_n + pair.restitution * p.approach), all(0));
      const Lanes d = hit ? next - p.p_n : all(0);
      p.sum_n += d;  // but not p_n, which the next step starts from: an impact does not come again
      both.push(p.r_a, p.r_b, d * p.n);
    }
    both.store(run);
  }
}

constexpr ContactKernels kernels_named(const char* name) {
  return {name, prepare, warm_start, solve, relax, sweep, book, part, measure, bounce};
}

}  // namespace
}  // namespace carom
