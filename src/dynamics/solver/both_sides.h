// Both sides of four pairs, of doubles or of floats: velocities and shifts of their bodies, and what impulses do to
// them. Part of contact_sweeps.h; all that stands here is local to the file that includes it.
//
// Bodies are doubles in either case. Of floats are the numbers of the rows, and what bodies do relative to each other,
// which is taken from the doubles before it is rounded; what impulses change is added up in floats for one visit of a
// pair and then given to the doubles. So a body that weighs a million times as much as its neighbour, or both on a
// train, lose nothing.
#pragma once

#include "dynamics/solver/lane_sides.h"

namespace carom::dynamics {
namespace {

/// How many points a pair has, and how many one may have: as the compiler knows, or 0 where it does not.
template <int kCount>
inline constexpr int most_points = kCount ? kCount : kPairPoints;
template <int kCount, class Number>
CAROM_LANES_INLINE int points_of(const PairLanesOf<Number>& pair) {
  if constexpr (kCount > 0) return kCount;
  return static_cast<int>(pair.points);
}

template <class Number>
struct Both;

template <>
struct Both<double> {
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
  CAROM_LANES_INLINE LaneVec spin() const { return b.omega - a.omega; }
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

using FloatVec = LaneVecOf<float>;

/// The eight numbers of one body: two rows of four.
CAROM_LANES_INLINE Lanes half_of(const void* body, int half) {
  return lanes_at(static_cast<const double*>(body) + half * kLanes);
}

template <>
struct Both<float> {
  FloatVec u, turning;      // of B relative to A, of the centres of mass, m/s; rad/s
  FloatVec omega_a;         // rad/s
  FloatVec sum;             // N s, impulses on B
  FloatVec turn_a, turn_b;  // rad/s, what they changed
  const PairLanesOf<float>& pair;
  const LockLanesOf<float>* locks;  // null: none

  CAROM_LANES_INLINE Both(const PairLanesOf<float>& p, const LaneRunOf<float>& run)
      : pair(p), locks(p.locked ? run.locks + (p.locked - 1) : nullptr) {
    LanesOf<float> near[kLanes], far[kLanes], own_near[kLanes], own_far[kLanes];
    for (int i = 0; i < kLanes; ++i) {
      const BodyVelocity* const a = run.velocity + p.a[i];
      const BodyVelocity* const b = run.velocity + p.b[i];
      const Lanes a0 = half_of(a, 0), a1 = half_of(a, 1);
      near[i] = to_float(half_of(b, 0) - a0), far[i] = to_float(half_of(b, 1) - a1);
      own_near[i] = to_float(a0), own_far[i] = to_float(a1);
    }
    const FloatLanes q = transpose(near[0], near[1], near[2], near[3]), r = transpose(far[0], far[1], far[2], far[3]),
                     s = transpose(own_near[0], own_near[1], own_near[2], own_near[3]),
                     t = transpose(own_far[0], own_far[1], own_far[2], own_far[3]);
    u = {q.lane[0], q.lane[1], q.lane[2]};
    turning = {q.lane[3], r.lane[0], r.lane[1]};
    omega_a = {s.lane[3], t.lane[0], t.lane[1]};
    sum = turn_a = turn_b = {all<float>(0), all<float>(0), all<float>(0)};
  }
  CAROM_LANES_INLINE void store(const LaneRunOf<float>& run) const {
    const auto none = all<float>(0);
    add(run, pair.a, -pair.inv_mass_a * (locks ? each(locks->free_a, sum) : sum), turn_a, none);
    add(run, pair.b, pair.inv_mass_b * (locks ? each(locks->free_b, sum) : sum), turn_b, none);
  }
  CAROM_LANES_INLINE FloatVec relative(const FloatVec& r_a, const FloatVec& r_b) const {
    return (u + cross(turning, r_b)) + cross(omega_a, r_b - r_a);
  }
  CAROM_LANES_INLINE FloatVec spin() const { return turning; }
  CAROM_LANES_INLINE void apply(const FloatVec& impulse, const FloatVec& moment_a, const FloatVec& moment_b) {
    if (locks)
      u = u + (pair.inv_mass_a * each(locks->free_a, impulse) + pair.inv_mass_b * each(locks->free_b, impulse));
    else
      u = u + (pair.inv_mass_a + pair.inv_mass_b) * impulse;
    sum = sum + impulse;
    turn(pair.inv_inertia_a * moment_a, pair.inv_inertia_b * moment_b);
  }
  CAROM_LANES_INLINE void push(const FloatVec& r_a, const FloatVec& r_b, const FloatVec& impulse) {
    apply(impulse, cross(r_a, impulse), cross(r_b, impulse));
  }
  CAROM_LANES_INLINE void twist(const FloatVec& moment) {
    turn(pair.inv_inertia_a * moment, pair.inv_inertia_b * moment);
  }

 private:
  CAROM_LANES_INLINE void turn(const FloatVec& back_a, const FloatVec& by_b) {
    omega_a = omega_a - back_a;
    turning = turning + (back_a + by_b);
    turn_a = turn_a - back_a;
    turn_b = turn_b + by_b;
  }
  CAROM_LANES_INLINE static void add(const LaneRunOf<float>& run, const std::uint32_t* body, const FloatVec& v,
                                     const FloatVec& omega, LanesOf<float> none) {
    const FloatLanes p = transpose(v.x, v.y, v.z, omega.x), q = transpose(omega.y, omega.z, none, none);
    for (int i = 0; i < kLanes; ++i) {
      if (body[i] < run.first_moved) continue;
      Lanes* const to = reinterpret_cast<Lanes*>(run.velocity + body[i]);
      to[0] += to_double(p.lane[i]), to[1] += to_double(q.lane[i]);
    }
  }
};

/// How four bodies on one side have turned.
template <class Number>
struct SideTurn {
  LaneVecOf<Number> u;
  LanesOf<Number> w;

  /// The normal part of what a turn does to an arm is a product with the arm: (rotated - r) . n = m . r for any r.
  CAROM_LANES_INLINE LaneVecOf<Number> turned(const LaneVecOf<Number>& n) const {
    return all<Number>(2) * (w * cross(n, u) + dot(u, n) * u - dot(u, u) * n);
  }
};

/// How far the bodies of four pairs have come, B's relative to A's.
template <class Number>
struct BothShifts;

template <>
struct BothShifts<double> {
  LaneVec moved;
  SideTurn<double> a, b;

  CAROM_LANES_INLINE BothShifts(const BodyShift* all_bodies, const PairLanes& pair) {
    LaneVec x_a, x_b;
    load(all_bodies, pair.a, x_a, a);
    load(all_bodies, pair.b, x_b, b);
    moved = x_b - x_a;
  }

 private:
  CAROM_LANES_INLINE static void load(const BodyShift* all_bodies, const std::uint32_t* body, LaneVec& x,
                                      SideTurn<double>& turn) {
    const BodyRows rows(all_bodies, body);
    const LanePair p = rows.two(0), q = rows.two(2), r = rows.two(4);
    x = {p.first, p.second, q.first};
    turn.u = {q.second, r.first, r.second};
    turn.w = rows.two(6).first;
  }
};

template <>
struct BothShifts<float> {
  FloatVec moved;
  SideTurn<float> a, b;

  CAROM_LANES_INLINE BothShifts(const BodyShift* all_bodies, const PairLanesOf<float>& pair) {
    LanesOf<float> apart[kLanes], a0[kLanes], a1[kLanes], b0[kLanes], b1[kLanes];
    for (int i = 0; i < kLanes; ++i) {
      const BodyShift* const of_a = all_bodies + pair.a[i];
      const BodyShift* const of_b = all_bodies + pair.b[i];
      const Lanes near_a = half_of(of_a, 0), near_b = half_of(of_b, 0);
      apart[i] = to_float(near_b - near_a);
      a0[i] = to_float(near_a), a1[i] = to_float(half_of(of_a, 1));
      b0[i] = to_float(near_b), b1[i] = to_float(half_of(of_b, 1));
    }
    const FloatLanes p = transpose(apart[0], apart[1], apart[2], apart[3]);
    moved = {p.lane[0], p.lane[1], p.lane[2]};
    const FloatLanes q = transpose(a0[0], a0[1], a0[2], a0[3]), r = transpose(a1[0], a1[1], a1[2], a1[3]),
                     s = transpose(b0[0], b0[1], b0[2], b0[3]), t = transpose(b1[0], b1[1], b1[2], b1[3]);
    a = {{q.lane[3], r.lane[0], r.lane[1]}, r.lane[2]};
    b = {{s.lane[3], t.lane[0], t.lane[1]}, t.lane[2]};
  }
};

}  // namespace
}  // namespace carom::dynamics
