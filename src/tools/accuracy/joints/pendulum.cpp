// pendulum: a rod hung by one end, let go from the horizontal.
#include <cmath>

#include "accuracy/joints/links.h"
#include "accuracy/reference.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kMass = 1;  // kg

/// The centre against the equation of motion, integrated by the classical fourth-order method in steps of 0.1 ms: its
/// own error in 10 s is below 1e-11 m.
class PendulumTrial : public Trial {
 public:
  PendulumTrial(std::size_t rod, double length, Mechanism mechanism)
      : rod_(rod), length_(length), mechanism_(std::move(mechanism)) {}

  void watch(const Stage& stage, double time) override {
    const double g = 1.5 * kGravity / length_;  // of the angle: m g l/2 over m l^2 / 3
    const auto pull = [&](double angle) { return -g * std::cos(angle); };
    const int steps = std::max(1, static_cast<int>(std::ceil((time - time_) / 1e-4)));
    const double h = (time - time_) / steps;
    for (int i = 0; i < steps; ++i) {
      const double a1 = pull(angle_), w2 = spin_ + h / 2 * a1, a2 = pull(angle_ + h / 2 * spin_),
                   w3 = spin_ + h / 2 * a2, a3 = pull(angle_ + h / 2 * w2), w4 = spin_ + h * a3,
                   a4 = pull(angle_ + h * w3);
      angle_ += h / 6 * (spin_ + 2 * w2 + 2 * w3 + w4);
      spin_ += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    time_ = time;
    place_ = std::max(place_, (stage.position(rod_) - truth(time)[0].position).norm());
    energy_ = std::max(energy_, std::fabs(mechanism_.energy(stage)) / (kMass * kGravity * length_ / 2));
    gap_ = std::max(gap_, mechanism_.worst_gap(stage));
  }
  std::vector<double> errors(const Stage&) const override { return {place_, energy_, gap_}; }
  std::vector<TruePose> truth(double) const override {
    const Quat turned(Eigen::AngleAxisd(angle_, Vec::UnitZ()));
    return {{rod_, length_ / 2 * Vec(std::cos(angle_), std::sin(angle_), 0), turned}};
  }

 private:
  std::size_t rod_;
  double length_, angle_ = 0, spin_ = 0, time_ = 0, place_ = 0, energy_ = 0, gap_ = 0;
  Mechanism mechanism_;
};

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const double length = knobs[0];
  Part looks;
  looks.shape = "box";
  looks.params = {length / 2, 0.01 * length, 0.01 * length};
  const Vec inertia = Vec(1e-4, length * length, length * length) * kMass / 12;
  const std::size_t rod = add_link(stage, "rod", Vec(length / 2, 0, 0), kMass, inertia, looks);
  Mechanism mechanism;
  mechanism.add(rod, kMass, inertia);
  mechanism.add(join(stage, CAROM_JOINT_BALL, CAROM_NULL_HANDLE, stage.actors[rod].body, Vec::Zero()));
  stage.bounds_min = Vec::Constant(-1e3);
  stage.camera_from = Vec(0, -0.5, 3), stage.camera_to = Vec(0, -0.5, 0);
  return std::make_unique<PendulumTrial>(rod, length, std::move(mechanism));
}

}  // namespace

Challenge pendulum_challenge() {
  return {7,
          {"pendulum",
           "A thin rod of 1 m, hung by one end, is let go from the horizontal.",
           "swings that come back as high as they began",
           {{"length", "m", "of the rod", 1, 0.1, 10}},
           10,
           1.0 / 60,
           fill},
          "the equation of motion",
          {{"centre, at worst", "m", 1e-6}, {"energy, at worst", "", kNoBound}, {"gap, at worst", "m", 1e-6}},
          {5.2e-7, "MuJoCo RK4"},
          {2.1e-11, "MuJoCo RK4, 1/960"}};
}

}  // namespace carom::tools::accuracy
