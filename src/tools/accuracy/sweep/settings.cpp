// The table of settings, and that of what scenes have in them.
#include "accuracy/sweep/settings.h"

namespace carom::tools::accuracy {
namespace {

struct Row {
  const char* name;
  unsigned has;
  double seconds;
};
// Scenes that are not here have everything and run as long as they ask.
constexpr Row kScenes[] = {
    {"freefall", kFlies, 0},
    {"drag", kFlies, 0},
    {"gzbox", kFlies | kTurns, 0},
    {"top", kTurns, 0},
    {"dzhanibekov", kTurns, 0},
    {"heavytop", kJoined | kFlies | kTurns, 0},
    {"pendulum", kJoined | kFlies, 0},
    {"chain1", kJoined, 0},
    {"chain100", kJoined, 0},
    {"chain1e4", kJoined, 0},
    {"fourbar", kJoined, 0},
    {"bricard", kJoined | kTurns, 0},
    {"governor", kJoined | kTurns, 0},
    {"wrecking", kJoined, 0},
    {"bridge", kJoined | kTouches, 2},
    {"bouncing", kBounces | kFlies, 0},
    {"bounce05", kBounces | kFlies | kTouches, 0},
    {"cradle", kBounces, 0},
    {"cannon", kBounces | kFlies, 0},
    {"elastic666", kBounces | kFlies | kTouches, 0},
    {"pack666", kTouches, 0},
    {"slide", kTouches, 0},
    {"slip", kTouches, 0},
    {"stick", kTouches, 0},
    {"rolling", kTouches, 0},
    {"skid", kTouches, 0},
    {"coin", kTouches | kTurns, 0},
    {"painleve", kTouches | kTurns, 0},
    {"arch", kTouches, 10},
    {"cards", kTouches, 10},
    {"kapla", kTouches, 5},
    {"domino", kTouches | kFlies, 0},
    {"bullet", kBounces | kTouches, 0},
    {"spinning_rod", kBounces | kTurns, 0},
    {"overlap", kTouches, 0},
    {"far", kTouches, 0},
    {"pile", kTouches | kFlies, 0},
    {"tumble", kTouches | kJoined | kFlies, 0},
    {"replay", kTouches, 0},
    {"collisions", kBounces | kTurns, 0},
};

Setting solved(const char* solver, int substeps, unsigned matters_to, const std::string& also_named = "",
               std::vector<std::string> also = {}) {
  const std::string n = std::to_string(substeps);
  Setting setting{std::string(solver) + ", " + n + (substeps == 1 ? " substep" : " substeps") + also_named,
                  {"solver=" + std::string(solver), "substeps=" + n},
                  matters_to};
  for (std::string& dial : also) setting.dials.push_back(std::move(dial));
  return setting;
}

/// @param tolerance  m and rad per second of motion
Setting asked(const std::string& tolerance) {
  return {"asked for " + tolerance,
          {"accuracy_place=" + tolerance, "accuracy_turn=" + tolerance},
          kTouches | kJoined | kFlies | kTurns};
}

}  // namespace

SceneTraits traits_of(const Challenge& challenge) {
  for (const Row& row : kScenes)
    if (challenge.scene.name == row.name) return {row.has, row.seconds};
  if (challenge.scene.name.starts_with("cones_")) return {kSolved, 0};
  if (challenge.scene.name.starts_with("stack") || challenge.scene.name.starts_with("massratio") ||
      challenge.scene.name.starts_with("tower"))
    return {kTouches, 0};
  return {};
}

const std::vector<std::string>& topics() {
  static const std::vector<std::string> list = {"Flight",   "Joints", "Impacts",   "Friction",
                                                "Standing", "Cones",  "Invariance"};
  return list;
}

std::string topic_of(const Challenge& challenge) {
  const int n = challenge.number;
  if (n <= 6) return "Flight";
  if (n >= 7 && n <= 9) return "Joints";
  if (n == 30 || n == 53) return "Joints";
  if (n >= 10 && n <= 15) return "Impacts";
  if (n == 29 || n == 37) return "Impacts";
  if ((n >= 16 && n <= 21) || n == 31 || (n >= 46 && n <= 52)) return "Friction";
  if (n == 33 || n == 35 || n == 36) return "Invariance";
  if (n == 34) return "Cones";
  return "Standing";
}

const std::vector<Setting>& carom_settings() {
  constexpr unsigned kLasts = kTouches | kJoined;  // where solvers differ; bounces come before them
  static const std::vector<Setting> settings = {
      solved("auto", 4, kAny),  // kDefaultSetting, and the preset balanced
      {"preset fast", {"preset=fast"}, kAny},
      {"preset accurate", {"preset=accurate"}, kAny},
      {"preset reference", {"preset=reference"}, kAny},
      solved("auto", 1, kAny),
      solved("auto", 2, kAny),
      solved("auto", 8, kAny),
      solved("auto", 16, kAny),
      solved("direct", 1, kLasts),
      solved("direct", 4, kLasts),
      solved("soft_step", 4, kLasts),
      solved("soft_step", 4, kTouches, ", floats", {"precision=float"}),
      solved("soft_step", 16, kLasts),
      solved("auto", 4, kTouches, ", points kept for 3 mm", {"keep_distance=3e-3"}),
      solved("auto", 4, kTouches, ", points kept for 0.1 mm", {"keep_distance=1e-4"}),
      solved("auto", 4, kTouches, ", points asked in each step", {"keep_distance=0"}),
      solved("severity", 1, kLasts),
      solved(
          "severity", 4, kLasts, ", to the end",
          {"velocity_tolerance=1e-9", "velocity_iterations=100", "position_iterations=50", "position_tolerance=1e-5"}),
      asked("1e-2"),
      asked("1e-3"),
      asked("1e-4"),
      solved("auto", 4, kFlies, ", explicit Euler", {"integrator=explicit_euler"}),
      solved("auto", 4, kFlies, ", semi-implicit Euler", {"integrator=semi_implicit_euler"}),
      solved("auto", 4, kFlies | kTurns, ", Runge-Kutta 4", {"integrator=rk4"}),
      solved("auto", 4, kBounces, ", bounces from 1 cm/s on", {"restitution_speed=0.01"}),
      solved("auto", 4, kTurns, ", rotation none", {"rotation=none"}),
      solved("auto", 4, kTurns, ", rotation explicit", {"rotation=explicit"}),
      solved("auto", 4, kTurns, ", rotation implicit", {"rotation=implicit"}),
      solved("auto", 4, kTurns, ", rotation rk4", {"rotation=rk4"}),
      solved("auto", 4, kTurns, ", rotation lie_midpoint", {"rotation=lie_midpoint"}),
      solved("auto", 4, kTurns, ", rotation splitting_4", {"rotation=splitting_4"}),
      solved("auto", 4, kTurns, ", rotation splitting_6", {"rotation=splitting_6"}),
      solved("direct", 1, kSolved, ", to 1e-2 m/s", {"velocity_tolerance=1"}),
      solved("direct", 1, kSolved, ", to 1e-4 m/s", {"velocity_tolerance=1e-2"}),
      solved("direct", 1, kSolved, ", to 1e-6 m/s", {"velocity_tolerance=1e-4"}),
      solved("direct", 1, kSolved, ", to 1e-8 m/s", {"velocity_tolerance=1e-6"}),
      solved("direct", 1, kSolved, ", to 1e-10 m/s", {"velocity_tolerance=1e-8"}),
  };
  return settings;
}

std::string preset_of(const std::string& setting) {
  if (setting == kDefaultSetting) return "balanced";
  return setting.starts_with("preset ") ? setting.substr(7) : "";
}

std::string options_of(const std::string& setting) {
  if (const std::string preset = preset_of(setting); !preset.empty()) return "--preset " + preset;
  for (const Setting& s : carom_settings()) {
    if (s.name != setting) continue;
    std::string text;
    for (const std::string& dial : s.dials) text += (text.empty() ? "--dial " : " --dial ") + dial;
    return text;
  }
  return "";
}

const std::vector<double>& sweep_steps() {
  static const std::vector<double> steps = {1.0 / 30, 1.0 / 60, 1.0 / 120, 1.0 / 240, 1.0 / 480, 1.0 / 960};
  return steps;
}

}  // namespace carom::tools::accuracy
