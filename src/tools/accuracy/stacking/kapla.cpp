// kapla: a tower of 102 wooden blocks, 34 layers of three, each layer across the one below.
#include "accuracy/stacking/stand.h"

namespace carom::tools::accuracy {
namespace {

const Vec kHalf(0.0585, 0.0039, 0.0117);           // m: blocks of 117 x 7.8 x 23.4 mm
constexpr double kMass = 0.012, kSeconds = 600;    // kg: pine; s
constexpr double kQuarter = 0.707106781186547524;  // cosine and sine of half a right angle

std::unique_ptr<Observer> fill_kapla(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  add_ground(stage, 0.5);
  const double apart = kHalf.x() - kHalf.z();  // the outer ones end flush with the layer below
  for (int layer = 0; layer < static_cast<int>(knobs[0]); ++layer)
    for (int i : {-1, 0, 1}) {
      const double height = kHalf.y() * (2 * layer + 1);
      const bool across = layer % 2 != 0;
      add_box(stage, across ? Vec(i * apart, height, 0) : Vec(0, height, i * apart), kHalf, kMass, {0.5, 0},
              Vec::Zero(), across ? Quat(kQuarter, 0, kQuarter, 0) : Quat::Identity());
    }
  stage.camera_from = Vec(0.3, 0.2, 0.6);
  stage.camera_to = Vec(0, 0.13, 0);
  return std::make_unique<StandTrial>(stage, kHalf.x(), kSeconds);
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
