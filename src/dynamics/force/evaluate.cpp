// The work of forces and flows: each on its participants, at one state.
#include <chrono>

#include "dynamics/force/force.h"
#include "dynamics/ledger/ledger.h"

namespace carom::dynamics {
namespace {

using Clock = std::chrono::steady_clock;

/// Records what a row does for some of its participants, and its time if that is asked for.
template <class F>
void serve(const World& world, PlannedEffect& row, const Participants& whom, F&& work) {
  const auto start = world.times_effects ? Clock::now() : Clock::time_point();
  work();
  if (world.times_effects) row.seconds += std::chrono::duration<double>(Clock::now() - start).count();
  row.evaluations += whom.count;
  if (row.effect->force == drag::force) {
    PlannedEffect& wind = world.plan->effects[+EffectId::wind];
    if (whom.count == row.participants.count)
      wind.evaluations += wind.participants.count;
    else
      whom.each([&](std::uint32_t i) { wind.evaluations += wind.participants.has(i); });
  }
}

}  // namespace

bool is_constant_in_a_step(const Effect& e) {
  return e.id == EffectId::gravity || e.id == EffectId::user_force || e.id == EffectId::user_torque ||
         e.id == EffectId::gyroscopic;
}

bool only_constant_forces_act(const World& world, std::uint32_t body) {
  for (const PlannedEffect& row : world.plan->effects) {
    const Effect& e = *row.effect;
    if (row.wanted == 0) continue;  // forced, though the scene does not call for it: it does nothing
    if (e.stage == Stage::integrate && e.participants == ParticipantKind::bodies && !is_constant_in_a_step(e) &&
        row.participants.has(body))
      return false;
  }
  return !world.plan->sprung.has(body);
}

void evaluate_forces(const World& world, const Motion& given, const Accelerate& out) {
  Motion at = given;
  if (world.plan->reads_velocities && at.v == out.v) {
    Plan& plan = *world.plan;
    plan.readers.each([&](std::uint32_t i) { plan.read_v[i] = at.v[i], plan.read_omega[i] = at.omega[i]; });
    at.v = plan.read_v.data(), at.omega = plan.read_omega.data();
  }
  each_acting(*world.plan, [&](PlannedEffect& row) {
    if (row.served != Served::force || row.participants.count == 0) return;
    const Participants& whom = row.forced();
    if (whom.count == 0) return;
    const AccountForRow account(world, row, out.v, out.omega, out.share);
    serve(world, row, whom, [&] { row.effect->force(world.scene, world.state, whom, at, out); });
  });
}

Motion extrapolated(const World& world, const Vec3* x, const Quat* q) {
  Plan& plan = *world.plan;
  const State& s = world.state;
  if (!plan.reads_velocities) return {x, q, s.v.data(), s.omega.data()};
  plan.readers.each([&](std::uint32_t i) {
    plan.read_v[i] = 2 * s.v[i] - plan.read_v[i];
    plan.read_omega[i] = 2 * s.omega[i] - plan.read_omega[i];
  });
  return {x, q, plan.read_v.data(), plan.read_omega.data()};
}

void evaluate_flows(const World& world, Velocities& to, Real h, const Quat* q) {
  each_acting(*world.plan, [&](PlannedEffect& row) {
    if (row.participants.count == 0 || !(row.served == Served::flow || row.has_stiff())) return;
    const Participants& whom = row.served == Served::flow ? row.participants : row.decays->stiff;
    const AccountForRow account(world, row, to.v.data(), to.omega.data(), 1);
    serve(world, row, whom, [&] { row.effect->flow(world.scene, whom, h, q, to.v.data(), to.omega.data()); });
  });
}

}  // namespace carom::dynamics
