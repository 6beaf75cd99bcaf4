#include "dynamics/force/trial.h"

#include <bit>

#include "dynamics/force/force.h"

namespace carom::dynamics {
namespace {

static_assert(kEffectCount <= 64, "rows are bits");

/// Whether where a spring's other end is does not depend on when it is asked.
bool stands(const World& world, std::uint32_t body) {
  if (body == kInvalid || world.scene.type[body] == BodyType::fixed || world.state.held_out[body]) return true;
  return world.scene.type[body] == BodyType::kinematic && world.state.v[body].is_zero() &&
         world.state.omega[body].is_zero();
}

/// m/(N s^2): what a newton of a spring accelerates its anchor by, at most.
Real mobility_of(const World& world, const SpringDef& def, std::uint32_t body) {
  const Vec3 arm = (def.body_a == body ? def.anchor_a : def.anchor_b) - world.scene.center[body];
  return world.scene.inv_mass[body] + arm.squared_norm() * world.scene.inv_inertia[body].trace();
}

}  // namespace

bool is_asked_at_trials(const Effect& effect) {
  return effect.force && effect.stage == Stage::integrate && effect.id != EffectId::gyroscopic;
}

bool find_varying(const World& world, std::uint32_t body, Trial& trial, ForcesOnOne& to) {
  to = {};
  to.body = body, to.spring = static_cast<std::uint32_t>(trial.springs.size());
  for (std::size_t row = 0; row < kEffectCount; ++row) {
    const PlannedEffect& planned = world.plan->effects[row];
    const Effect& effect = *planned.effect;
    if (planned.wanted == 0 || planned.participants.count == 0) continue;
    if (!is_asked_at_trials(effect) || is_constant_in_a_step(effect)) continue;
    if (effect.participants != ParticipantKind::bodies || !planned.participants.has(body)) continue;
    to.rows |= std::uint64_t(1) << row;
    if (effect.rate) to.rate += effect.rate(world.scene, world.state, body);
  }
  if (world.plan->sprung.has(body)) {
    bool all_stand = true;
    Real swing = 0;  // 1/s^2
    world.plan->effects[+EffectId::springs].participants.each([&](std::uint32_t k) {
      const SpringDef& def = world.scene.springs.def[k];
      if (!def.hangs_on(body)) return;
      all_stand = all_stand && (def.body_a == body || stands(world, def.body_a)) &&
                  (def.body_b == body || stands(world, def.body_b));
      trial.springs.push_back(k);
      const Real most = mobility_of(world, def, body);
      swing += most * world.scene.springs.stiffness[k], to.rate += most * world.scene.springs.damping[k];
    });
    if (!all_stand) return false;
    to.rate += std::sqrt(swing);
    to.springs = static_cast<std::uint32_t>(trial.springs.size()) - to.spring;
  }
  if (to) {
    trial.resize(world.scene.bodies.slots());
    trial.own.runs.reserve(1), trial.hanging.runs.reserve(to.springs);
  }
  return true;
}

void ForcesOnOne::add(const World& world, Trial& trial, const Vec3& x, const Quat& q, const Vec3& v, const Vec3& omega,
                      Vec3& accel, Vec3& alpha) const {
  if (!*this) return;
  trial.x[body] = x, trial.q[body] = q, trial.v[body] = v, trial.omega[body] = omega;
  trial.accel[body] = trial.alpha[body] = Vec3::zero();
  trial.own.clear(), trial.own.add(body);
  for (std::uint64_t left = rows; left != 0; left &= left - 1) {
    const Effect& effect = *world.plan->effects[static_cast<std::size_t>(std::countr_zero(left))].effect;
    effect.force(world.scene, world.state, trial.own, trial.at(), trial.to(1));
  }
  if (springs > 0) {
    trial.hanging.clear();
    for (std::uint32_t k = spring; k < spring + springs; ++k) trial.hanging.add(trial.springs[k]);
    world.plan->effects[+EffectId::springs].effect->force(world.scene, world.state, trial.hanging, trial.at(),
                                                          trial.to(1));
  }
  accel += trial.accel[body], alpha += trial.alpha[body];
}

}  // namespace carom::dynamics
