// fourbar: a row of windows whose bars turn as one (the benchmark A02 of the IFToMM library of multibody problems).
#include <cmath>
#include <numbers>

#include "accuracy/joints/links.h"
#include "accuracy/reference.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kMass = 1, kLength = 1;  // kg, m, of each bar
constexpr double kStart = 1;              // m/s, of the upper ends, which stand highest at first

/// All bars that stand turn alike, those across keep level: one angle. Its equation of motion is integrated by the
/// classical fourth-order method in steps of 0.1 ms; its own error in 10 s is below 1e-10 rad.
class FourbarTrial : public Trial {
 public:
  /// @param bar  the first that stands; then, window by window, the next that stands and the one across
  FourbarTrial(std::size_t bar, int windows, Mechanism mechanism)
      : bar_(bar), windows_(windows), mechanism_(std::move(mechanism)) {
    const double n = windows, weigh = (n + 1) / 2 + n, resist = (n + 1) / 3 + n;
    pull_ = kGravity * weigh / (kLength * resist);
    energy_then_ = kMass * (resist * kStart * kStart / 2 + weigh * kGravity * kLength);
  }

  void watch(const Stage& stage, double time) override {
    const auto pull = [&](double angle) { return -pull_ * std::cos(angle); };
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
    place_ = std::max(place_, (stage.position(bar_) - truth(time)[0].position).norm());
    energy_ = std::max(energy_, std::fabs(mechanism_.energy(stage) - energy_then_));
    gap_ = std::max(gap_, mechanism_.worst_gap(stage));
  }
  std::vector<double> errors(const Stage&) const override { return {energy_, place_, gap_}; }
  std::vector<TruePose> truth(double) const override {
    const Quat turned(Eigen::AngleAxisd(angle_, Vec::UnitZ()));
    const Vec along = kLength * Vec(std::cos(angle_), std::sin(angle_), 0);
    std::vector<TruePose> poses = {{bar_, along / 2, turned}};
    for (int i = 1; i <= windows_; ++i) {
      const std::size_t next = bar_ + 2 * static_cast<std::size_t>(i) - 1;
      poses.push_back({next, along / 2 + Vec(kLength * i, 0, 0), turned});
      poses.push_back({next + 1, along + Vec(kLength * (i - 0.5), 0, 0), Quat::Identity()});
    }
    return poses;
  }

 private:
  std::size_t bar_;
  int windows_;
  double pull_ = 0, energy_then_ = 0;
  double angle_ = std::numbers::pi / 2, spin_ = -kStart / kLength, time_ = 0, place_ = 0, energy_ = 0, gap_ = 0;
  Mechanism mechanism_;
};

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const int windows = static_cast<int>(knobs[0]);
  Part looks;
  looks.shape = "box";
  looks.params = {kLength / 2, 0.01 * kLength, 0.01 * kLength};
  const Vec inertia = Vec(1e-4, 1, 1) * (kMass * kLength * kLength / 12);
  const Quat upright(Eigen::AngleAxisd(std::numbers::pi / 2, Vec::UnitZ()));
  Mechanism mechanism;
  // A flat world, so that points which stay together are hinges, and loops hold nothing twice across the plane.
  const auto add = [&](const Vec& at, const Quat& orientation, const Vec& velocity, double spin) {
    const std::size_t bar = add_link(stage, "bar", at, kMass, inertia, looks, orientation);
    const double turn[3] = {0, 0, spin};
    Call call;
    call.done(carom_body_set_locks(stage.world.get(), stage.actors[bar].body, CAROM_LOCK_PLANE, call), "a flat world");
    call.done(carom_body_set_velocity(stage.world.get(), stage.actors[bar].body, velocity.data(), turn, call),
              "pushing a bar");
    mechanism.add(bar, kMass, inertia);
    return bar;
  };
  const auto pin = [&](carom_body a, carom_body b, const Vec& at) {
    mechanism.add(join(stage, CAROM_JOINT_BALL, a, b, at));
  };
  std::size_t first = 0, before = 0;
  for (int i = 0; i <= windows; ++i) {
    const Vec foot(kLength * i, 0, 0), head = foot + Vec(0, kLength, 0);
    const std::size_t bar = add((foot + head) / 2, upright, Vec(kStart / 2, 0, 0), -kStart / kLength);
    pin(CAROM_NULL_HANDLE, stage.actors[bar].body, foot);
    if (i == 0) {
      first = bar;
    } else {
      const std::size_t across = add(head - Vec(kLength / 2, 0, 0), Quat::Identity(), Vec(kStart, 0, 0), 0);
      pin(stage.actors[before].body, stage.actors[across].body, head - Vec(kLength, 0, 0));
      pin(stage.actors[across].body, stage.actors[bar].body, head);
    }
    before = bar;
  }
  stage.bounds_min = Vec::Constant(-1e3);
  stage.camera_from = Vec(windows / 2.0, 0, windows + 2.0), stage.camera_to = Vec(windows / 2.0, 0, 0);
  return std::make_unique<FourbarTrial>(first, windows, std::move(mechanism));
}

}  // namespace

Challenge fourbar_challenge() {
  return {9,
          {"fourbar",
           "A row of 40 windows, hinged at every corner, falls over to one side and swings round.",
           "bars that stay parallel, also as all of them lie in one line",
           {{"n", "", "windows", 40, 1, 400, true}},
           10,
           1.0 / 60,
           fill},
          "the equation of motion of one angle",
          {{"energy, at worst", "J", 1e-3}, {"place of a bar, at worst", "m", kNoBound}, {"gap, at worst", "m", 1e-4}},
          {},
          {}};
}

}  // namespace carom::tools::accuracy
