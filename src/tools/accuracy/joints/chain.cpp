// chain1, chain100, chain1e4, wrecking: rods with a ball of so many times their mass at the end, let go from the
// horizontal. bridge: planks between two banks, with a load on them.
#include <cmath>

#include "accuracy/joints/links.h"
#include "accuracy/reference.h"
#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

/// How far joints gape, and how much of what fell is lost or gained.
class ChainTrial : public Trial {
 public:
  /// @param falls  J, what is let go could lose by falling its length
  ChainTrial(const Stage& stage, Mechanism mechanism, double falls)
      : mechanism_(std::move(mechanism)), start_(mechanism_.energy(stage)), falls_(falls) {}

  void watch(const Stage& stage, double time) override {
    gap_ = std::max(gap_, mechanism_.worst_gap(stage));
    energy_ = std::max(energy_, std::fabs(mechanism_.energy(stage) - start_) / falls_);
    if (gap_ > kBroken) fall(time);
  }
  std::vector<double> errors(const Stage&) const override { return {gap_, energy_}; }

 private:
  static constexpr double kBroken = 1;  // m
  Mechanism mechanism_;
  double start_, falls_, gap_ = 0, energy_ = 0;
};

/// knobs: rods, their length, the end's mass over theirs
std::unique_ptr<Observer> fill_chain(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const int rods = static_cast<int>(knobs[0]);
  const double length = knobs[1], ratio = knobs[2], radius = 0.1;
  Mechanism mechanism;
  carom_body before = CAROM_NULL_HANDLE;
  for (int i = 0; i < rods; ++i) {
    const std::size_t rod = add_rod(stage, Vec((i + 0.5) * length, 0, 0), length, 1);
    mechanism.add(rod, 1, inertia_of_rod(length, 1));
    mechanism.add(join(stage, CAROM_JOINT_BALL, before, stage.actors[rod].body, Vec(i * length, 0, 0)));
    before = stage.actors[rod].body;
  }
  const double reach = rods * length;
  const std::size_t bob = add_bob(stage, Vec(reach + radius, 0, 0), radius, ratio);
  mechanism.add(bob, ratio, inertia_of_ball(radius, ratio));
  mechanism.add(join(stage, CAROM_JOINT_BALL, before, stage.actors[bob].body, Vec(reach, 0, 0)));
  stage.bounds_min = Vec::Constant(-1e3);
  stage.ground_half_width = 0;
  stage.camera_from = Vec(0, -reach / 2, 2.5 * reach), stage.camera_to = Vec(0, -reach / 2, 0);
  return std::make_unique<ChainTrial>(stage, std::move(mechanism),
                                      kGravity * (rods * reach / 2 + ratio * (reach + radius)));
}

Scene chain_scene(const std::string& name, double rods, double length, double ratio) {
  const std::string text = std::to_string(static_cast<int>(rods)) + " rods with a ball of " +
                           std::to_string(static_cast<int>(ratio)) + " times their mass fall from the horizontal.";
  return {name,
          text,
          "joints that stay shut while the chain is pulled tight and goes slack",
          {{"rods", "", "how many", rods, 1, 200, true},
           {"length", "m", "of each", length, 0.01, 10},
           {"ratio", "", "mass of the ball over that of a rod", ratio, 1e-3, 1e6}},
          10,
          1.0 / 60,
          fill_chain};
}

constexpr double kPlank = 0.5, kLoad = 0.4;  // m: a plank's length; half the side of the load

/// Planks along a parabola, hinged to each other and to both banks.
class BridgeTrial : public Trial {
 public:
  BridgeTrial(Mechanism mechanism, std::size_t load, double floor)
      : mechanism_(std::move(mechanism)), load_(load), floor_(floor) {}

  void watch(const Stage& stage, double time) override {
    gap_ = std::max(gap_, mechanism_.worst_gap(stage));
    if (stage.position(load_).y() < floor_) fall(time);
  }
  std::vector<double> errors(const Stage&) const override { return {gap_}; }

 private:
  Mechanism mechanism_;
  std::size_t load_;
  double floor_, gap_ = 0;
};

std::unique_ptr<Observer> fill_bridge(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const int planks = static_cast<int>(knobs[0]);
  const double ratio = knobs[1], sag = 0.02, plank_mass = 10;
  std::vector<Vec> at;  // joints, each a plank's length from the one before, along y = sag x^2
  double x = -kPlank * planks / 2 / std::sqrt(1 + 0.13 * sag * sag * kPlank * kPlank * planks * planks);
  for (int i = 0; i <= planks; ++i) {
    at.emplace_back(x, sag * x * x, 0);
    const double slope = 2 * sag * (x + kPlank / 2);
    double dx = kPlank / std::sqrt(1 + slope * slope);
    for (int k = 0; k < 20; ++k) {
      const double dy = sag * (2 * x + dx) * dx;
      dx *= kPlank / std::sqrt(dx * dx + dy * dy);
    }
    x += dx;
  }
  Mechanism mechanism;
  carom_body before = CAROM_NULL_HANDLE;
  for (int i = 0; i < planks; ++i) {
    const Vec along = at[i + 1] - at[i];
    const std::size_t plank =
        add_box(stage, (at[i] + at[i + 1]) / 2, Vec(0.48 * kPlank, 0.04, 0.6), plank_mass, {0.6, 0}, Vec::Zero(),
                Quat(Eigen::AngleAxisd(std::atan2(along.y(), along.x()), Vec(0, 0, 1))));
    for (double z : {-0.5, 0.5})
      mechanism.add(join(stage, CAROM_JOINT_BALL, before, stage.actors[plank].body, at[i] + Vec(0, 0, z)));
    before = stage.actors[plank].body;
  }
  for (double z : {-0.5, 0.5})
    mechanism.add(join(stage, CAROM_JOINT_BALL, before, CAROM_NULL_HANDLE, at[planks] + Vec(0, 0, z)));
  const double mass = ratio * plank_mass;
  const std::size_t load = add_box(stage, Vec(0, 0.05 + kLoad, 0), Vec::Constant(kLoad), mass, {0.6, 0});
  stage.bounds_min = Vec::Constant(-1e3);
  stage.ground_half_width = 0;
  stage.camera_from = Vec(0, 4, 18), stage.camera_to = Vec::Zero();
  return std::make_unique<BridgeTrial>(std::move(mechanism), load, -0.4 * kPlank * planks);
}

}  // namespace

std::vector<Challenge> chain_challenges() {
  const std::vector<Metric> metrics = {{"gap, at worst", "m", 1e-4}, {"energy, at worst", "", 0.01}};
  return {{8,
           chain_scene("chain1", 10, 0.5, 1),
           "joints are shut, energy stays",
           metrics,
           {1.9e-15, "MuJoCo implicit"},
           {1.3e-15, "MuJoCo Euler, 1/30"}},
          {8,
           chain_scene("chain100", 10, 0.5, 100),
           "joints are shut, energy stays",
           metrics,
           {1.8e-15, "MuJoCo RK4"},
           {9.2e-16, "MuJoCo RK4, 1/30"}},
          {8, chain_scene("chain1e4", 10, 0.5, 1e4), "joints are shut, energy stays", metrics, {}, {}}};
}

Challenge wrecking_challenge() {
  return {30,
          chain_scene("wrecking", 40, 0.25, 1000),
          "joints are shut, energy stays",
          {{"gap, at worst", "m", 1e-3}, {"energy, at worst", "", kNoBound}},
          {},
          {}};
}

Challenge bridge_challenge() {
  return {27,
          {"bridge",
           "A load of 1,000 times the mass of a plank on a hanging bridge of 40.",
           "a bridge that holds for a minute",
           {{"planks", "", "how many", 40, 4, 200, true},
            {"ratio", "", "mass of the load over that of a plank", 1000, 1e-3, 1e6}},
           60,
           1.0 / 60,
           fill_bridge},
          "joints are shut, and the load stays up",
          {{"gap, at worst", "m", 1e-3}},
          {},
          {}};
}

}  // namespace carom::tools::accuracy
