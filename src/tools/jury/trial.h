// A seed before the jury: drawn, run by Carom or read from files, judged.
#pragma once

#include <functional>

#include "jury/judge.h"

namespace carom::tools::jury {

/// How Carom runs a scene.
struct Setting {
  std::string preset;
  std::vector<std::string> dials;  ///< "name=value"
  double dt = 1.0 / 60;            ///< s
  double seconds = 5;              ///< s
  bool times = true;               ///< judge by times, too; a run that seems to stall is timed twice more
};

/// A scene in a world of its own, ready to run.
struct Scenery {
  Scenery(const PluginPath& plugins, std::uint64_t seed) : engine(plugins), stage(engine), scene(draw(seed, stage)) {}
  Engine engine;
  Stage stage;
  Case scene;
};

/// What a run left behind beside its verdict.
struct Motion {
  std::vector<Frame> frames;    ///< the start, then after each step
  std::vector<double> seconds;  ///< of each step
};

using Watcher = std::function<void(std::size_t step, const Reading&, const carom_step_report&)>;

struct Trial {
  std::uint64_t seed = 0;
  std::string summary;
  Verdict verdict;
  std::uint64_t hash = 0;  ///< of the world at the end; 0 if it was not Carom's
};

/// @param motion  filled if not null
Trial run(const PluginPath& plugins, std::uint64_t seed, const Setting& setting, const Watcher& watch = {},
          Motion* motion = nullptr);
/// Judge what another engine did with the scene.
Trial judge(const PluginPath& plugins, std::uint64_t seed, double dt, const Motion& motion, const Watcher& watch = {});

Frame frame_of(const Stage& stage);
std::size_t steps_of(const Setting& setting);

/// The scene for other engines (README.md says how), and where they say what became of it.
void write_scene_json(const std::string& path, const Scenery& scenery, const Setting& setting);
void write_motion(const std::string& path, const Motion& motion);
Motion read_motion(const std::string& path, std::size_t members);  ///< @throws Error

/// Seeds of a day: a thousand that no other day has.
std::uint64_t seed_of_day(int year, int month, int day);

}  // namespace carom::tools::jury
