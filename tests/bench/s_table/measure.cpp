// Engines take turns, repeat by repeat; each step counts with its least CPU time, so that a busy machine makes none
// slower.
#include "measure.h"

#include <time.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <optional>

namespace carom::bench {
namespace {

/// Where a long run is: a line that rewrites itself on a terminal, a line now and then in a log.
class Progress {
 public:
  explicit Progress(std::string what) : what_(std::move(what)), terminal_(isatty(STDERR_FILENO)) {}
  ~Progress() {
    if (terminal_ && shown_) std::fprintf(stderr, "\r%*s\r", 78, "");
  }
  void at(std::size_t step, std::size_t steps) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::seconds(terminal_ ? 1 : 20)) return;
    last_ = now;
    shown_ = true;
    std::fprintf(stderr, terminal_ ? "\r  %-60s step %zu of %zu " : "%s: step %zu of %zu\n", what_.c_str(), step,
                 steps);
  }

 private:
  std::string what_;
  bool terminal_, shown_ = false;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// The judge's last word and the worst there was.
void look(Record& record, const Judge& judge, const Plan& plan, const PeerWorld& world, std::size_t step) {
  std::vector<BodyState> states(plan.members().size());
  world.read(states.data());
  if (!record.is_carom) plan.to_body_frames(states);
  const double time = static_cast<double>(step) * kDt;
  record.end = judge.judge(states, time);
  record.peak_penetration = std::max(record.peak_penetration, record.end.max_penetration);
  record.peak_gap = std::max(record.peak_gap, record.end.max_gap);
  record.mean_gap += (record.end.mean_gap - record.mean_gap) / static_cast<double>(++record.looks);
  if (record.end.standing.fallen && record.fell_by < 0) record.fell_by = time;
  record.contact_points = world.contact_points();
}

/// Step one world to the end; the judge looks on outside the clock, in the last repeat only.
void drive(Record& record, PeerWorld& world, const Judge& judge, const Plan& plan, const Options& options, int repeat,
           const std::string& row) {
  Progress progress(row + ", " + record.engine + ", repeat " + std::to_string(repeat + 1) + " of " +
                    std::to_string(options.repeats));
  const bool last = repeat + 1 == options.repeats;
  // A run that the budget cut short is as long in every repeat.
  const std::size_t steps = record.best.empty() ? record.planned : record.best.size();
  double spent = 0;
  for (std::size_t i = 0; i < steps; ++i) {
    const double start = seconds_now(options.threads);
    world.step(kDt);
    const double took = seconds_now(options.threads) - start;
    spent += took;
    const bool cut = repeat == 0 && spent > options.budget;
    if (repeat == 0)
      record.best.push_back(took);
    else
      record.best[i] = std::min(record.best[i], took);
    if (last && record.is_carom) {
      const carom_step_report report = static_cast<const CaromWorld&>(world).report();
      record.stages.resize(report.stage_count);
      for (std::uint32_t k = 0; k < report.stage_count; ++k) record.stages[k] += report.stage_seconds[k];
    }
    if (last && (i % 10 == 9 || i + 1 == steps || cut)) look(record, judge, plan, world, i + 1);
    if (cut) break;
    progress.at(i + 1, steps);
  }
}

/// A stage that is never stepped: what the other engines and the judge are told.
struct Described {
  tools::Stage stage;
  std::optional<Plan> plan;
  Described(tools::Engine& engine, const SceneChoice& choice) : stage(engine) {
    tools::build(find_scene(choice.scene), choice.settings, stage);
    plan.emplace(stage);
  }
};

SceneChoice with_n(SceneChoice choice, double n) {
  for (auto& [name, value] : choice.settings.values)
    if (name == "n") value = n;
  return choice;
}

using MakeWorld = std::function<std::unique_ptr<PeerWorld>(const SceneChoice&, const Plan&)>;

}  // namespace

double seconds_now(std::uint32_t threads) {
  timespec now{};
  clock_gettime(threads > 1 ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double Record::mean_ms(std::size_t from, std::size_t to) const {
  return 1e3 *
         std::accumulate(best.begin() + static_cast<std::ptrdiff_t>(from),
                         best.begin() + static_cast<std::ptrdiff_t>(to), 0.0) /
         static_cast<double>(to - from);
}

double Record::p99_ms(std::size_t from) const {
  std::vector<double> steps(best.begin() + static_cast<std::ptrdiff_t>(from), best.end());
  const std::size_t above = steps.size() / 100;
  const auto place = steps.end() - 1 - static_cast<std::ptrdiff_t>(above);
  std::nth_element(steps.begin(), place, steps.end());
  return 1e3 * *place;
}

double Record::worst_ms(std::size_t from) const {
  return 1e3 * *std::max_element(best.begin() + static_cast<std::ptrdiff_t>(from), best.end());
}

std::vector<Record> measure(const Row& row, const Options& options) {
  SceneChoice choice = row.choice;
  double seconds = options.seconds > 0 ? options.seconds : row.seconds;
  if (options.quick) {
    seconds = std::min(seconds, 0.5);
    if (row.quick_n > 0) choice = with_n(choice, row.quick_n);
  }
  const carom_engine_desc desc = counted_engine();
  tools::Engine engine(tools::PluginPath(options.plugins), &desc);
  if (options.threads > 1) engine.set_threads(options.threads);
  const Described described(engine, choice);
  const Plan& plan = *described.plan;
  const Judge judge(plan);

  std::vector<Record> records;
  std::vector<MakeWorld> makers;
  std::vector<std::function<std::size_t()>> live;
  const auto add = [&](const std::string& name, bool is_carom, MakeWorld make, std::function<std::size_t()> bytes) {
    records.emplace_back();
    records.back().engine = name;
    records.back().is_carom = is_carom;
    records.back().planned = static_cast<std::size_t>(std::max(1l, std::lround(seconds / kDt)));
    makers.push_back(std::move(make));
    live.push_back(std::move(bytes));
  };
  if (options.carom)
    add(
        "Carom (double)", true,
        [&](const SceneChoice& scene, const Plan&) {
          std::vector<std::string> dials = options.dials;
          if (row.sleeping) dials.insert(dials.begin(), "sleep=on");
          return std::make_unique<CaromWorld>(engine, scene, dials);
        },
        carom_live_bytes);
  for (const PeerEngine& peer : options.peers)
    add(
        peer.name, false,
        [&row, &options, peer](const SceneChoice&, const Plan& told) {
          WorldPlan world = told.world(row.sleeping);
          world.threads = options.threads;
          return std::unique_ptr<PeerWorld>(peer.make(world));
        },
        peer.live_bytes);

  for (int repeat = 0; repeat < options.repeats; ++repeat)
    for (std::size_t i = 0; i < records.size(); ++i) {
      const std::size_t before = live[i]();
      const auto world = makers[i](choice, plan);
      drive(records[i], *world, judge, plan, options, repeat, row.id);
      records[i].bytes_per_body = static_cast<double>(live[i]() - before) / static_cast<double>(plan.members().size());
    }
  return records;
}

}  // namespace carom::bench
