// A free top turned by splitting, and the symmetric compositions that raise a step of second order to fourth and sixth.
// How the kinetic energy is cut: splitting.cpp.
#pragma once

#include <algorithm>
#include <cmath>

#include "dynamics/integrate/rotation/top.h"

namespace carom::dynamics {

/// Turn about the body's axis y by angle: q becomes q exp(angle e_y), and p is seen from the turned axes. Inlined, so
/// that q and p stay in registers.
[[gnu::always_inline]] inline void turn_y(Real angle, Quat& q, Vec3& p) {
  const Turn t = turn_by(angle);
  const Real c = t.half_cos, s = t.half_sin;
  q = Quat(q.w() * c - q.y() * s, q.x() * c - q.z() * s, q.y() * c + q.w() * s, q.z() * c + q.x() * s);
  p = Vec3(t.cos * p.x() - t.sin * p.z(), p.y(), t.sin * p.x() + t.cos * p.z());
}
[[gnu::always_inline]] inline void turn_z(Real angle, Quat& q, Vec3& p) {
  const Turn t = turn_by(angle);
  const Real c = t.half_cos, s = t.half_sin;
  q = Quat(q.w() * c - q.z() * s, q.x() * c + q.y() * s, q.y() * c - q.x() * s, q.z() * c + q.w() * s);
  p = Vec3(t.cos * p.x() + t.sin * p.y(), t.cos * p.y() - t.sin * p.x(), p.z());
}

/// Into how many parts a step is cut: turns that do not commute are small, or energy errs by tens of percents. Where
/// one of them is nothing the other is exact.
/// @param p  kg m^2/s, momentum
inline int parts_of(const Principal& top, Real step, const Vec3& p) {
  if (top.dy == 0 || top.dz == 0) return 1;
  const Real turn = std::fabs(step) * (std::fabs(top.dy) + std::fabs(top.dz)) * p.norm();  // rad, at most
  constexpr Real kMost = 1, kMostCuts = 4096;  // beyond that a body turns by as much as no number tells
  return turn > kMost ? static_cast<int>(std::min(std::ceil(turn / kMost), kMostCuts)) : 1;
}

/// A top over one step, composed of steps of g_1, ..., g_n of it.
/// @param l  kg m^2/s, world   @param p  the same in principal axes, at the start; then at the end
/// @param q  unit, principal axes -> world; then of any length
template <std::size_t n>
void turn_split(const Principal& top, Real step, const Vec3& l, Vec3& p, Quat& q, const Real (&g)[n]) {
  q = unscaled_exp(step * top.base * l) * q;
  const int parts = parts_of(top, step, p);
  const Real y = step / parts * top.dy, z = step / parts * top.dz;
  for (int i = 0; i < parts; ++i) {
    turn_y(y * (g[0] / 2) * p.y(), q, p);
    for (std::size_t k = 0; k < n; ++k) {
      turn_z(z * g[k] * p.z(), q, p);
      const Real next = k + 1 < n ? g[k + 1] : 0;  // the last turn of a step and the first of the next are one
      turn_y(y * ((g[k] + next) / 2) * p.y(), q, p);
    }
  }
}

/// Shares of a step. @source [Hairer2006 §II.4, §V.3.2]: Suzuki, Yoshida
inline constexpr Real kOne[] = {1};
inline constexpr Real kFour = 0.41449077179437573714;  // 1/(4 - 4^(1/3))
inline constexpr Real kSuzuki4[] = {kFour, kFour, 1 - 4 * kFour, kFour, kFour};
inline constexpr Real kOuter = 0.78451361047755726382, kMiddle = 0.23557321335935813368,
                      kBack = -1.17767998417887100695;
inline constexpr Real kYoshida6[] = {kOuter, kMiddle, kBack, 1 - 2 * (kOuter + kMiddle + kBack),
                                     kBack,  kMiddle, kOuter};

}  // namespace carom::dynamics
