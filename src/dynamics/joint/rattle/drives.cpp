// What motors, springs, limits and friction of joints are set to, as a step begins.
#include <algorithm>

#include "dynamics/joint/axis_parts.h"
#include "dynamics/joint/rattle/rattle.h"

namespace carom::dynamics::rattle {
namespace {

void set_motor(RattleDrive& d, Real speed, Real most) {
  d.law = RattleDrive::Law::motor;
  d.speed = speed, d.most = most;
}
void set_effort(RattleDrive& d, Real effort, Real most) { d.effort = std::clamp(effort, -most, most); }
void set_limit(RattleDrive& d, Real lower, Real upper) {
  d.law = RattleDrive::Law::limit;
  d.lower = lower, d.upper = upper;
}
/// @param h  s, of a substep   @param pulls  that act on the axis
void set_pull(RattleDrive& d, const AxisPull& pull, Real h, int pulls) {
  const PullGains gains = gains_of(pull, h);
  d.per_mass = pull.gains != Gains::force;
  d.k = gains.k, d.c = gains.c;
  d.stiffest = gains.fastest * gains.fastest / pulls;
}

void set_by_mode(RattleDrive& d, AxisDrive mode, Real speed, Real effort, Real most) {
  if (mode == AxisDrive::effort)
    set_effort(d, effort, most);
  else
    set_motor(d, speed, most);
}

void read_coordinate(const JointDrive& from, RattleDrive& d, Real h) {
  switch (d.row.kind) {
    case DriveKind::motor:
      return set_motor(d, from.motor.speed, from.motor.max_force);
    case DriveKind::spring:
      set_pull(d, {Gains::frequency, from.spring.frequency, from.spring.damping}, h, 1);
      d.lower = d.upper = from.spring.target, d.most = from.spring.max_force;
      return;
    default:
      return set_limit(d, from.limit.lower, from.limit.upper);
  }
}

void read_axis(const JointAxis& a, RattleDrive& d, Real h) {
  const int pulls = pulls_on(a);
  switch (d.row.source) {
    case kOfDrive:
      if (d.row.kind == DriveKind::motor) return set_by_mode(d, a.drive, a.speed, a.effort, a.max_force);
      d.lower = d.upper = a.target, d.speed = a.speed, d.most = a.max_force;
      return set_pull(d, a.gains, h, pulls);
    case kOfSpring:
      d.lower = d.upper = a.rest;
      return set_pull(d, a.spring, h, pulls);
    case kOfFriction:
      return set_motor(d, 0, a.friction);
    default:
      if (d.row.kind == DriveKind::limit) return set_limit(d, a.lower, a.upper);
      d.lower = a.lower, d.upper = a.upper;
      return set_pull(d, a.stop, h, pulls);
  }
}

void read_turn(const TurnDrive& t, RattleDrive& d, Real h) {
  const int k = d.row.coordinate - kFirstTurn;
  if (d.row.kind == DriveKind::motor) return set_by_mode(d, t.mode, t.velocity[k], t.effort[k], t.max_force[k]);
  d.speed = t.velocity[k], d.most = t.max_force[k];
  set_pull(d, t.gains, h, 1);
}

}  // namespace

void read_drives(const World& world, Rattle& r, Real h) {
  for (const RattleJoint& j : r.joints) {
    const Joint& joint = world.joints.joint[j.slot];
    for (std::uint32_t k = j.drive; k < j.drive + j.drives; ++k) {
      RattleDrive& d = r.drives[k];
      const DriveRow row = d.row;
      d = {};
      d.row = row, d.most = kInfinity;
      if (row.coordinate < kFirstAxis)
        read_coordinate(joint.drive[row.coordinate], d, h);
      else if (row.coordinate < kFirstTurn)
        read_axis(world.joints.axes_of(joint).axis[row.coordinate - kFirstAxis], d, h);
      else
        read_turn(joint.turn, d, h);
      if (row.coordinate < kFirstAxis ? row.kind != DriveKind::limit : row.source == kOfDrive) {
        const Real most = share_of_limit(world.joints.axes_of(joint), joint, row);
        d.most = std::min(d.most, most), d.effort = std::clamp(d.effort, -most, most);
      }
      const Real p = kept_impulse(world.joints.axes_of(joint), joint, row, k - j.drive);
      d.load = joint.p_h > 0 ? p / kept_for(row.kind, joint.p_h) : 0;
    }
  }
}

}  // namespace carom::dynamics::rattle
