// Joints: what a host says about one, checked and handed to the world, and read back.
#include <carom/joint.h>

#include <array>
#include <cstdio>

#include "abi/ends.h"
#include "abi/joint_numbers.h"
#include "abi/record_calls.h"
#include "abi/world.h"
#include "core/float_scope.h"
#include "dynamics/joint/axis_parts.h"
#include "dynamics/joint/parts.h"
#include "dynamics/quarantine.h"

namespace carom::abi {
namespace {

static_assert(static_cast<std::uint32_t>(JointKind::count) == CAROM_JOINT_COUNT &&
              static_cast<std::uint32_t>(JointKind::ball) == CAROM_JOINT_BALL &&
              static_cast<std::uint32_t>(JointKind::hinge) == CAROM_JOINT_HINGE &&
              static_cast<std::uint32_t>(JointKind::slider) == CAROM_JOINT_SLIDER &&
              static_cast<std::uint32_t>(JointKind::weld) == CAROM_JOINT_WELD &&
              static_cast<std::uint32_t>(JointKind::distance) == CAROM_JOINT_DISTANCE &&
              static_cast<std::uint32_t>(JointKind::universal) == CAROM_JOINT_UNIVERSAL &&
              static_cast<std::uint32_t>(JointKind::pulley) == CAROM_JOINT_PULLEY &&
              static_cast<std::uint32_t>(JointKind::gear) == CAROM_JOINT_GEAR &&
              static_cast<std::uint32_t>(JointKind::six_axis) == CAROM_JOINT_SIX_AXIS &&
              static_cast<std::uint32_t>(JointKind::coupling) == CAROM_JOINT_COUPLING);
static_assert(kCoordinates == CAROM_COORDINATE_COUNT &&
              static_cast<std::uint32_t>(Coordinate::twist) == CAROM_COORDINATE_TWIST &&
              static_cast<std::uint32_t>(Coordinate::swing) == CAROM_COORDINATE_SWING &&
              static_cast<std::uint32_t>(Coordinate::slide) == CAROM_COORDINATE_SLIDE &&
              static_cast<std::uint32_t>(Coordinate::distance) == CAROM_COORDINATE_DISTANCE);

constexpr std::uint32_t kJointFields =
    CAROM_JOINT_WORLD_FRAME | CAROM_JOINT_COLLIDE | CAROM_JOINT_FIELD_LENGTH | CAROM_JOINT_ACCELERATIONS;
constexpr double kLeastRatio = 1e-3, kMostRatio = 1e3;
constexpr double kFarthestApart = 8 * kMaxPosition;  // m: of places on bodies that no step would quarantine

bool check_position(Call& call, const char* name, const double v[3], int argument = 2) {
  return finite(call, argument, name, v, 3) &&
         (to_vec3(v).norm() <= kMaxPosition ||
          call.fail(CAROM_E_OUT_OF_RANGE, argument, "%s is (%g, %g, %g), at most %g long", name, v[0], v[1], v[2],
                    kMaxPosition));
}

/// Frames on the bodies, from what the host gave.
bool read_frames(Call& call, const World& world, const carom_joint_desc& d, JointDef& def) {
  if (!check_position(call, "desc->position_a", d.position_a) ||
      !unit(call, 2, "desc->orientation_a", d.orientation_a, 4))
    return false;
  def.frame_a = {to_quat(d.orientation_a), to_vec3(d.position_a)};
  if (d.fields & CAROM_JOINT_WORLD_FRAME) {
    const Pose frame = def.frame_a;
    const auto on = [&](std::uint32_t body) {
      if (body == kInvalid) return frame;
      const Pose local = world.pose(body).inverse() * frame;
      return Pose{normalized(local.q), local.p};
    };
    def.frame_a = on(def.body_a), def.frame_b = on(def.body_b);
    return (sane_position(def.frame_a.p) && sane_position(def.frame_b.p)) ||
           call.fail(CAROM_E_OUT_OF_RANGE, 2,
                     "desc->position_a lies more than %g m from a body's origin: give that body a pose near it first",
                     kMaxPosition);
  }
  if (!check_position(call, "desc->position_b", d.position_b) ||
      !unit(call, 2, "desc->orientation_b", d.orientation_b, 4))
    return false;
  def.frame_b = {to_quat(d.orientation_b), to_vec3(d.position_b)};
  return true;
}

bool is_made_of_bodies(Call& call, std::uint32_t kind) {
  return kind != CAROM_JOINT_COUPLING ||
         call.fail(CAROM_E_UNSUPPORTED, 2, "desc->kind is CAROM_JOINT_COUPLING, which joins no bodies") ||
         call.advise("couple two joints by carom_joint_couple()");
}

Real or_never(double most) { return most > 0 ? most : kInfinity; }

bool read_joint(Call& call, const World& world, const carom_joint_desc* given, JointDef& def) {
  carom_joint_desc d;
  carom_joint_desc_init(&d, sizeof d);
  if (!read_struct(call, 2, "desc", given, d) || !only_bits(call, 2, "desc->reserved", d.reserved, 0) ||
      !only_bits(call, 2, "desc->fields", d.fields, kJointFields) ||
      !known(call, 2, "desc->kind", d.kind, CAROM_JOINT_COUNT) || !is_made_of_bodies(call, d.kind) ||
      !read_ends(call, world, d, "joins", def) || !read_frames(call, world, d, def) ||
      !in_range(call, 2, "desc->length", d.length, 0, kLongestJoint) ||
      !in_range(call, 2, "desc->break_force", d.break_force, 0, kStrongestMotor) ||
      !in_range(call, 2, "desc->break_torque", d.break_torque, 0, kStrongestMotor))
    return false;
  def.kind = static_cast<JointKind>(d.kind);
  def.collide = d.fields & CAROM_JOINT_COLLIDE, def.measured = d.fields & CAROM_JOINT_ACCELERATIONS;
  def.break_force = or_never(d.break_force), def.break_torque = or_never(d.break_torque);
  def.user = d.user;
  Joint joint;
  joint.def = def;
  def.length = d.fields & CAROM_JOINT_FIELD_LENGTH ? d.length : place_of(world, joint).apart.norm();
  return def.length <= kFarthestApart ||
         call.fail(CAROM_E_OUT_OF_RANGE, 2,
                   "desc joins places %g m apart, at most %g: give the bodies poses within %g m of the origin first",
                   def.length, kFarthestApart, kMaxPosition);
}

bool has_joints_solver(Call& call, const World& world) {
  return world.scene.dials.choice(Dial::solver) != CAROM_SOLVER_SEVERITY ||
         call.fail(CAROM_E_UNSUPPORTED, 1,
                   "solver severity knows no joints; set CAROM_DIAL_SOLVER to another before joining bodies");
}

carom_joint_desc describe(const World& world, const Joint& joint) {
  const JointDef& def = joint.def;
  carom_joint_desc d{};
  d.kind = static_cast<std::uint32_t>(def.kind);
  d.fields = CAROM_JOINT_FIELD_LENGTH | (def.collide ? CAROM_JOINT_COLLIDE : 0u) |
             (def.measured ? CAROM_JOINT_ACCELERATIONS : 0u);
  d.body_a = handle_of_end(world, def.body_a), d.body_b = handle_of_end(world, def.body_b);
  from_vec3(def.frame_a.p, d.position_a), from_quat(def.frame_a.q, d.orientation_a);
  from_vec3(def.frame_b.p, d.position_b), from_quat(def.frame_b.q, d.orientation_b);
  d.length = def.length;
  d.break_force = def.break_force < kInfinity ? def.break_force : 0;
  d.break_torque = def.break_torque < kInfinity ? def.break_torque : 0;
  d.user = def.user;
  return d;
}

bool has_transmission(Call& call, const Joint& joint, int argument) {
  return dynamics::has_transmission(joint.def.kind) ||
         call.fail(CAROM_E_UNSUPPORTED, argument,
                   "a %s joint has no transmission; those of CAROM_JOINT_PULLEY and _GEAR have",
                   row_of(joint.def.kind).name);
}

/// A rope cannot push; wheels turn either way.
bool check_ratio(Call& call, JointKind kind, double ratio) {
  return in_range(call, 3, kind == JointKind::gear ? "transmission->ratio, or its negative," : "transmission->ratio",
                  kind == JointKind::gear ? std::fabs(ratio) : ratio, kLeastRatio, kMostRatio);
}

/// @param joint  as it is so far
bool read_transmission(Call& call, const World& world, Joint joint, const carom_joint_transmission* given,
                       Transmission& to) {
  carom_joint_transmission d;
  carom_joint_transmission_init(&d, sizeof d);
  if (!read_struct(call, 3, "transmission", given, d) ||
      !only_bits(call, 3, "transmission->fields", d.fields, CAROM_JOINT_FIELD_LENGTH) ||
      !check_ratio(call, joint.def.kind, d.ratio) || !check_position(call, "transmission->anchor_a", d.anchor_a, 3) ||
      !check_position(call, "transmission->anchor_b", d.anchor_b, 3) ||
      !in_range(call, 3, "transmission->length", d.length, 0, kLongestJoint) || !has_transmission(call, joint, 3))
    return false;
  if (joint.def.kind == JointKind::gear) return to = {d.ratio}, true;
  to = {d.ratio, to_vec3(d.anchor_a), to_vec3(d.anchor_b), d.length};
  if (d.fields & CAROM_JOINT_FIELD_LENGTH) return true;
  joint.transmission = to;
  to.length = place_of(world, joint).at[static_cast<std::size_t>(Coordinate::distance)];
  return to.length <= kLongestJoint ||
         call.fail(CAROM_E_OUT_OF_RANGE, 3, "the rope would be %g m long, at most %g: give anchors that are nearer",
                   to.length, kLongestJoint);
}

/// What is coupled is a joint of one motion.
bool can_be_coupled(Call& call, const World& world, const char* name, std::uint32_t slot) {
  const JointKind kind = world.joints.joint[slot].def.kind;
  return kind == JointKind::hinge || kind == JointKind::slider ||
         call.fail(CAROM_E_UNSUPPORTED, 2, "%s is a %s joint; a hinge or a slider is coupled", name, row_of(kind).name);
}

/// @param argument  of the call
bool read_polynomial(Call& call, int argument, const carom_joint_coupling& d, Coupling& to) {
  if (!only_bits(call, argument, "coupling->reserved", d.reserved, 0) ||
      !finite(call, argument, "coupling->polynomial", d.polynomial, Coupling::kTerms))
    return false;
  for (std::size_t k = 0; k < Coupling::kTerms; ++k) {
    if (!in_range(call, argument, "a number of coupling->polynomial", d.polynomial[k], -kLongestJoint, kLongestJoint))
      return false;
    to.polynomial[k] = d.polynomial[k];
  }
  return true;
}

bool read_coupling(Call& call, const World& world, const carom_joint_coupling* given, Coupling& to,
                   std::uint64_t& user) {
  carom_joint_coupling d;
  carom_joint_coupling_init(&d, sizeof d);
  if (!read_struct(call, 2, "coupling", given, d) || !read_polynomial(call, 2, d, to) ||
      !resolve(call, 2, "coupling->follower", world.joints.slots, d.follower) ||
      !resolve(call, 2, "coupling->leader", world.joints.slots, d.leader))
    return false;
  to.follower = handle_slot(d.follower), to.leader = handle_slot(d.leader), user = d.user;
  return true;
}

bool can_couple(Call& call, const World& world, const Coupling& to) {
  if (!can_be_coupled(call, world, "coupling->follower", to.follower) ||
      !can_be_coupled(call, world, "coupling->leader", to.leader))
    return false;
  if (to.follower == to.leader)
    return call.fail(CAROM_E_OUT_OF_RANGE, 2, "coupling->follower and coupling->leader are one joint") ||
           call.advise("couple two joints; one that is to stay where it is has a limit with lower = upper");
  const JointDef def = world.coupling_def(to);
  return def.body_a != kInvalid || def.body_b != kInvalid ||
         call.fail(CAROM_E_OUT_OF_RANGE, 2, "neither of the two joints has a body that is dynamic; one must have") ||
         call.advise("make one of their bodies dynamic");
}

bool has_coupling(Call& call, const Joint& joint, int argument) {
  return joint.coupling ||
         call.fail(CAROM_E_UNSUPPORTED, argument, "a %s joint is no coupling", row_of(joint.def.kind).name) ||
         call.advise("name a joint that carom_joint_couple() made");
}

/// Another polynomial for one that there is.
bool read_coupling(Call& call, const World& world, const Joint& joint, const carom_joint_coupling* given,
                   Coupling& to) {
  carom_joint_coupling d;
  carom_joint_coupling_init(&d, sizeof d);
  const auto lives = [&](const char* name, carom_joint handle) {
    return handle == CAROM_NULL_HANDLE || resolve(call, 3, name, world.joints.slots, handle);
  };
  if (!read_struct(call, 3, "coupling", given, d) || !read_polynomial(call, 3, d, to) ||
      !lives("coupling->follower", d.follower) || !lives("coupling->leader", d.leader) || !has_coupling(call, joint, 3))
    return false;
  const Coupling& now = world.joints.coupling_of(joint);
  const auto is_own = [&](const char* name, carom_joint handle, std::uint32_t own) {
    return handle == CAROM_NULL_HANDLE || handle_slot(handle) == own ||
           call.fail(CAROM_E_UNSUPPORTED, 3, "%s is not that of the coupling", name) ||
           call.advise("destroy the coupling and couple the other joints");
  };
  return is_own("coupling->follower", d.follower, now.follower) && is_own("coupling->leader", d.leader, now.leader);
}

/// Names of the coordinates that a kind leaves free, of CAROM_COORDINATE_*: "TWIST, SWING"; or "none".
std::array<char, 48> names_of_coordinates(JointKind kind) {
  static constexpr std::array<const char*, CAROM_COORDINATE_COUNT> kNames = {"TWIST", "SWING", "SLIDE", "DISTANCE"};
  std::array<char, 48> names{"none"};
  int at = 0;
  for (std::size_t k = 0; k < kNames.size(); ++k)
    if (has(kind, static_cast<Coordinate>(k)))
      at += std::snprintf(&names[static_cast<std::size_t>(at)], names.size() - static_cast<std::size_t>(at), "%s%s",
                          at > 0 ? ", " : "", kNames[k]);
  return names;
}
bool free_coordinate(Call& call, const Joint& joint, std::uint32_t coordinate) {
  if (!known(call, 3, "coordinate", coordinate, CAROM_COORDINATE_COUNT)) return false;
  if (has(joint.def.kind, static_cast<Coordinate>(coordinate))) return true;
  return call.fail(CAROM_E_UNSUPPORTED, 3, "coordinate %u is none that a %s joint leaves free; it leaves free: %s",
                   coordinate, row_of(joint.def.kind).name, names_of_coordinates(joint.def.kind).data()) ||
         call.advise(
             "use a coordinate that the message names, of CAROM_COORDINATE_*; axes of a six-axis joint have "
             "carom_joint_set_axis()");
}
bool drivable(Call& call, const Joint& joint, std::uint32_t coordinate) {
  return free_coordinate(call, joint, coordinate) &&
         (coordinate != CAROM_COORDINATE_SWING ||
          call.fail(CAROM_E_UNSUPPORTED, 3, "a swing has a limit, but no motor and no spring: it has no direction"));
}

bool read(Call& call, const Joint& joint, std::uint32_t coordinate, const carom_joint_limit* given, JointDrive& drive) {
  carom_joint_limit d;
  carom_joint_limit_init(&d, sizeof d);
  if (!free_coordinate(call, joint, coordinate) || !read_struct(call, 4, "limit", given, d) ||
      !known(call, 4, "limit->enabled", d.enabled, 2))
    return false;
  const CoordinateBounds b = bounds_of(coordinate);
  if (!in_range(call, 4, "limit->lower", d.lower, b.low, b.high) ||
      !in_range(call, 4, "limit->upper", d.upper, d.lower, b.high))
    return false;
  drive.limit = {d.enabled != 0, d.lower, d.upper};
  return true;
}
bool read(Call& call, const Joint& joint, std::uint32_t coordinate, const carom_joint_motor* given, JointDrive& drive) {
  carom_joint_motor d;
  carom_joint_motor_init(&d, sizeof d);
  if (!drivable(call, joint, coordinate) || !read_struct(call, 4, "motor", given, d) ||
      !known(call, 4, "motor->enabled", d.enabled, 2) ||
      !in_range(call, 4, "motor->speed", d.speed, -kFastestMotor, kFastestMotor) ||
      !in_range(call, 4, "motor->max_force", d.max_force, 0, kStrongestMotor))
    return false;
  drive.motor = {d.enabled != 0, d.speed, d.max_force};
  return true;
}
bool read(Call& call, const Joint& joint, std::uint32_t coordinate, const carom_joint_spring* given,
          JointDrive& drive) {
  carom_joint_spring d;
  carom_joint_spring_init(&d, sizeof d);
  if (!drivable(call, joint, coordinate) || !read_struct(call, 4, "spring", given, d) ||
      !known(call, 4, "spring->enabled", d.enabled, 2))
    return false;
  const CoordinateBounds b = bounds_of(coordinate);
  if (!in_range(call, 4, "spring->target", d.target, b.low, b.high) ||
      !in_range(call, 4, "spring->frequency", d.frequency, 0, kStiffest) ||
      !in_range(call, 4, "spring->damping", d.damping, 0, kMostDamping) ||
      !in_range(call, 4, "spring->max_force", d.max_force, 0, kStrongestMotor))
    return false;
  drive.spring = {d.enabled != 0, d.target, d.frequency, d.damping, d.max_force};
  return true;
}

void write(const JointDrive& drive, carom_joint_limit& d) {
  d.enabled = drive.limit.on, d.lower = drive.limit.lower, d.upper = drive.limit.upper;
}
void write(const JointDrive& drive, carom_joint_motor& d) {
  d.enabled = drive.motor.on, d.speed = drive.motor.speed, d.max_force = drive.motor.max_force;
}
void write(const JointDrive& drive, carom_joint_spring& d) {
  const JointSpring& s = drive.spring;
  d.enabled = s.on, d.target = s.target, d.frequency = s.frequency, d.damping = s.damping;
  d.max_force = std::min(s.max_force, kStrongestMotor);
}

template <class Desc, class Say>
int32_t set(carom_world* world, carom_joint handle, std::uint32_t coordinate, const Desc* desc, const Say& say,
            carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, say);
    if (!changing || !resolve_joint(call, *changing, handle)) return;
    const Joint& joint = changing->joints.joint[handle_slot(handle)];
    JointDrive drive = coordinate < kCoordinates ? joint.drive[coordinate] : JointDrive{};
    if (read(call, joint, coordinate, desc, drive))
      changing->set_joint_drive(handle_slot(handle), static_cast<Coordinate>(coordinate), drive);
  });
}

template <class Desc>
int32_t get(carom_world* world, carom_joint handle, std::uint32_t coordinate, Desc* desc, const char* name,
            carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve_joint(call, *reading, handle)) return;
    const Joint& joint = reading->joints.joint[handle_slot(handle)];
    if (!free_coordinate(call, joint, coordinate) || !fillable(call, 4, name, desc)) return;
    Desc full{};
    write(joint.drive[coordinate], full);
    write_struct(full, desc);
  });
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

const char* carom_joint_kind_name(uint32_t kind) {
  return kind < CAROM_JOINT_COUNT ? row_of(static_cast<JointKind>(kind)).name : "?";
}

int32_t carom_joint_desc_init(carom_joint_desc* desc, uint32_t struct_size) {
  return init_struct(desc, struct_size, [](carom_joint_desc& d) { d.orientation_a[3] = d.orientation_b[3] = 1; });
}
int32_t carom_joint_limit_init(carom_joint_limit* limit, uint32_t struct_size) {
  return init_struct(limit, struct_size);
}
int32_t carom_joint_motor_init(carom_joint_motor* motor, uint32_t struct_size) {
  return init_struct(motor, struct_size);
}
int32_t carom_joint_spring_init(carom_joint_spring* spring, uint32_t struct_size) {
  return init_struct(spring, struct_size, [](carom_joint_spring& d) {
    d.frequency = d.damping = 1;
    d.max_force = kStrongestMotor;
  });
}

int32_t carom_joint_transmission_init(carom_joint_transmission* transmission, uint32_t struct_size) {
  return init_struct(transmission, struct_size, [](carom_joint_transmission& d) { d.ratio = 1; });
}

int32_t carom_joint_create(carom_world* world, const carom_joint_desc* desc, carom_joint* joint, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::joint_create(desc));
    if (!changing) return;
    const FloatScope scope;
    JointDef def;
    if (!has_joints_solver(call, *changing) || !read_joint(call, *changing, desc, def) ||
        !present(call, 3, "joint", joint))
      return;
    const Handle handle = changing->add_joint(def);
    if (handle)
      *joint = handle;
    else
      call.fail(CAROM_E_LIMIT, 0, "this world has issued all %u joints", kMaxSlots);
  });
}

int32_t carom_joint_destroy(carom_world* world, carom_joint joint, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::joint_destroy(joint));
    if (changing && resolve_joint(call, *changing, joint)) changing->remove_joint(handle_slot(joint));
  });
}

int32_t carom_joint_get(carom_world* world, carom_joint joint, carom_joint_desc* desc, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && resolve_joint(call, *reading, joint) && fillable(call, 3, "desc", desc))
      write_struct(describe(*reading, reading->joints.joint[handle_slot(joint)]), desc);
  });
}

int32_t carom_joint_get_state(carom_world* world, carom_joint handle, carom_joint_state* state, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve_joint(call, *reading, handle) || !fillable(call, 3, "state", state)) return;
    const FloatScope scope;
    const Joint& joint = reading->joints.joint[handle_slot(handle)];
    const JointPlace place = place_of(*reading, joint);
    carom_joint_state full{};
    full.broken = joint.broken;
    from_vec3(joint.force, full.force), from_vec3(joint.torque, full.torque);
    full.gap = place.gap, full.angle = place.angle;
    const auto axis = axes_at(place, place.turned);
    std::copy(place.at.begin(), place.at.end(), full.coordinate), std::copy(axis.begin(), axis.end(), full.axis);
    write_struct(full, state);
  });
}

int32_t carom_joint_set_limit(carom_world* world, carom_joint joint, uint32_t coordinate,
                              const carom_joint_limit* limit, carom_error* error) {
  return set(world, joint, coordinate, limit, record::joint_set_limit(joint, coordinate, limit), error);
}
int32_t carom_joint_set_motor(carom_world* world, carom_joint joint, uint32_t coordinate,
                              const carom_joint_motor* motor, carom_error* error) {
  return set(world, joint, coordinate, motor, record::joint_set_motor(joint, coordinate, motor), error);
}
int32_t carom_joint_set_spring(carom_world* world, carom_joint joint, uint32_t coordinate,
                               const carom_joint_spring* spring, carom_error* error) {
  return set(world, joint, coordinate, spring, record::joint_set_spring(joint, coordinate, spring), error);
}
int32_t carom_joint_get_limit(carom_world* world, carom_joint joint, uint32_t coordinate, carom_joint_limit* limit,
                              carom_error* error) {
  return get(world, joint, coordinate, limit, "limit", error);
}
int32_t carom_joint_get_motor(carom_world* world, carom_joint joint, uint32_t coordinate, carom_joint_motor* motor,
                              carom_error* error) {
  return get(world, joint, coordinate, motor, "motor", error);
}
int32_t carom_joint_get_spring(carom_world* world, carom_joint joint, uint32_t coordinate, carom_joint_spring* spring,
                               carom_error* error) {
  return get(world, joint, coordinate, spring, "spring", error);
}

int32_t carom_joint_set_transmission(carom_world* world, carom_joint joint,
                                     const carom_joint_transmission* transmission, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::joint_set_transmission(joint, transmission));
    if (!changing || !resolve_joint(call, *changing, joint)) return;
    const FloatScope scope;
    const std::uint32_t slot = handle_slot(joint);
    Transmission to;
    if (read_transmission(call, *changing, changing->joints.joint[slot], transmission, to))
      changing->set_transmission(slot, to);
  });
}
int32_t carom_joint_get_transmission(carom_world* world, carom_joint handle, carom_joint_transmission* transmission,
                                     carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve_joint(call, *reading, handle)) return;
    const Joint& joint = reading->joints.joint[handle_slot(handle)];
    if (!fillable(call, 3, "transmission", transmission) || !has_transmission(call, joint, 3)) return;
    const Transmission& t = joint.transmission;
    carom_joint_transmission full{0, CAROM_JOINT_FIELD_LENGTH, t.ratio, {}, {}, t.length};
    from_vec3(t.anchor_a, full.anchor_a), from_vec3(t.anchor_b, full.anchor_b);
    write_struct(full, transmission);
  });
}

int32_t carom_joint_coupling_init(carom_joint_coupling* coupling, uint32_t struct_size) {
  return init_struct(coupling, struct_size, [](carom_joint_coupling& d) { d.polynomial[1] = 1; });
}

int32_t carom_joint_couple(carom_world* world, const carom_joint_coupling* coupling, carom_joint* joint,
                           carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::joint_couple(coupling));
    if (!changing) return;
    const FloatScope scope;
    Coupling to;
    std::uint64_t user = 0;
    if (!has_joints_solver(call, *changing) || !read_coupling(call, *changing, coupling, to, user) ||
        !present(call, 3, "joint", joint) || !can_couple(call, *changing, to))
      return;
    const Handle handle = changing->add_coupling(to, user);
    if (handle)
      *joint = handle;
    else
      call.fail(CAROM_E_LIMIT, 0, "this world has issued all %u joints", kMaxSlots);
  });
}

int32_t carom_joint_set_coupling(carom_world* world, carom_joint joint, const carom_joint_coupling* coupling,
                                 carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::joint_set_coupling(joint, coupling));
    if (!changing || !resolve_joint(call, *changing, joint)) return;
    const FloatScope scope;
    const std::uint32_t slot = handle_slot(joint);
    Coupling to;
    if (read_coupling(call, *changing, changing->joints.joint[slot], coupling, to))
      changing->set_polynomial(slot, to.polynomial);
  });
}

int32_t carom_joint_get_coupling(carom_world* world, carom_joint handle, carom_joint_coupling* coupling,
                                 carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve_joint(call, *reading, handle)) return;
    const Joint& joint = reading->joints.joint[handle_slot(handle)];
    if (!fillable(call, 3, "coupling", coupling) || !has_coupling(call, joint, 2)) return;
    const Coupling& c = reading->joints.coupling_of(joint);
    carom_joint_coupling full{};
    full.follower = reading->joints.slots.handle(c.follower), full.leader = reading->joints.slots.handle(c.leader);
    std::copy(c.polynomial.begin(), c.polynomial.end(), full.polynomial);
    full.user = joint.def.user;
    write_struct(full, coupling);
  });
}

int32_t carom_world_get_joints(carom_world* world, carom_joint* joints, uint64_t capacity, uint64_t* count,
                               carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !present(call, 4, "count", count)) return;
    const SlotPool& slots = reading->joints.slots;
    *count = slots.alive_count();
    if (!joints) return;
    for (std::uint32_t i = 0, k = 0; i < slots.slots() && k < capacity; ++i)
      if (slots.alive(i)) joints[k++] = slots.handle(i);
  });
}

}  // extern "C"
