#include "dynamics/begin_substep.h"

#include "dynamics/ccd/continuous.h"
#include "dynamics/contact/impact.h"
#include "dynamics/contact/mean_motion.h"
#include "dynamics/integrate/driven.h"
#include "dynamics/joint/wide_joints.h"

namespace carom::dynamics {
namespace {

/// f(body), of those whose velocity before the forces somebody asks for; of some twice.
template <class F>
void each_asked(const World& world, F&& f) {
  for (const WideJoints::Kicked& k : world.wide_joints->kicked) f(k.body);
  for (const SweptBody& b : world.continuous->bodies) f(b.body);
  if (!world.mean_motion) return;
  for (const MeanMotion::Body& b : world.mean_motion->bodies) f(b.slot);
}

}  // namespace

void reserve_begun(const World& world, const StepTime&) {
  bool any = false;
  each_asked(world, [&](std::uint32_t) { any = true; });
  if (any) world.plan->begun.resize(world.scene.bodies.slots());
}

void begin_substep(const World& world, Velocities& to, const StepTime& time) {
  lead(world, to, time);
  const State& s = world.state;
  each_asked(world, [&](std::uint32_t i) { world.plan->begun[i] = {s.v[i], s.omega[i]}; });
  begin_paths(world);
  measure_approach(world);
}

}  // namespace carom::dynamics
