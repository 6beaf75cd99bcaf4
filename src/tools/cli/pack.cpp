// `carom pack DIR`: scenes as files for the page of src/site: each world as it starts, as bytes, and what to say of it.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/scene_choice.h"
#include "host/files.h"
#include "scenefile/scenefile.h"

namespace carom::tools {
namespace {

struct PackOptions {
  std::string folder;
  std::vector<std::string> scenes;
  std::uint64_t steps = 240;
};

/// A browser's one thread is to keep up with these.
std::optional<double> bodies_for_a_page(const std::string& scene) {
  if (scene == "particles") return 5000;
  if (scene == "sleepers") return 1000;
  return std::nullopt;
}

std::string hex(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

nlohmann::json three(const Vec& v) { return {v.x(), v.y(), v.z()}; }

/// The scene's file, and the row of it in the index.
/// hashes: of the state after so many steps, as this machine has them; every other is to have them too
nlohmann::json pack_scene(const std::string& name, const PackOptions& options, Context& context) {
  const Scene& scene = chosen_scene(name);
  SceneChoice choice;
  choice.scene = name;
  choice.n = bodies_for_a_page(name);
  Engine engine(context.plugins());
  Stage stage(engine);
  set_up(choice, scene, stage);
  const std::string stem = is_scene_file(name) ? std::filesystem::path(name).stem().string() : scene.name;
  const std::vector<char> bytes = stage.world.save(CAROM_SNAPSHOT_WHOLE);
  write_file(options.folder + "/" + stem + ".world", std::string(bytes.begin(), bytes.end()));
  nlohmann::json row = {{"name", stem}, {"summary", scene.summary}, {"look_for", scene.look_for}, {"dt", scene.dt},
                        {"seconds", scene.seconds}, {"world", stem + ".world"}, {"remarks", stage.remarks},
                        {"camera", {{"from", three(stage.camera_from)}, {"to", three(stage.camera_to)}}},
                        {"ground", stage.ground_half_width}};
  if (stage.water_level) row["water"] = *stage.water_level;
  for (const Actor& actor : stage.actors)
    if (actor.particles == CAROM_NULL_HANDLE) row["bodies"].push_back({actor.name, actor.kind});
  row["particles"] = stage.particle_count();
  nlohmann::json& hashes = row["hashes"];
  hashes["0"] = hex(stage.world.hash());
  for (std::uint64_t step = 1; step <= options.steps; ++step) {
    stage.world.step(scene.dt);
    hashes[std::to_string(step)] = hex(stage.world.hash());
  }
  return row;
}

void pack(const PackOptions& options, Context& context) {
  std::error_code ignored;
  std::filesystem::create_directory(options.folder, ignored);
  nlohmann::json index = nlohmann::json::array();
  std::vector<std::string> names = options.scenes;
  if (names.empty())
    for (const Scene& scene : all_scenes()) names.push_back(scene.name);
  for (const std::string& name : names) {
    index.push_back(pack_scene(name, options, context));
    std::printf("%s\n", name.c_str());
  }
  write_file(options.folder + "/index.json", index.dump() + "\n");
  std::printf("%zu scenes in %s\n", index.size(), options.folder.c_str());
}

}  // namespace

void add_pack_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<PackOptions>();
  CLI::App* command =
      app.add_subcommand("pack", "Write scenes for the page of src/site: worlds as bytes, names, hashes of each step");
  command->add_option("DIR", options->folder, "Folder to write into")->required();
  command->add_option("SCENE", options->scenes, "Scenes or .gltf files; default: all of `carom list`");
  command->add_option("--steps", options->steps, "Steps whose hashes are written")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  command->callback([options, &context] { pack(*options, context); });
}

}  // namespace carom::tools
