// bricard: five bars and the ground in a ring of six hinges, which hold each other once more than they need (the
// benchmark A04 of the IFToMM library of multibody problems).
#include <cmath>

#include "accuracy/joints/links.h"
#include "accuracy/linkages.h"
#include "accuracy/reference.h"

namespace carom::tools::accuracy {
namespace {

class BricardTrial : public Trial {
 public:
  BricardTrial(std::array<std::size_t, 5> bars, Mechanism mechanism, const Stage& stage)
      : bars_(bars), mechanism_(std::move(mechanism)), start_(mechanism_.energy(stage)) {}

  void watch(const Stage& stage, double time) override {
    const int steps = std::max(1, static_cast<int>(std::ceil((time - time_) / 1e-3)));
    for (int i = 0; i < steps; ++i) motion_ = runge_kutta(motion_, (time - time_) / steps, BricardMotion::rate);
    time_ = time;
    const BricardPose truth = bricard(motion_[0]);
    for (std::size_t k = 0; k < bars_.size(); ++k)
      place_ = std::max(place_, (stage.position(bars_[k]) - truth.bars[k].middle).norm());
    energy_ = std::max(energy_, std::fabs(mechanism_.energy(stage) - start_));
    gap_ = std::max(gap_, mechanism_.worst_gap(stage));
  }
  std::vector<double> errors(const Stage&) const override { return {energy_, place_, gap_}; }
  std::vector<TruePose> truth(double) const override {
    const BricardPose pose = bricard(motion_[0]);
    std::vector<TruePose> poses;
    for (std::size_t k = 0; k < bars_.size(); ++k)
      poses.push_back({bars_[k], pose.bars[k].middle, Quat(pose.bars[k].axes)});
    return poses;
  }

 private:
  std::array<std::size_t, 5> bars_;
  Mechanism mechanism_;
  double start_, time_ = 0, energy_ = 0, place_ = 0, gap_ = 0;
  Eigen::Vector2d motion_ = Eigen::Vector2d::Zero();
};

/// @param axis  of a hinge, unit   @return joint -> world
Quat hinge_along(const Vec& axis) { return turn_between(Vec::UnitX(), axis); }

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>&, const std::string&) {
  const BricardPose pose = bricard(0);
  Part looks;
  looks.shape = "box";
  looks.params = {0.5, BricardMotion::kThick / 2, BricardMotion::kThick / 2};
  Mechanism mechanism;
  std::array<std::size_t, 5> bars{};
  carom_body before = CAROM_NULL_HANDLE;
  for (std::size_t k = 0; k < bars.size(); ++k) {
    const BricardPose::Bar& bar = pose.bars[k];
    bars[k] = add_link(stage, "bar", bar.middle, 1, BricardMotion::inertia(), looks, Quat(bar.axes));
    mechanism.add(bars[k], 1, BricardMotion::inertia());
    const carom_body body = stage.actors[bars[k]].body;
    mechanism.add(
        join(stage, CAROM_JOINT_HINGE, before, body, bar.middle - bar.axes.col(0) / 2, hinge_along(bar.axes.col(1))));
    before = body;
  }
  mechanism.add(join(stage, CAROM_JOINT_HINGE, before, CAROM_NULL_HANDLE, pose.end, hinge_along(pose.end_axis)));
  stage.bounds_min = Vec::Constant(-1e3);
  stage.ground_half_width = 0;
  stage.camera_from = Vec(3, 1.5, 3), stage.camera_to = Vec(0.5, -0.5, 0.5);
  return std::make_unique<BricardTrial>(bars, std::move(mechanism), stage);
}

}  // namespace

Challenge bricard_challenge() {
  return {9,
          {"bricard",
           "Five bars along edges of a cube, in a ring of six hinges with the ground, are let go.",
           "a ring that turns inside out, again and again, though counting hinges says that it can't move",
           {},
           10,
           1.0 / 60,
           fill},
          "the equation of motion of its one freedom",
          {{"energy, at worst", "J", 1e-3}, {"place of a bar, at worst", "m", kNoBound}, {"gap, at worst", "m", 1e-4}},
          {},
          {}};
}

}  // namespace carom::tools::accuracy
