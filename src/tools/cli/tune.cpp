// `carom tune SCENE`: which settings err least within so many milliseconds a frame, on this machine: what it asks and
// says.
#include "tune/tune.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <tuple>

#include "cli/commands.h"
#include "cli/run_output.h"
#include "cli/scene_choice.h"
#include "cli/table.h"
#include "host/drawings.h"
#include "host/system.h"
#include "report/plot.h"
#include "scenefile/scenefile.h"

namespace carom::tools {
namespace {

using tune::ErrorKind;
using tune::Measured;
using tune::Question;
using tune::Result;

struct TuneOptions {
  std::string scene, error, json, code, svg;
  std::vector<std::string> sets;
  double budget = 2, frame = 60, seconds = 0, within = 20;
  int repeats = 3;
  std::uint32_t threads = 1;
  bool quiet = false;
};

const std::vector<ErrorKind> kKinds = {ErrorKind::truth,  ErrorKind::pose, ErrorKind::drift,
                                       ErrorKind::energy, ErrorKind::gap,  ErrorKind::laws};

ErrorKind kind_from(const TuneOptions& options, bool is_challenge) {
  if (options.error.empty()) return is_challenge ? ErrorKind::truth : ErrorKind::pose;
  std::string names;
  for (const ErrorKind kind : kKinds) {
    if (options.error == tune::name_of(kind)) {
      if (kind == ErrorKind::truth && !is_challenge)
        throw Error(
            "scene " + options.scene + " has no closed form to be judged by",
            "leave --error away, or choose pose, drift, energy, gap or laws; `carom accuracy list` shows scenes "
            "with a truth");
      return kind;
    }
    names += (names.empty() ? "" : ", ") + std::string(tune::name_of(kind));
  }
  throw Error("--error " + options.error + " is not known", "give one of " + names);
}

Question question_from(const TuneOptions& options) {
  Question q;
  for (const accuracy::Challenge& c : accuracy::all_challenges())
    if (c.scene.name == options.scene && !(c.reference_dt > 0)) q.challenge = &c;
  q.scene = q.challenge ? &q.challenge->scene : nullptr;
  if (!q.scene) {
    for (const accuracy::Challenge& c : accuracy::all_challenges())
      if (c.scene.name == options.scene) q.scene = &c.scene;
    if (!q.scene) q.scene = &chosen_scene(options.scene);
  }
  q.settings.values = values_from(options.sets);
  if (is_scene_file(options.scene)) q.settings.mesh_path = options.scene;
  q.kind = kind_from(options, q.challenge != nullptr);
  q.kind_chosen = !options.error.empty();
  q.seconds = options.seconds > 0 ? options.seconds : std::min(q.scene->seconds, 10.0);
  if (q.challenge) q.seconds = options.seconds > 0 ? options.seconds : q.scene->seconds;
  q.seconds_chosen = options.seconds > 0;
  q.patience = options.within;
  q.frame_rate = options.frame;
  q.budget_ms = options.budget;
  q.repeats = options.repeats;
  q.threads = options.threads;
  return q;
}

std::string error_text(double error, const char* unit) {
  return std::isfinite(error) ? format("%.2g%s%s", error, *unit ? " " : "", unit) : "none";
}

std::string unit_of(const Question& q, const Result& a) {
  return a.kind == ErrorKind::truth ? q.challenge->metrics.front().unit : tune::unit_of(a.kind);
}

void print_front(const Question& q, const Result& a) {
  const std::string unit = unit_of(q, a);
  std::vector<std::vector<std::string>> rows = {{"", "ms a frame", "worst", "error", "settings"}};
  const auto add = [&](const std::string& mark, const Measured& m) {
    rows.push_back(
        {mark, format("%.3g", m.ms), format("%.3g", m.worst_ms), error_text(m.error, unit.c_str()), m.setting.text()});
  };
  for (std::size_t i = 0; i < a.front.size(); ++i)
    add(static_cast<int>(i) == a.pick ? "pick" : a.front[i].ms > q.budget_ms ? "over" : "", a.front[i]);
  const auto own = std::find_if(a.all.begin(), a.all.end(), [](const Measured& m) { return m.is_default; });
  const bool on_front = std::any_of(a.front.begin(), a.front.end(), [](const Measured& m) { return m.is_default; });
  if (own != a.all.end() && !on_front) add("default", *own);
  std::printf("%s\n", table(rows, {false, true, true, true}).c_str());
}

/// What half the error costs, and what half the time would.
void print_margins(const Question& q, const Result& a) {
  const Measured& pick = a.front[static_cast<std::size_t>(a.pick)];
  const std::string unit = unit_of(q, a);
  for (const Measured& m : a.front)
    if (m.error <= pick.error / 2) {
      std::printf("Half the error: +%.3g ms a frame (%s, %s)\n", m.ms - pick.ms,
                  error_text(m.error, unit.c_str()).c_str(), m.setting.text().c_str());
      break;
    }
  for (auto m = a.front.rbegin(); m != a.front.rend(); ++m)
    if (m->ms <= pick.ms / 2) {
      std::printf("Half the time: %.3g times the error (%.3g ms, %s)\n", m->error / pick.error, m->ms,
                  m->setting.text().c_str());
      break;
    }
}

double own_ms(const Result& a) {
  for (const Measured& m : a.all)
    if (m.is_default) return m.ms;
  return 0;
}

/// What a setting does that no motion may.
std::string offences_text(const tune::Offences& o) {
  return format("sinks %.2g m, joints off by %.2g m, Coulomb's law by %.2g m/s, energy by %.2g J/kg", o.sink, o.joints,
                o.cone, o.energy);
}

void print_chaos(const Result& a) {
  std::printf(
      "This scene is chaotic: its two finest runs end up %.2g m from each other (rms), which is as far as any setting "
      "is "
      "from them.\n",
      a.spread);
  if (a.kind != ErrorKind::laws) {
    std::printf("You asked for this error all the same; its figures are those of one run among many.\n");
    return;
  }
  std::printf("Poses say nothing then. Compared instead: what no motion may do, as lengths.\n");
  for (const Measured& m : a.all)
    if (m.is_default) std::printf("  default: %s\n", offences_text(m.offences).c_str());
  if (a.pick >= 0)
    std::printf("  pick: %s\n", offences_text(a.front[static_cast<std::size_t>(a.pick)].offences).c_str());
}

void print_counts(const Question& q, const Result& a) {
  std::printf("%d settings tried, %d stopped as too slow", a.tried, a.too_dear);
  if (a.let_fall) std::printf(", %d rejected because a standing object fell", a.let_fall);
  if (a.left_out) std::printf(", %d skipped (--within %g)", a.left_out, q.patience);
  std::printf(".\n");
  if (a.seconds < q.seconds)
    std::printf("Judged by the first %.2g of %g s: all of it takes more than %g s (--within, or --seconds).\n",
                a.seconds, q.seconds, q.patience);
}

/// Of times and of errors each: other work on the machine changes the one, chaos the other.
std::string verdict_on_fresh(const Measured& pick, const Result& a) {
  const bool time = tune::holds(pick.ms, a.fresh.ms), error = tune::errors_agree(pick, a.fresh);
  if (time && error) return "within a factor of two of what was said";
  std::string text = "NOT within a factor of two of what was said";
  if (!time) text += "; the time differs: is this machine busy?";
  if (!error) text += a.chaotic ? "; runs of a chaotic scene differ so much." : "; the error differs.";
  return text + " Try more --repeats";
}

void print_result(const Question& q, const Result& a) {
  if (a.chaotic)
    print_chaos(a);
  else if (a.floor > 0)
    std::printf("Differences below %.2g %s cannot be resolved: that is the error of the reference run.\n", a.floor,
                tune::unit_of(a.kind));
  print_front(q, a);
  print_counts(q, a);
  if (a.pick < 0) {
    if (a.front.empty())
      std::printf(a.let_fall
                      ? "No setting that is as cheap lets stand what stands.\n"
                      : "No setting gave a result: they take more than several times the budget, or leave the finite "
                        "world. The library's own takes %.3g ms a frame.\n",
                  own_ms(a));
    else if (a.front.front().ms > 4 * q.budget_ms)
      std::printf("Nothing is anywhere near %.3g ms a frame; ask with a larger --budget.\n", q.budget_ms);
    else
      std::printf("Nothing fits into %.3g ms a frame: the cheapest that errs less than all cheaper ones takes %.3g.\n",
                  q.budget_ms, a.front.front().ms);
    return;
  }
  const Measured& pick = a.front[static_cast<std::size_t>(a.pick)];
  const std::string unit = unit_of(q, a);
  std::printf("Pick for %.3g ms a frame at %g Hz: %s\n", q.budget_ms, q.frame_rate, pick.setting.text().c_str());
  print_margins(q, a);
  std::string error = error_text(a.fresh.error, unit.c_str());
  if (a.chaotic)
    error += format(" (runs: %s to %s)", error_text(a.fresh.least_error, unit.c_str()).c_str(),
                    error_text(a.fresh.most_error, unit.c_str()).c_str());
  std::printf("Run once more in a new world: %.3g ms, error %s: %s\n", a.fresh.ms, error.c_str(),
              verdict_on_fresh(pick, a).c_str());
}

nlohmann::json to_json(const Measured& m) {
  nlohmann::json dials = nlohmann::json::object();
  for (const auto& [dial, value] : m.setting.dials) dials[dial] = value;
  nlohmann::json j = {
      {"steps_per_frame", m.setting.steps_per_frame}, {"dials", dials}, {"ms", m.ms}, {"worst_ms", m.worst_ms}};
  j["error"] = std::isfinite(m.error) ? nlohmann::json(m.error) : nlohmann::json();
  j["fallen"] = m.fallen;
  j["offences"] = {{"sink", m.offences.sink},
                   {"joints", m.offences.joints},
                   {"cone", m.offences.cone},
                   {"energy", m.offences.energy}};
  return j;
}

void write_json(const std::string& path, const Question& q, const Result& a) {
  nlohmann::json j = {{"scene", q.scene->name},         {"seconds", q.seconds},
                      {"frame_rate", q.frame_rate},     {"budget_ms", q.budget_ms},
                      {"error", tune::name_of(a.kind)}, {"unit", unit_of(q, a)},
                      {"chaotic", a.chaotic},           {"floor", a.floor},
                      {"judged_seconds", a.seconds},    {"tried", a.tried},
                      {"let_fall", a.let_fall},         {"left_out", a.left_out},
                      {"too_dear", a.too_dear}};
  j["front"] = nlohmann::json::array();
  for (const Measured& m : a.front) j["front"].push_back(to_json(m));
  j["pick"] = a.pick < 0 ? nlohmann::json() : to_json(a.front[static_cast<std::size_t>(a.pick)]);
  j["fresh"] = a.pick < 0 ? nlohmann::json() : to_json(a.fresh);
  CsvFile file(path);
  file.out() << j.dump(2) << '\n';
  file.close();
}

/// The value of a dial as a number, whatever it was set by.
double number_of(const carom_dial_info& info, const std::string& value) {
  for (std::uint32_t i = 0; i < info.choice_count; ++i)
    if (value == info.choices[i]) return i;
  return std::strtod(value.c_str(), nullptr);
}

/// Every dial of a setting, those of its preset first, and how it is called there.
std::vector<std::tuple<carom_dial_info, double, std::string>> dials_of(const tune::Setting& setting) {
  std::vector<std::tuple<carom_dial_info, double, std::string>> list;
  const auto presets = all_presets();
  for (const auto& [dial, value] : setting.dials)
    for (const carom_dial_info& info : all_dials()) {
      double number = 0;
      if (dial == info.name)
        list.emplace_back(info, number_of(info, value), value);
      else if (dial == "preset") {
        const auto preset =
            static_cast<std::uint32_t>(std::find(presets.begin(), presets.end(), value) - presets.begin());
        if (carom_preset_get_dial(preset, info.dial, &number, nullptr) == CAROM_OK)
          list.emplace_back(info, number, "preset " + value);
      }
    }
  return list;
}

void write_code(const std::string& path, const Question& q, const Result& a) {
  CsvFile file(path);
  const Measured& pick = a.front[static_cast<std::size_t>(a.pick)];
  const std::string unit = unit_of(q, a);
  file.out() << "/* carom tune " << q.scene->name << ": " << format("%.3g", pick.ms) << " ms a frame, error "
             << error_text(pick.error, unit.c_str()) << " (" << tune::name_of(a.kind) << "). Step "
             << pick.setting.steps_per_frame << " times a frame by 1.0 / "
             << format("%g", q.frame_rate * pick.setting.steps_per_frame) << " s. */\n"
             << "static const struct {\n  uint32_t dial;\n  double value;\n} tuned[] = {\n";
  for (const auto& [info, number, value] : dials_of(pick.setting)) {
    std::string upper = info.name;
    for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    file.out() << "    {CAROM_DIAL_" << upper << ", " << format("%.17g", number) << "}, /* " << value << " */\n";
  }
  if (pick.setting.dials.empty()) file.out() << "    {CAROM_DIAL_SUBSTEPS, 4}, /* all dials at their defaults */\n";
  file.out() << "};\n";
  file.close();
}

void write_plot(const std::string& path, const Question& q, const Result& a) {
  report::LinePlot plot;
  plot.title = q.scene->name + ": error against time";
  plot.x = {"ms a frame", report::Scale::log, false, {}};
  const std::string unit = unit_of(q, a);
  plot.y = {"error (" + std::string(tune::name_of(a.kind)) + (unit.empty() ? "" : ", " + unit) + ")",
            report::Scale::log,
            false,
            {}};
  report::Series front{"front", {}, 0, false};
  for (const Measured& m : a.front) front.points.push_back({m.ms, m.error});
  plot.series.push_back(front);
  int colour = 1;
  for (const char* solver : {"severity", "soft_step", "auto", "direct"}) {
    report::Series series{solver, {}, colour++, false};
    for (const Measured& m : a.all)
      for (const auto& [dial, value] : m.setting.dials)
        if (dial == "solver" && value == solver && m.setting.steps_per_frame == 1 && m.setting.dials.size() == 2)
          series.points.push_back({m.ms, m.error});
    if (series.points.size() > 1) plot.series.push_back(series);
  }
  plot.marks.push_back({q.budget_ms, format("budget %.3g ms", q.budget_ms)});
  plot.note =
      "carom tune " + q.scene->name + format(", %d settings over %g s at %g Hz", a.tried, q.seconds, q.frame_rate);
  write_drawing(path, report::draw(plot));
}

/// A line that rewrites itself on a terminal; elsewhere a line each tenth of the way.
class TuneProgress {
 public:
  explicit TuneProgress(bool quiet) : quiet_(quiet), rewrites_(errors_are_seen()) {}
  void operator()(int done, int total, const std::string& what) {
    if (quiet_) return;
    const int tenth = 10 * done / total;
    if (rewrites_)
      std::fprintf(stderr, "\r  %s %d of about %d  %-70.70s", bar(static_cast<double>(done) / total, 20).c_str(), done,
                   total, what.c_str());
    else if (tenth > tenths_)
      std::fprintf(stderr, "  %d %%: %s\n", 10 * tenth, what.c_str());
    tenths_ = std::max(tenth, tenths_);
  }
  ~TuneProgress() {
    if (rewrites_ && !quiet_) std::fprintf(stderr, "\r%*s\r", 120, "");
  }

 private:
  bool quiet_, rewrites_;
  int tenths_ = -1;
};

void run_tune(const TuneOptions& options, Context& context) {
  if (!(options.budget > 0)) throw Error("--budget must be more than 0", "give milliseconds, e.g. --budget 2");
  if (!(options.frame > 0 && options.frame <= 1e4))
    throw Error("--frame is out of range", "give frames per second, e.g. 60");
  if (options.repeats < 1 || options.repeats > 99) throw Error("--repeats is out of range", "give 1 to 99");
  if (!(options.within >= 0)) throw Error("--within is negative", "give seconds, or 0 for as long as it takes");
  const Question q = question_from(options);
  Engine engine(context.plugins());
  engine.set_threads(q.threads);
  if (!options.quiet) {
    std::printf("%s over %g s at %g Hz, error: %s\n", q.scene->name.c_str(), q.seconds, q.frame_rate,
                q.kind == ErrorKind::truth ? q.challenge->metrics.front().what.c_str() : tune::name_of(q.kind));
    std::fflush(stdout);
  }
  Result a;
  {
    TuneProgress teller(options.quiet);
    a = tune::search(engine, q, [&](int done, int total, const std::string& what) { teller(done, total, what); });
  }
  if (!options.quiet) print_result(q, a);
  if (!options.json.empty()) write_json(options.json, q, a);
  if (!options.svg.empty()) write_plot(options.svg, q, a);
  if (!options.code.empty() && a.pick >= 0) write_code(options.code, q, a);
  if (a.pick < 0) context.exit_code = kExitBadNews;
}

}  // namespace

void add_tune_command(CLI::App& app, Context& context) {
  static TuneOptions options;
  CLI::App* command = app.add_subcommand("tune", "2 ms a frame: which settings err least on a scene?");
  command->add_option("scene", options.scene, "A scene of `carom list` or `carom accuracy list`")->required();
  command->add_option("--budget", options.budget, "ms of computing a frame")->capture_default_str();
  command->add_option("--frame", options.frame, "Frames per second")->capture_default_str();
  command->add_option(
      "--error", options.error,
      "truth (of accuracy scenes), pose, drift, energy, gap or laws; default: truth where there is one, "
      "else pose, or laws where the scene is chaotic");
  command->add_option("--seconds", options.seconds, "Simulated; default: the scene's own, at most 10");
  command
      ->add_option("--within", options.within,
                   "s that the search takes: less of the scene is run, and fewer settings; 0: no bound")
      ->capture_default_str();
  command->add_option("--set", options.sets, "Knob of the scene, NAME=NUMBER (repeatable)")->allow_extra_args(false);
  command->add_option("--repeats", options.repeats, "Runs behind each time on the front")->capture_default_str();
  command->add_option("--threads", options.threads, "Threads of the engine")->capture_default_str();
  command->add_option("--json", options.json, "Write front and pick");
  command->add_option("--code", options.code, "Write the pick as C");
  command->add_option("--svg", options.svg, "Draw error against time")->type_name("FILE.svg|FILE.png");
  command->add_flag("--quiet", options.quiet, "No text");
  command->callback([&context] { run_tune(options, context); });
}

}  // namespace carom::tools
