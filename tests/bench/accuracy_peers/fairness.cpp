// Closed forms that any engine of rigid bodies must meet, whatever its solver.
#include "fairness.h"

#include <cmath>
#include <cstdio>

#include "accuracy/joints/links.h"
#include "accuracy/reference.h"
#include "accuracy/scene_bodies.h"

namespace carom::bench {
namespace {

using namespace tools::accuracy;
using tools::Stage;

constexpr double kStep = 1.0 / 240;  // s
constexpr int kSteps = 240;

struct Judge {
  std::vector<std::string> complaints;
  /// What the first-order methods of all engines may be off by in a second, and a float's seven digits.
  void expect(const std::string& what, double found, double truth, double tolerance) {
    if (std::fabs(found - truth) <= tolerance) return;
    char text[160];
    std::snprintf(text, sizeof text, "%s is %.6g and should be %.6g, give or take %.2g", what.c_str(), found, truth,
                  tolerance);
    complaints.emplace_back(text);
  }
};

void run(Stage& stage, PeerMover& mover, const std::vector<Push>& pushes = {}, int steps = kSteps) {
  for (int i = 0; i < steps; ++i) {
    for (const Push& push : pushes) mover.push(stage, push);
    mover.step(stage, kStep);
  }
  if (!mover.show(stage)) throw tools::Error("a state is not finite", "mend the module of this engine");
}

Vec spin_of(const Stage& stage, std::size_t actor) {
  std::vector<double> velocities;
  stage.read(CAROM_FIELD_VELOCITY, velocities);
  return Vec(&velocities[6 * actor + 3]);
}

/// Solids that stand or lie on the ground stay at their height, where the engine has them.
void check_solids(tools::Engine& engine, const PeerEngine& peer, Judge& judge) {
  struct Case {
    const char* shape;
    std::vector<double> params;
    Vec along;
    double height;  // m, of its origin
  };
  const std::vector<Case> cases = {{"capsule", {0.1, 0.3}, Vec::UnitZ(), 0.1},
                                   {"capsule", {0.1, 0.3}, Vec::UnitY(), 0.4},
                                   {"cylinder", {0.2, 0.3}, Vec::UnitY(), 0.3},
                                   {"cylinder", {0.2, 0.3}, Vec::UnitX(), 0.2},
                                   {"cone", {0.4, 0.3}, Vec::UnitY(), 0.3}};
  for (const Case& c : cases) {
    Stage stage(engine);
    add_ground(stage, 0.5);
    const std::size_t body = add_solid(stage, c.shape, c.params, Vec(0, c.height, 0), 2, {0.5, 0}, Vec::Zero(),
                                       Quat::FromTwoVectors(Vec::UnitY(), c.along));
    try {
      PeerMover mover(stage, peer, {});
      run(stage, mover, {}, kSteps / 4);
    } catch (const tools::Error& error) {
      if (error.code != CAROM_E_UNSUPPORTED) throw;
      continue;
    }
    judge.expect(std::string("height of a ") + c.shape + " at rest", stage.position(body).y(), c.height, 5e-3);
  }
}

/// Sliders along a slanted axis, the world at either end: a motor gets to its speed, a spring swings to the other side.
void check_sliders(tools::Engine& engine, const PeerEngine& peer, Judge& judge) {
  const Vec way(0.6, 0, 0.8);
  const Quat axes = Quat::FromTwoVectors(Vec::UnitX(), way), turned(Eigen::AngleAxisd(0.7, Vec(1, 2, 2) / 3));
  for (const bool world_first : {true, false})
    for (const bool has_motor : {true, false}) {
      Stage stage(engine);
      set_gravity(stage, 0);
      const std::size_t body = add_link(stage, "sledge", Vec(1, 2, 3), 2, Vec(0.02, 0.03, 0.04), {}, turned);
      const carom_body moved = stage.actors[body].body;
      const carom_joint rail = join(stage, CAROM_JOINT_SLIDER, world_first ? CAROM_NULL_HANDLE : moved,
                                    world_first ? moved : CAROM_NULL_HANDLE, Vec(1.5, 2, 3), axes);
      carom_joint_motor motor;
      carom_joint_spring spring;
      carom_joint_motor_init(&motor, sizeof motor), carom_joint_spring_init(&spring, sizeof spring);
      motor.enabled = 1, motor.speed = 0.5, motor.max_force = 6;
      spring.enabled = 1, spring.target = 0.3, spring.frequency = 0.5, spring.damping = 0;
      tools::Call call;
      call.done(has_motor ? carom_joint_set_motor(stage.world.get(), rail, CAROM_COORDINATE_SLIDE, &motor, call)
                          : carom_joint_set_spring(stage.world.get(), rail, CAROM_COORDINATE_SLIDE, &spring, call),
                "driving a slider");
      PeerMover mover(stage, peer, {});
      run(stage, mover);
      const double sign = world_first ? 1 : -1;
      if (has_motor)
        judge.expect("speed that a motor keeps", sign * stage.velocity(body).dot(way), 0.5, 5e-3);
      else
        judge.expect("way of a spring in half a period", sign * (stage.position(body) - Vec(1, 2, 3)).dot(way), 0.6,
                     0.02);
      judge.expect("way off the slider's axis", (stage.position(body) - Vec(1, 2, 3)).cross(way).norm(), 0, 2e-3);
    }
}

}  // namespace

std::vector<std::string> unfair(tools::Engine& engine, const PeerEngine& peer) {
  Judge judge;
  {  // Free fall: any method of first order or better is within g t h / 2 of the parabola, and exact in velocity.
    Stage stage(engine);
    const std::size_t ball = add_ball(stage, Vec(1, 100, 2), 0.1, 3, {}, Vec(1, 2, 3));
    PeerMover mover(stage, peer, {});
    run(stage, mover);
    judge.expect("height after 1 s of fall", stage.position(ball).y(), 100 + 2 - kGravity / 2,
                 kGravity * kStep / 2 + 1e-3);
    judge.expect("way along x", stage.position(ball).x(), 2, 1e-3);
    judge.expect("speed of fall", stage.velocity(ball).y(), 2 - kGravity, 1e-4);
  }
  {  // Mass: 6 N on 3 kg for a second.
    Stage stage(engine);
    set_gravity(stage, 0);
    const std::size_t box = add_box(stage, Vec(0, 0, 0), Vec(0.1, 0.2, 0.3), 3, {});
    PeerMover mover(stage, peer, {});
    run(stage, mover, {{box, Vec(0, 0, 6)}});
    judge.expect("speed that 6 N give 3 kg in 1 s", stage.velocity(box).z(), 2, 1e-4);
    judge.expect("spin that they give", spin_of(stage, box).norm(), 0, 1e-6);
  }
  {  // Inertia: a bar hung by its end swings down with w^2 = 3 g / l, whatever joint holds it.
    Stage stage(engine);
    const std::size_t rod = add_link(stage, "rod", Vec(0.5, 0, 0), 1, Vec(1e-4, 1, 1) / 12, {});
    join(stage, CAROM_JOINT_BALL, CAROM_NULL_HANDLE, stage.actors[rod].body, Vec::Zero());
    PeerMover mover(stage, peer, {});
    const double quarter = 1.8540746773013719 * std::sqrt(2 / (3 * kGravity));  // s: K(1/2) over the root of 3 g / 2 l
    run(stage, mover, {}, static_cast<int>(std::lround(quarter / kStep)));
    judge.expect("spin of a rod that has swung down", std::fabs(spin_of(stage, rod).z()), std::sqrt(3 * kGravity),
                 0.15);
    judge.expect("its middle's distance from the pivot", stage.position(rod).norm(), 0.5, 0.02);
  }
  {  // Friction: the geometric mean of 0.9 and 0.4 is 0.6.
    Stage stage(engine);
    add_ground(stage, 0.9);
    const std::size_t box = add_box(stage, Vec(0, 0.1, 0), Vec(0.5, 0.1, 0.5), 1, {0.4, 0}, Vec(8, 0, 0));
    PeerMover mover(stage, peer, {});
    run(stage, mover);
    judge.expect("speed after 1 s of friction 0.6", stage.velocity(box).x(), 8 - 0.6 * kGravity, 0.3);
  }
  {  // Bounce: the livelier side counts, and half of 4.43 m/s comes back: 0.25 m, within a step's worth.
    Stage stage(engine);
    add_ground(stage, 0);
    const std::size_t ball = add_ball(stage, Vec(0, 1.1, 0), 0.1, 2, {0, 0.5});
    PeerMover mover(stage, peer, {});
    double highest = 0;
    for (int i = 0; i < kSteps * 7 / 10; ++i) {
      run(stage, mover, {}, 1);
      if (i > kSteps / 2) highest = std::max(highest, stage.position(ball).y() - 0.1);
    }
    judge.expect("height of a bounce", highest, 0.25, 0.03);
  }
  check_solids(engine, peer, judge);
  check_sliders(engine, peer, judge);
  return judge.complaints;
}

}  // namespace carom::bench
