// Sweeps over contacts in lanes: the arithmetic behind ContactKernels. Included by one file for each width of
// registers, compiled for it; all that stands here is local to that file.
#pragma once

#include "dynamics/solver/both_sides.h"
#include "dynamics/solver/contact_kernels.h"
#include "dynamics/solver/contact_layout.h"
#include "dynamics/solver/contact_masses.h"
#include "dynamics/solver/contact_points.h"
#include "dynamics/solver/lane_friction.h"
#include "dynamics/solver/sweep_constants.h"

namespace carom::dynamics {
namespace {

/// f(count, one_normal) as the pair has it, known to the compiler: points then stay in registers.
/// Where few copies are wanted only the normals are: count is 0, @see points_of
template <int n>
struct Count {
  static constexpr int value = n;
};
template <class Pair, class F>
CAROM_LANES_INLINE void as_it_is(const Pair& pair, const F& f) {
  static_assert(kPairPoints == 4);
  if constexpr (kFewCopies) {
    if (pair.one_normal) return f(Count<0>(), Count<1>());
    return f(Count<0>(), Count<0>());
  } else {
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
}

/// Normal impulses of a pair, added up: what they are together where its friction acts, and their moment about it.
template <class Number, int kCount, int kOneNormal>
struct NormalImpulse {
  using Lanes = LanesOf<Number>;
  using LaneVec = LaneVecOf<Number>;
  LaneVec force, moment;  // N s, N m s

  /// @param impulse  [kCount] N s
  CAROM_LANES_INLINE NormalImpulse(const PairLanesOf<Number>& pair, const PointLanesOf<Number>* points,
                                   const Lanes* impulse) {
    const int count = points_of<kCount>(pair);
    if constexpr (kOneNormal) {
      Lanes sum = impulse[0];
      LaneVec arm = impulse[0] * points[0].d;
      for (int k = 1; k < count; ++k) {
        sum += impulse[k];
        arm = arm + impulse[k] * points[k].d;
      }
      force = sum * pair.n;
      moment = cross(arm, pair.n);
    } else {
      force = moment = {all<Number>(0), all<Number>(0), all<Number>(0)};
      for (int k = 0; k < count; ++k) {
        const LaneVec p = impulse[k] * points[k].n;
        force = force + p;
        moment = moment + cross(points[k].d, p);
      }
    }
  }
  CAROM_LANES_INLINE void act(Both<Number>& both) const {
    both.apply(force, cross(both.pair.r_a, force) + moment, cross(both.pair.r_b, force) + moment);
  }
};

/// Normal velocities at the points of a pair.
template <class Number, int kOneNormal>
struct Closing {
  using Lanes = LanesOf<Number>;
  using LaneVec = LaneVecOf<Number>;
  LaneVec u, spin;  // of the middle, m/s; rad/s
  Lanes u_n;
  LaneVec gradient;  // 1/s, of the normal velocity over d

  CAROM_LANES_INLINE explicit Closing(const Both<Number>& both)
      : u(both.relative(both.pair.r_a, both.pair.r_b)), spin(both.spin()) {
    u_n = dot(u, both.pair.n);
    gradient = cross(both.pair.n, spin);
  }
  CAROM_LANES_INLINE Lanes at(const PointLanesOf<Number>& p) const {
    if constexpr (kOneNormal) return u_n + dot(gradient, p.d);
    return dot(u + cross(spin, p.d), p.n);
  }
};

/// The visits of solve_normal() to the points of a pair.
template <int kCount, class Number, class Lanes = LanesOf<Number>>
CAROM_SHARED_PART void visit_points(const PairLanesOf<Number>& pair, Lanes* goal, const Lanes* gain, Lanes* impulse) {
  Lanes take[kCount][kCount];  // of a point's goal, per impulse at another
  for (int k = 0; k < kCount; ++k)
    for (int l = 0; l < kCount; ++l)
      if (k != l) take[k][l] = gain[l] * pair.coupling[coupling_of(k, l)];
  const auto visit = [&](int k) __attribute__((always_inline)) {
    const Lanes next = larger(goal[k], all<Number>(0)), d = next - impulse[k];
    impulse[k] = next;
    for (int l = 0; l < kCount; ++l)
      if (l != k) goal[l] -= take[k][l] * d;
  };
  visit(0);
  for (int i = 0; i < (kCount > 1 ? kInnerSweeps.value : 0);
       ++i) {  // a point needs no second visit where the way turns
    for (int k = 1; k < kCount; ++k) visit(k);
    for (int k = kCount - 2; k >= 0; --k) visit(k);
  }
}
template <class Number, class Lanes = LanesOf<Number>>
CAROM_LANES_INLINE void visit_all(const PairLanesOf<Number>& pair, Lanes* goal, const Lanes* gain, Lanes* impulse) {
  switch (pair.points) {
    case 1:
      return visit_points<1>(pair, goal, gain, impulse);
    case 2:
      return visit_points<2>(pair, goal, gain, impulse);
    case 3:
      return visit_points<3>(pair, goal, gain, impulse);
    default:
      return visit_points<4>(pair, goal, gain, impulse);
  }
}

/// The normal law at all points of four pairs together: no pull, and no closing faster than the separation allows.
/// Points of one pair depend on each other so much that one sweep over them leaves the bodies rocking; a few sweeps on
/// the numbers that couple them cost less than one on the bodies.
///
/// Kept up to date is `goal`, the impulse that would solve a point if none pulled: its own impulse does not enter
/// there, since mass_scale + impulse_scale = 1, so that little stands between one visit and the next.
///   goal_k = (1 - back_k) p_k - gain_k lack_k,   p_k = max(goal_k, 0),   goal_l -= gain_l K_kl (change of p_k)
///
/// @tparam kSpare  what will bounce in the next substep keeps the impulse that it has
template <bool kPush, bool kSpare, int kCount, int kOneNormal, class Number>
CAROM_SHARED_PART void solve_normal(Both<Number>& both, PointLanesOf<Number>* points, Number inv_h, Number push_speed) {
  using Lanes = LanesOf<Number>;
  constexpr auto kUnder = static_cast<Number>(kUnderLoad.value);
  const PairLanesOf<Number>& pair = both.pair;
  const Closing<Number, kOneNormal> closing(both);
  constexpr int kMost = most_points<kCount>;
  const int count = points_of<kCount>(pair);
  Lanes goal[kMost], gain[kMost], impulse[kMost], push[kMost];
  for (int k = 0; k < count; ++k) {
    const PointLanesOf<Number>& p = points[k];
    const Lanes u_n = closing.at(p), s = p.separation;
    const auto open = s > 0;
    impulse[k] = push[k] = p.p_n;
    if constexpr (kPush) {
      gain[k] = (open ? all<Number>(1) : pair.mass_scale) * p.m_n;
      // push_speed bounds how fast a spring parts bodies, not what it can bear: under a load as large as that it goes
      // on growing, slowly.
      const Lanes given = pair.impulse_scale * p.p_n, most = gain[k] * push_speed;
      const Lanes spring = smaller(-gain[k] * (pair.bias_rate * s) - given, larger(most - given, kUnder * most));
      goal[k] = p.p_n - gain[k] * u_n + (open ? -gain[k] * (s * inv_h) : spring);
    } else {
      gain[k] = p.m_n;
      goal[k] = p.p_n - gain[k] * (u_n + (open ? s * inv_h : all<Number>(0)));
      if constexpr (kSpare) {
        const auto bounces = u_n < -pair.bounce_speed;
        gain[k] = bounces ? all<Number>(0) : gain[k];
        goal[k] = bounces ? p.p_n : goal[k];
      }
    }
  }
  if constexpr (kCount)
    visit_points<kCount>(pair, goal, gain, impulse);
  else
    visit_all(pair, goal, gain, impulse);
  for (int k = 0; k < count; ++k) {
    PointLanesOf<Number>& p = points[k];
    push[k] = impulse[k] - push[k];
    p.p_n = impulse[k];
  }
  NormalImpulse<Number, kCount, kOneNormal>(pair, points, push).act(both);
}

/// kernel(pair, points, both, count, one_normal) for each, with bodies' velocities read before and written after.
template <class Number, class Kernel>
CAROM_LANES_INLINE void each_pair(const LaneRunOf<Number>& run, const Kernel& kernel) {
  for (std::size_t i = 0; i < run.count; ++i) {
    PairLanesOf<Number>& pair = run.pairs[i];
    PointLanesOf<Number>* const points = run.points + pair.first;
    if constexpr (kFewCopies) {
      Both<Number> both(pair, run);
      as_it_is(
          pair, [&](auto count, auto one_normal)
                    __attribute__((always_inline)) { kernel(pair, points, both, count, one_normal); });
      both.store(run);
    } else {
      as_it_is(
          pair, [&](auto count, auto one_normal) __attribute__((always_inline)) {
            Both<Number> both(pair, run);
            kernel(pair, points, both, count, one_normal);
            both.store(run);
          });
    }
  }
}

static_assert(offsetof(BodyTurn, u) == 3 * sizeof(double) && offsetof(BodyTurn, w) == 6 * sizeof(double) &&
              offsetof(BodyTurn, omega) == 7 * sizeof(double));
/// Turns of the four bodies on one side.
struct GroundTurn {
  LaneVec x, u, omega;
  Lanes w;

  CAROM_LANES_INLINE GroundTurn(const BodyTurn* all_bodies, const std::uint32_t* body) {
    const BodyRows rows(all_bodies, body);
    const LanePair p = rows.two(0), q = rows.two(2), r = rows.two(4), s = rows.two(6), t = rows.two(8);
    x = {p.first, p.second, q.first}, u = {q.second, r.first, r.second};
    w = s.first, omega = {s.second, t.first, t.second};
  }
  /// (exp(h omega) - 1) y / h, m/s
  CAROM_LANES_INLINE LaneVec way(const LaneVec& y, Lanes two_per_h) const {
    const LaneVec c = cross(u, y);
    return two_per_h * (w * c + cross(u, c));
  }
};

/// The numbers are those of lead_of(). Friction turns by the angle whose half has the tangent x + x^3/3: it is where sweeps start.
template <class Number>
void lead(const LaneRunOf<Number>& run, const BodyTurn* bodies, double h) {
  const Lanes two_per_h = all(2 / h);
  for (std::size_t i = 0; i < run.count; ++i) {
    PairLanesOf<Number>& pair = run.pairs[i];
    if (!pair.driven) continue;
    DriveLanesOf<Number>& drive = run.drives[pair.driven - 1];
    const GroundTurn a(bodies, pair.a), b(bodies, pair.b);
    const Lanes share_a = widened(drive.share_a), share_b = widened(drive.share_b);
    const LaneVec apart = b.x - a.x, spin = share_a * a.omega + share_b * b.omega, n = widened(pair.n),
                  t = widened(pair.t), s = cross(n, t);
    const LaneVec to = share_a * a.way(apart, two_per_h) + share_b * b.way(apart, two_per_h);
    const LaneVec lead = cross(spin, widened(pair.r_a) - widened(pair.r_b)) - to;
    drive.t = rounded<Number>(widened(drive.own_t) + inner(lead, t));
    drive.s = rounded<Number>(widened(drive.own_s) + inner(lead, s));
    const Lanes half = all(h / 2) * inner(spin, n), tangent = half * (1 + half * half * all(1.0 / 3)),
                per = 1 / (1 + tangent * tangent), cosine = (1 - tangent * tangent) * per, sine = 2 * tangent * per;
    const Lanes p_t = widened(pair.p_t), p_s = widened(pair.p_s);
    pair.p_t = rounded<Number>(cosine * p_t - sine * p_s);
    pair.p_s = rounded<Number>(sine * p_t + cosine * p_s);
  }
}

template <class Number>
void warm_start(const LaneRunOf<Number>& run) {
  each_pair(
      run, [&](const auto& pair, const auto* points, auto& both, auto count, auto one_normal)
               __attribute__((always_inline)) {
                 constexpr int kCount = decltype(count)::value;
                 LanesOf<Number> impulse[most_points<kCount>];
                 for (int k = 0; k < points_of<kCount>(pair); ++k) impulse[k] = points[k].p_n;
                 NormalImpulse<Number, kCount, decltype(one_normal)::value> solve_normal(pair, points, impulse);
                 solve_normal.force = solve_normal.force + pair.p_t * pair.t + pair.p_s * cross(pair.n, pair.t);
                 solve_normal.moment = solve_normal.moment + pair.p_w * pair.n;
                 solve_normal.act(both);
               });
}

template <class Number>
void solve(const LaneRunOf<Number>& run, double per_substep, double most_push) {
  const auto inv_h = static_cast<Number>(per_substep), push_speed = static_cast<Number>(most_push);
  each_pair(
      run, [&](auto& pair, auto* points, auto& both, auto count, auto one_normal) __attribute__((always_inline)) {
        constexpr int kCount = decltype(count)::value;
        solve_friction<kCount>(both, pair, points, run.drives);
        solve_normal<true, false, kCount, decltype(one_normal)::value>(both, points, inv_h, push_speed);
      });
}

/// What one visit of four pairs changes of those that it is not for, kept and put back.
template <class Number>
class Unvisited {
 public:
  CAROM_LANES_INLINE Unvisited(const LaneRunOf<Number>& four, const PointLanesOf<Number>* points) : four_(four) {
    const PairLanesOf<Number>& pair = *four.pairs;
    for (int i = 0; i < kLanes; ++i) a_[i] = four.velocity[pair.a[i]], b_[i] = four.velocity[pair.b[i]];
    for (std::uint32_t k = 0; k < pair.points; ++k) p_n_[k] = points[k].p_n;
    p_t_ = pair.p_t, p_s_ = pair.p_s, p_w_ = pair.p_w;
  }
  CAROM_LANES_INLINE void put_back(int lane, PointLanesOf<Number>* points) const {
    PairLanesOf<Number>& pair = *four_.pairs;
    put_back(pair.a[lane], a_[lane]), put_back(pair.b[lane], b_[lane]);
    for (std::uint32_t k = 0; k < pair.points; ++k) points[k].p_n[lane] = p_n_[k][lane];
    pair.p_t[lane] = p_t_[lane], pair.p_s[lane] = p_s_[lane], pair.p_w[lane] = p_w_[lane];
  }

 private:
  CAROM_LANES_INLINE void put_back(std::uint32_t body, const BodyVelocity& velocity) const {
    if (body >= four_.first_moved) four_.velocity[body] = velocity;
  }

  using Lanes = LanesOf<Number>;
  const LaneRunOf<Number>& four_;
  BodyVelocity a_[kLanes], b_[kLanes];
  Lanes p_n_[kPairPoints], p_t_, p_s_, p_w_;
};

/// @param which  (four pairs) -> a bit for each that is visited
template <class Number, class Which>
void solve_some(const LaneRunOf<Number>& run, double per_substep, double most_push, const Which& which) {
  constexpr unsigned kAll = (1u << kLanes) - 1;
  for (std::size_t i = 0; i < run.count; ++i) {
    const PairLanesOf<Number>& pair = run.pairs[i];
    const unsigned visited = which(pair);
    if (visited == 0) continue;
    LaneRunOf<Number> four = run;
    four.pairs += i, four.count = 1;
    if (visited == kAll) {
      solve(four, per_substep, most_push);
      continue;
    }
    PointLanesOf<Number>* const points = run.points + pair.first;
    const Unvisited<Number> unvisited(four, points);
    solve(four, per_substep, most_push);
    for (int lane = 0; lane < kLanes; ++lane)
      if (!(visited >> lane & 1u)) unvisited.put_back(lane, points);
  }
}

template <class Number>
void solve_thin(const LaneRunOf<Number>& run, double per_substep, double most_push, double share) {
  const Number way = static_cast<Number>(1 / (per_substep * per_substep));  // s^2
  solve_some(run, per_substep, most_push, [&](const PairLanesOf<Number>& pair) {
    const auto is_thin = way * pair.pull > static_cast<Number>(share) * pair.thickness;
    unsigned thin = 0;
    for (int lane = 0; lane < kLanes; ++lane) thin |= static_cast<unsigned>(is_thin[lane] != 0) << lane;
    return thin;
  });
}

template <class Number>
void solve_of(const LaneRunOf<Number>& run, double per_substep, double most_push, const std::uint8_t* bodies) {
  solve_some(run, per_substep, most_push, [&](const PairLanesOf<Number>& pair) {
    unsigned of = 0;
    for (int lane = 0; lane < kLanes; ++lane) of |= unsigned(bodies[pair.a[lane]] | bodies[pair.b[lane]]) << lane;
    return of;
  });
}

/// Separations at all points of four pairs, at the present poses.
template <int kCount, int kOneNormal, class Number>
CAROM_SHARED_PART void separate(const LaneRunOf<Number>& run, const PairLanesOf<Number>& pair,
                                PointLanesOf<Number>* points) {
  using Lanes = LanesOf<Number>;
  using LaneVec = LaneVecOf<Number>;
  const BothShifts<Number> shifts(run.shift, pair);
  const LaneVec& moved = shifts.moved;
  const int count = points_of<kCount>(pair);
  if constexpr (kOneNormal) {
    const LaneVec m_a = shifts.a.turned(pair.n), m_b = shifts.b.turned(pair.n), m = m_b - m_a;
    const Lanes round = pair.radius_a * dot(m_a, pair.n) + pair.radius_b * dot(m_b, pair.n);
    const Lanes middle = dot(moved, pair.n) + (dot(m_b, pair.r_b) - dot(m_a, pair.r_a)) + round;
    for (int k = 0; k < count; ++k) points[k].separation = points[k].gap + (middle + dot(m, points[k].d));
  } else {
    for (int k = 0; k < count; ++k) {
      PointLanesOf<Number>& p = points[k];
      const LaneVec m_a = shifts.a.turned(p.n), m_b = shifts.b.turned(p.n);
      const Lanes turned = dot(m_b, pair.r_b + p.d) - dot(m_a, pair.r_a + p.d);
      const Lanes round = pair.radius_a * dot(m_a, p.n) + pair.radius_b * dot(m_b, p.n);
      p.separation = p.gap + (dot(moved, p.n) + turned + round);
    }
  }
}

template <class Number>
CAROM_LANES_INLINE void add_to_sums(PairLanesOf<Number>& pair, PointLanesOf<Number>* points, std::uint32_t count) {
  pair.sum_t += pair.p_t;
  pair.sum_s += pair.p_s;
  pair.sum_w += pair.p_w;
  for (std::uint32_t k = 0; k < count; ++k) points[k].sum_n += points[k].p_n;
}

template <bool kSpare, class Number>
void relax(const LaneRunOf<Number>& run, double per_substep) {
  const auto inv_h = static_cast<Number>(per_substep);
  each_pair(
      run, [&](auto& pair, auto* points, auto& both, auto count, auto one_normal) __attribute__((always_inline)) {
        constexpr int kCount = decltype(count)::value, kOneNormal = decltype(one_normal)::value;
        separate<kCount, kOneNormal>(run, pair, points);
        // Normals first: friction is then bound by the loads themselves, of which the springs of solve()
        // gave a part away.
        solve_normal<false, kSpare, kCount, kOneNormal>(both, points, inv_h, Number(0));
        solve_friction<kCount>(both, pair, points, run.drives);
        add_to_sums(pair, points, static_cast<std::uint32_t>(points_of<kCount>(pair)));
      });
}

/// Whether part() has anything to do at four pairs: a point is deeper than what is left to it, or a body was displaced.
template <class Number>
CAROM_LANES_INLINE bool is_to_be_parted(const LaneRunOf<Number>& run, const PairLanesOf<Number>& pair,
                                        LanesOf<Number> left) {
  for (std::uint32_t k = 0; k < pair.points; ++k) {
    const auto deep = -run.points[pair.first + k].separation > left;
    if (deep[0] | deep[1] | deep[2] | deep[3]) return true;
  }
  LaneMask displaced = {0, 0, 0, 0};
  const auto look_at = [&](std::uint32_t body) __attribute__((always_inline)) {
    LaneMask bits[2];
    static_assert(sizeof bits == sizeof(BodyVelocity));
    __builtin_memcpy(bits, run.velocity + body, sizeof bits);
    displaced |= bits[0] | bits[1];
  };
  for (int i = 0; i < kLanes; ++i) look_at(pair.a[i]), look_at(pair.b[i]);
  return (displaced[0] | displaced[1] | displaced[2] | displaced[3]) != 0;
}

template <class Number>
void part(const LaneRunOf<Number>& run, double of_depth, double tolerated, double tolerated_of_thin) {
  using Lanes = LanesOf<Number>;
  using LaneVec = LaneVecOf<Number>;
  const auto share = static_cast<Number>(of_depth), slop = static_cast<Number>(tolerated),
             of_thin = static_cast<Number>(tolerated_of_thin);
  constexpr auto kSpare = static_cast<Number>(kSpared.value);
  for (std::size_t i = 0; i < run.count; ++i) {
    const PairLanesOf<Number>& pair = run.pairs[i];
    const Lanes left = smaller(all<Number>(slop), of_thin * pair.thickness);
    if (!is_to_be_parted(run, pair, left)) continue;
    Both<Number> both(pair, run);
    for (std::uint32_t k = 0; k < pair.points; ++k) {
      const PointLanesOf<Number>& p = run.points[pair.first + k];
      const LaneVec n = normal_of(pair, p), r_a = pair.r_a + p.d, r_b = pair.r_b + p.d;
      const Lanes sag = pair.impulse_scale * p.p_n * inverse_or_zero(pair.mass_scale * pair.bias_rate * p.m_n);
      const Lanes wanted = share * larger(-p.separation - larger(left, kSpare * sag), all<Number>(0));
      const Lanes push = larger(p.m_n * (wanted - dot(both.relative(r_a, r_b), n)), all<Number>(0));
      both.push(r_a, r_b, push * n);
    }
    both.store(run);
  }
}

template <class Number>
void measure(const LaneRunOf<Number>& run) {
  for (std::size_t i = 0; i < run.count; ++i) {
    const PairLanesOf<Number>& pair = run.pairs[i];
    PointLanesOf<Number>* const points = run.points + pair.first;
    as_it_is(
        pair, [&](auto count, auto one_normal) __attribute__((always_inline)) {
          separate<decltype(count)::value, decltype(one_normal)::value>(run, pair, points);
        });
  }
}

template <class Number>
constexpr ContactSweeps<Number> all_sweeps() {
  return {lay_out<Number>,      read_back<Number>,   prepare<Number>,    lead<Number>,
          warm_start<Number>,   solve<Number>,       solve_thin<Number>, solve_of<Number>,
          relax<false, Number>, relax<true, Number>, part<Number>,       measure<Number>};
}

constexpr ContactKernels kernels_named(const char* name) {
  return {name, {place_points, watch_points}, all_sweeps<double>(), all_sweeps<float>()};
}

}  // namespace
}  // namespace carom::dynamics
