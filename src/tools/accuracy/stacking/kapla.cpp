// kapla: a tower of 102 wooden blocks, 34 layers of three, each layer across the one below.
#include "accuracy/stacking/stand.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kSeconds = 600;

std::unique_ptr<Observer> fill_kapla(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  add_ground(stage, 0.5);
  add_plank_tower(stage, static_cast<int>(knobs[0]));
  stage.camera_from = Vec(0.3, 0.2, 0.6);
  stage.camera_to = Vec(0, 0.13, 0);
  return std::make_unique<StandTrial>(stage, kPlankHalf.x(), kSeconds);
}

}  // namespace

Challenge kapla_challenge() {
  return {28,
          {"kapla",
           "A tower of 102 wooden blocks of 117 x 23 x 8 mm: 34 layers of three, crosswise.",
           "a tower that stands for ten minutes",
           {{"layers", "", "of three blocks each", 34, 1, 200, true}},
           kSeconds,
           1.0 / 60,
           fill_kapla},
          "it rests where it was put",
          StandTrial::metrics(kNoBound, kNoBound, 0),
          {},
          {}};
}

}  // namespace carom::tools::accuracy
