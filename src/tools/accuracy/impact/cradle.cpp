// cradle, cannon: an impact that is passed on through balls that touch.
#include <cmath>

#include "accuracy/reference.h"
#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kRadius = 0.1;  // m

/// One ball flies at 1 m/s into four that touch; afterwards the last one flies and all others rest.
class CradleTrial : public Trial {
 public:
  explicit CradleTrial(const Stage& stage) : crowd_(stage) {}  // of balls alone
  void watch(const Stage& stage, double) override { crowd_.look(stage); }
  std::vector<double> errors(const Stage&) const override {
    double worst = 0;
    for (std::size_t i = 0; i < crowd_.size(); ++i)
      worst = std::max(worst, (crowd_.velocity(i) - (i + 1 < crowd_.size() ? 0 : kSpeed) * Vec::UnitX()).norm());
    return {worst};
  }
  std::vector<TruePose> truth(double time) const override {
    std::vector<TruePose> poses;
    for (std::size_t i = 0; i < crowd_.size(); ++i) poses.push_back({i, crowd_.home(i), {}});
    const double met = kGap / kSpeed;
    poses.front().position.x() += kSpeed * std::min(time, met);
    poses.back().position.x() += kSpeed * std::max(0.0, time - met);
    return poses;
  }
  static constexpr double kGap = 0.05, kSpeed = 1;  // m, m/s: of the first

 private:
  Crowd crowd_;
};

std::unique_ptr<Observer> fill_cradle(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  set_gravity(stage, 0);  // no strings: the balls float in a row
  const int balls = static_cast<int>(knobs[0]);
  for (int i = 0; i < balls; ++i)
    add_ball(stage, Vec(2 * kRadius * i - (i == 0 ? CradleTrial::kGap : 0), 0, 0), kRadius, 1, {0, 1},
             i == 0 ? Vec(CradleTrial::kSpeed, 0, 0) : Vec(0, 0, 0));
  stage.ground_half_width = 0;
  stage.camera_from = Vec(0.5, 0.5, 3);
  stage.camera_to = Vec(0.5, 0, 0);
  return std::make_unique<CradleTrial>(stage);
}

/// At 3:1 the lower ball gives all it has and lies on the ground; the upper one's speed is passed back along its
/// flight to the impact.
class CannonTrial : public Trial {
 public:
  CannonTrial(std::size_t heavy, std::size_t light, double drop)
      : heavy_(heavy), light_(light), speed_(std::sqrt(2 * kGravity * drop)) {}
  void watch(const Stage&, double time) override { time_ = time; }
  std::vector<double> errors(const Stage& stage) const override {
    const Rebound truth = cannon(speed_, kRatio);
    const double flight = time_ - speed_ / kGravity;
    const double light = stage.velocity(light_).y() + kGravity * flight - truth.light;
    const double heavy = stage.velocity(heavy_).y() - truth.heavy;
    return {std::max(std::fabs(light), std::fabs(heavy)) / speed_};
  }

  std::vector<TruePose> truth(double time) const override {
    const double impact = speed_ / kGravity, after = time - impact;
    const Rebound up = cannon(speed_, kRatio);
    const auto height = [&](double speed) {
      return after < 0 ? (speed_ * speed_ / kGravity - kGravity * time * time) / 2
                       : speed * after - kGravity * after * after / 2;
    };
    const Vec light(0, 3 * kRadius + height(up.light), 0), heavy(0, kRadius + std::max(0.0, height(up.heavy)), 0);
    return {{heavy_, heavy, {}}, {light_, light, {}}};
  }

  static constexpr double kRatio = 3;  // of the masses

 private:
  std::size_t heavy_, light_;
  double speed_, time_ = 0;
};

std::unique_ptr<Observer> fill_cannon(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  add_ground(stage, 0);
  const double drop = knobs[0];
  const std::size_t heavy = add_ball(stage, Vec(0, drop + kRadius, 0), kRadius, CannonTrial::kRatio, {0, 1});
  const std::size_t light = add_ball(stage, Vec(0, drop + 3 * kRadius, 0), kRadius, 1, {0, 1});
  stage.camera_from = Vec(0, 2, 8);
  stage.camera_to = Vec(0, 2, 0);
  return std::make_unique<CannonTrial>(heavy, light, drop);
}

}  // namespace

Challenge cradle_challenge() {
  return {12,
          {"cradle",
           "A ball at 1 m/s hits a row of balls that touch; no loss, no gravity.",
           "only the last ball flies on, at the speed of the first",
           {{"balls", "", "how many, the first included", 5, 2, 50, true}},
           1,
           1.0 / 60,
           fill_cradle},
          "the last ball has the speed, all others rest",
          {{"velocity, worst ball", "m/s", 1e-6}},
          {2.2e-16, "Cyclone 4"},
          {0, "Cyclone 4, 1/30"}};
}

Challenge cannon_challenge() {
  return {13,
          {"cannon",
           "A 1 kg ball that lies on a 3 kg ball falls with it from 1 m; no loss.",
           "the upper ball flies off at twice the speed, the lower one stays",
           {{"drop", "m", "height of the lower ball's lowest point", 1, 0.1, 100}},
           0.75,
           1.0 / 60,
           fill_cannon},
          "one elastic impact after the other",
          {{"rebound speed, share of impact speed", "", 1e-3}},
          {},
          {}};
}

}  // namespace carom::tools::accuracy
