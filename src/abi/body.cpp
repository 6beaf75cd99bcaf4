// Bodies: what a host says about one, checked and handed to the world, and read back.
#include "abi/body.h"

#include <carom/body.h>

#include <cstddef>
#include <cstring>

#include "abi/attribute_fields.h"
#include "abi/collider.h"
#include "core/float_scope.h"
#include "abi/record_calls.h"
#include "abi/world.h"
#include "dynamics/mass.h"
#include "dynamics/quarantine.h"

namespace carom::abi {
namespace {

static_assert(static_cast<std::uint32_t>(BodyType::fixed) == CAROM_BODY_STATIC &&
              static_cast<std::uint32_t>(BodyType::kinematic) == CAROM_BODY_KINEMATIC &&
              static_cast<std::uint32_t>(BodyType::dynamic) == CAROM_BODY_DYNAMIC);

static_assert(static_cast<std::uint32_t>(SweepMode::automatic) == CAROM_CONTINUOUS_AUTO &&
              static_cast<std::uint32_t>(SweepMode::always) == CAROM_CONTINUOUS_ALWAYS &&
              static_cast<std::uint32_t>(SweepMode::never) == CAROM_CONTINUOUS_NEVER);

constexpr std::uint32_t kBodyFields = CAROM_BODY_FIELD_MASS | CAROM_BODY_FIELD_CENTER | CAROM_BODY_FIELD_INERTIA;
static_assert(kAllLocks == CAROM_LOCK_ALL &&
              kLinearLocks == (CAROM_LOCK_LINEAR_X | CAROM_LOCK_LINEAR_Y | CAROM_LOCK_LINEAR_Z) &&
              kAngularLocks == (CAROM_LOCK_ANGULAR_X | CAROM_LOCK_ANGULAR_Y | CAROM_LOCK_ANGULAR_Z));
constexpr double kSymmetryTolerance = 1e-9;  // of the largest entry: what a rotation of a tensor in double may leave

bool check_mass(Call& call, const carom_body_desc& d) {
  const std::uint32_t about_mass = CAROM_BODY_FIELD_CENTER | CAROM_BODY_FIELD_INERTIA;
  if (!only_bits(call, 2, "desc->fields", d.fields, kBodyFields | CAROM_BODY_STAYS_AWAKE | CAROM_BODY_DISABLED))
    return false;
  if ((d.fields & about_mass) && !(d.fields & CAROM_BODY_FIELD_MASS))
    return call.fail(CAROM_E_OUT_OF_RANGE, 2, "desc->fields is 0x%x: CENTER and INERTIA need MASS", d.fields);
  if (!(d.fields & CAROM_BODY_FIELD_MASS) && d.mass != 0)
    return call.fail(CAROM_E_OUT_OF_RANGE, 2, "desc->mass is %g, and desc->fields lacks CAROM_BODY_FIELD_MASS",
                     d.mass) ||
           call.advise(
               "set CAROM_BODY_FIELD_MASS in desc->fields, or leave desc->mass 0: then densities give the mass");
  if (d.fields & CAROM_BODY_FIELD_MASS) {
    if (!in_range(call, 2, "desc->mass", d.mass, 0, kInfinity)) return false;
    if (d.type == CAROM_BODY_DYNAMIC && d.mass < kLeastMass)
      return call.fail(CAROM_E_OUT_OF_RANGE, 2, "desc->mass is %g; a dynamic body's must be at least %g", d.mass,
                       kLeastMass);
  }
  return (!(d.fields & CAROM_BODY_FIELD_CENTER) || vector_in_range(call, 2, "desc->center", d.center, kMaxPosition)) &&
         (!(d.fields & CAROM_BODY_FIELD_INERTIA) || check_inertia(call, 2, "desc->inertia", d.inertia));
}

bool check_motion(Call& call, const carom_body_desc& d) {
  return finite(call, 2, "desc->position", d.position, 3) && unit(call, 2, "desc->orientation", d.orientation, 4) &&
         finite(call, 2, "desc->linear_velocity", d.linear_velocity, 3) &&
         finite(call, 2, "desc->angular_velocity", d.angular_velocity, 3) &&
         (d.type != CAROM_BODY_STATIC || at_rest(call, 2, "desc->linear_velocity", d.linear_velocity)) &&
         (d.type != CAROM_BODY_STATIC || at_rest(call, 2, "desc->angular_velocity", d.angular_velocity)) &&
         in_range(call, 2, "desc->linear_damping", d.linear_damping, 0, kLargestDamping) &&
         in_range(call, 2, "desc->angular_damping", d.angular_damping, 0, kLargestDamping);
}

/// What a descriptor says besides: read_body() reads it and describe() writes it.
constexpr std::string_view kOtherFields[] = {
    "struct_size",      "fields",   "type",   "reserved", "position",       "orientation",     "linear_velocity",
    "angular_velocity", "mass",     "center", "inertia",  "linear_damping", "angular_damping", "user",
    "continuous",       "reserved2"};
static_assert(
    [] {
      constexpr std::string_view kStruct = "carom_body_desc.";
      for (const LayoutRow& row : kLayout) {
        if (!row.name.starts_with(kStruct)) continue;
        const std::string_view name = row.name.substr(kStruct.size());
        bool is_read = std::ranges::find(kOtherFields, name) != std::end(kOtherFields);
        for (const AttributeRow& of : kAttributeTable)
          for (const char* const field : of.fields) is_read |= field && name == field;
        if (!is_read) return false;
      }
      return true;
    }(),
    "a field of carom_body_desc is neither in kOtherFields nor named by a row of kAttributeTable: nothing would read it");

bool check_attributes(Call& call, const World& world, const carom_body_desc& d) {
  if (!only_bits(call, 2, "desc->locks", d.locks, CAROM_LOCK_ALL)) return false;
  bool may = true;
  each_field([&](const AttributeRow& row) {
    std::array<const char*, kMostNumbers> names{};
    for (std::uint32_t k = 0; k < row.numbers; ++k) names[k] = kAttributeFields[+row.id].number[k].name.data();
    may = may && may_have(call, world, static_cast<BodyType>(d.type), row.id, value_in(d, row), names.data());
  });
  return may;
}

bool read_body(Call& call, const World& world, const carom_body_desc* given, carom_body_desc& d, BodyDef& def) {
  carom_body_desc_init(&d, sizeof d);
  if (!read_struct(call, 2, "desc", given, d) || !only_bits(call, 2, "desc->reserved", d.reserved, 0) ||
      !only_bits(call, 2, "desc->reserved2", d.reserved2, 0) ||
      !known(call, 2, "desc->type", d.type, CAROM_BODY_DYNAMIC + 1) ||
      !known(call, 2, "desc->continuous", d.continuous, CAROM_CONTINUOUS_NEVER + 1) || !check_mass(call, d) ||
      !check_motion(call, d) || !check_attributes(call, world, d))
    return false;
  def.type = static_cast<BodyType>(d.type);
  def.pose = {to_quat(d.orientation), to_vec3(d.position)};
  def.velocity = to_vec3(d.linear_velocity);
  def.omega = to_vec3(d.angular_velocity);
  if (def.type == BodyType::dynamic) {  // the others' mass is infinite, whatever the host says
    def.has_mass = d.fields & CAROM_BODY_FIELD_MASS;
    def.has_center = d.fields & CAROM_BODY_FIELD_CENTER;
    def.has_inertia = d.fields & CAROM_BODY_FIELD_INERTIA;
  }
  if (def.has_mass) def.mass = d.mass;
  if (def.has_center) def.center = to_vec3(d.center);
  if (def.has_inertia) def.inertia = symmetric(d.inertia);
  def.linear_damping = d.linear_damping;
  def.angular_damping = d.angular_damping;
  def.user = d.user;
  def.stays_awake = d.fields & CAROM_BODY_STAYS_AWAKE;
  def.disabled = d.fields & CAROM_BODY_DISABLED;
  def.continuous = static_cast<SweepMode>(d.continuous);
  return true;
}

carom_body_desc describe(const World& world, std::uint32_t slot) {
  const BodySettings& def = world.scene.def[slot];
  carom_body_desc d{};
  d.fields = kBodyFields | (def.stays_awake ? CAROM_BODY_STAYS_AWAKE : 0u) |
             (world.state.is_disabled(slot) ? CAROM_BODY_DISABLED : 0u);
  d.type = static_cast<std::uint32_t>(world.scene.type[slot]);
  const Pose pose = world.pose(slot);
  from_vec3(pose.p, d.position);
  from_quat(pose.q, d.orientation);
  from_vec3(world.state.v[slot], d.linear_velocity);
  from_vec3(world.state.omega[slot], d.angular_velocity);
  d.mass = world.scene.mass[slot];
  from_vec3(world.scene.center[slot], d.center);
  for (int i = 0; i < 9; ++i) d.inertia[i] = world.scene.inertia[slot](i / 3, i % 3);
  d.linear_damping = def.linear_damping;
  d.angular_damping = def.angular_damping;
  d.user = def.user;
  d.continuous = static_cast<std::uint32_t>(def.continuous);
  each_field([&](const AttributeRow& row) { put_value(world.scene.attributes.of(row.id, slot), row, d); });
  return d;
}

/// Only the first collider's removal can run out of memory, so all go or none.
void remove(carom_engine& engine, World& world, std::uint32_t body) {
  const std::uint32_t& first = world.scene.first_collider[body];
  while (first != kInvalid) remove_collider(engine, world, first);
  std::erase_if(world.fault_views, [&](const FaultView& v) { return v.body == body; });
  world.remove_body(body);
}

}  // namespace

// Cholesky on entries scaled to 1, so nothing overflows.
bool check_inertia(Call& call, int argument, const char* name, const double inertia[9]) {
  if (!finite(call, argument, name, inertia, 9)) return false;
  const Mat3 m = Mat3::from_rows(inertia);
  const Real largest = m.abs().max_entry();
  if (largest == 0) return true;
  const Mat3 a = m / largest;
  if ((a - a.transpose()).abs().max_entry() > kSymmetryTolerance)
    return call.fail(CAROM_E_OUT_OF_RANGE, argument, "%s is not symmetric: %g, %g, %g against %g, %g, %g", name,
                     inertia[1], inertia[2], inertia[5], inertia[3], inertia[6], inertia[7]);
  const Real d0 = a(0, 0), l10 = a(1, 0) / d0, l20 = a(2, 0) / d0;
  const Real d1 = a(1, 1) - l10 * a(1, 0), l21 = (a(2, 1) - l20 * a(1, 0)) / d1;
  const Real d2 = a(2, 2) - l20 * a(2, 0) - l21 * (a(2, 1) - l20 * a(1, 0));
  return (d0 > 0 && d1 > 0 && d2 > 0) ||
         call.fail(CAROM_E_OUT_OF_RANGE, argument, "%s is not positive definite (pivots %g, %g, %g times %g)", name, d0,
                   d1, d2, largest);
}

Mat3 symmetric(const double inertia[9]) {
  const Mat3 m = Mat3::from_rows(inertia);
  return 0.5 * m + 0.5 * m.transpose();  // the largest does not overflow
}

bool at_rest(Call& call, int argument, const char* name, const double v[3]) {
  return (v[0] == 0 && v[1] == 0 && v[2] == 0) ||
         call.fail(CAROM_E_OUT_OF_RANGE, argument, "%s is (%g, %g, %g); a static body's must be 0", name, v[0], v[1],
                   v[2]);
}

}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_body_desc_init(carom_body_desc* desc, uint32_t struct_size) {
  return init_struct(desc, struct_size, [](carom_body_desc& d) {
    d.type = CAROM_BODY_DYNAMIC;
    d.orientation[3] = 1;
    each_field([&](const AttributeRow& row) { put_value(row.usual, row, d); });
  });
}

int32_t carom_body_create(carom_world* world, const carom_body_desc* desc, carom_body* body, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_create(desc));
    carom_body_desc d;
    BodyDef def;
    if (!changing || !read_body(call, *changing, desc, d, def) || !present(call, 3, "body", body)) return;
    const FloatScope scope;
    each_field([&](const AttributeRow& row) {
      if (value_in(d, row) != row.usual) changing->reserve_another(row.id);
    });
    const Handle handle = changing->add_body(def);
    if (!handle) {
      call.fail(CAROM_E_LIMIT, 0, "this world has issued all %u bodies", kMaxSlots);
      return;
    }
    each_field(
        [&](const AttributeRow& row) { changing->set_attribute(handle_slot(handle), row.id, value_in(d, row)); });
    *body = handle;
  });
}

int32_t carom_body_destroy(carom_world* world, carom_body body, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_destroy(body));
    if (!changing || !resolve_body(call, *changing, body)) return;
    const FloatScope scope;
    remove(changing.engine(), *changing, handle_slot(body));
  });
}

int32_t carom_body_get(carom_world* world, carom_body body, carom_body_desc* desc, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && resolve_body(call, *reading, body) && fillable(call, 3, "desc", desc))
      write_struct(describe(*reading, handle_slot(body)), desc);
  });
}

int32_t carom_body_set_pose(carom_world* world, carom_body body, const double position[3], const double orientation[4],
                            carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_set_pose(body, position, orientation));
    if (!changing || !resolve_body(call, *changing, body) || !carom::abi::finite(call, 3, "position", position, 3) ||
        !unit(call, 4, "orientation", orientation, 4))
      return;
    const FloatScope scope;
    changing->set_pose(handle_slot(body), {to_quat(orientation), to_vec3(position)});
  });
}

int32_t carom_body_set_velocity(carom_world* world, carom_body body, const double linear[3], const double angular[3],
                                carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_set_velocity(body, linear, angular));
    if (!changing || !resolve_body(call, *changing, body) || !carom::abi::finite(call, 3, "linear", linear, 3) ||
        !carom::abi::finite(call, 4, "angular", angular, 3))
      return;
    const std::uint32_t slot = handle_slot(body);
    if (changing->scene.type[slot] == BodyType::fixed &&
        !(at_rest(call, 3, "linear", linear) && at_rest(call, 4, "angular", angular)))
      return;
    changing->set_velocity(slot, to_vec3(linear), to_vec3(angular));
  });
}

int32_t carom_body_is_asleep(carom_world* world, carom_body body, uint32_t* asleep, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && resolve_body(call, *reading, body) && present(call, 3, "asleep", asleep))
      *asleep = reading->asleep(handle_slot(body));
  });
}

int32_t carom_body_wake(carom_world* world, carom_body body, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_wake(body));
    if (changing && resolve_body(call, *changing, body)) changing->wake_body(handle_slot(body));
  });
}

int32_t carom_body_set_continuous(carom_world* world, carom_body body, uint32_t mode, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_set_continuous(body, mode));
    if (changing && resolve_body(call, *changing, body) && known(call, 3, "mode", mode, CAROM_CONTINUOUS_NEVER + 1))
      changing->set_continuous(handle_slot(body), static_cast<SweepMode>(mode));
  });
}

int32_t carom_body_get_continuous(carom_world* world, carom_body body, uint32_t* mode, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && resolve_body(call, *reading, body) && present(call, 3, "mode", mode))
      *mode = static_cast<std::uint32_t>(reading->scene.def[handle_slot(body)].continuous);
  });
}

int32_t carom_body_set_enabled(carom_world* world, carom_body body, uint32_t enabled, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_set_enabled(body, enabled));
    if (changing && resolve_body(call, *changing, body) && known(call, 3, "enabled", enabled, 2))
      changing->set_enabled(handle_slot(body), enabled != 0);
  });
}

int32_t carom_body_is_enabled(carom_world* world, carom_body body, uint32_t* enabled, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && resolve_body(call, *reading, body) && present(call, 3, "enabled", enabled))
      *enabled = !reading->state.is_disabled(handle_slot(body));
  });
}

int32_t carom_body_add_force(carom_world* world, carom_body body, const double force[3], const double torque[3],
                             carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_add_force(body, force, torque));
    if (!changing || !resolve_body(call, *changing, body) || !carom::abi::finite(call, 3, "force", force, 3) ||
        !carom::abi::finite(call, 4, "torque", torque, 3))
      return;
    if (!changing->add_force(handle_slot(body), to_vec3(force), to_vec3(torque)))
      call.fail(CAROM_E_OUT_OF_RANGE, larger_of(3, force, torque), "what was added up to now overflows with this");
  });
}

int32_t carom_body_add_impulse(carom_world* world, carom_body body, const double impulse[3], const double point[3],
                               carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_add_impulse(body, impulse, point));
    if (!changing || !resolve_body(call, *changing, body) || !carom::abi::finite(call, 3, "impulse", impulse, 3) ||
        !carom::abi::finite(call, 4, "point", point, 3))
      return;
    const FloatScope scope;
    if (!changing->add_impulse(handle_slot(body), to_vec3(impulse), to_vec3(point)))
      call.fail(CAROM_E_OUT_OF_RANGE, larger_of(3, impulse, point), "such an impulse makes a velocity that overflows");
  });
}

}  // extern "C"
