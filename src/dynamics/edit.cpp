// Editing a world between steps: bodies, colliders and materials come and go. Each function reserves, then changes.
#include <algorithm>

#include "dynamics/contact/contact.h"
#include "dynamics/contact_views.h"
#include "dynamics/effects.h"
#include "dynamics/events/events.h"
#include "dynamics/force/force.h"
#include "dynamics/mass.h"
#include "dynamics/query/index.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {
namespace {

template <class T>
void put(Array<T>& a, std::size_t slot, const T& value) {
  if (slot == a.size())
    a.push_back(value);
  else
    a[slot] = value;
}

void count_resistance(Scene& s) {
  s.resists = false;
  for (std::uint32_t i = 0; i < s.material_slots.slots(); ++i)
    s.resists |= s.material_slots.alive(i) && (s.material[i].rolling > 0 || s.material[i].spinning > 0);
  for (const MaterialPair& pair : s.material_pairs) s.resists |= pair.rolling > 0 || pair.spinning > 0;
}

auto lower_bound_of_pair(Array<MaterialPair>& pairs, std::uint32_t a, std::uint32_t b) {
  return std::find_if(pairs.begin(), pairs.end(),
                      [&](const MaterialPair& p) { return p.a > a || (p.a == a && p.b >= b); });
}

/// The slot that take() will hand out can be at most the number of slots there are.
void reserve_body(Scene& s, State& t) {
  reserve_slot(s.bodies.slots(), s.def, s.type, s.inv_mass, s.mass, s.center, s.inertia, s.inv_inertia,
               s.first_collider, t.x, t.q, t.held_q, t.placed_x, t.placed_q, t.v, t.omega, t.momentum, t.force,
               t.torque, t.held_out, t.loaded_steps, t.cooldown_steps, t.accuracy, t.written, t.is_written);
}

/// New mass properties; the body's frame stays where it is and its centre's velocity what it was.
void place_mass(Scene& s, State& t, std::uint32_t body, const BodyMass& m) {
  if (m.center != s.center[body]) t.mark_written(body);  // it may be out of bounds by now
  t.x[body] += t.q[body] * (m.center - s.center[body]);
  s.mass[body] = m.mass, s.inv_mass[body] = m.inv_mass, s.center[body] = m.center;
  s.inertia[body] = m.inertia, s.inv_inertia[body] = m.inv_inertia;
}

/// Where the link to a body's first collider at or after `collider` stands. Bodies have few colliders.
std::uint32_t& link_to(Scene& s, std::uint32_t body, std::uint32_t collider) {
  std::uint32_t* link = &s.first_collider[body];
  while (*link < collider) link = &s.colliders.next[*link];  // kInvalid is larger than any slot
  return *link;
}

}  // namespace

Handle World::add_body(const BodyDef& def) {
  reserve_body(scene, state);
  const Handle handle = scene.bodies.take();
  if (handle == 0) return 0;
  fill_body(handle_slot(handle), def);
  ++scene.revision;
  return handle;
}

void World::fill_body(std::uint32_t i, const BodyDef& def) {
  put<BodySettings>(scene.def, i, def);
  put(scene.type, i, def.type);
  put(scene.inv_mass, i, Real(0));
  put(scene.mass, i, Real(0));
  put<Vec3>(scene.center, i, Vec3::zero());
  put<Mat3>(scene.inertia, i, Mat3::zero());
  put<Mat3>(scene.inv_inertia, i, Mat3::zero());
  put(scene.first_collider, i, kInvalid);
  put(state.x, i, def.pose.p);
  put(state.q, i, oriented(def.pose.q));
  put(state.held_q, i, state.q[i]);
  put(state.placed_x, i, state.x[i]);
  put(state.placed_q, i, state.q[i]);
  const bool moves = def.type != BodyType::fixed;
  put<Vec3>(state.v, i, moves ? def.velocity : Vec3::zero());
  put<Vec3>(state.omega, i, moves ? def.omega : Vec3::zero());
  put<Vec3>(state.momentum, i, Vec3::zero());
  put<Vec3>(state.force, i, Vec3::zero());
  put<Vec3>(state.torque, i, Vec3::zero());
  put(state.held_out, i, static_cast<std::uint8_t>(def.disabled ? Quarantine::kDisabled : 0));
  put(state.loaded_steps, i, std::uint8_t(0));
  put(state.cooldown_steps, i, std::uint8_t(0));
  put(state.accuracy, i, AccuracyMemory());
  if (i == state.is_written.size()) state.is_written.push_back(0);
  place_mass(scene, state, i, mass_of_body(scene, i));
  state.mark_written(i);
}

void World::remove_body(std::uint32_t body) {
  wake(*this, body);
  while (joints.any_of(body)) remove_joint(joints.first[body]);
  remove_springs_of(*this, body);
  while (scene.first_collider[body] != kInvalid) remove_collider(scene.first_collider[body]);
  scene.inv_mass[body] = scene.mass[body] = 0;
  scene.inertia[body].set_zero(), scene.inv_inertia[body].set_zero();
  scene.attributes.reset(body);
  settle_locks(scene, body);
  if (body < scene.modes.forbidden_of.size()) scene.modes.forbidden_of[body] = scene.modes.forced_of[body] = 0;
  state.v[body] = state.omega[body] = state.force[body] = state.torque[body] = Vec3::zero();
  state.quarantined_count -= state.is_lost(body);
  state.held_out[body] = 0;
  unlist_body(*this, body);
  scene.apart.remove(body);
  if (body < events->slept.size()) events->slept[body] = 0;
  scene.bodies.release(body);
  ++scene.revision;
}

Handle World::add_collider(std::uint32_t body, const Shape* shape, const Pose& local, Real density,
                           std::uint32_t material, const ColliderSettings& settings) {
  Colliders& c = scene.colliders;
  const auto grow = [&](bool is_unusual, auto& all) {
    const std::uint32_t slots = scene.collider_slots.slots() + 1;
    if (is_unusual && all.size() < slots) all.resize(slots, {});
  };
  grow(settings.filter != Filter(), c.filter);
  grow(settings.sensor, c.sensor);
  grow(settings.surface.any(), scene.surface);
  reserve_slot(scene.collider_slots.slots(), c.shape, c.local, c.body, c.material, c.density, c.frame, c.bounds,
               c.reach, c.movable, c.disabled, c.next, c.travel);
  reserve_slot(c.live.size(), c.live);
  mark_touched_by_host(*this, body);
  const Handle handle = scene.collider_slots.take();
  if (handle == 0) return 0;
  const std::uint32_t i = handle_slot(handle);
  fill_collider(i, body, shape, local, density, material);
  if (i < c.filter.size()) c.filter[i] = settings.filter;
  if (i < c.sensor.size()) c.sensor[i] = settings.sensor;
  if (i < scene.surface.size()) scene.surface[i] = settings.surface;
  scene.moving_surfaces += settings.surface.any();
  settle_mass(body);
  queries->mark_changed(i);
  queries->mark_moved(body);
  ++scene.revision, ++scene.collider_revision;
  return handle;
}

void World::fill_collider(std::uint32_t i, std::uint32_t body, const Shape* shape, const Pose& local, Real density,
                          std::uint32_t material) {
  Colliders& c = scene.colliders;
  put(c.shape, i, shape);
  put(c.local, i, Pose{oriented(local.q), local.p});
  put(c.body, i, body);
  put(c.material, i, material);
  put(c.density, i, density);
  put(c.frame, i, Frame());
  put(c.travel, i, Real(0));
  put(c.bounds, i, Aabb());
  put(c.reach, i, Real(0));
  put(c.movable, i, how_moved(scene.type[body]));
  put(c.disabled, i, std::uint8_t(0));
  std::uint32_t& link = link_to(scene, body, i);
  put(c.next, i, link);
  link = i;
  c.live.insert(std::lower_bound(c.live.begin(), c.live.end(), i), i);
}

void World::settle_mass(std::uint32_t body) {
  contact_views();  // before the body's centre moves
  place_mass(scene, state, body, mass_of_body(scene, body));
}

void World::remove_collider(std::uint32_t collider) {
  Colliders& c = scene.colliders;
  const std::uint32_t body = c.body[collider];
  contact_views();
  wake(*this, body);
  if (scene.type[body] != BodyType::dynamic) wake_touching(*this, collider);  // else they are one island
  pairs.remove(collider);  // may run out of memory, so it comes before any loss
  views->remove(collider);
  unlist_collider(*this, collider);
  const Shape* shape = c.shape[collider];
  place_mass(scene, state, body, mass_of_body(scene, body, collider));
  link_to(scene, body, collider) = c.next[collider];
  c.live.erase(std::lower_bound(c.live.begin(), c.live.end(), collider));
  if (collider < scene.surface.size()) {
    scene.moving_surfaces -= scene.surface[collider].any();
    scene.surface[collider] = SurfaceVelocity{};
  }
  c.shape[collider] = nullptr;
  c.bounds[collider] = Aabb();
  scene.collider_slots.release(collider);
  // The host may now free the shape, and another may come to live at its address.
  const auto wears = [&](std::uint32_t slot) { return c.shape[slot] == shape; };
  if (!plan->faulty.empty() && std::none_of(c.live.begin(), c.live.end(), wears)) std::erase(plan->faulty, shape);
  queries->mark_changed(collider);
  queries->mark_moved(body);
  ++scene.revision, ++scene.collider_revision;
}

Handle World::add_material(const Material& m) {
  reserve_slot(scene.material_slots.slots(), scene.material);
  const Handle handle = scene.material_slots.take();
  if (handle == 0) return 0;
  put(scene.material, handle_slot(handle), m);
  count_resistance(scene);
  ++scene.revision;
  return handle;
}

void World::set_material(std::uint32_t material, const Material& m) {
  scene.material[material] = m;
  count_resistance(scene);
  wake_wearing(*this, material);
  ++scene.revision;
}

void World::remove_material(std::uint32_t material) {
  scene.material_slots.release(material);
  std::erase_if(scene.material_pairs, [&](const MaterialPair& p) { return p.a == material || p.b == material; });
  count_resistance(scene);
  ++scene.revision;
}

void World::set_material_pair(const MaterialPair& pair) {
  scene.material_pairs.reserve(scene.material_pairs.size() + 1);
  const auto at = lower_bound_of_pair(scene.material_pairs, pair.a, pair.b);
  if (at != scene.material_pairs.end() && at->a == pair.a && at->b == pair.b)
    *at = pair;
  else
    scene.material_pairs.insert(at, pair);
  count_resistance(scene);
  wake_wearing(*this, pair.a), wake_wearing(*this, pair.b);
  ++scene.revision;
}

void World::remove_material_pair(std::uint32_t a, std::uint32_t b) {
  if (std::erase_if(scene.material_pairs, [&](const MaterialPair& p) { return p.a == a && p.b == b; }) == 0) return;
  count_resistance(scene);
  wake_wearing(*this, a), wake_wearing(*this, b);
  ++scene.revision;
}

void World::set_filter(std::uint32_t collider, const Filter& filter) {
  Array<Filter>& all = scene.colliders.filter;
  if (scene.colliders.filter_of(collider) == filter) return;
  if (all.size() < scene.colliders.slots()) all.resize(scene.colliders.slots());
  mark_touched_by_host(*this, scene.colliders.body[collider]);
  all[collider] = filter;
  ++scene.revision;
}

void World::set_body_filter(std::uint32_t body, const Filter& filter) {
  Array<Filter>& all = scene.colliders.filter;
  if (all.size() < scene.colliders.slots()) all.resize(scene.colliders.slots());
  mark_touched_by_host(*this, body);  // may run out of memory, so it comes before any of them has changed
  for (std::uint32_t c = scene.first_collider[body]; c != kInvalid; c = scene.colliders.next[c]) all[c] = filter;
  ++scene.revision;
}

void World::set_sensor(std::uint32_t collider, bool sensor) {
  Colliders& c = scene.colliders;
  if (c.is_sensor(collider) == sensor) return;
  if (c.sensor.size() < c.slots()) c.sensor.resize(c.slots(), 0);
  mark_touched_by_host(*this, c.body[collider]);
  c.sensor[collider] = sensor;
  ++scene.revision;
}

void World::set_surface_velocity(std::uint32_t collider, const SurfaceVelocity& surface) {
  const SurfaceVelocity was = scene.surface_of(collider);
  if (was.linear == surface.linear && was.angular == surface.angular) return;
  if (scene.surface.size() < scene.colliders.slots()) scene.surface.resize(scene.colliders.slots());
  mark_touched_by_host(*this, scene.colliders.body[collider]);
  scene.surface[collider] = surface;
  scene.moving_surfaces += surface.any(), scene.moving_surfaces -= was.any();
  ++scene.revision;
}

void World::reserve_another(AttributeId id) {
  const std::uint32_t slots = scene.bodies.slots() + 1;
  if (id == AttributeId::locks && scene.locks.size() < slots) scene.locks.resize(slots, 0);
  scene.attributes.reserve(id, slots);
}

void World::set_attribute(std::uint32_t body, AttributeId id, const AttributeValue& value) {
  if (scene.attributes.of(id, body) == value) return;
  const std::uint32_t slots = scene.bodies.slots();
  if (id == AttributeId::locks && scene.locks.size() < slots) scene.locks.resize(slots, 0);
  scene.attributes.reserve(id, slots);
  wake(*this, body);
  scene.attributes.set(id, body, value);
  if (id == AttributeId::locks) {
    settle_locks(scene, body);
    hold_velocity(scene, body, state.q[body], state.v[body], state.omega[body]);
    state.mark_written(body);
  }
  ++scene.revision;
}

void World::ignore_collision(std::uint32_t a, std::uint32_t b) {
  scene.apart.reserve();
  mark_touched_by_host(*this, a), mark_touched_by_host(*this, b);
  scene.apart.add(a, b);
  ++scene.revision;
}

void World::restore_collision(std::uint32_t a, std::uint32_t b) {
  mark_touched_by_host(*this, a), mark_touched_by_host(*this, b);
  scene.apart.remove(a, b);
  ++scene.revision;
}

void World::set_dial(Dial dial, Real value) {
  if (scene.dials[dial] == value) return;
  scene.dials[dial] = value;
  if (dial != Dial::substeps) wake_all(*this);  // who rests does so in steps of any length
  ++scene.revision;
}

void World::set_gravity(const Vec3& g) {
  if (scene.gravity == g) return;
  scene.gravity = g;
  wake_all(*this);
  ++scene.revision;
}

void World::set_pose(std::uint32_t body, const Pose& pose) {
  const Quat q = oriented(pose.q);
  const Vec3 x = pose.p + q * scene.center[body];
  const bool same = q == state.q[body] && x == state.x[body] && !state.is_lost(body);
  if (same && scene.type[body] != BodyType::dynamic) return;  // a host that places all in every step wakes none
  contact_views();
  mark_touched_by_host(*this, body);
  state.q[body] = state.held_q[body] = q;
  state.x[body] = x;
  const bool revised = state.is_lost(body) || scene.type[body] == BodyType::fixed;
  queries->mark_moved(body, revised && !state.is_lost(body));
  state.mark_written(body);
  if (revised) {
    state.quarantined_count -= state.is_lost(body);
    state.held_out[body] &= Quarantine::kDisabled;  // the host takes it back
    ++scene.revision, ++scene.collider_revision;
  }
}

void World::set_velocity(std::uint32_t body, const Vec3& linear, const Vec3& angular) {
  if (linear != Vec3::zero() || angular != Vec3::zero()) wake(*this, body);
  state.v[body] = linear;
  state.omega[body] = angular;
  if (scene.locks_of(body)) hold_velocity(scene, body, state.q[body], state.v[body], state.omega[body]);
  state.mark_written(body);
}

bool World::add_impulse(std::uint32_t body, const Vec3& impulse, const Vec3& point) {
  if (!(scene.inv_mass[body] > 0)) return true;
  const Quat& q = state.q[body];
  const Vec3 v = state.v[body] + scene.inv_mass[body] * impulse;
  const Vec3 spin = (point - state.x[body]).cross(impulse);
  const Vec3 omega = state.omega[body] + q * (scene.inv_inertia[body] * (q.conjugate() * spin));
  if (!finite(v) || !finite(omega)) return false;
  if (impulse != Vec3::zero()) wake(*this, body);
  state.v[body] = v;
  state.omega[body] = omega;
  if (scene.locks_of(body)) hold_velocity(scene, body, q, state.v[body], state.omega[body]);
  state.mark_written(body);
  return true;
}

bool World::add_force(std::uint32_t body, const Vec3& force, const Vec3& torque) {
  const Vec3 f = state.force[body] + force, t = state.torque[body] + torque;
  if (!finite(f) || !finite(t)) return false;
  set_force(body, f, t);
  return true;
}

void World::set_force(std::uint32_t body, const Vec3& force, const Vec3& torque) {
  if (force != Vec3::zero() || torque != Vec3::zero()) wake(*this, body);
  state.force[body] = force;
  state.torque[body] = torque;
  state.mark_written(body);
}

void World::set_continuous(std::uint32_t body, SweepMode mode) {
  if (scene.def[body].continuous == mode) return;
  scene.def[body].continuous = mode;
  ++scene.revision;
}

void World::wake_body(std::uint32_t body) { wake(*this, body); }

}  // namespace carom::dynamics
