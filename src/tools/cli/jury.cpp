// `carom jury`: random scenes that no setting was tuned for, run at the settings given and judged.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/table.h"
#include "jury/trial.h"
#include "scenefile/scenefile.h"

namespace carom::tools {
namespace {

using jury::Failure;
using jury::Kind;
using jury::Setting;
using jury::Trial;

struct JuryOptions {
  Setting setting;
  std::string seeds, write, judge, family;
  std::optional<std::uint64_t> seed;
  std::size_t count = 100;
  bool as_json = false, steps = false, no_times = false, no_run = false;
};

struct Seeds {
  std::uint64_t first, last;
};

Seeds seeds_from(const JuryOptions& options) {
  if (options.seed) return {*options.seed, *options.seed};
  if (options.seeds.empty()) {
    const std::time_t now = std::time(nullptr);
    const std::tm day = *std::gmtime(&now);
    const std::uint64_t first = jury::seed_of_day(day.tm_year + 1900, day.tm_mon + 1, day.tm_mday);
    return {first, first + options.count - 1};
  }
  unsigned long long first = 0, last = 0;
  char rest = 0;
  const int read = std::sscanf(options.seeds.c_str(), "%llu..%llu%c", &first, &last, &rest);
  if (read != 2 || last < first || last - first >= 10000000)
    throw Error("--seeds " + options.seeds + " is no range", "write --seeds FROM..TO, both counted: --seeds 1..100");
  return {first, last};
}

std::string text_of(const Failure& f) {
  std::string text = format("%s at step %zu, %s: %.3g %s (%.3g borne)", jury::name_of(f.kind), f.step, f.who.c_str(),
                            f.value, f.unit, f.limit);
  if (f.plain_step) text += format("; plain from step %zu", f.plain_step);
  if (f.worst_step != f.step)
    text += format("; at worst %.3g %s at step %zu, %s", f.worst, f.unit, f.worst_step, f.worst_who.c_str());
  return text;
}

/// Numbers of all scenes together.
struct Tally {
  std::size_t scenes = 0, failed = 0;
  std::array<std::size_t, jury::kKinds> by_kind{}, plain{};
  std::size_t plainly = 0;            // scenes with a failure that anybody would see
  std::vector<double> steps, ratios;  // s, and of each scene its worst step over its mean
  double worst = 0;                   // s
  std::uint64_t worst_seed = 0, worst_ratio_seed = 0;
  double worst_ratio = 0;

  void add(const Trial& trial) {
    const jury::Verdict& v = trial.verdict;
    ++scenes;
    failed += !v.failures.empty();
    bool any = false;
    for (const Failure& f : v.failures) {
      ++by_kind[static_cast<std::size_t>(f.kind)];
      plain[static_cast<std::size_t>(f.kind)] += f.plain_step > 0;
      any |= f.plain_step > 0;
    }
    plainly += any;
    steps.insert(steps.end(), v.seconds.begin(), v.seconds.end());
    if (v.worst_seconds > worst) worst = v.worst_seconds, worst_seed = trial.seed;
    const double ratio = v.mean_seconds > 0 ? v.worst_seconds / v.mean_seconds : 0;
    ratios.push_back(ratio);
    if (ratio > worst_ratio) worst_ratio = ratio, worst_ratio_seed = trial.seed;
  }
  double mean() const {
    double sum = 0;
    for (const double s : steps) sum += s;
    return steps.empty() ? 0 : sum / static_cast<double>(steps.size());
  }
  static double share(std::vector<double> of, double part) {
    if (of.empty()) return 0;
    const auto at = static_cast<std::size_t>(part * static_cast<double>(of.size() - 1));
    std::nth_element(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(at), of.end());
    return of[at];
  }
};

void print_tally(const Tally& t, bool times) {
  std::vector<std::vector<std::string>> rows = {{"failure", "scenes", "plain", "which is"}};
  for (std::size_t k = 0; k < jury::kKinds; ++k)
    rows.push_back({jury::name_of(static_cast<Kind>(k)), std::to_string(t.by_kind[k]), std::to_string(t.plain[k]),
                    jury::meaning_of(static_cast<Kind>(k))});
  rows.push_back(
      {"any", std::to_string(t.failed), std::to_string(t.plainly), "of " + std::to_string(t.scenes) + " scenes"});
  std::printf("\n%s", table(rows, {false, true, true}).c_str());
  if (!times) return;
  std::printf(
      "\nms a step: mean %.3f, p99 %.3f, worst %.3f (seed %llu); worst over mean: median %.1f, most %.1f (seed %llu)\n",
      1e3 * t.mean(), 1e3 * Tally::share(t.steps, 0.99), 1e3 * t.worst, static_cast<unsigned long long>(t.worst_seed),
      Tally::share(t.ratios, 0.5), t.worst_ratio, static_cast<unsigned long long>(t.worst_ratio_seed));
}

/// A row for each family: which kinds fail how often, in brackets plainly.
void print_families(const std::map<std::string, Tally>& families) {
  if (families.empty()) return;
  std::vector<std::string> head = {"family", "scenes", "fail", "plain"};
  for (std::size_t k = 0; k < jury::kKinds; ++k) head.emplace_back(jury::name_of(static_cast<Kind>(k)));
  head.insert(head.end(), {"mean ms", "worst ms"});
  std::vector<std::vector<std::string>> rows = {head};
  for (const auto& [name, t] : families) {
    std::vector<std::string> row = {name, std::to_string(t.scenes), std::to_string(t.failed),
                                    std::to_string(t.plainly)};
    for (std::size_t k = 0; k < jury::kKinds; ++k)
      row.push_back(t.by_kind[k] ? format("%zu (%zu)", t.by_kind[k], t.plain[k]) : "");
    row.push_back(format("%.3f", 1e3 * t.mean())), row.push_back(format("%.1f", 1e3 * t.worst));
    rows.push_back(std::move(row));
  }
  std::printf("\n%s", table(rows, std::vector<bool>(head.size(), true)).c_str());
}

void check_family(const JuryOptions& options) {
  if (options.family.empty()) return;
  if (!options.setting.built) throw Error("--family is of built scenes alone", "add --built");
  const std::vector<std::string> names = jury::all_families();
  if (std::find(names.begin(), names.end(), options.family) != names.end()) return;
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  throw Error("no family '" + options.family + "'", "one of " + all);
}

nlohmann::json trial_json(const Trial& trial) {
  nlohmann::json out = {{"seed", trial.seed},
                        {"summary", trial.summary},
                        {"family", trial.family},
                        {"joints", trial.joints},
                        {"mean_ms", 1e3 * trial.verdict.mean_seconds},
                        {"worst_ms", 1e3 * trial.verdict.worst_seconds},
                        {"worst_step", trial.verdict.worst_step},
                        {"mean_work", trial.verdict.mean_work},
                        {"worst_work", trial.verdict.worst_work},
                        {"failures", nlohmann::json::array()}};
  for (const Failure& f : trial.verdict.failures)
    out["failures"].push_back({{"kind", jury::name_of(f.kind)},
                               {"step", f.step},
                               {"who", f.who},
                               {"value", f.value},
                               {"limit", f.limit},
                               {"unit", f.unit},
                               {"plain_step", f.plain_step},
                               {"worst", f.worst},
                               {"worst_step", f.worst_step},
                               {"worst_who", f.worst_who}});
  return out;
}

nlohmann::json tally_json(const Tally& t) {
  nlohmann::json kinds, plain;
  for (std::size_t k = 0; k < jury::kKinds; ++k) {
    kinds[jury::name_of(static_cast<Kind>(k))] = t.by_kind[k];
    plain[jury::name_of(static_cast<Kind>(k))] = t.plain[k];
  }
  return {{"scenes", t.scenes},
          {"failed", t.failed},
          {"failures", kinds},
          {"failed_plainly", t.plainly},
          {"plain_failures", plain},
          {"mean_ms", 1e3 * t.mean()},
          {"p99_ms", 1e3 * Tally::share(t.steps, 0.99)},
          {"worst_ms", 1e3 * t.worst},
          {"worst_over_mean", {{"median", Tally::share(t.ratios, 0.5)}, {"most", t.worst_ratio}}}};
}

std::string path_in(const std::string& folder, std::uint64_t seed, const char* ending) {
  return (std::filesystem::path(folder) / (std::to_string(seed) + ending)).string();
}

/// The scene before its first step: as glTF, and as other engines read it.
void write_start(const JuryOptions& options, const PluginPath& plugins, std::uint64_t seed) {
  std::error_code ignored;
  std::filesystem::create_directory(options.write, ignored);
  const jury::Setting& setting = options.setting;
  jury::Scenery scenery(plugins, seed, setting.built);
  jury::write_scene_json(path_in(options.write, seed, ".json"), scenery, setting);
  for (const jury::Deed& deed : scenery.scene.deeds)  // shown with all that will be there
    if (deed.what == jury::Deed::What::add) jury::act(scenery, deed);
  write_scene(path_in(options.write, seed, ".gltf"), scenery.stage, setting.seconds_of(scenery.scene),
              setting.dt_of(scenery.scene));
}

void print_members(const jury::Case& scene) {
  std::vector<std::vector<std::string>> rows = {{"body", "kg", "size, m", "thickness, m"}};
  for (const jury::Member& m : scene.members)
    if (m.moves())
      rows.push_back({m.name, format("%.3g", m.mass), format("%.3f", m.size), format("%.4f", m.thickness)});
  std::printf("%s", table(rows, {false, true, true, true}).c_str());
  for (const jury::Link& link : scene.links)
    std::printf("%s: %s and %s\n", carom_joint_kind_name(link.kind), scene.members[link.a].name.c_str(),
                scene.members[link.b].name.c_str());
}

/// A line a step: energies, who is worst in what, and what the solver did.
jury::Watcher print_steps(const jury::Case& scene) {
  std::printf(
      "\n step   kinetic J  potential J    excess J   (borne)  gained most            m/s fastest               mm "
      "deepest"
      "                            gap mm  points  impulses  hits      ms\n");
  return [&scene](std::size_t step, const jury::Reading& r, const carom_step_report& report) {
    const auto name = [&](std::size_t i) { return scene.members[i].name.c_str(); };
    const std::string pair = r.depth > 0 ? std::string(name(r.deep_a)) + " in " + name(r.deep_b) : "";
    std::printf("%5zu %11.4g %12.5g %11.3g %9.3g  %-20s %7.3g %-20s %6.2f %-36s %5.2f %7llu %9llu %5llu %7.3f\n", step,
                r.kinetic, r.potential, r.excess, r.excess_limit, name(r.gainer), r.speed, name(r.fastest),
                1e3 * r.depth, pair.c_str(), 1e3 * r.gap, static_cast<unsigned long long>(report.contact_points),
                static_cast<unsigned long long>(report.velocity_impulses),
                static_cast<unsigned long long>(report.sweep_hits), 1e3 * report.total_seconds);
  };
}

Trial try_seed(const JuryOptions& options, const PluginPath& plugins, std::uint64_t seed) {
  std::unique_ptr<jury::Scenery> shown;  // for names alone
  jury::Watcher watch;
  if (options.steps || !options.judge.empty())
    shown = std::make_unique<jury::Scenery>(plugins, seed, options.setting.built);
  if (options.steps) print_members(shown->scene), watch = print_steps(shown->scene);
  if (!options.judge.empty())
    return jury::judge(plugins, seed, options.setting,
                       jury::read_motion(path_in(options.judge, seed, ".motion"), shown->scene.members.size()), watch);
  jury::Motion motion;
  const Trial trial = jury::run(plugins, seed, options.setting, watch, options.write.empty() ? nullptr : &motion);
  if (!options.write.empty()) jury::write_motion(path_in(options.write, seed, ".motion"), motion);
  return trial;
}

void print_trial(const Trial& trial) {
  std::printf("seed %llu, %s:\n", static_cast<unsigned long long>(trial.seed), trial.summary.c_str());
  for (const Failure& f : trial.verdict.failures) std::printf("    %s\n", text_of(f).c_str());
  std::fflush(stdout);
}

void run_jury(JuryOptions options, Context& context) {
  options.setting.times = !options.no_times;
  const Seeds seeds = seeds_from(options);
  const PluginPath plugins = context.plugins();
  const auto first = static_cast<unsigned long long>(seeds.first), last = static_cast<unsigned long long>(seeds.last);
  check_family(options);
  if (!options.as_json) std::printf("seeds %llu..%llu\n", first, last);
  Tally tally;
  std::map<std::string, Tally> families;
  nlohmann::json scenes = nlohmann::json::array();
  for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
    if (!options.family.empty() && options.family != jury::family_of(seed)) continue;
    if (!options.write.empty()) write_start(options, plugins, seed);
    if (options.no_run) continue;
    const Trial trial = try_seed(options, plugins, seed);
    tally.add(trial);
    if (options.setting.built) families[trial.family].add(trial);
    if (options.as_json) scenes.push_back(trial_json(trial));
    if (!options.as_json && (options.seed || !trial.verdict.failures.empty())) print_trial(trial);
  }
  if (options.no_run) return;
  if (options.as_json)
    std::printf("%s\n",
                nlohmann::json{{"seeds", {seeds.first, seeds.last}}, {"summary", tally_json(tally)}, {"scenes", scenes}}
                    .dump(2)
                    .c_str());
  else
    print_families(families), print_tally(tally, options.setting.times);
  if (tally.failed) context.exit_code = kExitBadNews;
}

}  // namespace

void add_jury_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<JuryOptions>();
  CLI::App* jury = app.add_subcommand("jury", "Draw random scenes, run them and judge them; name the seeds that fail");
  jury->add_option("--seeds", options->seeds, "Which, both ends counted; default: those of the day (UTC)")
      ->type_name("FROM..TO");
  jury->add_option("--seed", options->seed, "One, and what became of it")->type_name("N");
  jury->add_option("--count", options->count, "How many seeds of the day")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  jury->add_option("--preset", options->setting.preset, "fast, balanced, accurate or reference; --dial comes after")
      ->type_name("NAME");
  jury->add_option("--dial,--set", options->setting.dials, "A dial of the world, repeatable; `carom dials` lists them")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  jury->add_flag("--built", options->setting.built, "Scenes that people build, not what falls at random");
  jury->add_option("--family", options->family, "Of the seeds of built scenes those of one family alone")
      ->type_name("NAME");
  jury->add_option("--dt", options->setting.dt, "Time step; default: that of the scene, 1/60 unless it is built")
      ->type_name("S")
      ->check(CLI::Range(1e-5, 1.0));
  jury->add_option("--seconds", options->setting.seconds, "How long each scene lasts")
      ->check(CLI::Range(1e-5, 3600.0))
      ->capture_default_str();
  jury->add_flag("--steps", options->steps,
                 "Print bodies, joints and a line for each step: energies, the worst body in each, the report");
  jury->add_option("--write", options->write,
                   "Write each scene as SEED.gltf and, for other engines, SEED.json; its motion as SEED.motion")
      ->type_name("DIR");
  jury->add_flag("--no-run", options->no_run, "With --write: the scenes alone");
  jury->add_option("--judge", options->judge, "Run nothing: judge DIR/SEED.motion, which another engine wrote")
      ->type_name("DIR");
  jury->add_flag("--no-times", options->no_times, "Judge stalls by work units alone: alike on every machine");
  jury->add_flag("--json", options->as_json, "Print verdicts as JSON");
  jury->footer("Exit code 1 if a scene fails. src/tools/jury/README.md says what each failure is.");
  jury->callback([options, &context] { run_jury(*options, context); });
}

}  // namespace carom::tools
