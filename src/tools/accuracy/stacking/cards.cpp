// cards: a house of cards, three storeys, each card 25 degrees off the vertical.
#include <cmath>

#include "accuracy/stacking/stand.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kSine = 0.422618261740699436, kCosine = 0.906307787036649963;   // 25 degrees
constexpr double kHalfHeight = 0.1, kHalfThickness = 0.001, kHalfWidth = 0.075;  // m
constexpr double kMass = 0.01, kSeconds = 20;                                    // kg, s
constexpr int kStoreys = 3;

// A tent is two cards that lean against each other. Its outermost points are kReach from its middle, its feet 2 a sin,
// and its top edges 2 t cos; flat cards, as long as tents are apart, lie on the top edges of two neighbours and carry
// the feet of the tent above just outside of them: loads run straight down.
constexpr double kReach = 2 * (kHalfHeight * kSine + kHalfThickness * kCosine);
constexpr double kPitch = 2 * kReach + 1e-4;                                      // m, neighbours do not touch
constexpr double kStorey = 2 * (kHalfHeight * kCosine + kHalfThickness * kSine);  // m, height of a tent

std::unique_ptr<Observer> fill_cards(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const Surface paper{knobs[0], 0};
  add_ground(stage, paper.friction);
  const double cosine = std::sqrt((1 + kCosine) / 2), sine = std::sqrt((1 - kCosine) / 2);  // of half the angle
  double floor = 0;
  for (int storey = 0; storey < kStoreys; ++storey, floor += kStorey + 2 * kHalfThickness) {
    const int tents = kStoreys - storey;
    for (int i = 0; i < tents; ++i) {
      const double middle = kPitch * (i - (tents - 1) / 2.0);
      for (int side : {-1, 1})  // the left card leans to the right: turned by -25 degrees about z
        add_box(stage, Vec(middle + side * kReach / 2, floor + kStorey / 2, 0),
                Vec(kHalfThickness, kHalfHeight, kHalfWidth), kMass, paper, Vec::Zero(),
                Quat(cosine, 0, 0, side * sine));
      if (i + 1 < tents)
        add_box(stage, Vec(middle + kPitch / 2, floor + kStorey + kHalfThickness, 0),
                Vec(kPitch / 2 - 5e-5, kHalfThickness, kHalfWidth), kMass, paper);
    }
  }
  stage.camera_from = Vec(0, 0.4, 1.2);
  stage.camera_to = Vec(0, 0.25, 0);
  return std::make_unique<StandTrial>(stage, kHalfHeight, kSeconds);
}

}  // namespace

Challenge cards_challenge() {
  return {26,
          {"cards",
           "A house of 15 cards of 0.2 x 0.15 m, 2 mm thick, in three storeys, leaning at 25 degrees.",
           "a house that stands",
           {{"mu", "", "friction of everything", 0.7, 0.1, 2}},
           kSeconds,
           1.0 / 60,
           fill_cards},
          "it rests where it was put",
          StandTrial::metrics(1e-3, kNoBound, 0),
          {5.5e-3, "Jolt 50"},
          {5.5e-3, "Jolt 50"}};
}

}  // namespace carom::tools::accuracy
