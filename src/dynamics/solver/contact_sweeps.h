// Sweeps over contacts in lanes: the arithmetic behind ContactKernels. Included by one file for each width of
// registers, compiled for it; all that stands here is local to that file.
#pragma once

#include "dynamics/solver/contact_kernels.h"
#include "dynamics/solver/contact_masses.h"
#include "dynamics/solver/lane_sides.h"

namespace carom {
namespace {

constexpr int kInnerSweeps = 2;     // there and back
constexpr double kUnderLoad = 0.1;  // of push_speed: how fast what bears as much as it may push still parts further
constexpr double kSpared = 1.2;     // times what a spring sinks under its load at rest

/// Both sides of four pairs, and what an impulse does to them.
struct Both {
  Side a, b;
  const PairLanes& pair;
  const LockLanes* locks;  // null: none

  CAROM_LANES_INLINE Both(const PairLanes& p, const LaneRun& run)
      : pair(p), locks(p.locked ? run.locks + (p.locked - 1) : nullptr) {
    a.load(run.velocity, p.a);
    b.load(run.velocity, p.b);
  }
  CAROM_LANES_INLINE void store(const LaneRun& run) const {
    a.store(run.velocity, run.first_moved, pair.a);
    b.store(run.velocity, run.first_moved, pair.b);
  }
  CAROM_LANES_INLINE LaneVec relative(const LaneVec& r_a, const LaneVec& r_b) const {
    return (b.v + cross(b.omega, r_b)) - (a.v + cross(a.omega, r_a));
  }
  /// @param moment_a, moment_b  N m s, of the impulse about the centres of mass
  CAROM_LANES_INLINE void apply(const LaneVec& impulse, const LaneVec& moment_a, const LaneVec& moment_b) {
    a.v = a.v - pair.inv_mass_a * (locks ? each(locks->free_a, impulse) : impulse);
    a.omega = a.omega - pair.inv_inertia_a * moment_a;
    b.v = b.v + pair.inv_mass_b * (locks ? each(locks->free_b, impulse) : impulse);
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

/// f(count, one_normal) as the pair has it, known to the compiler: points then stay in registers.
template <int n>
struct Count {
  static constexpr int value = n;
};
template <class F>
CAROM_LANES_INLINE void as_it_is(const PairLanes& pair, const F& f) {
  static_assert(kPairPoints == 4);
  if (pair.one_normal) switch (pair.points) {
      case 1:
        return f(Count<1>(), Count<1>());
      case 2:
        return f(Count<2>(), Count<1>());
      case 3:
        return f(Count<3>(), Count<1>());
      default:
        return f(Count<4>(), Count<1>());
    }
  switch (pair.points) {  // one point is always on the pair's normal
    case 2:
      return f(Count<2>(), Count<0>());
    case 3:
      return f(Count<3>(), Count<0>());
    default:
      return f(Count<4>(), Count<0>());
  }
}

/// Coulomb's law in the plane: the impulses that stop twist and slip, shortened to what the normal impulses allow.
template <int kCount>
CAROM_LANES_INLINE void rub(Both& both, PairLanes& pair, const PointLanes* points, const DriveLanes* drives) {
  Lanes load = points[0].p_n, moment = points[0].reach * points[0].p_n;
  for (int k = 1; k < kCount; ++k) {
    load += points[k].p_n;
    moment += points[k].reach * points[k].p_n;
  }
  if constexpr (kCount > 1) {  // one point has no reach, and bears no twist
    const Lanes most_w = pair.friction * moment;
    Lanes spin = dot(both.b.omega - both.a.omega, pair.n);
    if (pair.driven) spin += drives[pair.driven - 1].w;
    const Lanes p_w = larger(smaller(pair.p_w - pair.m_w * spin, most_w), -most_w);
    both.twist((p_w - pair.p_w) * pair.n);
    pair.p_w = p_w;
  }
  const LaneVec u = both.relative(pair.r_a, pair.r_b), s = cross(pair.n, pair.t);
  Lanes u_t = dot(u, pair.t), u_s = dot(u, s);
  if (pair.driven) {
    u_t += drives[pair.driven - 1].t;
    u_s += drives[pair.driven - 1].s;
  }
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

/// Normal impulses of a pair, added up: what they are together at the middle of its points, and their moment about it.
template <int kCount, int kOneNormal>
struct Press {
  LaneVec force, moment;  // N s, N m s

  /// @param impulse  [kCount] N s
  CAROM_LANES_INLINE Press(const PairLanes& pair, const PointLanes* points, const Lanes* impulse) {
    if constexpr (kOneNormal) {
      Lanes sum = impulse[0];
      LaneVec arm = impulse[0] * points[0].d;
      for (int k = 1; k < kCount; ++k) {
        sum += impulse[k];
        arm = arm + impulse[k] * points[k].d;
      }
      force = sum * pair.n;
      moment = cross(arm, pair.n);
    } else {
      force = moment = {all(0), all(0), all(0)};
      for (int k = 0; k < kCount; ++k) {
        const LaneVec p = impulse[k] * points[k].n;
        force = force + p;
        moment = moment + cross(points[k].d, p);
      }
    }
  }
  CAROM_LANES_INLINE void act(Both& both) const {
    both.apply(force, cross(both.pair.r_a, force) + moment, cross(both.pair.r_b, force) + moment);
  }
};

/// Normal velocities at the points of a pair.
template <int kOneNormal>
struct Closing {
  LaneVec u, spin;  // of the middle, m/s; rad/s
  Lanes u_n;
  LaneVec gradient;  // 1/s, of the normal velocity over d

  CAROM_LANES_INLINE explicit Closing(const Both& both)
      : u(both.relative(both.pair.r_a, both.pair.r_b)), spin(both.b.omega - both.a.omega) {
    u_n = dot(u, both.pair.n);
    gradient = cross(both.pair.n, spin);
  }
  CAROM_LANES_INLINE Lanes at(const PointLanes& p) const {
    if constexpr (kOneNormal) return u_n + dot(gradient, p.d);
    return dot(u + cross(spin, p.d), p.n);
  }
};

/// The normal law at all points of four pairs together: no pull, and no closing faster than the separation allows.
/// Points of one pair depend on each other so much that one sweep over them leaves the bodies rocking; a few sweeps on
/// the numbers that couple them cost less than one on the bodies.
///
/// Kept up to date is `goal`, the impulse that would answer a point if none pulled: its own impulse does not enter
/// there, since mass_scale + impulse_scale = 1, so that little stands between one visit and the next.
///   goal_k = (1 - back_k) p_k - gain_k lack_k,   p_k = max(goal_k, 0),   goal_l -= gain_l K_kl (change of p_k)
///
/// @tparam kSpare  what will bounce in the next substep keeps the impulse that it has
template <bool kPush, bool kSpare, int kCount, int kOneNormal>
CAROM_LANES_INLINE void press(Both& both, PointLanes* points, double inv_h, double push_speed) {
  const PairLanes& pair = both.pair;
  const Closing<kOneNormal> closing(both);
  Lanes goal[kCount], gain[kCount], impulse[kCount], push[kCount];
  for (int k = 0; k < kCount; ++k) {
    const PointLanes& p = points[k];
    const Lanes u_n = closing.at(p), s = p.separation;
    const LaneMask open = s > 0;
    impulse[k] = push[k] = p.p_n;
    if constexpr (kPush) {
      gain[k] = (open ? all(1) : pair.mass_scale) * p.m_n;
      // push_speed bounds how fast a spring parts bodies, not what it can bear: under a load as large as that it goes
      // on growing, slowly.
      const Lanes given = pair.impulse_scale * p.p_n, most = gain[k] * push_speed;
      const Lanes spring = smaller(-gain[k] * (pair.bias_rate * s) - given, larger(most - given, kUnderLoad * most));
      goal[k] = p.p_n - gain[k] * u_n + (open ? -gain[k] * (s * inv_h) : spring);
    } else {
      gain[k] = p.m_n;
      goal[k] = p.p_n - gain[k] * (u_n + (open ? s * inv_h : all(0)));
      if constexpr (kSpare) {
        const LaneMask bounces = u_n < -pair.bounce_speed;
        gain[k] = bounces ? all(0) : gain[k];
        goal[k] = bounces ? p.p_n : goal[k];
      }
    }
  }
  Lanes take[kCount][kCount];  // of a point's goal, per impulse at another
  for (int k = 0; k < kCount; ++k)
    for (int l = 0; l < kCount; ++l)
      if (k != l) take[k][l] = gain[l] * pair.coupling[coupling_of(k, l)];
  const auto visit = [&](int k) __attribute__((always_inline)) {
    const Lanes next = larger(goal[k], all(0)), d = next - impulse[k];
    impulse[k] = next;
    for (int l = 0; l < kCount; ++l)
      if (l != k) goal[l] -= take[k][l] * d;
  };
  visit(0);
  for (int i = 0; i < (kCount > 1 ? kInnerSweeps : 0); ++i) {  // a point needs no second visit where the way turns
    for (int k = 1; k < kCount; ++k) visit(k);
    for (int k = kCount - 2; k >= 0; --k) visit(k);
  }
  for (int k = 0; k < kCount; ++k) {
    PointLanes& p = points[k];
    push[k] = impulse[k] - push[k];
    p.p_n = impulse[k];
  }
  Press<kCount, kOneNormal>(pair, points, push).act(both);
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
  /// The normal part of what a turn does to an arm is a product with the arm: (rotated - r) . n = m . r for any r.
  CAROM_LANES_INLINE LaneVec turned(const LaneVec& n) const {
    return all(2) * (w * cross(n, u) + dot(u, n) * u - dot(u, u) * n);
  }
};

/// kernel(pair, points, both, count, one_normal) for each, with bodies' velocities read before and written after.
template <class Kernel>
CAROM_LANES_INLINE void each_pair(const LaneRun& run, const Kernel& kernel) {
  for (std::size_t i = 0; i < run.count; ++i) {
    PairLanes& pair = run.pairs[i];
    PointLanes* const points = run.points + pair.first;
    as_it_is(
        pair, [&](auto count, auto one_normal) __attribute__((always_inline)) {
          Both both(pair, run);
          kernel(pair, points, both, count, one_normal);
          both.store(run);
        });
  }
}

void warm_start(const LaneRun& run) {
  each_pair(
      run, [&](const PairLanes& pair, const PointLanes* points, Both& both, auto count, auto one_normal)
               __attribute__((always_inline)) {
                 constexpr int kCount = decltype(count)::value;
                 Lanes impulse[kCount];
                 for (int k = 0; k < kCount; ++k) impulse[k] = points[k].p_n;
                 Press<kCount, decltype(one_normal)::value> press(pair, points, impulse);
                 press.force = press.force + pair.p_t * pair.t + pair.p_s * cross(pair.n, pair.t);
                 press.moment = press.moment + pair.p_w * pair.n;
                 press.act(both);
               });
}

void solve(const LaneRun& run, double inv_h, double push_speed) {
  each_pair(
      run, [&](PairLanes & pair, PointLanes * points, Both & both, auto count, auto one_normal)
               __attribute__((always_inline)) {
                 constexpr int kCount = decltype(count)::value;
                 rub<kCount>(both, pair, points, run.drives);
                 press<true, false, kCount, decltype(one_normal)::value>(both, points, inv_h, push_speed);
               });
}

/// Separations at all points of four pairs, at the present poses.
template <int kCount, int kOneNormal>
CAROM_LANES_INLINE void separate(const LaneRun& run, const PairLanes& pair, PointLanes* points) {
  const SideShift a(run.shift, pair.a), b(run.shift, pair.b);
  const LaneVec moved = b.x - a.x;
  if constexpr (kOneNormal) {
    const LaneVec m_a = a.turned(pair.n), m_b = b.turned(pair.n), m = m_b - m_a;
    const Lanes round = pair.radius_a * dot(m_a, pair.n) + pair.radius_b * dot(m_b, pair.n);
    const Lanes middle = dot(moved, pair.n) + (dot(m_b, pair.r_b) - dot(m_a, pair.r_a)) + round;
    for (int k = 0; k < kCount; ++k) points[k].separation = points[k].gap + (middle + dot(m, points[k].d));
  } else {
    for (int k = 0; k < kCount; ++k) {
      PointLanes& p = points[k];
      const LaneVec m_a = a.turned(p.n), m_b = b.turned(p.n);
      const Lanes turned = dot(m_b, pair.r_b + p.d) - dot(m_a, pair.r_a + p.d);
      const Lanes round = pair.radius_a * dot(m_a, p.n) + pair.radius_b * dot(m_b, p.n);
      p.separation = p.gap + (dot(moved, p.n) + turned + round);
    }
  }
}

CAROM_LANES_INLINE void add_to_sums(PairLanes& pair, PointLanes* points, std::uint32_t count) {
  pair.sum_t += pair.p_t;
  pair.sum_s += pair.p_s;
  pair.sum_w += pair.p_w;
  for (std::uint32_t k = 0; k < count; ++k) points[k].sum_n += points[k].p_n;
}

template <bool kSpare>
void relax(const LaneRun& run, double inv_h) {
  each_pair(
      run, [&](PairLanes & pair, PointLanes * points, Both & both, auto count, auto one_normal)
               __attribute__((always_inline)) {
                 constexpr int kCount = decltype(count)::value, kOneNormal = decltype(one_normal)::value;
                 separate<kCount, kOneNormal>(run, pair, points);
                 // Normals first: friction is then bound by the loads themselves, of which the springs of solve()
                 // gave a part away.
                 press<false, kSpare, kCount, kOneNormal>(both, points, inv_h, 0);
                 rub<kCount>(both, pair, points, run.drives);
                 add_to_sums(pair, points, kCount);
               });
}

void sweep(const LaneRun& run, double inv_h) {
  each_pair(
      run, [&](PairLanes & pair, PointLanes * points, Both & both, auto count, auto one_normal)
               __attribute__((always_inline)) {
                 constexpr int kCount = decltype(count)::value;
                 rub<kCount>(both, pair, points, run.drives);
                 press<false, false, kCount, decltype(one_normal)::value>(both, points, inv_h, 0);
               });
}

void book(const LaneRun& run) {
  for (std::size_t i = 0; i < run.count; ++i)
    add_to_sums(run.pairs[i], run.points + run.pairs[i].first, run.pairs[i].points);
}

void part(const LaneRun& run, double share, double slop) {
  for (std::size_t i = 0; i < run.count; ++i) {
    const PairLanes& pair = run.pairs[i];
    Both both(pair, run);
    for (std::uint32_t k = 0; k < pair.points; ++k) {
      PointLanes& p = run.points[pair.first + k];
      const LaneVec n = normal_of(pair, p), r_a = pair.r_a + p.d, r_b = pair.r_b + p.d;
      const Lanes sag = pair.impulse_scale * p.p_n * inverse_or_zero(pair.mass_scale * pair.bias_rate * p.m_n);
      const Lanes wanted = share * larger(-p.separation - larger(all(slop), kSpared * sag), all(0));
      const Lanes next = larger(p.push + p.m_n * (wanted - dot(both.relative(r_a, r_b), n)), all(0)), d = next - p.push;
      p.push = next;
      both.push(r_a, r_b, d * n);
    }
    both.store(run);
  }
}

void measure(const LaneRun& run) {
  for (std::size_t i = 0; i < run.count; ++i) {
    const PairLanes& pair = run.pairs[i];
    PointLanes* const points = run.points + pair.first;
    as_it_is(
        pair, [&](auto count, auto one_normal) __attribute__((always_inline)) {
          separate<decltype(count)::value, decltype(one_normal)::value>(run, pair, points);
        });
    for (std::uint32_t k = 0; k < pair.points; ++k) points[k].push = all(0);
  }
}

constexpr ContactKernels kernels_named(const char* name) {
  return {name, prepare, warm_start, solve, relax<false>, relax<true>, sweep, book, part, measure};
}

}  // namespace
}  // namespace carom
