// bouncing, bounce05: balls dropped on level ground that keep all of their energy, or a quarter of it with each bounce.
#include <cmath>

#include "accuracy/impact/energy.h"
#include "accuracy/reference.h"
#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kRadius = 0.1, kMass = 10;  // m, kg

/// Balls that keep their energy come back to where they fell from, again and again.
class LosslessTrial : public EnergyTrial {
 public:
  /// @param drop  m, of the balls, which are all that the stage has but for the ground
  LosslessTrial(const Stage& stage, double drop) : EnergyTrial(stage, kRadius, kMass), drop_(drop) {
    for (std::size_t i = 0; i < stage.actors.size(); ++i)
      if (stage.actors[i].type == CAROM_BODY_DYNAMIC) homes_.push_back({i, stage.position(i), {}});
  }
  std::vector<TruePose> truth(double time) const override {
    std::vector<TruePose> poses = homes_;
    for (TruePose& pose : poses) pose.position.y() = kRadius + bounce_height(time, drop_, 1, kGravity);
    return poses;
  }

 private:
  double drop_;
  std::vector<TruePose> homes_;
};

std::unique_ptr<Observer> fill_bouncing(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  add_ground(stage, 0);
  for (int i = 0; i < 49; ++i)  // a metre apart: they never meet
    add_ball(stage, Vec(i % 7, knobs[0] + kRadius, i / 7), kRadius, kMass, {0, 1});
  stage.camera_from = Vec(3, 6, 25);
  stage.camera_to = Vec(3, 2.5, 3);
  return std::make_unique<LosslessTrial>(stage, knobs[0]);
}

/// Height over time against the closed form, and when the ball was last seen above two millimetres.
class BounceTrial : public Trial {
 public:
  BounceTrial(std::size_t ball, double drop, double e) : ball_(ball), drop_(drop), e_(e) {}

  void watch(const Stage& stage, double time) override {
    const double height = stage.position(ball_).y() - kRadius;
    const double error = height - bounce_height(time, drop_, e_, kGravity);
    sum_ += error * error;
    ++samples_;
    if (height > kLevel) last_above_ = time;
  }
  std::vector<double> errors(const Stage&) const override {
    return {std::sqrt(sum_ / samples_), std::fabs(last_above_ - bounce_last_above(kLevel, drop_, e_, kGravity))};
  }
  std::vector<TruePose> truth(double time) const override {
    return {{ball_, Vec(0, kRadius + bounce_height(time, drop_, e_, kGravity), 0), {}}};
  }

 private:
  static constexpr double kLevel = 2e-3;  // m: between the peaks of the fourth and the fifth bounce, 3.9 and 1 mm
  std::size_t ball_;
  double drop_, e_, sum_ = 0, samples_ = 0, last_above_ = 0;
};

std::unique_ptr<Observer> fill_bounce05(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  add_ground(stage, 0);
  const std::size_t ball = add_ball(stage, Vec(0, knobs[0] + kRadius, 0), kRadius, kMass, {0, knobs[1]});
  stage.camera_from = Vec(0, 1, 4);
  stage.camera_to = Vec(0, 0.5, 0);
  return std::make_unique<BounceTrial>(ball, knobs[0], knobs[1]);
}

}  // namespace

Challenge bouncing_challenge() {
  return {10,
          {"bouncing",
           "49 balls of 10 kg fall from 5 m and bounce without loss for 20 s.",
           "every bounce as high as the drop",
           {{"drop", "m", "height of the balls' lowest points", 5, 0.1, 100}},
           20,
           1.0 / 60,
           fill_bouncing},
          "the energy at the start",
          {{"energy, relative, RMS", "", 1e-6}},
          {1.0e-3, "Box3D 16 substeps"},
          {1.5e-4, "Jolt 4x10, 1/960"}};
}

Challenge bounce05_challenge() {
  return {11,
          {"bounce05",
           "A ball falls from 1 m and keeps half of its speed with each bounce, until it lies.",
           "ever smaller bounces that end after three times the fall",
           {{"drop", "m", "height of the ball's lowest point", 1, 0.1, 100}, {"e", "", "restitution", 0.5, 0.1, 0.9}},
           1.5,
           1.0 / 60,
           fill_bounce05},
          "parabolas between impacts, closed form",
          {{"height, RMS", "m", 1e-4}, {"last time above 2 mm", "s", kNoBound}},
          {6.3e-3, "Jolt 4x10"},
          {2.5e-4, "Jolt 4x10, 1/960"}};
}

}  // namespace carom::tools::accuracy
