// Quarantine: bodies whose state left the finite world are stopped and held, and nobody else notices.
#include "dynamics/quarantine.h"

#include <algorithm>

#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {

void quarantine(World& world, std::uint32_t body) {
  State& s = world.state;
  s.v[body] = s.omega[body] = s.force[body] = s.torque[body] = Vec3::zero();
  if (s.quarantined[body]) return;
  s.quarantined[body] = 1;
  ++s.quarantined_count;
  ++world.scene.revision;
  ++world.scene.collider_revision;
  world.sleep->alarm = true;
  FaultView view;
  view.body = body;
  if (world.fault_views.size() < world.fault_views.capacity()) world.fault_views.push_back(view);
}

void admit(World& world, const StepTime&) {
  world.fault_views.clear();
  world.fault_views.reserve(world.scene.bodies.slots() + world.scene.colliders.slots() +
                            world.particles.slots.slots());  // no room is made while bodies move
  State& s = world.state;
  std::sort(s.written.begin(), s.written.end());  // so that nothing depends on the order of a host's calls
  for (const std::uint32_t i : s.written) {
    if (!world.scene.bodies.alive(i)) continue;
    if (world.scene.inv_mass[i] > 0 && !(world.scene.inv_inertia[i](0, 0) > 0)) s.omega[i].set_zero();  // cannot rotate
    const Real n2 = s.q[i].squared_norm();
    const bool placed = sane_position(s.x[i]) && n2 > 0.5 && n2 < 2;
    if (placed && sane_velocity(s, i) && sane_spin(s, i) && finite(s.force[i]) && finite(s.torque[i])) continue;
    for (Real& x : s.x[i].at) x = finite(x) ? std::clamp(x, -kMaxPosition, kMaxPosition) : 0;
    s.q[i] = normalized(s.q[i]);
    quarantine(world, i);
  }
}

}  // namespace carom::dynamics
