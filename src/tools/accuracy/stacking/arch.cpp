// arch, thin_arch: stones in a half circle that hold each other up by friction alone.
#include <cmath>

#include "accuracy/reference.h"
#include "accuracy/stacking/stand.h"

namespace carom::tools::accuracy {
namespace {

// A fifth of its mean radius thick: a line of thrust fits inside with space to spare, since 0.11 would just do
// [Heyman1969].
constexpr double kMean = 2, kThick = 0.4, kHalfDepth = 0.25, kSeconds = 60;  // m, s
constexpr double kPi = 3.14159265358979324;

/// @param thick  m
std::unique_ptr<Observer> add_arch(Stage& stage, int stones, double mu, double thick) {
  const double inner = kMean - thick / 2, outer = kMean + thick / 2;
  add_ground(stage, mu);
  for (int i = 0; i < stones; ++i) {
    const double middle = kPi * (i + 0.5) / stones;
    Actor stone;
    stone.kind = "stone";
    stone.name = "stone " + std::to_string(i + 1);
    stone.position = kMean * Vec(std::cos(middle), std::sin(middle), 0);
    Part wedge;
    wedge.shape = "hull";
    wedge.friction = mu;
    wedge.density = 2400;
    for (double radius : {inner, outer})
      for (int end : {i, i + 1}) {
        const double angle = kPi * end / stones;
        // The feet stand on the ground: exactly level, which the sine of pi is not.
        const double height = end == 0 || end == stones ? 0 : radius * std::sin(angle);
        for (double z : {-kHalfDepth, kHalfDepth}) {
          const Vec corner = Vec(radius * std::cos(angle), height, z) - stone.position;
          wedge.params.insert(wedge.params.end(), corner.data(), corner.data() + 3);
        }
      }
    stone.parts.push_back(std::move(wedge));
    stage.add(std::move(stone));
  }
  stage.camera_from = Vec(0, 2, 8);
  stage.camera_to = Vec(0, 1, 0);
  return std::make_unique<StandTrial>(stage, thick, kSeconds);
}

std::unique_ptr<Observer> fill_arch(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  return add_arch(stage, static_cast<int>(knobs[0]), knobs[1], kThick);
}

std::unique_ptr<Observer> fill_thin(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const int stones = static_cast<int>(knobs[0]);
  return add_arch(stage, stones, knobs[1], knobs[2] * least_arch(stones, knobs[1]) * kMean);
}

}  // namespace

Challenge arch_challenge() {
  return {27,
          {"arch",
           "A half circle of 17 stones, 4 m across and 0.4 m thick.",
           "an arch that stands for a minute",
           {{"stones", "", "how many", 17, 5, 99, true}, {"mu", "", "friction of everything", 0.6, 0.1, 2}},
           kSeconds,
           1.0 / 60,
           fill_arch},
          "a line of thrust lies inside, so it stands",
          StandTrial::metrics(kNoBound, kNoBound, 0),
          {},
          {}};
}

Challenge thin_arch_challenge() {
  return {55,
          {"thin_arch",
           "A half circle of 17 stones that is 1 % thicker than the thinnest that stands.",
           "an arch that stands, and falls where it is 2 % thinner",
           {{"stones", "", "how many", 17, 5, 99, true},
            {"mu", "", "friction of everything", 0.6, 0.5, 2},
            {"thickness", "", "over that of the thinnest that stands", 1.01, 0.5, 4}},
           kSeconds,
           1.0 / 60,
           fill_thin},
          "a line of thrust just fits inside, so it stands",
          StandTrial::metrics(1e-3, 1e-3, 0),
          {},
          {}};
}

}  // namespace carom::tools::accuracy
