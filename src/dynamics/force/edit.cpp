// Editing what force effects are made from, between steps; and which effects a host forbids or forces. Each function
// reserves, then changes.
#include <algorithm>

#include "dynamics/events/events.h"
#include "dynamics/force/force.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {
namespace {

/// What a forbidden or forced effect changes beyond the plan.
void settle_modes(World& world) {
  for (std::uint32_t i = 0; i < world.scene.locks.size(); ++i) settle_locks(world.scene, i);
  collect(world, world.events->asked, world.events->hit_speed);
  ++world.scene.revision, ++world.scene.collider_revision;
}

void set_bit(RowBits& bits, std::size_t row, bool on) { bits = on ? bits | row_bit(row) : bits & ~row_bit(row); }

}  // namespace

void World::set_wind(const Vec3& wind) {
  if (scene.wind == wind) return;
  scene.wind = wind;
  wake_all(*this);
  ++scene.revision;
}

void World::set_water(const WaterDef* water) {
  scene.water.on = water != nullptr;
  if (water) scene.water.def = *water;
  wake_all(*this);
  ++scene.revision;
}

Handle World::add_field(const FieldDef& def) {
  reserve_slot(scene.fields.slots.slots(), scene.fields.def);
  const Handle handle = scene.fields.slots.take();
  if (handle == 0) return 0;
  const std::uint32_t slot = handle_slot(handle);
  if (slot == scene.fields.def.size()) scene.fields.def.emplace_back();
  set_field(slot, def);
  return handle;
}

void World::set_field(std::uint32_t field, const FieldDef& def) {
  scene.fields.def[field] = def;
  wake_all(*this);
  ++scene.revision;
}

void World::remove_field(std::uint32_t field) {
  scene.fields.slots.release(field);
  wake_all(*this);
  ++scene.revision;
}

Handle World::add_spring(const SpringDef& def) {
  Springs& s = scene.springs;
  reserve_slot(s.slots.slots(), s.def, s.stiffness, s.damping);
  s.ends.reserve(scene.bodies.slots()), s.load.reserve(scene.bodies.slots());
  const Handle handle = s.slots.take();
  if (handle == 0) return 0;
  const std::uint32_t slot = handle_slot(handle);
  if (slot == s.def.size()) s.def.emplace_back(), s.stiffness.push_back(0), s.damping.push_back(0);
  if (s.ends.size() < scene.bodies.slots()) s.ends.resize(scene.bodies.slots(), 0);
  if (s.load.size() < scene.bodies.slots()) s.load.resize(scene.bodies.slots());
  fill_spring(slot, def);
  def.each_end([&](std::uint32_t body, const Vec3&) { wake(*this, body); });
  ++scene.revision;
  return handle;
}

void World::fill_spring(std::uint32_t slot, const SpringDef& def) {
  Springs& s = scene.springs;
  s.def[slot] = def;
  def.each_end([&](std::uint32_t body, const Vec3&) { ++s.ends[body]; });
}

void World::set_spring(std::uint32_t spring, Real rest, Real stiffness, Real damping) {
  SpringDef& def = scene.springs.def[spring];
  def.each_end([&](std::uint32_t body, const Vec3&) { wake(*this, body); });
  def.rest = rest, def.stiffness = stiffness, def.damping = damping;
}

void World::remove_spring(std::uint32_t spring) {
  Springs& s = scene.springs;
  s.def[spring].each_end([&](std::uint32_t body, const Vec3&) {
    --s.ends[body];
    wake(*this, body);
  });
  s.slots.release(spring);
  ++scene.revision;
}

void remove_springs_of(World& world, std::uint32_t body) {
  const Springs& s = world.scene.springs;
  if (!s.hang_on(body)) return;
  s.each([&](std::uint32_t k, const SpringDef& def) {
    if (def.hangs_on(body)) world.remove_spring(k);
  });
}

void World::set_mode(std::size_t row, EffectMode mode) {
  if (scene.modes.of_world(row) == mode) return;
  if (row == +EffectId::events) events->slept.reserve(scene.bodies.slots());  // the last that may run out of memory
  wake_all(*this);
  set_bit(scene.modes.forbidden, row, mode == EffectMode::forbid);
  set_bit(scene.modes.forced, row, mode == EffectMode::force);
  if (mode == EffectMode::forbid) scene.modes.forbidden_anywhere |= row_bit(row);
  settle_modes(*this);
}

void World::set_body_mode(std::uint32_t body, std::size_t row, EffectMode mode) {
  EffectModes& modes = scene.modes;
  if (modes.of_body(row, body) == mode) return;
  const std::uint32_t slots = scene.bodies.slots();
  modes.forbidden_of.reserve(slots);
  if (modes.forced_of.size() < slots) modes.forced_of.resize(slots, 0);
  if (modes.forbidden_of.size() < slots) modes.forbidden_of.resize(slots, 0);
  mark_touched_by_host(*this, body);
  set_bit(modes.forbidden_of[body], row, mode == EffectMode::forbid);
  set_bit(modes.forced_of[body], row, mode == EffectMode::force);
  if (mode == EffectMode::forbid) modes.forbidden_anywhere |= row_bit(row);
  settle_modes(*this);
}

}  // namespace carom::dynamics
