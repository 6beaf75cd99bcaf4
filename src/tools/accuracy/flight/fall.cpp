// freefall, drag: what is thrown, through nothing and through air.
#include <cmath>

#include "accuracy/reference.h"
#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kRadius = 0.1;  // m
const Vec kThrown(3, 1, 4);      // m/s

/// A ball whose way and speed are known at any time: errors are the worst of any step.
class FlightTrial : public Trial {
 public:
  void watch(const Stage& stage, double time) override {
    place_ = std::max(place_, (stage.position(0) - truth(time)[0].position).norm());
  }
  std::vector<TruePose> truth(double time) const override {
    return {{0, -0.5 * kGravity * time * time * Vec::UnitY() + kThrown * time, {}}};
  }
  std::vector<double> errors(const Stage&) const override { return {place_}; }

 private:
  double place_ = 0;
};

std::unique_ptr<Observer> fill_freefall(Stage& stage, const std::vector<double>&, const std::string&) {
  add_ball(stage, Vec::Zero(), kRadius, 1, {}, kThrown);
  stage.bounds_min = Vec::Constant(-1e3);
  stage.ground_half_width = 0;
  stage.camera_from = Vec(20, 5, 60), stage.camera_to = Vec(15, -10, 0);
  return std::make_unique<FlightTrial>();
}

/// One ball is thrown where drag grows with the speed, one falls from rest where it grows with its square.
class DragTrial : public Trial {
 public:
  DragTrial(std::size_t thrown, std::size_t fallen, double linear, double quadratic)
      : thrown_(thrown), fallen_(fallen), linear_(linear), quadratic_(quadratic) {}

  void watch(const Stage& stage, double time) override {
    const std::vector<TruePose> poses = truth(time);
    slow_ = std::max(slow_, (stage.position(thrown_) - poses[0].position).norm());
    fast_ = std::max(fast_, (stage.position(fallen_) - poses[1].position).norm());
    const Course down = fallen_through_air(time, quadratic_, kGravity);
    last_ = std::fabs(-stage.velocity(fallen_).y() / down.speed - 1);
  }
  std::vector<double> errors(const Stage&) const override { return {slow_, fast_, last_}; }
  std::vector<TruePose> truth(double time) const override {
    const Course x = thrown_into_air(time, kThrown.x(), linear_, 0), z = thrown_into_air(time, kThrown.z(), linear_, 0),
                 y = thrown_into_air(time, kThrown.y(), linear_, -kGravity);
    const Course down = fallen_through_air(time, quadratic_, kGravity);
    return {{thrown_, Vec(x.way, y.way, z.way), {}}, {fallen_, kBeside - down.way * Vec::UnitY(), {}}};
  }

  static const Vec kBeside;  // m, where the second one starts: they never meet

 private:
  std::size_t thrown_, fallen_;
  double linear_, quadratic_, slow_ = 0, fast_ = 0, last_ = 0;
};
const Vec DragTrial::kBeside(-100, 0, 0);

std::unique_ptr<Observer> fill_drag(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const double linear = knobs[0], quadratic = knobs[1];  // of 1 kg
  const std::size_t thrown = add_ball(stage, Vec::Zero(), kRadius, 1, {}, kThrown);
  const std::size_t fallen = add_ball(stage, DragTrial::kBeside, kRadius, 1, {});
  stage.set_drag(thrown, linear, 0);
  stage.set_drag(fallen, 0, quadratic);
  stage.bounds_min = Vec::Constant(-1e3);
  stage.ground_half_width = 0;
  stage.camera_from = Vec(-50, 5, 150), stage.camera_to = Vec(-50, -20, 0);
  return std::make_unique<DragTrial>(thrown, fallen, linear, quadratic);
}

}  // namespace

Challenge freefall_challenge() {
  return {1,
          {"freefall",
           "A ball is thrown at (3, 1, 4) m/s and falls for 10 s.",
           "a parabola",
           {},
           10,
           1.0 / 60,
           fill_freefall},
          "v0 t - g t^2 / 2",
          {{"place, at worst", "m", 1e-9}},
          {1.7e-12, "MuJoCo RK4"},
          {1.9e-13, "MuJoCo RK4, 1/30"}};
}

Challenge drag_challenge() {
  return {2,
          {"drag",
           "A ball is thrown into air whose drag grows with the speed, another falls where it grows with its square.",
           "the first comes nowhere near its parabola, the second falls evenly in the end",
           {{"linear", "kg/s", "drag of the first over its speed", 0.1, 1e-3, 10},
            {"quadratic", "kg/m", "drag of the second over its speed squared", 0.1, 1e-3, 10}},
           10,
           1.0 / 60,
           fill_drag},
          "linear: v_t + (v0 - v_t) e^(-k t / m); quadratic: v_t tanh(g t / v_t); and their integrals",
          {{"place, linear, at worst", "m", 1e-6},
           {"place, quadratic, at worst", "m", 1e-6},
           {"speed at the end, quadratic, relative", "", 1e-6}},
          {},
          {}};
}

}  // namespace carom::tools::accuracy
