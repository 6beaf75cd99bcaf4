// Calls at the wrong time: from inside a callback they are REENTRANT, from another thread during a step BUSY, and neither
// changes anything. Reads may run side by side.
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include "bench.h"
#include "carom_test.h"

namespace {

/// Every call that can be made with the stage's objects, by name, and its result.
struct Attempt {
  std::string name;
  int32_t result;
};

const double kUp[3] = {0, 1, 0}, kUpright[4] = {0, 0, 0, 1};

std::vector<Attempt> try_world_calls(const Bench& b) {
  std::vector<Attempt> out;
  const auto add = [&](const char* name, int32_t result) { out.push_back({name, result}); };
  carom_material_desc material;
  carom_material_desc_init(&material, sizeof material);
  carom_body_desc body;
  carom_body_desc_init(&body, sizeof body);
  carom_collider_desc collider;
  carom_collider_desc_init(&collider, sizeof collider);
  collider.shape = b.ball;
  uint64_t handle, count;
  double v[7];
  uint32_t asleep, index = 0;
  carom_particles_desc particles;
  carom_particles_desc_init(&particles, sizeof particles);
  carom_step_report report = {};
  report.struct_size = sizeof report;
  add("world_destroy", carom_world_destroy(b.world, nullptr));
  add("world_step", carom_world_step(b.world, 0.01, nullptr));
  add("world_set_preset", carom_world_set_preset(b.world, CAROM_PRESET_FAST, nullptr));
  add("world_set_dial", carom_world_set_dial(b.world, CAROM_DIAL_SUBSTEPS, 2, nullptr));
  add("world_get_dial", carom_world_get_dial(b.world, CAROM_DIAL_SUBSTEPS, v, nullptr));
  add("world_set_gravity", carom_world_set_gravity(b.world, kUp, nullptr));
  add("world_get_gravity", carom_world_get_gravity(b.world, v, nullptr));
  add("world_get_report", carom_world_get_report(b.world, &report, nullptr));
  add("world_get_contacts", carom_world_get_contacts(b.world, nullptr, 0, 0, &count, nullptr));
  add("world_get_faults", carom_world_get_faults(b.world, nullptr, 0, 0, &count, nullptr));
  carom_ledger_state ledger = {};
  ledger.struct_size = sizeof ledger;
  carom_accuracy accuracy;
  carom_accuracy_init(&accuracy, sizeof accuracy);
  uint32_t asked = 0;
  add("world_set_accuracy", carom_world_set_accuracy(b.world, &accuracy, nullptr));
  add("world_get_accuracy", carom_world_get_accuracy(b.world, &accuracy, &asked, nullptr));
  carom_growth growth = {};
  growth.struct_size = sizeof growth;
  add("world_measure_growth", carom_world_measure_growth(b.world, 0.01, 2, &growth, nullptr));
  add("world_get_islands", carom_world_get_islands(b.world, nullptr, 0, 0, &count, nullptr));
  add("world_enable_ledger", carom_world_enable_ledger(b.world, 1, nullptr));
  add("world_get_ledger", carom_world_get_ledger(b.world, nullptr, 0, 0, &count, nullptr));
  add("world_get_ledger_state", carom_world_get_ledger_state(b.world, &ledger, nullptr));
  carom_residuals residuals = {};
  residuals.struct_size = sizeof residuals;
  double seconds;
  uint32_t fewest, most;
  add("world_get_residuals", carom_world_get_residuals(b.world, &residuals, nullptr));
  add("world_set_budget", carom_world_set_budget(b.world, 0, 0, 0, nullptr));
  add("world_get_budget", carom_world_get_budget(b.world, &seconds, &fewest, &most, nullptr));
  add("world_save", carom_world_save(b.world, CAROM_SNAPSHOT_STATE, nullptr, 0, &count, nullptr));
  add("world_restore", carom_world_restore(b.world, "", 0, nullptr));
  carom_difference difference = {};
  difference.struct_size = sizeof difference;
  carom_world* copy = nullptr;
  add("world_compare", carom_world_compare(b.world, "", 0, &difference, nullptr));
  add("world_fork", carom_world_fork(b.world, &copy, nullptr));
  add("world_translate_handles", carom_world_translate_handles(b.world, nullptr, 0, nullptr, nullptr));
  add("world_record_begin", carom_world_record_begin(
                                b.world, 0, [](void*, const void*, uint64_t) { return 0; }, nullptr, nullptr));
  add("world_record_end", carom_world_record_end(b.world, nullptr));
  add("world_hash", carom_world_hash(b.world, &count, nullptr));
  add("material_create", carom_material_create(b.world, &material, &handle, nullptr));
  add("material_update", carom_material_update(b.world, b.material, &material, nullptr));
  add("material_set_pair", carom_material_set_pair(b.world, b.material, b.material, nullptr, nullptr));
  add("material_destroy", carom_material_destroy(b.world, b.material, nullptr));
  add("body_create", carom_body_create(b.world, &body, &handle, nullptr));
  add("body_destroy", carom_body_destroy(b.world, b.bodies[0], nullptr));
  add("body_get", carom_body_get(b.world, b.bodies[0], &body, nullptr));
  add("body_set_pose", carom_body_set_pose(b.world, b.bodies[0], kUp, kUpright, nullptr));
  add("body_set_velocity", carom_body_set_velocity(b.world, b.bodies[0], kUp, kUp, nullptr));
  add("body_is_asleep", carom_body_is_asleep(b.world, b.bodies[0], &asleep, nullptr));
  add("body_wake", carom_body_wake(b.world, b.bodies[0], nullptr));
  add("body_add_force", carom_body_add_force(b.world, b.bodies[0], kUp, kUp, nullptr));
  add("body_add_impulse", carom_body_add_impulse(b.world, b.bodies[0], kUp, kUp, nullptr));
  add("collider_create", carom_collider_create(b.world, b.bodies[0], &collider, &handle, nullptr));
  add("collider_destroy", carom_collider_destroy(b.world, b.colliders[0], nullptr));
  add("collider_get", carom_collider_get(b.world, b.colliders[0], &collider, &handle, nullptr));
  add("particles_create", carom_particles_create(b.world, nullptr, &handle, nullptr));
  add("particles_destroy", carom_particles_destroy(b.world, b.particles, nullptr));
  add("particles_get", carom_particles_get(b.world, b.particles, &particles, nullptr));
  add("particles_update", carom_particles_update(b.world, b.particles, nullptr, nullptr));
  add("particles_get_count", carom_particles_get_count(b.world, b.particles, &count, nullptr));
  add("particles_add", carom_particles_add(b.world, b.particles, 1, CAROM_SCALAR_F64, kUp, 0, nullptr, 0, nullptr));
  add("particles_remove", carom_particles_remove(b.world, b.particles, &index, 1, nullptr));
  add("particles_read",
      carom_particles_read(b.world, b.particles, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, &index, 1, v, 0, nullptr));
  add("particles_write",
      carom_particles_write(b.world, b.particles, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, &index, 1, kUp, 0, nullptr));
  add("particles_get_quarantined", carom_particles_get_quarantined(b.world, b.particles, nullptr, 0, &count, nullptr));
  add("world_get_particles", carom_world_get_particles(b.world, nullptr, 0, &count, nullptr));
  carom_rays rays = {};
  rays.struct_size = sizeof rays;
  carom_world_hits hits = {};
  hits.struct_size = sizeof hits;
  carom_query_shapes shapes = {};
  shapes.struct_size = sizeof shapes;
  carom_world_hit hit;
  uint32_t flag;
  int32_t group;
  uint64_t category, mask;
  double factor, linear[3], angular[3];
  add("body_get_pose", carom_body_get_pose(b.world, b.bodies[0], linear, nullptr, nullptr));
  add("body_get_velocity", carom_body_get_velocity(b.world, b.bodies[0], linear, angular, nullptr));
  add("body_set_mass", carom_body_set_mass(b.world, b.bodies[0], 2, nullptr, nullptr, nullptr));
  add("body_get_mass", carom_body_get_mass(b.world, b.bodies[0], &factor, nullptr, nullptr, nullptr));
  add("body_set_type", carom_body_set_type(b.world, b.bodies[0], CAROM_BODY_STATIC, nullptr));
  add("body_get_type", carom_body_get_type(b.world, b.bodies[0], &flag, nullptr));
  add("body_set_damping", carom_body_set_damping(b.world, b.bodies[0], 1, 1, nullptr));
  add("body_get_damping", carom_body_get_damping(b.world, b.bodies[0], &factor, nullptr, nullptr));
  add("body_set_user", carom_body_set_user(b.world, b.bodies[0], 7, nullptr));
  add("body_get_user", carom_body_get_user(b.world, b.bodies[0], &mask, nullptr));
  add("body_get_colliders", carom_body_get_colliders(b.world, b.bodies[0], nullptr, 0, &count, nullptr));
  add("collider_set_material", carom_collider_set_material(b.world, b.colliders[0], CAROM_NULL_HANDLE, nullptr));
  add("collider_set_density", carom_collider_set_density(b.world, b.colliders[0], 1, nullptr));
  const double upright[4] = {0, 0, 0, 1};
  add("collider_set_pose", carom_collider_set_pose(b.world, b.colliders[0], kUp, upright, nullptr));
  add("body_set_gravity_factor", carom_body_set_gravity_factor(b.world, b.bodies[0], 2, nullptr));
  add("body_get_gravity_factor", carom_body_get_gravity_factor(b.world, b.bodies[0], &factor, nullptr));
  add("body_set_locks", carom_body_set_locks(b.world, b.bodies[0], 1, nullptr));
  add("body_get_locks", carom_body_get_locks(b.world, b.bodies[0], &flag, nullptr));
  const double attribute[4] = {1};
  double attribute_out[4];
  add("body_set_attribute", carom_body_set_attribute(b.world, b.bodies[0], 0, attribute, nullptr));
  add("body_get_attribute", carom_body_get_attribute(b.world, b.bodies[0], 0, attribute_out, nullptr));
  add("collider_set_surface_velocity", carom_collider_set_surface_velocity(b.world, b.colliders[0], kUp, kUp, nullptr));
  add("collider_get_surface_velocity",
      carom_collider_get_surface_velocity(b.world, b.colliders[0], linear, angular, nullptr));
  carom_force_field_desc field;
  carom_force_field_desc_init(&field, sizeof field);
  carom_spring_desc tie;
  carom_spring_desc_init(&tie, sizeof tie);
  tie.body_a = b.bodies[0];
  carom_water water;
  carom_water_init(&water, sizeof water);
  const uint64_t nothing = CAROM_NULL_HANDLE;  // BUSY comes before any look at it
  add("body_add_force_at", carom_body_add_force_at(b.world, b.bodies[0], kUp, kUp, nullptr));
  add("body_set_drag", carom_body_set_drag(b.world, b.bodies[0], 1, 1, nullptr));
  add("body_get_drag", carom_body_get_drag(b.world, b.bodies[0], linear, angular, nullptr));
  add("world_set_wind", carom_world_set_wind(b.world, kUp, nullptr));
  add("world_get_wind", carom_world_get_wind(b.world, linear, nullptr));
  add("force_field_create", carom_force_field_create(b.world, &field, &handle, nullptr));
  add("force_field_update", carom_force_field_update(b.world, nothing, &field, nullptr));
  add("force_field_get", carom_force_field_get(b.world, nothing, &field, nullptr));
  add("force_field_destroy", carom_force_field_destroy(b.world, nothing, nullptr));
  add("body_set_force_field_mask", carom_body_set_force_field_mask(b.world, b.bodies[0], 2, nullptr));
  add("body_get_force_field_mask", carom_body_get_force_field_mask(b.world, b.bodies[0], &flag, nullptr));
  add("spring_create", carom_spring_create(b.world, &tie, &handle, nullptr));
  add("spring_update", carom_spring_update(b.world, nothing, 1, 1, 1, nullptr));
  add("spring_get", carom_spring_get(b.world, nothing, &tie, nullptr));
  add("spring_get_state", carom_spring_get_state(b.world, nothing, linear, angular, nullptr));
  add("spring_destroy", carom_spring_destroy(b.world, nothing, nullptr));
  add("world_set_water", carom_world_set_water(b.world, &water, nullptr));
  add("world_get_water", carom_world_get_water(b.world, &water, &flag, nullptr));
  add("world_set_effect", carom_world_set_effect(b.world, CAROM_EFFECT_DRAG, CAROM_MODE_FORBID, nullptr));
  add("world_get_effect", carom_world_get_effect(b.world, CAROM_EFFECT_DRAG, &flag, nullptr));
  add("body_set_effect", carom_body_set_effect(b.world, b.bodies[0], CAROM_EFFECT_DRAG, CAROM_MODE_FORBID, nullptr));
  add("body_get_effect", carom_body_get_effect(b.world, b.bodies[0], CAROM_EFFECT_DRAG, &flag, nullptr));
  add("world_time_effects", carom_world_time_effects(b.world, 1, nullptr));
  add("world_get_plan", carom_world_get_plan(b.world, nullptr, 0, 0, &count, nullptr));
  add("collider_set_filter", carom_collider_set_filter(b.world, b.colliders[0], 1, 1, 0, nullptr));
  add("collider_get_filter", carom_collider_get_filter(b.world, b.colliders[0], &category, &mask, &group, nullptr));
  add("body_set_filter", carom_body_set_filter(b.world, b.bodies[0], 1, 1, 0, nullptr));
  add("body_ignore_collision", carom_body_ignore_collision(b.world, b.bodies[0], b.bodies[1], 1, nullptr));
  add("collider_set_sensor", carom_collider_set_sensor(b.world, b.colliders[0], 1, nullptr));
  add("collider_is_sensor", carom_collider_is_sensor(b.world, b.colliders[0], &flag, nullptr));
  add("world_collect_events", carom_world_collect_events(b.world, 7, 1, nullptr));
  add("world_get_contact_events", carom_world_get_contact_events(b.world, nullptr, 0, 0, &count, nullptr));
  add("world_get_sensor_events", carom_world_get_sensor_events(b.world, nullptr, 0, 0, &count, nullptr));
  add("world_get_sleep_events", carom_world_get_sleep_events(b.world, nullptr, 0, 0, &count, nullptr));
  add("world_get_joint_events", carom_world_get_joint_events(b.world, nullptr, 0, 0, &count, nullptr));
  add("world_get_fault_events", carom_world_get_fault_events(b.world, nullptr, 0, 0, &count, nullptr));
  add("world_cast_ray", carom_world_cast_ray(b.world, kUp, kUp, 1, nullptr, &hit, sizeof hit, nullptr));
  add("world_cast_rays", carom_world_cast_rays(b.world, &rays, 0, nullptr, &hits, nullptr));
  add("world_cast_rays_all", carom_world_cast_rays_all(b.world, &rays, nullptr, nullptr, 0, 0, &count, nullptr));
  add("world_cast_shapes", carom_world_cast_shapes(b.world, &shapes, 0, nullptr, &hit, 0, nullptr));
  add("world_cast_shapes_all", carom_world_cast_shapes_all(b.world, &shapes, nullptr, nullptr, 0, 0, &count, nullptr));
  add("world_overlap_shapes", carom_world_overlap_shapes(b.world, &shapes, nullptr, nullptr, 0, 0, &count, nullptr));
  add("world_find_nearest", carom_world_find_nearest(b.world, &shapes, 1, nullptr, &hit, 0, nullptr));
  carom_character character;
  carom_character_init(&character, sizeof character);
  carom_character_desc character_desc;
  carom_character_desc_init(&character_desc, sizeof character_desc);
  add("character_set_shape",
      carom_character_set_shape(b.engine, b.world, nullptr, &character, b.ball, nullptr, nullptr));
  add("character_move", carom_character_move(b.world, nullptr, &character, kUp, 0, 0.01, nullptr));
  add("character_push", carom_character_push(b.world, nullptr, &character, 0.01, nullptr));
  add("character_move_body", carom_character_move_body(b.world, &character_desc, &character, 0.01, nullptr));
  carom_vehicle_desc vehicle_desc;
  carom_wheel_desc wheel_desc;
  carom_vehicle_input vehicle_input;
  carom_vehicle vehicle;
  carom_wheel wheel;
  carom_vehicle_desc_init(&vehicle_desc, sizeof vehicle_desc), carom_wheel_desc_init(&wheel_desc, sizeof wheel_desc);
  carom_vehicle_input_init(&vehicle_input, sizeof vehicle_input);
  carom_vehicle_init(&vehicle, sizeof vehicle), carom_wheel_init(&wheel, sizeof wheel);
  vehicle_desc.chassis = b.bodies[0];
  add("vehicle_drive",
      carom_vehicle_drive(b.world, &vehicle_desc, &wheel_desc, 1, &vehicle_input, &vehicle, &wheel, 0.01, nullptr));
  carom_joint_desc joint;
  carom_joint_desc_init(&joint, sizeof joint);
  joint.body_a = b.bodies[0], joint.body_b = b.bodies[1];
  carom_joint_limit limit;
  carom_joint_limit_init(&limit, sizeof limit);
  carom_joint_motor motor;
  carom_joint_motor_init(&motor, sizeof motor);
  carom_joint_spring spring;
  carom_joint_spring_init(&spring, sizeof spring);
  carom_joint_transmission transmission;
  carom_joint_transmission_init(&transmission, sizeof transmission);
  carom_joint_coupling coupling;
  carom_joint_coupling_init(&coupling, sizeof coupling);
  carom_joint_axis axis;
  carom_joint_axis_init(&axis, sizeof axis);
  carom_joint_orientation_drive turn;
  carom_joint_orientation_drive_init(&turn, sizeof turn);
  carom_joint_state joint_state = {};
  joint_state.struct_size = sizeof joint_state;
  const carom_joint none = CAROM_NULL_HANDLE;  // BUSY comes before any look at it
  add("joint_create", carom_joint_create(b.world, &joint, &handle, nullptr));
  add("joint_destroy", carom_joint_destroy(b.world, none, nullptr));
  add("joint_get", carom_joint_get(b.world, none, &joint, nullptr));
  add("joint_get_state", carom_joint_get_state(b.world, none, &joint_state, nullptr));
  add("joint_set_limit", carom_joint_set_limit(b.world, none, CAROM_COORDINATE_TWIST, &limit, nullptr));
  add("joint_set_motor", carom_joint_set_motor(b.world, none, CAROM_COORDINATE_TWIST, &motor, nullptr));
  add("joint_set_spring", carom_joint_set_spring(b.world, none, CAROM_COORDINATE_TWIST, &spring, nullptr));
  add("joint_get_limit", carom_joint_get_limit(b.world, none, CAROM_COORDINATE_TWIST, &limit, nullptr));
  add("joint_get_motor", carom_joint_get_motor(b.world, none, CAROM_COORDINATE_TWIST, &motor, nullptr));
  add("joint_get_spring", carom_joint_get_spring(b.world, none, CAROM_COORDINATE_TWIST, &spring, nullptr));
  add("joint_set_transmission", carom_joint_set_transmission(b.world, none, &transmission, nullptr));
  add("joint_get_transmission", carom_joint_get_transmission(b.world, none, &transmission, nullptr));
  add("joint_couple", carom_joint_couple(b.world, &coupling, &handle, nullptr));
  add("joint_set_coupling", carom_joint_set_coupling(b.world, none, &coupling, nullptr));
  add("joint_get_coupling", carom_joint_get_coupling(b.world, none, &coupling, nullptr));
  add("joint_set_axis", carom_joint_set_axis(b.world, none, CAROM_AXIS_X, &axis, nullptr));
  add("joint_get_axis", carom_joint_get_axis(b.world, none, CAROM_AXIS_X, &axis, nullptr));
  add("joint_set_orientation_drive", carom_joint_set_orientation_drive(b.world, none, &turn, nullptr));
  add("joint_get_orientation_drive", carom_joint_get_orientation_drive(b.world, none, &turn, nullptr));
  add("world_read_joints",
      carom_world_read_joints(b.world, CAROM_JOINT_BULK_FORCE, CAROM_SCALAR_F64, &none, 1, v, 0, nullptr));
  add("world_write_joints",
      carom_world_write_joints(b.world, CAROM_JOINT_BULK_TARGET, CAROM_SCALAR_F64, &none, 1, kUp, 0, nullptr));
  add("tree_get_coordinates", carom_tree_get_coordinates(b.world, b.bodies[0], nullptr, 0, 0, &count, nullptr));
  add("tree_get_speeds", carom_tree_get_speeds(b.world, b.bodies[0], v, 6, nullptr));
  add("tree_get_forces", carom_tree_get_forces(b.world, b.bodies[0], nullptr, nullptr, v, 6, nullptr));
  add("tree_get_mass", carom_tree_get_mass(b.world, b.bodies[0], v, 6, nullptr));
  add("world_get_joints", carom_world_get_joints(b.world, nullptr, 0, &count, nullptr));
  add("world_get_bodies", carom_world_get_bodies(b.world, nullptr, 0, &count, nullptr));
  add("world_read", carom_world_read(b.world, CAROM_FIELD_POSE, CAROM_SCALAR_F64, b.bodies, 1, v, 0, nullptr));
  add("world_write", carom_world_write(b.world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, b.bodies, 1, kUp, 0, nullptr));
  return out;
}

std::vector<Attempt> try_engine_calls(const Bench& b) {
  std::vector<Attempt> out;
  const auto add = [&](const char* name, int32_t result) { out.push_back({name, result}); };
  const double radius = 1;
  double v[9];
  uint64_t handle, count = 3;
  uint32_t dial;
  carom_engine* engine = nullptr;
  carom_world* world = nullptr;
  const carom_shape_plugin* description;
  carom_shape_info info = {};
  info.struct_size = sizeof info;
  carom_distance distance = {};
  distance.struct_size = sizeof distance;
  carom_dial_info dial_info = {};
  dial_info.struct_size = sizeof dial_info;
  add("abi_check", carom_abi_check(carom_abi_manifest(), nullptr));
  add("engine_create", carom_engine_create(nullptr, &engine, nullptr));
  add("engine_destroy", carom_engine_destroy(b.engine, nullptr));
  add("plugin_load", carom_plugin_load(b.engine, CAROM_PLUGIN_DIR "/cone.so", &handle, nullptr));
  add("plugin_register", carom_plugin_register(b.engine, &b.box_plugin, &handle, nullptr));
  add("plugin_unload", carom_plugin_unload(b.engine, b.box, nullptr));
  add("plugin_find", carom_plugin_find(b.engine, "test.box", &handle, nullptr));
  add("plugin_describe", carom_plugin_describe(b.engine, b.box, &description, nullptr));
  add("shape_create", carom_shape_create(b.engine, b.sphere, &radius, 1, &handle, nullptr));
  add("shape_create_half_space", carom_shape_create_half_space(b.engine, kUp, 0, &handle, nullptr));
  add("shape_create_hull_of",
      carom_shape_create_hull_of(b.engine, &b.ball, 1, nullptr, nullptr, nullptr, 0, &handle, nullptr));
  add("shape_get_parts",
      carom_shape_get_parts(b.engine, b.ball, nullptr, nullptr, nullptr, nullptr, &count, nullptr, nullptr));
  add("shape_destroy", carom_shape_destroy(b.engine, b.ball, nullptr));
  add("shape_get_info", carom_shape_get_info(b.engine, b.ball, &info, nullptr));
  add("shape_get_params", carom_shape_get_params(b.engine, b.ball, v, &count, nullptr));
  add("shape_support", carom_shape_support(b.engine, b.ball, kUp, 1, v, nullptr));
  add("shape_distance",
      carom_shape_distance(b.engine, b.ball, kUp, kUpright, b.crate, kUp, kUpright, nullptr, &distance, nullptr));
  carom_pairs pairs = {};
  pairs.struct_size = sizeof pairs;
  pairs.count = 1;
  pairs.shapes_a = &b.ball, pairs.shapes_b = &b.crate;
  pairs.positions_a = pairs.positions_b = kUp, pairs.orientations_a = pairs.orientations_b = kUpright;
  add("pairs_distance", carom_pairs_distance(b.engine, &pairs, nullptr, &distance, sizeof distance, nullptr));
  carom_cast cast = {};
  cast.struct_size = sizeof cast;
  carom_overlap overlap = {};
  overlap.struct_size = sizeof overlap;
  carom_motion motion;
  carom_motion_init(&motion, sizeof motion);
  carom_rays rays = {};
  rays.struct_size = sizeof rays;
  carom_ray_hits hits = {};
  hits.struct_size = sizeof hits;
  add("ray_cast", carom_ray_cast(b.engine, b.ball, kUp, kUpright, kUp, kUp, 1, nullptr, &cast, nullptr));
  add("shape_cast",
      carom_shape_cast(b.engine, b.ball, kUp, kUpright, kUp, b.crate, kUp, kUpright, nullptr, &cast, nullptr));
  add("shape_time_of_impact",
      carom_shape_time_of_impact(b.engine, b.ball, &motion, b.crate, &motion, 1, nullptr, &cast, nullptr));
  add("shape_overlap",
      carom_shape_overlap(b.engine, b.ball, kUp, kUpright, b.crate, kUp, kUpright, nullptr, &overlap, nullptr));
  add("rays_cast", carom_rays_cast(b.engine, &b.ball, kUp, kUpright, 1, &rays, nullptr, &hits, nullptr));
  add("world_create", carom_world_create(b.engine, nullptr, &world, nullptr));
  add("dial_get_info", carom_dial_get_info(0, &dial_info, nullptr));
  carom_constant_info constant_info = {};
  constant_info.struct_size = sizeof constant_info;
  add("constant_get_info", carom_constant_get_info(0, &constant_info, nullptr));
  carom_attribute_info attribute_info = {};
  attribute_info.struct_size = sizeof attribute_info;
  add("attribute_get_info", carom_attribute_get_info(0, &attribute_info, nullptr));
  add("dial_find", carom_dial_find("solver", &dial, nullptr));
  double preset_value = 0;
  add("preset_get_dial", carom_preset_get_dial(0, CAROM_DIAL_SUBSTEPS, &preset_value, nullptr));
  return out;
}

void expect_all(const std::vector<Attempt>& attempts, int32_t code) {
  assert_true(attempts.size() > 10);
  for (const Attempt& a : attempts) {
    if (a.result != code)
      print_error("%s: %s, wanted %s\n", a.name.c_str(), carom_result_name(a.result), carom_result_name(code));
    assert_int_equal(a.result, code);
  }
}

/// What a support function does when it is asked: called once, then behaves.
void (*in_support)() = nullptr;

int32_t scheming_box(void*, const double* params, uint64_t count, const double dir[3], double out[3]) {
  if (auto* act = in_support) {
    in_support = nullptr;
    act();
  }
  return bench_box(nullptr, params, count, dir, out);
}

Bench stage;
std::vector<Attempt> seen;

/// The stage, with a box by the generic path and of a scheming plugin, lying on the floor.
void make_stage() {
  in_support = nullptr;
  seen.clear();
  assert_int_equal(bench_make(&stage, nullptr, nullptr), CAROM_OK);
  static carom_shape_plugin plugin;
  plugin = bench_plugin("test.scheming", bench_box_params, 3, nullptr, scheming_box);
  carom_plugin handle;
  assert_int_equal(carom_plugin_register(stage.engine, &plugin, &handle, nullptr), CAROM_OK);
  const double half[3] = {0.5, 0.5, 0.5};
  carom_shape shape;
  assert_int_equal(carom_shape_create(stage.engine, handle, half, 3, &shape, nullptr), CAROM_OK);
  carom_body body;
  carom_collider collider;
  assert_int_equal(bench_body(stage.world, shape, 0, CAROM_BODY_DYNAMIC, 10, 0.45, 0, &body, &collider, nullptr),
                   CAROM_OK);
  assert_int_equal(bench_particles(&stage, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(stage.world, 5, nullptr), CAROM_OK);
}

void a_support_function_that_calls_back_is_refused(void**) {
  make_stage();
  in_support = [] {
    seen = try_world_calls(stage);
    for (const Attempt& a : try_engine_calls(stage)) seen.push_back(a);
  };
  assert_int_equal(carom_world_step(stage.world, 1.0 / 64, nullptr), CAROM_OK);
  assert_null(in_support);  // it was asked
  expect_all(seen, CAROM_E_REENTRANT);
  const uint64_t hash = bench_hash(stage.world);
  assert_int_equal(bench_free(&stage), CAROM_OK);

  make_stage();  // the same without the schemer
  assert_int_equal(carom_world_step(stage.world, 1.0 / 64, nullptr), CAROM_OK);
  assert_true(bench_hash(stage.world) == hash);
  assert_int_equal(bench_free(&stage), CAROM_OK);
}

void a_support_function_that_calls_back_while_a_shape_is_made_is_refused(void**) {
  make_stage();
  carom_plugin plugin;
  assert_int_equal(carom_plugin_find(stage.engine, "test.scheming", &plugin, nullptr), CAROM_OK);
  in_support = [] { seen = try_engine_calls(stage); };
  const double half[3] = {1, 1, 1};
  carom_shape shape;
  assert_int_equal(carom_shape_create(stage.engine, plugin, half, 3, &shape, nullptr), CAROM_OK);
  expect_all(seen, CAROM_E_REENTRANT);
  assert_int_equal(bench_free(&stage), CAROM_OK);
}

void an_allocator_and_a_log_that_call_back_are_refused(void**) {
  static std::vector<int32_t> results;
  static bool active;
  results.clear();
  carom_engine_desc desc;
  carom_engine_desc_init(&desc, sizeof desc);
  desc.alloc = [](void*, uint64_t size, uint64_t alignment) -> void* {
    carom_engine* inner = nullptr;
    if (active) results.push_back(carom_engine_create(nullptr, &inner, nullptr));
    return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  };
  desc.free = [](void*, void* p, uint64_t, uint64_t) {
    uint32_t dial;
    if (active) results.push_back(carom_dial_find("solver", &dial, nullptr));
    std::free(p);
  };
  static int logged;
  logged = 0;
  desc.log = [](void*, uint32_t, const char* text) {
    uint32_t dial;
    ++logged;
    assert_true(std::strlen(text) > 4);
    if (active) results.push_back(carom_dial_find("solver", &dial, nullptr));
  };
  Bench b;
  active = true;
  assert_int_equal(bench_make(&b, &desc, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 20, nullptr), CAROM_OK);
  assert_int_equal(bench_free(&b), CAROM_OK);
  active = false;
  assert_true(logged > 0);
  assert_true(results.size() > 50);
  for (int32_t r : results) assert_int_equal(r, CAROM_E_REENTRANT);
}

void calls_from_another_thread_during_a_step_are_busy(void**) {
  make_stage();
  // The step stands still inside the support function until the other thread has tried everything.
  in_support = [] { std::thread([] { seen = try_world_calls(stage); }).join(); };
  assert_int_equal(carom_world_step(stage.world, 1.0 / 64, nullptr), CAROM_OK);
  expect_all(seen, CAROM_E_BUSY);
  const uint64_t hash = bench_hash(stage.world);
  assert_int_equal(bench_free(&stage), CAROM_OK);
  make_stage();
  assert_int_equal(carom_world_step(stage.world, 1.0 / 64, nullptr), CAROM_OK);
  assert_true(bench_hash(stage.world) == hash);
  assert_int_equal(bench_free(&stage), CAROM_OK);
}

void the_engine_and_other_worlds_are_free_during_a_step(void**) {
  make_stage();
  static int32_t step_of_another = 1, create_shape = 1, destroy_in_use = 1;
  in_support = [] {
    std::thread([] {
      carom_world* other = nullptr;
      const double radius = 2;
      carom_shape shape;
      carom_world_create(stage.engine, nullptr, &other, nullptr);
      step_of_another = carom_world_step(other, 0.01, nullptr);
      create_shape = carom_shape_create(stage.engine, stage.sphere, &radius, 1, &shape, nullptr);
      destroy_in_use = carom_shape_destroy(stage.engine, stage.ball, nullptr);
      carom_world_destroy(other, nullptr);
    }).join();
  };
  assert_int_equal(carom_world_step(stage.world, 1.0 / 64, nullptr), CAROM_OK);
  assert_int_equal(step_of_another, CAROM_OK);
  assert_int_equal(create_shape, CAROM_OK);
  assert_int_equal(destroy_in_use, CAROM_E_IN_USE);
  assert_int_equal(bench_free(&stage), CAROM_OK);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_support_function_that_calls_back_is_refused),
      cmocka_unit_test(a_support_function_that_calls_back_while_a_shape_is_made_is_refused),
      cmocka_unit_test(an_allocator_and_a_log_that_call_back_are_refused),
      cmocka_unit_test(calls_from_another_thread_during_a_step_are_busy),
      cmocka_unit_test(the_engine_and_other_worlds_are_free_during_a_step),
  };
  return cmocka_run_group_tests_name("abi/busy_reentrant", tests, nullptr, nullptr);
}
