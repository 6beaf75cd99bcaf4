// How each call that changes a world is written down, see recorder.h. Written by bindings/gen/generate from include/carom; do not edit.
#pragma once

#include <carom/carom.h>

#include "abi/columns.h"
#include "abi/recorder.h"

namespace carom::abi::record {

inline auto material_create(const carom_material_desc* desc) {
  return [=](Pen& pen) {
    pen.call("carom_material_create");
    pen.structure(desc);
  };
}
inline auto material_update(carom_material material, const carom_material_desc* desc) {
  return [=](Pen& pen) {
    pen.call("carom_material_update");
    pen.number(material);
    pen.structure(desc);
  };
}
inline auto material_set_resistance(carom_material material, double rolling, double spinning) {
  return [=](Pen& pen) {
    pen.call("carom_material_set_resistance");
    pen.number(material);
    pen.number(rolling);
    pen.number(spinning);
  };
}
inline auto material_destroy(carom_material material) {
  return [=](Pen& pen) {
    pen.call("carom_material_destroy");
    pen.number(material);
  };
}
inline auto body_create(const carom_body_desc* desc) {
  return [=](Pen& pen) {
    pen.call("carom_body_create");
    pen.structure(desc);
  };
}
inline auto body_destroy(carom_body body) {
  return [=](Pen& pen) {
    pen.call("carom_body_destroy");
    pen.number(body);
  };
}
inline auto body_set_pose(carom_body body, const double* position, const double* orientation) {
  return [=](Pen& pen) {
    pen.call("carom_body_set_pose");
    pen.number(body);
    pen.list(position, 3);
    pen.list(orientation, 4);
  };
}
inline auto body_set_velocity(carom_body body, const double* linear, const double* angular) {
  return [=](Pen& pen) {
    pen.call("carom_body_set_velocity");
    pen.number(body);
    pen.list(linear, 3);
    pen.list(angular, 3);
  };
}
inline auto body_add_force(carom_body body, const double* force, const double* torque) {
  return [=](Pen& pen) {
    pen.call("carom_body_add_force");
    pen.number(body);
    pen.list(force, 3);
    pen.list(torque, 3);
  };
}
inline auto body_add_impulse(carom_body body, const double* impulse, const double* point) {
  return [=](Pen& pen) {
    pen.call("carom_body_add_impulse");
    pen.number(body);
    pen.list(impulse, 3);
    pen.list(point, 3);
  };
}
inline auto body_set_gravity_factor(carom_body body, double factor) {
  return [=](Pen& pen) {
    pen.call("carom_body_set_gravity_factor");
    pen.number(body);
    pen.number(factor);
  };
}
inline auto body_set_locks(carom_body body, uint32_t locks) {
  return [=](Pen& pen) {
    pen.call("carom_body_set_locks");
    pen.number(body);
    pen.number(locks);
  };
}
inline auto body_wake(carom_body body) {
  return [=](Pen& pen) {
    pen.call("carom_body_wake");
    pen.number(body);
  };
}
inline auto body_set_continuous(carom_body body, uint32_t mode) {
  return [=](Pen& pen) {
    pen.call("carom_body_set_continuous");
    pen.number(body);
    pen.number(mode);
  };
}
inline auto collider_create(carom_body body, const carom_collider_desc* desc) {
  return [=](Pen& pen) {
    pen.call("carom_collider_create");
    pen.number(body);
    pen.shape(desc->shape);
    pen.structure(desc);
  };
}
inline auto collider_destroy(carom_collider collider) {
  return [=](Pen& pen) {
    pen.call("carom_collider_destroy");
    pen.number(collider);
  };
}
inline auto collider_set_surface_velocity(carom_collider collider, const double* linear, const double* angular) {
  return [=](Pen& pen) {
    pen.call("carom_collider_set_surface_velocity");
    pen.number(collider);
    pen.list(linear, 3);
    pen.list(angular, 3);
  };
}
inline auto world_write(uint32_t field, uint32_t scalar, const carom_body* handles, uint64_t n, const void* src, uint64_t stride) {
  return [=](Pen& pen) {
    pen.call("carom_world_write");
    pen.number(field);
    pen.number(scalar);
    pen.list(handles, n);
    pen.number(n);
    pen.records(src, n, field_width(field), scalar, stride);
  };
}
inline auto world_collect_events(uint32_t kinds, double hit_speed) {
  return [=](Pen& pen) {
    pen.call("carom_world_collect_events");
    pen.number(kinds);
    pen.number(hit_speed);
  };
}
inline auto collider_set_filter(carom_collider collider, uint64_t category, uint64_t mask, int32_t group) {
  return [=](Pen& pen) {
    pen.call("carom_collider_set_filter");
    pen.number(collider);
    pen.number(category);
    pen.number(mask);
    pen.number(group);
  };
}
inline auto body_set_filter(carom_body body, uint64_t category, uint64_t mask, int32_t group) {
  return [=](Pen& pen) {
    pen.call("carom_body_set_filter");
    pen.number(body);
    pen.number(category);
    pen.number(mask);
    pen.number(group);
  };
}
inline auto body_hold_apart(carom_body body_a, carom_body body_b, uint32_t apart) {
  return [=](Pen& pen) {
    pen.call("carom_body_hold_apart");
    pen.number(body_a);
    pen.number(body_b);
    pen.number(apart);
  };
}
inline auto collider_set_sensor(carom_collider collider, uint32_t sensor) {
  return [=](Pen& pen) {
    pen.call("carom_collider_set_sensor");
    pen.number(collider);
    pen.number(sensor);
  };
}
inline auto body_add_force_at(carom_body body, const double* force, const double* point) {
  return [=](Pen& pen) {
    pen.call("carom_body_add_force_at");
    pen.number(body);
    pen.list(force, 3);
    pen.list(point, 3);
  };
}
inline auto body_set_drag(carom_body body, double linear, double quadratic) {
  return [=](Pen& pen) {
    pen.call("carom_body_set_drag");
    pen.number(body);
    pen.number(linear);
    pen.number(quadratic);
  };
}
inline auto world_set_wind(const double* velocity) {
  return [=](Pen& pen) {
    pen.call("carom_world_set_wind");
    pen.list(velocity, 3);
  };
}
inline auto force_field_create(const carom_force_field_desc* desc) {
  return [=](Pen& pen) {
    pen.call("carom_force_field_create");
    pen.structure(desc);
  };
}
inline auto force_field_update(carom_force_field field, const carom_force_field_desc* desc) {
  return [=](Pen& pen) {
    pen.call("carom_force_field_update");
    pen.number(field);
    pen.structure(desc);
  };
}
inline auto force_field_destroy(carom_force_field field) {
  return [=](Pen& pen) {
    pen.call("carom_force_field_destroy");
    pen.number(field);
  };
}
inline auto body_set_force_field_mask(carom_body body, uint32_t mask) {
  return [=](Pen& pen) {
    pen.call("carom_body_set_force_field_mask");
    pen.number(body);
    pen.number(mask);
  };
}
inline auto spring_create(const carom_spring_desc* desc) {
  return [=](Pen& pen) {
    pen.call("carom_spring_create");
    pen.structure(desc);
  };
}
inline auto spring_update(carom_spring spring, double rest, double stiffness, double damping) {
  return [=](Pen& pen) {
    pen.call("carom_spring_update");
    pen.number(spring);
    pen.number(rest);
    pen.number(stiffness);
    pen.number(damping);
  };
}
inline auto spring_destroy(carom_spring spring) {
  return [=](Pen& pen) {
    pen.call("carom_spring_destroy");
    pen.number(spring);
  };
}
inline auto world_set_water(const carom_water* water) {
  return [=](Pen& pen) {
    pen.call("carom_world_set_water");
    pen.structure(water);
  };
}
inline auto joint_create(const carom_joint_desc* desc) {
  return [=](Pen& pen) {
    pen.call("carom_joint_create");
    pen.structure(desc);
  };
}
inline auto joint_destroy(carom_joint joint) {
  return [=](Pen& pen) {
    pen.call("carom_joint_destroy");
    pen.number(joint);
  };
}
inline auto joint_set_limit(carom_joint joint, uint32_t coordinate, const carom_joint_limit* limit) {
  return [=](Pen& pen) {
    pen.call("carom_joint_set_limit");
    pen.number(joint);
    pen.number(coordinate);
    pen.structure(limit);
  };
}
inline auto joint_set_motor(carom_joint joint, uint32_t coordinate, const carom_joint_motor* motor) {
  return [=](Pen& pen) {
    pen.call("carom_joint_set_motor");
    pen.number(joint);
    pen.number(coordinate);
    pen.structure(motor);
  };
}
inline auto joint_set_spring(carom_joint joint, uint32_t coordinate, const carom_joint_spring* spring) {
  return [=](Pen& pen) {
    pen.call("carom_joint_set_spring");
    pen.number(joint);
    pen.number(coordinate);
    pen.structure(spring);
  };
}
inline auto joint_set_transmission(carom_joint joint, const carom_joint_transmission* transmission) {
  return [=](Pen& pen) {
    pen.call("carom_joint_set_transmission");
    pen.number(joint);
    pen.structure(transmission);
  };
}
inline auto world_enable_ledger(uint32_t on) {
  return [=](Pen& pen) {
    pen.call("carom_world_enable_ledger");
    pen.number(on);
  };
}
inline auto particles_create(const carom_particles_desc* desc) {
  return [=](Pen& pen) {
    pen.call("carom_particles_create");
    pen.structure(desc);
  };
}
inline auto particles_destroy(carom_particles set) {
  return [=](Pen& pen) {
    pen.call("carom_particles_destroy");
    pen.number(set);
  };
}
inline auto particles_update(carom_particles set, const carom_particles_desc* desc) {
  return [=](Pen& pen) {
    pen.call("carom_particles_update");
    pen.number(set);
    pen.structure(desc);
  };
}
inline auto particles_add(carom_particles set, uint64_t n, uint32_t scalar, const void* positions, uint64_t position_stride, const void* velocities, uint64_t velocity_stride) {
  return [=](Pen& pen) {
    pen.call("carom_particles_add");
    pen.number(set);
    pen.number(n);
    pen.number(scalar);
    pen.records(positions, n, 3, scalar, position_stride);
    pen.records(velocities, n, 3, scalar, velocity_stride);
  };
}
inline auto particles_remove(carom_particles set, const uint32_t* indices, uint64_t n) {
  return [=](Pen& pen) {
    pen.call("carom_particles_remove");
    pen.number(set);
    pen.list(indices, n);
    pen.number(n);
  };
}
inline auto particles_write(carom_particles set, uint32_t field, uint32_t scalar, const uint32_t* indices, uint64_t n, const void* src, uint64_t stride) {
  return [=](Pen& pen) {
    pen.call("carom_particles_write");
    pen.number(set);
    pen.number(field);
    pen.number(scalar);
    pen.list(indices, n);
    pen.number(n);
    pen.records(src, n, field_width(field), scalar, stride);
  };
}
inline auto world_set_effect(uint32_t effect, uint32_t mode) {
  return [=](Pen& pen) {
    pen.call("carom_world_set_effect");
    pen.number(effect);
    pen.number(mode);
  };
}
inline auto body_set_effect(carom_body body, uint32_t effect, uint32_t mode) {
  return [=](Pen& pen) {
    pen.call("carom_body_set_effect");
    pen.number(body);
    pen.number(effect);
    pen.number(mode);
  };
}
inline auto world_time_effects(uint32_t on) {
  return [=](Pen& pen) {
    pen.call("carom_world_time_effects");
    pen.number(on);
  };
}
inline auto world_restore(const void* bytes, uint64_t size) {
  return [=](Pen& pen) {
    pen.call("carom_world_restore");
    pen.bytes(bytes, size);
    pen.number(size);
  };
}
inline auto world_step(double dt) {
  return [=](Pen& pen) {
    pen.call("carom_world_step");
    pen.number(dt);
  };
}
inline auto world_set_dial(uint32_t dial, double value) {
  return [=](Pen& pen) {
    pen.call("carom_world_set_dial");
    pen.number(dial);
    pen.number(value);
  };
}
inline auto world_set_preset(uint32_t preset) {
  return [=](Pen& pen) {
    pen.call("carom_world_set_preset");
    pen.number(preset);
  };
}
inline auto world_set_gravity(const double* gravity) {
  return [=](Pen& pen) {
    pen.call("carom_world_set_gravity");
    pen.list(gravity, 3);
  };
}

}  // namespace carom::abi::record
