// rolling, skid: solid balls that are set rolling by friction, under a plate's pull or out of a slide.
#include <cmath>

#include "accuracy/reference.h"
#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kPull = 150, kPlateMass = 10, kBallMass = 1, kRadius = 0.5;  // N, kg, kg, m
constexpr double kGroundFriction = 0.4, kBallFriction = 0.8;                  // of plate on ground; of ball on plate
constexpr int kBalls = 25;
const Vec kHeading(0.5, 0, 0.866025403784438647);  // 60 degrees off an axis of the world

/// Mean over bodies and steps of the squared error of velocity; the plate is pulled on along the way.
class RollingTrial : public Trial {
 public:
  RollingTrial(const Stage& stage, std::size_t plate) : crowd_(stage), plate_(plate) {}

  void watch(const Stage& stage, double time) override {
    crowd_.look(stage);
    const RollingPlate a = rolling_plate(kPull, kGroundFriction, kPlateMass, kBallMass, kBalls, kGravity);
    for (std::size_t i = 0; i < crowd_.size(); ++i)  // the plate is first
      sum_ += (crowd_.velocity(i) - (i == 0 ? a.plate : a.ball) * time * kHeading).squaredNorm();
    samples_ += static_cast<double>(crowd_.size());
  }
  std::vector<double> errors(const Stage&) const override { return {sum_ / samples_}; }
  std::vector<Push> pushes() const override { return {{plate_, kPull * kHeading}}; }

 private:
  Crowd crowd_;
  std::size_t plate_;
  double sum_ = 0, samples_ = 0;
};

std::unique_ptr<Observer> fill_rolling(Stage& stage, const std::vector<double>&, const std::string&) {
  add_ground(stage, kGroundFriction);
  const std::size_t plate = add_box(stage, Vec(0, 0.5, 0), Vec(10, 0.5, 10), kPlateMass, {kGroundFriction, 0});
  const double mu = kBallFriction * kBallFriction / kGroundFriction;  // the geometric mean with the plate's is 0.8
  for (int i = 0; i < kBalls; ++i)
    add_ball(stage, Vec(3 * (i % 5 - 2), 1 + kRadius, 3 * (i / 5 - 2)), kRadius, kBallMass, {mu, 0});
  stage.camera_from = Vec(0, 10, 25);
  return std::make_unique<RollingTrial>(stage, plate);
}

/// Speed at the end, and when the ball began to roll: its slip falls by 7/2 mu g a second, so the last step on which it
/// slipped tells.
class SkidTrial : public Trial {
 public:
  SkidTrial(std::size_t ball, double speed, double mu) : ball_(ball), speed_(speed), mu_(mu) {}

  void watch(const Stage& stage, double time) override {
    double v[6];
    Call call;
    call.done(carom_world_read(stage.world.get(), CAROM_FIELD_VELOCITY, CAROM_SCALAR_F64, &stage.actors[ball_].body, 1,
                               v, 0, call),
              "reading the ball");
    final_ = v[0];
    const double slip = v[0] + kRadius * v[5];  // of the lowest point; rolling to +x spins about -z
    if (slip > 1e-3 * speed_) onset_ = time + slip / (3.5 * mu_ * kGravity);
  }
  std::vector<double> errors(const Stage&) const override {
    const Skid rolls = skid(speed_, mu_, kGravity);
    return {std::fabs(final_ - rolls.final_speed), std::fabs(onset_ - rolls.onset)};
  }
  std::vector<TruePose> truth(double time) const override {
    const Skid rolls = skid(speed_, mu_, kGravity);
    const double slid = std::min(time, rolls.onset);
    const double way = (speed_ - mu_ * kGravity * slid / 2) * slid + rolls.final_speed * (time - slid);
    return {{ball_, Vec(way, kRadius, 0), {}}};
  }

 private:
  std::size_t ball_;
  double speed_, mu_, final_ = 0, onset_ = 0;
};

std::unique_ptr<Observer> fill_skid(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const double speed = knobs[0], mu = knobs[1];
  add_ground(stage, mu);
  const std::size_t ball = add_ball(stage, Vec(0, kRadius, 0), kRadius, 1, {mu, 0}, speed * Vec::UnitX());
  stage.camera_from = Vec(3, 2, 8);
  stage.camera_to = Vec(3, 0, 0);
  return std::make_unique<SkidTrial>(ball, speed, mu);
}

}  // namespace

Challenge rolling_challenge() {
  return {19,
          {"rolling",
           "A plate with 25 balls on it is pulled over rough ground, 60 degrees off an axis.",
           "all balls roll backwards on the plate in step",
           {},
           4,
           1.0 / 60,
           fill_rolling},
          "steady accelerations, closed form",
          {{"velocity, mean square", "m^2/s^2", 1e-10}},
          {4.6e-7, "Jolt 50"},
          {1.7e-9, "Bullet erp 0, 50, 1/240"}};
}

Challenge skid_challenge() {
  return {20,
          {"skid",
           "A ball without spin slides over level ground until it rolls.",
           "it keeps 5/7 of its speed",
           {{"speed", "m/s", "at the start", 5, 0.1, 50}, {"mu", "", "friction of ball and ground", 0.2, 0.01, 2}},
           2,
           1.0 / 60,
           fill_skid},
          "5/7 v0 from t = 2 v0 / (7 mu g) on",
          {{"speed at the end", "m/s", 1e-4}, {"onset of rolling", "s", 1e-4}},
          {},
          {}};
}

}  // namespace carom::tools::accuracy
