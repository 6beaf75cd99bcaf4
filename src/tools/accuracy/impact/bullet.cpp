// bullet, spinning_rod: what moves farther in a step than what stands in its way is thick.
#include <cmath>
#include <numbers>

#include "accuracy/reference.h"
#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

constexpr int kPhases = 16;  // of the step in which something is met
constexpr double kStep = 1.0 / 60;

std::size_t add_post(Stage& stage, const std::string& shape, std::vector<double> params, const Vec& position,
                     double restitution) {
  Actor actor;
  actor.kind = "wall";
  actor.name = "wall " + std::to_string(stage.actors.size());
  actor.type = CAROM_BODY_STATIC;
  actor.position = position;
  Part part;
  part.shape = shape;
  part.params = std::move(params);
  part.friction = 0, part.restitution = restitution;
  actor.parts.push_back(std::move(part));
  return stage.add(std::move(actor));
}

/// Balls fly at walls of their own; each is to come back as if it had turned round where it touches.
class BulletTrial : public Trial {
 public:
  struct Shot {
    std::size_t ball;
    double start, front;  // m, along x: of its centre, as it starts and as it touches
    double z;             // m
  };
  BulletTrial(double speed, double e, std::vector<Shot> shots) : speed_(speed), e_(e), shots_(std::move(shots)) {}

  void watch(const Stage& stage, double time) override {
    for (const Shot& s : shots_)
      worst_ = std::max(
          worst_, std::fabs(stage.position(s.ball).x() - s.front + turned_back(time, s.front - s.start, speed_, e_)));
  }
  std::vector<double> errors(const Stage& stage) const override {
    double through = 0;
    for (const Shot& s : shots_) through += stage.position(s.ball).x() > s.front + kFar;
    return {through / static_cast<double>(shots_.size()), worst_};
  }
  std::vector<TruePose> truth(double time) const override {
    std::vector<TruePose> poses;
    for (const Shot& s : shots_)
      poses.push_back({s.ball, Vec(s.front - turned_back(time, s.front - s.start, speed_, e_), 0, s.z), {}});
    return poses;
  }

 private:
  static constexpr double kFar = 0.1;  // m: a wall's thickness, past where it should have turned
  double speed_, e_, worst_ = 0;
  std::vector<Shot> shots_;
};

std::unique_ptr<Observer> fill_bullet(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  constexpr double kRadius = 0.1, kWall = 0.05, kAway = 2;  // m
  const double speed = knobs[0], e = knobs[1];
  set_gravity(stage, 0);
  std::vector<BulletTrial::Shot> shots;
  for (int i = 0; i < kPhases; ++i) {
    const double front = -kWall - kRadius, start = front - kAway - speed * kStep * i / kPhases, z = 2 * i;
    add_post(stage, "box", {kWall, 0.5, 0.5}, Vec(0, 0, z), e);
    shots.push_back({add_ball(stage, Vec(start, 0, z), kRadius, 1, {0, e}, Vec(speed, 0, 0)), start, front, z});
  }
  stage.ground_half_width = 0;
  stage.camera_from = Vec(-20, 10, 15), stage.camera_to = Vec(0, 0, 15);
  return std::make_unique<BulletTrial>(speed, e, std::move(shots));
}

/// Rods that spin in space beside posts. One that met its post spins on as a rod does that was hit there.
class RodTrial : public Trial {
 public:
  struct Rod {
    std::size_t rod;
    double meets;     // s
    double spin = 0;  // rad/s, after the first step that ends later
  };
  RodTrial(double spin, double after, std::vector<Rod> rods) : spin_(spin), after_(after), rods_(std::move(rods)) {}

  void watch(const Stage& stage, double time) override {
    for (Rod& r : rods_) {
      if (r.spin != 0 || !(time > r.meets)) continue;
      double v[6];
      Call call;
      call.done(carom_world_read(stage.world.get(), CAROM_FIELD_VELOCITY, CAROM_SCALAR_F64, &stage.actors[r.rod].body,
                                 1, v, 0, call),
                "reading a velocity");
      r.spin = v[4];
    }
  }
  std::vector<double> errors(const Stage&) const override {
    double through = 0, worst = 0;
    for (const Rod& r : rods_) {
      through += r.spin > 0.99 * spin_;
      worst = std::max(worst, std::fabs(r.spin - after_) / spin_);
    }
    return {through / static_cast<double>(rods_.size()), worst};
  }

 private:
  double spin_, after_;
  std::vector<Rod> rods_;
};

std::unique_ptr<Observer> fill_spinning_rod(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  constexpr double kHalf = 1, kThin = 0.01, kPost = 0.01, kAway = 0.8;  // m
  const double spin = knobs[0];
  set_gravity(stage, 0);
  const HitRod truth = hit_rod(spin, kHalf, kThin, kPost, kAway);
  std::vector<RodTrial::Rod> rods;
  for (int i = 0; i < kPhases; ++i) {
    const double angle = 0.3 + 2.5 * i / kPhases, z = 4 * i;  // rad, of its axis from the post: the other end meets it
    add_post(stage, "capsule", {kPost, 0.5}, Vec(kAway, 0, z), 1);
    const Quat turned(std::cos(angle / 2), 0, std::sin(angle / 2), 0);
    const std::size_t rod = add_box(stage, Vec(0, 0, z), Vec(kHalf, kThin, kThin), 1, {0, 1}, Vec::Zero(), turned);
    set_moving(stage, rod, Vec::Zero(), Vec(0, spin, 0));
    rods.push_back({rod, (std::numbers::pi - truth.stop - angle) / spin});
  }
  stage.ground_half_width = 0;
  stage.camera_from = Vec(-20, 20, 30), stage.camera_to = Vec(0, 0, 30);
  return std::make_unique<RodTrial>(spin, truth.spin, std::move(rods));
}

}  // namespace

Challenge bullet_challenge() {
  return {29,
          {"bullet",
           "Balls of r 0.1 m fly at 200 m/s into walls of 0.1 m, at 16 phases of the step.",
           "all of them turn round where they touch",
           {{"speed", "m/s", "of the balls", 200, 1, 2000}, {"e", "", "restitution", 0.5, 0, 1}},
           0.05,
           kStep,
           fill_bullet},
          "they turn round at the wall's face",
          {{"share that passes through", "", 0}, {"place, worst", "m", 1e-6}},
          {0, "Box3D, Rapier, Jolt, Bullet with CCD; ODE 1"},
          {0, "likewise"}};
}

Challenge spinning_rod_challenge() {
  return {29,
          {"spinning_rod",
           "Rods of 2 m, 2 cm thick, spin in space and meet posts of 2 cm, at 16 phases of the step; no loss.",
           "none passes its post",
           {{"spin", "rad/s", "of the rods", 150, 1, 600}},
           0.2,
           kStep,
           fill_spinning_rod},
          "a rigid body that is hit where its face meets the post",
          {{"share that passes through", "", 0}, {"spin after the hit, relative, worst", "", 1e-6}},
          {},
          {}};
}

}  // namespace carom::tools::accuracy
