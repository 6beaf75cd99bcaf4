// Drag, wind, fields, springs and water: what a host says about them, checked and handed to the world, and read back.
#include "dynamics/force/force.h"

#include <carom/force.h>

#include <cmath>

#include "abi/ends.h"
#include "core/float_scope.h"
#include "abi/record_calls.h"
#include "abi/world.h"
#include "dynamics/quarantine.h"

namespace carom::abi {
namespace {

static_assert(static_cast<std::uint32_t>(FieldKind::count) == CAROM_FORCE_FIELD_COUNT);

constexpr double kFastestWind = 1e6, kStrongestForce = 1e30, kLongestSpring = 1e9, kDensest = 1e9, kMostRate = 1e6;
constexpr std::int32_t kLeastFalloff = -2, kMostFalloff = 8;

bool resolve_field(Call& call, const World& world, carom_force_field field) {
  return resolve(call, 2, "field", world.scene.fields.slots, field);
}
bool resolve_spring(Call& call, const World& world, carom_spring spring) {
  return resolve(call, 2, "spring", world.scene.springs.slots, spring);
}

/// Above 0; may be infinite.
/// May be infinite.
bool positive(Call& call, int argument, const char* name, double value) {
  return value > 0 || call.fail(std::isnan(value) ? CAROM_E_NOT_FINITE : CAROM_E_OUT_OF_RANGE, argument,
                                "%s is %g, must be greater than 0", name, value);
}

/// @param argument  the descriptor's
bool read_field(Call& call, int argument, const carom_force_field_desc* given, FieldDef& def) {
  carom_force_field_desc d;
  carom_force_field_desc_init(&d, sizeof d);
  if (!read_struct(call, argument, "desc", given, d) || !only_bits(call, argument, "desc->reserved", d.reserved, 0) ||
      !known(call, argument, "desc->kind", d.kind, CAROM_FORCE_FIELD_COUNT) ||
      !only_bits(call, argument, "desc->is_force", d.is_force, 1) ||
      !vector_in_range(call, argument, "desc->position", d.position, kMaxPosition) ||
      !unit(call, argument, "desc->orientation", d.orientation, 4) ||
      !positive(call, argument, "desc->half[0]", d.half[0]) || !positive(call, argument, "desc->half[1]", d.half[1]) ||
      !positive(call, argument, "desc->half[2]", d.half[2]) ||
      !vector_in_range(call, argument, "desc->vector", d.vector, kStrongestForce) ||
      !in_range(call, argument, "desc->strength", d.strength, -kStrongestForce, kStrongestForce) ||
      !in_range(call, argument, "desc->pull", d.pull, -kStrongestForce, kStrongestForce) ||
      !in_range(call, argument, "desc->lift", d.lift, -kStrongestForce, kStrongestForce) ||
      !in_range(call, argument, "desc->reference", d.reference, 1e-9, kLongestSpring) ||
      !in_range(call, argument, "desc->core", d.core, 0, kLongestSpring) ||
      !positive(call, argument, "desc->reach", d.reach))
    return false;
  if (d.falloff < kLeastFalloff || d.falloff > kMostFalloff)
    return call.fail(CAROM_E_OUT_OF_RANGE, argument, "desc->falloff is %d, must be within [%d, %d]", d.falloff,
                     kLeastFalloff, kMostFalloff);
  def.kind = static_cast<FieldKind>(d.kind);
  def.is_force = d.is_force != 0;
  def.pose = {to_quat(d.orientation), to_vec3(d.position)};
  def.half = to_vec3(d.half), def.vector = to_vec3(d.vector);
  def.strength = d.strength, def.pull = d.pull, def.lift = d.lift;
  def.reference = d.reference, def.core = d.core, def.reach = d.reach, def.falloff = d.falloff;
  def.mask = d.mask, def.user = d.user;
  return true;
}

carom_force_field_desc describe(const FieldDef& def) {
  carom_force_field_desc d{};
  d.kind = static_cast<std::uint32_t>(def.kind);
  d.is_force = def.is_force, d.mask = def.mask;
  from_vec3(def.pose.p, d.position), from_quat(def.pose.q, d.orientation);
  from_vec3(def.half, d.half), from_vec3(def.vector, d.vector);
  d.strength = def.strength, d.pull = def.pull, d.lift = def.lift;
  d.reference = def.reference, d.core = def.core, d.reach = def.reach, d.falloff = def.falloff;
  d.user = def.user;
  return d;
}

bool check_spring(Call& call, int argument, double rest, double stiffness, double damping) {
  return in_range(call, argument, "rest", rest, 0, kLongestSpring) &&
         in_range(call, argument == 2 ? 2 : argument + 1, "stiffness", stiffness, 0, kStrongestForce) &&
         in_range(call, argument == 2 ? 2 : argument + 2, "damping", damping, 0, kStrongestForce);
}

bool read_spring(Call& call, const World& world, const carom_spring_desc* given, SpringDef& def) {
  carom_spring_desc d;
  carom_spring_desc_init(&d, sizeof d);
  if (!read_struct(call, 2, "desc", given, d) || !only_bits(call, 2, "desc->only_pulls", d.only_pulls, 1) ||
      !read_ends(call, world, d, "ties", def))
    return false;
  if (!vector_in_range(call, 2, "desc->anchor_a", d.anchor_a, kMaxPosition) ||
      !vector_in_range(call, 2, "desc->anchor_b", d.anchor_b, kMaxPosition) ||
      !check_spring(call, 2, d.rest, d.stiffness, d.damping))
    return false;
  def.anchor_a = to_vec3(d.anchor_a), def.anchor_b = to_vec3(d.anchor_b);
  def.rest = d.rest, def.stiffness = d.stiffness, def.damping = d.damping;
  def.only_pulls = d.only_pulls != 0, def.user = d.user;
  return true;
}

carom_spring_desc describe(const World& world, const SpringDef& def) {
  carom_spring_desc d{};
  d.only_pulls = def.only_pulls;
  d.body_a = handle_of_end(world, def.body_a), d.body_b = handle_of_end(world, def.body_b);
  from_vec3(def.anchor_a, d.anchor_a), from_vec3(def.anchor_b, d.anchor_b);
  d.rest = def.rest, d.stiffness = def.stiffness, d.damping = def.damping;
  d.user = def.user;
  return d;
}

bool read_water(Call& call, const carom_water* given, WaterDef& def) {
  carom_water w;
  carom_water_init(&w, sizeof w);
  if (!read_struct(call, 2, "water", given, w) || !only_bits(call, 2, "water->reserved", w.reserved, 0) ||
      !unit(call, 2, "water->normal", w.normal, 3) ||
      !in_range(call, 2, "water->level", w.level, -kMaxPosition, kMaxPosition) ||
      !in_range(call, 2, "water->density", w.density, 0, kDensest) || !positive(call, 2, "water->density", w.density) ||
      !vector_in_range(call, 2, "water->current", w.current, kFastestWind) ||
      !in_range(call, 2, "water->drag", w.drag, 0, kMostRate))
    return false;
  def = {to_vec3(w.normal).normalized(), w.level, w.density, to_vec3(w.current), w.drag};
  return true;
}

carom_water describe(const WaterDef& def) {
  carom_water w{};
  from_vec3(def.normal, w.normal);
  w.level = def.level, w.density = def.density;
  from_vec3(def.current, w.current);
  w.drag = def.drag;
  return w;
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_body_add_force_at(carom_world* world, carom_body body, const double force[3], const double point[3],
                                carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_add_force_at(body, force, point));
    if (!changing || !resolve_body(call, *changing, body) || !finite(call, 3, "force", force, 3) ||
        !finite(call, 4, "point", point, 3))
      return;
    const FloatScope scope;
    const std::uint32_t slot = handle_slot(body);
    const Vec3 f = to_vec3(force);
    if (!changing->add_force(slot, f, (to_vec3(point) - changing->state.x[slot]).cross(f)))
      call.fail(CAROM_E_OUT_OF_RANGE, larger_of(3, force, point), "what was added up to now overflows with this");
  });
}

int32_t carom_world_set_wind(carom_world* world, const double velocity[3], carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::world_set_wind(velocity));
    if (changing && vector_in_range(call, 2, "velocity", velocity, kFastestWind)) changing->set_wind(to_vec3(velocity));
  });
}

int32_t carom_world_get_wind(carom_world* world, double velocity[3], carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && present(call, 2, "velocity", velocity)) from_vec3(reading->scene.wind, velocity);
  });
}

const char* carom_force_field_name(uint32_t kind) {
  return kind < CAROM_FORCE_FIELD_COUNT ? kFieldKinds[kind].name : "?";
}

int32_t carom_force_field_desc_init(carom_force_field_desc* desc, uint32_t struct_size) {
  return init_struct(desc, struct_size, [](carom_force_field_desc& d) {
    d.mask = 1;
    d.orientation[3] = 1;
    for (double& half : d.half) half = kInfinity;
    d.reference = 1;
    d.reach = kInfinity;
    d.falloff = 2;
  });
}

int32_t carom_force_field_create(carom_world* world, const carom_force_field_desc* desc, carom_force_field* field,
                                 carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::force_field_create(desc));
    if (!changing) return;
    const FloatScope scope;
    FieldDef def;
    if (!read_field(call, 2, desc, def) || !present(call, 3, "field", field)) return;
    const Handle handle = changing->add_field(def);
    if (handle)
      *field = handle;
    else
      call.fail(CAROM_E_LIMIT, 0, "this world has issued all %u fields", kMaxSlots);
  });
}

int32_t carom_force_field_update(carom_world* world, carom_force_field field, const carom_force_field_desc* desc,
                                 carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::force_field_update(field, desc));
    if (!changing || !resolve_field(call, *changing, field)) return;
    const FloatScope scope;
    FieldDef def;
    if (read_field(call, 3, desc, def)) changing->set_field(handle_slot(field), def);
  });
}

int32_t carom_force_field_get(carom_world* world, carom_force_field field, carom_force_field_desc* desc,
                              carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && resolve_field(call, *reading, field) && fillable(call, 3, "desc", desc))
      write_struct(describe(reading->scene.fields.def[handle_slot(field)]), desc);
  });
}

int32_t carom_force_field_destroy(carom_world* world, carom_force_field field, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::force_field_destroy(field));
    if (changing && resolve_field(call, *changing, field)) changing->remove_field(handle_slot(field));
  });
}

int32_t carom_spring_desc_init(carom_spring_desc* desc, uint32_t struct_size) { return init_struct(desc, struct_size); }

int32_t carom_spring_create(carom_world* world, const carom_spring_desc* desc, carom_spring* spring,
                            carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::spring_create(desc));
    if (!changing) return;
    SpringDef def;
    if (!read_spring(call, *changing, desc, def) || !present(call, 3, "spring", spring)) return;
    const Handle handle = changing->add_spring(def);
    if (handle)
      *spring = handle;
    else
      call.fail(CAROM_E_LIMIT, 0, "this world has issued all %u springs", kMaxSlots);
  });
}

int32_t carom_spring_update(carom_world* world, carom_spring spring, double rest, double stiffness, double damping,
                            carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::spring_update(spring, rest, stiffness, damping));
    if (changing && resolve_spring(call, *changing, spring) && check_spring(call, 3, rest, stiffness, damping))
      changing->set_spring(handle_slot(spring), rest, stiffness, damping);
  });
}

int32_t carom_spring_get(carom_world* world, carom_spring spring, carom_spring_desc* desc, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && resolve_spring(call, *reading, spring) && fillable(call, 3, "desc", desc))
      write_struct(describe(*reading, reading->scene.springs.def[handle_slot(spring)]), desc);
  });
}

int32_t carom_spring_get_state(carom_world* world, carom_spring spring, double* length, double* force,
                               carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve_spring(call, *reading, spring) || !present(call, 3, "length", length) ||
        !present(call, 4, "force", force))
      return;
    const FloatScope scope;
    const SpringReading now = carom::read_spring(*reading, handle_slot(spring));
    *length = now.length, *force = now.pull;
  });
}

int32_t carom_spring_destroy(carom_world* world, carom_spring spring, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::spring_destroy(spring));
    if (changing && resolve_spring(call, *changing, spring)) changing->remove_spring(handle_slot(spring));
  });
}

int32_t carom_water_init(carom_water* water, uint32_t struct_size) {
  return init_struct(water, struct_size, [](carom_water& d) {
    d.normal[1] = 1;
    d.density = 1000;
    d.drag = 1;
  });
}

int32_t carom_world_set_water(carom_world* world, const carom_water* water, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::world_set_water(water));
    if (!changing) return;
    const FloatScope scope;
    WaterDef def;
    if (!water)
      changing->set_water(nullptr);
    else if (read_water(call, water, def))
      changing->set_water(&def);
  });
}

int32_t carom_world_get_water(carom_world* world, carom_water* water, uint32_t* there, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !fillable(call, 2, "water", water) || !present(call, 3, "present", there)) return;
    *there = reading->scene.water.on;
    carom_water full;
    carom_water_init(&full, sizeof full);
    write_struct(*there ? describe(reading->scene.water.def) : full, water);
  });
}

}  // extern "C"
