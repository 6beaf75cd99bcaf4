// Linear and angular damping: dv/dt = -c v, as a force or, exactly, as a decay over h.
#include <cmath>

#include "dynamics/force/force.h"

namespace carom::dynamics {

Real decay(Real x) {
  if (!(x < 700)) return 0;
  constexpr Real kLn2High = 6.93147180369123816490e-01;  // first 33 bits of ln 2: k * high is exact for k < 2^20
  constexpr Real kLn2Low = 1.90821492927058770002e-10;
  const Real k = std::floor(x * 1.44269504088896338700 + Real(0.5));
  const Real r = (x - k * kLn2High) - k * kLn2Low;  // |r| <= ln(2)/2
  // Taylor of e^-r by Horner; the remainder r^14/14! is below 5e-18 on this interval.
  Real s = 1;
  for (int n = 13; n >= 1; --n) s = 1 - r / n * s;
  return std::ldexp(s, -static_cast<int>(k));
}

namespace linear_damping {

void find(const Scene& scene, const State& state, Participants& participants) {
  for (std::uint32_t i = 0; i < scene.bodies.slots(); ++i)
    if (responds(scene, state, i) && scene.def[i].linear_damping > 0) participants.add(i);
}

void force(const Scene& scene, const State&, const Participants& participants, const Motion& at,
           const Accelerate& out) {
  participants.each([&](std::uint32_t i) { out.v[i] -= out.scale * scene.def[i].linear_damping * at.v[i]; });
}

void flow(const Scene& scene, const Participants& participants, Real h, const Quat*, Vec3* v, Vec3*) {
  participants.each([&](std::uint32_t i) { v[i] *= decay(h * scene.def[i].linear_damping); });
}

Real rate(const Scene& scene, const State&, std::uint32_t i) { return scene.def[i].linear_damping; }

}  // namespace linear_damping

namespace angular_damping {

void find(const Scene& scene, const State& state, Participants& participants) {
  for (std::uint32_t i = 0; i < scene.bodies.slots(); ++i)
    if (responds(scene, state, i) && rotates(scene, i) && scene.def[i].angular_damping > 0) participants.add(i);
}

void force(const Scene& scene, const State&, const Participants& participants, const Motion& at,
           const Accelerate& out) {
  participants.each([&](std::uint32_t i) { out.omega[i] -= out.scale * scene.def[i].angular_damping * at.omega[i]; });
}

void flow(const Scene& scene, const Participants& participants, Real h, const Quat*, Vec3*, Vec3* omega) {
  participants.each([&](std::uint32_t i) { omega[i] *= decay(h * scene.def[i].angular_damping); });
}

Real rate(const Scene& scene, const State&, std::uint32_t i) { return scene.def[i].angular_damping; }

}  // namespace angular_damping
}  // namespace carom::dynamics
