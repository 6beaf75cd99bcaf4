// The options of a scene, and the stage that they ask for.
#include "cli/scene_choice.h"

#include <algorithm>
#include <filesystem>

#include "cli/commands.h"
#include "cli/packed_scene.h"
#include "scenefile/scenefile.h"

namespace carom::tools {

std::vector<std::pair<std::string, double>> values_from(const std::vector<std::string>& sets) {
  std::vector<std::pair<std::string, double>> values;
  for (const std::string& text : sets) {
    const std::size_t equals = text.find('=');
    char* end = nullptr;
    const double value = equals == std::string::npos ? 0 : std::strtod(text.c_str() + equals + 1, &end);
    if (!end || end == text.c_str() + equals + 1 || *end)
      throw Error("--set " + text + " is not name=number", "write --set name=value; `carom list` shows the names");
    values.emplace_back(text.substr(0, equals), value);
  }
  return values;
}

namespace {

/// A word that is no scene's name, but one of the file system's.   @throws Error where it is
void refuse_other_files(const std::string& name) {
  namespace fs = std::filesystem;
  std::error_code failed;
  const std::string ending = fs::path(name).extension().string();
  const bool mesh = ending == ".obj" || ending == ".stl" || ending == ".ply";
  const std::string remedy =
      "give a scene of `carom list`, a .gltf or .glb file, or what `carom run SCENE --save FILE` wrote";
  if (fs::is_directory(name, failed)) throw Error("'" + name + "' is a folder, not a scene", remedy);
  if (is_recording(name)) throw Error("'" + name + "' is a recording, not a scene", "write: carom replay " + name);
  if (mesh && fs::exists(name, failed))
    throw Error("'" + name + "' is a mesh, not a scene",
                "write: carom import " + name + " --out scene.gltf, then carom run scene.gltf");
  if (fs::exists(name, failed)) throw Error("'" + name + "' is no scene file", remedy);
  if (name.find('/') != std::string::npos || !ending.empty()) throw Error("there is no file '" + name + "'", remedy);
}

}  // namespace

void check_times(double seconds, double dt) {
  if (!(seconds > 0 && seconds <= 1e6))
    throw Error("--seconds is out of range", "give seconds, more than 0 and at most 1e6");
  if (!(dt >= 1e-9 && dt <= 1)) throw Error("--dt is out of range", "give seconds from 1e-9 to 1, e.g. --dt 0.016667");
}

const Scene& chosen_scene(const std::string& name) {
  static std::map<std::string, Scene> files;
  if (!is_scene_file(name)) {
    const std::vector<Scene>& scenes = all_scenes();
    if (std::none_of(scenes.begin(), scenes.end(), [&](const Scene& scene) { return scene.name == name; }))
      refuse_other_files(name);
    return find_scene(name);
  }
  const auto known = files.find(name);
  return known != files.end() ? known->second : files.emplace(name, scene_of_file(name)).first->second;
}

void add_scene_options(CLI::App& command, SceneChoice& choice, const std::string& seconds_help) {
  command.add_option("SCENE", choice.scene, "Which scene: a name (`carom list` shows them), or a .gltf or .glb file")
      ->required();
  command.add_option("--n", choice.n, "Number of bodies, for scenes that have one (short for --set n=N)");
  command.add_option("--set", choice.sets, "A parameter of the scene, repeatable")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  command.add_option("--seconds", choice.seconds, seconds_help)->type_name("S");
  command.add_option("--dt", choice.dt, "Time step; default: the scene's")->type_name("S");
  command
      .add_option("--preset", choice.preset,
                  "fast, balanced, accurate or reference: what `carom dials` says; --dial comes after")
      ->type_name("NAME");
  command.add_option("--dial", choice.dials, "A dial of the world, repeatable; `carom dials` lists them")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  command
      .add_option("--accuracy", choice.accuracy,
                  "Error that is borne, m and rad per second of motion: each island takes the substeps that it needs")
      ->type_name("X");
  command
      .add_option("--forbid", choice.forbidden,
                  "An effect that shall not run, repeatable; `carom plan SCENE` lists them")
      ->type_name("EFFECT")
      ->allow_extra_args(false);
  command.add_option("--force", choice.forced, "An effect that runs for all participants it can act on, repeatable")
      ->type_name("EFFECT")
      ->allow_extra_args(false);
  command
      .add_option("--mesh", choice.mesh,
                  "OBJ, STL or PLY file for the bunny; default: the Stanford bunny of Debian's glmark2-data")
      ->type_name("FILE");
  command.add_option("--threads", choice.threads, "Threads that share a step; the outcome is the same")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
}

std::unique_ptr<Observer> set_up(const SceneChoice& choice, const Scene& scene, Stage& stage) {
  Settings settings;
  settings.mesh_path = is_scene_file(choice.scene) ? choice.scene : choice.mesh;
  if (choice.n) settings.values.emplace_back("n", *choice.n);
  for (auto& value : values_from(choice.sets)) settings.values.push_back(std::move(value));
  std::unique_ptr<Observer> observer = build(scene, settings, stage);
  if (!choice.preset.empty()) stage.world.set_preset(choice.preset);
  if (choice.accuracy) stage.world.ask(*choice.accuracy);
  for (const std::string& dial : choice.dials) stage.world.set_dial(dial);
  for (const std::string& effect : choice.forbidden) {
    stage.world.set_effect(effect, CAROM_MODE_FORBID);
    if (std::find(choice.forced.begin(), choice.forced.end(), effect) != choice.forced.end())
      throw Error("effect " + effect + " is both forbidden and forced", "leave out --forbid or --force " + effect);
  }
  for (const std::string& effect : choice.forced) stage.world.set_effect(effect, CAROM_MODE_FORCE);
  return observer;
}

}  // namespace carom::tools
