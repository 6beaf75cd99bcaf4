// The S-table in one run: Carom beside other engines on the same scenes, what a step costs and what it is worth.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <numeric>

#include "../module_reason.h"
#include "table.h"

namespace {

using namespace carom;
using namespace carom::bench;

std::string profile(const Row& row, const Record& record) {
  const double all = std::accumulate(record.stages.begin(), record.stages.end(), 0.0);
  std::string text = row.id + ":";
  for (std::size_t k = 0; k < record.stages.size(); ++k)
    text += std::string(k ? ", " : " ") + carom_stage_name(static_cast<std::uint32_t>(k)) +
            format(" %.1f %%", 100 * record.stages[k] / all);
  return text;
}

/// @return whether Carom kept every body, finite and within the scene
bool run(const std::vector<Row>& rows, const Options& options, Table& table, bool with_profile) {
  std::vector<std::string> profiles;
  bool kept = true;
  for (const Row& row : rows) {
    if (row.rays) continue;
    const std::vector<Record> records = measure(row, options);
    table.add(row, records);
    for (const Record& record : records) {
      if (!record.is_carom) continue;
      kept = kept && !record.end.escaped && !record.end.lost;
      profiles.push_back(profile(row, record));
    }
  }
  if (with_profile && !profiles.empty()) std::printf("\nWhere Carom's time goes:\n\n");
  for (const std::string& line : profiles)
    if (with_profile) std::printf("- %s\n", line.c_str());
  for (const Row& row : rows)
    if (row.rays) table.add(row, measure_rays(row, options, row.rays));
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
  CLI::App app{"Speed and quality of Carom beside other engines on the scenes of the S-table, in one run."};
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
  std::string csv, steps;
  app.add_option("--csv", csv, "File for one line a row and engine");
  app.add_option("--steps", steps, "File for the time of each step");
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
    Table table(csv.empty() ? nullptr : csv.c_str(), steps.empty() ? nullptr : steps.c_str());
    const bool kept = run(rows, options, table, with_profile);
    if (!missing.empty()) std::printf("\nNot in the table:\n\n");
    for (const std::string& line : missing) std::printf("- %s\n", line.c_str());
    return kept ? 0 : 1;
  } catch (const tools::Error& error) {
    std::fprintf(stderr, "s_table: %s\n  what to do: %s\n", error.what(), error.remedy.c_str());
    return 2;
  }
}
