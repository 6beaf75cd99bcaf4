// A step: the stages of the table (stages.cpp), in order, those of a substep as often as there are substeps.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <utility>

#include "core/ticks.h"
#include "dynamics/accuracy/accuracy.h"
#include "dynamics/contact/lone_rollers.h"
#include "dynamics/give_back.h"
#include "dynamics/joint/rattle/rattle.h"
#include "dynamics/joint/speeds.h"
#include "dynamics/observe.h"
#include "dynamics/solver/direct.h"
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

/// Runs a stage if it has participants, and records what it did and its time. In a small world clocks are much of a
/// step: two are read, and ticks tell what share of it each stage has.
class Runner {
 public:
  Runner(World& world, Real dt) : world_(world), dt_(dt) {}
  ~Runner() {
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    const double per_tick = seconds / static_cast<double>(std::max<std::uint64_t>(core::ticks() - first_, 1));
    world_.report.total_seconds = seconds;
    for (std::size_t s = 0; s < kStageCount; ++s)
      world_.report.stage_seconds[s] = per_tick * static_cast<double>(of_stage_[s]);
    for (std::size_t row = 0; row < kEffectCount; ++row)
      if (of_effect_[row] > 0) world_.plan->effects[row].seconds += per_tick * static_cast<double>(of_effect_[row]);
  }
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
    const std::uint64_t ticks = lap();
    of_stage_[s] += ticks;
    if (entry.effect < kEffectCount) of_effect_[entry.effect] += ticks;
    if (keeps_ledger(world_)) account(entry);
  }

  /// What went on since the last stage is none's.
  void begin_lap() { last_ = core::ticks(); }

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
    of_stage_[static_cast<std::size_t>(Stage::observe)] += lap();
  }
  /// Ticks since the last lap: a stage begins where the one before ended.
  std::uint64_t lap() {
    const std::uint64_t now = std::max(core::ticks(), last_);  // cores may be a little apart
    return now - std::exchange(last_, now);
  }

  World& world_;
  Real dt_;  // s
  Clock::time_point start_ = Clock::now();
  std::uint64_t first_ = core::ticks(), last_ = first_;
  std::array<std::uint64_t, kStageCount> of_stage_{};
  std::array<std::uint64_t, kEffectCount> of_effect_{};
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
  direct->forget();
  give_back(*this, impulses, pairs, mean_motion);
  Array<AxisRates> begun(memory);
  if (joints.measured > 0) measure_rates(*this, begun);
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
  if (joints.measured > 0) note_accelerations(*this, begun, dt, joints);
}

}  // namespace carom::dynamics
