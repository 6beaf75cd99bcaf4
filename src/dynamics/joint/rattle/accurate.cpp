// Islands that joints alone hold, each with the substeps that its own error asks for: @see accuracy/README.md
#include <algorithm>

#include "dynamics/accuracy/accuracy.h"
#include "dynamics/accuracy/measure.h"
#include "dynamics/joint/rattle/rattle.h"
#include "dynamics/ledger/accounts.h"
#include "dynamics/ledger/ledger.h"

namespace carom::dynamics::rattle {
namespace {

using accuracy::BodyEnd;
using accuracy::Borne;
using accuracy::End;
using accuracy::Shares;
using accuracy::Trial;

constexpr int kFirstOrder = 4;  // of what has no memory yet

BodyEnd end_of(const RattleBody& b) { return {b.x, b.v, b.omega, b.q}; }

std::uint8_t number_of(const RattleIsland& island) {
  return accuracy::number_of(island.movers, 0, island.joints, true);
}

template <class F>
void each_moved(const RattleIsland& island, F&& f) {
  for (std::uint32_t i = island.body; i < island.body + island.movers; ++i) f(i);
}

/// A run of an island has ended.   @return what becomes of where it led
End judge(Rattle& r, const RattleIsland& island, Trial& trial, const Borne& borne) {
  Shares apart;
  bool went_well = island.is_moving;
  each_moved(island, [&](std::uint32_t i) {
    const BodyEnd end = end_of(r.bodies[i]);
    went_well &= accuracy::is_finite(end);
    if (trial.coarse > 0)
      add_apart(apart, r.coarse[i], end, r.bodies[i].inertia, r.bodies[i].inv_inertia, kAccuracyHorizon, borne);
  });
  if (!went_well) {  // finer steps help where a stage was too long, not where a limit was reached
    const int least = trial.run << island.halvings;
    if (island.halvings == 0 || least > borne.most / 2)
      trial.run = 0;
    else
      trial.raise_least(least);
    return End::dropped;
  }
  const End end = trial.end_run(true, apart);
  if (end == End::dropped) climb(trial);
  if (end == End::compared) each_moved(island, [&](std::uint32_t i) { r.coarse[i] = end_of(r.bodies[i]); });
  return end;
}

AccuracyMemory memory_of(const World& world, const Rattle& r, const RattleIsland& island) {
  AccuracyMemory memory;
  each_moved(island, [&](std::uint32_t i) {
    accuracy::join_memory(memory, world.state.accuracy[r.bodies[i].slot], i == island.body);
  });
  return memory;
}

}  // namespace

void try_accurately(const World& world, Rattle& r, Real dt, int least_order) {
  Accuracy& a = *world.accuracy;
  const Borne borne(world.scene.dials, dt);
  a.decided.reserve(world.scene.bodies.slots());
  r.coarse.resize(r.bodies.size());
  r.trials.assign(r.islands.size(), {});
  for (std::size_t k = 0; k < r.islands.size(); ++k)
    if (r.islands[k].is_held && !r.islands[k].is_met && r.islands[k].movers > 0) {
      const AccuracyMemory memory = memory_of(world, r, r.islands[k]);
      const int order = std::max<int>(least_order, memory.order > 0 ? memory.order : kFirstOrder);
      r.trials[k].begin(memory, number_of(r.islands[k]), order, 1, borne.most);
    }
  for (;;) {
    const Trial* next = nullptr;  // the fewest substeps, of the lowest order: with all that take the same
    for (const Trial& t : r.trials)
      if (t.run > 0 && (!next || t.run < next->run || (t.run == next->run && t.order < next->order))) next = &t;
    if (!next) break;
    const int run = next->run, order = next->order;
    for (std::size_t k = 0; k < r.islands.size(); ++k) {
      RattleIsland& island = r.islands[k];
      island.is_moving = island.was_tried = r.trials[k].run == run && r.trials[k].order == order;
      if (island.was_tried) island.halvings = 0;
    }
    move_tried(world, r, dt, run, order);
    for (std::size_t k = 0; k < r.islands.size(); ++k) {
      RattleIsland& island = r.islands[k];
      if (!island.was_tried) continue;
      island.went_well = judge(r, island, r.trials[k], borne) == End::accepted;
      if (island.went_well || !keeps_ledger(world)) continue;
      each_moved(island, [&](std::uint32_t i) { clear_kicks(ledger_of(world), r.bodies[i].slot); });
    }
  }
  for (std::size_t k = 0; k < r.islands.size(); ++k) {
    const RattleIsland& island = r.islands[k];
    if (!island.went_well) continue;
    AccuracyMemory memory = r.trials[k].memory_after(memory_of(world, r, island), number_of(island));
    choose_order(memory, r.trials[k], least_order);
    decide(a, r.trials[k], memory, AccuracyView::kByJointsAlone,
           [&](const auto& f) { each_moved(island, [&](std::uint32_t i) { f(r.bodies[i].slot); }); });
  }
}

}  // namespace carom::dynamics::rattle
