// The list of scenes, and the checks between a request and a scene.
#include <algorithm>
#include <cmath>

#include "scenes/scene.h"

namespace carom::tools {

Scene seesaw_scene();
Scene catapult_scene();
Scene bunnies_scene();
Scene particles_scene();
Scene falling_scene();
Scene pyramid_scene();
Scene stacks_scene();
Scene wall_scene();
Scene sleepers_scene();
Scene net_scene();
Scene bullet_scene();
Scene conveyor_scene();
Scene terrain_scene();
Scene quoits_scene();
Scene ragdoll_scene();
Scene weather_scene();

const std::vector<Scene>& all_scenes() {
  static const std::vector<Scene> scenes = {seesaw_scene(),   catapult_scene(), bunnies_scene(), particles_scene(),
                                            falling_scene(),  pyramid_scene(),  stacks_scene(),  wall_scene(),
                                            sleepers_scene(), net_scene(),      bullet_scene(),  conveyor_scene(),
                                            terrain_scene(),  quoits_scene(),   ragdoll_scene(), weather_scene()};
  return scenes;
}

namespace {

/// "did you mean 'seesaw'? the scenes are: seesaw, ..."
std::string suggestion(const std::string& name, const std::vector<std::string>& names, const std::string& what) {
  const std::string near = nearest_name(name, names);
  std::string text = near.empty() ? "" : "did you mean '" + near + "'? ";
  text += what;
  for (std::size_t i = 0; i < names.size(); ++i) text += (i ? ", " : " ") + names[i];
  return text;
}

}  // namespace

const Scene& find_scene(const std::string& name) {
  std::vector<std::string> names;
  for (const Scene& scene : all_scenes()) {
    if (scene.name == name) return scene;
    names.push_back(scene.name);
  }
  throw Error("there is no scene called '" + name + "'", suggestion(name, names, "the scenes are:"));
}

std::unique_ptr<Observer> build(const Scene& scene, const Settings& settings, Stage& stage) {
  std::vector<double> values;
  std::vector<std::string> names;
  for (const Knob& knob : scene.knobs) {
    values.push_back(knob.initial);
    names.push_back(knob.name);
  }
  for (const auto& [name, value] : settings.values) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      throw Error("scene " + scene.name + " has no parameter '" + name + "'",
                  names.empty() ? "leave it out: this scene has none" : suggestion(name, names, "it has:"));
    const Knob& knob = scene.knobs[static_cast<std::size_t>(found - names.begin())];
    auto number = [](double x) {
      std::string text = std::to_string(x);
      text.erase(text.find_last_not_of('0') + 1);
      return text.back() == '.' ? text.substr(0, text.size() - 1) : text;
    };
    if (!(value >= knob.min && value <= knob.max) || (knob.whole && value != std::floor(value)))
      throw Error("parameter " + name + " of scene " + scene.name + " cannot be " + number(value),
                  std::string("give a ") + (knob.whole ? "whole number" : "number") + " from " + number(knob.min) +
                      " to " + number(knob.max) + (knob.unit.empty() ? "" : " " + knob.unit));
    values[static_cast<std::size_t>(found - names.begin())] = value;
  }
  return scene.fill(stage, values, settings.mesh_path);
}

}  // namespace carom::tools
