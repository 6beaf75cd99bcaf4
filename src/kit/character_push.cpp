// What a character does to bodies: forces on those that it met, and the body of its own that follows it.
#include "kit/bodies.h"
#include "kit/character.h"

namespace carom::kit {
namespace {

constexpr Real kTeleport = 1;  // m: a body of its own is not thrown any farther

}  // namespace

bool has_body(Call& call, int argument, carom_world* world, const carom_character_desc& desc) {
  carom_error inner = CAROM_ERROR_INIT;
  if (desc.body != CAROM_NULL_HANDLE) {
    std::uint32_t type = 0;
    return call.passed(carom_body_get_type(world, desc.body, &type, &inner), inner, argument);
  }
  double gravity[3];
  return call.passed(carom_world_get_gravity(world, gravity, &inner), inner, 1);
}

bool push(Call& call, carom_world* world, const carom_character_desc& desc, const carom_character& c, Real dt) {
  Forces<CAROM_CHARACTER_CONTACTS + 1> forces;  // and what it stands on
  for (std::uint32_t i = 0; i < c.contact_count; ++i) {
    Inertia body;
    if (c.contact_bodies[i] == CAROM_NULL_HANDLE) continue;
    if (!read_inertia(call, world, c.contact_bodies[i], 3, body)) return false;
    if (!body.dynamic) continue;
    const Vec3 point = Vec3::from(c.contact_points + 3 * i), along = -Vec3::from(c.contact_normals + 3 * i);
    const Real wanted = effective_mass(body, point, along) * c.contact_speeds[i] / dt;
    const Real force = smaller(wanted, desc.push_force);
    if (force > 0) forces.add(c.contact_bodies[i], force * along, (point - body.center).cross(force * along));
  }
  if (c.ground == CAROM_GROUND_FIRM && c.ground_body != CAROM_NULL_HANDLE && desc.mass * desc.gravity > 0) {
    Inertia body;
    if (!read_inertia(call, world, c.ground_body, 3, body)) return false;
    const Vec3 weight = (-desc.mass * desc.gravity) * Vec3::from(desc.up).normalized();
    if (body.dynamic) forces.add(c.ground_body, weight, (Vec3::from(c.ground_point) - body.center).cross(weight));
  }
  return forces.write(call, world, 3);
}

bool move_body(Call& call, carom_world* world, const carom_character_desc& desc, const carom_character& c, Real dt) {
  if (desc.body == CAROM_NULL_HANDLE)
    return call.fail(CAROM_E_INVALID_HANDLE, 2, "desc->body is none: nothing can follow");
  carom_error inner = CAROM_ERROR_INIT;
  std::uint32_t type = 0;
  double position[3], orientation[4];
  if (!call.passed(carom_body_get_type(world, desc.body, &type, &inner), inner, 2)) return false;
  if (type != CAROM_BODY_KINEMATIC) return call.fail(CAROM_E_OUT_OF_RANGE, 2, "desc->body is not kinematic");
  if (!call.passed(carom_body_get_pose(world, desc.body, position, orientation, &inner), inner, 2)) return false;
  const Vec3 way = Vec3::from(c.position) - Vec3::from(position);
  bool there = way.norm() <= kTeleport;
  for (int k = 0; k < 4; ++k) there = there && std::fabs(orientation[k] - c.orientation[k]) <= 1e-6;
  const Vec3 velocity = there ? way / dt : Vec3::zero(), none = Vec3::zero();
  return call.passed(carom_body_set_velocity(world, desc.body, velocity.data(), none.data(), &inner), inner, 2) &&
         (there || call.passed(carom_body_set_pose(world, desc.body, c.position, c.orientation, &inner), inner, 2));
}

}  // namespace carom::kit
