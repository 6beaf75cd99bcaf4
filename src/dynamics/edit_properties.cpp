// What a host changes of a body or a collider that is there: its kind, mass, damping; its material, density, place.
#include <algorithm>

#include "dynamics/contact_views.h"
#include "dynamics/force/force.h"
#include "dynamics/query/index.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {

void World::set_mass(std::uint32_t body, const MassGiven& given) {
  wake(*this, body);
  BodySettings& def = scene.def[body];
  def.has_mass = given.mass > 0, def.has_center = given.has_center, def.has_inertia = given.has_inertia;
  def.mass = given.mass, def.center = given.center, def.inertia = given.inertia;
  settle_mass(body);
  scene.bodies.mark_change(), ++scene.revision;
}

void World::set_damping(std::uint32_t body, Real linear, Real angular) {
  BodySettings& def = scene.def[body];
  if (def.linear_damping == linear && def.angular_damping == angular) return;
  wake(*this, body);
  def.linear_damping = linear, def.angular_damping = angular;
  scene.bodies.mark_change(), ++scene.revision;
}

void World::set_type(std::uint32_t body, BodyType type) {
  if (scene.type[body] == type) return;
  Colliders& c = scene.colliders;
  contact_views();
  wake(*this, body);
  const auto each = [&](auto&& f) {
    for (std::uint32_t i = scene.first_collider[body]; i != kInvalid; i = c.next[i]) f(i);
  };
  each([&](std::uint32_t i) {  // may run out of memory, so it comes before any change
    if (scene.type[body] != BodyType::dynamic) wake_touching(*this, i);
    pairs.remove(i);
  });
  BodySettings& def = scene.def[body];
  scene.type[body] = def.type = type;
  if (type != BodyType::dynamic) def.has_mass = def.has_center = def.has_inertia = false;
  each([&](std::uint32_t i) {
    c.movable[i] = how_moved(type);
    queries->mark_changed(i);
  });
  if (type == BodyType::fixed) state.v[body] = state.omega[body] = Vec3::zero();
  if (type != BodyType::dynamic) {
    state.force[body] = state.torque[body] = Vec3::zero();
    for (const AttributeRow& row : kAttributeTable)
      if (row.of_dynamic && body < scene.attributes.bodies(row.id)) scene.attributes.set(row.id, body, row.usual);
    settle_locks(scene, body);
  }
  settle_mass(body);
  state.mark_written(body);
  queries->mark_moved(body);
  mark_touched_by_host(*this, body);
  scene.bodies.mark_change(), ++scene.revision, ++scene.collider_revision;
}

void World::set_enabled(std::uint32_t body, bool enabled) {
  if (state.is_disabled(body) != enabled) return;
  Colliders& c = scene.colliders;
  contact_views();
  mark_touched_by_host(*this, body);  // may run out of memory, as forgetting pairs may, so that comes before any change
  wake_joined(*this, Sleepers(*this), body);
  for (std::uint32_t i = scene.first_collider[body]; i != kInvalid; i = c.next[i]) {
    wake_touching(*this, i);
    pairs.remove(i);
    queries->mark_changed(i);
  }
  state.held_out[body] ^= Quarantine::kDisabled;
  state.mark_written(body);
  queries->mark_moved(body);
  scene.bodies.mark_change(), ++scene.revision, ++scene.collider_revision;
}

void World::set_collider_material(std::uint32_t collider, std::uint32_t material) {
  if (scene.colliders.material[collider] == material) return;
  mark_touched_by_host(*this, scene.colliders.body[collider]);
  scene.colliders.material[collider] = material;
  scene.collider_slots.mark_change(), ++scene.revision;
}

void World::set_density(std::uint32_t collider, Real density) {
  if (scene.colliders.density[collider] == density) return;
  const std::uint32_t body = scene.colliders.body[collider];
  wake(*this, body);
  scene.colliders.density[collider] = density;
  settle_mass(body);
  scene.collider_slots.mark_change(), ++scene.revision;
}

void World::set_local_pose(std::uint32_t collider, const Pose& local) {
  Colliders& c = scene.colliders;
  const std::uint32_t body = c.body[collider];
  contact_views();
  mark_touched_by_host(*this, body);
  pairs.remove(collider);
  c.local[collider] = Pose{oriented(local.q), local.p};
  settle_mass(body);
  queries->mark_changed(collider);
  queries->mark_moved(body);
  scene.collider_slots.mark_change(), ++scene.revision, ++scene.collider_revision;
}

}  // namespace carom::dynamics
