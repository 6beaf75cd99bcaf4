// far: a column and a slide where the world begins, and the same ten and a thousand kilometres away.
#include <cmath>

#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

constexpr int kCubes = 5;
constexpr double kFriction = 0.5, kSpeed = 5;  // m/s, of the block that slides
const Vec kSlides(0.5, 0.1, 0.5);              // m, its half extents
const Vec kFloor(6, 0.5, 6);                   // m, those of what all stands on

/// How far bodies have gone from home, against those of the first copy.
class FarTrial : public Trial {
 public:
  FarTrial(const Stage& stage, std::size_t copies) : crowd_(stage), copies_(copies), worst_(copies, 0) {}
  void watch(const Stage& stage, double) override {
    crowd_.look(stage);
    const std::size_t each = crowd_.size() / copies_;
    for (std::size_t i = 0; i < crowd_.size(); ++i)
      worst_[i / each] = std::max(worst_[i / each], (way(i) - way(i % each)).norm());
  }
  std::vector<double> errors(const Stage&) const override { return {worst_.begin() + 1, worst_.end()}; }

 private:
  Vec way(std::size_t i) const { return crowd_.position(i) - crowd_.home(i); }

  Crowd crowd_;
  std::size_t copies_;
  std::vector<double> worst_;  // m
};

void add_copy(Stage& stage, const Vec& at) {
  Actor floor;
  floor.kind = "floor", floor.name = "floor " + std::to_string(stage.actors.size());
  floor.type = CAROM_BODY_STATIC;
  floor.position = at - kFloor.y() * Vec::UnitY();
  Part part;
  part.shape = "box", part.params = {kFloor.x(), kFloor.y(), kFloor.z()}, part.friction = kFriction;
  floor.parts.push_back(std::move(part));
  stage.add(std::move(floor));
  for (int i = 0; i < kCubes; ++i) add_box(stage, at + Vec(0, i + 0.5, -2), Vec::Constant(0.5), 1, {kFriction, 0});
  add_box(stage, at + Vec(-2, kSlides.y(), 2), kSlides, 1, {kFriction, 0}, Vec(kSpeed, 0, 0));
}

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>&, const std::string&) {
  const Vec away = Vec(3, 1, 2).normalized();  // no round numbers: places are rounded, by 1e-10 m at 1000 km
  const std::vector<double> distances = {0, 1e4, 1e6};
  for (const double distance : distances) add_copy(stage, distance * away);
  stage.bounds_min = Vec::Constant(-1e9), stage.bounds_max = Vec::Constant(1e9);
  stage.ground_half_width = 0;
  stage.camera_from = Vec(0, 4, 12);
  return std::make_unique<FarTrial>(stage, distances.size());
}

}  // namespace

Challenge far_challenge() {
  return {33,
          {"far",
           "A column of five cubes stands, and a block slides; the same at 10 km and at 1000 km.",
           "nothing: where the world begins must not matter",
           {},
           4,
           1.0 / 60,
           fill},
          "the same room where the world begins",
          {{"place at 10 km, at worst", "m", 1e-6}, {"place at 1000 km, at worst", "m", 1e-6}},
          {},
          {}};
}

}  // namespace carom::tools::accuracy
