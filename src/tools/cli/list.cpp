// `carom list`: the scenes, what to look for in each, and their parameters.
#include <cstdio>

#include "cli/commands.h"
#include "cli/table.h"
#include "scenes/scene.h"

namespace carom::tools {
namespace {

void print_scenes() {
  for (const Scene& scene : all_scenes()) {
    std::printf("%s\n  %s\n  look for: %s\n  suggested: %g s in steps of 1/%.0f s\n", scene.name.c_str(),
                scene.summary.c_str(), scene.look_for.c_str(), scene.seconds, 1 / scene.dt);
    for (const Knob& knob : scene.knobs)
      std::printf("    --set %s=%g  %s (%g to %g%s%s)\n", knob.name.c_str(), knob.initial, knob.help.c_str(), knob.min,
                  knob.max, knob.unit.empty() ? "" : " ", knob.unit.c_str());
    std::printf("\n");
  }
  std::printf("Run one with: carom run SCENE [--set name=value] [--gltf motion.glb]; --n N is short for --set n=N\n");
}

}  // namespace

void add_list_command(CLI::App& app, Context&) {
  app.add_subcommand("list", "List the scenes and their parameters")->callback(print_scenes);
}

}  // namespace carom::tools
