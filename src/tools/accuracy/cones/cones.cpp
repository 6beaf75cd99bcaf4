// cones_chain, cones_capsules, cones_stack, cones_kapla: problems of contact with friction, of the kinds that
// collections for solvers hold, and how far from Coulomb's law their solutions are.
#include <algorithm>
#include <cmath>

#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

/// What the direct solver says of itself after each step: how far its solution is from the law at the worst contact.
/// That this is so is tested elsewhere (tests/oracle/test_direct). Where none was solved directly nothing can be said.
class ConesTrial : public Trial {
 public:
  void watch(const Stage& stage, double) override {
    const carom_step_report report = stage.world.report();
    if (report.contact_points == 0) return;
    is_said_ &= report.direct_groups > 0 || stage.world.dial(CAROM_DIAL_SOLVER) == CAROM_SOLVER_DIRECT;
    residual_.push_back(report.solver_residual);
  }
  std::vector<double> errors(const Stage&) const override {
    if (!is_said_ || residual_.empty()) return {kNoBound, kNoBound};
    std::vector<double> sorted = residual_;
    std::sort(sorted.begin(), sorted.end());
    return {sorted[(sorted.size() - 1) * 9 / 10], sorted.back()};
  }

 private:
  std::vector<double> residual_;  // m/s, by step with contacts
  bool is_said_ = true;
};

/// Every step is one problem.
std::unique_ptr<Observer> solved_directly(Stage& stage) {
  stage.world.set_dial("solver=direct");
  stage.world.set_dial("substeps=1");
  return std::make_unique<ConesTrial>();
}

Actor actor_of(const std::string& kind, std::size_t i, const Vec& position, const Quat& orientation) {
  Actor actor;
  actor.kind = kind;
  actor.name = kind + " " + std::to_string(i);
  actor.position = position;
  actor.orientation = orientation;
  return actor;
}

constexpr double kHalfRight = 0.707106781186547524;  // cosine and sine of half a right angle

/// Rings of eight capsules, each through the one above; the first is held.
std::unique_ptr<Observer> fill_chain(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  constexpr double kRing = 0.1, kWire = 0.02, kSlack = 0.004;  // m
  constexpr int kParts = 8;
  const double half = kRing * std::tan(M_PI / kParts), apart = 2 * (kRing - kWire) - kSlack;
  const int rings = static_cast<int>(knobs[0]);
  for (int i = 0; i < rings; ++i) {
    const Quat turned = i % 2 ? Quat(kHalfRight, 0, kHalfRight, 0) : Quat::Identity();
    Actor ring = actor_of("ring", static_cast<std::size_t>(i), Vec(0, -apart * i, 0), turned);
    if (i == 0) ring.type = CAROM_BODY_STATIC;
    for (int k = 0; k < kParts; ++k) {
      const double at = 2 * M_PI * (k + 0.5) / kParts;  // in the plane of x and y
      Part wire;
      wire.shape = "capsule";
      wire.params = {kWire, half};
      wire.position = kRing * Vec(std::cos(at), std::sin(at), 0);
      wire.orientation = Quat(std::cos(at / 2), 0, 0, std::sin(at / 2));  // capsules lie along y
      wire.density = 7800;
      wire.friction = 0.3;
      ring.parts.push_back(wire);
    }
    stage.add(std::move(ring));
  }
  // The last one is knocked aside, so that all of them swing, rub and turn.
  set_moving(stage, stage.actors.size() - 1, Vec(0.8, 0, 0.5), Vec::Zero());
  stage.bounds_min = Vec::Constant(-100);
  stage.ground_half_width = 0;
  stage.camera_from = Vec(1.2, -0.5, 1.8);
  stage.camera_to = Vec(0, -0.08 * rings, 0);
  return solved_directly(stage);
}

/// Capsules that fall into a box.
std::unique_ptr<Observer> fill_capsules(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  constexpr double kRadius = 0.1, kHalf = 0.12, kWall = 0.5;  // m
  add_ground(stage, 0.3);
  stage.add_half_space("left", {1, 0, 0}, {-kWall, 0, 0}, 0.3);
  stage.add_half_space("right", {-1, 0, 0}, {kWall, 0, 0}, 0.3);
  stage.add_half_space("back", {0, 0, 1}, {0, 0, -kWall}, 0.3);
  stage.add_half_space("front", {0, 0, -1}, {0, 0, kWall}, 0.3);
  for (std::size_t i = 0; i < static_cast<std::size_t>(knobs[0]); ++i) {
    const auto k = static_cast<double>(i);
    const Vec at(0.3 * std::sin(2.4 * k), 0.3 + 0.08 * k, 0.3 * std::cos(2.4 * k));  // a helix of the golden angle
    const Vec axis = Vec(std::cos(k), 0.3, std::sin(k)).normalized();
    Actor capsule = actor_of("capsule", i, at, turn_between(Vec::UnitY(), axis));
    Part part;
    part.shape = "capsule";
    part.params = {kRadius, kHalf};
    part.friction = 0.3;
    capsule.parts.push_back(part);
    stage.add(std::move(capsule));
  }
  stage.camera_from = Vec(1.5, 1.6, 2.5);
  stage.camera_to = Vec(0, 0.5, 0);
  return solved_directly(stage);
}

/// Cubes, let go a hair above each other.
std::unique_ptr<Observer> fill_stack(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  constexpr double kEdge = 0.5, kDrop = 0.002;  // m
  add_ground(stage, 0.6);
  const int base = static_cast<int>(knobs[0]);
  for (int row = 0; row < base; ++row)
    for (int i = 0; i < base - row; ++i)
      add_box(stage, Vec((kEdge + 0.01) * (i - 0.5 * (base - row - 1)), (kEdge + kDrop) * (row + 0.5), 0),
              Vec::Constant(kEdge / 2), 1, {0.6, 0});
  stage.camera_from = Vec(1, 2, 8);
  stage.camera_to = Vec(0, 1.5, 0);
  return solved_directly(stage);
}

/// A tower of planks that is hit at its foot.
std::unique_ptr<Observer> fill_kapla(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  add_ground(stage, 0.5);
  add_plank_tower(stage, static_cast<int>(knobs[0]));
  add_ball(stage, Vec(-0.15, 0.05, 0), 0.02, 0.05, {0.5, 0}, Vec(2, 0, 0));
  stage.camera_from = Vec(0.3, 0.2, 0.6);
  stage.camera_to = Vec(0, 0.06, 0);
  return solved_directly(stage);
}

Challenge cones(const std::string& kind, const std::string& what, const std::string& look_for, Knob size,
                double seconds,
                std::unique_ptr<Observer> (*fill)(Stage&, const std::vector<double>&, const std::string&)) {
  return {34,
          {"cones_" + kind, what, look_for, {std::move(size)}, seconds, 1.0 / 60, fill},
          "Coulomb's law at every contact",
          {{"residual, nine steps of ten", "m/s", 1e-4}, {"residual, at worst", "m/s", kNoBound}},
          {},
          {}};
}

}  // namespace

std::vector<Challenge> cones_challenges() {
  return {cones("chain", "Rings hang in each other, each of eight capsules, and the last is knocked aside.",
                "a chain that swings and rattles", {"rings", "", "of the chain, the first held", 7, 2, 40, true}, 3,
                fill_chain),
          cones("capsules", "Capsules fall into a box.", "they come to rest across each other",
                {"n", "", "number of capsules", 24, 1, 200, true}, 2, fill_capsules),
          cones("stack", "A wall of cubes, let go 2 mm apart.", "they settle, and lie still",
                {"base", "", "cubes in the lowest row", 7, 1, 30, true}, 2, fill_stack),
          cones("kapla", "A tower of planks, three to a layer, that a ball hits.", "planks slide on each other",
                {"layers", "", "of three planks each", 8, 1, 60, true}, 2, fill_kapla)};
}

}  // namespace carom::tools::accuracy
