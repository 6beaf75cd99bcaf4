// What a body is and has, one thing a call: pose, velocity, kind, mass, damping, the host's number, colliders.
#include <carom/body.h>

#include "abi/body.h"
#include "abi/collider.h"
#include "abi/ends.h"
#include "core/float_scope.h"
#include "abi/record_calls.h"
#include "dynamics/mass.h"
#include "dynamics/quarantine.h"

namespace carom::abi {
namespace {

/// A joint or a spring needs one body that is dynamic: whether those of a body have one where it is none.
bool ties_keep_one(Call& call, const World& world, std::uint32_t body) {
  bool kept = true;
  world.joints.each_of(body, [&](std::uint32_t, std::uint32_t other) { kept &= is_dynamic(world, other); });
  const auto& springs = world.scene.springs;
  for (std::uint32_t i = 0; i < springs.slots.slots(); ++i) {
    if (!springs.slots.alive(i)) continue;
    const auto& def = springs.def[i];
    if (def.body_a == body || def.body_b == body)
      kept &= is_dynamic(world, def.body_a == body ? def.body_b : def.body_a);
  }
  return kept || call.fail(CAROM_E_OUT_OF_RANGE, 3,
                           "a joint or a spring holds this body and none that is dynamic: destroy it first");
}

/// Whether a body may be of a kind with the shapes that it has.   @param has_mass  the host gives it
bool shapes_fit(Call& call, const World& world, std::uint32_t body, BodyType type, bool has_mass) {
  const Colliders& c = world.scene.colliders;
  for (std::uint32_t i = world.scene.first_collider[body]; i != kInvalid; i = c.next[i])
    if (!shape_fits(call, 3, type, has_mass, *c.shape[i], c.density[i])) return false;
  return true;
}

bool read_mass(Call& call, double mass, const double* center, const double* inertia, MassGiven& given) {
  if (!in_range(call, 3, "mass", mass, 0, kInfinity)) return false;
  if (mass == 0 && (center || inertia))
    return call.fail(CAROM_E_OUT_OF_RANGE, 3,
                     "mass is 0, which asks for that of the colliders: center and inertia must be NULL");
  if (mass != 0 && mass < kLeastMass)
    return call.fail(CAROM_E_OUT_OF_RANGE, 3, "mass is %g; it must be 0 or at least %g", mass, kLeastMass);
  if ((center && !vector_in_range(call, 4, "center", center, kMaxPosition)) ||
      (inertia && !check_inertia(call, 5, "inertia", inertia)))
    return false;
  given.mass = mass;
  given.has_center = center, given.has_inertia = inertia;
  if (center) given.center = to_vec3(center);
  if (inertia) given.inertia = symmetric(inertia);
  return true;
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_body_get_pose(carom_world* world, carom_body body, double position[3], double orientation[4],
                            carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve_body(call, *reading, body)) return;
    const Pose pose = reading->pose(handle_slot(body));
    if (position) from_vec3(pose.p, position);
    if (orientation) from_quat(pose.q, orientation);
  });
}

int32_t carom_body_get_velocity(carom_world* world, carom_body body, double linear[3], double angular[3],
                                carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve_body(call, *reading, body)) return;
    if (linear) from_vec3(reading->state.v[handle_slot(body)], linear);
    if (angular) from_vec3(reading->state.omega[handle_slot(body)], angular);
  });
}

int32_t carom_body_set_mass(carom_world* world, carom_body body, double mass, const double center[3],
                            const double inertia[9], carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_set_mass(body, mass, center, inertia));
    MassGiven given;
    if (!changing || !resolve_body(call, *changing, body) || !read_mass(call, mass, center, inertia, given)) return;
    const std::uint32_t slot = handle_slot(body);
    if (changing->scene.type[slot] != BodyType::dynamic) {
      call.fail(CAROM_E_OUT_OF_RANGE, 2, "the body is not dynamic: its mass is infinite");
      return;
    }
    if (!shapes_fit(call, *changing, slot, BodyType::dynamic, mass > 0)) return;
    const FloatScope scope;
    changing->set_mass(slot, given);
  });
}

int32_t carom_body_get_mass(carom_world* world, carom_body body, double* mass, double center[3], double inertia[9],
                            carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve_body(call, *reading, body)) return;
    const dynamics::Scene& scene = reading->scene;
    const std::uint32_t slot = handle_slot(body);
    if (mass) *mass = scene.mass[slot];
    if (center) from_vec3(scene.center[slot], center);
    for (int i = 0; inertia && i < 9; ++i) inertia[i] = scene.inertia[slot](i / 3, i % 3);
  });
}

int32_t carom_body_set_type(carom_world* world, carom_body body, uint32_t type, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_set_type(body, type));
    if (!changing || !resolve_body(call, *changing, body) || !known(call, 3, "type", type, CAROM_BODY_DYNAMIC + 1))
      return;
    const std::uint32_t slot = handle_slot(body);
    const auto to = static_cast<BodyType>(type);
    if (!shapes_fit(call, *changing, slot, to, changing->scene.def[slot].has_mass) ||
        (to != BodyType::dynamic && !ties_keep_one(call, *changing, slot)))
      return;
    const FloatScope scope;
    changing->set_type(slot, to);
  });
}

int32_t carom_body_get_type(carom_world* world, carom_body body, uint32_t* type, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && resolve_body(call, *reading, body) && present(call, 3, "type", type))
      *type = static_cast<std::uint32_t>(reading->scene.type[handle_slot(body)]);
  });
}

int32_t carom_body_set_damping(carom_world* world, carom_body body, double linear, double angular, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_set_damping(body, linear, angular));
    if (changing && resolve_body(call, *changing, body) && in_range(call, 3, "linear", linear, 0, kLargestDamping) &&
        in_range(call, 4, "angular", angular, 0, kLargestDamping))
      changing->set_damping(handle_slot(body), linear, angular);
  });
}

int32_t carom_body_get_damping(carom_world* world, carom_body body, double* linear, double* angular,
                               carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve_body(call, *reading, body)) return;
    const BodySettings& def = reading->scene.def[handle_slot(body)];
    if (linear) *linear = def.linear_damping;
    if (angular) *angular = def.angular_damping;
  });
}

int32_t carom_body_set_user(carom_world* world, carom_body body, uint64_t user, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::body_set_user(body, user));
    if (changing && resolve_body(call, *changing, body)) changing->scene.def[handle_slot(body)].user = user;
  });
}

int32_t carom_body_get_user(carom_world* world, carom_body body, uint64_t* user, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && resolve_body(call, *reading, body) && present(call, 3, "user", user))
      *user = reading->scene.def[handle_slot(body)].user;
  });
}

int32_t carom_body_get_colliders(carom_world* world, carom_body body, carom_collider* colliders, uint64_t capacity,
                                 uint64_t* count, carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !resolve_body(call, *reading, body) || !present(call, 5, "count", count)) return;
    const Colliders& c = reading->scene.colliders;
    *count = 0;
    for (std::uint32_t i = reading->scene.first_collider[handle_slot(body)]; i != kInvalid; i = c.next[i]) {
      if (colliders && *count < capacity) colliders[*count] = reading->scene.collider_slots.handle(i);
      ++*count;
    }
  });
}

}  // extern "C"
