// particles: one set of them; nothing runs but integration.
#include "scenes/random.h"
#include "scenes/scene.h"

namespace carom::tools {
namespace {

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  Random random(20061001);
  const double spread = knobs[1];
  std::vector<Actor> start;
  for (int i = 0; i < static_cast<int>(knobs[0]); ++i) {
    Actor actor;
    actor.name = "particle " + std::to_string(i);
    actor.kind = "particle";
    actor.position = random.within(Vec(-spread, 0, -spread), Vec(spread, spread, spread));
    const Vec way = random.direction() + Vec(0, 1.5, 0);
    actor.linear_velocity = random.between(2, 12) * way;
    start.push_back(std::move(actor));
  }
  stage.add_particles(std::move(start));
  // A fountain over nothing: it falls for ever, and that is fine.
  stage.bounds_min = Vec::Constant(-1e9);
  stage.bounds_max = Vec::Constant(1e9);
  stage.camera_from = Vec(0, 10, 40);
  stage.camera_to = Vec(0, 5, 0);
  return nullptr;
}

}  // namespace

Scene particles_scene() {
  return {"particles",
          "Particles burst from a point and fly under gravity (the paper's scene D).",
          "a shell of points that falls as one; only the integration stage has participants",
          {{"n", "", "number of particles", 20000, 1, 1000000, true},
           {"spread", "m", "half the width of where they start", 0.2, 0, 1000}},
          3.0,
          1.0 / 60,
          fill};
}

}  // namespace carom::tools
