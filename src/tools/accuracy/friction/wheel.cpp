// wheel, tray, turntable: what rolls without slip, by closed forms: a wheel in a leaning turn, the same on what could give
// way, a ball on a table that turns.
#include <cmath>

#include "accuracy/linkages.h"
#include "accuracy/reference.h"
#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

/// The farthest that a body's middle is from a circle's point of the moment.
class CircleTrial : public Trial {
 public:
  /// @param round  rad/s about +y   @param middle, start  m: of the circle; where the body begins
  CircleTrial(const Stage& stage, std::size_t body, double round, const Vec& middle, const Vec& start)
      : body_(body), round_(round), middle_(middle), start_(start), turned_(stage.orientation(body)) {}

  void watch(const Stage& stage, double time) override {
    worst_ = std::max(worst_, (stage.position(body_) - truth(time)[0].position).norm());
  }
  std::vector<TruePose> truth(double time) const override {  // spin about its own axis left out
    const Quat gone(Eigen::AngleAxisd(round_ * time, Vec::UnitY()));
    return {{body_, middle_ + gone * (start_ - middle_), gone * turned_}};
  }
  std::vector<double> errors(const Stage&) const override { return {worst_}; }

 private:
  std::size_t body_;
  double round_;
  Vec middle_, start_;
  Quat turned_;
  double worst_ = 0;
};

/// Of the circle on which what begins at `start` with `velocity` goes round.
Vec middle_of(const Vec& start, const Vec& velocity, double round) {
  return start + Vec::UnitY().cross(velocity) / round;
}

/// @param height  m, of the level surface that it rolls on
std::unique_ptr<Observer> roll(Stage& stage, const TurningWheel& wheel, const std::string& kind, double height) {
  Actor actor;
  actor.kind = actor.name = kind;
  actor.position = Vec(0, height - wheel.to_ground().y(), 0);
  actor.orientation = Quat::FromTwoVectors(Vec::UnitY(), wheel.axis());
  actor.linear_velocity = wheel.velocity(kGravity), actor.angular_velocity = wheel.spin(kGravity);
  actor.mass = 1;
  Part part;
  part.shape = "cylinder", part.params = {wheel.radius, wheel.half}, part.friction = 1;
  actor.parts.push_back(part);
  const Vec start = actor.position, middle = middle_of(start, actor.linear_velocity, wheel.round);
  const std::size_t body = stage.add(std::move(actor));
  stage.camera_from = middle + Vec(0, 3, 8), stage.camera_to = middle;
  return std::make_unique<CircleTrial>(stage, body, wheel.round, middle, start);
}

TurningWheel wheel_of(const std::vector<double>& knobs) { return {knobs[0], 0.02 * knobs[0], knobs[1], knobs[2]}; }

std::unique_ptr<Observer> fill_wheel(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  add_ground(stage, 1);
  return roll(stage, wheel_of(knobs), "wheel", 0);
}

/// The coin goes round the tray's middle; friction holds the tray, and a level surface that stays is as good as the ground.
std::unique_ptr<Observer> fill_tray(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const TurningWheel coin = wheel_of(knobs);
  const Vec start(0, -coin.to_ground().y(), 0);
  const Vec middle = middle_of(start, coin.velocity(kGravity), coin.round);
  const double wide = 2 * ((middle - start).norm() + coin.radius), thick = 0.05 * wide;
  add_ground(stage, 1);
  add_solid(stage, "cylinder", {wide / 2, thick / 2}, Vec(middle.x(), thick / 2, middle.z()), knobs[3], {1, 0});
  return roll(stage, coin, "coin", thick);
}

std::unique_ptr<Observer> fill_turntable(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const double rate = knobs[0], radius = knobs[1];
  Actor table;
  table.kind = table.name = "table", table.type = CAROM_BODY_KINEMATIC;
  table.position = Vec(0, -0.2, 0), table.angular_velocity = rate * Vec::UnitY();
  Part part;
  part.shape = "cylinder", part.params = {5, 0.2}, part.friction = 1;
  table.parts.push_back(part);
  stage.add(std::move(table));
  const Vec start(0.5, radius, 0), velocity(0.2, 0, -0.4);
  // Its point goes with the table from the beginning: v + w x (-r y) = rate y x p
  const Vec spin = Vec::UnitY().cross(velocity - rate * Vec::UnitY().cross(Vec(0.5, 0, 0))) / radius;
  const std::size_t ball = add_ball(stage, start, radius, 1, {1, 0}, velocity);
  Call call;
  call.done(carom_body_set_velocity(stage.world.get(), stage.actors[ball].body, velocity.data(), spin.data(), call),
            "setting the ball rolling");
  stage.camera_from = Vec(0, 4, 6), stage.camera_to = Vec::Zero();
  const double round = turntable_round(rate);
  return std::make_unique<CircleTrial>(stage, ball, round, middle_of(start, velocity, round), start);
}

}  // namespace

Challenge wheel_challenge() {
  return {46,
          {"wheel",
           "A wheel rolls round on level ground, leaning in its turn.",
           "a wheel that keeps its lean and comes round",
           {{"radius", "m", "of the wheel", 0.3, 0.01, 10},
            {"lean", "rad", "of its axis from the vertical", 1.2, 0.2, 1.5},
            {"round", "rad/s", "about the vertical", 0.8, 0.1, 10}},
           8,
           1.0 / 60,
           fill_wheel},
          "steady turn of a disk that rolls",
          {{"place, at worst", "m", 0.02}},
          {},
          {}};
}

Challenge tray_challenge() {
  return {52,
          {"tray",
           "A coin of 1 kg rolls round on a tray that lies on the ground.",
           "a coin that keeps its lean and comes round, a tray that stays",
           {{"radius", "m", "of the coin", 0.3, 0.01, 10},
            {"lean", "rad", "of its axis from the vertical", 0.8, 0.2, 1.5},
            {"round", "rad/s", "about the vertical", 4, 0.1, 10},
            {"weight", "kg", "of the tray", 20, 5, 1e6}},
           4,
           1.0 / 60,
           fill_tray},
          "steady turn of a disk that rolls",
          {{"place, at worst", "m", 0.02}},
          {},
          {}};
}

Challenge turntable_challenge() {
  return {47,
          {"turntable",
           "A ball rolls on a level table that turns.",
           "a ball that goes round on a circle of its own, at 2/7 of the table's rate",
           {{"rate", "rad/s", "of the table", 3, 0.1, 20}, {"radius", "m", "of the ball", 0.1, 0.01, 1}},
           8,
           1.0 / 60,
           fill_turntable},
          "circle at 2/7 of the table's rate",
          {{"place, at worst", "m", 1e-3}},
          {},
          {}};
}

}  // namespace carom::tools::accuracy
