// Uniform gravity on every body that has mass, each by its factor.
#include "dynamics/force/force.h"

namespace carom::dynamics::gravity {

void find(const Scene& scene, const State& state, Participants& participants) {
  if (scene.gravity == Vec3::zero()) return;
  for (std::uint32_t i = 0; i < scene.bodies.slots(); ++i)
    if (responds(scene, state, i) && scene.gravity_factor_of(i) != 0) participants.add(i);
}

/// a = f g
void force(const Scene& scene, const State&, const Participants& participants, const Motion&, const Accelerate& out) {
  const Vec3 dv = out.scale * scene.gravity;
  if (scene.attributes.bodies(AttributeId::gravity_factor) == 0)
    return participants.each([&](std::uint32_t i) { out.v[i] += dv; });
  participants.each([&](std::uint32_t i) { out.v[i] += scene.gravity_factor_of(i) * dv; });
}

}  // namespace carom::dynamics::gravity
