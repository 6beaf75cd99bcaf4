// What a step comes to: penetration, energies, counts.
#include "dynamics/observe.h"

#include <algorithm>
#include <utility>

#include "dynamics/contact/contact.h"
#include "dynamics/contact_views.h"
#include "dynamics/events/events.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {
namespace {

void measure_contacts(const World& world, StepReport& report) {
  const Contacts& c = *world.contacts;
  each_block(world, [&](Contacts::Block& block, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Row& row = c.rows[i];
      const Real separation = c.geometry[i].separation;
      if (leaves_impulse(world, row)) ++block.loaded;
      if (!(separation < 0)) continue;
      ++block.overlapping;
      block.depth = std::max(block.depth, -separation);
      block.sum_of_depths -= separation;
      block.closing = std::max(block.closing, -row.u.dot(row.n));
    }
  });
  double sum = 0;
  std::uint64_t overlapping = 0;
  for (const Contacts::Block& block : c.blocks) {
    report.max_penetration = std::max<double>(report.max_penetration, block.depth);
    report.max_closing_speed = std::max<double>(report.max_closing_speed, block.closing);
    sum += block.sum_of_depths;
    overlapping += block.overlapping;
  }
  if (overlapping) report.mean_penetration = sum / static_cast<double>(overlapping);
}

void measure_energy(const World& world, StepReport& report) {
  const Scene& scene = world.scene;
  const State& s = world.state;
  const Plan& plan = *world.plan;
  const auto linear = [&](std::uint32_t i) { report.linear_energy += 0.5 * scene.mass[i] * s.v[i].squared_norm(); };
  plan.linear.each(linear);
  plan.rotating.each([&](std::uint32_t i) {
    linear(i);
    const Vec3 w = s.q[i].conjugate() * s.omega[i];
    report.angular_energy += 0.5 * w.dot(scene.inertia[i] * w);
  });
  report.linear_energy += world.particles.linear_energy();
  report.dynamic_bodies = plan.linear.count + plan.rotating.count + world.sleep->count;
}

/// What effects without a stage of their own did: they are served within the loops of their stages.
void account_served(const World& world) {
  Plan& plan = *world.plan;
  const auto account = [&](std::size_t row, Stage stage, std::uint64_t times) {
    PlannedEffect& effect = plan.effects[row];
    if (plan.runs[static_cast<std::size_t>(stage)]) effect.evaluations += times * effect.participants.count;
  };
  const auto substeps = static_cast<std::uint64_t>(plan.substeps);
  for (const std::size_t row : {+EffectId::friction, +EffectId::restitution, +EffectId::rolling_resistance,
                                +EffectId::spinning_resistance, +EffectId::surface_velocity, +EffectId::response,
                                +EffectId::joints, +EffectId::joint_limits, +EffectId::joint_motors})
    account(row, Stage::solve, substeps);
  for (const std::size_t row : {+EffectId::collision, +EffectId::filter, +EffectId::sensor, +EffectId::scenery})
    account(row, Stage::broad, 1);
}

/// A force lives for one step.
void drop_forces(HostForces& s) {
  for (const std::uint32_t i : s.written) {
    s.force[i] = s.torque[i] = Vec3::zero();
    s.is_written[i] = 0;
  }
  s.written.clear();
}

}  // namespace

void begin_report(const World& world, StepReport& report, GroupViews& groups, Events& events) {
  const std::uint64_t steps = report.steps;
  const double time = report.time;
  report = StepReport{};
  report.steps = steps;
  report.time = time;
  world.views->clear();
  groups.clear();
  events.clear();
}

void observe(const World& world, StepReport& report, HostForces& host, Impulses& impulses, Sleep& sleep,
             const StepTime& time) {
  if (world.plan->runs[static_cast<std::size_t>(Stage::solve)]) {
    measure_contacts(world, report);
    world.views->expect();
    remember_impulses(world, impulses, time.h);
  }
  measure_energy(world, report);
  account_served(world);
  if (world.plan->host_wrote) drop_forces(host);
  report.steps += 1;
  report.time += time.dt;
  report.bodies = world.scene.bodies.alive_count();
  report.colliders = world.scene.colliders.live.size();
  report.quarantined_bodies = world.state.quarantined_count;
  report.particles = world.particles.count();
  report.quarantined_particles = world.particles.held_count();
  report.faults = world.fault_views.size();
  report.asleep_bodies = world.sleep->count;
  report.woke_up = std::exchange(sleep.woke, 0);
}

}  // namespace carom::dynamics
