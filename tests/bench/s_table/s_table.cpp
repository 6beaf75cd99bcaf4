// The S-table in one run: Carom beside Bullet and ODE on the same scenes, what a step costs and what it is worth.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "../module_reason.h"
#include "rays.h"

namespace {

using namespace carom;
using namespace carom::bench;

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

/// What became of the scene, in words.
std::string outcome(const Row& row, const Record& record) {
  std::string text;
  const auto say = [&](const std::string& what) { text += (text.empty() ? "" : "; ") + what; };
  const tools::Standing& s = record.end.standing;
  if (s.blocks && !s.fallen)
    say("stands, drop " + format("%.1f", 1e3 * s.drop) + " mm, drift " + format("%.1f mm", 1e3 * s.drift));
  if (s.fallen)
    say(std::to_string(s.fallen) + " of " + std::to_string(s.blocks) + " fallen, the first by " +
        format("%.1f s", record.fell_by) + ", drop " + format("%.1f", s.drop) + " m, drift " +
        format("%.1f m", s.drift));
  if (record.end.flight_error > 0) say(format("%.3f m off the parabola", record.end.flight_error));
  if (record.peak_gap > 0)
    say("joints gape by " + format("%.2f", 1e3 * record.mean_gap) + " mm, at most " +
        format("%.1f mm", 1e3 * record.peak_gap));
  if (row.memory) say(format("%.0f bytes a body", record.bytes_per_body));
  if (record.best.size() < record.planned)
    say("cut after " + std::to_string(record.best.size()) + " of " + std::to_string(record.planned) + " steps");
  return text;
}

void print_row(const Row& row, const Record& record, const Record* reference) {
  const auto settle = static_cast<std::size_t>(std::lround(row.settle / kDt));
  const std::size_t steps = record.best.size(), from = std::min(settle, steps - 1);
  std::string ratio = "-", target = "-";
  if (row.memory && reference) {
    ratio = format("%.2f", record.bytes_per_body / reference->bytes_per_body);
  } else if (reference) {  // over the steps that both did
    const std::size_t both = std::min(steps, reference->best.size()), common = std::min(settle, both - 1);
    ratio = format("%.2f", record.mean_ms(common, both) / reference->mean_ms(common, both));
  }
  if (record.is_carom && row.target > 0) target = format("%g", row.target);
  if (record.is_carom && row.bullet > 0) target += format(" (%.2g)", row.target / row.bullet);
  const std::string points = record.contact_points == kNotTold ? "-" : std::to_string(record.contact_points);
  std::printf("| %s | %s | %.3f | %.3f | %.2f | %.2f | %.2f | %s | %s | %.1f / %.2f | %.0f | %.1e | %s | %zu, %zu | %s |\n",
              row.id.c_str(), record.engine.c_str(), record.mean_ms(from, steps),
              record.mean_ms(steps - (steps - from + 2) / 3, steps), record.p99_ms(from), record.worst_ms(from),
              record.first_ms(), ratio.c_str(), target.c_str(), 1e3 * record.end.max_penetration,
              1e3 * record.end.mean_penetration, 1e3 * record.peak_penetration, record.end.mean_energy, points.c_str(),
              record.end.escaped, record.end.lost, outcome(row, record).c_str());
  std::fflush(stdout);
}

void print_rays(const std::vector<Row>& rows, const Options& options) {
  bool first = true;
  for (const Row& row : rows) {
    if (!row.rays) continue;
    if (first)
      std::printf(
          "\n| row | engine | ms, all rays | first time | of Bullet | target (of Bullet) | hits | unlike Carom's | "
          "apart from Carom's, max mm | rays apart by 1 mm |\n|---|---|---|---|---|---|---|---|---|---|\n");
    first = false;
    const std::vector<RayRecord> records = measure_rays(row, options, row.rays);
    const auto bullet = std::find_if(records.begin(), records.end(),
                                     [](const RayRecord& r) { return r.engine.rfind("Bullet", 0) == 0; });
    for (const RayRecord& r : records)
      std::printf("| %s | %s | %.1f | %.1f | %s | %s | %zu | %zu | %.2g | %zu |\n", row.id.c_str(), r.engine.c_str(),
                  1e3 * r.best, 1e3 * r.first,
                  bullet == records.end() ? "-" : format("%.4f", r.best / bullet->best).c_str(),
                  r.is_carom ? (format("%g", row.target) + format(" (%.2g)", row.target / row.bullet)).c_str() : "-",
                  r.hits, r.unlike, 1e3 * r.farthest, r.apart);
    std::fflush(stdout);
  }
}

std::string profile(const Row& row, const Record& record) {
  const double all = std::accumulate(record.stages.begin(), record.stages.end(), 0.0);
  std::string text = row.id + ":";
  for (std::size_t k = 0; k < record.stages.size(); ++k)
    text += std::string(k ? ", " : " ") + carom_stage_name(static_cast<std::uint32_t>(k)) +
            format(" %.1f %%", 100 * record.stages[k] / all);
  return text;
}

/// @return whether Carom kept every body, finite and within the scene
bool run(const std::vector<Row>& rows, const Options& options, bool with_profile) {
  const bool any_steps = std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.rays == 0; });
  if (any_steps)
    std::printf(
        "| row | engine | ms/step | last third | p99 | worst | first | of Bullet | target (of Bullet) | penetration max / "
        "mean mm | peak mm | J/body | points | escaped, not finite | outcome |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  std::vector<std::string> profiles;
  bool kept = true;
  for (const Row& row : rows) {
    if (row.rays) continue;
    const std::vector<Record> records = measure(row, options);
    const auto bullet =
        std::find_if(records.begin(), records.end(), [](const Record& r) { return r.engine.rfind("Bullet", 0) == 0; });
    for (const Record& record : records) {
      print_row(row, record, bullet == records.end() ? nullptr : &*bullet);
      if (!record.is_carom) continue;
      kept = kept && !record.end.escaped && !record.end.lost;
      profiles.push_back(profile(row, record));
    }
  }
  if (with_profile && !profiles.empty()) std::printf("\nWhere Carom's time goes:\n\n");
  for (const std::string& line : profiles)
    if (with_profile) std::printf("- %s\n", line.c_str());
  return kept;
}

const std::map<std::string, std::string>& modules() {
  static const std::map<std::string, std::string> paths = {CAROM_ENGINE_MODULES};
  return paths;
}

/// @param engines  by name   @return of each that is not loaded its name and why
std::vector<std::string> load_peers(const std::vector<std::string>& engines, Options& options) {
  std::vector<std::string> missing;
  for (const std::string& name : engines) {
    if (name == "carom") continue;
    const std::string& path = modules().at(name);
    std::string reason = reason_missing(path);
    if (reason.empty()) {
      const PeerEngine engine = load_engine(path.c_str());
      if (engine.threads >= options.threads)
        options.peers.push_back(engine);
      else
        reason = "its steps have one thread";
    }
    if (!reason.empty()) missing.push_back(name + ": " + reason);
  }
  return missing;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Speed and quality of Carom beside Bullet and ODE on the scenes of the S-table, in one run."};
  app.footer("Exit codes: 0 done; 1 Carom lost a body; 2 could not run.");
  Options options;
  options.plugins = {CAROM_PLUGIN_DIR};
  std::vector<std::string> names, engines;
  std::vector<std::string> known = {"carom"};
  for (const auto& [name, path] : modules()) known.push_back(name);
  bool with_profile = false;
  app.add_option("ROWS", names, "Rows of the table, or SCENE:knob=value,... of `carom list`; default: the whole table");
  app.add_option("--engines", engines, "Which engines; default: all")->check(CLI::IsMember(known));
  app.add_option("--seconds", options.seconds, "Simulated time; default: the row's")->check(CLI::Range(0.01, 3600.0));
  app.add_option("--repeats", options.repeats, "Runs of each engine, in turn")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  app.add_option("--budget", options.budget,
                 "CPU seconds an engine may take for one run of a row; then it is cut short")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--dial", options.dials, "name=value, of Carom's world (repeatable)")->allow_extra_args(false);
  app.add_option("--plugins", options.plugins, "Folders with shape plugins");
  app.add_option("--threads", options.threads, "That a step may use; with several, times are of the clock on the wall")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  app.add_flag("--profile", with_profile, "Say which stages of Carom's step take the time");
  app.add_flag("--quick", options.quick, "Small scenes, half a second, once: does it run at all?");
  CLI11_PARSE(app, argc, argv);
  try {
    if (options.quick) options.repeats = 1;
    if (engines.empty()) {
      engines = known;  // with one thread Rapier without threads stands for it
      if (options.threads == 1) std::erase(engines, "rapier_threads");
    }
    options.carom = std::find(engines.begin(), engines.end(), "carom") != engines.end();
    const std::vector<std::string> missing = load_peers(engines, options);
    std::vector<Row> rows = names.empty() ? s_table() : std::vector<Row>();
    for (const std::string& name : names) rows.push_back(find_row(name));
    const bool kept = run(rows, options, with_profile);
    print_rays(rows, options);
    if (!missing.empty()) std::printf("\nNot in the table:\n\n");
    for (const std::string& line : missing) std::printf("- %s\n", line.c_str());
    return kept ? 0 : 1;
  } catch (const tools::Error& error) {
    std::fprintf(stderr, "s_table: %s\n  what to do: %s\n", error.what(), error.remedy.c_str());
    return 2;
  }
}
