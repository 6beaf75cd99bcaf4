// The two integration stages of the page: one kick, one move, with a stop for what left the finite world.
#include "dynamics/integrate/integrator.h"

#include "dynamics/quarantine.h"

namespace carom {

void integrate_velocity(World& world, const StepTime& time) {
  Plan& plan = *world.plan;
  plan.integrator->velocity(world, time.h);
  // Before any contact reads them, so that one body's infinity does not become its neighbours'.
  plan.linear.each([&](std::uint32_t i) {
    if (!sane_velocity(world.state, i)) quarantine(world, i);
  });
  plan.rotating.each([&](std::uint32_t i) {
    if (!sane_velocity(world.state, i) || !sane_spin(world.state, i)) quarantine(world, i);
  });
}

void integrate_position(World& world, const StepTime& time) {
  State& s = world.state;
  Plan& plan = *world.plan;
  const Real h = time.h;

  const auto place = [&](std::uint32_t i, const Vec3& x) {
    if (sane_position(x))
      s.x[i] = x;
    else
      quarantine(world, i);  // stays at its last good place
  };
  const auto move = [&](std::uint32_t i) { place(i, s.x[i] + h * s.v[i]); };
  const auto spin = [&](std::uint32_t i) { s.q[i] = normalized(exp_map(h * s.omega[i]) * s.q[i]); };
  const auto turn = [&](std::uint32_t i) {
    if (s.quarantined[i]) return;
    s.q[i] = plan.proposal.q[i];
    if (plan.touched[i]) s.q[i] = normalized(exp_map(h * (s.omega[i] - plan.proposal.omega[i])) * s.q[i]);
  };
  const bool carries = plan.rotation_method != nullptr;
  const auto orient = [&](std::uint32_t i) { (carries && plan.carried[i]) ? turn(i) : spin(i); };

  if (!plan.integrator->proposes) {
    plan.linear.each(move);
    plan.rotating.each([&](std::uint32_t i) { move(i), orient(i); });
  } else {
    const auto free = [&](std::uint32_t i) { return !plan.touched[i] && !s.quarantined[i]; };
    plan.linear.each([&](std::uint32_t i) { free(i) ? place(i, plan.proposal.x[i]) : move(i); });
    plan.rotating.each([&](std::uint32_t i) {
      if (free(i))
        place(i, plan.proposal.x[i]), s.q[i] = plan.proposal.q[i];
      else
        move(i), orient(i);
    });
  }
  plan.kinematic.each([&](std::uint32_t i) { move(i), spin(i); });
}

}  // namespace carom
