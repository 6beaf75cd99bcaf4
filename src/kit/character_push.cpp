// What a character does to bodies: forces on those that it met, and the body of its own that follows it.
#include <carom/body_bulk.h>

#include "kit/character.h"
#include "kit/mover.h"

namespace carom::kit {
namespace {

constexpr std::uint32_t kMostPushed = CAROM_CHARACTER_CONTACTS + 1;  // and what it stands on
constexpr Real kTeleport = 1;                                        // m: a body of its own is not thrown any farther

/// Forces to be left on bodies, one entry a body.
struct Forces {
  struct Six {
    Vec3 force = Vec3::zero(), torque = Vec3::zero();  // N, N m about the centre of mass, world
  };
  carom_body bodies[kMostPushed];
  Six six[kMostPushed];
  std::uint32_t count = 0;

  void add(carom_body body, const Vec3& force, const Vec3& arm) {
    std::uint32_t i = 0;
    while (i < count && bodies[i] != body) ++i;
    if (i == count) bodies[count] = body, six[count++] = Six();
    six[i].force += force, six[i].torque += arm.cross(force);
  }
};

struct Inertia {
  bool dynamic = false;
  Real mass = 0;
  Vec3 center;   // m, world
  Mat3 inverse;  // 1/(kg m^2), world axes; zero: it does not rotate
};

bool read_inertia(Call& call, carom_world* world, carom_body body, Inertia& out) {
  out = Inertia();
  std::uint32_t type = 0;
  carom_error inner = CAROM_ERROR_INIT;
  const std::int32_t result = carom_body_get_type(world, body, &type, &inner);
  if (result == CAROM_E_STALE_HANDLE) return true;  // it is gone
  if (!call.passed(result, inner, 3)) return false;
  if (type != CAROM_BODY_DYNAMIC) return true;
  double position[3], orientation[4], center[3], inertia[9];
  if (!call.passed(carom_body_get_pose(world, body, position, orientation, &inner), inner, 3) ||
      !call.passed(carom_body_get_mass(world, body, &out.mass, center, inertia, &inner), inner, 3))
    return false;
  const Pose pose{quat_of(orientation), Vec3::from(position)};
  out.center = pose.apply(Vec3::from(center));
  const Mat3 local = Mat3::from_rows(inertia), r = pose.q.matrix();
  const Real size = local.determinant();
  out.inverse = size > 0 ? r * local.inverse() * r.transpose() : Mat3::zero();
  out.dynamic = true;
  return true;
}

/// kg: the mass that a body has for a push at a point along a direction.
Real effective_mass(const Inertia& body, const Vec3& point, const Vec3& direction) {
  const Vec3 turn = (point - body.center).cross(direction);
  return 1 / (1 / body.mass + turn.dot(body.inverse * turn));
}

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
  Forces forces;
  for (std::uint32_t i = 0; i < c.contact_count; ++i) {
    Inertia body;
    if (c.contact_bodies[i] == CAROM_NULL_HANDLE) continue;
    if (!read_inertia(call, world, c.contact_bodies[i], body)) return false;
    if (!body.dynamic) continue;
    const Vec3 point = Vec3::from(c.contact_points + 3 * i), along = -Vec3::from(c.contact_normals + 3 * i);
    const Real wanted = effective_mass(body, point, along) * c.contact_speeds[i] / dt;
    const Real force = smaller(wanted, desc.push_force);
    if (force > 0) forces.add(c.contact_bodies[i], force * along, point - body.center);
  }
  if (c.ground == CAROM_GROUND_FIRM && c.ground_body != CAROM_NULL_HANDLE && desc.mass * desc.gravity > 0) {
    Inertia body;
    if (!read_inertia(call, world, c.ground_body, body)) return false;
    const Vec3 weight = (-desc.mass * desc.gravity) * Vec3::from(desc.up).normalized();
    if (body.dynamic) forces.add(c.ground_body, weight, Vec3::from(c.ground_point) - body.center);
  }
  if (forces.count == 0) return true;
  // All at once, so that a failure leaves none.
  static_assert(sizeof(Forces::Six) == 6 * sizeof(double));
  Forces::Six pending[kMostPushed];
  carom_error inner = CAROM_ERROR_INIT;
  const auto n = static_cast<std::uint64_t>(forces.count);
  if (!call.passed(carom_world_read(world, CAROM_FIELD_FORCE, CAROM_SCALAR_F64, forces.bodies, n, pending, 0, &inner),
                   inner, 3))
    return false;
  for (std::uint32_t i = 0; i < forces.count; ++i)
    pending[i].force += forces.six[i].force, pending[i].torque += forces.six[i].torque;
  return call.passed(
      carom_world_write(world, CAROM_FIELD_FORCE, CAROM_SCALAR_F64, forces.bodies, n, pending, 0, &inner), inner, 3);
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
