// Splitting: the kinetic energy is cut into parts under each of which the body's motion is one turn, known in closed
// form.
//
//   T = |L|^2 / (2 I_x)  +  dy p_y^2 / 2  +  dz p_z^2 / 2,      p = q^-1 L,  dy = 1/I_y - 1/I_x,  dz = 1/I_z - 1/I_x
//
//   first part     q' = exp(h L / I_x) q        about L in the world. |L| is the same for every orientation, so this
//   part
//                                               commutes with the others and is done once, for a whole composition
//   other parts    q' = q exp(h dy p_y e_y)     about a principal axis; p turns the other way, p_y stays
//
// The two that do not commute are composed symmetrically: y(h/2) z(h) y(h/2), of second order, and such steps of g_1 h,
// ..., g_n h into one of fourth (Suzuki) or sixth (Yoshida). Every turn keeps L and is symplectic, hence so is the
// step: energy errs by a bounded amount for ever. A body with two equal moments has dy = 0 or dz = 0: its motion is
// exact at any h.
// @source [McLachlan1993], [Touma1994], [Hairer2006 §V.3.2, §VII.5]
#include <algorithm>
#include <cmath>

#include "dynamics/integrate/rotation/top.h"

namespace carom::dynamics {
namespace {

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
int parts_of(const Principal& top, Real step, const Vec3& p) {
  if (top.dy == 0 || top.dz == 0) return 1;
  const Real turn = std::fabs(step) * (std::fabs(top.dy) + std::fabs(top.dz)) * p.norm();  // rad, at most
  constexpr Real kMost = 1, kMostParts = 4096;  // beyond that a body turns by as much as no number tells
  return turn > kMost ? static_cast<int>(std::min(std::ceil(turn / kMost), kMostParts)) : 1;
}

template <std::size_t n>
void split(const World& world, Velocities& to, const Customers& customers, Real h, const Real (&g)[n]) {
  carry_tops(world, to, customers, h, [&g](const Principal& top, Real step, const Vec3& l, Vec3& p, Quat& q) {
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
  });
}

constexpr Real kOne[] = {1};
constexpr Real kFour = 0.41449077179437573714;  // 1/(4 - 4^(1/3))
constexpr Real kSuzuki4[] = {kFour, kFour, 1 - 4 * kFour, kFour, kFour};
constexpr Real kOuter = 0.78451361047755726382, kMiddle = 0.23557321335935813368, kBack = -1.17767998417887100695;
constexpr Real kYoshida6[] = {kOuter, kMiddle, kBack, 1 - 2 * (kOuter + kMiddle + kBack), kBack, kMiddle, kOuter};

}  // namespace

const Rotation kSplitting = {
    "splitting", [](const World& w, Velocities& to, const Customers& c, Real h) { split(w, to, c, h, kOne); }};
const Rotation kSplitting4 = {
    "splitting_4", [](const World& w, Velocities& to, const Customers& c, Real h) { split(w, to, c, h, kSuzuki4); }};
const Rotation kSplitting6 = {
    "splitting_6", [](const World& w, Velocities& to, const Customers& c, Real h) { split(w, to, c, h, kYoshida6); }};

}  // namespace carom::dynamics
