// Rows of joints in lanes whose axes are told one by one. Part of joint_sweeps.h.
//
// With q = q_a^-1 q_b, B's frame in A's, q = swing * twist: the twist t turns about x, the swing about an axis across x.
// n is B's x axis in A's frame, theta = angle(x, n), f = theta / sin theta, g = (sin theta - theta cos theta) / sin^3 theta:
//   s_y = -f n_z,  s_z = f n_y;   with w the relative omega in A's frame, n' = w x n:
//   s_y' = (-f n_y, g n_z^2 + f n_x, -g n_y n_z) . w
//   s_z' = (-f n_z, -g n_y n_z, g n_y^2 + f n_x) . w
//   t'   = (x + n) . w / (1 + n_x)
// At theta = pi there is neither a twist nor a direction of the swing: rows are held short there.
#pragma once

#include "dynamics/joint/place_sweep.h"

namespace carom::dynamics {
namespace {

struct AxesPlacing : JointPlacing {
  AxesLanes& axes;
  int plane = 0;  // 1, 2: the swing is an angle about y, about z, for the other is locked at 0; 0: a rotation vector
  Lanes n_x, n_y, n_z, f, g;

  CAROM_LANES_INLINE AxesPlacing(const JointRun& run, JointLanes& j, bool locked)
      : JointPlacing(j, run.shift, locked, nullptr, nullptr), axes(run.axes[j.axed - 1]) {
    for (std::uint32_t k = 0; k < j.layout.parts; ++k)
      plane = j.layout.part[k] == JointPart::across_y ? 1 : j.layout.part[k] == JointPart::across_z ? 2 : plane;
    n_x = dot(axes_a.x, axes_b.x), n_y = dot(axes_a.y, axes_b.x), n_z = dot(axes_a.z, axes_b.x);
    const JointDriveLanes* const drives = run.drives + j.first_drive;
    if (plane != 0)
      count_in_plane();
    else
      count_vector(drives);
    axes.ahead_y = axes.ahead_z = all(0);
    if (plane == 0) count_twist(run, *this, kFirstAxis + 3);
  }

  /// The swing as an angle, and the twist about the axis that this has turned: q = (c + s e) twist.
  CAROM_LANES_INLINE void count_in_plane() {
    f = g = all(0);
    const Lanes sine = plane == 1 ? -n_z : n_y;
    Lanes& swing = plane == 1 ? axes.swing_y : axes.swing_z;
    swing = nearest_turn(angle_of<Lanes>(sine, n_x), swing + (plane == 1 ? axes.ahead_y : axes.ahead_z));
    const Lanes c = square_root(larger(0.5 + 0.5 * n_x, all(0))), side = square_root(larger(0.5 - 0.5 * n_x, all(0)));
    const Lanes s = sine < 0 ? -side : side;
    const LaneQuat t = conjugate(q_a) * q_b;
    const Lanes x = plane == 1 ? c * t.x - s * t.z : c * t.x + s * t.y;
    const Lanes w = plane == 1 ? c * t.w + s * t.y : c * t.w + s * t.z;
    const LaneMask back = w < 0;
    joint.twist = nearest_turn(2 * angle_of<Lanes>(back ? -x : x, back ? -w : w), joint.twist + joint.twist_ahead);
    joint.twist_ahead = all(0);
  }

  /// The swing as a vector: of all along one line whose lengths differ by whole turns the nearest to where it was.
  CAROM_LANES_INLINE void count_vector(const JointDriveLanes* drives) {
    const Lanes sine = square_root(n_y * n_y + n_z * n_z);
    const LaneMask apart = sine > 1e-5, straight = n_x > 0;
    const Lanes s = larger(sine, all(1e-5));
    Lanes angle = angle_of<Lanes>(sine, n_x);
    if (joint.layout.counts) {
      const LaneMask any = n_x < 1e-3 - 1;
      const Lanes near_y = near_turn(joint.layout, drives, kFirstAxis + 4, axes.swing_y + axes.ahead_y, any),
                  near_z = near_turn(joint.layout, drives, kFirstAxis + 5, axes.swing_z + axes.ahead_z, any);
      const Lanes near = (n_y * near_z - n_z * near_y) / s;
      angle = apart ? nearest_turn(angle, near) : angle;
    }
    f = apart ? angle / s : (straight ? all(1) : angle / s);
    g = apart ? (s - angle * n_x) / (s * s * s) : (straight ? all(1.0 / 3) : all(0));
    axes.swing_y = -f * n_z, axes.swing_z = f * n_y;
  }

  /// A vector of A's frame, in the world.
  CAROM_LANES_INLINE LaneVec in_world(Lanes x, Lanes y, Lanes z) const {
    return x * axes_a.x + (y * axes_a.y + z * axes_a.z);
  }

  CAROM_SHARED_PART void axis(int which, JointRowLanes& r) const {
    switch (which) {
      case 0:
        return along(r, axes_a.x, dot(axes_a.x, joint.gap));
      case 1:
        return along(r, axes_a.y, dot(axes_a.y, joint.gap));
      case 2:
        return along(r, axes_a.z, dot(axes_a.z, joint.gap));
      case 3:
        if (plane != 0) return about(r, axes_b.x, joint.twist);
        return coordinate(0, r);
      case 4:
        if (plane == 1) return about(r, axes_a.y, axes.swing_y);
        return about(r, in_world(-f * n_y, g * n_z * n_z + f * n_x, -g * n_y * n_z), axes.swing_y);
      default:
        if (plane == 2) return about(r, axes_a.z, axes.swing_z);
        return about(r, in_world(-f * n_z, -g * n_y * n_z, g * n_y * n_y + f * n_x), axes.swing_z);
    }
  }

  /// A turn that is locked alone, by the nearer way.
  CAROM_LANES_INLINE void turn(int which, JointRowLanes& r) const {
    axis(3 + which, r);
    r.error = nearest_turn(r.error - (which == 0 ? axes.turn.x : which == 1 ? axes.turn.y : axes.turn.z), all(0));
  }

  CAROM_LANES_INLINE JointRowLanes* lock(JointPart which, JointRowLanes* r) const {
    switch (which) {
      case JointPart::place_x:
        return axis(0, *r), r + 1;
      case JointPart::place_y:
        return axis(1, *r), r + 1;
      case JointPart::place_z:
        return axis(2, *r), r + 1;
      case JointPart::turn_x:
        return turn(0, *r), r + 1;
      case JointPart::turn_y:
        return turn(1, *r), r + 1;
      case JointPart::turn_z:
        return turn(2, *r), r + 1;
      case JointPart::point:
      case JointPart::line:
      case JointPart::rod:
      case JointPart::orientation:
      case JointPart::direction:
      case JointPart::pins:
      case JointPart::ropes:
      case JointPart::gears:
      case JointPart::across_y:
      case JointPart::across_z:
        break;
    }
    return part(which, r);
  }

  /// What is left of a turn to an orientation, about A's axes: the rotation vector of the shortest turn from there to here.
  CAROM_LANES_INLINE void to_target(JointRowLanes* const (&r)[3]) const {
    const LaneQuat off = (conjugate(q_a) * q_b) * conjugate(axes.target);
    const LaneMask back = off.w < 0;
    const Lanes sine = square_root(off.x * off.x + off.y * off.y + off.z * off.z);
    const LaneMask apart = sine > 1e-12;
    const Lanes long_way = 2 * angle_of<Lanes>(sine, back ? -off.w : off.w) / (apart ? sine : all(1));
    const Lanes scale = (back ? all(-1) : all(1)) * (apart ? long_way : all(2));
    about(*r[0], axes_a.x, scale * off.x);
    about(*r[1], axes_a.y, scale * off.y);
    about(*r[2], axes_a.z, scale * off.z);
  }
};

/// What a spring's or a stop's coefficients are at the row's mass, @see spring_of().
CAROM_LANES_INLINE void find_pull(const AxesLanes::Pull& of, JointDriveLanes& drive) {
  const LaneMask per_mass = of.per_mass > 0;
  const Lanes unit = per_mass ? drive.m : all(1);
  const Lanes stiff = smaller(unit * of.stiffness, drive.m * of.stiffest), drags = unit * of.damping;
  const Lanes inverse = inverse_or_zero(drive.m + drags);
  drive.pull = stiff * inverse;
  drive.drag = drags * inverse;
}

/// A rotor has what it gave its axis the other way round: its speed goes on from substep to substep.
CAROM_LANES_INLINE void turn_rotor(JointDriveLanes& drive) {
  drive.speed -= drive.row.p * (1 - drive.drag) * inverse_or_zero(drive.drag * drive.m);
  drive.row.p = all(0);
}

void place_axes(const JointRun& run, JointLanes& joint) {
  const LockLanes* const locks = locks_of(run, joint);
  const AxesLanes& axes = run.axes[joint.axed - 1];
  const AxesPlacing placing(run, joint, locks != nullptr);
  JointRowLanes* const rows = run.rows + joint.first;
  JointRowLanes* next = rows;
  for (std::uint32_t k = 0; k < joint.layout.parts; ++k) next = placing.lock(joint.layout.part[k], next);
  factor_rows<false>(joint, locks, nullptr, rows);
  JointDriveLanes* const drives = run.drives + joint.first_drive;
  for (std::uint32_t k = 0; k < joint.layout.drives; ++k) {
    const int c = joint.layout.drive[k].coordinate;
    if (c == kFirstTurn)
      placing.to_target({&drives[k].row, &drives[k + 1].row, &drives[k + 2].row});
    else if (c < kFirstAxis)
      placing.coordinate(c, drives[k].row);
    else if (c < kFirstTurn)
      placing.axis(c - kFirstAxis, drives[k].row);
    if (joint.layout.drive[k].kind == DriveKind::rotor) turn_rotor(drives[k]);
    if (joint.layout.drive[k].kind == DriveKind::pace) drives[k].row.error = all(0);
    weigh<false>(joint, locks, nullptr, rows, drives[k]);
    if (acts_once(joint.layout.drive[k].kind) && c >= kFirstAxis) find_pull(axes.pull[k], drives[k]);
  }
}

void place(const JointRun& run) {
  for (std::size_t i = 0; i < run.count; ++i) {
    JointLanes& joint = run.joints[i];
    if (joint.axed)
      place_axes(run, joint);
    else if (joint.pulled)
      place_one<true>(run, joint, locks_of(run, joint));
    else if (joint.locked)
      place_one<false>(run, joint, run.locks + (joint.locked - 1));
    else
      place_one<false>(run, joint, nullptr);
  }
}

}  // namespace
}  // namespace carom::dynamics
