// terrain: bodies of all kinds fall on hills, a height field, and roll and slide into the valleys.
#include <cmath>

#include "scenes/random.h"
#include "scenes/scene.h"

namespace carom::tools {
namespace {

constexpr double kSpacing = 0.5;  // m, of the vertices

/// m: hills, and a bowl around them so that none leaves.
double height(double x, double z, double half) {
  const double out = std::max(std::fabs(x), std::fabs(z)) / half;
  return 0.9 * std::sin(0.7 * x) * std::cos(0.6 * z) + 0.5 * std::sin(1.3 * x + 0.8 * z) + 6 * std::pow(out, 8);
}

Part part_of(std::size_t kind, Random& random) {
  static constexpr const char* kNames[] = {"box", "sphere", "capsule", "cylinder", "cone"};
  const double a = 0.05 * static_cast<double>(random.bits() % 4), b = 0.05 * static_cast<double>(random.bits() % 4);
  Part part;
  part.shape = kNames[kind];
  if (kind == 0)
    part.params = {0.2 + a, 0.15 + b, 0.25};
  else if (kind == 1)
    part.params = {0.2 + a};
  else
    part.params = {0.2 + a, 0.2 + b};
  return part;
}

Actor hills(double across) {
  const auto vertices = static_cast<std::size_t>(std::lround(across / kSpacing)) + 1;
  const double half = across / 2;
  Actor ground;
  ground.name = ground.kind = "hills";
  ground.type = CAROM_BODY_STATIC;
  ground.position = Vec(-half, 0, -half);
  Part field;
  field.shape = "height_field";
  field.params = {static_cast<double>(vertices), static_cast<double>(vertices), kSpacing, kSpacing};
  for (std::size_t j = 0; j < vertices; ++j)
    for (std::size_t i = 0; i < vertices; ++i)
      field.params.push_back(
          height(kSpacing * static_cast<double>(i) - half, kSpacing * static_cast<double>(j) - half, half));
  ground.parts.push_back(std::move(field));
  return ground;
}

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const auto count = static_cast<std::size_t>(knobs[0]);
  const double half = knobs[1] / 2;
  stage.add(hills(knobs[1]));
  Random random(20111115);
  const auto side = static_cast<std::size_t>(std::max(1.0, std::floor(0.7 * knobs[1])));  // they start a metre apart
  const auto middle = static_cast<double>(side - 1) / 2;
  for (std::size_t i = 0; i < count; ++i) {
    Actor actor;
    actor.parts.push_back(part_of(i % 5, random));
    actor.kind = actor.parts[0].shape;
    actor.name = actor.kind + " " + std::to_string(i);
    actor.position = Vec(static_cast<double>(i % side) - middle, 3 + 1.2 * static_cast<double>(i / (side * side)),
                         static_cast<double>(i / side % side) - middle);
    actor.orientation = random.rotation();
    stage.add(std::move(actor));
  }
  stage.bounds_min = Vec(-half, -3, -half);
  stage.bounds_max = Vec(half, 1e3, half);
  stage.ground_half_width = 0;
  stage.camera_from = Vec(0.6 * half, 0.9 * half, 1.3 * half), stage.camera_to = Vec(0, -0.1 * half, 0);
  return nullptr;
}

}  // namespace

Scene terrain_scene() {
  return {
      "terrain",
      "Bodies of five kinds fall on hills made of triangles.",
      "no body falls through, and none trips over a seam",
      {{"n", "", "number of bodies", 200, 1, 20000, true}, {"across", "m", "side of the square of hills", 24, 4, 400}},
      8.0,
      1.0 / 60,
      fill};
}

}  // namespace carom::tools
