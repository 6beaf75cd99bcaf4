// A seed before the jury: drawn, run by Carom or read from files, judged.
#pragma once

#include <functional>

#include "jury/built/built.h"
#include "jury/judge.h"

namespace carom::tools::jury {

/// How Carom runs a scene.
struct Setting {
  std::string preset;
  std::vector<std::string> dials;  ///< "name=value"
  bool built = false;              ///< scenes that people build, not what falls at random
  double dt = 0;                   ///< s; 0: as the scene was drawn, and as its host changes it
  double seconds = 0;              ///< s; 0: as the scene was drawn
  bool times = true;               ///< judge by times, too; a run that seems to stall is timed twice more
  double dt_of(const Case& scene) const { return dt > 0 ? dt : scene.dt; }
  double seconds_of(const Case& scene) const { return seconds > 0 ? seconds : scene.seconds; }
};

/// A scene in a world of its own, ready to run.
struct Scenery {
  Scenery(const PluginPath& plugins, std::uint64_t seed, bool built = false)
      : engine(plugins), stage(engine), scene(built ? draw_built(seed, stage) : draw(seed, stage)) {}
  Engine engine;
  Stage stage;
  Case scene;
};

/// A step of a run, and what the host does before it.
struct Beat {
  double time, end, dt;            ///< s: from when to when, how long it is
  std::vector<std::size_t> deeds;  ///< indices into those of the case
};
std::vector<Beat> course_of(const Case& scene, const Setting& setting);

/// What a run left behind beside its verdict.
struct Motion {
  std::vector<Frame> frames;    ///< the start, then after each step
  std::vector<double> seconds;  ///< of each step
};

using Watcher = std::function<void(std::size_t step, const Reading&, const carom_step_report&)>;

struct Trial {
  std::uint64_t seed = 0;
  std::string summary, family;
  std::size_t joints = 0;
  Verdict verdict;
  std::uint64_t hash = 0;  ///< of the world at the end; 0 if it was not Carom's
};

/// @param motion  filled if not null
Trial run(const PluginPath& plugins, std::uint64_t seed, const Setting& setting, const Watcher& watch = {},
          Motion* motion = nullptr);
/// Judge what another engine did with the scene.
Trial judge(const PluginPath& plugins, std::uint64_t seed, const Setting& setting, const Motion& motion,
            const Watcher& watch = {});

Frame frame_of(const Stage& stage);
/// Do what a host does.   @throws Error
void act(Scenery& scenery, const Deed& deed);

/// The scene for other engines (README.md says how), and where they say what became of it.
void write_scene_json(const std::string& path, const Scenery& scenery, const Setting& setting);
void write_motion(const std::string& path, const Motion& motion);
Motion read_motion(const std::string& path, std::size_t members);  ///< @throws Error

/// Seeds of a day: a thousand that no other day has.
std::uint64_t seed_of_day(int year, int month, int day);

}  // namespace carom::tools::jury
