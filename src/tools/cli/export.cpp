// `carom export SCENE FILE`: a scene as a file that `carom run`, and other tools, read.
#include <cstdio>

#include "cli/commands.h"
#include "cli/scene_choice.h"
#include "scenefile/scenefile.h"
#include "scenes/run.h"

namespace carom::tools {
namespace {

struct ExportOptions {
  SceneChoice choice;
  std::string file;
};

void export_scene(const ExportOptions& options, Context& context) {
  const SceneChoice& choice = options.choice;
  const Scene& scene = chosen_scene(choice.scene);
  const double dt = choice.dt.value_or(scene.dt);
  Engine engine(context.plugins());
  engine.set_threads(choice.threads);
  Stage stage(engine);
  set_up(choice, scene, stage);
  if (choice.seconds && *choice.seconds > 0) simulate(stage, nullptr, *choice.seconds, dt);
  write_scene(options.file, stage, scene.seconds, dt);
  std::printf("%s: %zu bodies and particles, %zu joints; see it with: carom run %s\n", options.file.c_str(),
              stage.actors.size(), stage.ties.size(), options.file.c_str());
}

}  // namespace

void add_export_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command =
      app.add_subcommand("export", "Write a scene as glTF with physics, for `carom run` and other tools");
  add_scene_options(*command, options->choice, "Simulate so long before writing; default: 0");
  command->add_option("FILE", options->file, "What to write: .gltf or .glb")->required();
  command->footer(
      "glTF 2.0 with KHR_physics_rigid_bodies, KHR_implicit_shapes and CAROM_physics (src/tools/scenefile).");
  command->callback([options, &context] { export_scene(*options, context); });
}

}  // namespace carom::tools
