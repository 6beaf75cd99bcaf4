// Written by bindings/gen/generate from include/carom; do not edit.
#ifndef CAROM_FILL_HPP
#define CAROM_FILL_HPP
#include <carom/carom.h>

namespace carom::raw {
inline void fill(carom_error &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_accuracy &it) noexcept { carom_accuracy_init(&it, sizeof it); }
inline void fill(carom_growth &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_batch_column &it) noexcept { carom_batch_column_init(&it, sizeof it); }
inline void fill(carom_batch_info &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_material_desc &it) noexcept { carom_material_desc_init(&it, sizeof it); }
inline void fill(carom_body_desc &it) noexcept { carom_body_desc_init(&it, sizeof it); }
inline void fill(carom_attribute_info &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_collider_desc &it) noexcept { carom_collider_desc_init(&it, sizeof it); }
inline void fill(carom_cast_desc &it) noexcept { carom_cast_desc_init(&it, sizeof it); }
inline void fill(carom_cast &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_motion &it) noexcept { carom_motion_init(&it, sizeof it); }
inline void fill(carom_overlap &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_rays &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_ray_hits &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_character_desc &it) noexcept { carom_character_desc_init(&it, sizeof it); }
inline void fill(carom_character &it) noexcept { carom_character_init(&it, sizeof it); }
inline void fill(carom_dial_info &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_constant_info &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_draw_desc &it) noexcept { carom_draw_desc_init(&it, sizeof it); }
inline void fill(carom_engine_desc &it) noexcept { carom_engine_desc_init(&it, sizeof it); }
inline void fill(carom_jobs_desc &it) noexcept { carom_jobs_desc_init(&it, sizeof it); }
inline void fill(carom_force_field_desc &it) noexcept { carom_force_field_desc_init(&it, sizeof it); }
inline void fill(carom_spring_desc &it) noexcept { carom_spring_desc_init(&it, sizeof it); }
inline void fill(carom_water &it) noexcept { carom_water_init(&it, sizeof it); }
inline void fill(carom_joint_desc &it) noexcept { carom_joint_desc_init(&it, sizeof it); }
inline void fill(carom_joint_limit &it) noexcept { carom_joint_limit_init(&it, sizeof it); }
inline void fill(carom_joint_motor &it) noexcept { carom_joint_motor_init(&it, sizeof it); }
inline void fill(carom_joint_spring &it) noexcept { carom_joint_spring_init(&it, sizeof it); }
inline void fill(carom_joint_transmission &it) noexcept { carom_joint_transmission_init(&it, sizeof it); }
inline void fill(carom_joint_coupling &it) noexcept { carom_joint_coupling_init(&it, sizeof it); }
inline void fill(carom_joint_axis &it) noexcept { carom_joint_axis_init(&it, sizeof it); }
inline void fill(carom_joint_orientation_drive &it) noexcept { carom_joint_orientation_drive_init(&it, sizeof it); }
inline void fill(carom_joint_state &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_ledger_state &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_pairs &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_device_info &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_particles_desc &it) noexcept { carom_particles_desc_init(&it, sizeof it); }
inline void fill(carom_geometry &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_shape_plugin &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_distance_desc &it) noexcept { carom_distance_desc_init(&it, sizeof it); }
inline void fill(carom_distance &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_difference &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_residuals &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_mesh_desc &it) noexcept { carom_mesh_desc_init(&it, sizeof it); }
inline void fill(carom_height_field_desc &it) noexcept { carom_height_field_desc_init(&it, sizeof it); }
inline void fill(carom_scenery_info &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_shape_info &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_vehicle_desc &it) noexcept { carom_vehicle_desc_init(&it, sizeof it); }
inline void fill(carom_wheel_desc &it) noexcept { carom_wheel_desc_init(&it, sizeof it); }
inline void fill(carom_vehicle_input &it) noexcept { carom_vehicle_input_init(&it, sizeof it); }
inline void fill(carom_vehicle &it) noexcept { carom_vehicle_init(&it, sizeof it); }
inline void fill(carom_wheel &it) noexcept { carom_wheel_init(&it, sizeof it); }
inline void fill(carom_world_desc &it) noexcept { carom_world_desc_init(&it, sizeof it); }
inline void fill(carom_step_report &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_query_desc &it) noexcept { carom_query_desc_init(&it, sizeof it); }
inline void fill(carom_query_shapes &it) noexcept { it = {}, it.struct_size = sizeof it; }
inline void fill(carom_world_hits &it) noexcept { it = {}, it.struct_size = sizeof it; }
}  // namespace carom::raw
#endif
