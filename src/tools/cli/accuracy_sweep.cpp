// `carom accuracy sweep` and `carom accuracy report`: dials x steps on scenes with a truth, and one page that shows it.
#include "cli/accuracy_sweep.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>

#include "accuracy/page/measured.h"
#include "accuracy/page/report.h"
#include "accuracy/sweep/sweep.h"
#include "cli/table.h"
#include "host/drawings.h"
#include "host/files.h"
#include "host/system.h"

namespace carom::tools {
namespace {

using accuracy::Sweep;
using accuracy::SweepPlan;

struct SweepOptions {
  std::vector<std::string> scenes;
  std::string out;
  double seconds = 600, per_run = 20;
  bool no_maps = false, quiet = false;
};

std::string minutes(double seconds) {
  return seconds < 100 ? format("%.0f s", seconds) : format("%.0f min", seconds / 60);
}

/// A line that rewrites itself on a terminal; elsewhere one line a scene.
class Teller {
 public:
  explicit Teller(bool quiet) : quiet_(quiet), rewrites_(errors_are_seen()) {}
  void operator()(const accuracy::Progress& p) {
    if (quiet_) return;
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
    const double left = p.done > 0.02 ? std::min(spent / p.done * (1 - p.done), p.seconds_left) : p.seconds_left;
    if (rewrites_) {
      std::fprintf(stderr, "\r  %s %3.0f %%, %s left  %-64.64s", bar(p.done, 20).c_str(), 100 * p.done,
                   minutes(left).c_str(), p.what.c_str());
      return;
    }
    const std::string scene = p.what.substr(0, p.what.find(':'));
    if (scene == scene_) return;
    scene_ = scene;
    std::fprintf(stderr, "  %3.0f %%, at most %s left: %s\n", 100 * p.done, minutes(left).c_str(), scene.c_str());
  }
  ~Teller() {
    if (rewrites_ && !quiet_) std::fprintf(stderr, "\r%*s\r", 110, "");
  }

 private:
  bool quiet_, rewrites_;
  std::string scene_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

/// Before a long run, not after it. Leaves no empty file behind.
void check_writable(const std::string& path) {
  const bool was_there = std::filesystem::exists(path);
  const bool opens = std::ofstream(path, std::ios::app).is_open();
  if (opens && !was_there) std::filesystem::remove(path);
  if (!opens) throw Error("cannot write " + path, "check that its folder exists and is writable");
}

void run_sweep(const SweepOptions& options, Context& context) {
  if (!(options.seconds > 0)) throw Error("--seconds must be more than 0", "give seconds, e.g. --seconds 60");
  if (!(options.per_run > 0)) throw Error("--per-run must be more than 0", "give seconds, e.g. --per-run 5");
  const bool csv = options.out.ends_with(".csv");
  if (!csv && !options.out.ends_with(".json"))
    throw Error("--out " + options.out + " is neither .json nor .csv",
                "name a FILE.json (reports read it) or a FILE.csv");
  SweepPlan plan;
  for (const std::string& scene : options.scenes)
    if (scene == "all")
      for (const accuracy::Challenge& c : accuracy::all_challenges()) plan.scenes.push_back(&c);
    else
      plan.scenes.push_back(&accuracy::find_challenge(scene));
  check_writable(options.out);
  plan.entries = accuracy::carom_entries();
  plan.steps = accuracy::sweep_steps();
  plan.seconds = options.seconds, plan.most_per_run = options.per_run, plan.maps = !options.no_maps;
  Engine engine(context.plugins());
  Sweep found;
  {
    Teller teller(options.quiet);
    found = accuracy::sweep(engine, plan, [&](const accuracy::Progress& p) { teller(p); });
  }
  csv ? accuracy::write_csv(options.out, found) : accuracy::write_json(options.out, found);
  const auto left_out =
      std::count_if(found.rows.begin(), found.rows.end(), [](const auto& row) { return row.left_out; });
  if (!options.quiet)
    std::printf("%zu runs in %s, %td of them left out for want of time%s\n", found.rows.size(), options.out.c_str(),
                left_out, left_out ? ": a larger --seconds or --per-run has them" : "");
}

struct ReportOptions {
  std::vector<std::string> from, draw;
  std::string out, effects;
  double seconds = 120;
  bool quiet = false;
};

void run_report(const ReportOptions& options, Context& context) {
  if (options.out.empty() && options.draw.empty()) throw Error("nothing to write", "give --out report.html");
  if (!options.out.empty()) check_writable(options.out);
  Sweep sweep;
  for (const std::string& path : options.from) accuracy::merge(sweep, accuracy::read_json(path));
  Engine engine(context.plugins());
  if (options.from.empty()) {
    SweepPlan plan;
    for (const accuracy::Challenge& c : accuracy::all_challenges()) plan.scenes.push_back(&c);
    plan.entries = accuracy::carom_entries(), plan.steps = accuracy::sweep_steps();
    plan.seconds = options.seconds;
    Teller teller(options.quiet);
    sweep = accuracy::sweep(engine, plan, [&](const accuracy::Progress& p) { teller(p); });
  }
  for (const std::string& drawing : options.draw) {
    const std::size_t equals = drawing.find('=');
    if (equals == std::string::npos)
      throw Error("--draw " + drawing + " names no file", "write --draw NAME=FILE.svg, or FILE.png");
    const std::string path = drawing.substr(equals + 1);
    write_drawing(path, accuracy::report_drawing(sweep, drawing.substr(0, equals)));
  }
  if (options.out.empty()) return;
  accuracy::Extras extras;
  extras.tolerances = accuracy::measure_tolerances(engine);
  extras.effects =
      options.effects.empty() ? accuracy::measure_effects(engine) : accuracy::read_effects(options.effects);
  write_file(options.out, accuracy::report_page(sweep, extras));
  if (!options.quiet) std::printf("%s: %zu runs\n", options.out.c_str(), sweep.rows.size());
}

}  // namespace

void add_sweep_and_report_commands(CLI::App& accuracy_command, Context& context) {
  const auto sweep_options = std::make_shared<SweepOptions>();
  CLI::App* sweep =
      accuracy_command.add_subcommand("sweep", "Run scenes at many settings and steps: what accuracy costs");
  sweep->add_option("SCENE", sweep_options->scenes, "Which scenes, or all; `carom accuracy list` shows them")
      ->required();
  sweep->add_option("--out", sweep_options->out, "Every run: .json for `carom accuracy report`, .csv for other tools")
      ->required()
      ->type_name("FILE.json|FILE.csv");
  sweep
      ->add_option("--seconds", sweep_options->seconds,
                   "About how long to take; what does not fit is left out, finest steps first")
      ->capture_default_str();
  sweep->add_option("--per-run", sweep_options->per_run, "A run that takes more s of computing is left out")
      ->capture_default_str();
  sweep->add_flag("--no-maps", sweep_options->no_maps, "Leave out the maps of what stands");
  sweep->add_flag("--quiet", sweep_options->quiet, "Say nothing but errors");
  sweep->callback([sweep_options, &context] { run_sweep(*sweep_options, context); });

  const auto report_options = std::make_shared<ReportOptions>();
  CLI::App* report =
      accuracy_command.add_subcommand("report", "One HTML page with every diagram of a sweep, nothing beside it");
  report->add_option("--out", report_options->out, "The page")->type_name("FILE.html");
  report
      ->add_option("--from", report_options->from,
                   "A sweep, repeatable: rows are put together; default: sweep now, coarsely")
      ->type_name("FILE.json")
      ->allow_extra_args(false);
  report
      ->add_option("--effects", report_options->effects,
                   "Costs of effects as `effect_costs --csv` writes them; default: measured now, coarsely")
      ->type_name("FILE.csv");
  report
      ->add_option("--draw", report_options->draw,
                   "One diagram as a drawing of its own, repeatable; a wrong name lists them")
      ->type_name("NAME=FILE.svg|NAME=FILE.png")
      ->allow_extra_args(false);
  report->add_option("--seconds", report_options->seconds, "How long to sweep where --from is not given")
      ->capture_default_str();
  report->add_flag("--quiet", report_options->quiet, "Say nothing but errors");
  report->callback([report_options, &context] { run_report(*report_options, context); });
}

}  // namespace carom::tools
