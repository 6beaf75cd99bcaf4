// One call for n joints: read what they do, or write what drives and limits them, in float or double, at any stride.
#include <carom/joint.h>

#include <cstdio>

#include "abi/joint_fields.h"
#include "abi/joint_numbers.h"
#include "abi/record_calls.h"
#include "abi/records.h"
#include "abi/selection.h"
#include "abi/world.h"
#include "core/float_scope.h"
#include "dynamics/joint/axis_parts.h"
#include "dynamics/joint/parts.h"
#include "dynamics/joint/speeds.h"
#include "dynamics/joint/tree/joint_moves.h"
#include "dynamics/joint/turns.h"
#include "dynamics/quarantine.h"

namespace carom::abi {
namespace {

using dynamics::Joint;

/// Which kinds have a field.
enum class Kinds { any, of_one_motion, six_axis, turning, hinge_or_slider, moving };

Coordinate motion_of(JointKind kind) {
  return kind == JointKind::hinge    ? Coordinate::twist
         : kind == JointKind::slider ? Coordinate::slide
                                     : Coordinate::distance;
}
std::size_t motion_of(const Joint& joint) { return static_cast<std::size_t>(motion_of(joint.def.kind)); }

bool is_among(Kinds kinds, JointKind kind) {
  switch (kinds) {
    case Kinds::any:
      return true;
    case Kinds::of_one_motion:
      return kind == JointKind::hinge || kind == JointKind::slider || kind == JointKind::distance ||
             kind == JointKind::pulley;
    case Kinds::six_axis:
      return kind == JointKind::six_axis;
    case Kinds::turning:
      return kind == JointKind::ball || kind == JointKind::six_axis;
    case Kinds::hinge_or_slider:
      return kind == JointKind::hinge || kind == JointKind::slider;
    case Kinds::moving:
      return dynamics::JointMoves::can_move(kind);
  }
  return false;
}
constexpr const char* kNamesOfKinds[] = {"any joint",         "a hinge, slider, distance joint or pulley",
                                         "a six-axis joint",  "a ball or a six-axis joint",
                                         "a hinge or slider", "a hinge, slider, ball, universal or six-axis joint"};
constexpr const char* kRemediesOfKinds[] = {
    "",
    "list such joints alone; axes of a six-axis joint have fields AXIS_*, a ball has ORIENTATION_*",
    "list such joints alone; a hinge or slider has TARGET, MOTOR, SPRING and LIMIT",
    "list such joints alone; a hinge or slider has TARGET, MOTOR, SPRING and LIMIT",
    "list such joints alone; other joints have fields AXES and AXIS_*",
    "list such joints alone; move the bodies of others by carom_world_write()"};

/// What a field that moves bodies says.
enum class Moves : std::uint8_t { none, places, speeds };
struct MovesOf {
  Moves what;
  Kinds kinds;
};
constexpr MovesOf moves_of(std::uint32_t field) {
  switch (field) {
    case CAROM_JOINT_BULK_POSITION:
      return {Moves::places, Kinds::hinge_or_slider};
    case CAROM_JOINT_BULK_VELOCITY:
      return {Moves::speeds, Kinds::hinge_or_slider};
    case CAROM_JOINT_BULK_AXES:
      return {Moves::places, Kinds::moving};
    case CAROM_JOINT_BULK_AXIS_SPEEDS:
      return {Moves::speeds, Kinds::moving};
    default:
      return {Moves::none, Kinds::any};
  }
}
constexpr bool is_measured(std::uint32_t field) {
  return field == CAROM_JOINT_BULK_ACCELERATION || field == CAROM_JOINT_BULK_AXIS_ACCELERATIONS;
}

/// A record that a host gave, and where it stands.
struct Given {
  Call& call;
  const char* field;
  std::uint64_t joint;  // its number among those listed
  const double* record;
  int width = 1;  // of the record

  bool within(int k, double low, double high) const {
    return (record[k] >= low && record[k] <= high) || in_range(call, 6, name(k).data(), record[k], low, high);
  }
  bool all_within(int from, int to, double low, double high) const {
    for (int k = from; k < to; ++k)
      if (!within(k, low, high)) return false;
    return true;
  }
  bool is_switch(int k) const {
    return record[k] == 0 || record[k] == 1 || !within(k, 0, 1) ||
           call.fail(CAROM_E_OUT_OF_RANGE, 6, "%s is %g, must be 0 or 1", name(k).data(), record[k]);
  }
  bool is_unit() const { return unit(call, 6, name(0).data(), record, 4); }
  std::array<char, 80> name(int k) const {
    std::array<char, 80> text;
    std::snprintf(text.data(), text.size(), "number %d of %s of joint %llu", k, field,
                  static_cast<unsigned long long>(joint));
    return text;
  }
};

struct JointField {
  const char* name;
  int scalars;
  Kinds kinds;
  void (*read)(const World& world, const Joint& joint, double record[]);
  bool (*check)(const World& world, const Joint& joint, const Given& given);  // null: it is read only
  void (*write)(World& world, std::uint32_t slot, const Joint& joint, const double record[]);
};

template <class Numbers>
void put(const Numbers& numbers, double* record) {
  std::copy(numbers.begin(), numbers.end(), record);
}

std::array<double, kAxes> axes_of(const World& world, const Joint& joint) {
  const auto ends = ends_of(world, joint.def);
  return axes_at(ends, counted_angles(world, joint, ends));
}

/// What a joint bore along its one motion: what does work at the motion's rate.
double effort_of(const World& world, const Joint& joint) {
  const auto ends = ends_of(world, joint.def);
  const auto along = [&](const Vec3& way) { return way.norm() > 0 ? joint.force.dot(way) / way.norm() : 0; };
  switch (joint.def.kind) {
    case JointKind::hinge:
      return joint.torque.dot(ends.a.q * Vec3::unit_x());
    case JointKind::slider:
      return joint.force.dot(ends.a.q * Vec3::unit_x());
    case JointKind::pulley:
      return joint.transmission.ratio > 0 ? along(ropes_of(world, joint, ends).b) / joint.transmission.ratio : 0;
    default:
      return along(ends.apart);
  }
}

void read_axis_efforts(const World& world, const Joint& joint, double* record) {
  const Quat to_a = ends_of(world, joint.def).a.q.conjugate();
  from_vec3(to_a * joint.force, record), from_vec3(to_a * joint.torque, record + 3);
}

// ---- one motion: limit, motor, spring ----

const JointDrive& drive_of(const Joint& joint) { return joint.drive[motion_of(joint)]; }

void set_drive(World& world, std::uint32_t slot, const Joint& joint, const JointDrive& drive) {
  if (!(drive == drive_of(joint))) world.set_joint_drive(slot, motion_of(joint.def.kind), drive);
}
template <class Set>
void set_drive(World& world, std::uint32_t slot, const Joint& joint, const Set& set) {
  JointDrive drive = drive_of(joint);
  set(drive);
  set_drive(world, slot, joint, drive);
}

bool is_target(const Joint& joint, const Given& given, int k) {
  const CoordinateBounds b = bounds_of(static_cast<std::uint32_t>(motion_of(joint)));
  return given.within(k, b.low, b.high);
}
bool check_limit(const World&, const Joint& joint, const Given& given) {
  const CoordinateBounds b = bounds_of(static_cast<std::uint32_t>(motion_of(joint)));
  return given.is_switch(0) && given.within(1, b.low, b.high) && given.within(2, given.record[1], b.high);
}
bool check_motor(const World&, const Joint&, const Given& given) {
  return given.is_switch(0) && given.within(1, -kFastestMotor, kFastestMotor) && given.within(2, 0, kStrongestMotor);
}
bool check_spring(const World&, const Joint& joint, const Given& given) {
  return given.is_switch(0) && is_target(joint, given, 1) && given.within(2, 0, kStiffest) &&
         given.within(3, 0, kMostDamping) && given.within(4, 0, kStrongestMotor);
}
void read_limit(const World&, const Joint& joint, double* record) {
  const JointLimit& limit = drive_of(joint).limit;
  record[0] = limit.on, record[1] = limit.lower, record[2] = limit.upper;
}
void read_motor(const World&, const Joint& joint, double* record) {
  const JointMotor& motor = drive_of(joint).motor;
  record[0] = motor.on, record[1] = motor.speed, record[2] = motor.max_force;
}
void read_spring(const World&, const Joint& joint, double* record) {
  const JointSpring& s = drive_of(joint).spring;
  record[0] = s.on, record[1] = s.target, record[2] = s.frequency, record[3] = s.damping;
  record[4] = std::min(s.max_force, kStrongestMotor);
}
void write_limit(World& world, std::uint32_t slot, const Joint& joint, const double* r) {
  set_drive(world, slot, joint, [&](JointDrive& d) { d.limit = {r[0] != 0, r[1], r[2]}; });
}
void write_motor(World& world, std::uint32_t slot, const Joint& joint, const double* r) {
  set_drive(world, slot, joint, [&](JointDrive& d) { d.motor = {r[0] != 0, r[1], r[2]}; });
}
void write_spring(World& world, std::uint32_t slot, const Joint& joint, const double* r) {
  set_drive(world, slot, joint, [&](JointDrive& d) { d.spring = {r[0] != 0, r[1], r[2], r[3], r[4]}; });
}
void read_target_effort(const World&, const Joint& joint, double* record) {
  const JointMotor& motor = drive_of(joint).motor;
  *record = motor.on && std::fabs(motor.speed) == kFastestMotor ? std::copysign(motor.max_force, motor.speed) : 0;
}
void write_target_effort(World& world, std::uint32_t slot, const Joint& joint, const double* r) {
  const JointMotor motor = {true, std::copysign(kFastestMotor, *r), std::fabs(*r)};
  set_drive(world, slot, joint, [&](JointDrive& d) { d.motor = motor; });
}

// ---- axes of a six-axis joint ----

constexpr double farthest(std::uint32_t axis) { return axis < kPlaces ? kLongestJoint : kMostTurned; }

/// One number of each axis.
template <Real JointAxis::*number>
void read_axes(const World& world, const Joint& joint, double* record) {
  for (const JointAxis& a : world.joints.axes_of(joint).axis) *record++ = std::min(a.*number, kStrongestMotor);
}
/// @param set  (axis, its record)
template <class Set>
void write_axes(World& world, std::uint32_t slot, const Joint& joint, const double* record, int width, const Set& set) {
  for (std::uint32_t k = 0; k < kAxes; ++k, record += width) {
    const JointAxis& now = world.joints.axes_of(joint).axis[k];
    JointAxis axis = now;
    set(axis, record);
    if (!(axis == now)) world.set_joint_axis(slot, k, axis);
  }
}
template <Real JointAxis::*number>
void write_axes(World& world, std::uint32_t slot, const Joint& joint, const double* record) {
  write_axes(world, slot, joint, record, 1, [](JointAxis& a, const double* r) { a.*number = *r; });
}
/// What is as large as may be has no bound.
template <Real JointAxis::*number>
void write_boundless(World& world, std::uint32_t slot, const Joint& joint, const double* record) {
  write_axes(world, slot, joint, record, 1,
             [](JointAxis& a, const double* r) { a.*number = *r < kStrongestMotor ? *r : kInfinity; });
}
bool check_strengths(const World&, const Joint&, const Given& given) {
  return given.all_within(0, given.width, 0, kStrongestMotor);
}

/// Of the axis of a hinge or slider.
template <Real JointAxis::*number>
void read_own(const World& world, const Joint& joint, double* record) {
  *record = std::min(world.joints.axes_of(joint).axis[dynamics::own_axis(joint.def.kind)].*number, kStrongestMotor);
}
template <Real JointAxis::*number>
void write_own(World& world, std::uint32_t slot, const Joint& joint, const double* record) {
  const std::uint32_t k = dynamics::own_axis(joint.def.kind);
  JointAxis axis = world.joints.axes_of(joint).axis[k];
  const bool counts = number == &JointAxis::armature;  // others may be boundless
  axis.*number = counts || *record < kStrongestMotor ? *record : kInfinity;
  if (!(axis == world.joints.axes_of(joint).axis[k])) world.set_joint_axis(slot, k, axis);
}
/// The drive of that axis.
const JointAxis& own_of(const World& world, const Joint& joint) {
  return world.joints.axes_of(joint).axis[dynamics::own_axis(joint.def.kind)];
}
bool check_own_target(const World&, const Joint& joint, const Given& given) {
  const double far = farthest(dynamics::own_axis(joint.def.kind));
  return given.within(0, -far, far);
}
template <Real JointAxis::*number>
void write_own_any(World& world, std::uint32_t slot, const Joint& joint, const double* record) {
  JointAxis axis = own_of(world, joint);
  axis.*number = *record;
  if (!(axis == own_of(world, joint))) world.set_joint_axis(slot, dynamics::own_axis(joint.def.kind), axis);
}
bool check_own_gains(const World& world, const Joint& joint, const Given& given) {
  const bool rates = own_of(world, joint).gains.gains == Gains::frequency;
  return given.within(0, 0, rates ? kStiffest : kStrongestMotor) &&
         given.within(1, 0, rates ? kMostDamping : kStrongestMotor);
}
void read_own_gains(const World& world, const Joint& joint, double* record) {
  record[0] = own_of(world, joint).gains.stiffness, record[1] = own_of(world, joint).gains.damping;
}
void write_own_gains(World& world, std::uint32_t slot, const Joint& joint, const double* record) {
  JointAxis axis = own_of(world, joint);
  axis.gains.stiffness = record[0], axis.gains.damping = record[1];
  if (!(axis == own_of(world, joint))) world.set_joint_axis(slot, dynamics::own_axis(joint.def.kind), axis);
}
bool check_axis_targets(const World&, const Joint&, const Given& given) {
  return given.all_within(0, 3, -farthest(0), farthest(0)) && given.all_within(3, 6, -farthest(3), farthest(3));
}
bool check_axis_gains(const World& world, const Joint& joint, const Given& given) {
  for (std::uint32_t k = 0; k < kAxes; ++k) {
    const bool rates = world.joints.axes_of(joint).axis[k].gains.gains == Gains::frequency;
    const int at = 2 * static_cast<int>(k);
    if (!given.within(at, 0, rates ? kStiffest : kStrongestMotor) ||
        !given.within(at + 1, 0, rates ? kMostDamping : kStrongestMotor))
      return false;
  }
  return true;
}
void read_axis_gains(const World& world, const Joint& joint, double* record) {
  for (const JointAxis& a : world.joints.axes_of(joint).axis)
    *record++ = a.gains.stiffness, *record++ = a.gains.damping;
}
void write_axis_gains(World& world, std::uint32_t slot, const Joint& joint, const double* record) {
  write_axes(world, slot, joint, record, 2,
             [](JointAxis& a, const double* r) { a.gains.stiffness = r[0], a.gains.damping = r[1]; });
}
bool check_axis_limits(const World& world, const Joint& joint, const Given& given) {
  for (std::uint32_t k = 0; k < kAxes; ++k) {
    const double far = farthest(k);
    const int at = 2 * static_cast<int>(k);
    const bool ordered = world.joints.axes_of(joint).axis[k].mode == AxisMode::limited;
    if (!given.within(at, -far, far) || !given.within(at + 1, ordered ? given.record[at] : -far, far)) return false;
  }
  return true;
}
void read_axis_limits(const World& world, const Joint& joint, double* record) {
  for (const JointAxis& a : world.joints.axes_of(joint).axis) *record++ = a.lower, *record++ = a.upper;
}
void write_axis_limits(World& world, std::uint32_t slot, const Joint& joint, const double* record) {
  write_axes(world, slot, joint, record, 2, [](JointAxis& a, const double* r) { a.lower = r[0], a.upper = r[1]; });
}

// ---- the drive to an orientation ----

template <class Set>
void set_turn(World& world, std::uint32_t slot, const Joint& joint, const Set& set) {
  TurnDrive turn = joint.turn;
  set(turn);
  world.set_joint_turn(slot, turn);
}
bool check_turn_gains(const World&, const Joint& joint, const Given& given) {
  const bool rates = joint.turn.gains.gains == Gains::frequency;
  return given.within(0, 0, rates ? kStiffest : kStrongestMotor) &&
         given.within(1, 0, rates ? kMostDamping : kStrongestMotor);
}
void write_turn_target(World& world, std::uint32_t slot, const Joint& joint, const double* r) {
  const Quat to = to_quat(r);
  if (!(to == joint.turn.target)) set_turn(world, slot, joint, [&](TurnDrive& t) { t.target = to; });
}
void write_turn_velocity(World& world, std::uint32_t slot, const Joint& joint, const double* r) {
  if (to_vec3(r) != joint.turn.velocity) set_turn(world, slot, joint, [&](TurnDrive& t) { t.velocity = to_vec3(r); });
}
void write_turn_effort(World& world, std::uint32_t slot, const Joint& joint, const double* r) {
  if (to_vec3(r) != joint.turn.effort) set_turn(world, slot, joint, [&](TurnDrive& t) { t.effort = to_vec3(r); });
}
void write_turn_gains(World& world, std::uint32_t slot, const Joint& joint, const double* r) {
  if (r[0] != joint.turn.gains.stiffness || r[1] != joint.turn.gains.damping)
    set_turn(world, slot, joint, [&](TurnDrive& t) { t.gains.stiffness = r[0], t.gains.damping = r[1]; });
}

// ---- where joints are ----

/// By CAROM_AXIS_*: along or about which a hinge or slider moves.
std::size_t axis_of(const Joint& joint) { return dynamics::own_axis(joint.def.kind); }
bool check_move(const World&, const Joint&, const Given& given) {
  return given.all_within(0, given.width, -kLongestJoint, kLongestJoint);
}

using W = const World&;
using J = const Joint&;
using R = double*;

// clang-format off
constexpr JointField kBulkJointFields[CAROM_JOINT_BULK_COUNT] = {
    // in the order of CAROM_JOINT_BULK_*
    {"coordinates", 4, Kinds::any, [](W w, J j, R r) { put(place_of(w, j).at, r); }, nullptr, nullptr},
    {"speeds", 4, Kinds::any, [](W w, J j, R r) { put(speeds_of(w, j).coordinate, r); }, nullptr, nullptr},
    {"axes", 6, Kinds::any, [](W w, J j, R r) { put(axes_of(w, j), r); }, check_move, nullptr},
    {"axis_speeds", 6, Kinds::any, [](W w, J j, R r) { put(speeds_of(w, j).axis, r); }, check_move, nullptr},
    {"force", 3, Kinds::any, [](W, J j, R r) { from_vec3(j.force, r); }, nullptr, nullptr},
    {"torque", 3, Kinds::any, [](W, J j, R r) { from_vec3(j.torque, r); }, nullptr, nullptr},
    {"error", 2, Kinds::any,
     [](W w, J j, R r) {
       const dynamics::JointPlace place = place_of(w, j);
       r[0] = place.gap, r[1] = place.angle;
     }, nullptr, nullptr},
    {"broken", 1, Kinds::any, [](W, J j, R r) { *r = j.broken; }, nullptr, nullptr},
    {"position", 1, Kinds::of_one_motion, [](W w, J j, R r) { *r = place_of(w, j).at[motion_of(j)]; }, check_move, nullptr},
    {"velocity", 1, Kinds::of_one_motion, [](W w, J j, R r) { *r = speeds_of(w, j).coordinate[motion_of(j)]; }, check_move, nullptr},
    {"effort", 1, Kinds::of_one_motion, [](W w, J j, R r) { *r = effort_of(w, j); }, nullptr, nullptr},
    {"target", 1, Kinds::of_one_motion, [](W, J j, R r) { *r = drive_of(j).spring.target; },
     [](W, J j, const Given& given) { return is_target(j, given, 0); },
     [](World& w, std::uint32_t slot, J j, const double* r) {
       set_drive(w, slot, j, [&](JointDrive& d) { d.spring.target = *r; });
     }},
    {"target_velocity", 1, Kinds::of_one_motion, [](W, J j, R r) { *r = drive_of(j).motor.speed; },
     [](W, J, const Given& given) { return given.within(0, -kFastestMotor, kFastestMotor); },
     [](World& w, std::uint32_t slot, J j, const double* r) {
       set_drive(w, slot, j, [&](JointDrive& d) { d.motor.speed = *r; });
     }},
    {"target_effort", 1, Kinds::of_one_motion, read_target_effort,
     [](W, J, const Given& given) { return given.within(0, -kStrongestMotor, kStrongestMotor); }, write_target_effort},
    {"motor", 3, Kinds::of_one_motion, read_motor, check_motor, write_motor},
    {"spring", 5, Kinds::of_one_motion, read_spring, check_spring, write_spring},
    {"limit", 3, Kinds::of_one_motion, read_limit, check_limit, write_limit},
    {"axis_efforts", 6, Kinds::any, read_axis_efforts, nullptr, nullptr},
    {"axis_targets", 6, Kinds::six_axis, read_axes<&JointAxis::target>, check_axis_targets, write_axes<&JointAxis::target>},
    {"axis_target_velocities", 6, Kinds::six_axis, read_axes<&JointAxis::speed>,
     [](W, J, const Given& given) { return given.all_within(0, 6, -kFastestMotor, kFastestMotor); }, write_axes<&JointAxis::speed>},
    {"axis_target_efforts", 6, Kinds::six_axis, read_axes<&JointAxis::effort>,
     [](W, J, const Given& given) { return given.all_within(0, 6, -kStrongestMotor, kStrongestMotor); }, write_axes<&JointAxis::effort>},
    {"axis_max_forces", 6, Kinds::six_axis, read_axes<&JointAxis::max_force>, check_strengths, write_boundless<&JointAxis::max_force>},
    {"axis_gains", 12, Kinds::six_axis, read_axis_gains, check_axis_gains, write_axis_gains},
    {"axis_limits", 12, Kinds::six_axis, read_axis_limits, check_axis_limits, write_axis_limits},
    {"orientation_target", 4, Kinds::turning, [](W, J j, R r) { from_quat(j.turn.target, r); },
     [](W, J, const Given& given) { return given.is_unit(); }, write_turn_target},
    {"orientation_velocity", 3, Kinds::turning, [](W, J j, R r) { from_vec3(j.turn.velocity, r); },
     [](W, J, const Given& given) { return given.all_within(0, 3, -kFastestMotor, kFastestMotor); }, write_turn_velocity},
    {"orientation_effort", 3, Kinds::turning, [](W, J j, R r) { from_vec3(j.turn.effort, r); },
     [](W, J, const Given& given) { return given.all_within(0, 3, -kStrongestMotor, kStrongestMotor); }, write_turn_effort},
    {"orientation_gains", 2, Kinds::turning, [](W, J j, R r) { r[0] = j.turn.gains.stiffness, r[1] = j.turn.gains.damping; },
     check_turn_gains, write_turn_gains},
    {"acceleration", 1, Kinds::hinge_or_slider, [](W, J j, R r) { *r = j.acceleration[axis_of(j)]; }, nullptr, nullptr},
    {"axis_accelerations", 6, Kinds::any, [](W, J j, R r) { put(j.acceleration, r); }, nullptr, nullptr},
    {"axis_frictions", 6, Kinds::six_axis, read_axes<&JointAxis::friction>, check_strengths, write_boundless<&JointAxis::friction>},
    {"axis_armatures", 6, Kinds::six_axis, read_axes<&JointAxis::armature>, check_strengths, write_axes<&JointAxis::armature>},
    {"axis_effort_limits", 6, Kinds::six_axis, read_axes<&JointAxis::effort_limit>, check_strengths, write_boundless<&JointAxis::effort_limit>},
    {"axis_speed_limits", 6, Kinds::six_axis, read_axes<&JointAxis::speed_limit>, check_strengths, write_boundless<&JointAxis::speed_limit>},
    {"friction", 1, Kinds::hinge_or_slider, read_own<&JointAxis::friction>, check_strengths, write_own<&JointAxis::friction>},
    {"armature", 1, Kinds::hinge_or_slider, read_own<&JointAxis::armature>, check_strengths, write_own<&JointAxis::armature>},
    {"effort_limit", 1, Kinds::hinge_or_slider, read_own<&JointAxis::effort_limit>, check_strengths, write_own<&JointAxis::effort_limit>},
    {"speed_limit", 1, Kinds::hinge_or_slider, read_own<&JointAxis::speed_limit>, check_strengths, write_own<&JointAxis::speed_limit>},
    {"drive_target", 1, Kinds::hinge_or_slider, read_own<&JointAxis::target>, check_own_target, write_own_any<&JointAxis::target>},
    {"drive_velocity", 1, Kinds::hinge_or_slider, read_own<&JointAxis::speed>,
     [](W, J, const Given& given) { return given.within(0, -kFastestMotor, kFastestMotor); }, write_own_any<&JointAxis::speed>},
    {"drive_effort", 1, Kinds::hinge_or_slider, read_own<&JointAxis::effort>,
     [](W, J, const Given& given) { return given.within(0, -kStrongestMotor, kStrongestMotor); }, write_own_any<&JointAxis::effort>},
    {"drive_max_force", 1, Kinds::hinge_or_slider, read_own<&JointAxis::max_force>, check_strengths, write_own<&JointAxis::max_force>},
    {"drive_gains", 2, Kinds::hinge_or_slider, read_own_gains, check_own_gains, write_own_gains},
};
// clang-format on

constexpr Selection::Words kJoints = {"joints", "a joint of joints"};

/// What reading and writing check alike; stride 0 becomes the record's size.
bool check_data(Call& call, std::uint32_t field, std::uint32_t scalar, std::uint64_t n, const char* name,
                const void* data, std::uint64_t& stride) {
  return known(call, 2, "field", field, CAROM_JOINT_BULK_COUNT) &&
         known(call, 3, "scalar", scalar, CAROM_SCALAR_F64 + 1) && (!n || present(call, 6, name, data)) &&
         check_stride(call, 7, kBulkJointFields[field].name, kBulkJointFields[field].scalars, scalar, stride, n, 5);
}

/// @param can  "has" or what else those of the kinds can
bool have_field(Call& call, const World& world, std::uint32_t number, Kinds kinds, const char* can,
                const Selection& selection, std::uint64_t n) {
  const char* const name = kBulkJointFields[number].name;
  selection.for_each(n, [&](std::uint32_t slot, std::uint64_t i) {
    const dynamics::JointDef& def = world.joints.joint[slot].def;
    const auto of = static_cast<unsigned long long>(i);
    if (!is_among(kinds, def.kind)) {
      const auto k = static_cast<std::size_t>(kinds);
      call.fail(CAROM_E_UNSUPPORTED, 4, "joint %llu is a %s and has no %s%s; %s has", of, row_of(def.kind).name, name,
                can, kNamesOfKinds[k]);
      return call.advise(kRemediesOfKinds[k]);
    }
    if (!is_measured(number) || def.measured) return true;
    call.fail(CAROM_E_UNSUPPORTED, 4, "joint %llu does not measure its accelerations", of);
    return call.advise("create the joint with CAROM_JOINT_ACCELERATIONS in desc->fields");
  });
  return call.ok();
}

/// The number of a joint among those listed.
std::uint64_t index_of(const Selection& selection, std::uint64_t n, std::uint32_t slot) {
  std::uint64_t index = 0;
  selection.for_each(n, [&](std::uint32_t of, std::uint64_t i) {
    index = i;
    return of != slot;
  });
  return index;
}

bool say(Call& call, dynamics::MoveFault fault, std::uint64_t joint) {
  const auto i = static_cast<unsigned long long>(joint);
  using dynamics::MoveFault;
  switch (fault) {
    case MoveFault::none:
      return true;
    case MoveFault::broken:
      call.fail(CAROM_E_UNSUPPORTED, 4, "joint %llu is broken: its bodies go their own ways", i);
      return call.advise("leave broken joints out; CAROM_JOINT_BULK_BROKEN reports them");
    case MoveFault::held:
      call.fail(CAROM_E_UNSUPPORTED, 4, "neither body of joint %llu is moved by forces", i);
      return call.advise("leave the joint out, or enable its bodies; kinematic ones have poses of their own");
    case MoveFault::loop:
      call.fail(CAROM_E_UNSUPPORTED, 4, "joint %llu is part of a loop: other joints hold its bodies together, too", i);
      return call.advise(
          "leave out the joints of loops and write poses of their bodies; the world, static and kinematic bodies "
          "count as one body");
    case MoveFault::far:
      call.fail(CAROM_E_OUT_OF_RANGE, 6, "a body would be %g m from the origin, or faster than %g m/s or rad/s",
                dynamics::kMaxPosition, dynamics::kMaxSpeed);
      return call.advise("write smaller numbers");
  }
  return false;
}

dynamics::JointMove move_of(const World& world, std::uint32_t slot, const JointField& row, const double* record) {
  dynamics::JointMove move = {slot, {}};
  if (row.scalars == 1)
    move.to[axis_of(world.joints.joint[slot])] = *record;
  else
    std::copy_n(record, kAxes, move.to.begin());
  return move;
}

void load_record(std::uint32_t scalar, const void* src, std::uint64_t i, std::uint64_t stride, int scalars,
                 double record[]) {
  const char* const from = static_cast<const char*>(src) + i * stride;
  scalar == CAROM_SCALAR_F32 ? load<float>(from, scalars, record) : load<double>(from, scalars, record);
}

}  // namespace

bool have_joint_field(Call& call, const World& world, std::uint32_t field, const std::uint64_t* joints, std::uint64_t n,
                      bool writes) {
  const JointField& row = kBulkJointFields[field];
  const bool moves = writes && !row.write;
  return have_field(call, world, field, moves ? moves_of(field).kinds : row.kinds, moves ? " that can be written" : "",
                    Selection(world.joints.slots, joints, kJoints), n);
}

bool moves_joints(std::uint32_t field) { return moves_of(field).what != Moves::none; }
bool is_read_only(std::uint32_t field) { return !kBulkJointFields[field].check; }

void read_joint(const World& world, std::uint32_t field, std::uint32_t slot, double* record) {
  kBulkJointFields[field].read(world, world.joints.joint[slot], record);
}

bool check_joint(Call& call, const World& world, std::uint32_t field, std::uint32_t slot, std::uint64_t i,
                 const double* record) {
  const JointField& row = kBulkJointFields[field];
  return row.check(world, world.joints.joint[slot], {call, row.name, i, record, row.scalars});
}

bool write_joints(Call& call, World& world, std::uint32_t field, std::span<const std::uint32_t> slots,
                  const double* records, Memory* memory) {
  const JointField& row = kBulkJointFields[field];
  const auto width = static_cast<std::size_t>(row.scalars);
  if (row.write) {
    for (std::size_t i = 0; i < slots.size(); ++i)
      row.write(world, slots[i], world.joints.joint[slots[i]], records + width * i);
    return true;
  }
  dynamics::JointMoves all(memory);
  for (std::size_t i = 0; i < slots.size(); ++i) all.ask(world, move_of(world, slots[i], row, records + width * i));
  const dynamics::MoveFault fault = all.find(world, moves_of(field).what == Moves::speeds);
  const auto at = static_cast<std::uint64_t>(std::ranges::find(slots, all.joint_at_fault()) - slots.begin());
  if (!say(call, fault, at)) return false;
  world.move_joints(all);
  return true;
}

std::uint32_t joint_bulk_width(std::uint32_t field) {
  return field < CAROM_JOINT_BULK_COUNT ? static_cast<std::uint32_t>(kBulkJointFields[field].scalars) : 0;
}

}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_joint_bulk_width(uint32_t field, uint32_t* width) {
  if (!width) return CAROM_E_NULL_ARGUMENT;
  if (field >= CAROM_JOINT_BULK_COUNT) return CAROM_E_UNKNOWN_ENUM;
  *width = joint_bulk_width(field);
  return CAROM_OK;
}

int32_t carom_world_read_joints(carom_world* world, uint32_t field, uint32_t scalar, const carom_joint* joints,
                                uint64_t n, void* dst, uint64_t stride, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !check_data(call, field, scalar, n, "dst", dst, stride)) return;
    const JointField& row = kBulkJointFields[field];
    const Selection selection(reading->joints.slots, joints, kJoints);
    if (!selection.check(call, n) || !have_field(call, *reading, field, row.kinds, "", selection, n)) return;
    const FloatScope scope;
    selection.for_each(n, [&](std::uint32_t slot, std::uint64_t i) {
      double record[kMostScalars];
      row.read(*reading, reading->joints.joint[slot], record);
      char* const to = static_cast<char*>(dst) + i * stride;
      scalar == CAROM_SCALAR_F32 ? store<float>(record, row.scalars, to) : store<double>(record, row.scalars, to);
      return true;
    });
  });
}

int32_t carom_world_write_joints(carom_world* world, uint32_t field, uint32_t scalar, const carom_joint* joints,
                                 uint64_t n, const void* src, uint64_t stride, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::world_write_joints(field, scalar, joints, n, src, stride));
    if (!changing || !check_data(call, field, scalar, n, "src", src, stride)) return;
    const JointField& row = kBulkJointFields[field];
    if (!row.check) {
      call.fail(CAROM_E_UNSUPPORTED, 2, "%s of joints can be read, not written", row.name);
      call.advise(
          "fields POSITION, VELOCITY, AXES and AXIS_SPEEDS move joints; targets, motors, springs and limits are written, too");
      return;
    }
    const MovesOf moves = moves_of(field);
    const Selection selection(changing->joints.slots, joints, kJoints);
    if (!selection.check(call, n) || !have_field(call, *changing, field, row.write ? row.kinds : moves.kinds,
                                                 row.write ? "" : " that can be written", selection, n))
      return;
    const FloatScope scope;
    double record[kMostScalars];
    selection.for_each(n, [&](std::uint32_t slot, std::uint64_t i) {
      load_record(scalar, src, i, stride, row.scalars, record);
      return row.check(*changing, changing->joints.joint[slot], {call, row.name, i, record, row.scalars});
    });
    if (!call.ok()) return;
    if (!row.write) {
      dynamics::JointMoves all(&changing.engine().memory);
      selection.for_each(n, [&](std::uint32_t slot, std::uint64_t i) {
        load_record(scalar, src, i, stride, row.scalars, record);
        all.ask(*changing, move_of(*changing, slot, row, record));
        return true;
      });
      const dynamics::MoveFault fault = all.find(*changing, moves.what == Moves::speeds);
      if (say(call, fault, index_of(selection, n, all.joint_at_fault()))) changing->move_joints(all);
      return;
    }
    selection.for_each(n, [&](std::uint32_t slot, std::uint64_t i) {
      load_record(scalar, src, i, stride, row.scalars, record);
      row.write(*changing, slot, changing->joints.joint[slot], record);
      return true;
    });
  });
}

}  // extern "C"
