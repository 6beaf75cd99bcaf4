// Forces and torques that a host asked for, for one step: only bodies that it wrote to can have any.
#include "dynamics/force/force.h"

namespace carom::dynamics {

void user_force::find(const Scene& scene, const State& state, Participants& participants) {
  for (const std::uint32_t i : state.written)
    if (responds(scene, state, i) && state.force[i] != Vec3::zero()) participants.add(i);
}

void user_force::force(const Scene& scene, const State& state, const Participants& participants, const Motion&,
                       const Accelerate& out) {
  participants.each([&](std::uint32_t i) { out.v[i] += out.scale * scene.inv_mass[i] * state.force[i]; });
}

void user_torque::find(const Scene& scene, const State& state, Participants& participants) {
  for (const std::uint32_t i : state.written)
    if (responds(scene, state, i) && rotates(scene, i) && state.torque[i] != Vec3::zero()) participants.add(i);
}

void user_torque::force(const Scene& scene, const State& state, const Participants& participants, const Motion& at,
                        const Accelerate& out) {
  participants.each(
      [&](std::uint32_t i) { out.omega[i] += out.scale * angular_acceleration(scene, i, at.q[i], state.torque[i]); });
}

}  // namespace carom::dynamics
