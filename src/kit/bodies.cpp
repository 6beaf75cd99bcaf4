// What the kit reads of bodies, and the forces that it leaves on them.
#include "kit/bodies.h"

namespace carom::kit {

bool read_motion(Call& call, carom_world* world, carom_body body, BodyMotion& motion) {
  motion = BodyMotion();
  if (body == CAROM_NULL_HANDLE) return true;
  carom_error inner = CAROM_ERROR_INIT;
  const std::int32_t result = carom_body_get_velocity(world, body, motion.linear.data(), motion.angular.data(), &inner);
  if (is_gone(result)) return true;
  return call.passed(result, inner, 0) &&
         (motion.angular.is_zero() || call.passed(carom_world_read(world, CAROM_FIELD_CENTER, CAROM_SCALAR_F64, &body,
                                                                   1, motion.center.data(), 0, &inner),
                                                  inner, 0));
}

bool velocity_at(Call& call, carom_world* world, carom_body body, const Vec3& point, Vec3& velocity) {
  BodyMotion motion;
  if (!read_motion(call, world, body, motion)) return false;
  velocity = motion.at(point);
  return true;
}

bool read_inertia(Call& call, carom_world* world, carom_body body, int argument, Inertia& out) {
  out = Inertia();
  std::uint32_t type = 0;
  carom_error inner = CAROM_ERROR_INIT;
  const std::int32_t result = carom_body_get_type(world, body, &type, &inner);
  if (is_gone(result)) return true;
  if (!call.passed(result, inner, argument)) return false;
  if (type != CAROM_BODY_DYNAMIC) return true;
  double position[3], orientation[4], center[3], inertia[9];
  if (!call.passed(carom_body_get_pose(world, body, position, orientation, &inner), inner, argument) ||
      !call.passed(carom_body_get_mass(world, body, &out.mass, center, inertia, &inner), inner, argument))
    return false;
  const Pose pose{quat_of(orientation), Vec3::from(position)};
  out.center = pose.apply(Vec3::from(center));
  const Mat3 local = Mat3::from_rows(inertia), r = pose.q.matrix();
  const Real size = local.determinant();
  out.inverse = size > 0 ? r * local.inverse() * r.transpose() : Mat3::zero();
  out.dynamic = true;
  return true;
}

Real effective_mass(const Inertia& body, const Vec3& point, const Vec3& direction) {
  const Vec3 turn = (point - body.center).cross(direction);
  return 1 / (1 / body.mass + turn.dot(body.inverse * turn));
}

bool add_forces(Call& call, carom_world* world, int argument, const carom_body* bodies, const Six* six, Six* pending,
                std::uint32_t n) {
  if (n == 0) return true;
  carom_error inner = CAROM_ERROR_INIT;
  if (!call.passed(carom_world_read(world, CAROM_FIELD_FORCE, CAROM_SCALAR_F64, bodies, n, pending, 0, &inner), inner,
                   argument))
    return false;
  for (std::uint32_t i = 0; i < n; ++i) {
    pending[i].force += six[i].force, pending[i].torque += six[i].torque;
    if (!pending[i].force.all_finite() || !pending[i].torque.all_finite())
      return call.fail(CAROM_E_OUT_OF_RANGE, argument, "the forces on a body are too large for numbers");
  }
  return call.passed(carom_world_write(world, CAROM_FIELD_FORCE, CAROM_SCALAR_F64, bodies, n, pending, 0, &inner),
                     inner, argument);
}

}  // namespace carom::kit
