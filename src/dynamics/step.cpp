// A step: the stages of the table (stages.cpp), in order, those of a substep as often as there are substeps.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <utility>

#include "dynamics/accuracy/accuracy.h"
#include "dynamics/contact/lone_rollers.h"
#include "dynamics/give_back.h"
#include "dynamics/joint/rattle/rattle.h"
#include "dynamics/observe.h"
#include "dynamics/stages.h"

namespace carom::dynamics {
namespace {

/// What throws leaves the step as it began.
struct Undo {
  const World& world;
  Passing to;
  bool is_done = false;
  ~Undo() {
    if (!is_done) accuracy::drop_passes(world, to);
  }
};

/// Runs a stage if it has participants, and records what it did and its time.
class Runner {
 public:
  Runner(World& world, Real dt) : world_(world), dt_(dt) {}
  ~Runner() { world_.report.total_seconds = std::chrono::duration<double>(Clock::now() - start_).count(); }
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  int substeps() const { return world_.plan->substeps; }  // once the plan is made

  void operator()(const StageEntry& entry) {
    const auto s = static_cast<std::size_t>(entry.stage);
    if (entry.stage != Stage::refresh && !world_.plan->runs[s]) return;
    if (world_.watches_stages)
      watch(entry);
    else
      entry.run(world_, {dt_, dt_ / substeps()});
    const double seconds = lap();
    world_.report.stage_seconds[s] += seconds;
    if (entry.effect < kEffectCount) world_.plan->effects[entry.effect].seconds += seconds;
    if (keeps_ledger(world_)) account(entry);
  }

  /// What went on since the last stage is none's.
  void begin_lap() { last_ = Clock::now(); }

  /// Substeps by island: as many passes as islands ask for, each with its own.
  void by_island(std::span<const StageEntry> table);

 private:
  using Clock = std::chrono::steady_clock;

  /// A stage that writes what it was not given is a bug of ours.
  void watch(const StageEntry& entry) const {
    const Parts undeclared = run_watched(entry, world_, {dt_, dt_ / substeps()});
    for (std::size_t i = 0; i < kPartCount; ++i)
      if (undeclared.has(static_cast<Part>(i)))
        std::fprintf(stderr, "carom: stage '%.*s' writes %s; its function was not given that\n",
                     static_cast<int>(entry.name.size()), entry.name.data(), part_name(static_cast<Part>(i)));
    if (undeclared.bits) std::abort();
  }
  void account(const StageEntry& entry) {
    account_stage(world_, entry.account, {dt_, dt_ / substeps()});
    world_.report.stage_seconds[static_cast<std::size_t>(Stage::observe)] += lap();
  }
  /// s, since the last lap. A stage begins where the one before ended: in small worlds clocks are much of a step's time.
  double lap() {
    const Clock::time_point now = Clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

  World& world_;
  Real dt_;  // s
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

void Runner::by_island(std::span<const StageEntry> table) {
  const auto substep = [](const StageEntry& e) { return e.each_substep; };
  const auto first = std::ranges::find_if(table, substep), last = std::find_if_not(first, table.end(), substep);
  const auto in_pass = [&](auto from, auto to) {
    for (auto entry = from; entry != to; ++entry)
      if (entry->by_island != ByIsland::no) (*this)(*entry);
  };
  const StepTime time{dt_, dt_ / substeps()};
  Undo undo{world_, Passing(world_)};
  accuracy::plan_passes(world_, time);
  while (accuracy::begin_pass(world_, world_.scene.springs, world_.scene.water, undo.to, time)) {
    begin_lap();
    in_pass(table.begin(), first);
    for (int k = 0; k < substeps(); ++k)
      for (auto entry = first; entry != last; ++entry) (*this)(*entry);
    in_pass(last, table.end());
    accuracy::end_pass(world_, undo.to, time);
  }
  accuracy::end_passes(world_, undo.to, *world_.events, time);
  undo.is_done = true;
}

}  // namespace

void World::step(Real dt) {
  accuracy::begin(*this, accuracy);
  if (!rattle && rattle::is_asked(*this)) rattle = make_owned<Rattle>(memory, memory);
  if (!lone_rollers && scene.colliders.live.size() > 1) lone_rollers = make_owned<LoneRollers>(memory, memory);
  Runner run(*this, dt);
  begin_report(*this, report, group_views, *events);
  give_back(*this, impulses, pairs, mean_motion);
  run.begin_lap();
  const std::span<const StageEntry> table = stage_table();
  for (auto first = table.begin(); first != table.end();) {
    auto last = first;
    while (last != table.end() && last->each_substep == first->each_substep) ++last;
    const bool by_island = first->each_substep && !plan->idle && accuracy::goes_by_island(*this);
    if (by_island) run.by_island(table);
    const int times = !first->each_substep ? 1 : plan->idle || by_island ? 0 : run.substeps();
    for (int k = 0; k < times; ++k)
      for (auto entry = first; entry != last; ++entry)
        if (entry->by_island != ByIsland::alone || !accuracy::goes_by_island(*this)) run(*entry);
    first = last;
  }
}

}  // namespace carom::dynamics
