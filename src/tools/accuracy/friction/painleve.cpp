// painleve: a rod that slides on its end and leans so that no force can hold it there: the end stops at once.
#include <cmath>

#include "accuracy/reference.h"
#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

/// Spin after the first step against a rod that has stopped on its end and swings about it; energy of 1 kg from then
/// on.
class PainleveTrial : public Trial {
 public:
  PainleveTrial(std::size_t body, const LeaningRod& rod, double depth, double speed)
      : body_(body),
        rod_(rod),
        depth_(depth),
        spin_(rod.spin_after(speed)),
        first_(-kGravity * rod.y() + speed * speed / 2),
        least_(first_) {}

  void watch(const Stage& stage, double time) override {
    std::vector<double> v;
    stage.world.read(CAROM_FIELD_VELOCITY, {stage.actors[body_].body}, v);
    const Eigen::Map<const Vec> u(v.data()), w(v.data() + 3);
    if (jam_ < 0 && time > 0.99 * kLook) jam_ = std::fabs(w.z() - swung(time)) / spin_;
    const Vec spin = stage.orientation(body_).conjugate() * w;
    const double across = (rod_.half * rod_.half + depth_ * depth_) / 3,
                 along = (rod_.thin * rod_.thin + depth_ * depth_) / 3;
    const double energy =
        kGravity * stage.position(body_).y() + u.squaredNorm() / 2 +
        (along * spin.x() * spin.x() + across * spin.y() * spin.y() + rod_.inertia() * spin.z() * spin.z()) / 2;
    gained_ = std::max(gained_, std::isfinite(energy) ? (energy - least_) / first_ : INFINITY);
    least_ = std::min(least_, energy);
  }
  std::vector<double> errors(const Stage&) const override { return {jam_ < 0 ? INFINITY : jam_, gained_}; }

 private:
  static constexpr double kLook = 1.0 / 60;  // s

  /// rad/s, of a rod that hangs on its end since the beginning. Midpoint rule: off by 1e-10.
  double swung(double time) const {
    const double reach2 = rod_.x() * rod_.x() + rod_.y() * rod_.y();
    const auto rate = [&](const Eigen::Vector2d& s) {
      return Eigen::Vector2d(s[1], -kGravity * std::sqrt(reach2) * std::cos(s[0]) / (rod_.inertia() + reach2));
    };
    Eigen::Vector2d state(std::atan2(-rod_.y(), -rod_.x()), spin_);  // of the line from the end to the middle
    constexpr int kSteps = 1000;
    for (int i = 0; i < kSteps; ++i) state += time / kSteps * rate(state + time / (2 * kSteps) * rate(state));
    return state[1];
  }

  std::size_t body_;
  LeaningRod rod_;
  double depth_, spin_, first_, least_, jam_ = -1, gained_ = 0;
};

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const LeaningRod rod{0.5, 0.002, knobs[0] * 3.14159265358979324 / 180};
  const double mu = knobs[1], speed = knobs[2], depth = 0.05;
  add_ground(stage, mu);
  const std::size_t body = add_box(stage, Vec(0, -rod.y(), 0), Vec(rod.half, rod.thin, depth), 1, {mu, 0},
                                   Vec(-speed, 0, 0), Quat(Eigen::AngleAxisd(rod.angle, Vec::UnitZ())));
  stage.camera_from = Vec(0, 0.5, 3), stage.camera_to = Vec(0, 0.3, 0);
  return std::make_unique<PainleveTrial>(body, rod, depth, speed);
}

}  // namespace

Challenge painleve_challenge() {
  return {31,
          {"painleve",
           "A rod that leans by 72 degrees slides on its end over ground of friction 1.5, away from where it leans to.",
           "the end stops at once: no force could hold it while it slides",
           {{"angle", "degrees", "of the rod from the ground", 72, 10, 85},
            {"mu", "", "friction", 1.5, 0, 10},
            {"speed", "m/s", "of the rod", 1, 0.01, 100}},
           5,
           1.0 / 60,
           fill},
          "the one solution of a step: the end stops; then it is a pendulum",
          {{"spin after 1/60 s, relative", "", 0.01}, {"energy gained, relative", "", 0.01}},
          {},
          {}};
}

}  // namespace carom::tools::accuracy
