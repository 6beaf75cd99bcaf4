// domino: a wave runs through a row of 40.
#include <cmath>

#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kPitch = 0.5;                 // m, centre to centre
const Vec kHalf(0.075, 0.5, 0.25);             // m
constexpr std::size_t kFrom = 10, kTo = 30;    // the wave is timed between these: past the start, before the end
constexpr double kLean = 0.99619469809174555;  // cosine of 5 degrees: a domino that leans so far has been reached

/// Speed of the wave between two dominoes; the truth is the scene's own at a much finer step.
class DominoTrial : public Trial {
 public:
  explicit DominoTrial(std::vector<std::size_t> row) : row_(std::move(row)) {}

  void watch(const Stage& stage, double time) override {
    reach(stage, time, row_[kFrom], from_);
    reach(stage, time, row_[kTo], to_);
  }
  bool over() const override { return to_.when >= 0; }
  Solution solution() const override { return {speed()}; }
  void compare_with(const Solution& truth) override { truth_ = truth.at(0); }
  std::vector<double> errors(const Stage&) const override { return {std::fabs(speed() / truth_ - 1)}; }
  std::vector<std::string> tell(const Stage&) const override {
    return {"the wave runs at " + std::to_string(speed()) + " m/s, at the finest step at " + std::to_string(truth_)};
  }

 private:
  struct Passage {
    double when = -1, upright = 1, before = 0;  // s; cosine of the lean after the last step, and when that was
  };

  void reach(const Stage& stage, double time, std::size_t domino, Passage& p) const {
    if (p.when >= 0) return;
    const Quat q = stage.orientation(domino);
    const double upright = 1 - 2 * (q.x() * q.x() + q.z() * q.z());
    if (upright < kLean) {  // between two steps the lean grows at an even rate
      const auto lean = [](double cosine) { return std::sqrt(std::max(0.0, 1 - cosine)); };  // small: ~ the angle
      const double share = (lean(kLean) - lean(p.upright)) / (lean(upright) - lean(p.upright));
      p.when = p.before + share * (time - p.before);
    }
    p.upright = upright;
    p.before = time;
  }

  double speed() const {  // m/s; 0: it died away
    return over() ? static_cast<double>(kTo - kFrom) * kPitch / (to_.when - from_.when) : 0;
  }

  std::vector<std::size_t> row_;
  Passage from_, to_;
  double truth_ = 0;
};

std::unique_ptr<Observer> fill_domino(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const double mu = knobs[0];
  add_ground(stage, mu);
  std::vector<std::size_t> row;
  for (int i = 0; i < 40; ++i) row.push_back(add_box(stage, Vec(kPitch * i, kHalf.y(), 0), kHalf, 1, {mu, 0}));
  // The first one is tipped over its lower edge; 0.57 rad/s would just carry it over the top.
  const Vec spin(0, 0, -1), centre(-kHalf.x(), kHalf.y(), 0);
  set_moving(stage, row[0], spin.cross(centre), spin);
  stage.camera_from = Vec(5, 3, 12);
  stage.camera_to = Vec(8, 0, 0);
  return std::make_unique<DominoTrial>(std::move(row));
}

}  // namespace

Challenge domino_challenge() {
  return {25,
          {"domino",
           "40 dominoes of 0.15 x 0.5 x 1 m, half a metre apart; the first is tipped over.",
           "a wave that runs through the row at an even speed",
           {{"mu", "", "friction of everything", 0.5, 0, 2}},
           15,
           1.0 / 60,
           fill_domino},
          "own run at 1/7680 s, same dials",
          {{"speed of the wave, relative", "", 0.01}},
          {},
          {},
          1.0 / 7680};
}

}  // namespace carom::tools::accuracy
