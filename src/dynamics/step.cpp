// THE PAGE: what a step does, in order. Each line names the stage that its time is booked under and the room that does
// it.
#include <chrono>

#include "dynamics/ccd/continuous.h"
#include "dynamics/contact/impact.h"
#include "dynamics/contact/mean_motion.h"
#include "dynamics/contact/resistance.h"
#include "dynamics/contact/surface.h"
#include "dynamics/detect.h"
#include "dynamics/effects.h"
#include "dynamics/events/events.h"
#include "dynamics/integrate/free_flight.h"
#include "dynamics/integrate/integrator.h"
#include "dynamics/island.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/ledger/ledger.h"
#include "dynamics/observe.h"
#include "dynamics/particles/flight.h"
#include "dynamics/quarantine.h"
#include "dynamics/query/index.h"
#include "dynamics/sleep/sleep.h"
#include "dynamics/solver/solver.h"

namespace carom::dynamics {
namespace {

/// Runs a stage if it has customers, and books its time.
class Runner {
 public:
  Runner(World& world, Real dt) : world_(world), dt_(dt) {}
  ~Runner() { world_.report.total_seconds = seconds_since(start_); }
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  int substeps() const { return world_.plan->substeps; }  // once the plan is made

  /// @param effect  row of the table whose room this is, if it is one effect's
  void operator()(Stage stage, void (*room)(World&, const StepTime&), std::size_t effect = kEffectCount) const {
    const auto s = static_cast<std::size_t>(stage);
    if (stage != Stage::refresh && !world_.plan->runs[s]) return;
    const auto start = Clock::now();
    room(world_, {dt_, dt_ / substeps()});
    const double seconds = seconds_since(start);
    world_.report.stage_seconds[s] += seconds;
    if (effect < kEffectCount) world_.plan->effects[effect].seconds += seconds;
    if (keeps_books(world_)) book(room);
  }

 private:
  using Clock = std::chrono::steady_clock;
  /// What a room did, for who asked: after each room, so that none need know of it.
  void book(void (*room)(World&, const StepTime&)) const {
    const auto start = Clock::now();
    book_room(world_, room, {dt_, dt_ / substeps()});
    world_.report.stage_seconds[static_cast<std::size_t>(Stage::observe)] += seconds_since(start);
  }
  static double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  World& world_;
  Real dt_;  // s
  Clock::time_point start_ = Clock::now();
};

}  // namespace

void World::step(Real dt) {
  const Runner run(*this, dt);
  begin_report(*this);
  run(Stage::refresh, admit);
  run(Stage::refresh, refresh);
  run(Stage::refresh, wake_touched);
  run(Stage::broad, find_pairs, kCollisionRow);
  run(Stage::narrow, find_contacts, kCollisionRow);
  run(Stage::narrow, leave_to_sweep, kContinuousRow);
  run(Stage::group, make_rows);
  run(Stage::group, find_resistance);
  run(Stage::group, find_surfaces);
  run(Stage::group, link_joints);
  run(Stage::group, list_moved_bodies);
  run(Stage::group, find_groups);
  run(Stage::solve, begin_contacts);
  run(Stage::solve, begin_sweeps, kContinuousRow);
  run(Stage::observe, begin_events, kEventsRow);
  run(Stage::integrate, part_with_flyers);
  for (int k = 0; k < run.substeps(); ++k) {
    run(Stage::solve, note_starts);
    run(Stage::solve, measure_approach);
    run(Stage::solve, note_velocities);
    run(Stage::solve, note_velocities_of_groups);
    run(Stage::integrate, integrate_velocity);
    run(Stage::solve, note_forces);
    run(Stage::solve, answer_impacts, kRestitutionRow);
    run(Stage::solve, hold_moments, kRollingRow);
    run(Stage::solve, solve_velocities);
    run(Stage::integrate, integrate_position);
    run(Stage::relax, solve_positions);
    run(Stage::solve, resist, kRollingRow);
    run(Stage::solve, sweep, kContinuousRow);
  }
  run(Stage::solve, stop_strays);
  run(Stage::integrate, fly_free);
  run(Stage::integrate, fly, kParticlesRow);
  run(Stage::solve, end_contacts);
  run(Stage::solve, end_sweeps, kContinuousRow);
  run(Stage::observe, observe);
  run(Stage::observe, fall_asleep, kSleepRow);
  run(Stage::observe, end_events, kEventsRow);
  run(Stage::observe, note_who_moved);
}

}  // namespace carom::dynamics
