// Which rotation method the dial names, and the call that integrators make.
#include "dynamics/integrate/rotation/rotation.h"

namespace carom::dynamics {

const Rotation* rotation_method(std::uint32_t choice) {
  static constexpr const Rotation* kMethods[] = {nullptr,       nullptr,     nullptr,      &kRotationRungeKutta4,
                                                 &kLieMidpoint, &kSplitting, &kSplitting4, &kSplitting6};
  return kMethods[choice];
}

void turn_tops(const World& world, Velocities& to, Real h) {
  Plan& plan = *world.plan;
  if (!plan.rotation_method) return;
  PlannedEffect& row = plan.effects[+EffectId::gyroscopic];
  if (row.participants.count == 0) return;
  plan.rotation_method->advance(world, to, row.participants, h);
  row.evaluations += row.participants.count;
}

}  // namespace carom::dynamics
