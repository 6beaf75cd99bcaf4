// Accuracy scenes through every engine that is installed, Carom among them, in one process: rows as `carom accuracy
// sweep` writes them, for `carom accuracy report --from`. Exit codes: 0; 1 an engine is not set up as the comparison
// needs it (--check); 2 it could not run.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "../module_reason.h"
#include "accuracy/sweep/sweep.h"
#include "fairness.h"
#include "settings.h"

namespace carom::bench {
namespace {

using namespace tools::accuracy;

struct Module {
  const char *name, *path;
};
const std::vector<Module> kModules = {CAROM_ENGINE_MODULES};

struct Options {
  std::string out = "peers.json";
  std::vector<std::string> scenes, engines;
  double seconds = 1200, per_run = 10;
  bool check = false, no_maps = false;
};

std::vector<PeerEngine> load(const Options& options) {
  std::vector<PeerEngine> list;
  for (const Module& module : kModules) {
    const auto& wanted = options.engines;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), module.name) == wanted.end()) continue;
    if (const std::string reason = reason_missing(module.path); !reason.empty())
      std::fprintf(stderr, "%s is left out: %s\n", module.name, reason.c_str());
    else if (const PeerEngine engine = load_engine(module.path); engine.name)
      list.push_back(engine);
    else
      std::fprintf(stderr, "%s is left out: it did not start\n", module.name);
  }
  return list;
}

std::vector<Entry> entries_of(const std::vector<PeerEngine>& peers) {
  std::vector<Entry> entries;
  for (const PeerEngine& peer : peers)
    for (const PeerSetting& setting : settings_of(peer.name)) {
      const auto takes_part = [takes = setting.takes](const Challenge& c) {
        const auto& names = scenes_for_peers();
        return std::find(names.begin(), names.end(), c.scene.name) != names.end() && (!takes || takes(c.scene.name));
      };
      entries.push_back({peer.name, setting.name, takes_part, {}, [peer, setting](tools::Stage& stage) {
                           return std::make_unique<PeerMover>(stage, peer, setting.dials);
                         }});
    }
  return entries;
}

int check(tools::Engine& engine, const std::vector<PeerEngine>& peers) {
  int wrong = 0;
  for (const PeerEngine& peer : peers) {
    const std::vector<std::string> complaints = unfair(engine, peer);
    std::printf("%s: %s\n", peer.name, complaints.empty() ? "set up right" : "");
    for (const std::string& c : complaints) std::printf("  %s\n", c.c_str());
    wrong += !complaints.empty();
  }
  return wrong ? 1 : 0;
}

int run(const Options& options) {
  tools::Engine engine{tools::PluginPath({CAROM_PLUGIN_DIR})};
  const std::vector<PeerEngine> peers = load(options);
  if (options.check) return check(engine, peers);
  SweepPlan plan;
  for (const std::string& name : options.scenes.empty() ? scenes_for_peers() : options.scenes)
    plan.scenes.push_back(&find_challenge(name));
  plan.entries = carom_entries();
  for (Entry& entry : entries_of(peers)) plan.entries.push_back(std::move(entry));
  plan.steps = sweep_steps();
  plan.seconds = options.seconds, plan.most_per_run = options.per_run, plan.maps = !options.no_maps;
  std::string scene;
  Sweep found = sweep(engine, plan, [&](const Progress& p) {
    const std::string now = p.what.substr(0, p.what.find(':'));
    if (now != scene) std::fprintf(stderr, "%3.0f %%  %s\n", 100 * p.done, now.c_str());
    scene = now;
  });
  for (EngineNote& note : found.engines)
    if (note.name != "Carom") note.version = note.name, note.note = note_on(note.name);
  write_json(options.out, found);
  std::printf("%zu runs in %s\n", found.rows.size(), options.out.c_str());
  return 0;
}

}  // namespace
}  // namespace carom::bench

int main(int argc, char** argv) {
  carom::bench::Options options;
  CLI::App app("Accuracy scenes through every engine that is installed");
  app.add_option("SCENES", options.scenes, "Which; default: all that every engine can run");
  app.add_option("--out", options.out, "Rows, for `carom accuracy report --from`")
      ->type_name("FILE.json")
      ->capture_default_str();
  app.add_option("--engines", options.engines,
                 "Which, besides Carom: bullet, bullet64, ode, mujoco (Debian's), mujoco_wheel, drake, rapier64");
  app.add_option("--seconds", options.seconds, "About how long to take")->capture_default_str();
  app.add_option("--per-run", options.per_run, "A run that takes more s of computing is left out")
      ->capture_default_str();
  app.add_flag("--no-maps", options.no_maps, "Leave out the maps of what stands");
  app.add_flag("--check", options.check, "Only see whether every engine is told the same");
  CLI11_PARSE(app, argc, argv);
  try {
    return carom::bench::run(options);
  } catch (const carom::tools::Error& error) {
    std::fprintf(stderr, "accuracy_peers: %s\n  what to do: %s\n", error.what(), error.remedy.c_str());
    return 2;
  }
}
