// `carom pack DIR`: scenes as files for the page of src/site: each world as it starts, as bytes, and what to say of it.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <sstream>

#include "cli/packed_scene.h"
#include "cli/packed_truth.h"
#include "cli/progress.h"
#include "host/files.h"
#include "scenefile/scenefile.h"

namespace carom::tools {
namespace {

struct PackOptions {
  std::string folder;
  std::vector<std::string> scenes;
  HashedSteps steps;
};

/// A browser's one thread is to keep up with these.
std::optional<double> bodies_for_a_page(const std::string& scene) {
  if (scene == "particles") return 5000;
  if (scene == "sleepers") return 1000;
  return std::nullopt;
}

/// "falling:n=64,layers=2": a scene with other parameters than its own, as a scene of another name.
SceneChoice choice_of(const std::string& text) {
  SceneChoice choice;
  const std::size_t colon = is_scene_file(text) ? std::string::npos : text.find(':');
  choice.scene = text.substr(0, colon);
  if (colon == std::string::npos) {
    choice.n = bodies_for_a_page(text);
    return choice;
  }
  std::stringstream sets(text.substr(colon + 1));
  for (std::string set; std::getline(sets, set, ',');) choice.sets.push_back(set);
  return choice;
}

void pack(const PackOptions& options, Context& context) {
  std::error_code ignored;
  std::filesystem::create_directories(options.folder, ignored);
  nlohmann::json index = nlohmann::json::array();
  std::vector<std::string> names = options.scenes;
  if (names.empty()) {
    for (const Scene& scene : all_scenes()) names.push_back(scene.name);
    for (std::string& name : scenes_with_true_poses(context)) names.push_back(std::move(name));
  }
  ShareOfProgress share(names.size());
  for (const std::string& name : names) {
    share.begins(name);
    PackedScene packed = packed_scene(choice_of(name), options.steps, context);
    if (!is_scene_file(name)) packed.rename(name);
    write_file(options.folder + "/" + packed.file, packed.content);
    if (!packed.truth.empty())
      write_file(options.folder + "/" + packed.row["truth"]["file"].get<std::string>(), packed.truth);
    if (packed.row.contains("meshes")) {  // apart: a page wants them only with their scene
      const std::string file = packed.row["name"].get<std::string>() + ".meshes";
      write_file(options.folder + "/" + file, packed.row["meshes"].dump());
      packed.row["meshes"] = file;
    }
    index.push_back(std::move(packed.row));
    share.clear();
    std::printf("%s\n", name.c_str());
    std::fflush(stdout);
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
  command->add_option(
      "SCENE", options->scenes,
      "Scenes, as falling or falling:n=64,layers=2, accuracy/slide, or files; default: all of `carom list`, "
      "and of `carom accuracy list` all whose truth is poses");
  command->add_option("--steps", options->steps.most, "Steps whose hashes are written")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  command->callback([options, &context] { pack(*options, context); });
}

}  // namespace carom::tools
