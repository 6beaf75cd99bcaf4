// cone, ladder: what touches along a line, and what leans on two surfaces and comes off one.
#include <cmath>

#include "accuracy/linkages.h"
#include "accuracy/reference.h"
#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kPart = 1e-4;  // s, of the steps in which equations of motion are integrated

/// The angle of the cone's axis about the vertical of its slope.
class ConeTrial : public Trial {
 public:
  ConeTrial(std::size_t body, const SlopeCone& cone, double from) : body_(body), cone_(cone), state_(from, 0) {}

  void watch(const Stage& stage, double time) override {
    const int parts = std::max(1, static_cast<int>(std::ceil((time - time_) / kPart)));
    for (int i = 0; i < parts; ++i)
      state_ = runge_kutta(state_, (time - time_) / parts,
                           [&](const Eigen::Vector2d& s) { return cone_.rate(s, kGravity); });
    time_ = time;
    const Vec axis = stage.orientation(body_) * -Vec::UnitY();  // from the apex to the base
    worst_ = std::max(worst_, std::fabs(std::atan2(axis.z(), axis.x()) - state_.x()));
  }
  std::vector<double> errors(const Stage&) const override { return {worst_}; }
  std::vector<TruePose> truth(double) const override {
    const Vec axis = axis_at(cone_, state_.x());
    return {{body_, cone_.height / 2 * axis, turn_between(Vec::UnitY(), -axis)}};
  }
  /// From the apex, which is at the origin, to the base.
  static Vec axis_at(const SlopeCone& cone, double angle) {
    return {std::cos(cone.half_angle) * std::cos(angle), std::sin(cone.half_angle),
            std::cos(cone.half_angle) * std::sin(angle)};
  }

 private:
  std::size_t body_;
  SlopeCone cone_;
  Eigen::Vector2d state_;
  double time_ = 0, worst_ = 0;
};

std::unique_ptr<Observer> fill_cone(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const SlopeCone cone{knobs[0], knobs[1], knobs[2]};
  constexpr double kFrom = 0.5;  // rad
  const Vec pull = kGravity * Vec(std::sin(cone.slope), -std::cos(cone.slope), 0);
  Call call;
  call.done(carom_world_set_gravity(stage.world.get(), pull.data(), call), "setting gravity");
  add_ground(stage, 1);
  Actor actor;
  actor.kind = actor.name = "cone";
  const Vec axis = ConeTrial::axis_at(cone, kFrom);
  actor.position = cone.height / 2 * axis;
  actor.orientation = Quat::FromTwoVectors(Vec::UnitY(), -axis);
  actor.mass = 1;
  Part part;
  part.shape = "cone", part.params = {cone.height * std::tan(cone.half_angle), cone.height / 2}, part.friction = 1;
  actor.parts.push_back(part);
  const std::size_t body = stage.add(std::move(actor));
  stage.camera_from = Vec(1, 2, 3) * cone.height, stage.camera_to = Vec::Zero();
  return std::make_unique<ConeTrial>(body, cone, kFrom);
}

/// The middle of the rod.
class LadderTrial : public Trial {
 public:
  LadderTrial(std::size_t body, const Ladder& ladder, double from) : body_(body), ladder_(ladder), motion_(from) {}

  void watch(const Stage& stage, double time) override {
    if (motion_.angle() < kFlat) return;
    const int parts = std::max(1, static_cast<int>(std::ceil((time - time_) / kPart)));
    for (int i = 0; i < parts; ++i) motion_.step(ladder_, (time - time_) / parts, kGravity);
    time_ = time;
    if (motion_.angle() < kFlat) return;
    worst_ = std::max(worst_, (stage.position(body_) - motion_.middle(ladder_)).norm());
  }
  std::vector<double> errors(const Stage&) const override { return {worst_}; }
  std::vector<TruePose> truth(double) const override {
    if (motion_.angle() < kFlat) return {};
    const Vec along(-std::cos(motion_.angle()), std::sin(motion_.angle()), 0);
    return {{body_, motion_.middle(ladder_), turn_between(Vec::UnitY(), along)}};
  }

 private:
  static constexpr double kFlat = 0.1;  // rad: up to where it is followed
  std::size_t body_;
  Ladder ladder_;
  Ladder::Motion motion_;
  double time_ = 0, worst_ = 0;
};

std::unique_ptr<Observer> fill_ladder(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const Ladder ladder{knobs[0] / 2, 0.01 * knobs[0]};
  const double from = knobs[1];
  add_ground(stage, 0);
  Part part;
  part.shape = "half_space", part.params = {1, 0, 0, 0}, part.friction = 0;
  Actor wall;
  wall.kind = wall.name = "wall", wall.type = CAROM_BODY_STATIC;
  wall.parts.push_back(part);
  stage.add(std::move(wall));
  Actor actor;
  actor.kind = actor.name = "ladder";
  actor.position = Ladder::Motion(from).middle(ladder);
  actor.orientation = Quat::FromTwoVectors(Vec::UnitY(), Vec(-std::cos(from), std::sin(from), 0));
  actor.mass = 1, actor.inertia = Vec(ladder.inertia(), 1e-3 * ladder.inertia(), ladder.inertia()).asDiagonal();
  part.shape = "capsule", part.params = {ladder.radius, ladder.half};
  actor.parts.push_back(part);
  const std::size_t body = stage.add(std::move(actor));
  stage.camera_from = Vec(1, 1, 4) * ladder.half, stage.camera_to = Vec(0.5, 0.5, 0) * ladder.half;
  return std::make_unique<LadderTrial>(body, ladder, from);
}

}  // namespace

Challenge cone_challenge() {
  return {48,
          {"cone",
           "A cone that lies on a slope rolls to and fro about its apex.",
           "a cone that swings as a pendulum",
           {{"height", "m", "of the cone", 1, 0.01, 10},
            {"angle", "rad", "half of its apex", 0.436, 0.1, 1.2},
            {"slope", "rad", "of the ground", 0.175, 0.01, 0.5}},
           4,
           1.0 / 60,
           fill_cone},
          "equation of a pendulum that rolls on its side",
          {{"angle, at worst", "rad", 1e-3}},
          {},
          {}};
}

Challenge ladder_challenge() {
  return {49,
          {"ladder",
           "A rod slides down a smooth wall and floor, and leaves the wall by itself.",
           "a ladder whose upper end comes off the wall before it is down",
           {{"length", "m", "of the rod", 2, 0.01, 100}, {"from", "rad", "above the floor", 1.047, 0.3, 1.5}},
           1,
           1.0 / 60,
           fill_ladder},
          "equation of motion on two surfaces, then on one",
          {{"place, at worst", "m", 1e-3}},
          {},
          {}};
}

}  // namespace carom::tools::accuracy
