// `carom sweep SCENE`: one scene under many settings, a line of JSON for each. A line follows from its settings alone, so
// any machine may make any of them: a shard is a run of lines, and shards one after the other are the whole, to the byte.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/scene_choice.h"
#include "host/files.h"
#include "scenes/run.h"

namespace carom::tools {
namespace {

constexpr std::size_t kMostLines = 10'000'000;

struct SweepOptions {
  SceneChoice choice;
  std::vector<std::string> over, over_dials;
  std::string out, shard = "1/1";
};

/// What is varied: a parameter of the scene or a dial, and its values as they were written.
struct Varied {
  std::string name;
  bool is_dial;
  std::vector<std::string> values;
};

/// "1,2.5,4" or "1..100", which is each whole number.
Varied varied_from(const std::string& text, bool is_dial) {
  const auto refuse = [&](const std::string& why) {
    throw Error((is_dial ? "--over-dial " : "--over ") + text + " " + why,
                "write NAME=VALUE,VALUE,... or NAME=FIRST..LAST of whole numbers");
  };
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) refuse("has no name or no values");
  Varied v{text.substr(0, equals), is_dial, {}};
  const std::string values = text.substr(equals + 1);
  if (const std::size_t dots = values.find(".."); dots != std::string::npos) {
    char *end = nullptr, *last_end = nullptr;
    const std::string last_word = values.substr(dots + 2);
    const long long first = std::strtoll(values.c_str(), &end, 10),
                    last = std::strtoll(last_word.c_str(), &last_end, 10);
    if (end != values.c_str() + dots || last_word.empty() || *last_end || last < first ||
        last - first >= static_cast<long long>(kMostLines))
      refuse("is no range of whole numbers");
    for (long long k = first; k <= last; ++k) v.values.push_back(std::to_string(k));
    return v;
  }
  for (std::size_t at = 0; at <= values.size();) {
    const std::size_t comma = std::min(values.find(',', at), values.size());
    if (comma == at) refuse("has an empty value");
    v.values.push_back(values.substr(at, comma - at));
    at = comma + 1;
  }
  return v;
}

/// Of "i/n": lines [first, last) of so many.
std::pair<std::size_t, std::size_t> lines_of(const std::string& shard, std::size_t lines) {
  unsigned long long i = 0, n = 0;
  char rest = 0;
  if (std::sscanf(shard.c_str(), "%llu/%llu%c", &i, &n, &rest) != 2 || i < 1 || i > n || n > kMostLines)
    throw Error("--shard " + shard + " is no shard", "write --shard i/n, i from 1 to n: n machines take one i each");
  return {lines * (i - 1) / n, lines * i / n};
}

/// A name for what is asked: a file of another sweep is none to go on from.
std::string key_of(const SweepOptions& options) {
  const SceneChoice& c = options.choice;
  nlohmann::json all = {{"scene", c.scene},   {"mesh", c.mesh},       {"preset", c.preset},
                        {"dials", c.dials},   {"sets", c.sets},       {"forbidden", c.forbidden},
                        {"forced", c.forced}, {"over", options.over}, {"dials over", options.over_dials}};
  for (const auto& [name, value] :
       {std::pair("n", c.n), std::pair("seconds", c.seconds), std::pair("dt", c.dt), std::pair("accuracy", c.accuracy)})
    if (value) all[name] = *value;
  std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
  for (const char byte : all.dump()) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  char key[17];
  std::snprintf(key, sizeof key, "%016llx", static_cast<unsigned long long>(hash));
  return key;
}

std::string line_of(const SweepOptions& options, const std::vector<Varied>& varied, std::size_t line,
                    Context& context) {
  SceneChoice choice = options.choice;
  nlohmann::json about = {{"line", line}, {"sweep", key_of(options)}};
  std::size_t rest = line;
  for (std::size_t k = varied.size(); k-- > 0;) {  // the last that is named changes fastest
    const Varied& v = varied[k];
    const std::string& value = v.values[rest % v.values.size()];
    rest /= v.values.size();
    (v.is_dial ? choice.dials : choice.sets).push_back(v.name + "=" + value);
    about[v.is_dial ? "dials" : "set"][v.name] = value;
  }
  const Scene& scene = chosen_scene(choice.scene);
  const double seconds = choice.seconds.value_or(scene.seconds), dt = choice.dt.value_or(scene.dt);
  check_times(seconds, dt);
  Engine engine(context.plugins());
  engine.set_threads(choice.threads);
  Stage stage(engine);
  const std::unique_ptr<Observer> observer = set_up(choice, scene, stage);
  const RunSummary run = simulate(stage, observer.get(), seconds, dt);
  char hash[17];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(run.hash));
  about["scene"] = scene.name, about["seconds"] = run.simulated, about["steps"] = run.steps, about["hash"] = hash;
  about["worst_penetration"] = run.worst_penetration, about["faults"] = run.faults;
  for (const KindSummary& k : where_it_ended(stage))
    about["ended"][k.kind] = {
        {"count", k.count}, {"moving", k.moving}, {"escaped", k.escaped}, {"not_finite", k.not_finite},
        {"low", k.low},     {"mean", k.mean},     {"high", k.high},       {"fastest", k.fastest}};
  return about.dump() + "\n";
}

/// Lines that a file has already, of this sweep: those of a run that was stopped. A last line that was cut off goes.
std::size_t lines_done(const std::string& path, const std::string& key, std::size_t first, std::size_t last) {
  if (!std::filesystem::exists(path)) return 0;
  const std::string text = read_file(path, "give --out a file that can be read, or a new one");
  std::size_t done = 0, at = 0;
  for (std::size_t end; (end = text.find('\n', at)) != std::string::npos; at = end + 1, ++done) {
    const nlohmann::json line = nlohmann::json::parse(text.substr(at, end - at), nullptr, false);
    if (!line.is_object() || line.value("line", ~std::size_t{0}) != first + done || first + done >= last ||
        line.value("sweep", "") != key)
      throw Error(path + " has lines of something else, the first of them line " + std::to_string(done + 1),
                  "give --out a new file, or that of the same sweep and shard");
  }
  if (at < text.size()) std::filesystem::resize_file(path, at);
  return done;
}

void sweep_scene(const SweepOptions& options, Context& context) {
  std::vector<Varied> varied;
  for (const std::string& text : options.over) varied.push_back(varied_from(text, false));
  for (const std::string& text : options.over_dials) varied.push_back(varied_from(text, true));
  std::size_t lines = 1;
  for (const Varied& v : varied) {
    lines *= v.values.size();
    if (lines > kMostLines)
      throw Error("the sweep has more than " + std::to_string(kMostLines) + " lines",
                  "vary less, or in several sweeps");
  }
  const auto [first, last] = lines_of(options.shard, lines);
  if (!options.out.empty()) check_output(options.out);
  std::ofstream file;
  std::size_t next = first;
  if (!options.out.empty()) {
    next += lines_done(options.out, key_of(options), first, last);
    file.open(options.out, std::ios::binary | std::ios::app);
  }
  for (; next < last; ++next) {
    const std::string line = line_of(options, varied, next, context);
    if (options.out.empty()) {
      std::fputs(line.c_str(), stdout);
      continue;
    }
    file << line << std::flush;
    if (!file)
      throw Error("line " + std::to_string(next) + " could not be written to " + options.out, "free space on the disk");
  }
}

}  // namespace

void add_sweep_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<SweepOptions>();
  CLI::App* sweep = app.add_subcommand(
      "sweep", "Simulate a scene under many settings: a line of JSON for each, the same on any machine");
  add_scene_options(*sweep, options->choice, "How long to simulate; default: the scene's");
  sweep->add_option("--over", options->over, "A parameter of the scene that takes each of these values, repeatable")
      ->type_name("NAME=V,V,...|NAME=FIRST..LAST")
      ->allow_extra_args(false);
  sweep->add_option("--over-dial", options->over_dials, "Likewise a dial")
      ->type_name("NAME=V,V,...|NAME=FIRST..LAST")
      ->allow_extra_args(false);
  sweep
      ->add_option("--shard", options->shard,
                   "The i-th of n parts, by lines: n machines take one each, `cat` joins them")
      ->type_name("i/n")
      ->capture_default_str();
  sweep->add_option("--out", options->out, "File that lines are appended to; one that was stopped goes on from there")
      ->type_name("FILE");
  sweep->callback([options, &context] { sweep_scene(*options, context); });
}

}  // namespace carom::tools
