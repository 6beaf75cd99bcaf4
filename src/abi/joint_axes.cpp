// Axes of six-axis joints, and drives to an orientation: what a host says of them, checked and handed to the world, and read back.
#include <carom/joint.h>

#include "abi/joint_numbers.h"
#include "abi/record_calls.h"
#include "dynamics/joint/parts.h"

namespace carom::abi {
namespace {

static_assert(kAxes == CAROM_AXIS_COUNT && kPlaces == CAROM_AXIS_TURN_X);
static_assert(static_cast<std::uint32_t>(AxisMode::count) == CAROM_AXIS_MODE_COUNT &&
              static_cast<std::uint32_t>(AxisMode::locked) == CAROM_AXIS_MODE_LOCKED &&
              static_cast<std::uint32_t>(AxisMode::limited) == CAROM_AXIS_MODE_LIMITED);
static_assert(static_cast<std::uint32_t>(AxisDrive::count) == CAROM_DRIVE_COUNT &&
              static_cast<std::uint32_t>(AxisDrive::position) == CAROM_DRIVE_POSITION &&
              static_cast<std::uint32_t>(AxisDrive::velocity) == CAROM_DRIVE_VELOCITY &&
              static_cast<std::uint32_t>(AxisDrive::effort) == CAROM_DRIVE_EFFORT);
static_assert(static_cast<std::uint32_t>(Gains::count) == CAROM_GAINS_COUNT &&
              static_cast<std::uint32_t>(Gains::force) == CAROM_GAINS_FORCE &&
              static_cast<std::uint32_t>(Gains::acceleration) == CAROM_GAINS_ACCELERATION);

/// A stiffness and a damping with what they are given in.
struct PullGiven {
  int argument;
  const char *gains_name, *stiffness_name, *damping_name;
  std::uint32_t gains;
  double stiffness, damping;
};
bool read_pull(Call& call, const PullGiven& g, AxisPull& to) {
  const bool rates = g.gains == CAROM_GAINS_FREQUENCY;
  if (!known(call, g.argument, g.gains_name, g.gains, CAROM_GAINS_COUNT) ||
      !in_range(call, g.argument, g.stiffness_name, g.stiffness, 0, rates ? kStiffest : kStrongestMotor) ||
      !in_range(call, g.argument, g.damping_name, g.damping, 0, rates ? kMostDamping : kStrongestMotor))
    return false;
  to = {static_cast<Gains>(g.gains), g.stiffness, g.damping};
  return true;
}

Real or_any(double most) { return most < kStrongestMotor ? most : kInfinity; }

bool has_axis(Call& call, const Joint& joint, std::uint32_t axis) {
  const JointKind kind = joint.def.kind;
  const bool has_one = kind == JointKind::hinge || kind == JointKind::slider;
  if (kind == JointKind::six_axis || (has_one && axis == dynamics::own_axis(kind))) return true;
  if (has_one) {
    call.fail(CAROM_E_UNSUPPORTED, 4, "axis %u of a %s is locked for good", axis, row_of(kind).name);
    return call.advise(kind == JointKind::hinge ? "a hinge has CAROM_AXIS_TURN_X, a six-axis joint has all"
                                                : "a slider has CAROM_AXIS_X, a six-axis joint has all");
  }
  return call.fail(
      CAROM_E_UNSUPPORTED, 4,
      "a %s joint has no axes to be set; hinges, sliders and CAROM_JOINT_SIX_AXIS have, others have limits, "
      "motors and springs",
      row_of(kind).name);
}
bool may_turn(Call& call, const Joint& joint) {
  return joint.def.kind == JointKind::six_axis || joint.def.kind == JointKind::ball ||
         call.fail(
             CAROM_E_UNSUPPORTED, 3,
             "a %s joint does not turn any way; one of CAROM_JOINT_BALL or _SIX_AXIS does, a hinge has a motor and a spring",
             row_of(joint.def.kind).name);
}

bool read_axis(Call& call, std::uint32_t axis, const carom_joint_axis* given, JointAxis& to) {
  carom_joint_axis d;
  carom_joint_axis_init(&d, sizeof d);
  const double far = axis < kPlaces ? kLongestJoint : kMostTurned;
  if (!read_struct(call, 4, "desc", given, d) || !known(call, 4, "desc->mode", d.mode, CAROM_AXIS_MODE_COUNT) ||
      !known(call, 4, "desc->drive", d.drive, CAROM_DRIVE_COUNT) ||
      !in_range(call, 4, "desc->lower", d.lower, -far, far) || !in_range(call, 4, "desc->upper", d.upper, -far, far) ||
      !in_range(call, 4, "desc->target", d.target, -far, far) || !in_range(call, 4, "desc->rest", d.rest, -far, far) ||
      !in_range(call, 4, "desc->speed", d.speed, -kFastestMotor, kFastestMotor) ||
      !in_range(call, 4, "desc->effort", d.effort, -kStrongestMotor, kStrongestMotor) ||
      !in_range(call, 4, "desc->max_force", d.max_force, 0, kStrongestMotor) ||
      !in_range(call, 4, "desc->friction", d.friction, 0, kStrongestMotor) ||
      !in_range(call, 4, "desc->armature", d.armature, 0, kStrongestMotor) ||
      !in_range(call, 4, "desc->effort_limit", d.effort_limit, 0, kStrongestMotor) ||
      !in_range(call, 4, "desc->speed_limit", d.speed_limit, 0, kStrongestMotor) ||
      !read_pull(call,
                 {4, "desc->stop_gains", "desc->stop_stiffness", "desc->stop_damping", d.stop_gains, d.stop_stiffness,
                  d.stop_damping},
                 to.stop) ||
      !read_pull(call,
                 {4, "desc->drive_gains", "desc->drive_stiffness", "desc->drive_damping", d.drive_gains,
                  d.drive_stiffness, d.drive_damping},
                 to.gains) ||
      !read_pull(call,
                 {4, "desc->spring_gains", "desc->spring_stiffness", "desc->spring_damping", d.spring_gains,
                  d.spring_stiffness, d.spring_damping},
                 to.spring))
    return false;
  if (d.mode == CAROM_AXIS_MODE_LIMITED && !in_range(call, 4, "desc->upper", d.upper, d.lower, far)) return false;
  to.mode = static_cast<AxisMode>(d.mode), to.lower = d.lower, to.upper = d.upper;
  to.drive = static_cast<AxisDrive>(d.drive), to.target = d.target, to.speed = d.speed;
  to.effort = d.effort, to.max_force = or_any(d.max_force), to.rest = d.rest;
  to.friction = or_any(d.friction), to.armature = d.armature;
  to.effort_limit = or_any(d.effort_limit), to.speed_limit = or_any(d.speed_limit);
  return true;
}

carom_joint_axis describe_axis(const JointAxis& a) {
  carom_joint_axis d{};
  d.mode = static_cast<std::uint32_t>(a.mode), d.lower = a.lower, d.upper = a.upper;
  d.drive = static_cast<std::uint32_t>(a.drive), d.target = a.target, d.speed = a.speed, d.effort = a.effort;
  d.max_force = std::min(a.max_force, kStrongestMotor), d.rest = a.rest;
  d.friction = std::min(a.friction, kStrongestMotor), d.armature = a.armature;
  d.effort_limit = std::min(a.effort_limit, kStrongestMotor), d.speed_limit = std::min(a.speed_limit, kStrongestMotor);
  const auto put = [](const AxisPull& from, std::uint32_t& gains, double& stiffness, double& damping) {
    gains = static_cast<std::uint32_t>(from.gains), stiffness = from.stiffness, damping = from.damping;
  };
  put(a.stop, d.stop_gains, d.stop_stiffness, d.stop_damping);
  put(a.gains, d.drive_gains, d.drive_stiffness, d.drive_damping);
  put(a.spring, d.spring_gains, d.spring_stiffness, d.spring_damping);
  return d;
}

bool all_in_range(Call& call, const char* const (&names)[3], const double (&v)[3], double low, double high) {
  for (int k = 0; k < 3; ++k)
    if (!in_range(call, 3, names[k], v[k], low, high)) return false;
  return true;
}

bool read_turn(Call& call, const carom_joint_orientation_drive* given, TurnDrive& to) {
  static constexpr const char* kVelocity[] = {"drive->velocity[0]", "drive->velocity[1]", "drive->velocity[2]"};
  static constexpr const char* kEffort[] = {"drive->effort[0]", "drive->effort[1]", "drive->effort[2]"};
  static constexpr const char* kMost[] = {"drive->max_force[0]", "drive->max_force[1]", "drive->max_force[2]"};
  carom_joint_orientation_drive d;
  carom_joint_orientation_drive_init(&d, sizeof d);
  if (!read_struct(call, 3, "drive", given, d) || !known(call, 3, "drive->drive", d.drive, CAROM_DRIVE_COUNT) ||
      !only_bits(call, 3, "drive->reserved", d.reserved, 0) || !unit(call, 3, "drive->target", d.target, 4) ||
      !all_in_range(call, kVelocity, d.velocity, -kFastestMotor, kFastestMotor) ||
      !all_in_range(call, kEffort, d.effort, -kStrongestMotor, kStrongestMotor) ||
      !all_in_range(call, kMost, d.max_force, 0, kStrongestMotor) ||
      !read_pull(call, {3, "drive->gains", "drive->stiffness", "drive->damping", d.gains, d.stiffness, d.damping},
                 to.gains))
    return false;
  to.mode = static_cast<AxisDrive>(d.drive);
  to.target = to_quat(d.target), to.velocity = to_vec3(d.velocity), to.effort = to_vec3(d.effort);
  to.max_force = {or_any(d.max_force[0]), or_any(d.max_force[1]), or_any(d.max_force[2])};
  return true;
}

carom_joint_orientation_drive describe_turn(const TurnDrive& t) {
  carom_joint_orientation_drive d{};
  d.drive = static_cast<std::uint32_t>(t.mode), d.gains = static_cast<std::uint32_t>(t.gains.gains);
  d.stiffness = t.gains.stiffness, d.damping = t.gains.damping;
  from_quat(t.target, d.target), from_vec3(t.velocity, d.velocity), from_vec3(t.effort, d.effort);
  for (int k = 0; k < 3; ++k) d.max_force[k] = std::min(t.max_force[k], kStrongestMotor);
  return d;
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_joint_axis_init(carom_joint_axis* axis, uint32_t struct_size) {
  return init_struct(axis, struct_size,
                     [](carom_joint_axis& d) { d.max_force = d.effort_limit = d.speed_limit = kStrongestMotor; });
}
int32_t carom_joint_orientation_drive_init(carom_joint_orientation_drive* drive, uint32_t struct_size) {
  return init_struct(drive, struct_size, [](carom_joint_orientation_drive& d) {
    d.target[3] = 1;
    d.max_force[0] = d.max_force[1] = d.max_force[2] = kStrongestMotor;
  });
}

int32_t carom_joint_set_axis(carom_world* world, carom_joint joint, uint32_t axis, const carom_joint_axis* desc,
                             carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::joint_set_axis(joint, axis, desc));
    if (!changing || !resolve_joint(call, *changing, joint)) return;
    JointAxis to;
    if (known(call, 3, "axis", axis, CAROM_AXIS_COUNT) && read_axis(call, axis, desc, to) &&
        has_axis(call, changing->joints.joint[handle_slot(joint)], axis))
      changing->set_joint_axis(handle_slot(joint), axis, to);
  });
}
int32_t carom_joint_get_axis(carom_world* world, carom_joint handle, uint32_t axis, carom_joint_axis* desc,
                             carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve_joint(call, *reading, handle)) return;
    const Joint& joint = reading->joints.joint[handle_slot(handle)];
    if (known(call, 3, "axis", axis, CAROM_AXIS_COUNT) && fillable(call, 4, "desc", desc) &&
        has_axis(call, joint, axis))
      write_struct(describe_axis(reading->joints.axes_of(joint).axis[axis]), desc);
  });
}

int32_t carom_joint_set_orientation_drive(carom_world* world, carom_joint joint,
                                          const carom_joint_orientation_drive* drive, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::joint_set_orientation_drive(joint, drive));
    if (!changing || !resolve_joint(call, *changing, joint)) return;
    TurnDrive to;
    if (read_turn(call, drive, to) && may_turn(call, changing->joints.joint[handle_slot(joint)]))
      changing->set_joint_turn(handle_slot(joint), to);
  });
}
int32_t carom_joint_get_orientation_drive(carom_world* world, carom_joint handle, carom_joint_orientation_drive* drive,
                                          carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve_joint(call, *reading, handle)) return;
    const Joint& joint = reading->joints.joint[handle_slot(handle)];
    if (fillable(call, 3, "drive", drive) && may_turn(call, joint)) write_struct(describe_turn(joint.turn), drive);
  });
}

}  // extern "C"
