// overlap: a pyramid whose boxes a host has put into one another by half.
#include <cmath>

#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

/// The largest speed of any box after any step, and what still overlaps at the end.
class OverlapTrial : public Trial {
 public:
  explicit OverlapTrial(const Stage& stage) : crowd_(stage) {}
  void watch(const Stage& stage, double) override {
    crowd_.look(stage);
    for (std::size_t i = 0; i < crowd_.size(); ++i) {
      const double speed = crowd_.velocity(i).norm();
      fastest_ = speed <= fastest_ ? fastest_ : speed;  // what is not a number, too
    }
  }
  std::vector<double> errors(const Stage& stage) const override {
    return {fastest_, stage.world.report().max_penetration};
  }

 private:
  Crowd crowd_;
  double fastest_ = 0;
};

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  add_ground(stage, 0.5);
  const int base = static_cast<int>(knobs[0]);
  for (int row = 0; row < base; ++row)
    for (int i = 0; i < base - row; ++i)
      add_box(stage, Vec(i + 0.5 * row, 0.25 + 0.5 * row, 0), Vec::Constant(0.5), 1, {0.5, 0});
  stage.camera_from = Vec(0.5 * base, 2, 10), stage.camera_to = Vec(0.5 * base, 1, 0);
  return std::make_unique<OverlapTrial>(stage);
}

}  // namespace

Challenge overlap_challenge() {
  return {32,
          {"overlap",
           "A pyramid of cubes of 1 m whose rows are half a metre apart: each starts halfway in those below it.",
           "a pyramid that rises to its height, and is not blown up",
           {{"base", "", "cubes in the lowest row", 4, 2, 20, true}},
           2.5,
           1.0 / 60,
           fill},
          "it parts, and stands on its ground",
          {{"speed, largest", "m/s", 2}, {"overlap at the end", "m", 0.01}},
          {},
          {}};
}

}  // namespace carom::tools::accuracy
