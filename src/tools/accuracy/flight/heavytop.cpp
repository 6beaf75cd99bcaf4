// heavytop: a disk that spins at the end of a stick whose other end a ball joint holds.
#include <cmath>

#include "accuracy/joints/links.h"
#include "accuracy/linkages.h"
#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kMass = 1;  // kg

/// Its middle against the reduced equation of motion, integrated by the classical fourth-order method in steps of
/// 0.1 ms: nods go at 16 rad/s, so its own error in 10 s is below 1e-10 m.
class HeavyTopTrial : public Trial {
 public:
  HeavyTopTrial(std::size_t disk, Mechanism mechanism, const Stage& stage)
      : disk_(disk), mechanism_(std::move(mechanism)), start_(mechanism_.energy(stage)) {}

  void watch(const Stage& stage, double time) override {
    const int steps = std::max(1, static_cast<int>(std::ceil((time - time_) / 1e-4)));
    for (int i = 0; i < steps; ++i) state_ = runge_kutta(state_, (time - time_) / steps, HeavyTop::rate);
    time_ = time;
    place_ = std::max(place_, (stage.position(disk_) - HeavyTop::middle(state_)).norm());
    energy_ = std::max(energy_, std::fabs(mechanism_.energy(stage) / start_ - 1));
    gap_ = std::max(gap_, mechanism_.worst_gap(stage));
  }
  std::vector<double> errors(const Stage&) const override { return {place_, energy_, gap_}; }
  std::vector<TruePose> truth(double) const override {
    const Vec middle = HeavyTop::middle(state_);
    return {{disk_, middle, turn_between(Vec::UnitX(), middle)}};
  }

 private:
  std::size_t disk_;
  Mechanism mechanism_;
  Vec state_ = HeavyTop::start();
  double start_, time_ = 0, place_ = 0, energy_ = 0, gap_ = 0;
};

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>&, const std::string&) {
  Part looks;
  looks.shape = "cylinder";
  looks.params = {HeavyTop::kRadius, HeavyTop::kThick / 2};
  looks.orientation = turn_between(Vec::UnitY(), Vec::UnitX());
  const Vec inertia = kMass * Vec(HeavyTop::axial(), HeavyTop::across(), HeavyTop::across());
  const std::size_t disk = add_link(stage, "disk", HeavyTop::middle(HeavyTop::start()), kMass, inertia, looks);
  set_moving(stage, disk, Vec::Zero(), Vec(HeavyTop::kSpin, 0, 0));
  Mechanism mechanism;
  mechanism.add(disk, kMass, inertia);
  mechanism.add(join(stage, CAROM_JOINT_BALL, CAROM_NULL_HANDLE, stage.actors[disk].body, Vec::Zero()));
  stage.bounds_min = Vec::Constant(-1e3);
  stage.ground_half_width = 0;
  stage.camera_from = Vec(1, 1, 2.5);
  return std::make_unique<HeavyTopTrial>(disk, std::move(mechanism), stage);
}

}  // namespace

Challenge heavytop_challenge() {
  return {6,
          {"heavytop",
           "A disk of r 0.5 m spins at 40 rad/s at the end of a level stick of 0.5 m; the other end is held.",
           "it goes round and nods, and does not fall",
           {},
           10,
           1.0 / 60,
           fill},
          "the reduced equation of motion",
          {{"middle, at worst", "m", 1e-4}, {"energy, at worst, relative", "", kNoBound}, {"gap, at worst", "m", 1e-6}},
          {},
          {2.0e-3, "MuJoCo RK4, 1/960"}};
}

}  // namespace carom::tools::accuracy
