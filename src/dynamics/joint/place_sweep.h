// Where joints in lanes are: arms, axes, errors, and how their rows are coupled. Part of joint_sweeps.h.
#pragma once

#include "core/wide_angle.h"
#include "dynamics/joint/joint_kernels.h"
#include "dynamics/solver/lane_sides.h"

namespace carom::dynamics {
namespace {

CAROM_LANES_INLINE LaneQuat operator*(const LaneQuat& a, const LaneQuat& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
          a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}
CAROM_LANES_INLINE LaneQuat conjugate(const LaneQuat& q) { return {-q.x, -q.y, -q.z, q.w}; }

/// The axes of a frame.
struct LaneAxes {
  LaneVec x, y, z;
  CAROM_LANES_INLINE explicit LaneAxes(const LaneQuat& q) {
    const Lanes xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z, xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z,
                wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
    x = {1 - 2 * (yy + zz), 2 * (xy + wz), 2 * (xz - wy)};
    y = {2 * (xy - wz), 1 - 2 * (xx + zz), 2 * (yz + wx)};
    z = {2 * (xz + wy), 2 * (yz - wx), 1 - 2 * (xx + yy)};
  }
};

/// How far the four bodies on one side have come.
struct JointShift {
  LaneVec x;
  LaneQuat turn;

  CAROM_LANES_INLINE JointShift(const BodyShift* all_bodies, const std::uint32_t* body) {
    const BodyRows rows(all_bodies, body);
    const LanePair p = rows.two(0), q = rows.two(2), r = rows.two(4), s = rows.two(6);
    x = {p.first, p.second, q.first};
    turn = {q.second, r.first, r.second, s.first};
  }
  /// What the turn does to an arm.
  CAROM_LANES_INLINE LaneVec change(const LaneVec& arm) const {
    const LaneVec u = {turn.x, turn.y, turn.z}, t = cross(u, arm);
    return all(2) * (cross(u, t) + turn.w * t);
  }
  /// A tensor of the body, as it has turned.
  CAROM_LANES_INLINE LaneSymmetric turned(const LaneSymmetric& m) const {
    const LaneAxes r(turn);  // columns
    const LaneVec row_x = {r.x.x, r.y.x, r.z.x}, row_y = {r.x.y, r.y.y, r.z.y}, row_z = {r.x.z, r.y.z, r.z.z};
    const LaneVec mx = m * row_x, my = m * row_y, mz = m * row_z;
    return {dot(row_x, mx), dot(row_x, my), dot(row_x, mz), dot(row_y, my), dot(row_y, mz), dot(row_z, mz)};
  }
};

/// x <- K^-1 x.
template <int n>
CAROM_LANES_INLINE void solve_coupled(const Lanes* factor, Lanes* x) {
  for (int k = 1; k < n; ++k)
    for (int l = 0; l < k; ++l) x[k] -= factor[k * (k + 1) / 2 + l] * x[l];
  for (int k = n - 1; k >= 0; --k) {
    x[k] = x[k] * factor[k * (k + 1) / 2 + k];
    for (int l = k + 1; l < n; ++l) x[k] -= factor[l * (l + 1) / 2 + k] * x[l];
  }
}

/// rad: by how much a turn is one about an axis, of all such angles the nearest to one.
CAROM_LANES_INLINE Lanes turned_about(const LaneQuat& turn, const LaneVec& axis, Lanes near) {
  const Lanes along = turn.x * axis.x + turn.y * axis.y + turn.z * axis.z;
  const LaneMask back = turn.w < 0;
  const Lanes angle = 2 * angle_of<Lanes>(back ? -along : along, back ? -turn.w : turn.w);
  constexpr double kTurn = 6.283185307179586477, kRound = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds
  const Lanes turns = ((near - angle) * (1 / kTurn) + kRound) - kRound;
  return angle + kTurn * turns;
}

/// The inverse of what is left of a number, or 0 where that is but rounding: a row that others imply bears nothing.
CAROM_LANES_INLINE Lanes inverse_of_rest(Lanes rest, Lanes whole) {
  return inverse_or_zero(rest > 1e-11 * whole ? rest : all(0));
}

/// A joint at the present poses; writes its rows.
struct JointPlacing {
  JointLanes& joint;
  JointShift a, b;
  LaneQuat q_a, q_b;
  LaneAxes axes_a, axes_b;
  PullLanes* pull;  // of a pulley; else null
  GearLanes* gear;  // of a gear; else null

  /// @param locked  some of the bodies are
  CAROM_LANES_INLINE JointPlacing(JointLanes& j, const BodyShift* shift, bool locked, PullLanes* of_pulley,
                                  GearLanes* of_gear)
      : joint(j),
        a(shift, j.a),
        b(shift, j.b),
        q_a(a.turn * j.start_frame_a),
        q_b(b.turn * j.start_frame_b),
        axes_a(q_a),
        axes_b(q_b),
        pull(of_pulley),
        gear(of_gear) {
    const LaneVec d_a = a.change(j.start_a), d_b = b.change(j.start_b);
    j.r_a = j.start_a + d_a;
    j.r_b = j.start_b + d_b;
    j.gap = j.start_gap + ((b.x - a.x) + (d_b - d_a));
    j.x_a = axes_a.x;
    j.inv_inertia_a = locked ? turned_within(a, j.start_inertia_a) : a.turned(j.start_inertia_a);
    j.inv_inertia_b = locked ? turned_within(b, j.start_inertia_b) : b.turned(j.start_inertia_b);
    if (pull) {
      pull->rope_a = pull->start_rope_a + (a.x + d_a);
      pull->rope_b = pull->start_rope_b + (b.x + d_b);
    }
  }

  /// What is locked stays so in world axes: who cannot turn about one of them has nothing in its corner of the tensor.
  CAROM_LANES_INLINE static LaneSymmetric turned_within(const JointShift& shift, const LaneSymmetric& start) {
    const LaneSymmetric now = shift.turned(start);
    const LaneMask free = smaller(smaller(start.xx, start.yy), start.zz) > 0;
    return {free ? now.xx : start.xx, free ? now.xy : start.xy, free ? now.xz : start.xz,
            free ? now.yy : start.yy, free ? now.yz : start.yz, free ? now.zz : start.zz};
  }

  /// A row along a direction, of which A's point is where B's is now: the direction turns with A.
  CAROM_LANES_INLINE void along(JointRowLanes& r, const LaneVec& d, Lanes error) const {
    r.d = d;
    r.w_a = cross(joint.r_a + joint.gap, d);
    r.w_b = cross(joint.r_b, d);
    r.error = error;
    r.curve = all(0);
  }
  CAROM_LANES_INLINE void about(JointRowLanes& r, const LaneVec& axis, Lanes error) const {
    r.d = {all(0), all(0), all(0)};
    r.w_a = r.w_b = axis;
    r.error = error;
    r.curve = all(0);
  }

  CAROM_LANES_INLINE JointRowLanes* part(JointPart which, JointRowLanes* r) const {
    switch (which) {
      case JointPart::point: {
        const LaneVec e[3] = {{all(1), all(0), all(0)}, {all(0), all(1), all(0)}, {all(0), all(0), all(1)}};
        const Lanes gap[3] = {joint.gap.x, joint.gap.y, joint.gap.z};
        const LaneVec half = all(0.5) * joint.gap;  // impulses act at one place, halfway: else a gap has a moment
        for (int k = 0; k < 3; ++k) {
          r[k].d = e[k];
          r[k].w_a = cross(joint.r_a + half, e[k]);
          r[k].w_b = cross(joint.r_b - half, e[k]);
          r[k].error = gap[k];
          r[k].curve = all(0);
        }
        return r + 3;
      }
      case JointPart::line:
        along(r[0], axes_a.y, dot(axes_a.y, joint.gap));
        along(r[1], axes_a.z, dot(axes_a.z, joint.gap));
        return r + 2;
      case JointPart::rod:
        distance(*r);
        r->error = r->error - joint.length;
        return r + 1;
      case JointPart::orientation: {
        const LaneQuat t = q_b * conjugate(q_a);
        const Lanes two = t.w < 0 ? all(-2) : all(2);
        about(r[0], {all(1), all(0), all(0)}, two * t.x);
        about(r[1], {all(0), all(1), all(0)}, two * t.y);
        about(r[2], {all(0), all(0), all(1)}, two * t.z);
        return r + 3;
      }
      case JointPart::direction: {
        const LaneVec turn = cross(axes_a.x, axes_b.x);
        about(r[0], axes_a.y, dot(axes_a.y, turn));
        about(r[1], axes_a.z, dot(axes_a.z, turn));
        return r + 2;
      }
      case JointPart::pins:
        about(*r, cross(axes_b.z, axes_a.y), dot(axes_a.y, axes_b.z));
        return r + 1;
      case JointPart::ropes:
        ropes(*r);
        r->error = r->error - joint.length;
        return r + 1;
      case JointPart::gears:
        gears(*r);
        return r + 1;
    }
    return r;
  }

  /// About both axes at once: the rate of angle a + ratio * angle b. What turns about an axis that itself turns is told by
  /// the mean of that axis before and after, as a twist is.
  CAROM_LANES_INLINE void gears(JointRowLanes& r) const {
    const LaneVec from_a = LaneAxes(joint.start_frame_a).x, from_b = LaneAxes(joint.start_frame_b).x;
    gear->turned_a = turned_about(a.turn, from_a, gear->turned_a + gear->ahead_a);
    gear->turned_b = turned_about(b.turn, from_b, gear->turned_b + gear->ahead_b);
    gear->ahead_a = gear->ahead_b = all(0);
    const auto mean = [](const LaneVec& before, const LaneVec& now) __attribute__((always_inline)) {
      return (1 / larger(1 + dot(before, now), all(1e-3))) * (before + now);
    };
    r.d = {all(0), all(0), all(0)};
    r.w_a = all(-1) * mean(from_a, axes_a.x);
    r.w_b = gear->ratio * mean(from_b, axes_b.x);
    r.error = gear->phase + gear->turned_a + gear->ratio * gear->turned_b;
    r.curve = all(0);
  }

  /// Along both ropes at once: the rate of |rope_a| + ratio |rope_b|. A rope of no length pulls nowhere.
  CAROM_LANES_INLINE void ropes(JointRowLanes& r) const {
    const Lanes far_a = square_root(dot(pull->rope_a, pull->rope_a)), far_b = square_root(dot(pull->rope_b, pull->rope_b));
    pull->d_a = -inverse_or_zero(far_a > 1e-12 ? far_a : all(0)) * pull->rope_a;
    r.d = pull->ratio * inverse_or_zero(far_b > 1e-12 ? far_b : all(0)) * pull->rope_b;
    r.w_a = cross(joint.r_a, pull->d_a);
    r.w_b = cross(joint.r_b, r.d);
    r.error = far_a + pull->ratio * far_b;
    r.curve = all(0);
  }

  CAROM_LANES_INLINE void distance(JointRowLanes& r) const {
    const Lanes far = square_root(dot(joint.gap, joint.gap));
    const LaneMask apart = far > 1e-12;
    const Lanes inverse = 1 / (apart ? far : all(1));
    const LaneVec d = inverse * joint.gap;
    along(r, {apart ? d.x : axes_a.x.x, apart ? d.y : axes_a.x.y, apart ? d.z : axes_a.x.z}, far);
  }

  CAROM_LANES_INLINE void coordinate(int which, JointRowLanes& r) const {
    switch (which) {
      case 0: {  // twist: its rate is omega . (x_a + x_b) / (1 + x_a.x_b)
        const LaneQuat t = conjugate(q_a) * q_b;
        const LaneMask back = t.w < 0;
        const Lanes angle = 2 * angle_of<Lanes>(back ? -t.x : t.x, back ? -t.w : t.w);
        const Lanes scale = 1 / larger(1 + dot(axes_a.x, axes_b.x), all(1e-3));
        return about(r, scale * (axes_a.x + axes_b.x), angle);
      }
      case 1: {  // swing
        const LaneVec c = cross(axes_a.x, axes_b.x);
        const Lanes sine = square_root(dot(c, c));
        const LaneMask apart = sine > 1e-12;
        const Lanes inverse = 1 / (apart ? sine : all(1));
        const LaneVec n = {apart ? inverse * c.x : axes_a.y.x, apart ? inverse * c.y : axes_a.y.y,
                           apart ? inverse * c.z : axes_a.y.z};
        return about(r, n, angle_of<Lanes>(sine, dot(axes_a.x, axes_b.x)));
      }
      case 2:
        return along(r, axes_a.x, dot(axes_a.x, joint.gap));
      default:
        return pull ? ropes(r) : distance(r);
    }
  }
};

/// Velocity at one row per impulse at another.
/// @tparam kTwoWays  A is pulled another way than B
template <bool kTwoWays>
struct RowResponse {
  LaneVec d, i_a, i_b;  // of the impulse, over the masses
  Lanes at_a;           // of two ways: what the impulse does at A, along the way all rows have there
  CAROM_LANES_INLINE void set(const JointLanes& joint, const LockLanes* locks, const JointRowLanes& r,
                              const PullLanes* pull) {
    if constexpr (kTwoWays) {
      d = joint.inv_mass_b * (locks ? each(locks->free_b, r.d) : r.d);
      at_a = joint.inv_mass_a * dot(locks ? each(locks->free_a, pull->d_a) : pull->d_a, pull->d_a);
    } else {
      d = locks ? each(joint.inv_mass_a * locks->free_a + joint.inv_mass_b * locks->free_b, r.d)
                : (joint.inv_mass_a + joint.inv_mass_b) * r.d;
    }
    i_a = joint.inv_inertia_a * r.w_a;
    i_b = joint.inv_inertia_b * r.w_b;
  }
  CAROM_LANES_INLINE Lanes at(const JointRowLanes& r) const {
    const Lanes rest = dot(d, r.d) + (dot(i_a, r.w_a) + dot(i_b, r.w_b));
    if constexpr (kTwoWays) return at_a + rest;
    return rest;
  }
};

CAROM_LANES_INLINE PullLanes* pull_of(const JointRun& run, const JointLanes& joint) {
  return joint.pulled ? run.pulls + (joint.pulled - 1) : nullptr;
}

CAROM_LANES_INLINE const LockLanes* locks_of(const JointRun& run, const JointLanes& joint) {
  return joint.locked ? run.locks + (joint.locked - 1) : nullptr;
}

/// What a row's response is measured by: of its own size, but where bodies are locked of what it would be if they were
/// not, to within the unlikeness of a body's moments: what is left of a locked direction is rounding.
template <bool kTwoWays>
CAROM_LANES_INLINE Lanes whole_of(const JointLanes& joint, const LockLanes* locks, const JointRowLanes& r,
                                  const PullLanes* pull, Lanes own) {
  if (!locks) return own;
  const LaneSymmetric &i_a = joint.inv_inertia_a, &i_b = joint.inv_inertia_b;
  Lanes moved = (joint.inv_mass_a + joint.inv_mass_b) * dot(r.d, r.d);
  if constexpr (kTwoWays) moved = joint.inv_mass_a * dot(pull->d_a, pull->d_a) + joint.inv_mass_b * dot(r.d, r.d);
  return 1e2 * (moved + dot(r.w_a, r.w_a) * (i_a.xx + i_a.yy + i_a.zz) + dot(r.w_b, r.w_b) * (i_b.xx + i_b.yy + i_b.zz));
}

/// L D L^T of the coupling of n rows.
template <bool kTwoWays>
CAROM_LANES_INLINE void factor_rows(JointLanes& joint, const LockLanes* locks, const PullLanes* pull,
                                    const JointRowLanes* rows) {
  const int n = static_cast<int>(joint.layout.equalities);
  Lanes* const f = joint.factor;
  for (int k = 0; k < n; ++k) {
    RowResponse<kTwoWays> response;
    response.set(joint, locks, rows[k], pull);
    Lanes v[kMostRows];
    Lanes* const row = f + k * (k + 1) / 2;
    const Lanes own = response.at(rows[k]), whole = whole_of<kTwoWays>(joint, locks, rows[k], pull, own);
    Lanes rest = own;
    for (int l = 0; l < k; ++l) {
      v[l] = response.at(rows[l]);
      const Lanes* const other = f + l * (l + 1) / 2;
      for (int m = 0; m < l; ++m) v[l] -= other[m] * v[m];
      row[l] = v[l] * other[l];
    }
    for (int l = 0; l < k; ++l) rest -= row[l] * v[l];
    row[k] = inverse_of_rest(rest, whole);
  }
}

CAROM_LANES_INLINE void solve_any(const JointLanes& joint, Lanes* x) {
  switch (joint.layout.equalities) {
    case 1:
      return solve_coupled<1>(joint.factor, x);
    case 2:
      return solve_coupled<2>(joint.factor, x);
    case 3:
      return solve_coupled<3>(joint.factor, x);
    case 4:
      return solve_coupled<4>(joint.factor, x);
    case 5:
      return solve_coupled<5>(joint.factor, x);
    case 6:
      return solve_coupled<6>(joint.factor, x);
    default:
      return;
  }
}

/// Effective mass of a drive, what is locked staying so.
template <bool kTwoWays>
CAROM_LANES_INLINE void weigh(const JointLanes& joint, const LockLanes* locks, const PullLanes* pull,
                              const JointRowLanes* rows, JointDriveLanes& drive) {
  RowResponse<kTwoWays> response;
  response.set(joint, locks, drive.row, pull);
  Lanes coupled[kMostRows], x[kMostRows];
  const int n = static_cast<int>(joint.layout.equalities);
  for (int k = 0; k < n; ++k) x[k] = coupled[k] = response.at(rows[k]);
  solve_any(joint, x);
  const Lanes own = response.at(drive.row);
  Lanes rest = own;
  for (int k = 0; k < n; ++k) rest -= coupled[k] * x[k];
  drive.m = inverse_of_rest(rest, whole_of<kTwoWays>(joint, locks, drive.row, pull, own));
}

/// @param locks  null, known when compiled: none
template <bool kTwoWays>
CAROM_LANES_INLINE void place_one(const JointRun& run, JointLanes& joint, const LockLanes* locks) {
  PullLanes* const pull = kTwoWays ? pull_of(run, joint) : nullptr;
  GearLanes* const gear = kTwoWays || !joint.geared ? nullptr : run.gears + (joint.geared - 1);
  const JointPlacing placing(joint, run.shift, locks != nullptr, pull, gear);
  JointRowLanes* const rows = run.rows + joint.first;
  JointRowLanes* next = rows;
  for (std::uint32_t k = 0; k < joint.layout.parts; ++k) next = placing.part(joint.layout.part[k], next);
  factor_rows<kTwoWays>(joint, locks, pull, rows);
  for (std::uint32_t k = 0; k < joint.layout.drives; ++k) {
    JointDriveLanes& drive = run.drives[joint.first_drive + k];
    placing.coordinate(joint.layout.drive[k].coordinate, drive.row);
    weigh<kTwoWays>(joint, locks, pull, rows, drive);
  }
}

void place(const JointRun& run) {
  for (std::size_t i = 0; i < run.count; ++i) {
    JointLanes& joint = run.joints[i];
    if (joint.pulled)
      place_one<true>(run, joint, locks_of(run, joint));
    else if (joint.locked)
      place_one<false>(run, joint, run.locks + (joint.locked - 1));
    else
      place_one<false>(run, joint, nullptr);
  }
}

/// m/s^2: how the length of a rope bends, its far end being that of an arm.
CAROM_LANES_INLINE Lanes rope_bend(const JointRun& run, const std::uint32_t* body, const Side& side, const LaneVec& arm,
                                   const LaneVec& rope) {
  const LaneVec turns = cross(side.omega, arm), moves = side.v + turns;
  LaneVec inward = cross(side.omega, turns);
  if (run.gyro) {
    Side gyro;
    gyro.load(run.gyro, body);
    inward = inward - cross(gyro.omega, arm);
  }
  const Lanes far = square_root(dot(rope, rope)), inverse = inverse_or_zero(far > 1e-9 ? far : all(0));
  const Lanes out = inverse * dot(rope, moves);
  return (dot(moves, moves) - out * out) * inverse + inverse * dot(rope, inward);
}

// With g the gap and d a direction that turns with A,
//   (d.g)'' = d''.g + 2 d'.g' + d.g'',   d' = w_a x d,
//   g'' = w_b x (w_b x r_b) - a_b x r_b - (w_a x (w_a x r_a) - a_a x r_a);
// for a distance |g|'' = (g'^2 - (d.g')^2) / |g| + d.g''. Angles are taken to be straight. a is how omega changes while
// nothing acts: what a rotation method carries is turned by the mean of its omega before and after, which is the one
// after, w, less h a / 2.
void bend(const JointRun& run, double h) {
  for (std::size_t i = 0; i < run.count; ++i) {
    const JointLanes& joint = run.joints[i];
    Side a, b;
    a.load(run.velocity, joint.a), b.load(run.velocity, joint.b);
    const LaneVec turns_a = cross(a.omega, joint.r_a), turns_b = cross(b.omega, joint.r_b);
    LaneVec inward = cross(b.omega, turns_b) - cross(a.omega, turns_a);
    if (run.gyro) {
      Side gyro_a, gyro_b;
      gyro_a.load(run.gyro, joint.a), gyro_b.load(run.gyro, joint.b);
      inward = inward - (cross(gyro_b.omega, joint.r_b) - cross(gyro_a.omega, joint.r_a));
    }
    // Beyond a radian a substep nothing is straight nor bends like a parabola: then less is asked for, not more.
    const Lanes half = (h / 2) / (1 + (h * h / 4) * (dot(a.omega, a.omega) + dot(b.omega, b.omega)));
    JointRowLanes* r = run.rows + joint.first;
    for (std::uint32_t k = 0; k < joint.layout.parts; ++k) {
      const LaneVec parting = (b.v + turns_b) - (a.v + turns_a);
      switch (joint.layout.part[k]) {
        case JointPart::point:
          r[0].curve = half * inward.x;
          r[1].curve = half * inward.y;
          r[2].curve = half * inward.z;
          r += 3;
          break;
        case JointPart::line:
          for (int l = 0; l < 2; ++l, ++r) {
            const LaneVec d1 = cross(a.omega, r->d), d2 = cross(a.omega, d1);
            r->curve = half * (dot(d2, joint.gap) + 2 * dot(d1, parting) + dot(r->d, inward));
          }
          break;
        case JointPart::rod: {
          const Lanes closing = dot(r->d, parting), far = r->error + joint.length;
          const Lanes across = dot(parting, parting) - closing * closing;
          r->curve = half * (across * inverse_or_zero(far > 1e-9 ? far : all(0)) + dot(r->d, inward));
          r += 1;
          break;
        }
        case JointPart::orientation:
          r += 3;
          break;
        case JointPart::direction:
          r += 2;
          break;
        case JointPart::pins:
          r += 1;
          break;
        case JointPart::ropes: {
          const PullLanes& pull = *pull_of(run, joint);
          r->curve = half * (rope_bend(run, joint.a, a, joint.r_a, pull.rope_a) +
                             pull.ratio * rope_bend(run, joint.b, b, joint.r_b, pull.rope_b));
          r += 1;
          break;
        }
        case JointPart::gears: {
          GearLanes& gear = run.gears[joint.geared - 1];
          gear.ahead_a = -h * dot(r->w_a, a.omega);
          gear.ahead_b = (h / gear.ratio) * dot(r->w_b, b.omega);
          r += 1;
          break;
        }
      }
    }
  }
}

}  // namespace
}  // namespace carom::dynamics
