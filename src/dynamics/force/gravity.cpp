// Uniform gravity on every body that has mass.
#include "dynamics/force/force.h"

namespace carom::gravity {

void find(const Scene& scene, const State& state, Customers& customers) {
  if (scene.gravity == Vec3::Zero()) return;
  for (std::uint32_t i = 0; i < scene.bodies.slots(); ++i)
    if (responds(scene, state, i)) customers.add(i);
}

/// a = g
void force(const Scene& scene, const State&, const Customers& customers, const Motion&, const Accelerate& out) {
  const Vec3 dv = out.scale * scene.gravity;
  customers.each([&](std::uint32_t i) { out.v[i] += dv; });
}

}  // namespace carom::gravity
