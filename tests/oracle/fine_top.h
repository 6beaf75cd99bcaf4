// Tops with torque, of which there is no closed form.
#pragma once

#include "core/pose.h"

namespace carom::test {

/// Fine Runge-Kutta of q' = omega q / 2, L' = torque(t, q), omega = q I^-1 q^-1 L.
/// @param moment  kg m^2, about the axes of a body that are those of the world at t = 0   @param n  steps
/// @return        the orientation at the end
template <class Torque>
Quat fine_top(const Vec3& moment, const Vec3& omega, Real seconds, int n, Torque&& torque) {
  struct Y {
    Quat q;
    Vec3 l;
  } y{Quat::identity(), moment.times(omega)};
  const auto rate = [&](Real t, const Y& at) {
    const Quat q = at.q.normalized();
    const Vec3 half = 0.5 * (q * (q.conjugate() * at.l).over(moment));
    const Quat dq = Quat(0, half.x(), half.y(), half.z()) * at.q;
    return Y{dq, torque(t, q)};
  };
  const auto plus = [](const Y& a, Real s, const Y& d) { return Y{a.q + s * d.q, a.l + s * d.l}; };
  const Real h = seconds / n;
  for (int i = 0; i < n; ++i) {
    const Real t = i * h;
    const Y k1 = rate(t, y), k2 = rate(t + h / 2, plus(y, h / 2, k1)), k3 = rate(t + h / 2, plus(y, h / 2, k2)),
            k4 = rate(t + h, plus(y, h, k3));
    y = plus(plus(plus(plus(y, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
  }
  return y.q.normalized();
}

}  // namespace carom::test
