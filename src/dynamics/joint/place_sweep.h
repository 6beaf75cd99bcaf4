// Where joints in lanes are: arms, axes, errors. Part of joint_sweeps.h.
#pragma once

#include "core/wide_angle.h"
#include "dynamics/joint/couple_rows.h"
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

constexpr double kLaneTurn = 6.283185307179586477;  // rad, once around

/// Of all angles that differ from one by whole turns, the nearest to another. rad
CAROM_LANES_INLINE Lanes nearest_turn(Lanes angle, Lanes near) {
  constexpr double kRound = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds
  return angle + kLaneTurn * (((near - angle) * (1 / kLaneTurn) + kRound) - kRound);
}

/// rad: by how much a turn is one about an axis, of all such angles the nearest to one.
CAROM_LANES_INLINE Lanes turned_about(const LaneQuat& turn, const LaneVec& axis, Lanes near) {
  const Lanes along = turn.x * axis.x + turn.y * axis.y + turn.z * axis.z;
  const LaneMask back = turn.w < 0;
  return nearest_turn(2 * angle_of<Lanes>(back ? -along : along, back ? -turn.w : turn.w), near);
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
  CAROM_SHARED_PART JointPlacing(JointLanes& j, const BodyShift* shift, bool locked, PullLanes* of_pulley,
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

  CAROM_SHARED_PART JointRowLanes* part(JointPart which, JointRowLanes* r) const {
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
      case JointPart::across_y:
        about(*r, cross(axes_b.x, axes_a.y), dot(axes_a.y, axes_b.x));
        return r + 1;
      case JointPart::across_z:
        about(*r, cross(axes_a.z, axes_b.x), -dot(axes_a.z, axes_b.x));
        return r + 1;
      case JointPart::ropes:
        ropes(*r);
        r->error = r->error - joint.length;
        return r + 1;
      case JointPart::gears:
        gears(*r);
        return r + 1;
      case JointPart::place_x:
      case JointPart::place_y:
      case JointPart::place_z:
      case JointPart::turn_x:
      case JointPart::turn_y:
      case JointPart::turn_z:
        break;  // of six-axis joints alone, @see AxesPlacing
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
    const Lanes far_a = square_root(dot(pull->rope_a, pull->rope_a)),
                far_b = square_root(dot(pull->rope_b, pull->rope_b));
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

  CAROM_SHARED_PART void coordinate(int which, JointRowLanes& r) const {
    switch (which) {
      case 0: {  // twist: its rate is omega . (x_a + x_b) / (1 + x_a.x_b)
        const Lanes scale = 1 / larger(1 + dot(axes_a.x, axes_b.x), all(1e-3));
        return about(r, scale * (axes_a.x + axes_b.x), joint.twist);
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

/// Where an angle is taken to have been, of which a pose does not tell the whole turns. At a swing of pi a twist may be
/// any: there it is one that limits and springs ask for.
/// @param coordinate  of the rows that are told by it
/// @param any         lanes in which it may be any
CAROM_LANES_INLINE Lanes near_turn(const JointLayout& layout, const JointDriveLanes* drives, int coordinate, Lanes near,
                                   LaneMask any) {
  for (std::uint32_t k = 0; k < layout.drives; ++k)
    if (layout.drive[k].coordinate == coordinate && has_place(layout.drive[k].kind))
      near = any ? larger(smaller(near, drives[k].upper), drives[k].lower) : near;
  return near;
}

/// The twist, as counted.
CAROM_SHARED_PART void count_twist(const JointRun& run, const JointPlacing& at, int coordinate) {
  JointLanes& joint = at.joint;
  const LaneQuat t = conjugate(at.q_a) * at.q_b;
  const LaneMask back = t.w < 0;
  const Lanes angle = 2 * angle_of<Lanes>(back ? -t.x : t.x, back ? -t.w : t.w);
  const Lanes near = near_turn(joint.layout, run.drives + joint.first_drive, coordinate,
                               joint.twist + joint.twist_ahead, dot(at.axes_a.x, at.axes_b.x) < 1e-3 - 1);
  joint.twist = nearest_turn(angle, near);
  joint.twist_ahead = all(0);
}

/// @param locks  null, known when compiled: none
template <bool kTwoWays>
CAROM_LANES_INLINE void place_one(const JointRun& run, JointLanes& joint, const LockLanes* locks) {
  PullLanes* const pull = kTwoWays ? pull_of(run, joint) : nullptr;
  GearLanes* const gear = kTwoWays || !joint.geared ? nullptr : run.gears + (joint.geared - 1);
  const JointPlacing placing(joint, run.shift, locks != nullptr, pull, gear);
  if (joint.layout.counts) count_twist(run, placing, 0);
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

}  // namespace
}  // namespace carom::dynamics
