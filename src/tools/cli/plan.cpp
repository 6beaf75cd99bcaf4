// `carom plan SCENE`: what a scene calls for: run it for a moment, then say what ran and what was left out, and why.
#include <cstdio>

#include "cli/commands.h"
#include "cli/plan_output.h"
#include "cli/scene_choice.h"
#include "scenes/run.h"

namespace carom::tools {
namespace {

constexpr double kMoment = 1;       // s
constexpr double kDifferences = 1;  // s of wall clock

struct PlanOptions {
  SceneChoice choice;
  bool as_json = false;
};

void print_plan(const PlanOptions& options, Context& context) {
  const SceneChoice& choice = options.choice;
  const Scene& scene = chosen_scene(choice.scene);
  Engine engine(context.plugins());
  engine.set_threads(choice.threads);
  Stage stage(engine);
  set_up(choice, scene, stage);
  stage.world.time_effects(true);
  const double dt = choice.dt.value_or(scene.dt), seconds = choice.seconds.value_or(kMoment);
  check_times(seconds, dt);
  const RunSummary run = simulate(stage, nullptr, seconds, dt);
  const std::vector<carom_plan_line> plan = stage.world.plan();
  const Differences differences = time_by_difference(stage.world, dt, plan, kDifferences);
  if (options.as_json) {
    std::printf("%s\n", plan_json(plan, differences).dump(2).c_str());
    return;
  }
  const std::size_t particles = stage.particle_count();
  std::printf("%s: %s\n  %zu bodies, %zu particles, %llu steps, %.4g s\n\n%s", scene.name.c_str(),
              scene.summary.c_str(), stage.actors.size() - particles, particles,
              static_cast<unsigned long long>(run.steps), run.simulated, plan_text(plan, differences).c_str());
}

}  // namespace

void add_plan_command(CLI::App& app, Context& context) {
  auto options = std::make_shared<PlanOptions>();
  CLI::App* plan =
      app.add_subcommand("plan", "Which stages and effects a scene runs, on which participants, at what cost, and why");
  add_scene_options(*plan, options->choice, "Simulate so long before looking; default: 1");
  plan->add_flag("--json", options->as_json, "Print the plan as JSON");
  plan->callback([options, &context] { print_plan(*options, context); });
}

}  // namespace carom::tools
