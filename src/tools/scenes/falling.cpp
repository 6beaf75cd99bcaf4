// falling: N boxes and spheres, alternating, fall into a walled box; the scene that scaling is measured with.
#include <cmath>

#include "scenes/random.h"
#include "scenes/scene.h"

namespace carom::tools {
namespace {

constexpr double kLayerSpacing =
    0.8;                          // m: the largest box, turned, has radius 0.48 with its jitter; sites never overlap
constexpr double kJitter = 0.05;  // m: breaks the grid's symmetry, so that columns do not balance
constexpr int kSizes = 8;         // distinct sizes of each kind: shapes are shared, as a host would

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const auto count = static_cast<std::size_t>(knobs[0]);
  Random random(20111115);
  const double layers = knobs[1], spacing = knobs[2];
  // By default as wide as the heap is tall when it leaves, so that the shape of the heap does not change with N.
  const double across =
      layers > 0 ? std::sqrt(static_cast<double>(count) / layers) : std::cbrt(static_cast<double>(count));
  const int side = std::max(2, static_cast<int>(std::ceil(across - 1e-9)));
  const double half = side * spacing / 2 + 0.1;
  stage.add_walled_ground(half);
  double radius[kSizes];
  Vec extents[kSizes];
  for (int i = 0; i < kSizes; ++i) {
    radius[i] = random.between(0.2, 0.3);
    extents[i] = random.within(Vec(0.2, 0.2, 0.2), Vec(0.27, 0.27, 0.27));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto size = static_cast<std::size_t>(random.bits() % kSizes);
    const auto s = static_cast<std::size_t>(side);
    const Vec site(static_cast<double>(i % s), static_cast<double>(i / (s * s)), static_cast<double>(i / s % s));
    Actor actor;
    Part part;
    actor.kind = i % 2 == 0 ? "box" : "sphere";
    part.shape = actor.kind;
    part.params = i % 2 == 0 ? std::vector<double>{extents[size].x(), extents[size].y(), extents[size].z()}
                             : std::vector<double>{radius[size]};
    actor.name = actor.kind + " " + std::to_string(i);
    const double middle = (side - 1) / 2.0;
    const Vec jitter = random.within(Vec(-kJitter, -kJitter, -kJitter), Vec(kJitter, kJitter, kJitter));
    actor.position =
        Vec(spacing * (site.x() - middle), kLayerSpacing * (site.y() + 1), spacing * (site.z() - middle)) + jitter;
    actor.orientation = random.rotation();
    actor.parts.push_back(std::move(part));
    stage.add(std::move(actor));
  }
  stage.camera_from = Vec(0, 1.6 * half, 3.2 * half);
  stage.camera_to = Vec(0, half / 3, 0);
  return nullptr;
}

}  // namespace

Scene falling_scene() {
  return {"falling",
          "N boxes and spheres, alternating, fall into a walled box.",
          "a heap that comes to rest, no body lost, none sunk into a neighbour",
          {{"n", "", "number of bodies", 1024, 1, 100000, true},
           {"layers", "", "layers that they start in; 0: as many as make a cube", 0, 0, 1000, true},
           {"spacing", "m", "between neighbours of a layer; 2 spreads them out", 0.8, 0.8, 100}},
          15.0,
          1.0 / 60,
          fill};
}

}  // namespace carom::tools
