// elastic666, pack666: a cube of 6 x 6 x 6 balls falls on level ground without friction, and bounces or packs.
#include "accuracy/impact/energy.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kRadius = 0.1, kMass = 10, kSpacing = 0.21, kLowest = 1.1;  // m, kg, m, m: centres of the lowest layer

void add_cube(Stage& stage, double e) {
  add_ground(stage, 0);
  for (int i = 0; i < 216; ++i)
    add_ball(stage, Vec(kSpacing * (i % 6), kLowest + kSpacing * (i / 36), kSpacing * (i / 6 % 6)), kRadius, kMass,
             {0, e});
  stage.camera_from = Vec(0.5, 2, 6);
  stage.camera_to = Vec(0.5, 1, 0.5);
}

std::unique_ptr<Observer> fill_elastic(Stage& stage, const std::vector<double>&, const std::string&) {
  add_cube(stage, 1);
  return std::make_unique<EnergyTrial>(stage, kRadius, kMass);
}

/// The deepest overlap of two balls, or of a ball and the ground, after any step; from the balls' places alone.
class OverlapTrial : public Trial {
 public:
  explicit OverlapTrial(const Stage& stage) : crowd_(stage) {}
  void watch(const Stage& stage, double) override {
    crowd_.look(stage);
    for (std::size_t i = 0; i < crowd_.size(); ++i) {
      const Vec at = crowd_.position(i);
      worst_ = std::max(worst_, kRadius - at.y());
      for (std::size_t j = 0; j < i; ++j) {
        const Vec apart = at - crowd_.position(j);
        if (apart.squaredNorm() < 4 * kRadius * kRadius) worst_ = std::max(worst_, 2 * kRadius - apart.norm());
      }
    }
  }
  std::vector<double> errors(const Stage&) const override { return {worst_}; }

 private:
  Crowd crowd_;
  double worst_ = 0;
};

std::unique_ptr<Observer> fill_pack(Stage& stage, const std::vector<double>&, const std::string&) {
  add_cube(stage, 0);
  return std::make_unique<OverlapTrial>(stage);
}

}  // namespace

Challenge elastic666_challenge() {
  return {14,
          {"elastic666",
           "6 x 6 x 6 balls, a tenth of a radius apart, fall and bounce without loss or friction.",
           "balls that keep jumping for ten seconds",
           {},
           10,
           1.0 / 60,
           fill_elastic},
          "the energy at the start",
          {{"energy, relative, RMS", "", 1e-4}},
          {0.035, "Box3D 4 substeps"},
          {3.2e-4, "ReactPhysics3D 10, 1/960"}};
}

Challenge pack666_challenge() {
  return {15,
          {"pack666",
           "6 x 6 x 6 balls, a tenth of a radius apart, fall and do not bounce; no friction.",
           "balls that run apart over the ground without sinking into one another",
           {},
           10,
           1.0 / 60,
           fill_pack},
          "nothing overlaps",
          {{"overlap, deepest of the run", "m", 1e-3}},
          {2.8e-3, "Jolt 4x10"},
          {1.5e-3, "Bullet 200, 1/960"}};
}

}  // namespace carom::tools::accuracy
