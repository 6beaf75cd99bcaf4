// `carom accuracy`: scenes whose solution is known, and how far from it a world with given dials and step ends.
#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "accuracy/run.h"
#include "cli/accuracy_ask.h"
#include "cli/accuracy_sweep.h"
#include "cli/commands.h"
#include "cli/run_output.h"
#include "cli/table.h"

namespace carom::tools {
namespace {

using accuracy::Challenge;
using accuracy::Metric;
using accuracy::Peer;
using accuracy::Request;
using accuracy::Result;

struct Options {
  std::string scene, preset, dt = "1/60", csv;
  std::vector<std::string> dials, sets;
  double seconds = 0;
  int halvings = 0;
};

/// "1/60" or "0.01".   @throws Error
double step_from(const std::string& text) {
  const auto number = [&](const std::string& part) {
    double value = 0;
    const auto [end, failed] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (failed != std::errc() || end != part.data() + part.size())
      throw Error("--dt " + text + " is not a time step", "give seconds, e.g. --dt 1/60 or --dt 0.01");
    return value;
  };
  const std::size_t slash = text.find('/');
  return slash == std::string::npos ? number(text) : number(text.substr(0, slash)) / number(text.substr(slash + 1));
}

Request request_from(const Options& options) {
  Request request;
  request.settings.values = values_from(options.sets);
  request.preset = options.preset;
  request.dials = options.dials;
  request.dt = step_from(options.dt);
  request.seconds = options.seconds;
  return request;
}

/// All that was set, as it is written on the command line.
std::vector<std::string> settings_of(const Options& options) {
  std::vector<std::string> all = options.dials;
  if (!options.preset.empty()) all.insert(all.begin(), "preset=" + options.preset);
  return all;
}

std::string error_text(double error) { return std::isfinite(error) ? format("%.2g", error) : "none"; }
std::string bound_text(const Metric& metric) {
  return metric.bound == accuracy::kNoBound ? "" : format("%.2g", metric.bound);
}
std::string peer_text(const Peer& peer) {
  return peer.error < 0 ? "" : format("%.2g %s", peer.error, peer.setting.c_str());
}
std::string verdict_text(const Metric& metric, const Result& result, double error) {
  if (result.fell_at >= 0) return format("fell at %.3g s", result.fell_at);
  return metric.bound == accuracy::kNoBound ? "" : error <= metric.bound ? "yes" : "no";
}

/// One row per metric; a column of orders where there are halvings.
void add_rows(std::vector<std::vector<std::string>>& rows, const Challenge& challenge,
              const std::vector<Result>& results) {
  for (std::size_t k = 0; k < results.size(); ++k)
    for (std::size_t i = 0; i < challenge.metrics.size(); ++i) {
      const Metric& metric = challenge.metrics[i];
      const Result& result = results[k];
      const double order = k == 0 ? NAN : accuracy::observed_order(results[k - 1].errors[i], result.errors[i]);
      rows.push_back({i == 0 ? challenge.scene.name : "", i == 0 ? format("1/%.5g", 1 / result.dt) : "",
                      metric.what + (metric.unit.empty() ? "" : ", " + metric.unit), error_text(result.errors[i]),
                      std::isnan(order) ? "" : format("%.1f", order), bound_text(metric),
                      verdict_text(metric, result, result.errors[i]),
                      i == 0 ? format("%.2g", result.ms_per_second) : "", i == 0 ? peer_text(challenge.at_60_hz) : "",
                      i == 0 ? peer_text(challenge.at_any_step) : ""});
    }
}

const std::vector<std::string> kHeader = {
    "scene", "dt", "what", "error", "order", "bound", "within", "ms/s", "best peer at 60 Hz", "best peer at any step"};
const std::vector<bool> kRight = {false, true, false, true, true, true, false, true};

/// One line per metric and step size; cells whose text may hold a comma are quoted.
class ErrorTable {
 public:
  explicit ErrorTable(const std::string& path) : file_(path) {
    file_.out() << "scene,dt,metric,unit,error,bound,within,fell_at,simulated,ms_per_second,best_60,best_60_setting,"
                   "best_any,best_any_setting,dials\n";
  }
  void add(const Challenge& challenge, const Result& result, const std::vector<std::string>& dials) {
    const auto peer = [](const Peer& p) {
      return p.error < 0 ? "," : format("%.17g,\"%s\"", p.error, p.setting.c_str());
    };
    const auto number = [](double x) { return std::isfinite(x) ? format("%.17g", x) : std::string(); };
    std::string set;
    for (const std::string& dial : dials) set += (set.empty() ? "" : " ") + dial;
    for (std::size_t i = 0; i < challenge.metrics.size(); ++i) {
      const Metric& m = challenge.metrics[i];
      file_.out() << challenge.scene.name << ',' << number(result.dt) << ",\"" << m.what << "\"," << m.unit << ','
                  << number(result.errors[i]) << ',' << number(m.bound) << ','
                  << (result.fell_at < 0 && result.errors[i] <= m.bound) << ','
                  << (result.fell_at < 0 ? "" : number(result.fell_at)) << ',' << number(result.simulated) << ','
                  << number(result.ms_per_second) << ',' << (i == 0 ? peer(challenge.at_60_hz) : ",") << ','
                  << (i == 0 ? peer(challenge.at_any_step) : ",") << ",\"" << set << "\"\n";
    }
  }
  void finish() { file_.close(); }

 private:
  CsvFile file_;
};

void describe(const Challenge& challenge) {
  std::printf("%s: %s\n  look for: %s\n  truth: %s\n  %g s\n", challenge.scene.name.c_str(),
              challenge.scene.summary.c_str(), challenge.scene.look_for.c_str(), challenge.reference.c_str(),
              challenge.scene.seconds);
  for (const Knob& knob : challenge.scene.knobs)
    std::printf("  --set %s=%g  %s (%g to %g%s%s)\n", knob.name.c_str(), knob.initial, knob.help.c_str(), knob.min,
                knob.max, knob.unit.empty() ? "" : " ", knob.unit.c_str());
  std::printf("\n");
}

void run_accuracy(const Options& options, Context& context) {
  if (options.halvings < 0 || options.halvings > 10)
    throw Error("--steps-halved is out of range", "give how often to halve the step, 0 to 10");
  if (!(options.seconds >= 0)) throw Error("--seconds is out of range", "give seconds, more than 0");
  const bool all = options.scene == "all";
  if (all && !options.sets.empty()) throw Error("--set goes with one scene", "name the scene in place of 'all'");
  std::vector<const Challenge*> chosen;
  if (all)
    for (const Challenge& challenge : accuracy::all_challenges()) chosen.push_back(&challenge);
  else
    chosen.push_back(&accuracy::find_challenge(options.scene));
  const Request request = request_from(options);
  std::optional<ErrorTable> csv;
  if (!options.csv.empty()) csv.emplace(options.csv);
  if (!all) describe(*chosen[0]);
  Engine engine(context.plugins());
  std::vector<std::vector<std::string>> rows{kHeader};
  std::vector<std::string> story;
  std::size_t held = 0;
  for (const Challenge* challenge : chosen) {
    if (all) std::fprintf(stderr, "  running: %s\n", challenge->scene.name.c_str());
    const std::vector<Result> results = accuracy::run_halved(engine, *challenge, request, options.halvings);
    add_rows(rows, *challenge, results);
    held += accuracy::within_bounds(*challenge, results.back());
    story = results.back().story;
    if (csv)
      for (const Result& result : results) csv->add(*challenge, result, settings_of(options));
  }
  if (csv) csv->finish();
  std::printf("%s", table(rows, kRight).c_str());
  if (!all)
    for (const std::string& line : story) std::printf("  %s\n", line.c_str());
  else
    std::printf("\n%zu of %zu scenes within their bounds%s\n", held, chosen.size(),
                options.halvings > 0 ? " at the smallest step" : "");
  if (held < chosen.size()) context.exit_code = kExitBadNews;
}

void list_challenges() {
  std::vector<std::vector<std::string>> rows = {{"scene", "what happens", "error", "bound", "truth"}};
  for (const Challenge& challenge : accuracy::all_challenges())
    for (std::size_t i = 0; i < challenge.metrics.size(); ++i) {
      const Metric& metric = challenge.metrics[i];
      rows.push_back({i == 0 ? challenge.scene.name : "", i == 0 ? challenge.scene.summary : "",
                      metric.what + (metric.unit.empty() ? "" : ", " + metric.unit), bound_text(metric),
                      i == 0 ? challenge.reference : ""});
    }
  std::printf("%s\nRun one with: carom accuracy run SCENE|all [--dial name=value] [--dt 1/60] [--steps-halved K]\n",
              table(rows, {false, false, false, true}).c_str());
}

}  // namespace

void add_accuracy_command(CLI::App& app, Context& context) {
  CLI::App* command =
      app.add_subcommand("accuracy", "Scenes with a known solution: how far off a world ends, and what it costs");
  command->require_subcommand(1);
  command->fallthrough();
  command->add_subcommand("list", "List the scenes, their errors and bounds")->callback(list_challenges);

  const auto options = std::make_shared<Options>();
  CLI::App* run = command->add_subcommand("run", "Run a scene, or all, and print error, bound, best peer and cost");
  run->add_option("SCENE", options->scene, "Which scene, or all; `carom accuracy list` shows them")->required();
  run->add_option("--preset", options->preset, "fast, balanced, accurate or reference; --dial comes after")
      ->type_name("NAME");
  run->add_option("--dial", options->dials, "A dial of the world, repeatable; `carom dials` lists them")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  run->add_option("--set", options->sets, "A number of the scene, repeatable")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  run->add_option("--dt", options->dt, "Time step")->type_name("S")->capture_default_str();
  run->add_option("--steps-halved", options->halvings, "Run again at half the step, K times; shows the observed order")
      ->type_name("K")
      ->capture_default_str();
  run->add_option("--seconds", options->seconds, "How long to simulate; default: what the scene asks for")
      ->type_name("S");
  run->add_option("--csv", options->csv, "Write every error as a table")->type_name("FILE");
  run->footer(
      "Errors are judged against the bounds; exit code 1 if one is missed. The peers' figures were measured for\n"
      "this project, each engine at the best of its settings.");
  run->callback([options, &context] { run_accuracy(*options, context); });
  add_ask_command(*command, context);
  add_sweep_and_report_commands(*command, context);
}

}  // namespace carom::tools
