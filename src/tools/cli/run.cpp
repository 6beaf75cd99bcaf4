// `carom run SCENE`: simulate a scene, show how it goes, say what it cost and what ended where, and write the motion.

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/commands.h"
#include "cli/ledger_output.h"
#include "cli/plan_output.h"
#include "cli/run_output.h"
#include "cli/scene_choice.h"
#include "cli/table.h"
#include "host/drawings.h"
#include "host/files.h"
#include "host/system.h"
#include "replay/replay.h"
#include "report/perspective.h"
#include "report/silhouette.h"
#include "scenefile/scenefile.h"
#include "visual/gltf.h"

namespace carom::tools {
namespace {

struct RunOptions {
  SceneChoice choice;
  std::string gltf, csv, csv_steps, filmstrip, svg, ledger_svg, save, load, record;
  double fps = 30;
  bool quiet = false, as_json = false, plan = false, ledger = false, record_states = false;
};

/// A line that rewrites itself, at most ten times a second, on a terminal only.
class Progress {
 public:
  Progress(double seconds, bool wanted) : seconds_(seconds), shown_(wanted && errors_are_seen()) {}
  void update(const carom_step_report& report) {
    if (!shown_) return;
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(100)) return;
    last_ = now;
    std::fprintf(stderr, "\r  %s %6.2f of %.2f s  %9.0f steps/s  %6llu contacts ",
                 bar(report.time / seconds_, 30).c_str(), report.time, seconds_,
                 1 / std::max(report.total_seconds, 1e-9), static_cast<unsigned long long>(report.contact_points));
  }
  ~Progress() {
    if (shown_) std::fprintf(stderr, "\r%*s\r", 78, "");
  }

 private:
  double seconds_;
  bool shown_;
  std::chrono::steady_clock::time_point last_{};
};

/// Make the folder that a file shall go into, but none above it: a slip in a long path is an error, not a tree of
/// folders. What fails here fails again, with its remedy, where the file is opened.
void make_folder_of(const std::string& path) {
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (!folder.empty()) std::filesystem::create_directory(folder, ignored);
}

/// Six moments of the run seen from the side, for a page that plays no animation.
void write_filmstrip(const std::string& path, const Scene& scene, Stage& stage, const Recording& recording) {
  report::Filmstrip strip = report::filmstrip_of(stage, recording, 6);
  strip.title = scene.name + ": " + scene.look_for;
  strip.note = stage.remarks.empty() ? "" : stage.remarks.front();
  write_drawing(path, report::draw(strip));
}

/// The moment at which the run ended, in perspective.
void write_picture(const std::string& path, const Scene& scene, Stage& stage, double time) {
  char moment[64];
  std::snprintf(moment, sizeof moment, " after %.4g s", time);
  write_drawing(path, report::perspective(stage, scene.summary, "carom run " + scene.name + moment));
}

/// How errors grow in the first seconds: an accuracy is a promise about each step, and chaos makes more of it.
carom_growth growth_of(const World& world, double seconds, double dt) {
  constexpr double kLongest = 10;
  return world.growth(dt, static_cast<std::uint32_t>(std::max(1.0, std::min(seconds, kLongest) / dt)));
}

/// The whole world, so that a later run needs no scene.
void save_state(const std::string& path, const World& world) {
  const std::vector<char> bytes = world.save(CAROM_SNAPSHOT_WHOLE);
  write_file(path, {bytes.begin(), bytes.end()});
}

void load_state(const std::string& path, World& world) {
  const std::string bytes = read_file(path, "give --load a file that --save wrote");
  world.restore({bytes.begin(), bytes.end()}, path);
}

void run_scene(RunOptions options, Context& context) {
  SceneChoice& choice = options.choice;
  if (choice.scene.empty() && options.load.empty())
    throw Error("no scene is named", "give a scene (`carom list` shows them), a .gltf file, or --load FILE");
  if (!options.load.empty() && !is_snapshot_file(options.load))
    throw Error(std::filesystem::exists(options.load) ? options.load + " is no saved world"
                                                      : "there is no file " + options.load,
                "give --load a file that `carom run SCENE --save FILE` wrote");
  if (choice.scene.empty()) choice.scene.swap(options.load);  // which is whole, or told to be none
  const Scene& scene = chosen_scene(choice.scene);
  const double seconds = choice.seconds.value_or(scene.seconds), dt = choice.dt.value_or(scene.dt);
  check_times(seconds, dt);
  if (!(options.fps > 0 && options.fps <= 1e4))
    throw Error("--fps is out of range", "give frames per second, more than 0 and at most 10000");
  // Files first: better to hear now than after the run that one cannot be written.
  for (const std::string& path : {options.csv, options.csv_steps, options.save, options.record, options.gltf,
                                  options.svg, options.filmstrip, options.ledger_svg}) {
    make_folder_of(path);
    if (!path.empty()) check_output(path);
  }
  for (const std::string& path : {options.svg, options.filmstrip, options.ledger_svg})
    if (!path.empty()) check_drawing_path(path);
  if (!options.gltf.empty()) check_gltf_path(options.gltf);
  Engine engine(context.plugins());
  engine.set_threads(choice.threads);
  Stage stage(engine);
  const std::unique_ptr<Observer> observer = set_up(choice, scene, stage);
  stage.world.time_effects(options.plan);
  if (!options.load.empty()) load_state(options.load, stage.world);
  const double start = stage.world.report().time;
  std::optional<replay::FileRecorder> recorder;
  if (!options.record.empty()) recorder.emplace(stage.world, options.record, options.record_states);
  std::optional<StepTable> step_table;
  if (!options.csv_steps.empty()) step_table.emplace(options.csv_steps);
  std::optional<MotionTable> motion_table;
  if (!options.csv.empty()) motion_table.emplace(options.csv);

  const bool talk = !options.quiet && !options.as_json;
  if (talk) {
    std::printf("%s: %s\n", scene.name.c_str(), scene.summary.c_str());
    std::string plugins;
    for (const std::string& name : engine.loaded()) plugins += (plugins.empty() ? "" : ", ") + name;
    const std::size_t particles = stage.particle_count();
    std::printf("  %zu bodies, %zu particles; shape plugins loaded: %s\n", stage.actors.size() - particles, particles,
                plugins.empty() ? "none" : plugins.c_str());
    for (const std::string& remark : stage.remarks) std::printf("  %s\n", remark.c_str());
    std::printf("  look for: %s\n", scene.look_for.c_str());
    std::fflush(stdout);
  }
  std::optional<Recording> recording;
  if (motion_table || !options.gltf.empty() || !options.filmstrip.empty()) recording.emplace(stage, dt, options.fps);
  LedgerPlot ledger_plot;
  if (options.ledger || !options.ledger_svg.empty()) stage.world.keep_ledger();
  carom_growth growth{};
  if (choice.accuracy) growth = growth_of(stage.world, seconds, dt);
  RunSummary run;
  {
    Progress progress(start + seconds, talk);
    run = simulate(stage, observer.get(), seconds, dt, [&](const carom_step_report& report) {
      progress.update(report);
      if (recording) recording->after_step(report.steps, report.time);
      if (step_table) step_table->add(report);
      if (!options.ledger_svg.empty()) ledger_plot.add(stage.world, report.time);
      return true;
    });
  }
  run.growth = growth;
  if (recorder) recorder->end();
  if (!options.save.empty()) save_state(options.save, stage.world);
  if (recording) recording->finish(run.simulated);
  if (step_table) step_table->finish();
  if (motion_table) motion_table->write(stage, *recording);
  if (!options.gltf.empty()) write_gltf(options.gltf, stage, *recording);
  if (!options.filmstrip.empty()) write_filmstrip(options.filmstrip, scene, stage, *recording);
  if (!options.svg.empty()) write_picture(options.svg, scene, stage, run.simulated);

  if (!options.ledger_svg.empty())
    write_drawing(options.ledger_svg, ledger_plot.draw(scene.name + ": where the energy of motion came from"));

  const std::vector<KindSummary> kinds = where_it_ended(stage);
  if (options.as_json) {
    nlohmann::json summary = summary_json(scene, stage, observer.get(), run, kinds, dt);
    if (options.plan) summary["plan"] = plan_json(stage.world.plan());
    std::printf("%s\n", summary.dump(2).c_str());
  } else if (!options.quiet) {
    print_summary(stage, observer.get(), run, kinds);
  }
  if (options.ledger && !options.as_json) print_ledger(stage.world);
  if (options.plan && talk) std::printf("\n%s", plan_text(stage.world.plan()).c_str());
  if (talk && !options.gltf.empty())
    std::printf("\nmotion: %s (%zu frames), for any glTF viewer\n", options.gltf.c_str(), recording->frame_count());
  if (run_went_wrong(run, kinds)) {
    std::fprintf(stderr,
                 "carom: the run went wrong: bodies not finite, escaped, or faults (see the summary)\n"
                 "  what to do: try a smaller --dt or more substeps (`carom dials`); if a shape is at fault, "
                 "`carom check` its plugin\n");
    context.exit_code = kExitBadNews;
  }
}

}  // namespace

void add_run_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* run = app.add_subcommand("run", "Simulate a scene; say what happened and what it cost");
  add_scene_options(*run, options->choice, "How long to simulate; default: the scene's");
  run->add_option("--gltf", options->gltf, "Write the motion as animated glTF")->type_name("FILE.gltf|FILE.glb");
  run->add_option("--filmstrip", options->filmstrip,
                  "Write six moments of the motion, seen from the side, as a drawing")
      ->type_name("FILE.svg|FILE.png");
  run->add_option("--svg", options->svg, "Write what it looks like when the run ends, as a drawing; needs no display")
      ->type_name("FILE.svg|FILE.png");
  run->add_option("--csv", options->csv, "Write pose and name of every body, per frame")->type_name("FILE");
  run->add_option("--csv-steps", options->csv_steps, "Write times, counts and residuals of every step")
      ->type_name("FILE");
  run->add_option("--fps", options->fps, "Frames per simulated second in --gltf and --csv")->capture_default_str();
  run->add_flag("--ledger", options->ledger,
                "Print where energy, momentum and angular momentum came from and went to, by cause");
  run->add_option("--ledger-svg", options->ledger_svg, "Draw energy by cause over time")
      ->type_name("FILE.svg|FILE.png");
  run->add_option("--save", options->save, "Write the world in which the run ends, whole")->type_name("FILE");
  run->add_option("--load", options->load,
                  "Begin with what --save wrote: of the same scene and settings, or, if no scene is named, as it is")
      ->type_name("FILE");
  run->add_option("--record", options->record, "Write every call and the hash of each step, for `carom replay`")
      ->type_name("FILE");
  run->add_flag("--record-states", options->record_states,
                "With --record: the state after each step, too, so that a replay can name what differs");
  run->get_option("SCENE")->required(false);
  run->add_flag("--quiet", options->quiet, "Say nothing but errors");
  run->add_flag("--plan", options->plan,
                "At the end print what ran in the last step, on which participants, and what was left out");
  run->add_flag("--json", options->as_json, "Print the summary as JSON");
  run->callback([options, &context] { run_scene(*options, context); });
}

}  // namespace carom::tools
