// Quarantine: bodies whose state left the finite world are stopped and held, and no other body notices.
#include "dynamics/quarantine.h"

#include <algorithm>

#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {

void quarantine(Quarantining to, std::uint32_t body) {
  Velocities& motion = to;
  HostForces& host = to;
  Quarantine& held = to;
  Revisions& scene = to;
  motion.v[body] = motion.omega[body] = motion.momentum[body] = Vec3::zero();
  host.force[body] = host.torque[body] = Vec3::zero();
  if (held.is_lost(body)) return;
  held.held_out[body] |= Quarantine::kNotFinite;
  ++held.quarantined_count;
  ++scene.revision;
  ++scene.collider_revision;
  scene.alarm = true;
  FaultView view;
  view.body = body;
  FaultViews& views = to;
  if (views.size() < views.capacity()) views.push_back(view);
}

void admit(const World& world, Poses& poses, Quarantining to, const StepTime&) {
  FaultViews& views = to;
  views.clear();
  views.reserve(world.scene.bodies.slots() + world.scene.colliders.slots() +
                world.particles.slots.slots());  // nothing is reserved while bodies move
  HostForces& host = to;
  Velocities& motion = to;
  const State& s = world.state;
  std::sort(host.written.begin(), host.written.end());  // so that nothing depends on the order of a host's calls
  for (const std::uint32_t i : s.written) {
    if (!world.scene.bodies.alive(i)) continue;
    if (world.scene.inv_mass[i] > 0 && !(world.scene.inv_inertia[i](0, 0) > 0))
      motion.omega[i].set_zero();  // cannot rotate
    const Real n2 = s.q[i].squared_norm();
    const bool placed = sane_position(s.x[i]) && n2 > 0.5 && n2 < 2;
    if (placed && sane_velocity(s, i) && sane_spin(s, i) && finite(s.force[i]) && finite(s.torque[i])) continue;
    for (Real& x : poses.x[i].at) x = finite(x) ? std::clamp(x, -kMaxPosition, kMaxPosition) : 0;
    poses.q[i] = normalized(s.q[i]);
    quarantine(to, i);
  }
}

}  // namespace carom::dynamics
