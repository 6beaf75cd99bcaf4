// Semi-implicit (symplectic) Euler: forces kick the velocity, the new velocity moves the body.
#include "dynamics/integrate/integrator.h"
#include "dynamics/integrate/rotation/rotation.h"

namespace carom::dynamics {
namespace {

void velocity_by_semi_implicit_euler(const World& world, Velocities& to, Real h) {
  const State& s = world.state;
  evaluate_forces(world, {s.x.data(), s.q.data(), s.v.data(), s.omega.data()}, {h, to.v.data(), to.omega.data()});
  evaluate_flows(world, to, h, s.q.data());
  turn_tops(world, to, h);
}

}  // namespace

const Integrator kSemiImplicitEuler = {"semi_implicit_euler",          false, false, false, 0.5, 0, 0,
                                       velocity_by_semi_implicit_euler};

}  // namespace carom::dynamics
