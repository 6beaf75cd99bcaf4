// Which scene, with which parameters, dials and effects: the options that `carom run` and `carom plan` share.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace carom::tools {

struct SceneChoice {
  std::string scene, mesh, preset;
  std::vector<std::string> dials, sets, forbidden, forced;
  std::optional<double> n, seconds, dt, accuracy;
  std::uint32_t threads = 1;
};

/// How long to simulate and in which steps, s.   @throws Error that names the option
void check_times(double seconds, double dt);
/// By name, or of a file (.gltf, .glb).   @throws Error
const Scene& chosen_scene(const std::string& name);
void add_scene_options(CLI::App& command, SceneChoice& choice, const std::string& seconds_help);
/// Fill the stage, then set dials and effects.   @return the scene's observer, or null   @throws Error
std::unique_ptr<Observer> set_up(const SceneChoice& choice, const Scene& scene, Stage& stage);

}  // namespace carom::tools
