// collisions: a cloud of boxes that hit one another where nothing else acts: momentum and angular momentum stay.
#include <cmath>

#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

constexpr int kSide = 5, kLayers = 4;    // boxes
const Vec kHalf(0.1, 0.2, 0.3);          // m
constexpr double kMass = 1, kApart = 1;  // kg; m, between middles

/// What the cloud has as a whole.
struct Whole {
  Vec momentum = Vec::Zero(), turn = Vec::Zero();  // N s; N m s, about the origin
  double energy = 0;                               // J
  double moved = 0, turned = 0;                    // sums of magnitudes: what errors are a share of
};

Whole whole(const Stage& stage) {
  const Vec squares = kHalf.cwiseProduct(kHalf), inertia = kMass / 3 * (Vec::Constant(squares.sum()) - squares);
  std::vector<double> pose, velocity;
  stage.read(CAROM_FIELD_POSE, pose);
  stage.read(CAROM_FIELD_VELOCITY, velocity);
  Whole sum;
  for (std::size_t i = 0; i < stage.actors.size(); ++i) {
    const Eigen::Map<const Vec> x(&pose[7 * i]), v(&velocity[6 * i]), w(&velocity[6 * i + 3]);
    const Eigen::Map<const Quat> q(&pose[7 * i + 3]);
    const Vec spin = q.conjugate() * w, turn = kMass * x.cross(v) + q * inertia.cwiseProduct(spin);
    sum.momentum += kMass * v, sum.moved += kMass * v.norm();
    sum.turn += turn, sum.turned += turn.norm();
    sum.energy += kMass * v.squaredNorm() / 2 + spin.dot(inertia.cwiseProduct(spin)) / 2;
  }
  return sum;
}

/// Worst of any step. Where boxes lose nothing, the energy's change; else only what it has grown by.
class CollisionsTrial : public Trial {
 public:
  CollisionsTrial(const Stage& stage, bool lossless) : start_(whole(stage)), lossless_(lossless) {}
  void watch(const Stage& stage, double) override {
    const Whole now = whole(stage);
    momentum_ = std::max(momentum_, (now.momentum - start_.momentum).norm() / start_.moved);
    turn_ = std::max(turn_, (now.turn - start_.turn).norm() / start_.turned);
    const double gain = now.energy / start_.energy - 1;
    energy_ = std::max(energy_, lossless_ ? std::fabs(gain) : gain);
  }
  std::vector<double> errors(const Stage&) const override { return {momentum_, turn_, energy_}; }

 private:
  Whole start_;
  bool lossless_;
  double momentum_ = 0, turn_ = 0, energy_ = 0;
};

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const double e = knobs[0], mu = knobs[1];
  set_gravity(stage, 0);
  const Vec middle = kApart / 2 * Vec(kSide - 1, kLayers - 1, kSide - 1);
  for (int i = 0; i < kSide * kLayers * kSide; ++i) {
    const Vec at = kApart * Vec(i % kSide, i / kSide % kLayers, i / (kSide * kLayers)) - middle;
    const std::size_t box = add_box(stage, at, kHalf, kMass, {mu, e});
    // All fly towards the middle, the outer ones faster, each a little past it and with a spin of its own.
    const Vec aside(std::sin(1.7 * i), std::sin(2.3 * i + 1), std::sin(2.9 * i + 2));
    set_moving(stage, box, -at + 0.3 * aside, 3 * Vec(aside.y(), aside.z(), aside.x()));
  }
  stage.bounds_min = Vec::Constant(-1e3);
  stage.ground_half_width = 0;
  stage.camera_from = Vec(0, 3, 12);
  return std::make_unique<CollisionsTrial>(stage, e == 1 && mu == 0);
}

}  // namespace

Challenge collisions_challenge() {
  return {37,
          {"collisions",
           "A hundred boxes fly into one another where there is no gravity.",
           "a cloud that goes on with the momentum, the angular momentum and the energy it came with",
           {{"e", "", "restitution", 1, 0, 1}, {"mu", "", "friction", 0, 0, 2}},
           3,
           1.0 / 60,
           fill},
          "momentum, angular momentum and energy at the start",
          {{"momentum, at worst, share of all boxes'", "", 1e-12},
           {"angular momentum, at worst, share of all boxes'", "", 1e-12},
           {"energy, relative, at worst", "", kNoBound}},
          {},
          {}};
}

}  // namespace carom::tools::accuracy
