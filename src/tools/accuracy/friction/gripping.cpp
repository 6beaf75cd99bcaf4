// grip, shake: what two pads hold by friction alone does not creep, at rest and while the gripper shakes.
//
// The first is the case of mujoco#3328 (2026-06): a capsule of 45 g between pads whose friction bears tens of its weight,
// which regularised friction lets down by 50 to 155 um/s. The second is what robots do with it.
#include <cmath>

#include "accuracy/joints/links.h"
#include "accuracy/reference.h"
#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kSettled = 0.5;  // s, from where on creep is measured
constexpr double kSpeed = 0.1;    // m/s, at which pads close until they press

/// How fast a body creeps along its pads, and how far it comes from where it was held.
class HoldTrial : public Trial {
 public:
  /// @param held, holder  actors: places of the one are told in the frame of the other
  HoldTrial(std::size_t held, std::size_t holder) : held_(held), holder_(holder) {}

  void watch(const Stage& stage, double time) override {
    const Vec at = stage.orientation(holder_).conjugate() * (stage.position(held_) - stage.position(holder_));
    if (time < kSettled) return;
    if (begun_ < 0) begun_ = time, from_ = at;
    worst_ = std::max(worst_, (at - from_).norm());
    if (time > begun_) speed_ = (at - from_).norm() / (time - begun_);
  }
  std::vector<double> errors(const Stage&) const override { return {speed_, worst_}; }

 private:
  std::size_t held_, holder_;
  double begun_ = -1, speed_ = 0, worst_ = 0;
  Vec from_ = Vec::Zero();
};

/// A pad on a rail of the gripper along x, pressed by a motor.   @param side  +-1: it presses towards the middle
void add_pad(Stage& stage, const Vec& middle, double side, double thick, carom_body gripper, double force) {
  constexpr double kPad = 0.004;  // m, half its thickness
  const Vec at = middle + side * Vec(thick + kPad + 1e-4, 0, 0);
  const std::size_t pad = add_box(stage, at, Vec(kPad, 0.02, 0.02), 0.05, {0.7, 0});
  const Quat axes = side > 0 ? Quat(Eigen::AngleAxisd(M_PI, Vec::UnitY())) : Quat::Identity();
  const carom_joint rail = join(stage, CAROM_JOINT_SLIDER, gripper, stage.actors[pad].body, at, axes);
  carom_joint_motor motor;
  carom_joint_motor_init(&motor, sizeof motor);
  motor.enabled = 1, motor.speed = kSpeed, motor.max_force = force;
  Call call;
  call.done(carom_joint_set_motor(stage.world.get(), rail, CAROM_COORDINATE_SLIDE, &motor, call), "driving a pad");
}

/// A capsule or a box of 45 g, its friction 0.7, between two pads.
std::size_t add_held(Stage& stage, const Vec& at, const char* shape, const std::vector<double>& params) {
  Actor actor;
  actor.kind = actor.name = "held";
  actor.position = at, actor.mass = 0.045;
  actor.orientation = Quat::FromTwoVectors(Vec::UnitY(), Vec::UnitZ());
  Part part;
  part.shape = shape, part.params = params, part.friction = 0.7;
  actor.parts.push_back(part);
  return stage.add(std::move(actor));
}

std::unique_ptr<Observer> fill_grip(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  constexpr double kRadius = 0.004;  // m
  const Vec middle(0, 0.5, 0);
  Actor frame;
  frame.kind = frame.name = "frame", frame.type = CAROM_BODY_STATIC, frame.position = middle;
  const std::size_t holder = stage.add(std::move(frame));
  const std::size_t held = add_held(stage, middle, "capsule", {kRadius, 0.015});
  for (const double side : {-1.0, 1.0}) add_pad(stage, middle, side, kRadius, stage.actors[holder].body, knobs[0]);
  stage.camera_from = Vec(0.05, 0.55, 0.15), stage.camera_to = middle;
  return std::make_unique<HoldTrial>(held, holder);
}

std::unique_ptr<Observer> fill_shake(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  constexpr double kHalf = 0.01, kMass = 5;  // m, kg
  const double amplitude = knobs[1], frequency = knobs[2];
  const Vec middle(0, 0.5, 0);
  // The palm swings up and down on a rail to the world, from where its spring is stretched.
  Part looks;
  looks.shape = "box", looks.params = {0.04, 0.005, 0.02};
  const std::size_t palm = add_link(stage, "palm", middle + Vec(0, 0.06, 0), kMass, Vec::Constant(0.01), looks);
  const Quat up(Eigen::AngleAxisd(M_PI / 2, Vec::UnitZ()));
  const carom_joint rail =
      join(stage, CAROM_JOINT_SLIDER, CAROM_NULL_HANDLE, stage.actors[palm].body, stage.actors[palm].position, up);
  carom_joint_spring spring;
  carom_joint_spring_init(&spring, sizeof spring);
  const double rate = 2 * M_PI * frequency;
  spring.enabled = 1, spring.target = amplitude + kGravity / (rate * rate), spring.frequency = frequency,
  spring.damping = 0;
  Call call;
  call.done(carom_joint_set_spring(stage.world.get(), rail, CAROM_COORDINATE_SLIDE, &spring, call), "hanging the palm");
  const std::size_t held = add_held(stage, middle, "box", {kHalf, kHalf, kHalf});
  for (const double side : {-1.0, 1.0}) add_pad(stage, middle, side, kHalf, stage.actors[palm].body, knobs[0]);
  stage.bounds_min = Vec::Constant(-10);
  stage.camera_from = Vec(0.1, 0.6, 0.4), stage.camera_to = middle;
  return std::make_unique<HoldTrial>(held, palm);
}

}  // namespace

Challenge grip_challenge() {
  return {50,
          {"grip",
           "A capsule is held between two pads by friction alone.",
           "a capsule that stays where it is",
           {{"force", "N", "of each pad", 12, 0.5, 200}},
           10,
           1.0 / 60,
           fill_grip},
          "it does not move, friction bears 38 times its weight",
          {{"creep", "m/s", 1e-6}, {"place, at worst", "m", 1e-5}},
          {},
          {}};
}

Challenge shake_challenge() {
  return {51,
          {"shake",
           "Two fingers hold a box by friction while the palm shakes.",
           "a box that stays in the gripper",
           {{"force", "N", "of each finger", 12, 0.5, 200},
            {"amplitude", "m", "of the palm's way", 0.05, 0, 0.5},
            {"frequency", "Hz", "at which it shakes", 3, 0.1, 10}},
           10,
           1.0 / 60,
           fill_shake},
          "it does not slip, friction bears 13 times what is asked",
          {{"creep", "m/s", 1e-6}, {"place, at worst", "m", 1e-5}},
          {},
          {}};
}

}  // namespace carom::tools::accuracy
