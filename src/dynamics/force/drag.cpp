// Drag of air, still or windy: F = -(k + c |u|) u, u the velocity of a body relative to the air. As a flow it is exact:
// the direction of u stays, and du/dt = -(a + b u) u, a = k/m, b = c/m, has
//   u(h) = u0 e^(-a h) / (1 + b u0 (1 - e^(-a h)) / a)
#include <algorithm>

#include "dynamics/force/force.h"

namespace carom::dynamics {
namespace {

/// (1 - e^-x) / x   @param x  x >= 0   @accuracy  16 eps relative
Real mean_decay(Real x) {
  if (x >= 0.125) return (1 - decay(x)) / x;
  // Taylor by Horner; the remainder x^10/11! is below 3e-17.
  Real s = 1;
  for (int n = 10; n >= 2; --n) s = 1 - x / n * s;
  return s;
}

bool meets_air(const Scene& scene, const State& state, std::uint32_t i) {
  return responds(scene, state, i) && scene.drag_of(i).any();
}

}  // namespace

Vec3 air_velocity(const Scene& scene, std::uint32_t body) {
  return scene.modes.forbids(+EffectId::wind, body) ? Vec3(Vec3::zero()) : scene.wind;
}

void wind::find(const Scene& scene, const State& state, Participants& participants) {
  if (scene.wind == Vec3::zero()) return;
  for (std::uint32_t i = 0; i < scene.attributes.bodies(AttributeId::drag); ++i)
    if (meets_air(scene, state, i) && !scene.modes.forbids(+EffectId::drag, i)) participants.add(i);
}

void drag::find(const Scene& scene, const State& state, Participants& participants) {
  for (std::uint32_t i = 0; i < scene.attributes.bodies(AttributeId::drag); ++i)
    if (meets_air(scene, state, i)) participants.add(i);
}

void drag::force(const Scene& scene, const State&, const Participants& participants, const Motion& at,
                 const Accelerate& out) {
  participants.each([&](std::uint32_t i) {
    const Drag d = scene.drag_of(i);
    const Vec3 u = at.v[i] - air_velocity(scene, i);
    out.v[i] -= out.scale * scene.inv_mass[i] * (d.linear + d.quadratic * u.norm()) * u;
  });
}

void drag::flow(const Scene& scene, const Participants& participants, Real h, const Quat*, Vec3* v, Vec3*) {
  participants.each([&](std::uint32_t i) {
    const Drag d = scene.drag_of(i);
    const Vec3 air = air_velocity(scene, i), u = v[i] - air;
    const Real a = d.linear * scene.inv_mass[i], b = d.quadratic * scene.inv_mass[i];
    v[i] = air + decay(a * h) / (1 + b * u.norm() * h * mean_decay(a * h)) * u;
  });
}

Real drag::rate(const Scene& scene, const State& state, std::uint32_t i) {
  const Drag d = scene.drag_of(i);
  const Real speed = (state.v[i] - air_velocity(scene, i)).norm();
  return scene.inv_mass[i] * (d.linear + 2 * d.quadratic * speed);
}

}  // namespace carom::dynamics
