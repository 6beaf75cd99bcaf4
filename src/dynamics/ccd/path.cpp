// The rotation vector between two orientations.
#include "dynamics/ccd/path.h"

#include "core/wide_angle.h"

namespace carom::dynamics {

Vec3 rotation_vector(const Quat& turn, const Vec3& near) {
  constexpr Real kWhole = 6.28318530717958647693;
  const Real sign = turn.w() < 0 ? -1 : 1, s = turn.vec().norm(), c = sign * turn.w(), size = near.norm();
  // Of almost no turn the axis is that of the other: only whole turns are missing.
  const Vec3 axis = s > 1e-9 ? Vec3(sign / s * turn.vec()) : size > 0 ? Vec3(near / size) : Vec3(Vec3::unit_x());
  const Vec3 least = s > 1e-9 ? Vec3(2 * angle_of(s, c) * axis) : Vec3(2 * sign * turn.vec());
  return least + kWhole * std::floor((near - least).dot(axis) / kWhole + Real(0.5)) * axis;
}

Path path_to(const State& s, std::uint32_t body, Real h) {
  Path p{0, s.x[body] - h * s.v[body], s.q[body], Vec3::zero(), Vec3::zero()};
  if (s.omega[body] != Vec3::zero()) p.q = normalized(exp_map(-h * s.omega[body]) * p.q);
  return p;
}

}  // namespace carom::dynamics
