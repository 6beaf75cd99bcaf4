// Broad and narrow phase on the world's colliders, and what becomes of shapes that misbehave.
#include "dynamics/detect.h"

#include <algorithm>

#include "dynamics/events/events.h"
#include "dynamics/filter.h"
#include "dynamics/scenery.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {

BroadPhase& broad_phase(const World& world, BroadPhases& all) {
  using Make = Owned<BroadPhase> (*)(Memory*);
  static constexpr Make kMake[] = {make_brute_force, make_sweep_and_prune, make_uniform_grid, make_tree};
  const std::uint32_t choice = world.scene.dials.choice(Dial::broad_phase);
  if (!all[choice]) all[choice] = kMake[choice](world.memory);
  return *all[choice];
}

void disable(const World& world, Revisions& scene, FaultViews& views, const SupportFault& fault) {
  Plan& plan = *world.plan;
  if (std::find(plan.faulty.begin(), plan.faulty.end(), fault.shape) != plan.faulty.end()) return;
  plan.faulty.push_back(fault.shape);
  const Colliders& c = world.scene.colliders;
  FaultView view{};
  view.support = fault;
  for (const std::uint32_t slot : c.live)
    if (c.shape[slot] == fault.shape) {
      view.body = c.body[slot];
      break;
    }
  views.push_back(view);
  ++scene.revision, ++scene.collider_revision;
  scene.alarm = true;
}

namespace {

constexpr Real kUsualSteps = 60;         // 1/s: finer steps ask for finer distances
constexpr Real kLeastTolerance = 1e-14;  // the dial's least

/// The pairs of movers and sleepers among those of the broad phase; both ascending, merged from behind.
void add_near(const Array<Pair>& near, Array<Pair>& pairs) {
  std::size_t i = pairs.size(), k = near.size(), to = i + k;
  pairs.resize(to);
  while (k > 0) pairs[--to] = i > 0 && near[k - 1] < pairs[i - 1] ? pairs[--i] : near[--k];
}

}  // namespace

NarrowSettings narrow_settings(const Dials& dials) {
  NarrowSettings s;
  s.query.simplex = static_cast<Simplex>(dials.choice(Dial::simplex));
  s.query.method = static_cast<Method>(dials.choice(Dial::narrow_phase));
  s.query.routines = dials.choice(Dial::pair_routines) != 0;
  s.query.tolerance = dials[Dial::gjk_tolerance];
  s.query.margin = dials[Dial::hybrid_margin];
  s.query.max_distance = dials[Dial::contact_distance];
  s.query.gjk_cap = dials.whole(Dial::gjk_iterations);
  s.query.epa_cap = dials.whole(Dial::epa_iterations);
  s.manifold.kind = static_cast<ManifoldKind>(dials.choice(Dial::manifold));
  s.manifold.cache_distance = dials[Dial::cache_distance];
  s.manifold.keep_distance = dials[Dial::keep_distance];
  s.manifold.contact_distance = dials[Dial::contact_distance];
  s.warm_separation = dials.choice(Dial::warm_separation) != 0;
  s.carry_over = dials[Dial::carry_over];
  return s;
}

NarrowSettings narrow_settings(const Dials& dials, Real dt) {
  NarrowSettings s = narrow_settings(dials);
  // What gravity does to a gap in a step is as the square of it. Half of the digits are the normal's.
  const Real fine = std::min(Real(1), kUsualSteps * dt);
  s.query.tolerance = std::max(fine * fine * s.query.tolerance, std::min(s.query.tolerance, kLeastTolerance));
  return s;
}

void find_manifold(const PatchPair& pair, const NarrowSettings& settings, QueryMemory& memory, Manifold& manifold,
                   NarrowReport& report, SupportFault& fault) {
  Candidates found;
  collide(pair.a, pair.frame_a, pair.b, pair.frame_b, settings, memory, nullptr, found, report, fault);
  PatchMemory patch;
  if (fault.kind != SupportFault::none || found.count == 0) return;
  if (found.whole)
    adopt_patch(pair, found, settings.manifold, manifold, patch);
  else
    update_patch(pair, found, settings.manifold, manifold, patch, report.support_calls, fault);
}

void find_pairs(const World& world, BroadPhases& broad, ClearingSleepers to, Events& events, StepReport& report,
                const StepTime&) {
  PairTable& pairs = to;
  Sleep& sleep = to;
  BroadSettings settings;
  settings.grid_cell = world.scene.dials[Dial::grid_cell];
  settings.jobs = world.jobs;
  try {
    Plan& plan = *world.plan;
    broad_phase(world, broad).find_pairs(world.scene.colliders, world.scene.collider_revision, settings, plan.pairs);
    add_near(world.sleep->near, plan.pairs);
    drop_filtered(world, plan.pairs);
    set_sensors_aside(world, events, plan.pairs);
    pairs.update(plan.pairs, world.jobs);
    for (const std::uint32_t collider : sleep.rejoined) pairs.release(collider);
    sleep.rejoined.clear();
  } catch (...) {
    // Out of memory: forget what may be half changed; the next step starts these caches afresh.
    for (auto& b : broad) b.reset();
    pairs.clear();
    clear_sleepers(world, to);
    throw;
  }
  report.broad_pairs = world.plan->pairs.size();
}

void find_contacts(const World& world, PairTable& pairs, Revisions& scene, FaultViews& views, StepReport& report,
                   const StepTime& time) {
  Plan& plan = *world.plan;
  const NarrowSettings settings = narrow_settings(world.scene.dials, time.dt);
  meet_scenery(world, pairs, report.narrow, settings);
  narrow_phase(world.scene.colliders, settings, pairs, report.narrow, plan.faults, world.jobs);
  for (const SupportFault& fault : plan.faults) disable(world, scene, views, fault);
}

}  // namespace carom::dynamics
