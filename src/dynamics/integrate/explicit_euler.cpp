// Explicit Euler (the paper's): the old velocity moves the body, forces kick the velocity.
#include "dynamics/integrate/integrator.h"
#include "dynamics/integrate/rotation/rotation.h"

namespace carom::dynamics {
namespace {

void velocity_by_explicit_euler(const World& world, Velocities& to, Real h) {
  const State& s = world.state;
  Plan& plan = *world.plan;
  plan.linear.each([&](std::uint32_t i) { plan.predicted.x[i] = s.x[i] + h * s.v[i]; });
  plan.rotating.each([&](std::uint32_t i) {
    plan.predicted.x[i] = s.x[i] + h * s.v[i];
    plan.predicted.q[i] = normalized(exp_map(h * s.omega[i]) * s.q[i]);
  });
  turn_tops(world, to, h);
  // In place: rows that read velocities come first in the table, so each reads those of the start of the substep.
  evaluate_forces(world, {s.x.data(), s.q.data(), s.v.data(), s.omega.data()}, {h, to.v.data(), to.omega.data()});
  evaluate_flows(world, to, h, s.q.data());
}

}  // namespace

const Integrator kExplicitEuler = {"explicit_euler", true, false, false, 1.5, 0, 0, velocity_by_explicit_euler};

}  // namespace carom::dynamics
