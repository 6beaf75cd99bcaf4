// What the kit reads of bodies, and the forces that it leaves on them.
#pragma once

#include <carom/body_bulk.h>

#include "core/pose.h"
#include "kit/check.h"

namespace carom::kit {

inline Quat quat_of(const double q[4]) { return Quat(q[3], q[0], q[1], q[2]).normalized(); }
/// Of a handle whose body was destroyed: it is passed over, where a handle of something else is a fault of the host's.
inline bool is_gone(std::int32_t result) { return result == CAROM_E_STALE_HANDLE; }

/// How a body moves; at rest where it is gone, or none.
struct BodyMotion {
  Vec3 linear = Vec3::zero(), angular = Vec3::zero();  // m/s of its centre of mass, rad/s, world
  Vec3 center = Vec3::zero();                          // m, world; read only where it turns

  Vec3 at(const Vec3& point) const { return angular.is_zero() ? linear : linear + angular.cross(point - center); }
};
bool read_motion(Call& call, carom_world* world, carom_body body, BodyMotion& motion);
/// The velocity of a body at a point.   @return false after a failure
bool velocity_at(Call& call, carom_world* world, carom_body body, const Vec3& point, Vec3& velocity);

struct Inertia {
  bool dynamic = false;
  Real mass = 0;                // kg
  Vec3 center = Vec3::zero();   // m, world
  Mat3 inverse = Mat3::zero();  // 1/(kg m^2), world axes; zero: it does not rotate
};
/// Of a body that is not dynamic, or gone, nothing but that.   @param argument  of ours, that its handle stands in
bool read_inertia(Call& call, carom_world* world, carom_body body, int argument, Inertia& out);

/// kg: the mass that a body has for a push at a point along a direction.
Real effective_mass(const Inertia& body, const Vec3& point, const Vec3& direction);

/// N, N m about the centre of mass, world: as CAROM_FIELD_FORCE.
struct Six {
  Vec3 force = Vec3::zero(), torque = Vec3::zero();
};
static_assert(sizeof(Six) == 6 * sizeof(double));

/// Add to what is pending, of all bodies in one call, so that a failure leaves nothing.
bool add_forces(Call& call, carom_world* world, int argument, const carom_body* bodies, const Six* six, Six* pending,
                std::uint32_t n);

/// Forces to be left on at most Most bodies, one entry a body.
template <std::uint32_t Most>
struct Forces {
  carom_body bodies[Most];
  Six six[Most];
  std::uint32_t count = 0;

  void add(carom_body body, const Vec3& force, const Vec3& torque) {
    std::uint32_t i = 0;
    while (i < count && bodies[i] != body) ++i;
    if (i == count) bodies[count] = body, six[count++] = Six();
    six[i].force += force, six[i].torque += torque;
  }
  bool write(Call& call, carom_world* world, int argument) const {
    Six pending[Most];
    return add_forces(call, world, argument, bodies, six, pending, count);
  }
};

}  // namespace carom::kit
