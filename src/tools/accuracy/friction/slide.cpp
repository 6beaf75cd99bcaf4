// slide, slip, stick: a block on rough ground, level or at 30 degrees.
#include <cmath>

#include "accuracy/reference.h"
#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kSine = 0.5, kCosine = 0.866025403784438647;  // 30 degrees
// m. Low and wide: the couple of friction (mu times the half height) stays well inside the base, so no corner lifts.
const Vec kHalf(0.5, 0.1, 0.5);

/// Two blocks on level ground, one along an axis of the world and one 30 degrees off it: where friction is limited in
/// a square or a pyramid of directions and not in a circle, the second one stops elsewhere and drifts sideways.
class SlideTrial : public Trial {
 public:
  /// @param first  actor: the blocks are it and those after it   @param speed m/s
  SlideTrial(const Stage& stage, std::size_t first, std::vector<Vec> headings, double speed, double mu)
      : crowd_(stage),
        first_(first),
        headings_(std::move(headings)),
        distance_(stopping_distance(speed, mu, kGravity)),
        speed_(speed),
        mu_(mu) {}
  void watch(const Stage& stage, double) override { crowd_.look(stage); }
  std::vector<double> errors(const Stage&) const override {
    double along = 0, across = 0;
    for (std::size_t i = 0; i < crowd_.size(); ++i) {
      const Vec way = crowd_.position(i) - crowd_.home(i), side = headings_[i].cross(Vec::UnitY());
      along = std::max(along, std::fabs(way.dot(headings_[i]) - distance_));
      across = std::max(across, std::fabs(way.dot(side)));
    }
    return {along, across};
  }
  std::vector<TruePose> truth(double time) const override {
    const double brake = mu_ * kGravity, slid = std::min(time, speed_ / brake);
    std::vector<TruePose> poses;
    for (std::size_t i = 0; i < crowd_.size(); ++i) {
      const Vec way = (speed_ - brake * slid / 2) * slid * headings_[i];
      poses.push_back({first_ + i, crowd_.home(i) + way, Quat::Identity()});
    }
    return poses;
  }

 private:
  Crowd crowd_;
  std::size_t first_;
  std::vector<Vec> headings_;
  double distance_, speed_, mu_;
};

std::unique_ptr<Observer> fill_slide(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const double speed = knobs[0], mu = knobs[1];
  const std::vector<Vec> headings = {Vec(1, 0, 0), Vec(kCosine, 0, kSine)};
  add_ground(stage, mu);
  const std::size_t first = stage.actors.size();
  for (std::size_t i = 0; i < headings.size(); ++i)
    add_box(stage, Vec(0, kHalf.y(), 3.0 * static_cast<double>(i)), kHalf, 1, {mu, 0}, speed * headings[i]);
  stage.camera_from = Vec(1.5, 3, 9);
  return std::make_unique<SlideTrial>(stage, first, headings, speed, mu);
}

const Vec kDown(kCosine, -kSine, 0);  // a slope of 30 degrees

/// A slope of 30 degrees that falls towards +x, and a block at rest on it.
std::size_t add_slope(Stage& stage, double mu) {
  const Vec normal(kSine, kCosine, 0);
  stage.add_half_space("slope", normal, Vec::Zero(), mu);
  const Quat tilt(std::sqrt((1 + kCosine) / 2), 0, 0, -std::sqrt((1 - kCosine) / 2));  // -30 degrees about z
  stage.ground_half_width = 0;
  stage.camera_from = Vec(2, 1, 8);
  stage.camera_to = Vec(2, -1, 0);
  return add_box(stage, kHalf.y() * normal, kHalf, 1, {mu, 0}, Vec::Zero(), tilt);
}

/// How far down the slope the block has come, against the closed form (which is 0 above the friction angle), and its
/// whole way in the plane of the slope.
class SlopeTrial : public Trial {
 public:
  SlopeTrial(const Stage& stage, std::size_t block, double mu)
      : block_(block),
        home_(stage.position(block)),
        turned_(stage.orientation(block)),
        mu_(std::min(mu, kSine / kCosine)) {}
  void watch(const Stage&, double time) override { time_ = time; }
  std::vector<double> errors(const Stage& stage) const override {
    const Vec way = stage.position(block_) - home_;
    const double off = way.dot(kDown) - slope_distance(time_, mu_, kSine, kCosine, kGravity);
    return {std::hypot(off, way.z())};
  }
  std::vector<TruePose> truth(double time) const override {
    return {{block_, home_ + slope_distance(time, mu_, kSine, kCosine, kGravity) * kDown, turned_}};
  }

 private:
  std::size_t block_;
  Vec home_;
  Quat turned_;
  double mu_, time_ = 0;
};

std::unique_ptr<Observer> fill_slope(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const std::size_t block = add_slope(stage, knobs[0]);
  return std::make_unique<SlopeTrial>(stage, block, knobs[0]);
}

}  // namespace

Challenge slide_challenge() {
  return {16,
          {"slide",
           "Two blocks slide over level ground until they rest, one along an axis, one 30 degrees off it.",
           "both stop after the same distance, neither drifts aside",
           {{"speed", "m/s", "at the start", 5, 0.1, 50}, {"mu", "", "friction of block and ground", 0.5, 0.05, 2}},
           2,
           1.0 / 60,
           fill_slide},
          "v^2 / (2 mu g), straight",
          {{"distance, worse block", "m", 1e-3}, {"lateral, worse block", "m", 1e-6}},
          {2.3e-3, "Box3D 16 substeps"},
          {1.7e-4, "Box3D 16 substeps, 1/960"}};
}

Challenge slip_challenge() {
  return {17,
          {"slip",
           "A block slides from rest down a slope of 30 degrees.",
           "a steady acceleration straight down",
           {{"mu", "", "friction of block and slope", 0.3, 0, 0.57}},
           2,
           1.0 / 60,
           fill_slope},
          "g (sin - mu cos) t^2 / 2",
          {{"distance", "m", 1e-3}},
          {2.4e-3, "Rapier 16"},
          {2.5e-4, "Rapier 16, 1/960"}};
}

Challenge stick_challenge() {
  return {18,
          {"stick",
           "A block lies for 10 s on a slope of 30 degrees that is just rough enough (tan 30 = 0.577).",
           "nothing moves",
           {{"mu", "", "friction of block and slope", 0.6, 0.58, 2}},
           10,
           1.0 / 60,
           fill_slope},
          "it stays",
          {{"creep in the plane", "m", 1e-6}},
          {6.7e-17, "Bullet 50"},
          {7.9e-18, "Bullet 50, 1/960"}};
}

}  // namespace carom::tools::accuracy
