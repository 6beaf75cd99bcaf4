// `carom scaling SCENE`: what threads would give a scene, on paper: each loop that a step shares is run here, part by
// part, on one thread, and the parts are then dealt to as many threads as one likes.
#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>

#include "cli/commands.h"
#include "cli/scene_choice.h"
#include "cli/table.h"
#include "host/cpu_time.h"
#include "scenes/run.h"

namespace carom::tools {
namespace {

constexpr std::uint32_t kThreads[] = {1, 2, 4, 8, 16, 32, 64};

struct ScalingOptions {
  SceneChoice choice;
  double skipped = 1;  // s
  double wake_us = 1;  // us
};

/// The loops of steps, as they ask to be shared: times of all their parts.
class Loops {
 public:
  static void run(void* user, carom_job_fn job, void* context, std::uint32_t count) {
    static_cast<Loops*>(user)->take(job, context, count);
  }
  void clear() { count_ = 0, seconds_ = longest_parts_ = 0, dealt_.fill(0); }

  std::size_t count() const { return count_; }
  double seconds() const { return seconds_; }              // s, of all parts
  double longest_parts() const { return longest_parts_; }  // s: no number of threads makes loops shorter
  /// s, on the i-th number of threads
  double dealt(std::size_t i) const { return dealt_[i]; }

 private:
  void take(carom_job_fn job, void* context, std::uint32_t count) {
    parts_.resize(count);
    double begun = cpu_time();
    for (std::uint32_t part = 0; part < count; ++part) {
      job(context, part, part + 1);
      const double now = cpu_time();
      parts_[part] = now - begun;
      begun = now;
    }
    ++count_;
    seconds_ += std::accumulate(parts_.begin(), parts_.end(), 0.0);
    longest_parts_ += *std::max_element(parts_.begin(), parts_.end());
    for (std::size_t i = 0; i < std::size(kThreads); ++i) dealt_[i] += deal(kThreads[i]);
  }
  /// Each part goes to the thread that is free first, as in the engine's own pool.   @return s, until the last is done
  double deal(std::uint32_t threads) {
    free_at_.assign(std::min<std::size_t>(threads, parts_.size()), 0);
    for (const double part : parts_) *std::min_element(free_at_.begin(), free_at_.end()) += part;
    return *std::max_element(free_at_.begin(), free_at_.end());
  }

  std::vector<double> parts_, free_at_;
  std::size_t count_ = 0;
  double seconds_ = 0, longest_parts_ = 0;
  std::array<double, std::size(kThreads)> dealt_{};
};

void print_scaling(const ScalingOptions& options, Context& context) {
  const SceneChoice& choice = options.choice;
  const Scene& scene = chosen_scene(choice.scene);
  Engine engine(context.plugins());
  Loops loops;
  engine.set_jobs(Loops::run, &loops);
  Stage stage(engine);
  const std::unique_ptr<Observer> observer = set_up(choice, scene, stage);
  const double dt = choice.dt.value_or(scene.dt), seconds = choice.seconds.value_or(scene.seconds);
  check_times(seconds, dt);
  if (!(options.skipped >= 0 && options.skipped < seconds))
    throw Error("--skip leaves no step to measure", "give seconds from 0 to below --seconds");
  if (options.skipped > 0) simulate(stage, observer.get(), options.skipped, dt);
  loops.clear();
  const double begun = cpu_time();
  const RunSummary run = simulate(stage, observer.get(), seconds - options.skipped, dt);
  const double all = std::min(cpu_time() - begun, run.total_seconds), serial = std::max(0.0, all - loops.seconds());
  const double steps = static_cast<double>(run.steps),
               wakes = static_cast<double>(loops.count()) * 1e-6 * options.wake_us;

  std::printf("%s: %llu steps, %.4g ms each on one thread\n", scene.name.c_str(),
              static_cast<unsigned long long>(run.steps), 1e3 * all / steps);
  std::printf("  shared: %.1f %% of the time, in %.0f loops a step; the rest, %.4g ms a step, is one thread's\n",
              100 * loops.seconds() / all, static_cast<double>(loops.count()) / steps, 1e3 * serial / steps);
  std::printf("  on paper, with %.3g us to hand a loop to other threads, and no cache or memory that they share:\n\n",
              options.wake_us);
  std::vector<std::vector<std::string>> rows = {
      {"threads", "speed-up", "ms/step", "one thread's", "loops", "handing over"}};
  for (std::size_t i = 0; i < std::size(kThreads); ++i) {
    const double handing = kThreads[i] > 1 ? wakes : 0, dealt = loops.dealt(i), took = serial + dealt + handing;
    const auto share = [&](double of) { return format("%.0f %%", 100 * of / took); };
    rows.push_back({format("%u", kThreads[i]), format("%.2f", all / took), format("%.4g", 1e3 * took / steps),
                    share(serial), share(dealt), share(handing)});
  }
  rows.push_back({"any", format("%.2f", all / (serial + loops.longest_parts() + wakes)), "", "", "", ""});
  std::printf("%s", table(rows, {true, true, true, true, true, true}).c_str());
}

}  // namespace

void add_scaling_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<ScalingOptions>();
  CLI::App* scaling = app.add_subcommand(
      "scaling",
      "What more threads would give a scene: its shared loops are timed on one, part by part, and dealt to many");
  add_scene_options(*scaling, options->choice, "Simulated time; default: the scene's");
  scaling->remove_option(scaling->get_option("--threads"));
  scaling->add_option("--skip", options->skipped, "Seconds before the measurement begins")->capture_default_str();
  scaling->add_option("--wake-us", options->wake_us, "Time that it takes to hand a loop to other threads, us")
      ->check(CLI::Range(0.0, 1e3))
      ->capture_default_str();
  scaling->callback([options, &context] { print_scaling(*options, context); });
}

}  // namespace carom::tools
