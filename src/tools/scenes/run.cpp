// Runs a stage and measures it by the library's own step reports.
#include "scenes/run.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::tools {

RunSummary simulate(Stage& stage, Observer* observer, double seconds, double dt,
                    const std::function<bool(const carom_step_report&)>& each) {
  if (!(seconds > 0 && seconds <= 1e6))
    throw Error("a run cannot last that long", "give --seconds, more than 0 and at most 1e6");
  if (!(dt >= 1e-9 && dt <= 1)) throw Error("the time step must be in [1e-9, 1] s", "give --dt, e.g. 0.016667");
  RunSummary run;
  const auto steps = static_cast<std::uint64_t>(std::max(1.0, std::ceil(seconds / dt - 1e-6)));
  double fastest = std::numeric_limits<double>::infinity(), slowest = 0;
  for (run.steps = 0; run.steps < steps;) {
    stage.world.step(dt);
    ++run.steps;
    run.last = stage.world.report();
    run.total_seconds += run.last.total_seconds;
    run.stage_seconds.resize(run.last.stage_count);
    for (std::uint32_t i = 0; i < run.last.stage_count; ++i) run.stage_seconds[i] += run.last.stage_seconds[i];
    fastest = std::min(fastest, run.last.total_seconds);
    slowest = std::max(slowest, run.last.total_seconds);
    run.most_contact_points = std::max(run.most_contact_points, run.last.contact_points);
    run.worst_penetration = std::max(run.worst_penetration, run.last.max_penetration);
    run.wedged_groups += run.last.wedged_groups, run.rejected_solutions += run.last.rejected_solutions;
    if (run.last.faults && run.faults == 0) run.first_faults = stage.world.faults();
    run.faults += run.last.faults;
    if (observer) observer->watch(stage, run.last.time);
    if (each && !each(run.last)) break;
  }
  run.simulated = run.last.time;
  const double tick = 1e-9;  // s: a step faster than the clock resolves
  run.min_rate = 1 / std::max(slowest, tick);
  run.max_rate = 1 / std::max(fastest, tick);
  run.average_rate = static_cast<double>(run.steps) / std::max(run.total_seconds, tick);
  run.hash = stage.world.hash();
  return run;
}

std::vector<KindSummary> where_it_ended(const Stage& stage) {
  std::vector<double> positions, velocities;
  stage.read(CAROM_FIELD_POSITION, positions);
  stage.read(CAROM_FIELD_LINEAR_VELOCITY, velocities);
  std::vector<KindSummary> rows;
  for (std::size_t i = 0; i < stage.actors.size(); ++i) {
    const Actor& actor = stage.actors[i];
    if (actor.type != CAROM_BODY_DYNAMIC) continue;
    auto row = std::find_if(rows.begin(), rows.end(), [&](const KindSummary& r) { return r.kind == actor.kind; });
    if (row == rows.end()) {
      row = rows.insert(rows.end(), KindSummary());
      row->kind = actor.kind;
      row->low = std::numeric_limits<double>::infinity();
      row->high = -row->low;
    }
    ++row->count;
    const Vec p(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
    const Vec v(velocities[3 * i], velocities[3 * i + 1], velocities[3 * i + 2]);
    if (!p.allFinite() || !v.allFinite()) {
      ++row->not_finite;
      continue;
    }
    row->moving += v.norm() > 0.05;
    row->fastest = std::max(row->fastest, v.norm());
    row->escaped += (p.array() < stage.bounds_min.array()).any() || (p.array() > stage.bounds_max.array()).any();
    row->low = std::min(row->low, p.y());
    row->high = std::max(row->high, p.y());
    row->mean += p.y();
  }
  for (KindSummary& row : rows) row.mean /= static_cast<double>(std::max<std::size_t>(1, row.count - row.not_finite));
  return rows;
}

}  // namespace carom::tools
