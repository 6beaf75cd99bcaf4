// Carom beside Bullet 3 in one process: the scene `falling`, same first poses, same judge, speed and what it is worth.
#include <time.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>

#include "bullet_world.h"
#include "judge.h"

namespace {

using namespace carom;
using namespace carom::bench;

#ifdef BT_USE_DOUBLE_PRECISION
constexpr const char* kPrecision = "double";
#else
constexpr const char* kPrecision = "float";
#endif

struct Options {
  int n = 1024;
  double seconds = 15;  // simulated
  int repeats = 3;
  int bullet_iterations = 0;
  std::vector<std::string> dials;
  std::vector<std::string> plugins;
  bool skip_carom = false;
};

/// What one engine did: every step's least time over the repeats, and the verdicts at the end and at its worst.
struct Run {
  std::vector<double> best;        // s, a step
  Verdict end;                     // of the last repeat
  double peak_penetration = 0;     // m, over every tenth step of the last repeat
  std::size_t contact_points = 0;  // at the end
  std::vector<double> stages;      // s of wall clock in the last repeat, by CAROM_STAGE_*

  double mean_ms(std::size_t from, std::size_t to) const {
    return 1e3 *
           std::accumulate(best.begin() + static_cast<std::ptrdiff_t>(from),
                           best.begin() + static_cast<std::ptrdiff_t>(to), 0.0) /
           static_cast<double>(to - from);
  }
};

constexpr double kDt = 1.0 / 60;

/// CPU time of this process, all threads together: what a step costs, however busy the machine is with others.
double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Step an engine to the end once; the judge looks on outside the clock, in the last repeat only.
void drive(Run& run, const Judge& judge, std::size_t steps, bool last, const std::function<void()>& step,
           const std::function<void(std::vector<BodyState>&)>& read, const std::function<void()>& look = {}) {
  run.best.resize(steps, HUGE_VAL);
  std::vector<BodyState> states;
  for (std::size_t i = 0; i < steps; ++i) {
    const double start = cpu_seconds();
    step();
    run.best[i] = std::min(run.best[i], cpu_seconds() - start);
    if (last && look) look();
    if (!last || (i % 10 && i + 1 < steps)) continue;
    read(states);
    run.end = judge.judge(states);
    run.peak_penetration = std::max(run.peak_penetration, run.end.max_penetration);
  }
}

void fill(tools::Stage& stage, int n) {
  tools::build(tools::find_scene("falling"), {{{"n", static_cast<double>(n)}}, ""}, stage);
}

void read_carom(const tools::Stage& stage, std::vector<BodyState>& states) {
  std::vector<carom_body> handles;
  for (const tools::Actor& actor : stage.actors) handles.push_back(actor.body);
  std::vector<double> pose, velocity;
  stage.world.read(CAROM_FIELD_POSE, handles, pose);
  stage.world.read(CAROM_FIELD_VELOCITY, handles, velocity);
  states.resize(handles.size());
  for (std::size_t i = 0; i < handles.size(); ++i) {
    states[i].position = Vec(&pose[7 * i]);
    states[i].orientation = Quat(&pose[7 * i + 3]);
    states[i].velocity = Vec(&velocity[6 * i]);
    states[i].omega = Vec(&velocity[6 * i + 3]);
  }
}

void print_row(const char* name, const Run& run, double relative_to) {
  const std::size_t steps = run.best.size();
  std::printf("| %s | %.3f | %.3f | %.3f | %.1f | %.2f | %.1f / %.2f | %.0f | %zu | %.1e | %zu | %zu | %zu |\n", name,
              run.mean_ms(0, steps), run.mean_ms(steps - steps / 3, steps),
              1e3 * *std::max_element(run.best.begin(), run.best.end()),
              1e-3 * run.mean_ms(0, steps) * static_cast<double>(steps), run.mean_ms(0, steps) / relative_to,
              1e3 * run.end.max_penetration, 1e3 * run.end.mean_penetration, 1e3 * run.peak_penetration,
              run.end.overlaps, run.end.mean_energy, run.contact_points, run.end.escaped, run.end.lost);
}

void print_stages(const Run& run) {
  const double all = std::accumulate(run.stages.begin(), run.stages.end(), 0.0);
  std::printf("\nCarom's stages:");
  for (std::size_t k = 0; k < run.stages.size(); ++k)
    std::printf("%s %s %.1f %%", k ? "," : "", carom_stage_name(static_cast<std::uint32_t>(k)),
                100 * run.stages[k] / all);
  std::printf("\n");
}

void run_carom(Run& run, const Judge& judge, tools::Engine& engine, const Options& options, std::size_t steps,
               bool last) {
  tools::Stage stage(engine);
  fill(stage, options.n);
  for (const std::string& dial : options.dials) stage.world.set_dial(dial);
  const auto step = [&] { stage.world.step(kDt); };
  const auto read = [&](std::vector<BodyState>& states) { read_carom(stage, states); };
  const auto look = [&] {
    const carom_step_report report = stage.world.report();
    run.stages.resize(report.stage_count);
    for (std::uint32_t k = 0; k < report.stage_count; ++k) run.stages[k] += report.stage_seconds[k];
    run.contact_points = report.contact_points;
  };
  drive(run, judge, steps, last, step, read, look);
}

/// @return the solver iterations it used
int run_bullet(Run& run, const Judge& judge, const tools::Stage& described, const Options& options, std::size_t steps,
               bool last) {
  BulletWorld bullet(described, judge, options.bullet_iterations);
  const auto step = [&] { bullet.step(kDt); };
  const auto read = [&](std::vector<BodyState>& states) { bullet.read(states); };
  drive(run, judge, steps, last, step, read);
  run.contact_points = bullet.contact_points();
  return bullet.iterations();
}

void compare(const Options& options) {
  const auto steps = static_cast<std::size_t>(std::lround(options.seconds / kDt));
  tools::Engine engine{tools::PluginPath(options.plugins)};
  tools::Stage described(engine);  // for the judge; never stepped
  fill(described, options.n);
  const Judge judge(described);
  Run ours, theirs;
  int iterations = 0;
  for (int repeat = 0; repeat < options.repeats; ++repeat) {
    const bool last = repeat + 1 == options.repeats;
    if (!options.skip_carom) run_carom(ours, judge, engine, options, steps, last);
    iterations = run_bullet(theirs, judge, described, options, steps, last);
  }
  std::printf("falling, n = %d, %zu steps of 1/60 s, least CPU time of each step over %d repeats\n\n", options.n, steps,
              options.repeats);
  std::printf(
      "| engine | ms/step | last third | worst step | total s | ratio | penetration max / mean mm | peak mm | overlaps "
      "| energy J/body | contact points | escaped | not finite |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  const double reference = theirs.mean_ms(0, steps);
  const std::string bullet_name = "Bullet " + std::to_string(btGetVersion() / 100) + "." +
                                  std::to_string(btGetVersion() % 100) + " (" + kPrecision + ", " +
                                  std::to_string(iterations) + " iterations)";
  if (!options.skip_carom) print_row("Carom (double)", ours, reference);
  print_row(bullet_name.c_str(), theirs, reference);
  if (!options.skip_carom) print_stages(ours);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Speed and quality of Carom beside Bullet 3 on the scene `falling`, in one run."};
  Options options;
  options.plugins = {CAROM_PLUGIN_DIR};
  app.add_option("--n", options.n, "Bodies")->check(CLI::Range(1, 100000))->capture_default_str();
  app.add_option("--seconds", options.seconds, "Simulated time")->check(CLI::Range(0.1, 3600.0))->capture_default_str();
  app.add_option("--repeats", options.repeats, "Runs of each engine, in turn")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  app.add_option("--dial", options.dials, "name=value, of Carom's world (repeatable)")->allow_extra_args(false);
  app.add_option("--bullet-iterations", options.bullet_iterations, "Solver iterations of Bullet; 0: its default");
  app.add_option("--plugins", options.plugins, "Folders with shape plugins");
  app.add_flag("--bullet-only", options.skip_carom, "Do not step Carom");
  CLI11_PARSE(app, argc, argv);
  try {
    compare(options);
  } catch (const tools::Error& error) {
    std::fprintf(stderr, "falling_vs_bullet: %s\n  what to do: %s\n", error.what(), error.remedy.c_str());
    return 1;
  }
  return 0;
}
