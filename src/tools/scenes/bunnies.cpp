// bunnies: bunnies, boxes and spheres rain onto a walled ground; many general hulls among specific shapes.
#include <cmath>

#include "scenes/random.h"
#include "scenes/scene.h"

namespace carom::tools {
namespace {

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string& mesh_path) {
  const int boxes = static_cast<int>(knobs[2]), spheres = static_cast<int>(knobs[3]);  // to a bunny
  const int period = 1 + boxes + spheres, count = period * static_cast<int>(knobs[0]);
  const double height = 0.6;  // m
  const Bunny bunny = load_bunny(mesh_path, height, static_cast<std::size_t>(knobs[1]));
  stage.meshes.push_back(bunny.mesh);
  stage.remarks.insert(stage.remarks.end(), bunny.remarks.begin(), bunny.remarks.end());
  const std::vector<double> hull = hull_params(bunny.hull.hull);

  Random random(19940301);
  const double spacing = 0.9;  // m: a turned bunny fits a sphere of radius 0.41 m
  const int side = std::max(2, static_cast<int>(std::ceil(std::cbrt(count) - 1e-9)));
  const double half = side * spacing / 2 + 0.3;
  stage.add_walled_ground(half);
  for (int i = 0; i < count; ++i) {
    Actor actor;
    Part part;
    const int rank = i % period;
    int number = i / period;
    if (rank == 0) {
      actor.kind = "bunny";
      part.shape = "hull";
      part.params = hull;
      part.mesh = 0;
    } else if (rank <= boxes) {
      number = number * boxes + rank - 1;
      actor.kind = "box";
      part.shape = "box";
      part.params = {0.25, 0.15, 0.2};
    } else {
      number = number * spheres + rank - 1 - boxes;
      actor.kind = "sphere";
      part.shape = "sphere";
      part.params = {0.22};
    }
    actor.name = actor.kind + " " + std::to_string(number);
    const double middle = (side - 1) / 2.0;
    const Vec site(i % side - middle, i / (side * side) + 1.0, i / side % side - middle);
    const Vec jitter = random.within(Vec(-0.03, -0.03, -0.03), Vec(0.03, 0.03, 0.03));
    actor.position = spacing * site + jitter;
    actor.orientation = random.rotation();
    actor.parts.push_back(std::move(part));
    stage.add(std::move(actor));
  }
  stage.camera_from = Vec(0, 1.4 * half, 3 * half);
  stage.camera_to = Vec(0, half / 4, 0);
  return nullptr;
}

}  // namespace

Scene bunnies_scene() {
  return {"bunnies",
          "N bunnies and, to each, boxes and spheres rain into a walled ground (the paper's scene C).",
          "bunnies at rest among boxes, ears over edges, none inside a neighbour",
          {{"n", "", "number of bunnies", 40, 1, 5000, true},
           {"hull_vertices", "", "vertices of a bunny's hull at most", 42, 8, 2000, true},
           {"boxes", "", "boxes to a bunny", 1, 0, 10, true},
           {"spheres", "", "spheres to a bunny", 1, 0, 10, true}},
          10.0,
          1.0 / 60,
          fill};
}

}  // namespace carom::tools
