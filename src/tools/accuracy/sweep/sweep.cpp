// Runs in the order of their cost: all settings of a scene at one step before any at half of it.
#include "accuracy/sweep/sweep.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

namespace carom::tools::accuracy {
namespace {

/// What a map asks of: a scene with one knob that goes up.
struct Map {
  const char *scene, *knob;
  std::vector<double> values;
  double seconds;  // simulated
};
const std::vector<Map>& maps() {
  static const std::vector<Map> list = {{"massratio1e2", "ratio", {1, 10, 1e2, 1e3, 1e4, 1e5, 1e6}, 10},
                                        {"stack10", "n", {2, 5, 10, 20, 40, 80}, 10}};
  return list;
}
/// Settings that maps are drawn for, besides every setting of other engines: one of each solver.
bool in_maps(const Entry& entry) {
  if (entry.mover) return true;
  for (const char* name : {kDefaultSetting, "auto, 1 substep", "direct, 1 substep", "soft_step, 4 substeps",
                           "severity, 4 substeps, to the end"})
    if (entry.setting == name) return true;
  return false;
}

class Clock {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count(); }

 private:
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

/// A row of runs of one entry on one scene, at ever finer steps.
struct Line {
  const Entry* entry;
  const Challenge* challenge;
  std::vector<std::pair<std::string, double>> knobs;
  double seconds = 0;   // simulated
  double expected = 0;  // s of the wall clock, of the next run
  bool stopped = false;
};

/// One scene, or one map: lines that share a budget.
struct Job {
  std::vector<Line> lines;
};

std::vector<Job> jobs_of(const SweepPlan& plan) {
  std::vector<Job> jobs;
  for (const Challenge* challenge : plan.scenes) {
    Job job;
    const SceneTraits traits = traits_of(*challenge);
    for (const Entry& entry : plan.entries)
      if (entry.takes_part(*challenge)) job.lines.push_back({&entry, challenge, {}, traits.seconds});
    if (!job.lines.empty()) jobs.push_back(std::move(job));
  }
  if (!plan.maps) return jobs;
  for (const Map& map : maps()) {
    const Challenge& challenge = find_challenge(map.scene);
    if (std::find(plan.scenes.begin(), plan.scenes.end(), &challenge) == plan.scenes.end()) continue;
    Job job;
    for (const Entry& entry : plan.entries)
      if (entry.takes_part(challenge) && in_maps(entry))
        for (const double value : map.values)
          job.lines.push_back({&entry, &challenge, {{map.knob, value}}, map.seconds});
    jobs.push_back(std::move(job));
  }
  return jobs;
}

Row row_of(const Line& line, double dt) {
  Row row;
  row.engine = line.entry->engine, row.setting = line.entry->setting;
  row.scene = line.challenge->scene.name, row.knobs = line.knobs, row.dt = dt;
  row.errors.assign(line.challenge->metrics.size(), std::numeric_limits<double>::infinity());
  row.left_out = true;
  return row;
}

/// Runs until the least time of a few is known: three where they are short.
Row measure(Engine& engine, const Line& line, double dt, double patience, const std::optional<Solution>& truth) {
  Row row = row_of(line, dt);
  Request request;
  request.dt = dt, request.seconds = line.seconds, request.patience = patience;
  request.dials = line.entry->dials, request.mover = line.entry->mover;
  request.settings.values = line.knobs;
  double computed = 0;
  for (int repeat = 0; repeat < 3 && (repeat == 0 || computed < 0.15); ++repeat) {
    const Result result = run(engine, *line.challenge, request, truth);
    row.left_out = result.given_up;
    row.errors = result.errors, row.fell_at = result.fell_at, row.simulated = result.simulated;
    const double cost = 1e-3 * result.ms_per_second;
    row.cost = repeat == 0 ? cost : std::min(row.cost, cost);
    computed += cost * result.simulated;
    if (row.left_out) break;
  }
  return row;
}

}  // namespace

std::vector<Entry> carom_entries() {
  std::vector<Entry> entries;
  for (const Setting& setting : carom_settings())
    entries.push_back({"Carom",
                       setting.name,
                       [matters_to = setting.matters_to](const Challenge& challenge) {
                         return (traits_of(challenge).has & matters_to) != 0;
                       },
                       setting.dials,
                       {}});
  return entries;
}

Sweep sweep(Engine& engine, const SweepPlan& plan, const std::function<void(const Progress&)>& tell) {
  Sweep found;
  found.machine = this_machine(), found.date = today();
  const Clock clock;
  std::vector<Job> jobs = jobs_of(plan);
  for (std::size_t j = 0; j < jobs.size(); ++j) {
    // What earlier scenes left over is for those that follow.
    const double share = (plan.seconds - clock.seconds()) / static_cast<double>(jobs.size() - j);
    const Clock spent;
    std::optional<Solution> truth;
    bool truth_known = false;
    for (std::size_t s = 0; s < plan.steps.size(); ++s)
      for (std::size_t l = 0; l < jobs[j].lines.size(); ++l) {
        Line& line = jobs[j].lines[l];
        const double dt = plan.steps[s], left = share - spent.seconds();
        line.stopped |= line.expected > left || left <= 0;
        if (line.stopped) {
          found.rows.push_back(row_of(line, dt));
          continue;
        }
        if (tell) {
          const double runs = static_cast<double>(s * jobs[j].lines.size() + l) /
                              static_cast<double>(plan.steps.size() * jobs[j].lines.size());
          char step[32];
          std::snprintf(step, sizeof step, "1/%.4g s", 1 / dt);
          tell({line.challenge->scene.name + ": " + line.entry->engine + ", " + line.entry->setting + ", " + step,
                (static_cast<double>(j) + runs) / static_cast<double>(jobs.size()),
                std::max(0.0, plan.seconds - clock.seconds())});
        }
        if (!truth_known && line.challenge->reference_dt > 0) {  // one for all: the library's own dials
          const Clock probe;
          run(engine, *line.challenge, Request{}, std::nullopt);
          truth_known = true;
          if (probe.seconds() / (60 * line.challenge->reference_dt) < left / 2)
            truth = own_truth(engine, *line.challenge, Request{});
        }
        if (truth_known && !truth) line.stopped = true;  // nothing to judge by
        if (line.stopped) {
          found.rows.push_back(row_of(line, dt));
          continue;
        }
        const Clock run_time;
        try {
          found.rows.push_back(measure(engine, line, dt, plan.most_per_run, truth));
        } catch (const Error& error) {
          if (error.code == CAROM_OK) throw;  // not the library's
          line.stopped = true;                // it refuses: joints under solver severity
          found.rows.push_back(row_of(line, dt));
          continue;
        }
        line.expected = 2.2 * run_time.seconds();  // half the step: twice the steps
        line.stopped |= found.rows.back().left_out;
      }
  }
  for (const Row& row : found.rows)
    if (std::none_of(found.engines.begin(), found.engines.end(),
                     [&](const EngineNote& e) { return e.name == row.engine; }))
      found.engines.push_back({row.engine, "", ""});
  for (EngineNote& e : found.engines)
    if (e.name == "Carom") {
      std::uint32_t major = 0, minor = 0, patch = 0;
      carom_version(&major, &minor, &patch);
      char text[32];
      std::snprintf(text, sizeof text, "%u.%u.%u", major, minor, patch);
      e.version = text, e.note = "double";
    }
  return found;
}

}  // namespace carom::tools::accuracy
