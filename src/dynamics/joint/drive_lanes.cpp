// Limits, motors, springs and axes of a joint into lanes and back.
#include <algorithm>
#include <numbers>
#include <utility>

#include "dynamics/joint/axis_parts.h"
#include "dynamics/joint/parts.h"
#include "dynamics/joint/speeds.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/solver/fill_lanes.h"

namespace carom::dynamics {
namespace {

constexpr Real kPushesOn = 1e30;  // m/s or rad/s: never reached, so that a motor is a force

/// N or N m: what each drive of an axis may do, of what they may do together. Where several act they share it, for their
/// bounds are known before what they do.
Real share_of_limit(const JointAxis& a, const JointDrive& own) {
  const int drives =
      (a.drive != AxisDrive::none && (a.drive != AxisDrive::position || a.gains.on())) + own.motor.on + own.spring.on;
  return a.effort_limit / std::max(1, drives);
}

/// Of a coordinate of a kind.
/// @param most  N or N m, of each of its drives
void fill_drive(const Joint& joint, const DriveRow& row, Real most, Real start_p, Real h, bool again,
                JointDriveLanes& drive, int lane) {
  const JointDrive& d = joint.drive[row.coordinate];
  drive.row.p[lane] = start_p;
  drive.lower[lane] = drive.upper[lane] = drive.speed[lane] = drive.pull[lane] = drive.drag[lane] = 0;
  drive.max_impulse[lane] = kInfinity;
  switch (row.kind) {
    case DriveKind::motor:
      drive.speed[lane] = d.motor.speed;
      drive.max_impulse[lane] = std::min(d.motor.max_force, most) * (again ? h / 2 : h);
      break;
    case DriveKind::spring: {
      const Spring spring = spring_of(d.spring.frequency, d.spring.damping, h);
      drive.lower[lane] = drive.upper[lane] = d.spring.target;
      drive.pull[lane] = spring.pull, drive.drag[lane] = spring.drag;
      drive.max_impulse[lane] = std::min(d.spring.max_force, most) * h;
      break;
    }
    case DriveKind::limit:
    case DriveKind::stop:
    case DriveKind::rotor:
    case DriveKind::pace:  // all three of axes alone
      drive.lower[lane] = d.limit.lower, drive.upper[lane] = d.limit.upper;
      break;
  }
}

void fill_motor(AxisDrive mode, Real speed, Real effort, Real max_force, Real h, JointDriveLanes& drive, int lane) {
  const bool pushes = mode == AxisDrive::effort;
  drive.speed[lane] = !pushes ? speed : effort < 0 ? -kPushesOn : kPushesOn;
  drive.max_impulse[lane] = (pushes ? std::min(std::fabs(effort), max_force) : max_force) * h;
}

void fill_spring(Real target, Real speed, Real max_force, Real h, JointDriveLanes& drive, int lane) {
  drive.lower[lane] = drive.upper[lane] = target;
  drive.speed[lane] = speed;
  drive.max_impulse[lane] = max_force * h;
}

/// @param pulls  that act on the axis
void fill_pull(const AxisPull& pull, Real h, int pulls, AxesLanes::Pull& to, int lane) {
  const PullGains gains = gains_of(pull, h);
  to.per_mass[lane] = pull.gains == Gains::force ? 0 : 1;
  to.stiffness[lane] = h * gains.k, to.damping[lane] = h * gains.c;
  to.stiffest[lane] = h * gains.fastest * gains.fastest / pulls;
}

struct RowFill {
  Real h, half;  // s: of a substep; of what acts again
  JointDriveLanes& drive;
  AxesLanes::Pull& pull;
  int lane;
  Real rotor;  // m/s or rad/s
  Real most;   // N or N m, of each drive
};

void fill_axis(const JointAxis& a, const DriveRow& row, const RowFill& to) {
  const int pulls = pulls_on(a);
  switch (row.source) {
    case kOfDrive:
      if (row.kind == DriveKind::motor)
        return fill_motor(a.drive, a.speed, a.effort, std::min(a.max_force, to.most), to.half, to.drive, to.lane);
      fill_spring(a.target, a.speed, std::min(a.max_force, to.most), to.h, to.drive, to.lane);
      return fill_pull(a.gains, to.h, pulls, to.pull, to.lane);
    case kOfSpring:
      fill_spring(a.rest, 0, kInfinity, to.h, to.drive, to.lane);
      return fill_pull(a.spring, to.h, pulls, to.pull, to.lane);
    case kOfFriction:
      return fill_motor(AxisDrive::velocity, 0, 0, a.friction, to.half, to.drive, to.lane);
    case kOfRotor:
      to.drive.speed[to.lane] = to.rotor;
      to.pull.per_mass[to.lane] = to.pull.stiffness[to.lane] = to.pull.stiffest[to.lane] = 0;
      to.pull.damping[to.lane] = a.armature;
      return;
    case kOfSpeed:
      to.drive.lower[to.lane] = -a.speed_limit * to.h, to.drive.upper[to.lane] = a.speed_limit * to.h;
      return;
    default:
      to.drive.lower[to.lane] = a.lower, to.drive.upper[to.lane] = a.upper;
      if (row.kind == DriveKind::stop) fill_pull(a.stop, to.h, pulls, to.pull, to.lane);
  }
}

void fill_turn(const TurnDrive& d, const DriveRow& row, const RowFill& to) {
  const int k = row.coordinate - kFirstTurn;
  if (row.kind == DriveKind::motor)
    return fill_motor(d.mode, d.velocity[k], d.effort[k], d.max_force[k], to.half, to.drive, to.lane);
  fill_spring(0, d.velocity[k], d.max_force[k], to.h, to.drive, to.lane);
  fill_pull(d.gains, to.h, 1, to.pull, to.lane);
}

/// m/s or rad/s: what a host does to the bodies' velocities it does to the rotor's.
Real speed_of_rotor(const World& world, const Joint& joint, const DriveRow& row) {
  const std::uint32_t axis = row.coordinate - kFirstAxis;
  return speeds_of(world, joint).axis[axis] + world.joints.axes_of(joint).p[axis][kOfRotor];
}

}  // namespace

PullGains gains_of(const AxisPull& pull, Real h) {
  constexpr Real kPi = std::numbers::pi;
  PullGains to = {pull.stiffness, pull.damping, kPi / 2 / h};
  if (pull.gains == Gains::frequency) {
    const Real w = std::min(2 * kPi * pull.stiffness, to.fastest);
    to.k = w * w, to.c = 2 * pull.damping * w;
  }
  return to;
}

int pulls_on(const JointAxis& axis) {
  const bool stops = axis.is_limited() && axis.stop.on();
  return std::max(1, (axis.drive == AxisDrive::position) + axis.spring.on() + stops);
}

Real share_of_limit(const JointAxes& axes, const Joint& joint, const DriveRow& row) {
  if (!joint.axes || row.coordinate >= kFirstTurn) return kInfinity;
  if (row.coordinate >= kFirstAxis) return share_of_limit(axes.axis[row.coordinate - kFirstAxis], own_drive(joint));
  return share_of_limit(axes.axis[own_axis(joint.def.kind)], joint.drive[row.coordinate]);
}

Real& impulse_of(JointAxes* axes, Joint& joint, const DriveRow& row, std::uint32_t k) {
  if (row.coordinate >= kFirstTurn) return joint.turn.p[row.coordinate - kFirstTurn];
  if (row.coordinate >= kFirstAxis) return axes->p[row.coordinate - kFirstAxis][row.source];
  return joint.drive_p[k];
}
Real kept_impulse(const JointAxes& axes, const Joint& joint, const DriveRow& row, std::uint32_t k) {
  if (row.kind == DriveKind::pace) return 0;
  if (row.coordinate >= kFirstTurn) return joint.turn.p[row.coordinate - kFirstTurn];
  if (row.coordinate >= kFirstAxis) return axes.p[row.coordinate - kFirstAxis][row.source];
  return joint.drive_p[k];
}

void fill_drives(const World& world, const Joint& joint, const DriveStart& start, WideJoints& w, JointLanes& lanes,
                 int lane) {
  const JointAxes& axes = world.joints.axes_of(joint);
  AxesLanes::Pull none;
  for (std::uint32_t k = 0; k < lanes.layout.drives; ++k) {
    const DriveRow& row = lanes.layout.drive[k];
    JointDriveLanes& drive = w.drives[lanes.first_drive + k];
    const Real p = start.scale * kept_impulse(axes, joint, row, k);
    if (row.coordinate < kFirstAxis) {
      fill_drive(joint, row, share_of_limit(axes, joint, row), p, start.h, start.again, drive, lane);
      continue;
    }
    drive.row.p[lane] = row.kind == DriveKind::rotor ? 0 : p;
    drive.lower[lane] = drive.upper[lane] = drive.speed[lane] = drive.pull[lane] = drive.drag[lane] = 0;
    drive.max_impulse[lane] = kInfinity;
    const RowFill to = {start.h,
                        start.again ? start.h / 2 : start.h,
                        drive,
                        lanes.axed ? w.axes[lanes.axed - 1].pull[k] : none,
                        lane,
                        row.kind == DriveKind::rotor ? speed_of_rotor(world, joint, row) : 0,
                        share_of_limit(axes, joint, row)};
    if (row.coordinate < kFirstTurn)
      fill_axis(axes.axis[row.coordinate - kFirstAxis], row, to);
    else
      fill_turn(joint.turn, row, to);
  }
}

void keep_drives(const World& world, Joints& joints, Joint& joint, const WideJoints& w, const JointLanes& lanes,
                 std::uint32_t lane) {
  JointAxes* const axes = joints.axes_of(joint);
  for (std::uint32_t k = 0; k < lanes.layout.drives; ++k) {
    const DriveRow& row = lanes.layout.drive[k];
    const JointDriveLanes& drive = w.drives[lanes.first_drive + k];
    if (row.kind == DriveKind::pace) continue;
    Real& kept = impulse_of(axes, joint, row, k);
    kept = drive.row.p[lane];
    if (row.kind != DriveKind::rotor) continue;
    const std::uint32_t axis = row.coordinate - kFirstAxis;
    kept = drive.speed[lane] - kept / axes->axis[axis].armature - speeds_of(world, joint).axis[axis];
  }
}

void fill_axes(const World& world, const Joint& joint, AxesLanes& to, JointLanes& lanes, int lane) {
  const JointAxes& axes = world.joints.axes_of(joint);
  const AxisOffsets off = offsets_of(axes);
  const JointEnds ends = ends_of(world, joint.def);
  const Vec3 moved = ends.a.q * off.place;
  set(lanes.start_a, lane, ends.arm_a + moved), set(lanes.start_gap, lane, ends.apart - moved);
  set(to.turn, lane, off.turn);
  const auto put = [&](LaneQuat& quat, const Quat& q) {
    quat.x[lane] = q.x(), quat.y[lane] = q.y(), quat.z[lane] = q.z(), quat.w[lane] = q.w();
  };
  put(to.target, joint.turn.target);
  if (off.all_turns) put(lanes.start_frame_b, ends.b.q * off.orientation.conjugate());
}

bool has_sane_impulses(Joints& joints, Joint& joint) {
  const auto finite_all = [](const auto& p) { return std::ranges::all_of(p, [](Real x) { return finite(x); }); };
  const JointAxes& axes = std::as_const(joints).axes_of(joint);
  return finite_all(joint.p) && finite_all(joint.drive_p) && joint.turn.p.all_finite() &&
         std::ranges::all_of(axes.p, finite_all) && finite(joint.transmission.phase) && joint.turned.all_finite() &&
         joint.force.all_finite() && joint.torque.all_finite();
}

void start_cold(Joints& joints, Joint& joint) {
  joints.clear_impulses(joint);
  joint.transmission.phase = finite(joint.transmission.phase) ? joint.transmission.phase : 0;
  if (!joint.turned.all_finite()) joint.turned.set_zero();
  joint.force.set_zero(), joint.torque.set_zero();
}

}  // namespace carom::dynamics
