// Velocity Verlet: half a kick, a move, half a kick of the forces where the body arrives.
//
//   v+ = v0 + h/2 a(x0, v0),   x1 = x0 + h v+,   v1 = v+ + h/2 a(x1, 2 v+ - v0)
//
// The velocity of the second kick is that of the end to first order, so forces that read velocities keep the order too.
// Orientation and omega likewise, with the rotation method as the move. Flows are composed around it, half before and
// half after, so that the whole is symmetric and damping alone stays exact. Under a constant force x is exact at any h,
// since the parabola has no third derivative.   @source [Hairer2006 §I.1.4, §II.5]
#include "dynamics/integrate/integrator.h"
#include "dynamics/integrate/rotation/rotation.h"
#include "dynamics/integrate/turn_kernels.h"

namespace carom::dynamics {
namespace {

void velocity_by_verlet(const World& world, Velocities& end, Real h) {
  const State& s = world.state;
  Plan& plan = *world.plan;
  PredictedPose& to = plan.predicted;
  const Accelerate kick = {h / 2, end.v.data(), end.omega.data()};
  evaluate_flows(world, end, h / 2, s.q.data());
  evaluate_forces(world, {s.x.data(), s.q.data(), s.v.data(), s.omega.data()}, kick);

  const auto move = [&](std::uint32_t i) { to.x[i] = s.x[i] + h * s.v[i]; };
  plan.linear.each(world.jobs, move);
  const bool carries = plan.rotation_method != nullptr;
  const auto turns = [&](std::uint32_t i) {
    if (!carries || !plan.turns_by_method[i]) return true;
    move(i);
    return false;
  };
  const Motions motions = motions_of(world, to.x, to.q);
  const auto in_lanes = turn_kernels().move;
  plan.rotating.each_four(world.jobs, turns, [&](const std::uint32_t* body, std::uint32_t count) {
    if (count == 4 && in_lanes(motions, body, h)) return;
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t i = body[k];
      move(i), to.q[i] = normalized(exp_map(h * s.omega[i]) * s.q[i]);
    }
  });
  turn_tops(world, end, h);

  evaluate_forces(world, extrapolated(world, to.x.data(), to.q.data()), kick);
  evaluate_flows(world, end, h / 2, to.q.data());
}

}  // namespace

const Integrator kVelocityVerlet = {"velocity_verlet", true, false, true, 1, 0, 0, velocity_by_verlet};

}  // namespace carom::dynamics
