// A row for every function of the ABI: its arguments, each with what is good and all that is wrong (arguments.h). A function
// without a row fails tests/abi/test_hostile.cpp. Used by it and by tests/fuzz/calls.cpp.
#pragma once

#include "arguments.h"

namespace hostile {

template <class T, class Init>
T fresh(Init init) {
  T t;
  init(&t, sizeof t);
  return t;
}
inline uint64_t pick(Context& c, Kind kind, bool& none) { return living(c, kind, none); }
/// A body other than `first`, or with a chance of one in three the world.
inline uint64_t other_end(Context& c, uint64_t first) { return c.source.below(3) == 1 ? 0 : another(c, kBody, first); }

inline Argument body_desc(Context& c) {
  auto d = fresh<carom_body_desc>(carom_body_desc_init);
  const unsigned type = c.source.below(8);
  d.type = type < 6 ? CAROM_BODY_DYNAMIC : type == 6 ? CAROM_BODY_KINEMATIC : CAROM_BODY_STATIC;
  for (double& x : d.position) x = c.between(-3, 3);
  turn(c, 4, d.orientation);
  if (d.type != CAROM_BODY_STATIC) {
    for (double& x : d.linear_velocity) x = c.between(-3, 3);
    for (double& x : d.angular_velocity) x = c.between(-3, 3);
  }
  if (c.source.below(4) != 3) {
    d.fields = CAROM_BODY_FIELD_MASS | CAROM_BODY_FIELD_CENTER | CAROM_BODY_FIELD_INERTIA;
    d.mass = c.between(0.5, 5);
    for (double& x : d.center) x = c.between(-0.1, 0.1);
    for (const int i : {0, 4, 8}) d.inertia[i] = c.between(1, 1.5);
  }
  d.linear_damping = c.between(0, 1), d.angular_damping = c.between(0, 1);
  d.gravity_factor = c.between(-1, 2);
  d.linear_drag = c.between(0, 1), d.quadratic_drag = c.between(0, 1);
  d.force_field_mask = c.source.below(4);
  d.continuous = c.source.below(3);
  if (d.type == CAROM_BODY_DYNAMIC)
    for (double& x : d.magnetic_moment) x = c.between(-1, 1);
  const bool given = d.fields & CAROM_BODY_FIELD_MASS;
  std::vector<Field> fields;
  Argument a = in_struct(
      c, d,
      {HOSTILE_BITS(carom_body_desc, fields, 31u), HOSTILE_CHOICE(carom_body_desc, type, 3u),
       HOSTILE_RESERVED(carom_body_desc, reserved), HOSTILE_NUMBERS(carom_body_desc, position, 3, any()),
       HOSTILE_UNIT(carom_body_desc, orientation, 4), HOSTILE_NUMBERS(carom_body_desc, linear_velocity, 3, any()),
       HOSTILE_NUMBERS(carom_body_desc, angular_velocity, 3, any()),
       HOSTILE_NUMBERS(carom_body_desc, linear_damping, 1, {0, 1e6}),
       HOSTILE_NUMBERS(carom_body_desc, angular_damping, 1, {0, 1e6}),
       HOSTILE_NUMBERS(carom_body_desc, gravity_factor, 1, any()), HOSTILE_BITS(carom_body_desc, locks, 63u),
       HOSTILE_CHOICE(carom_body_desc, continuous, 3u), HOSTILE_NUMBERS(carom_body_desc, linear_drag, 1, {0, 1e12}),
       HOSTILE_NUMBERS(carom_body_desc, quadratic_drag, 1, {0, 1e12}), HOSTILE_RESERVED(carom_body_desc, reserved2),
       HOSTILE_NUMBERS(carom_body_desc, magnetic_moment, 3, {-1e12, 1e12})});
  if (given && d.type == CAROM_BODY_DYNAMIC) {
    const Argument more = in_struct(
        c, d,
        {HOSTILE_NUMBERS(carom_body_desc, mass, 1, {kLeast, kMost}), HOSTILE_NUMBERS(carom_body_desc, center, 3, any()),
         HOSTILE_NUMBERS(carom_body_desc, inertia, 9, any())});
    a.wrong.insert(a.wrong.end(), more.wrong.begin(), more.wrong.end());
  }
  return a;
}
inline Argument collider_desc(Context& c) {
  auto d = fresh<carom_collider_desc>(carom_collider_desc_init);
  Argument a;
  bool none = false, nothing = false;
  d.shape = pick(c, kShape, none);
  if (c.source.below(2) == 0) d.material = pick(c, kMaterial, nothing);
  for (double& x : d.position) x = c.between(-0.5, 0.5);
  turn(c, 4, d.orientation);
  d.density = c.between(1, 2000);
  d.category = 1 + c.source.below(3), d.mask = ~std::uint64_t(c.source.below(3));
  d.group = static_cast<std::int32_t>(c.source.below(3)) - 1;
  d.sensor = c.source.below(6) == 5;
  if (c.source.below(4) == 3)
    for (double& x : d.surface_linear) x = c.between(-1, 1);
  a = in_struct(
      c, d,
      {HOSTILE_RESERVED(carom_collider_desc, reserved), HOSTILE_HANDLE(carom_collider_desc, shape, kShape, false),
       HOSTILE_HANDLE(carom_collider_desc, material, kMaterial, true),
       HOSTILE_NUMBERS(carom_collider_desc, position, 3, any()), HOSTILE_UNIT(carom_collider_desc, orientation, 4),
       HOSTILE_NUMBERS(carom_collider_desc, density, 1, {0, 1e9}), HOSTILE_WHOLE(carom_collider_desc, sensor, 0, 1),
       HOSTILE_NUMBERS(carom_collider_desc, surface_linear, 3, {-1e6, 1e6}),
       HOSTILE_NUMBERS(carom_collider_desc, surface_angular, 3, {-1e6, 1e6})});
  a.impossible = none;
  return a;
}
inline Argument material_desc(Context& c) {
  auto d = fresh<carom_material_desc>(carom_material_desc_init);
  d.friction_mix = c.source.below(5), d.restitution_mix = c.source.below(5);
  d.friction = c.between(0, 2), d.restitution = c.between(0, 1);
  return in_struct(
      c, d,
      {HOSTILE_CHOICE(carom_material_desc, friction_mix, 5u), HOSTILE_CHOICE(carom_material_desc, restitution_mix, 5u),
       HOSTILE_RESERVED(carom_material_desc, reserved), HOSTILE_NUMBERS(carom_material_desc, friction, 1, {0, 1e3}),
       HOSTILE_NUMBERS(carom_material_desc, restitution, 1, {0, 1})});
}
inline Argument particles_desc(Context& c) {
  auto d = fresh<carom_particles_desc>(carom_particles_desc_init);
  d.gravity_factor = c.between(-1, 1), d.linear_damping = c.between(0, 1), d.mass = c.between(0.1, 2);
  return in_struct(c, d,
                   {HOSTILE_RESERVED(carom_particles_desc, reserved),
                    HOSTILE_NUMBERS(carom_particles_desc, gravity_factor, 1, {-1e3, 1e3}),
                    HOSTILE_NUMBERS(carom_particles_desc, linear_damping, 1, {0, 1e6}),
                    HOSTILE_NUMBERS(carom_particles_desc, mass, 1, {kLeast, 1e30})},
                   true);
}
inline Argument joint_desc(Context& c) {
  auto d = fresh<carom_joint_desc>(carom_joint_desc_init);
  bool none = false;
  d.kind = c.source.below(CAROM_JOINT_COUNT);
  d.fields = c.source.below(4);
  d.body_a = pick(c, kBody, none), d.body_b = other_end(c, d.body_a);
  for (double& x : d.position_a) x = c.between(-1, 1);
  for (double& x : d.position_b) x = c.between(-1, 1);
  turn(c, 4, d.orientation_a), turn(c, 4, d.orientation_b);
  if (c.source.below(4) == 3) d.break_force = 1000;
  std::vector<Wrong> more;
  Argument a = in_struct(
      c, d,
      {HOSTILE_CHOICE(carom_joint_desc, kind, uint32_t(CAROM_JOINT_COUNT)), HOSTILE_BITS(carom_joint_desc, fields, 15u),
       HOSTILE_RESERVED(carom_joint_desc, reserved), HOSTILE_HANDLE(carom_joint_desc, body_a, kBody, true),
       HOSTILE_HANDLE(carom_joint_desc, body_b, kBody, true), HOSTILE_NUMBERS(carom_joint_desc, position_a, 3, any()),
       HOSTILE_UNIT(carom_joint_desc, orientation_a, 4), HOSTILE_NUMBERS(carom_joint_desc, break_force, 1, {0, kMost}),
       HOSTILE_NUMBERS(carom_joint_desc, break_torque, 1, {0, kMost})});
  if (!(d.fields & CAROM_JOINT_WORLD_FRAME)) {
    const Argument b = in_struct(
        c, d,
        {HOSTILE_NUMBERS(carom_joint_desc, position_b, 3, any()), HOSTILE_UNIT(carom_joint_desc, orientation_b, 4)});
    a.wrong.insert(a.wrong.end(), b.wrong.begin(), b.wrong.end());
  }
  a.impossible = none;
  return a;
}
inline Argument joint_limit(Context& c) {
  auto d = fresh<carom_joint_limit>(carom_joint_limit_init);
  d.enabled = c.source.below(2), d.lower = c.between(0, 0.3), d.upper = c.between(0.5, 1);
  return in_struct(
      c, d,
      {HOSTILE_CHOICE(carom_joint_limit, enabled, 2u), HOSTILE_NUMBERS(carom_joint_limit, lower, 1, {-1e9, 1e9}),
       HOSTILE_NUMBERS(carom_joint_limit, upper, 1, {-1e9, 1e9})});
}
inline Argument joint_motor(Context& c) {
  auto d = fresh<carom_joint_motor>(carom_joint_motor_init);
  d.enabled = c.source.below(2), d.speed = c.between(-3, 3), d.max_force = c.between(0, 50);
  return in_struct(
      c, d,
      {HOSTILE_CHOICE(carom_joint_motor, enabled, 2u), HOSTILE_NUMBERS(carom_joint_motor, speed, 1, {-1e6, 1e6}),
       HOSTILE_NUMBERS(carom_joint_motor, max_force, 1, {0, 1e30})});
}
/// @param may_be_null  its joints: of one that there is
inline Argument joint_coupling(Context& c, bool may_be_null = false) {
  auto d = fresh<carom_joint_coupling>(carom_joint_coupling_init);
  bool none = false;
  d.follower = pick(c, kJoint, none), d.leader = another(c, kJoint, d.follower);
  for (double& x : d.polynomial) x = c.between(-2, 2);
  Argument a = in_struct(c, d,
                         {HOSTILE_RESERVED(carom_joint_coupling, reserved),
                          HOSTILE_HANDLE(carom_joint_coupling, follower, kJoint, may_be_null),
                          HOSTILE_HANDLE(carom_joint_coupling, leader, kJoint, may_be_null),
                          HOSTILE_NUMBERS(carom_joint_coupling, polynomial, 5, {-1e9, 1e9})});
  a.impossible = none && !may_be_null;
  return a;
}
inline Argument joint_transmission(Context& c) {
  auto d = fresh<carom_joint_transmission>(carom_joint_transmission_init);
  d.ratio = c.between(0.1, 10), d.length = c.between(0, 10),
  d.fields = c.source.below(2) ? CAROM_JOINT_FIELD_LENGTH : 0u;
  for (double& x : d.anchor_a) x = c.between(-3, 3);
  for (double& x : d.anchor_b) x = c.between(-3, 3);
  return in_struct(c, d,
                   {HOSTILE_BITS(carom_joint_transmission, fields, uint32_t(CAROM_JOINT_FIELD_LENGTH)),
                    HOSTILE_NUMBERS(carom_joint_transmission, ratio, 1, {-1e3, 1e3}),
                    HOSTILE_NUMBERS(carom_joint_transmission, anchor_a, 3, any()),
                    HOSTILE_NUMBERS(carom_joint_transmission, anchor_b, 3, any()),
                    HOSTILE_NUMBERS(carom_joint_transmission, length, 1, {0, 1e9})});
}
inline Argument joint_axis(Context& c) {
  auto d = fresh<carom_joint_axis>(carom_joint_axis_init);
  d.mode = c.source.below(3), d.drive = c.source.below(4), d.lower = c.between(-1, 0), d.upper = c.between(0, 1);
  d.stop_gains = c.source.below(3), d.drive_gains = c.source.below(3), d.spring_gains = c.source.below(3);
  d.stop_stiffness = c.between(0, 9), d.drive_stiffness = c.between(0, 9),
  d.spring_stiffness = c.source.below(2) ? 4 : 0;
  d.stop_damping = c.between(0, 1), d.drive_damping = c.between(0, 1), d.spring_damping = c.between(0, 1);
  d.target = c.between(-1, 1), d.speed = c.between(-2, 2), d.effort = c.between(-9, 9), d.max_force = c.between(0, 50),
  d.rest = c.between(-1, 1), d.friction = c.between(0, 3), d.armature = c.between(0, 2);
  d.effort_limit = c.between(1, 9), d.speed_limit = c.between(1, 9);
  return in_struct(c, d,
                   {HOSTILE_CHOICE(carom_joint_axis, mode, uint32_t(CAROM_AXIS_MODE_COUNT)),
                    HOSTILE_CHOICE(carom_joint_axis, drive, uint32_t(CAROM_DRIVE_COUNT)),
                    HOSTILE_CHOICE(carom_joint_axis, stop_gains, uint32_t(CAROM_GAINS_COUNT)),
                    HOSTILE_CHOICE(carom_joint_axis, drive_gains, uint32_t(CAROM_GAINS_COUNT)),
                    HOSTILE_CHOICE(carom_joint_axis, spring_gains, uint32_t(CAROM_GAINS_COUNT)),
                    HOSTILE_NUMBERS(carom_joint_axis, lower, 1, {-1e9, 1e9}),
                    HOSTILE_NUMBERS(carom_joint_axis, upper, 1, {-1e9, 1e9}),
                    HOSTILE_NUMBERS(carom_joint_axis, stop_stiffness, 1, {0, 1e30}),
                    HOSTILE_NUMBERS(carom_joint_axis, stop_damping, 1, {0, 1e30}),
                    HOSTILE_NUMBERS(carom_joint_axis, target, 1, {-1e9, 1e9}),
                    HOSTILE_NUMBERS(carom_joint_axis, speed, 1, {-1e6, 1e6}),
                    HOSTILE_NUMBERS(carom_joint_axis, effort, 1, {-1e30, 1e30}),
                    HOSTILE_NUMBERS(carom_joint_axis, max_force, 1, {0, 1e30}),
                    HOSTILE_NUMBERS(carom_joint_axis, drive_stiffness, 1, {0, 1e30}),
                    HOSTILE_NUMBERS(carom_joint_axis, drive_damping, 1, {0, 1e30}),
                    HOSTILE_NUMBERS(carom_joint_axis, rest, 1, {-1e9, 1e9}),
                    HOSTILE_NUMBERS(carom_joint_axis, spring_stiffness, 1, {0, 1e30}),
                    HOSTILE_NUMBERS(carom_joint_axis, spring_damping, 1, {0, 1e30}),
                    HOSTILE_NUMBERS(carom_joint_axis, friction, 1, {0, 1e30}),
                    HOSTILE_NUMBERS(carom_joint_axis, armature, 1, {0, 1e30}),
                    HOSTILE_NUMBERS(carom_joint_axis, effort_limit, 1, {0, 1e30}),
                    HOSTILE_NUMBERS(carom_joint_axis, speed_limit, 1, {0, 1e30})});
}
inline Argument joint_orientation_drive(Context& c) {
  auto d = fresh<carom_joint_orientation_drive>(carom_joint_orientation_drive_init);
  d.drive = c.source.below(4), d.gains = c.source.below(3), d.stiffness = c.between(0, 9), d.damping = c.between(0, 1);
  for (double& x : d.velocity) x = c.between(-3, 3);
  for (double& x : d.effort) x = c.between(-3, 3);
  for (double& x : d.max_force) x = c.between(0, 9);
  return in_struct(c, d,
                   {HOSTILE_CHOICE(carom_joint_orientation_drive, drive, uint32_t(CAROM_DRIVE_COUNT)),
                    HOSTILE_CHOICE(carom_joint_orientation_drive, gains, uint32_t(CAROM_GAINS_COUNT)),
                    HOSTILE_RESERVED(carom_joint_orientation_drive, reserved),
                    HOSTILE_UNIT(carom_joint_orientation_drive, target, 4),
                    HOSTILE_NUMBERS(carom_joint_orientation_drive, velocity, 3, {-1e6, 1e6}),
                    HOSTILE_NUMBERS(carom_joint_orientation_drive, effort, 3, {-1e30, 1e30}),
                    HOSTILE_NUMBERS(carom_joint_orientation_drive, max_force, 3, {0, 1e30}),
                    HOSTILE_NUMBERS(carom_joint_orientation_drive, stiffness, 1, {0, 1e30}),
                    HOSTILE_NUMBERS(carom_joint_orientation_drive, damping, 1, {0, 1e30})});
}
inline Argument joint_spring(Context& c) {
  auto d = fresh<carom_joint_spring>(carom_joint_spring_init);
  d.enabled = c.source.below(2), d.target = c.between(0, 1), d.frequency = c.between(0, 5), d.damping = c.between(0, 1),
  d.max_force = 100;
  return in_struct(
      c, d,
      {HOSTILE_CHOICE(carom_joint_spring, enabled, 2u), HOSTILE_NUMBERS(carom_joint_spring, target, 1, {-1e9, 1e9}),
       HOSTILE_NUMBERS(carom_joint_spring, frequency, 1, {0, 1e4}),
       HOSTILE_NUMBERS(carom_joint_spring, damping, 1, {0, 1e3}),
       HOSTILE_NUMBERS(carom_joint_spring, max_force, 1, {0, 1e30})});
}
inline Argument field_desc(Context& c) {
  auto d = fresh<carom_force_field_desc>(carom_force_field_desc_init);
  d.kind = c.source.below(3), d.is_force = c.source.below(2);
  for (double& x : d.position) x = c.between(-3, 3);
  for (double& x : d.vector) x = c.between(-3, 3);
  turn(c, 4, d.orientation);
  d.strength = c.between(-5, 5), d.pull = c.between(-1, 1), d.lift = c.between(-1, 1), d.core = c.between(0, 1);
  d.falloff = static_cast<int32_t>(c.source.below(5)) - 1;
  const Bounds strength = {-1e30, 1e30};
  return in_struct(
      c, d,
      {HOSTILE_CHOICE(carom_force_field_desc, kind, CAROM_FORCE_FIELD_COUNT),
       HOSTILE_CHOICE(carom_force_field_desc, is_force, 2u),
       HOSTILE_NUMBERS(carom_force_field_desc, position, 3, any()),
       HOSTILE_UNIT(carom_force_field_desc, orientation, 4),
       HOSTILE_NUMBERS(carom_force_field_desc, half, 3, {kLeast, kMost, true}),
       HOSTILE_NUMBERS(carom_force_field_desc, vector, 3, strength),
       HOSTILE_NUMBERS(carom_force_field_desc, strength, 1, strength),
       HOSTILE_NUMBERS(carom_force_field_desc, pull, 1, strength),
       HOSTILE_NUMBERS(carom_force_field_desc, lift, 1, strength),
       HOSTILE_NUMBERS(carom_force_field_desc, reference, 1, {kLeast, kMost}),
       HOSTILE_NUMBERS(carom_force_field_desc, core, 1, {0, kMost}),
       HOSTILE_NUMBERS(carom_force_field_desc, reach, 1, {kLeast, kMost, true}),
       HOSTILE_WHOLE(carom_force_field_desc, falloff, -2, 8), HOSTILE_RESERVED(carom_force_field_desc, reserved)});
}
inline Argument spring_desc(Context& c) {
  auto d = fresh<carom_spring_desc>(carom_spring_desc_init);
  bool none = false;
  d.body_b = pick(c, kBody, none), d.body_a = other_end(c, d.body_b), d.only_pulls = c.source.below(2);
  for (double& x : d.anchor_a) x = c.between(-1, 1);
  d.rest = c.between(0, 2), d.stiffness = c.between(0, 100), d.damping = c.between(0, 3);
  Argument a = in_struct(
      c, d,
      {HOSTILE_CHOICE(carom_spring_desc, only_pulls, 2u), HOSTILE_HANDLE(carom_spring_desc, body_a, kBody, true),
       HOSTILE_HANDLE(carom_spring_desc, body_b, kBody, true), HOSTILE_NUMBERS(carom_spring_desc, anchor_a, 3, any()),
       HOSTILE_NUMBERS(carom_spring_desc, anchor_b, 3, any()), HOSTILE_NUMBERS(carom_spring_desc, rest, 1, {0, 1e9}),
       HOSTILE_NUMBERS(carom_spring_desc, stiffness, 1, {0, 1e30}),
       HOSTILE_NUMBERS(carom_spring_desc, damping, 1, {0, 1e30})});
  a.impossible = none;
  return a;
}
inline Argument water_desc(Context& c) {
  auto d = fresh<carom_water>(carom_water_init);
  turn(c, 3, d.normal);
  d.level = c.between(-1, 1), d.density = c.between(500, 1500);
  for (double& x : d.current) x = c.between(-1, 1);
  return in_struct(
      c, d,
      {HOSTILE_RESERVED(carom_water, reserved), HOSTILE_UNIT(carom_water, normal, 3),
       HOSTILE_NUMBERS(carom_water, level, 1, any()), HOSTILE_NUMBERS(carom_water, density, 1, {kLeast, 1e9}),
       HOSTILE_NUMBERS(carom_water, current, 3, any()), HOSTILE_NUMBERS(carom_water, drag, 1, {0, 1e6})},
      true);
}
/// Of carom_world_measure_growth(): a large number of steps is allowed, and takes its time.
inline Argument growth_steps(Context& c) {
  return {of(uint64_t(1 + c.source.below(20))),
          {{"none", of(uint64_t(0)), kRange}, {"too many", of(uint64_t(1000001)), kRange}}};
}
inline Argument accuracy_desc(Context& c) {
  auto d = fresh<carom_accuracy>(carom_accuracy_init);
  d.place = std::pow(10, c.between(-6, 0)), d.turn = std::pow(10, c.between(-6, 0)),
  d.substeps = 2 + c.source.below(30);
  return in_struct(
      c, d,
      {HOSTILE_WHOLE(carom_accuracy, substeps, 2, 4096), HOSTILE_NUMBERS(carom_accuracy, place, 1, {0, 1e6}),
       HOSTILE_NUMBERS(carom_accuracy, turn, 1, {0, 1e6})},
      true);
}
inline Argument cast_desc(Context& c) {
  auto d = fresh<carom_cast_desc>(carom_cast_desc_init);
  d.flags = c.source.below(2) * CAROM_ASK_GENERIC + c.source.below(2) * CAROM_ASK_IGNORE_TOUCHED;
  return in_struct(
      c, d,
      {HOSTILE_BITS(carom_cast_desc, flags, 5u), HOSTILE_NUMBERS(carom_cast_desc, tolerance, 1, {kLeast, 1}),
       HOSTILE_NUMBERS(carom_cast_desc, target, 1, {0, 1e9}), HOSTILE_CHOICE(carom_cast_desc, iterations, 10001u),
       HOSTILE_RESERVED(carom_cast_desc, reserved)},
      true);
}
inline Argument query_desc(Context& c) {
  auto d = fresh<carom_query_desc>(carom_query_desc_init);
  d.flags = c.source.below(8);
  return in_struct(c, d,
                   {HOSTILE_BITS(carom_query_desc, flags, 7u), HOSTILE_HANDLE(carom_query_desc, ignore, kBody, true),
                    HOSTILE_NUMBERS(carom_query_desc, tolerance, 1, {kLeast, 1}),
                    HOSTILE_NUMBERS(carom_query_desc, target, 1, {0, 1e9}),
                    HOSTILE_CHOICE(carom_query_desc, iterations, 10001u), HOSTILE_RESERVED(carom_query_desc, reserved)},
                   true);
}
inline Argument distance_desc(Context& c) {
  auto d = fresh<carom_distance_desc>(carom_distance_desc_init);
  d.simplex = c.source.below(3), d.narrow_phase = c.source.below(2), d.pair_routines = c.source.below(2);
  return in_struct(
      c, d,
      {HOSTILE_CHOICE(carom_distance_desc, simplex, 3u), HOSTILE_CHOICE(carom_distance_desc, narrow_phase, 2u),
       HOSTILE_CHOICE(carom_distance_desc, pair_routines, 2u),
       HOSTILE_NUMBERS(carom_distance_desc, tolerance, 1, {kLeast, 1}),
       HOSTILE_NUMBERS(carom_distance_desc, hybrid_margin, 1, {0, 1e9}),
       HOSTILE_CHOICE(carom_distance_desc, gjk_iterations, 100000000u),
       HOSTILE_CHOICE(carom_distance_desc, epa_iterations, 100000000u)},
      true);
}
inline Argument motion(Context& c) {
  auto d = fresh<carom_motion>(carom_motion_init);
  for (double& x : d.position) x = c.between(-2, 2);
  for (double& x : d.linear_velocity) x = c.between(-1, 1);
  return in_struct(c, d,
                   {HOSTILE_RESERVED(carom_motion, reserved), HOSTILE_NUMBERS(carom_motion, position, 3, any()),
                    HOSTILE_UNIT(carom_motion, orientation, 4), HOSTILE_NUMBERS(carom_motion, center, 3, any()),
                    HOSTILE_NUMBERS(carom_motion, linear_velocity, 3, any()),
                    HOSTILE_NUMBERS(carom_motion, angular_velocity, 3, any())});
}
inline Argument draw_desc(Context& c) {
  auto d = fresh<carom_draw_desc>(carom_draw_desc_init);
  d.what = c.source.below(64), d.colouring = c.source.below(2);
  return in_struct(
      c, d,
      {HOSTILE_BITS(carom_draw_desc, what, 63u), HOSTILE_CHOICE(carom_draw_desc, colouring, 2u),
       HOSTILE_RESERVED(carom_draw_desc, reserved), HOSTILE_NUMBERS(carom_draw_desc, scale, 1, {kLeast, kMost})},
      true);
}
constexpr int kQuestions = 3;
inline Argument rays(Context& c) {
  carom_rays r = {};
  r.struct_size = sizeof r, r.scalar = CAROM_SCALAR_F64, r.count = kQuestions;
  auto *o = static_cast<double*>(c.take(8 * 3 * kQuestions)), *d = static_cast<double*>(c.take(8 * 3 * kQuestions));
  for (int i = 0; i < 3 * kQuestions; ++i) o[i] = c.between(-3, 3), d[i] = c.between(-1, 1);
  if (c.source.below(4) == 3) o[0] = kNan;  // a bad ray spoils no other
  r.origins = o, r.directions = d;
  if (c.source.below(2)) r.max = d;
  return in_struct(c, r,
                   {HOSTILE_CHOICE(carom_rays, scalar, 2u), HOSTILE_POINTER(carom_rays, origins),
                    HOSTILE_POINTER(carom_rays, directions)});
}
template <class Hits, class Record>
Argument hits(Context& c) {
  Hits h = {};
  h.struct_size = sizeof h, h.scalar = c.source.below(2) ? CAROM_SCALAR_F32 : CAROM_SCALAR_F64;
  h.records = static_cast<Record*>(c.take(sizeof(Record) * kQuestions));
  h.outcomes = static_cast<uint32_t*>(c.take(4 * kQuestions));
  h.times = c.take(8 * kQuestions), h.normals = c.take(24 * kQuestions), h.points = c.take(24 * kQuestions);
  return in_struct(c, h, {HOSTILE_CHOICE(Hits, scalar, 2u)});
}
/// Questions whose last shape, or the last number of whose last position, is wrong.
template <class Questions, class Positions>
void add_wrong_lasts(Context& c, Argument& a, const Questions& q, const carom_shape* Questions::*shapes,
                     Positions Questions::*positions, bool may_be_null) {
  for (const Wrong& w : wrong_handles(c, kShape, may_be_null)) {
    Questions bad = q;
    auto* some = static_cast<carom_shape*>(c.take(8 * kQuestions));
    std::memcpy(some, q.*shapes, 8 * kQuestions);
    some[kQuestions - 1] = w.value.u;
    bad.*shapes = some;
    a.wrong.push_back({"last shape: " + w.what, of(c.keep(bad)), w.codes});
  }
  for (const double x : {kNan, kInf}) {
    Questions bad = q;
    auto* some = static_cast<double*>(c.take(8 * 3 * kQuestions));
    std::memcpy(some, q.*positions, 8 * 3 * kQuestions);
    some[3 * kQuestions - 1] = x;
    bad.*positions = some;
    a.wrong.push_back({"last position: " + shown(x), of(c.keep(bad)), kNotFinite});
  }
}
inline Argument query_shapes(Context& c, bool move, bool& half_space) {
  carom_query_shapes q = {};
  q.struct_size = sizeof q, q.scalar = CAROM_SCALAR_F64, q.count = kQuestions;
  auto* shapes = static_cast<carom_shape*>(c.take(8 * kQuestions));
  auto *p = static_cast<double*>(c.take(8 * 3 * kQuestions)), *m = static_cast<double*>(c.take(8 * 3 * kQuestions)),
       *t = static_cast<double*>(c.take(8 * 4 * kQuestions));
  half_space = false;
  for (int i = 0; i < kQuestions; ++i) {
    bool none = false;
    const unsigned which = c.source.below(5);
    shapes[i] = which == 4                          ? 0
                : c.own.live[kShape].size() > which ? c.own.live[kShape][which].handle
                                                    : pick(c, kShape, none);
    for (int k = 0; k < 3; ++k) p[3 * i + k] = c.between(-3, 3), m[3 * i + k] = c.between(-2, 2);
    turn(c, 4, t + 4 * i);
  }
  q.shapes = shapes, q.positions = p, q.orientations = t;
  if (move) q.motions = m;
  Argument a =
      in_struct(c, q, {HOSTILE_CHOICE(carom_query_shapes, scalar, 2u), HOSTILE_POINTER(carom_query_shapes, positions)});
  add_wrong_lasts(c, a, q, &carom_query_shapes::shapes, &carom_query_shapes::positions, true);
  return a;
}

inline Argument no_device() { return {of(nullptr), {{"null", of(nullptr), kNull}}}; }
inline Argument shape_but_scenery(Context& c);
inline Argument shape_pairs(Context& c) {
  carom_pairs q = {};
  q.struct_size = sizeof q, q.count = kQuestions;
  auto* shapes = static_cast<carom_shape*>(c.take(8 * kQuestions));
  auto *p = static_cast<double*>(c.take(8 * 3 * kQuestions)), *t = static_cast<double*>(c.take(8 * 4 * kQuestions));
  bool none = false;
  for (int i = 0; i < kQuestions; ++i) {
    shapes[i] = shape_but_scenery(c).good.u;
    for (int k = 0; k < 3; ++k) p[3 * i + k] = c.between(-3, 3);
    turn(c, 4, t + 4 * i);
    none = none || !shapes[i];
  }
  q.shapes_a = q.shapes_b = shapes, q.positions_a = q.positions_b = p, q.orientations_a = q.orientations_b = t;
  Argument a = in_struct(c, q,
                         {HOSTILE_RESERVED(carom_pairs, reserved), HOSTILE_POINTER(carom_pairs, shapes_a),
                          HOSTILE_POINTER(carom_pairs, shapes_b), HOSTILE_POINTER(carom_pairs, positions_a),
                          HOSTILE_POINTER(carom_pairs, positions_b), HOSTILE_POINTER(carom_pairs, orientations_a),
                          HOSTILE_POINTER(carom_pairs, orientations_b)});
  a.impossible = none;
  add_wrong_lasts(c, a, q, &carom_pairs::shapes_b, &carom_pairs::positions_a, false);
  return a;
}

inline Argument character_desc(Context& c, bool has_body = false) {
  auto d = fresh<carom_character_desc>(carom_character_desc_init);
  using T = carom_character_desc;
  bool none = false;
  if (has_body) {  // one that is kinematic, if there is
    d.body = pick(c, kBody, none);
    for (const Owned& body : c.own.live[kBody]) {
      uint32_t type = 0;
      carom_body_get_type(c.own.world, body.handle, &type, nullptr);
      if (type == CAROM_BODY_KINEMATIC) d.body = body.handle;
    }
  }
  d.flags = c.source.below(4);
  turn(c, 3, d.up);
  d.max_slope = c.between(0, 1.5), d.step_up = c.between(0, 1), d.step_down = c.between(0, 1);
  d.skin = c.between(0.001, 0.1), d.acceleration = c.between(0, 100), d.air_acceleration = c.between(0, 100);
  Argument a = in_struct(c, d,
                         {HOSTILE_BITS(T, flags, 3u), HOSTILE_UNIT(T, up, 3), HOSTILE_NUMBERS(T, gravity, 1, {0, 1e6}),
                          HOSTILE_NUMBERS(T, fall_speed, 1, {0, 1e6}), HOSTILE_NUMBERS(T, max_slope, 1, {0, 1.57}),
                          HOSTILE_NUMBERS(T, step_up, 1, {0, 1e6}), HOSTILE_NUMBERS(T, step_down, 1, {0, 1e6}),
                          HOSTILE_NUMBERS(T, skin, 1, {1e-6, 1e6}), HOSTILE_NUMBERS(T, acceleration, 1, {0, 1e9}),
                          HOSTILE_NUMBERS(T, air_acceleration, 1, {0, 1e9}), HOSTILE_NUMBERS(T, mass, 1, {0, 1e9}),
                          HOSTILE_NUMBERS(T, push_force, 1, {0, 1e12}), HOSTILE_NUMBERS(T, recover_speed, 1, {0, 1e6}),
                          HOSTILE_HANDLE(T, body, kBody, !has_body)},
                         !has_body);
  a.impossible = none;
  return a;
}
/// @param moves  its shape and its ground are looked at
inline Argument character(Context& c, bool moves) {
  auto d = fresh<carom_character>(carom_character_init);
  using T = carom_character;
  bool none = false;
  d.ground = c.source.below(3);
  for (double& x : d.position) x = c.between(-3, 3);
  for (double& x : d.velocity) x = c.between(-3, 3);
  for (double& x : d.ground_point) x = c.between(-3, 3);
  turn(c, 4, d.orientation), turn(c, 3, d.ground_normal), turn(c, 4, d.ground_orientation);
  d.foot = c.between(0, 1), d.head = c.between(0, 1), d.reach = c.between(0, 1);
  if (moves) d.shape = c.own.live[kShape].empty() ? 0 : c.own.live[kShape][0].handle;
  if (c.source.below(2)) d.ground_body = pick(c, kBody, none);
  d.contact_count = 1;
  d.contact_bodies[0] = pick(c, kBody, none);
  d.contact_speeds[0] = c.between(0, 3);
  turn(c, 3, d.contact_normals);
  Argument a = in_struct(
      c, d,
      {HOSTILE_CHOICE(T, ground, 3u), HOSTILE_NUMBERS(T, position, 3, {-1e12, 1e12}), HOSTILE_UNIT(T, orientation, 4),
       HOSTILE_NUMBERS(T, velocity, 3, {-1e9, 1e9}), HOSTILE_NUMBERS(T, foot, 1, {-1e9, 1e9}),
       HOSTILE_NUMBERS(T, head, 1, {-1e9, 1e9}), HOSTILE_NUMBERS(T, reach, 1, {0, 1e9}),
       HOSTILE_NUMBERS(T, ground_point, 3, {-1e12, 1e12}), HOSTILE_UNIT(T, ground_normal, 3),
       HOSTILE_NUMBERS(T, ground_velocity, 3, {-1e9, 1e9}), HOSTILE_NUMBERS(T, ground_position, 3, {-1e15, 1e15}),
       HOSTILE_UNIT(T, ground_orientation, 4), HOSTILE_WHOLE(T, contact_count, 0, 8), HOSTILE_RESERVED(T, reserved),
       HOSTILE_NUMBERS(T, contact_points, 3, {-1e12, 1e12}), HOSTILE_UNIT(T, contact_normals, 3),
       HOSTILE_NUMBERS(T, contact_speeds, 1, {0, 2e9})});
  if (moves) {
    const Argument more = in_struct(c, d, {HOSTILE_HANDLE(T, shape, kShape, false)});
    a.wrong.insert(a.wrong.end(), more.wrong.begin(), more.wrong.end());
  }
  a.impossible = none;
  return a;
}
/// One that a call changes.
inline Argument changed_character(Context& c, bool moves) {
  Argument a = character(c, moves);
  a.out = const_cast<void*>(a.good.p), a.out_size = sizeof(carom_character);
  return a;
}

inline Argument vehicle_desc(Context& c) {
  auto d = fresh<carom_vehicle_desc>(carom_vehicle_desc_init);
  using T = carom_vehicle_desc;
  for (const Owned& body : c.own.live[kBody]) {
    uint32_t type = 0;
    carom_body_get_type(c.own.world, body.handle, &type, nullptr);
    if (type == CAROM_BODY_DYNAMIC) d.chassis = body.handle;
  }
  d.flags = c.source.below(4);
  Argument a = in_struct(c, d,
                         {HOSTILE_BITS(T, flags, 3u),
                          HOSTILE_HANDLE(T, chassis, kBody, false),
                          HOSTILE_UNIT(T, up, 3),
                          HOSTILE_UNIT(T, forward, 3),
                          HOSTILE_WHOLE(T, torque_count, 1, 8),
                          HOSTILE_WHOLE(T, gear_count, 1, 8),
                          HOSTILE_NUMBERS(T, torque_speeds, 4, {0, 1e5}),
                          HOSTILE_NUMBERS(T, torques, 4, {0, 1e7}),
                          HOSTILE_NUMBERS(T, idle_speed, 1, {1, 1e5}),
                          HOSTILE_NUMBERS(T, max_speed, 1, {90, 1e5}),
                          HOSTILE_NUMBERS(T, engine_inertia, 1, {1e-3, 1e6}),
                          HOSTILE_NUMBERS(T, engine_drag, 1, {0, 1e7}),
                          HOSTILE_NUMBERS(T, gears, 5, {1e-3, 1e3}),
                          HOSTILE_NUMBERS(T, reverse, 1, {1e-3, 1e3}),
                          HOSTILE_NUMBERS(T, final_drive, 1, {1e-3, 1e3}),
                          HOSTILE_NUMBERS(T, clutch_torque, 1, {0, 1e7}),
                          HOSTILE_NUMBERS(T, shift_up, 1, {0, 1e5}),
                          HOSTILE_NUMBERS(T, shift_down, 1, {0, 1e5}),
                          HOSTILE_NUMBERS(T, shift_time, 1, {0, 10}),
                          HOSTILE_NUMBERS(T, limited_slip, 1, {0, 1e7})});
  a.impossible = !d.chassis;
  return a;
}
inline Argument wheel_desc(Context& c) {
  auto d = fresh<carom_wheel_desc>(carom_wheel_desc_init);
  using T = carom_wheel_desc;
  d.drive = 1, d.handbrake = 500, d.max_steer = c.between(-1, 1);
  for (double& x : d.position) x = c.between(-1, 1);
  if (c.source.below(3) == 2 && !c.own.live[kShape].empty()) d.shape = c.own.live[kShape][0].handle;
  return in_struct(c, d,
                   {HOSTILE_HANDLE(T, shape, kShape, true),        HOSTILE_NUMBERS(T, position, 3, {-1e6, 1e6}),
                    HOSTILE_NUMBERS(T, radius, 1, {1e-3, 1e3}),    HOSTILE_NUMBERS(T, inertia, 1, {1e-9, 1e6}),
                    HOSTILE_NUMBERS(T, travel, 1, {1e-3, 1e3}),    HOSTILE_NUMBERS(T, stiffness, 1, {0, 1e9}),
                    HOSTILE_NUMBERS(T, damping_bump, 1, {0, 1e8}), HOSTILE_NUMBERS(T, damping_rebound, 1, {0, 1e8}),
                    HOSTILE_NUMBERS(T, anti_roll, 1, {0, 1e9}),    HOSTILE_NUMBERS(T, max_steer, 1, {-1.5, 1.5}),
                    HOSTILE_NUMBERS(T, drive, 1, {0, 1e3}),        HOSTILE_NUMBERS(T, brake, 1, {0, 1e7}),
                    HOSTILE_NUMBERS(T, handbrake, 1, {0, 1e7}),    HOSTILE_NUMBERS(T, rolling, 1, {0, 1}),
                    HOSTILE_NUMBERS(T, grip, 1, {0, 10}),          HOSTILE_NUMBERS(T, side_grip, 1, {0, 10}),
                    HOSTILE_NUMBERS(T, peak_slip, 1, {1e-3, 1}),   HOSTILE_NUMBERS(T, side_peak_slip, 1, {1e-3, 1}),
                    HOSTILE_NUMBERS(T, slide, 1, {0, 1}),          HOSTILE_NUMBERS(T, slide_slip, 1, {1.01, 100}),
                    HOSTILE_NUMBERS(T, relaxation, 1, {0.01, 10})});
}
inline Argument vehicle_input(Context& c) {
  auto d = fresh<carom_vehicle_input>(carom_vehicle_input_init);
  using T = carom_vehicle_input;
  d.throttle = c.source.unit(), d.brake = c.source.unit(), d.steer = c.between(-1, 1);
  return in_struct(
      c, d,
      {HOSTILE_WHOLE(T, gear, -1, 5), HOSTILE_NUMBERS(T, throttle, 1, {0, 1}), HOSTILE_NUMBERS(T, brake, 1, {0, 1}),
       HOSTILE_NUMBERS(T, handbrake, 1, {0, 1}), HOSTILE_NUMBERS(T, steer, 1, {-1, 1})});
}
inline Argument vehicle_state(Context& c) {
  auto d = fresh<carom_vehicle>(carom_vehicle_init);
  using T = carom_vehicle;
  d.engine_speed = c.between(0, 500);
  Argument a = in_struct(c, d,
                         {HOSTILE_WHOLE(T, gear, -1, 5), HOSTILE_NUMBERS(T, engine_speed, 1, {0, 1e6}),
                          HOSTILE_NUMBERS(T, shifting, 1, {0, 10}), HOSTILE_NUMBERS(T, since_shift, 1, {0, 1e3})});
  a.out = const_cast<void*>(a.good.p), a.out_size = sizeof d;
  return a;
}
inline Argument wheel_state(Context& c) {
  auto d = fresh<carom_wheel>(carom_wheel_init);
  using T = carom_wheel;
  d.spin = c.between(-50, 50);
  Argument a =
      in_struct(c, d,
                {HOSTILE_NUMBERS(T, spin, 1, {-1e5, 1e5}), HOSTILE_NUMBERS(T, angle, 1, {-3.1415926, 3.1415926}),
                 HOSTILE_NUMBERS(T, slip, 1, {-1e3, 1e3}), HOSTILE_NUMBERS(T, side_slip, 1, {-1e3, 1e3})});
  a.out = const_cast<void*>(a.good.p), a.out_size = sizeof d;
  return a;
}

/// Rows of bulk calls: [handles], n, array, stride after the field and the scalar.
struct Bulk {
  Argument field, scalar, list, n, array, stride;
};
template <class Id>
Bulk bulk(Context& c, const std::vector<Id>& ids, std::initializer_list<std::pair<uint32_t, int>> fields,
          uint32_t known, bool write) {
  Bulk b;
  const auto& [field, scalars] = fields.begin()[c.source.below(static_cast<unsigned>(fields.size()))];
  b.field = {of(uint64_t(field)),
             {{"unknown field", of(uint64_t(known)), kEnum}, {"all bits", of(uint64_t(0xFFFFFFFF)), kEnum}}};
  b.scalar = {of(uint64_t(CAROM_SCALAR_F64)),
              {{"unknown scalar", of(uint64_t(2)), kEnum}, {"all bits", of(uint64_t(0xFFFFFFFF)), kEnum}}};
  const std::size_t n = ids.size(), bytes = 8 * static_cast<std::size_t>(scalars);
  auto* list = static_cast<Id*>(c.take(sizeof(Id) * n + 1));
  if (n) std::memcpy(list, ids.data(), sizeof(Id) * n);
  b.list = fixed(list);
  b.n = fixed_number(n);
  if (write) {
    auto* values = static_cast<double*>(c.take(bytes * n + 1));
    for (std::size_t i = 0; i < n; ++i) {
      for (int k = 0; k < scalars; ++k)
        values[i * static_cast<std::size_t>(scalars) + static_cast<std::size_t>(k)] = c.between(0.5, 2);
      if (field == CAROM_FIELD_ORIENTATION) turn(c, 4, values + 4 * i);
      if (field == CAROM_FIELD_POSE) turn(c, 4, values + 7 * i + 3);
    }
    b.array = fixed(values);
    if (n)
      for (const double x : {kNan, kInf, -kInf}) {  // the last of all: those before it are not written
        auto* bad = static_cast<double*>(c.take(bytes * n));
        std::memcpy(bad, values, bytes * n);
        bad[static_cast<std::size_t>(scalars) * n - 1] = x;
        b.array.wrong.push_back({"last is " + shown(x), of(bad), kNotFinite | kNotUnit});
      }
  } else {
    b.array = out(c, bytes * n + 1);
    b.array.wrong.clear();
  }
  if (n) b.array.wrong.push_back({"null", of(nullptr), kNull});
  b.stride = fixed_number(0);
  for (const uint64_t s : {uint64_t(1), uint64_t(bytes - 1)})
    b.stride.wrong.push_back({"stride " + std::to_string(s), of(s), kSmall});
  return b;
}
inline std::vector<carom_body> bodies_for(Context& c) {
  std::vector<carom_body> some;
  for (const Owned& o : c.own.live[kBody])
    if (some.size() < 2) some.push_back(o.handle);
  return some;
}
/// The list argument with its last handle replaced by each wrong one.
inline void wrong_last(Context& c, Argument& list, const std::vector<uint64_t>& ids, Kind kind = kBody) {
  if (ids.empty()) return;
  for (const Wrong& w : wrong_handles(c, kind, false)) {
    auto* bad = static_cast<carom_body*>(c.take(8 * ids.size()));
    std::memcpy(bad, ids.data(), 8 * ids.size());
    bad[ids.size() - 1] = w.value.u;
    list.wrong.push_back({"last: " + w.what, of(bad), w.codes});
  }
}
inline uint32_t kind_of_joint(Context& c, carom_joint joint) {
  auto d = fresh<carom_joint_desc>(carom_joint_desc_init);
  carom_joint_get(c.own.world, joint, &d, nullptr);
  return d.kind;
}
/// A body that is one of a tree, and how many coordinates that has.
struct Tree {
  Argument body, n;
  uint64_t size = 0;
};
inline Tree some_tree(Context& c) {
  Tree t;
  t.body = handle(c, kBody), t.body.impossible = true;
  for (const Owned& o : c.own.live[kBody])
    if (carom_tree_get_coordinates(c.own.world, o.handle, nullptr, 0, 0, &t.size, nullptr) == CAROM_OK && t.size) {
      t.body.good = of(o.handle), t.body.impossible = false;
      break;
    }
  t.n = fixed_number(t.size);
  t.n.wrong.push_back({"one more", of(t.size + 1), kRange});
  t.n.wrong.push_back({"a lot", of(~uint64_t(0)), kRange});
  return t;
}
inline uint32_t size_of_set(Context& c) {
  uint64_t n = 0;
  if (!c.own.live[kParticles].empty())
    carom_particles_get_count(c.own.world, c.own.live[kParticles][0].handle, &n, nullptr);
  return static_cast<uint32_t>(n);
}
/// The first set alone: its size is known.
inline Argument first_set(Context& c) {
  Argument a = handle(c, kParticles);
  if (!a.impossible) a.good = of(c.own.live[kParticles][0].handle);
  return a;
}
inline std::vector<uint32_t> first_particles(Context& c) {
  std::vector<uint32_t> some;
  for (uint32_t i = 0; i < size_of_set(c) && i < 2; ++i) some.push_back(i);
  return some;
}
inline Argument shape_but_scenery(Context& c) {
  Argument a = handle(c, kShape);
  if (!a.impossible)
    a.good =
        of(c.own.live[kShape][c.source.below(std::min<unsigned>(4, static_cast<unsigned>(c.own.live[kShape].size())))]
               .handle);
  return a;
}
inline Argument scenery_shape(Context& c) {
  Argument a = handle(c, kShape);
  if (!a.impossible) a.good = of(c.own.live[kShape].back().handle);
  return a;
}
inline Argument string(Context& c, const char* good) {
  auto* s = static_cast<char*>(std::memcpy(c.take(std::strlen(good) + 1), good, std::strlen(good) + 1));
  return {of(s), {{"null", of(nullptr), kNull}}};
}

/// Two copies of the caller's own world, and a column of what can be written. It ends with the arguments.
inline carom_batch* make_batch(Context& c) {
  carom_batch* made = nullptr;
  if (carom_batch_create(c.own.engine, &made, nullptr) != CAROM_OK) return nullptr;
  c.batches.emplace_back(made, [](carom_batch* b) { carom_batch_destroy(b, nullptr); });
  uint64_t first = 0;
  if (carom_batch_add_worlds(made, c.own.world, 2, &first, nullptr) != CAROM_OK) return nullptr;
  auto column = fresh<carom_batch_column>(carom_batch_column_init);
  auto* gravity = static_cast<double*>(c.take(48));
  for (int i = 0; i < 6; ++i) gravity[i] = c.between(-10, 10);
  column.source = CAROM_COLUMN_GRAVITY, column.when = CAROM_WHEN_BEFORE_STEP, column.n = 1, column.data = gravity;
  uint32_t number = 0;
  return carom_batch_add_column(made, &column, &number, nullptr) == CAROM_OK ? made : nullptr;
}
inline Argument batch(Context& c) {
  carom_batch* const made = make_batch(c);
  Argument a{of(static_cast<const void*>(made)), {{"null", of(nullptr), kNull}}};
  a.impossible = !made;
  return a;
}
inline Argument batch_column(Context& c) {
  auto d = fresh<carom_batch_column>(carom_batch_column_init);
  bool none = false;
  const uint64_t body = pick(c, kBody, none);
  d.field = CAROM_FIELD_POSITION, d.when = c.source.below(3), d.scalar = c.source.below(2);
  d.n = 1, d.handles = static_cast<const uint64_t*>(static_cast<const void*>(c.keep(body)));
  d.data = c.take(48);
  Argument a = in_struct(c, d,
                         {HOSTILE_CHOICE(carom_batch_column, source, 8u), HOSTILE_CHOICE(carom_batch_column, field, 9u),
                          HOSTILE_CHOICE(carom_batch_column, when, 3u), HOSTILE_CHOICE(carom_batch_column, scalar, 2u),
                          HOSTILE_RESERVED(carom_batch_column, reserved), HOSTILE_POINTER(carom_batch_column, handles),
                          HOSTILE_POINTER(carom_batch_column, data)});
  const auto worse = [&](const char* what, Codes codes, auto&& spoil) {
    carom_batch_column bad = d;
    spoil(bad);
    a.wrong.push_back({what, of(static_cast<const void*>(c.keep(bad))), codes});
  };
  if (c.wants_wrong) {
    worse("no things", kRange, [](auto& b) { b.n = 0; });
    worse("more things than memory", kRange, [](auto& b) { b.n = ~uint64_t(0); });
    worse("a world that is none", kRange, [](auto& b) { b.world = 2; });
    worse("a short stride", kSmall, [](auto& b) { b.stride = 8; });
    worse("a stride beyond all", kRange, [](auto& b) { b.stride = ~uint64_t(0); });
    worse("rays of another source", kUnsupported, [&](auto& b) { b.rays = static_cast<const double*>(c.take(56)); });
    worse("mass is read only", kUnsupported,
          [](auto& b) { b.field = CAROM_FIELD_MASS, b.when = CAROM_WHEN_BEFORE_STEP; });
    for (const Wrong& w : wrong_handles(c, kBody, false)) {
      const uint64_t handle = w.value.u;
      worse(w.what.c_str(), w.codes,
            [&](auto& b) { b.handles = static_cast<const uint64_t*>(static_cast<const void*>(c.keep(handle))); });
    }
  }
  a.impossible = none;
  return a;
}
inline Argument world_number(Context&) {
  Argument a = fixed_number(1);
  for (const uint64_t bad : {uint64_t(2), ~uint64_t(0)}) a.wrong.push_back({"a world that is none", of(bad), kRange});
  return a;
}
inline Argument all_worlds(Context&) {
  Argument a = fixed_number(2);
  for (const uint64_t bad : {uint64_t(0), uint64_t(3), ~uint64_t(0)}) a.wrong.push_back({"n", of(bad), kRange});
  return a;
}
inline Argument perhaps_mask(Context& c) {
  if (c.source.below(2) == 0) return fixed(nullptr);
  auto* mask = static_cast<uint8_t*>(c.take(2));
  mask[c.source.below(2)] = 1;
  return fixed(mask);
}
inline Argument columns(Context& c) {
  const uint32_t good = 0, bad = 1;
  return {of(static_cast<const void*>(c.keep(good))),
          {{"null", of(nullptr), kNull}, {"a column that is none", of(static_cast<const void*>(c.keep(bad))), kRange}}};
}

struct Row {
  const char* name;
  Call (*make)(Context& c);
};

#define ROW(f, ...)                                                    \
  {                                                                    \
#f, [](Context & c) -> Call { return call(#f, f, {__VA_ARGS__}); } \
  }
#define ROW_THAT(f, that, ...)                                                                 \
  {                                                                                            \
#f, [](Context& c) -> Call { Call made = call(#f, f, {__VA_ARGS__}); made.that; return made; } \
  }
#define GET_LIST(f, T)                                                                                                                      \
  {                                                                                                                                         \
#f, [](Context& c) -> Call { List l = list(c, sizeof(T)); return call(#f, f, {world(c), l.dst, l.stride, l.capacity, l.count, error(c)}); } \
  }
#define GET_HANDLES(f)                                                                                                                                       \
  {                                                                                                                                                          \
#f, [](Context& c) -> Call { Argument dst = out(c, 8 * 64); dst.wrong.clear(); return call(#f, f, {world(c), dst, fixed_number(64), out(c, 8), error(c)}); } \
  }
/// The caller's size of a struct that is to be filled in.
inline Argument struct_size(std::uint32_t size) {
  Argument a = fixed_number(size);
  for (const std::uint32_t bad : {0u, 4u, 9u, 4104u, 0xFFFFFFFFu})
    a.wrong.push_back({"a size of no version", fixed_number(bad).good, code(CAROM_E_STRUCT_SIZE)});
  return a;
}
#define INIT(f, T) ROW(f, out(c, sizeof(T)), struct_size(sizeof(T)))

/// A snapshot of the caller's own world, and all that may become of one on its way.
struct Snapshot {
  Argument bytes, size;
};
inline Snapshot snapshot(Context& c, uint32_t flags) {
  uint64_t size = 0;
  carom_world_save(c.own.world, flags, nullptr, 0, &size, nullptr);
  auto* good = static_cast<char*>(c.take(size + 1));
  carom_world_save(c.own.world, flags, good, size, &size, nullptr);
  Argument bytes = fixed(good), n = fixed_number(size);
  bytes.wrong.push_back({"null", of(nullptr), kNull});
  for (const uint64_t at : {uint64_t(0), uint64_t(9), size / 2, size - 1}) {  // one bit is another
    auto* bad = static_cast<char*>(std::memcpy(c.take(size + 1), good, size));
    bad[at] = static_cast<char>(bad[at] ^ 16);
    bytes.wrong.push_back({"damaged at " + std::to_string(at), of(bad), kCorrupt | kUnsupported | kMismatch});
  }
  for (const uint64_t cut : {uint64_t(0), uint64_t(7), size / 2, size - 1})
    n.wrong.push_back({"cut off at " + std::to_string(cut), of(cut), kCorrupt, 2});
  return {bytes, n};
}

inline const Row kRows[] = {
    // base
    ROW(carom_version, out(c, 4), out(c, 4), out(c, 4)),
    {"carom_result_name", [](Context& c) { return call("carom_result_name", carom_result_name, {fixed_number(c.source.below(64) - 40u)}); }},
    {"carom_result_remedy", [](Context& c) { return call("carom_result_remedy", carom_result_remedy, {fixed_number(c.source.below(64) - 40u)}); }},
    {"carom_force_field_name", [](Context& c) { return call("carom_force_field_name", carom_force_field_name, {fixed_number(c.source.below(64))}); }},
    {"carom_stage_name", [](Context& c) { return call("carom_stage_name", carom_stage_name, {fixed_number(c.source.below(64))}); }},
    {"carom_effect_name", [](Context& c) { return call("carom_effect_name", carom_effect_name, {fixed_number(c.source.below(64))}); }},
    {"carom_abi_manifest", [](Context&) { return call("carom_abi_manifest", carom_abi_manifest, {}); }},
    {"carom_abi_check", [](Context& c) {
       Argument layout = string(c, carom_abi_manifest());
       for (const char* wrong : {"", "carom", "carom 0.9", "ELF"}) layout.wrong.push_back({wrong, of(wrong), kRange});
       return call("carom_abi_check", carom_abi_check, {layout, error(c)});
     }},
    // engine
    INIT(carom_engine_desc_init, carom_engine_desc),
    INIT(carom_jobs_desc_init, carom_jobs_desc),
    {"carom_engine_create", [](Context& c) {
       auto d = fresh<carom_engine_desc>(carom_engine_desc_init);
       carom_engine_desc half = d;
       half.alloc = [](void*, uint64_t, uint64_t) -> void* { return nullptr; };
       Argument desc = in_struct(c, d, {HOSTILE_RESERVED(carom_engine_desc, reserved)}, true);
       desc.wrong.push_back({"alloc without free", of(c.keep(half)), kNull});
       return call("carom_engine_create", carom_engine_create, {desc, out(c, sizeof(void*)), error(c)}).after([](const Value* v) {
         carom_engine_destroy(*static_cast<carom_engine* const*>(v[1].p), nullptr);
       });
     }},
    ROW_THAT(carom_engine_destroy, only_wrong(), engine(c), error(c)),
    {"carom_engine_set_jobs", [](Context& c) {
       auto d = fresh<carom_jobs_desc>(carom_jobs_desc_init);
       carom_jobs_desc many = d;
       many.threads = 257;
       Argument desc = in_struct(c, d, {}, true);
       desc.wrong.push_back({"257 threads", of(c.keep(many)), kRange | kInUse});
       return call("carom_engine_set_jobs", carom_engine_set_jobs, {engine(c), desc, error(c)}).may(kInUse);
     }},
    {"carom_plugin_load", [](Context& c) {
       Argument path = string(c, CAROM_PLUGIN_DIR "/template.so");
       const Codes wrong = code(CAROM_E_PLUGIN_PATH) | code(CAROM_E_PLUGIN_LOAD) | code(CAROM_E_PLUGIN_ABI);
       path.wrong.push_back({"empty", string(c, "").good, wrong});
       path.wrong.push_back({"relative", string(c, "template.so").good, wrong});
       path.wrong.push_back({"a folder", string(c, "/").good, wrong});
       path.wrong.push_back({"nothing there", string(c, "/nothing/there.so").good, wrong});
       path.wrong.push_back({"not an ELF", string(c, CAROM_SOURCE_DIR "/README.md").good, wrong});
       path.wrong.push_back({"very long", string(c, ("/" + std::string(70000, 'x')).c_str()).good, wrong});
       return call("carom_plugin_load", carom_plugin_load, {engine(c), path, out(c, 8), error(c)}).may(code(CAROM_E_ALREADY_EXISTS));
     }},
    {"carom_plugin_register", [](Context& c) {
       static const carom_shape_plugin spare = plugin_of("hostile.spare", kRadius, 1, &kSphereGeometry, point);
       Argument p = fixed(&spare);
       p.wrong.push_back({"null", of(nullptr), kNull});
       const Codes abi = code(CAROM_E_PLUGIN_ABI);
       const auto bad = [&](const char* what, auto&& change) {
         carom_shape_plugin q = spare;
         change(q);
         p.wrong.push_back({what, of(c.keep(q)), abi});
       };
       bad("size 0", [](auto& q) { q.struct_size = 0; });
       bad("size 8", [](auto& q) { q.struct_size = 8; });
       bad("major", [](auto& q) { q.abi_major = 99; });
       bad("flags", [](auto& q) { q.flags = 2; });
       bad("no id", [](auto& q) { q.id = nullptr; });
       bad("no support", [](auto& q) { q.support = nullptr; });
       bad("no params", [](auto& q) { q.params = nullptr; });
       bad("many params", [](auto& q) { q.param_count = 0xFFFFFFFF; });
       return call("carom_plugin_register", carom_plugin_register, {engine(c), p, out(c, 8), error(c)}).may(code(CAROM_E_ALREADY_EXISTS));
     }},
    ROW_THAT(carom_plugins_register_standard, may(code(CAROM_E_UNSUPPORTED)), engine(c), error(c)),
    ROW_THAT(carom_plugin_unload, may(kInUse).ends(kPlugin), engine(c), handle(c, kPlugin), error(c)),
    ROW_THAT(carom_plugin_find, may(code(CAROM_E_NOT_FOUND)), engine(c), string(c, "hostile.ball"), out(c, 8), error(c)),
    ROW(carom_plugin_describe, engine(c), handle(c, kPlugin), out(c, sizeof(void*)), error(c)),
    // shapes
    {"carom_shape_create", [](Context& c) {
       Argument plugin = handle(c, kPlugin);
       const bool ball = !plugin.impossible && plugin.good.u == c.own.live[kPlugin][0].handle;
       Argument n = fixed_number(ball ? 1 : 3);
       for (const uint64_t bad : {uint64_t(0), uint64_t(2), uint64_t(4), ~uint64_t(0)}) n.wrong.push_back({"count", of(bad), kRange});
       return call("carom_shape_create", carom_shape_create, {engine(c), plugin, vector(c, ball ? 1 : 3, {0.01, 100, false, 0.1, 1}), n, out(c, 8), error(c)}).makes(kShape, 4).may(kRange);
     }},
    {"carom_shape_create_named", [](Context& c) {
       Argument name = string(c, "hostile.ball"), n = fixed_number(1);
       name.wrong.push_back({"none of this name", string(c, "bananas").good, code(CAROM_E_NOT_FOUND)});
       name.wrong.push_back({"a path", string(c, "../box").good, kRange});
       name.wrong.push_back({"empty", string(c, "").good, kRange});
       name.wrong.push_back({"very long", string(c, std::string(70000, 'x').c_str()).good, kRange});
       for (const uint64_t bad : {uint64_t(0), uint64_t(2), ~uint64_t(0)}) n.wrong.push_back({"count", of(bad), kRange});
       return call("carom_shape_create_named", carom_shape_create_named, {engine(c), name, vector(c, 1, {0.01, 100, false, 0.1, 1}), n, out(c, 8), error(c)})
           .makes(kShape, 4).may(kRange | code(CAROM_E_NOT_FOUND));
     }},
    ROW_THAT(carom_shape_create_half_space, makes(kShape, 3), engine(c), unit(c, 3), number(c, any()), out(c, 8), error(c)),
    {"carom_shape_create_hull_of", [](Context& c) {
       bool none = false;
       const carom_shape first = pick(c, kShape, none);
       auto* parts = static_cast<carom_shape*>(c.take(16));
       parts[0] = parts[1] = first;
       Argument list = fixed(parts), n = fixed_number(2), scales = vector(c, 6, {1e-6, 1e6, false, 0.5, 2});
       list.impossible = none;
       list.wrong.push_back({"null", of(nullptr), kNull});
       for (const Wrong& w : wrong_handles(c, kShape, false)) {
         auto* bad = static_cast<carom_shape*>(std::memcpy(c.take(16), parts, 16));
         bad[1] = w.value.u;
         list.wrong.push_back({"second: " + w.what, of(bad), w.codes});
       }
       for (const uint64_t bad : {uint64_t(0), uint64_t(4097), ~uint64_t(0)}) n.wrong.push_back({"count", of(bad), kRange});
       Argument positions = vector(c, 6, {-1e8, 1e8, false, -1, 1}), turns = fixed(nullptr);
       const auto optional = [](Argument& a) {
         std::erase_if(a.wrong, [](const Wrong& w) { return w.what == "null"; });
       };
       optional(positions), optional(scales);
       return call("carom_shape_create_hull_of", carom_shape_create_hull_of, {engine(c), list, n, positions, turns, scales, number(c, {0, 1e8, false, 0, 1}), out(c, 8), error(c)})
           .makes(kShape, 7).may(code(CAROM_E_UNSUPPORTED) | code(CAROM_E_LIMIT));
     }},
    {"carom_shape_get_parts", [](Context& c) {
       Argument count{of(c.keep(uint64_t(4096))), {{"null", of(nullptr), kNull}}};
       return call("carom_shape_get_parts", carom_shape_get_parts, {engine(c), handle(c, kShape), fixed(c.take(8 * 4096)), fixed(nullptr), fixed(nullptr), fixed(nullptr), count, fixed(nullptr), error(c)});
     }},
    ROW_THAT(carom_shape_destroy, may(kInUse).ends(kShape), engine(c), handle(c, kShape), error(c)),
    ROW(carom_shape_get_info, engine(c), handle(c, kShape), out_struct<carom_shape_info>(c), error(c)),
    {"carom_shape_get_params", [](Context& c) {
       Argument count{of(c.keep(uint64_t(3))), {{"null", of(nullptr), kNull}}};
       return call("carom_shape_get_params", carom_shape_get_params, {engine(c), shape_but_scenery(c), out(c, 24), count, error(c)});
     }},
    {"carom_shape_support", [](Context& c) {
       Argument dirs = vector(c, 6, {-DBL_MAX, DBL_MAX, false, 0.1, 2});
       dirs.wrong.push_back({"a zero direction", of(c.take(48)), kRange});
       return call("carom_shape_support", carom_shape_support, {engine(c), shape_but_scenery(c), dirs, fixed_number(2), out(c, 48), error(c)});
     }},
    INIT(carom_mesh_desc_init, carom_mesh_desc),
    INIT(carom_height_field_desc_init, carom_height_field_desc),
    {"carom_shape_create_mesh", [](Context& c) {
       auto d = fresh<carom_mesh_desc>(carom_mesh_desc_init);
       auto* v = static_cast<double*>(c.take(8 * 9));
       for (int i = 0; i < 9; ++i) v[i] = c.between(-3, 3) + (i % 4 == 0);
       const uint32_t abc[3] = {0, 1, 2}, far[3] = {0, 1, 3};
       d.vertices = v, d.vertex_count = 3, d.triangles = static_cast<uint32_t*>(std::memcpy(c.take(12), abc, 12)), d.triangle_count = 1;
       Argument desc = in_struct(c, d, {HOSTILE_BITS(carom_mesh_desc, flags, 1u), HOSTILE_POINTER(carom_mesh_desc, vertices), HOSTILE_POINTER(carom_mesh_desc, triangles)});
       const auto bad = [&](const char* what, Codes codes, auto&& change) {
         carom_mesh_desc q = d;
         change(q);
         desc.wrong.push_back({what, of(c.keep(q)), codes});
       };
       bad("an index beyond", kRange, [&](auto& q) { q.triangles = static_cast<uint32_t*>(std::memcpy(c.take(12), far, 12)); });
       bad("no vertices", kRange, [](auto& q) { q.vertex_count = 0; });
       bad("no triangles", kRange, [](auto& q) { q.triangle_count = 0; });
       bad("too many triangles", kRange | kLimit, [](auto& q) { q.triangle_count = ~uint64_t(0); });
       bad("too many vertices", kRange | kLimit, [](auto& q) { q.vertex_count = ~uint64_t(0); });
       for (const auto& [x, codes] : wrong_numbers({-1e8, 1e8})) {
         auto* w = static_cast<double*>(std::memcpy(c.take(72), v, 72));
         w[5] = x;
         bad("a vertex", codes, [&](auto& q) { q.vertices = w; });
       }
       bad("no area", kRange, [&](auto& q) { q.vertices = static_cast<double*>(c.take(72)); });
       return call("carom_shape_create_mesh", carom_shape_create_mesh, {engine(c), desc, out(c, 8), error(c)}).makes(kShape, 2).may(kRange);
     }},
    {"carom_shape_create_height_field", [](Context& c) {
       auto d = fresh<carom_height_field_desc>(carom_height_field_desc_init);
       auto* h = static_cast<double*>(c.take(8 * 6));
       for (int i = 0; i < 6; ++i) h[i] = c.between(-1, 1);
       d.columns = 3, d.rows = 2, d.heights = h;
       Argument desc = in_struct(c, d, {HOSTILE_BITS(carom_height_field_desc, flags, 0u), HOSTILE_POINTER(carom_height_field_desc, heights),
                                        HOSTILE_CHOICE(carom_height_field_desc, columns, 16385u), HOSTILE_CHOICE(carom_height_field_desc, rows, 16385u),
                                        HOSTILE_NUMBERS(carom_height_field_desc, spacing, 2, {kLeast, kMost})});
       for (const uint32_t one : {0u, 1u}) {
         carom_height_field_desc q = d;
         q.rows = one;
         desc.wrong.push_back({"rows", of(c.keep(q)), kRange});
       }
       carom_height_field_desc holes = d, infinite = d;
       auto *w = static_cast<double*>(c.take(48)), *i = static_cast<double*>(std::memcpy(c.take(48), h, 48));
       for (int k = 0; k < 6; ++k) w[k] = kNan;
       i[4] = kInf;
       holes.heights = w, infinite.heights = i;
       desc.wrong.push_back({"nothing but holes", of(c.keep(holes)), kRange});
       desc.wrong.push_back({"an infinite height", of(c.keep(infinite)), kNotFinite});
       return call("carom_shape_create_height_field", carom_shape_create_height_field, {engine(c), desc, out(c, 8), error(c)}).makes(kShape, 2);
     }},
    ROW_THAT(carom_shape_get_scenery_info, may(kUnsupported), engine(c), scenery_shape(c), out_struct<carom_scenery_info>(c), error(c)),
    {"carom_shape_get_triangles", [](Context& c) {
       Argument first = fixed_number(0), count{of(c.keep(uint64_t(2))), {{"null", of(nullptr), kNull}}};
       first.wrong.push_back({"beyond all", of(~uint64_t(0)), kRange});
       Argument corners = out(c, 9 * 8 * 2);
       corners.wrong.clear();  // NULL counts
       return call("carom_shape_get_triangles", carom_shape_get_triangles, {engine(c), scenery_shape(c), first, corners, count, out(c, 8), error(c)}).may(kUnsupported);
     }},
    // questions without a world
    INIT(carom_distance_desc_init, carom_distance_desc),
    INIT(carom_cast_desc_init, carom_cast_desc),
    INIT(carom_motion_init, carom_motion),
    ROW(carom_shape_distance, engine(c), shape_but_scenery(c), vector(c, 3, any()), unit(c, 4), shape_but_scenery(c), vector(c, 3, any()), unit(c, 4), distance_desc(c), out_struct<carom_distance>(c), error(c)),
    {"carom_pairs_distance", [](Context& c) {
       Argument stride = fixed_number(sizeof(carom_distance));
       for (const uint64_t s : {4u, 13u}) stride.wrong.push_back({"stride " + std::to_string(s), of(s), kSmall});
       stride.wrong.push_back({"a stride beyond all", of(~uint64_t(0)), kRange});
       return call("carom_pairs_distance", carom_pairs_distance, {engine(c), shape_pairs(c), distance_desc(c), out(c, sizeof(carom_distance) * kQuestions), stride, error(c)});
     }},
    ROW(carom_ray_cast, engine(c), handle(c, kShape), vector(c, 3, any()), unit(c, 4), vector(c, 3, any()), vector(c, 3, any()), number(c, {0, kMost, true, 0, 9}), cast_desc(c), out_struct<carom_cast>(c), error(c)),
    ROW(carom_shape_cast, engine(c), shape_but_scenery(c), vector(c, 3, any()), unit(c, 4), vector(c, 3, any()), shape_but_scenery(c), vector(c, 3, any()), unit(c, 4), cast_desc(c), out_struct<carom_cast>(c), error(c)),
    ROW(carom_shape_time_of_impact, engine(c), shape_but_scenery(c), motion(c), shape_but_scenery(c), motion(c), number(c, {0, 1e9, false, 0, 3}), cast_desc(c), out_struct<carom_cast>(c), error(c)),
    ROW(carom_shape_overlap, engine(c), shape_but_scenery(c), vector(c, 3, any()), unit(c, 4), shape_but_scenery(c), vector(c, 3, any()), unit(c, 4), cast_desc(c), out_struct<carom_overlap>(c), error(c)),
    {"carom_rays_cast", [](Context& c) {
       bool none = false;
       const carom_shape shapes[2] = {pick(c, kShape, none), 0};
       auto* good = static_cast<carom_shape*>(std::memcpy(c.take(16), shapes, 16));
       good[0] = c.own.live[kShape].empty() ? 0 : c.own.live[kShape][0].handle, good[1] = good[0];
       Argument list = fixed(good);
       list.impossible = none;
       list.wrong.push_back({"null", of(nullptr), kNull});
       for (const Wrong& w : wrong_handles(c, kShape, false)) {
         auto* bad = static_cast<carom_shape*>(std::memcpy(c.take(16), good, 16));
         bad[1] = w.value.u;
         list.wrong.push_back({"second: " + w.what, of(bad), w.codes});
       }
       Argument turns = fixed(c.take(64));
       auto* q = static_cast<double*>(const_cast<void*>(turns.good.p));
       turn(c, 4, q), turn(c, 4, q + 4);
       turns.wrong.push_back({"null", of(nullptr), kNull});
       turns.wrong.push_back({"zero", of(c.take(64)), kNotUnit});
       return call("carom_rays_cast", carom_rays_cast, {engine(c), list, vector(c, 6, any()), turns, fixed_number(2), rays(c), cast_desc(c), hits<carom_ray_hits, carom_ray_hit>(c), error(c)});
     }},
    // dials
    {"carom_dial_get_info", [](Context& c) { return call("carom_dial_get_info", carom_dial_get_info, {choice(c, CAROM_DIAL_COUNT), out_struct<carom_dial_info>(c), error(c)}); }},
    ROW(carom_dial_get_count, out(c, 4)),
    {"carom_constant_get_info", [](Context& c) {
       uint32_t count = 0;
       carom_constant_get_count(&count);
       return call("carom_constant_get_info", carom_constant_get_info, {choice(c, count), out_struct<carom_constant_info>(c), error(c)});
     }},
    ROW(carom_constant_get_count, out(c, 4)),
    ROW(carom_attribute_get_info, choice(c, CAROM_ATTRIBUTE_COUNT), out_struct<carom_attribute_info>(c), error(c)),
    {"carom_body_set_attribute", [](Context& c) {
       Argument which = choice(c, CAROM_ATTRIBUTE_COUNT);
       carom_attribute_info info{};
       info.struct_size = sizeof info;
       carom_attribute_get_info(static_cast<uint32_t>(which.good.u), &info, nullptr);
       auto* good = static_cast<double*>(c.take(sizeof info.usual));
       for (uint32_t i = 0; i < info.numbers; ++i) good[i] = std::floor(c.between(std::max(info.min, -3.0), std::min(info.max, 9.0)));
       Argument value{of(good), {{"null", of(nullptr), kNull}}};
       const auto bad = [&](const char* what, uint32_t i, double x, Codes codes) {
         auto* q = static_cast<double*>(std::memcpy(c.take(sizeof info.usual), good, sizeof info.usual));
         q[i] = x;
         value.wrong.push_back({what, of(q), codes});
       };
       bad("nan", info.numbers - 1, kNan, kNotFinite), bad("infinite", 0, kInf, kNotFinite), bad("surplus", 3, 1, kRange);
       if (info.max < DBL_MAX) bad("above", 0, 2 * info.max, kRange), bad("below", 0, info.min - std::fabs(info.max), kRange);
       if (info.is_whole) bad("a fraction", 0, 0.5, kRange);
       return call("carom_body_set_attribute", carom_body_set_attribute, {world(c), handle(c, kBody), which, value, error(c)}).may(kRange | kUnsupported);
     }},
    ROW(carom_body_get_attribute, world(c), handle(c, kBody), choice(c, CAROM_ATTRIBUTE_COUNT), out(c, 32), error(c)),
    {"carom_preset_name", [](Context& c) { return call("carom_preset_name", carom_preset_name, {fixed_number(c.source.below(64))}); }},
    {"carom_preset_get_dial", [](Context& c) {
       return call("carom_preset_get_dial", carom_preset_get_dial, {choice(c, CAROM_PRESET_COUNT), choice(c, CAROM_DIAL_COUNT), out(c, 8), error(c)}).may(code(CAROM_E_NOT_FOUND));
     }},
    {"carom_dial_find", [](Context& c) {
       Argument name = string(c, "substeps");
       name.wrong.push_back({"none of this name", string(c, "bananas").good, code(CAROM_E_NOT_FOUND)});
       name.wrong.push_back({"a constant", string(c, "direct_impact_share").good, code(CAROM_E_READ_ONLY)});
       return call("carom_dial_find", carom_dial_find, {name, out(c, 4), error(c)});
     }},
    // worlds
    INIT(carom_world_desc_init, carom_world_desc),
    {"carom_world_create", [](Context& c) {
       auto d = fresh<carom_world_desc>(carom_world_desc_init);
       Argument desc = in_struct(c, d, {HOSTILE_RESERVED(carom_world_desc, reserved), HOSTILE_NUMBERS(carom_world_desc, gravity, 3, {-1e6, 1e6})}, true);
       carom_world_desc many = d;
       many.body_capacity = ~uint64_t(0);
       desc.wrong.push_back({"capacity", of(c.keep(many)), kRange});
       return call("carom_world_create", carom_world_create, {engine(c), desc, out(c, sizeof(void*)), error(c)}).after([](const Value* v) {
         carom_world_destroy(*static_cast<carom_world* const*>(v[2].p), nullptr);
       });
     }},
    ROW_THAT(carom_world_destroy, only_wrong(), world(c), error(c)),
    {"carom_world_step", [](Context& c) {
       Argument dt = number(c, {1e-9, 1, false, 0.004, 0.02});
       dt.wrong.push_back({"0", of(0.), kRange});
       return call("carom_world_step", carom_world_step, {world(c), dt, error(c)});
     }},
    {"carom_world_set_dial", [](Context& c) {
       const uint32_t dial = c.source.below(CAROM_DIAL_COUNT);
       carom_dial_info info = {};
       info.struct_size = sizeof info;
       carom_dial_get_info(dial, &info, nullptr);
       double good = info.initial;
       if (info.kind == CAROM_DIAL_KIND_CHOICE) good = c.source.below(info.choice_count);
       if (dial == CAROM_DIAL_SUBSTEPS) good = 1 + c.source.below(4);
       Argument which{of(uint64_t(dial)), {{"unknown", of(uint64_t(CAROM_DIAL_COUNT)), kEnum}, {"all bits", of(uint64_t(0xFFFFFFFF)), kEnum}}};
       Argument value{of(good), {}};
       for (const auto& [x, codes] : wrong_numbers({info.min, info.max})) value.wrong.push_back({shown(x), of(x), codes});
       if (info.kind != CAROM_DIAL_KIND_NUMBER) value.wrong.push_back({"not whole", of(info.min + 0.5), kRange});
       return call("carom_world_set_dial", carom_world_set_dial, {world(c), which, value, error(c)}).may(kUnsupported);
     }},
    ROW(carom_world_set_preset, world(c), choice(c, CAROM_PRESET_COUNT), error(c)),
    ROW(carom_world_get_dial, world(c), choice(c, CAROM_DIAL_COUNT), out(c, 8), error(c)),
    ROW(carom_world_set_gravity, world(c), vector(c, 3, {-1e6, 1e6, false, -10, 10}), error(c)),
    ROW(carom_world_get_gravity, world(c), out(c, 24), error(c)),
    ROW(carom_world_get_report, world(c), out_struct<carom_step_report>(c), error(c)),
    GET_LIST(carom_world_get_contacts, carom_contact),
    GET_LIST(carom_world_get_groups, carom_group),
    GET_LIST(carom_world_get_faults, carom_fault),
    ROW(carom_world_hash, world(c), out(c, 8), error(c)),
    // snapshots
    {"carom_world_save", [](Context& c) {
       constexpr std::size_t kRoom = 1 << 16;
       Argument capacity = fixed_number(kRoom);
       capacity.wrong.push_back({"room for 8 bytes", of(uint64_t(8)), kSmall});
       return call("carom_world_save", carom_world_save, {world(c), bits(c, CAROM_SNAPSHOT_WHOLE), fixed(c.take(kRoom)), capacity, out(c, 8), error(c)}).may(kSmall);
     }},
    {"carom_world_restore", [](Context& c) {
       const Snapshot own = snapshot(c, CAROM_SNAPSHOT_STATE | c.source.below(2));
       return call("carom_world_restore", carom_world_restore, {world(c), own.bytes, own.size, error(c)});
     }},
    {"carom_world_compare", [](Context& c) {
       const Snapshot own = snapshot(c, CAROM_SNAPSHOT_STATE);
       return call("carom_world_compare", carom_world_compare, {world(c), own.bytes, own.size, out_struct<carom_difference>(c), error(c)});
     }},
    {"carom_world_fork", [](Context& c) {
       return call("carom_world_fork", carom_world_fork, {world(c), out(c, sizeof(void*)), error(c)}).after([](const Value* v) {
         carom_world_destroy(*static_cast<carom_world* const*>(v[1].p), nullptr);
       });
     }},
    {"carom_world_translate_handles", [](Context& c) {
       const Argument one = handle(c, kBody);
       uint64_t list[2] = {0, one.good.u};
       Argument handles = fixed(c.keep(list));
       handles.impossible = one.impossible;
       handles.wrong.push_back({"null", of(nullptr), kNull});
       for (const Wrong& w : one.wrong) {
         // Of another world, of any kind, or none: that is what this is for.
         if ((w.codes & (kWrongWorld | kWrongKind)) || w.value.u == 0) continue;
         list[1] = w.value.u;
         handles.wrong.push_back({w.what, of(c.keep(list)), w.codes | kWrongKind});  // bits may be of nothing at all
       }
       return call("carom_world_translate_handles", carom_world_translate_handles, {world(c), handles, fixed_number(2), out(c, sizeof list), error(c)});
     }},
    {"carom_world_record_begin", [](Context& c) {
       Argument write = fixed(reinterpret_cast<const void*>(+[](void*, const void*, uint64_t) -> int32_t { return 0; }));
       write.wrong.push_back({"null", of(nullptr), kNull});
       return call("carom_world_record_begin", carom_world_record_begin, {world(c), bits(c, CAROM_RECORD_STATES), write, fixed(nullptr), error(c)})
           .may(kInUse).after([](const Value* v) { carom_world_record_end(static_cast<carom_world*>(const_cast<void*>(v[0].p)), nullptr); });
     }},
    {"carom_world_record_end", [](Context& c) {
       return call("carom_world_record_end", carom_world_record_end, {world(c), error(c)}).may(kNotFound);
     }},
    // materials
    INIT(carom_material_desc_init, carom_material_desc),
    ROW_THAT(carom_material_create, makes(kMaterial, 2), world(c), material_desc(c), out(c, 8), error(c)),
    ROW(carom_material_update, world(c), handle(c, kMaterial), material_desc(c), error(c)),
    ROW(carom_material_set_resistance, world(c), handle(c, kMaterial), number(c, {0, 1e3, false, 0, 0.1}), number(c, {0, 1e3, false, 0, 0.1}), error(c)),
    ROW(carom_material_get_resistance, world(c), handle(c, kMaterial), out(c, 8), out(c, 8), error(c)),
    {"carom_material_set_pair", [](Context& c) {
       Argument surface = vector(c, 4, {0, 1, false, 0, 1});
       std::erase_if(surface.wrong, [](const Wrong& w) { return w.codes == kNull; });  // NULL: they mix
       if (c.source.below(3) == 0) surface = fixed(nullptr);
       return call("carom_material_set_pair", carom_material_set_pair, {world(c), handle(c, kMaterial), handle(c, kMaterial), surface, error(c)});
     }},
    ROW(carom_material_get_pair, world(c), handle(c, kMaterial), handle(c, kMaterial), out(c, 32), error(c)),
    ROW_THAT(carom_material_destroy, may(kInUse).ends(kMaterial), world(c), handle(c, kMaterial), error(c)),
    // bodies
    INIT(carom_body_desc_init, carom_body_desc),
    ROW_THAT(carom_body_create, makes(kBody, 2), world(c), body_desc(c), out(c, 8), error(c)),
    ROW_THAT(carom_body_destroy, ends(kBody), world(c), handle(c, kBody), error(c)),
    ROW(carom_body_get, world(c), handle(c, kBody), out_struct<carom_body_desc>(c), error(c)),
    ROW(carom_body_set_pose, world(c), handle(c, kBody), vector(c, 3, any()), unit(c, 4), error(c)),
    ROW_THAT(carom_body_set_velocity, may(kRange), world(c), handle(c, kBody), vector(c, 3, any()), vector(c, 3, any()), error(c)),
    ROW(carom_body_get_pose, world(c), handle(c, kBody), wanted_out(c, 24), wanted_out(c, 32), error(c)),
    ROW(carom_body_get_velocity, world(c), handle(c, kBody), wanted_out(c, 24), wanted_out(c, 24), error(c)),
    {"carom_body_set_mass", [](Context& c) {
       Argument mass = number(c, {1e-300, kMost, false, 0.1, 10}), center = vector(c, 3, {-1e15, 1e15}), inertia = vector(c, 9, any());
       double* const tensor = static_cast<double*>(c.take(9 * sizeof(double)));
       for (int i = 0; i < 9; ++i) tensor[i] = i % 4 == 0 ? c.between(0.1, 1) : 0;
       inertia.good = of(tensor);
       std::erase_if(center.wrong, [](const Wrong& w) { return w.codes == kNull; });  // NULL: from the colliders
       std::erase_if(inertia.wrong, [](const Wrong& w) { return !(w.codes & kNotFinite); });
       if (c.source.below(3) == 0) center = fixed(nullptr);
       if (c.source.below(3) == 0) inertia = fixed(nullptr);
       return call("carom_body_set_mass", carom_body_set_mass, {world(c), handle(c, kBody), mass, center, inertia, error(c)}).may(kRange | kNoVolume);
     }},
    ROW(carom_body_get_mass, world(c), handle(c, kBody), wanted_out(c, 8), wanted_out(c, 24), wanted_out(c, 72), error(c)),
    ROW_THAT(carom_body_set_type, may(kRange | kNoVolume), world(c), handle(c, kBody), choice(c, 3), error(c)),
    ROW(carom_body_get_type, world(c), handle(c, kBody), out(c, 4), error(c)),
    ROW(carom_body_set_damping, world(c), handle(c, kBody), number(c, {0, 1e6, false, 0, 1}), number(c, {0, 1e6, false, 0, 1}), error(c)),
    ROW(carom_body_get_damping, world(c), handle(c, kBody), wanted_out(c, 8), wanted_out(c, 8), error(c)),
    ROW(carom_body_set_user, world(c), handle(c, kBody), whole(c, 100), error(c)),
    ROW(carom_body_get_user, world(c), handle(c, kBody), out(c, 8), error(c)),
    {"carom_body_get_colliders", [](Context& c) {
       Argument dst = wanted_out(c, 8 * 64);
       return call("carom_body_get_colliders", carom_body_get_colliders, {world(c), handle(c, kBody), dst, fixed_number(64), out(c, 8), error(c)});
     }},
    {"carom_body_create_named", [](Context& c) {
       Argument name = string(c, "hostile.ball"), n = fixed_number(1);
       name.wrong.push_back({"none of this name", string(c, "bananas").good, code(CAROM_E_NOT_FOUND)});
       name.wrong.push_back({"a path", string(c, "../box").good, kRange});
       for (const uint64_t bad : {uint64_t(0), uint64_t(2)}) n.wrong.push_back({"count", of(bad), kRange});
       return call("carom_body_create_named", carom_body_create_named, {world(c), choice(c, 3), name, vector(c, 1, {0.01, 100, false, 0.1, 1}), n, vector(c, 3, any()), out(c, 8), error(c)})
           .makes(kBody, 6).may(kRange | code(CAROM_E_NOT_FOUND));
     }},
    ROW_THAT(carom_body_add_force, may(kRange), world(c), handle(c, kBody), vector(c, 3, any()), vector(c, 3, any()), error(c)),
    ROW_THAT(carom_body_add_force_at, may(kRange), world(c), handle(c, kBody), vector(c, 3, any()), vector(c, 3, any()), error(c)),
    ROW_THAT(carom_body_add_impulse, may(kRange), world(c), handle(c, kBody), vector(c, 3, any()), vector(c, 3, any()), error(c)),
    ROW(carom_body_set_gravity_factor, world(c), handle(c, kBody), number(c, any()), error(c)),
    ROW(carom_body_get_gravity_factor, world(c), handle(c, kBody), out(c, 8), error(c)),
    ROW_THAT(carom_body_set_locks, may(kRange | kUnsupported), world(c), handle(c, kBody), bits(c, CAROM_LOCK_ALL), error(c)),
    ROW(carom_body_get_locks, world(c), handle(c, kBody), out(c, 4), error(c)),
    ROW(carom_body_is_asleep, world(c), handle(c, kBody), out(c, 4), error(c)),
    ROW(carom_body_wake, world(c), handle(c, kBody), error(c)),
    ROW(carom_body_set_enabled, world(c), handle(c, kBody), choice(c, 2), error(c)),
    ROW(carom_body_is_enabled, world(c), handle(c, kBody), out(c, 4), error(c)),
    ROW(carom_body_set_continuous, world(c), handle(c, kBody), choice(c, 3), error(c)),
    ROW(carom_body_get_continuous, world(c), handle(c, kBody), out(c, 4), error(c)),
    INIT(carom_collider_desc_init, carom_collider_desc),
    ROW_THAT(carom_collider_create, makes(kCollider, 3, 1).may(kRange | kNoVolume), world(c), handle(c, kBody), collider_desc(c), out(c, 8), error(c)),
    ROW_THAT(carom_collider_destroy, ends(kCollider), world(c), handle(c, kCollider), error(c)),
    ROW(carom_collider_get, world(c), handle(c, kCollider), out_struct<carom_collider_desc>(c), out(c, 8), error(c)),
    ROW(carom_collider_set_material, world(c), handle(c, kCollider), perhaps_handle(c, kMaterial), error(c)),
    ROW_THAT(carom_collider_set_density, may(kNoVolume), world(c), handle(c, kCollider), number(c, {0, 1e9, false, 1, 2000}), error(c)),
    ROW(carom_collider_set_pose, world(c), handle(c, kCollider), vector(c, 3, {-1e15, 1e15}), unit(c, 4), error(c)),
    ROW(carom_collider_set_surface_velocity, world(c), handle(c, kCollider), vector(c, 3, {-1e6, 1e6}), vector(c, 3, {-1e6, 1e6}), error(c)),
    ROW(carom_collider_get_surface_velocity, world(c), handle(c, kCollider), out(c, 24), out(c, 24), error(c)),
    GET_HANDLES(carom_world_get_bodies),
    {"carom_world_read", [](Context& c) {
       const std::vector<carom_body> some = bodies_for(c);
       Bulk b = bulk(c, some, {{CAROM_FIELD_POSE, 7}, {CAROM_FIELD_VELOCITY, 6}, {CAROM_FIELD_FORCE, 6}, {CAROM_FIELD_MASS, 1}}, CAROM_FIELD_COUNT, false);
       wrong_last(c, b.list, some);
       b.list.wrong.push_back({"all of them, but another n", of(nullptr), kRange, 5});
       return call("carom_world_read", carom_world_read, {world(c), b.field, b.scalar, b.list, b.n, b.array, b.stride, error(c)});
     }},
    {"carom_world_write", [](Context& c) {
       const std::vector<carom_body> some = bodies_for(c);
       Bulk b = bulk(c, some, {{CAROM_FIELD_POSE, 7}, {CAROM_FIELD_POSITION, 3}, {CAROM_FIELD_ORIENTATION, 4}, {CAROM_FIELD_FORCE, 6}, {CAROM_FIELD_VELOCITY, 6}}, CAROM_FIELD_COUNT, true);
       wrong_last(c, b.list, some);
       b.list.wrong.push_back({"all of them, but another n", of(nullptr), kRange, 5});
       for (const uint32_t f : {CAROM_FIELD_CENTER, CAROM_FIELD_MASS}) b.field.wrong.push_back({"read only", of(uint64_t(f)), kUnsupported});
       return call("carom_world_write", carom_world_write, {world(c), b.field, b.scalar, b.list, b.n, b.array, b.stride, error(c)}).may(kRange);
     }},
    // particles
    INIT(carom_particles_desc_init, carom_particles_desc),
    ROW_THAT(carom_particles_create, makes(kParticles, 2), world(c), particles_desc(c), out(c, 8), error(c)),
    ROW_THAT(carom_particles_destroy, ends(kParticles), world(c), handle(c, kParticles), error(c)),
    ROW(carom_particles_get, world(c), handle(c, kParticles), out_struct<carom_particles_desc>(c), error(c)),
    ROW(carom_particles_update, world(c), handle(c, kParticles), particles_desc(c), error(c)),
    ROW(carom_particles_get_count, world(c), handle(c, kParticles), out(c, 8), error(c)),
    {"carom_particles_add", [](Context& c) {
       Argument stride = fixed_number(0), positions = vector(c, 6, {-1e15, 1e15}), velocities = vector(c, 6, {-1e9, 1e9});
       stride.wrong.push_back({"stride 8", of(uint64_t(8)), kSmall});
       if (c.wants_wrong) velocities.wrong.erase(velocities.wrong.begin());  // NULL: at rest
       Argument n = fixed_number(2);
       n.wrong.push_back({"too many", of(uint64_t(1) << 32), kLimit | kRange});
       return call("carom_particles_add", carom_particles_add, {world(c), handle(c, kParticles), n, fixed_number(CAROM_SCALAR_F64), positions, stride, velocities, stride, error(c)});
     }},
    {"carom_particles_remove", [](Context& c) {
       Argument set = first_set(c);
       const uint32_t beyond = size_of_set(c);
       const std::vector<uint32_t> first = {0};
       Argument indices = fixed(c.keep(uint32_t(0)));
       indices.impossible = beyond == 0;
       indices.wrong.push_back({"beyond all", of(c.keep(beyond)), kRange});
       indices.wrong.push_back({"all bits", of(c.keep(uint32_t(0xFFFFFFFF))), kRange});
       Argument n = fixed_number(1);
       return call("carom_particles_remove", carom_particles_remove, {world(c), set, indices, n, error(c)});
     }},
    {"carom_particles_read", [](Context& c) {
       Argument set = first_set(c);
       Bulk b = bulk(c, first_particles(c), {{CAROM_FIELD_POSITION, 3}, {CAROM_FIELD_LINEAR_VELOCITY, 3}, {CAROM_FIELD_MASS, 1}}, CAROM_FIELD_COUNT, false);
       b.list.impossible = size_of_set(c) == 0;
       b.field.wrong.push_back({"no such field", of(uint64_t(CAROM_FIELD_POSE)), kUnsupported});
       return call("carom_particles_read", carom_particles_read, {world(c), set, b.field, b.scalar, b.list, b.n, b.array, b.stride, error(c)});
     }},
    {"carom_particles_write", [](Context& c) {
       Argument set = first_set(c);
       Bulk b = bulk(c, first_particles(c), {{CAROM_FIELD_POSITION, 3}, {CAROM_FIELD_LINEAR_VELOCITY, 3}, {CAROM_FIELD_MASS, 1}}, CAROM_FIELD_COUNT, true);
       b.list.impossible = size_of_set(c) == 0;
       b.field.wrong.push_back({"no such field", of(uint64_t(CAROM_FIELD_POSE)), kUnsupported});
       return call("carom_particles_write", carom_particles_write, {world(c), set, b.field, b.scalar, b.list, b.n, b.array, b.stride, error(c)});
     }},
    {"carom_particles_get_quarantined", [](Context& c) {
       return call("carom_particles_get_quarantined", carom_particles_get_quarantined, {world(c), handle(c, kParticles), fixed(c.take(64)), fixed_number(16), out(c, 8), error(c)});
     }},
    GET_HANDLES(carom_world_get_particles),
    // filters
    ROW(carom_collider_set_filter, world(c), handle(c, kCollider), whole(c, 4), whole(c, 4), whole(c, 3), error(c)),
    ROW(carom_collider_get_filter, world(c), handle(c, kCollider), out(c, 8), out(c, 8), out(c, 4), error(c)),
    ROW(carom_body_set_filter, world(c), handle(c, kBody), whole(c, 4), whole(c, 4), whole(c, 3), error(c)),
    {"carom_body_ignore_collision", [](Context& c) {
       const Argument a = handle(c, kBody);
       return call("carom_body_ignore_collision", carom_body_ignore_collision, {world(c), a, another_handle(c, kBody, a), choice(c, 2), error(c)}).may(kRange);
     }},
    ROW(carom_collider_set_sensor, world(c), handle(c, kCollider), choice(c, 2), error(c)),
    ROW(carom_collider_is_sensor, world(c), handle(c, kCollider), out(c, 4), error(c)),
    // events
    ROW(carom_world_collect_events, world(c), bits(c, 31), number(c, {0, 1e9, false, 0, 2}), error(c)),
    GET_LIST(carom_world_get_contact_events, carom_contact_event),
    GET_LIST(carom_world_get_sensor_events, carom_sensor_event),
    GET_LIST(carom_world_get_sleep_events, carom_sleep_event),
    GET_LIST(carom_world_get_joint_events, carom_joint_event),
    GET_LIST(carom_world_get_fault_events, carom_fault_event),
    // joints
    {"carom_joint_kind_name", [](Context& c) { return call("carom_joint_kind_name", carom_joint_kind_name, {fixed_number(c.source.below(64))}); }},
    INIT(carom_joint_desc_init, carom_joint_desc),
    INIT(carom_joint_limit_init, carom_joint_limit),
    INIT(carom_joint_motor_init, carom_joint_motor),
    INIT(carom_joint_spring_init, carom_joint_spring),
    INIT(carom_joint_transmission_init, carom_joint_transmission),
    INIT(carom_joint_coupling_init, carom_joint_coupling),
    INIT(carom_joint_axis_init, carom_joint_axis),
    INIT(carom_joint_orientation_drive_init, carom_joint_orientation_drive),
    ROW_THAT(carom_joint_create, makes(kJoint, 2).may(kRange | kUnsupported), world(c), joint_desc(c), out(c, 8), error(c)),
    ROW_THAT(carom_joint_destroy, ends(kJoint), world(c), handle(c, kJoint), error(c)),
    ROW(carom_joint_get, world(c), handle(c, kJoint), out_struct<carom_joint_desc>(c), error(c)),
    ROW(carom_joint_get_state, world(c), handle(c, kJoint), out_struct<carom_joint_state>(c), error(c)),
    ROW_THAT(carom_joint_set_limit, may(kUnsupported | kRange), world(c), handle(c, kJoint), choice(c, 4), joint_limit(c), error(c)),
    ROW_THAT(carom_joint_set_motor, may(kUnsupported | kRange), world(c), handle(c, kJoint), choice(c, 4), joint_motor(c), error(c)),
    ROW_THAT(carom_joint_set_spring, may(kUnsupported | kRange), world(c), handle(c, kJoint), choice(c, 4), joint_spring(c), error(c)),
    ROW_THAT(carom_joint_get_limit, may(kUnsupported), world(c), handle(c, kJoint), choice(c, 4), out_struct<carom_joint_limit>(c), error(c)),
    ROW_THAT(carom_joint_get_motor, may(kUnsupported), world(c), handle(c, kJoint), choice(c, 4), out_struct<carom_joint_motor>(c), error(c)),
    ROW_THAT(carom_joint_get_spring, may(kUnsupported), world(c), handle(c, kJoint), choice(c, 4), out_struct<carom_joint_spring>(c), error(c)),
    ROW_THAT(carom_joint_set_transmission, may(kUnsupported | kRange), world(c), handle(c, kJoint), joint_transmission(c), error(c)),
    ROW_THAT(carom_joint_get_transmission, may(kUnsupported), world(c), handle(c, kJoint), out_struct<carom_joint_transmission>(c), error(c)),
    ROW_THAT(carom_joint_couple, makes(kJoint, 2).may(kRange | kUnsupported), world(c), joint_coupling(c), out(c, 8), error(c)),
    ROW_THAT(carom_joint_set_coupling, may(kUnsupported | kRange), world(c), handle(c, kJoint), joint_coupling(c, true), error(c)),
    ROW_THAT(carom_joint_get_coupling, may(kUnsupported), world(c), handle(c, kJoint), out_struct<carom_joint_coupling>(c), error(c)),
    ROW_THAT(carom_joint_set_axis, may(kUnsupported | kRange), world(c), handle(c, kJoint), choice(c, 6), joint_axis(c), error(c)),
    ROW_THAT(carom_joint_get_axis, may(kUnsupported), world(c), handle(c, kJoint), choice(c, 6), out_struct<carom_joint_axis>(c), error(c)),
    ROW_THAT(carom_joint_set_orientation_drive, may(kUnsupported | kRange), world(c), handle(c, kJoint), joint_orientation_drive(c), error(c)),
    ROW_THAT(carom_joint_get_orientation_drive, may(kUnsupported), world(c), handle(c, kJoint), out_struct<carom_joint_orientation_drive>(c), error(c)),
    GET_HANDLES(carom_world_get_joints),
    {"carom_world_read_joints", [](Context& c) {
       std::vector<carom_joint> some;
       for (const Owned& o : c.own.live[kJoint])
         if (some.size() < 2) some.push_back(o.handle);
       Bulk b = bulk(c, some, {{CAROM_JOINT_BULK_SPEEDS, 4}, {CAROM_JOINT_BULK_AXIS_SPEEDS, 6}, {CAROM_JOINT_BULK_FORCE, 3}, {CAROM_JOINT_BULK_ERROR, 2}}, CAROM_JOINT_BULK_COUNT, false);
       wrong_last(c, b.list, some, kJoint);
       if (c.own.live[kJoint].size() > some.size())
         b.list.wrong.push_back({"all of them, but another n", of(nullptr), kRange, 5});
       return call("carom_world_read_joints", carom_world_read_joints, {world(c), b.field, b.scalar, b.list, b.n, b.array, b.stride, error(c)});
     }},
    // trees
    {"carom_tree_get_coordinates", [](Context& c) {
       const Tree tree = some_tree(c);
       Argument stride = fixed_number(sizeof(carom_tree_coordinate));
       for (const uint64_t s : {uint64_t(0), uint64_t(4), uint64_t(sizeof(carom_tree_coordinate) + 1)}) stride.wrong.push_back({"stride " + std::to_string(s), of(s), kSmall});
       Argument dst = out(c, sizeof(carom_tree_coordinate) * 2);
       return call("carom_tree_get_coordinates", carom_tree_get_coordinates, {world(c), tree.body, dst, stride, fixed_number(2), out(c, 8), error(c)});
     }},
    {"carom_tree_get_speeds", [](Context& c) {
       const Tree tree = some_tree(c);
       return call("carom_tree_get_speeds", carom_tree_get_speeds, {world(c), tree.body, out(c, 8 * tree.size), tree.n, error(c)});
     }},
    {"carom_tree_get_forces", [](Context& c) {
       const Tree tree = some_tree(c);
       const auto numbers = [&] {
         auto* values = static_cast<double*>(c.take(8 * tree.size + 1));
         for (uint64_t k = 0; k < tree.size; ++k) values[k] = c.between(-2, 2);
         Argument a = fixed(values);
         for (const double x : {kNan, kInf, -kInf}) {
           auto* bad = static_cast<double*>(c.take(8 * tree.size + 1));
           std::memcpy(bad, values, 8 * tree.size);
           if (tree.size) bad[tree.size - 1] = x, a.wrong.push_back({"last is " + shown(x), of(bad), kNotFinite});
         }
         return a;
       };
       return call("carom_tree_get_forces", carom_tree_get_forces, {world(c), tree.body, numbers(), numbers(), out(c, 8 * tree.size), tree.n, error(c)}).may(kNotFinite);
     }},
    {"carom_tree_get_mass", [](Context& c) {
       const Tree tree = some_tree(c);
       return call("carom_tree_get_mass", carom_tree_get_mass, {world(c), tree.body, out(c, 8 * tree.size * tree.size), tree.n, error(c)});
     }},
    ROW(carom_joint_bulk_width, choice(c, CAROM_JOINT_BULK_COUNT), out(c, 4)),
    {"carom_world_write_joints", [](Context& c) {
       const bool axes = c.source.below(2) == 1;  // of six-axis joints, else of hinges
       const uint32_t kind = axes ? CAROM_JOINT_SIX_AXIS : CAROM_JOINT_HINGE;
       std::vector<carom_joint> some, others;
       for (const Owned& o : c.own.live[kJoint])
         if (kind_of_joint(c, o.handle) != kind) others.push_back(o.handle);
         else if (some.size() < 2) some.push_back(o.handle);
       Bulk b = axes ? bulk(c, some, {{CAROM_JOINT_BULK_AXIS_TARGETS, 6}, {CAROM_JOINT_BULK_AXIS_MAX_FORCES, 6}, {CAROM_JOINT_BULK_AXIS_GAINS, 12}, {CAROM_JOINT_BULK_AXIS_FRICTIONS, 6}, {CAROM_JOINT_BULK_ORIENTATION_GAINS, 2}}, CAROM_JOINT_BULK_COUNT, true)
                     : bulk(c, some, {{CAROM_JOINT_BULK_TARGET, 1}, {CAROM_JOINT_BULK_TARGET_VELOCITY, 1}, {CAROM_JOINT_BULK_TARGET_EFFORT, 1}}, CAROM_JOINT_BULK_COUNT, true);
       wrong_last(c, b.list, some, kJoint);
       if (c.own.live[kJoint].size() > some.size())
         b.list.wrong.push_back({"all of them, but another n", of(nullptr), kRange, 5});
       if (!some.empty() && !others.empty() && kind_of_joint(c, others[0]) == CAROM_JOINT_WELD) {
         auto* list = static_cast<carom_joint*>(c.take(8 * some.size()));
         std::memcpy(list, some.data(), 8 * some.size());
         list[some.size() - 1] = others[0];
         b.list.wrong.push_back({"last: a weld", of(list), kUnsupported});
       }
       for (const uint32_t f : {CAROM_JOINT_BULK_SPEEDS, CAROM_JOINT_BULK_EFFORT, CAROM_JOINT_BULK_AXIS_EFFORTS, CAROM_JOINT_BULK_AXIS_ACCELERATIONS}) b.field.wrong.push_back({"read only", of(uint64_t(f)), kUnsupported});
       return call("carom_world_write_joints", carom_world_write_joints, {world(c), b.field, b.scalar, b.list, b.n, b.array, b.stride, error(c)});
     }},
    // forces
    ROW(carom_body_set_drag, world(c), handle(c, kBody), number(c, {0, 1e12, false, 0, 1}), number(c, {0, 1e12, false, 0, 1}), error(c)),
    ROW(carom_body_get_drag, world(c), handle(c, kBody), out(c, 8), out(c, 8), error(c)),
    ROW(carom_world_set_wind, world(c), vector(c, 3, {-1e6, 1e6}), error(c)),
    ROW(carom_world_get_wind, world(c), out(c, 24), error(c)),
    INIT(carom_force_field_desc_init, carom_force_field_desc),
    ROW_THAT(carom_force_field_create, makes(kField, 2), world(c), field_desc(c), out(c, 8), error(c)),
    ROW(carom_force_field_update, world(c), handle(c, kField), field_desc(c), error(c)),
    ROW(carom_force_field_get, world(c), handle(c, kField), out_struct<carom_force_field_desc>(c), error(c)),
    ROW_THAT(carom_force_field_destroy, ends(kField), world(c), handle(c, kField), error(c)),
    ROW(carom_body_set_force_field_mask, world(c), handle(c, kBody), whole(c, 4), error(c)),
    ROW(carom_body_get_force_field_mask, world(c), handle(c, kBody), out(c, 4), error(c)),
    INIT(carom_spring_desc_init, carom_spring_desc),
    ROW_THAT(carom_spring_create, makes(kSpring, 2).may(kRange), world(c), spring_desc(c), out(c, 8), error(c)),
    ROW(carom_spring_update, world(c), handle(c, kSpring), number(c, {0, 1e9, false, 0, 2}), number(c, {0, 1e30, false, 0, 99}), number(c, {0, 1e30, false, 0, 2}), error(c)),
    ROW(carom_spring_get, world(c), handle(c, kSpring), out_struct<carom_spring_desc>(c), error(c)),
    ROW(carom_spring_get_state, world(c), handle(c, kSpring), out(c, 8), out(c, 8), error(c)),
    ROW_THAT(carom_spring_destroy, ends(kSpring), world(c), handle(c, kSpring), error(c)),
    INIT(carom_water_init, carom_water),
    ROW(carom_world_set_water, world(c), water_desc(c), error(c)),
    ROW(carom_world_get_water, world(c), out_struct<carom_water>(c), out(c, 4), error(c)),
    // the plan
    ROW(carom_world_set_effect, world(c), choice(c, CAROM_EFFECT_COUNT), choice(c, 3), error(c)),
    ROW(carom_world_get_effect, world(c), choice(c, CAROM_EFFECT_COUNT), out(c, 4), error(c)),
    ROW_THAT(carom_body_set_effect, may(kUnsupported), world(c), handle(c, kBody), choice(c, CAROM_EFFECT_COUNT), choice(c, 3), error(c)),
    ROW(carom_body_get_effect, world(c), handle(c, kBody), choice(c, CAROM_EFFECT_COUNT), out(c, 4), error(c)),
    ROW(carom_world_time_effects, world(c), choice(c, 2), error(c)),
    GET_LIST(carom_world_get_plan, carom_plan_line),
    // accuracy
    INIT(carom_accuracy_init, carom_accuracy),
    ROW(carom_world_set_accuracy, world(c), accuracy_desc(c), error(c)),
    ROW(carom_world_get_accuracy, world(c), out_struct<carom_accuracy>(c), out(c, 4), error(c)),
    GET_LIST(carom_world_get_islands, carom_island),
    ROW(carom_world_measure_growth, world(c), number(c, {1e-9, 1, false, 0.004, 0.02}), growth_steps(c), out_struct<carom_growth>(c), error(c)),
    // the ledger
    ROW(carom_world_enable_ledger, world(c), choice(c, 2), error(c)),
    GET_LIST(carom_world_get_ledger, carom_ledger_entry),
    ROW(carom_world_get_ledger_state, world(c), out_struct<carom_ledger_state>(c), error(c)),
    // residuals; a budget that leaves no choice, or steps would be what the machine's load makes of them
    ROW(carom_world_get_residuals, world(c), out_struct<carom_residuals>(c), error(c)),
    ROW(carom_world_set_budget, world(c), number(c, {0, 10, false, 0, 0}), fixed_number(4), fixed_number(4), error(c)),
    ROW(carom_world_get_budget, world(c), out(c, 8), out(c, 4), out(c, 4), error(c)),
    // drawing
    INIT(carom_draw_desc_init, carom_draw_desc),
    {"carom_world_draw", [](Context& c) {
       List l = list(c, sizeof(carom_draw_line), true);
       l.dst.wrong.clear();  // NULL counts
       return call("carom_world_draw", carom_world_draw, {world(c), draw_desc(c), l.dst, l.stride, l.capacity, l.count, error(c)});
     }},
    // questions to a world
    INIT(carom_query_desc_init, carom_query_desc),
    {"carom_world_cast_ray", [](Context& c) {
       Argument size = fixed_number(sizeof(carom_world_hit));
       size.wrong.push_back({"size 4", of(uint64_t(4)), kSmall});
       return call("carom_world_cast_ray", carom_world_cast_ray, {world(c), vector(c, 3, any()), vector(c, 3, any()), number(c, {0, kMost, true, 0, 9}), query_desc(c), out(c, sizeof(carom_world_hit)), size, error(c)});
     }},
    {"carom_world_cast_rays", [](Context& c) {
       return call("carom_world_cast_rays", carom_world_cast_rays, {world(c), rays(c), choice(c, 2), query_desc(c), hits<carom_world_hits, carom_world_hit>(c), error(c)});
     }},
    {"carom_world_cast_rays_all", [](Context& c) {
       List l = list(c, sizeof(carom_world_hit));
       return call("carom_world_cast_rays_all", carom_world_cast_rays_all, {world(c), rays(c), query_desc(c), l.dst, l.stride, l.capacity, l.count, error(c)});
     }},
    {"carom_world_cast_shapes", [](Context& c) {
       bool half = false;
       Argument shapes = query_shapes(c, true, half), stride = fixed_number(0);
       stride.wrong.push_back({"stride 4", of(uint64_t(4)), kSmall});
       return call("carom_world_cast_shapes", carom_world_cast_shapes, {world(c), shapes, choice(c, 2), query_desc(c), out(c, sizeof(carom_world_hit) * kQuestions), stride, error(c)});
     }},
    {"carom_world_cast_shapes_all", [](Context& c) {
       bool half = false;
       Argument shapes = query_shapes(c, true, half);
       List l = list(c, sizeof(carom_world_hit));
       return call("carom_world_cast_shapes_all", carom_world_cast_shapes_all, {world(c), shapes, query_desc(c), l.dst, l.stride, l.capacity, l.count, error(c)});
     }},
    {"carom_world_overlap_shapes", [](Context& c) {
       bool half = false;
       Argument shapes = query_shapes(c, false, half);
       List l = list(c, sizeof(carom_world_hit));
       return call("carom_world_overlap_shapes", carom_world_overlap_shapes, {world(c), shapes, query_desc(c), l.dst, l.stride, l.capacity, l.count, error(c)});
     }},
    {"carom_world_find_nearest", [](Context& c) {
       bool half = false;
       Argument shapes = query_shapes(c, false, half), stride = fixed_number(0);
       stride.wrong.push_back({"stride 4", of(uint64_t(4)), kSmall});
       return call("carom_world_find_nearest", carom_world_find_nearest, {world(c), shapes, number(c, {0, kMost, true, 0, 9}), query_desc(c), out(c, sizeof(carom_world_hit) * kQuestions), stride, error(c)});
     }},

    // ---- characters ----
    INIT(carom_character_desc_init, carom_character_desc),
    INIT(carom_character_init, carom_character),
    ROW(carom_character_set_shape, engine(c), world(c), character_desc(c), changed_character(c, false), shape_but_scenery(c), wanted_out(c, 4), error(c)),
    ROW_THAT(carom_character_move, may(kRange), world(c), character_desc(c), changed_character(c, true), vector(c, 3, {-1e6, 1e6, false, -3, 3}), number(c, {0, 1e6, false, 0, 2}), number(c, {0, 1, false, 0, 0.1}), error(c)),
    ROW_THAT(carom_character_push, may(kRange), world(c), character_desc(c), character(c, false), number(c, {1e-9, 1, false, 0.01, 0.1}), error(c)),
    ROW_THAT(carom_character_move_body, may(kRange), world(c), character_desc(c, true), character(c, false), number(c, {1e-9, 1, false, 0.01, 0.1}), error(c)),

    // ---- vehicles ----
    INIT(carom_vehicle_desc_init, carom_vehicle_desc),
    INIT(carom_wheel_desc_init, carom_wheel_desc),
    INIT(carom_vehicle_input_init, carom_vehicle_input),
    INIT(carom_vehicle_init, carom_vehicle),
    INIT(carom_wheel_init, carom_wheel),
    {"carom_vehicle_drive", [](Context& c) {
       Argument n = fixed_number(1);
       for (const uint64_t bad : {uint64_t(0), uint64_t(17), ~uint64_t(0)}) n.wrong.push_back({"so many wheels", of(bad), kRange});
       Call made = call("carom_vehicle_drive", carom_vehicle_drive, {world(c), vehicle_desc(c), wheel_desc(c), n, vehicle_input(c), vehicle_state(c), wheel_state(c), number(c, {1e-4, 0.1, false, 0.01, 0.1}), error(c)});
       made.may(kRange);
       return made;
     }},

    // ---- batches ----
    INIT(carom_batch_column_init, carom_batch_column),
    // Devices are those of the machine: test_device.cpp and test_device_on_host.cpp ask them.
    ROW_THAT(carom_device_create, only_wrong(), engine(c), fixed_number(0), out(c, sizeof(void*)), error(c)),
    ROW_THAT(carom_device_destroy, only_wrong(), no_device(), error(c)),
    ROW_THAT(carom_device_get_info, only_wrong(), no_device(), fixed(c.take(sizeof(carom_device_info))), error(c)),
    ROW_THAT(carom_device_pairs_distance, only_wrong(), no_device(), fixed(c.take(sizeof(carom_pairs))), fixed(nullptr), fixed(c.take(sizeof(carom_distance))), fixed_number(sizeof(carom_distance)), error(c)),
    {"carom_batch_create", [](Context& c) {
       return call("carom_batch_create", carom_batch_create, {engine(c), out(c, sizeof(void*)), error(c)}).after([](const Value* v) {
         carom_batch_destroy(*static_cast<carom_batch* const*>(v[1].p), nullptr);
       });
     }},
    ROW_THAT(carom_batch_destroy, only_wrong(), batch(c), error(c)),
    {"carom_batch_add_worlds", [](Context& c) {
       Argument n = fixed_number(1);
       for (const uint64_t bad : {uint64_t(0), uint64_t(1) << 24, ~uint64_t(0)}) n.wrong.push_back({"so many worlds", of(bad), kRange});
       Argument its = world(c);
       its.wrong.push_back({"another engine's", of(static_cast<const void*>(c.other.world)), kWrongWorld});
       return call("carom_batch_add_worlds", carom_batch_add_worlds, {batch(c), its, n, out(c, 8), error(c)});
     }},
    ROW(carom_batch_add_column, batch(c), batch_column(c), wanted_out(c, 4), error(c)),
    {"carom_batch_step", [](Context& c) {
       Argument steps = fixed_number(1);
       for (const uint64_t bad : {uint64_t(0), uint64_t(1000001), uint64_t(0xFFFFFFFF)}) steps.wrong.push_back({"so many steps", of(bad), kRange});
       return call("carom_batch_step", carom_batch_step, {batch(c), perhaps_mask(c), number(c, {1e-9, 1, false, 0.01, 0.1}), steps, wanted_out(c, 8), error(c)});
     }},
    ROW(carom_batch_read, batch(c), columns(c), fixed_number(1), perhaps_mask(c), error(c)),
    ROW(carom_batch_write, batch(c), columns(c), fixed_number(1), perhaps_mask(c), error(c)),
    {"carom_batch_add_start", [](Context& c) {
       Snapshot own = snapshot(c, CAROM_SNAPSHOT_STATE | c.source.below(2));
       for (Wrong& w : own.size.wrong) w.argument = 3;
       return call("carom_batch_add_start", carom_batch_add_start, {batch(c), world_number(c), own.bytes, own.size, out(c, 4), error(c)});
     }},
    {"carom_batch_reset", [](Context& c) {
       Argument starts = fixed(c.take(8));
       const uint32_t bad[2] = {1, 1};
       starts.wrong.push_back({"a start that is none", of(static_cast<const void*>(std::memcpy(c.take(sizeof bad), bad, sizeof bad))), kRange});
       return call("carom_batch_reset", carom_batch_reset, {batch(c), fixed(nullptr), starts, error(c)});
     }},
    {"carom_batch_save", [](Context& c) {
       constexpr std::size_t kRoom = 1 << 16;
       Argument capacity = fixed_number(kRoom);
       capacity.wrong.push_back({"room for 8 bytes", of(uint64_t(8)), kSmall});
       return call("carom_batch_save", carom_batch_save, {batch(c), world_number(c), fixed(c.take(kRoom)), capacity, out(c, 8), error(c)}).may(kSmall);
     }},
    ROW(carom_batch_get_hashes, batch(c), out(c, 16), all_worlds(c), error(c)),
    ROW(carom_batch_get_stopped, batch(c), out(c, 8), all_worlds(c), error(c)),
    {"carom_batch_get_faults", [](Context& c) {
       const List l = list(c, sizeof(carom_fault));
       return call("carom_batch_get_faults", carom_batch_get_faults, {batch(c), world_number(c), l.dst, l.stride, l.capacity, l.count, error(c)});
     }},
    ROW(carom_batch_get_info, batch(c), out_struct<carom_batch_info>(c), error(c)),
    {"carom_random_fill", [](Context& c) {
       Argument keys = fixed(c.take(48)), n = fixed_number(2), width = fixed_number(3);
       keys.wrong.push_back({"null", of(nullptr), kNull});
       n.wrong.push_back({"more rows than memory", of(~uint64_t(0)), kRange});
       width.wrong.push_back({"more numbers than memory", of(~uint64_t(0)), kRange});
       return call("carom_random_fill", carom_random_fill, {choice(c, CAROM_RANDOM_COUNT), keys, n, width, out(c, 48), error(c)});
     }},
};

#undef ROW
#undef ROW_THAT
#undef GET_LIST
#undef GET_HANDLES
#undef INIT

}  // namespace hostile
