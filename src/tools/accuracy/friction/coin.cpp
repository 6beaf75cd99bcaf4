// coin: Euler's disk, which rolls round on its rim ever faster as it loses energy, and lies down.
#include <cmath>

#include "accuracy/reference.h"
#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kTilt = 0.3;  // rad, at first
// Against the moment, rolling asks for 4 rolling / tilt of the load as friction: for 3.3 at the tilt of the last fiftieth.
// With 1 the disk slid from a tilt of 0.02 rad on, where the closed form ends.
constexpr double kFriction = 10;
constexpr double kHalfLeft = 0.5, kRest = 0.02;  // of the energy

/// When half of its energy is gone, and when all but a fiftieth.
class CoinTrial : public Trial {
 public:
  CoinTrial(std::size_t body, const Coin& coin, double rolling) : body_(body), coin_(coin), rolling_(rolling) {}

  void watch(const Stage& stage, double time) override {
    std::vector<double> v;
    stage.world.read(CAROM_FIELD_VELOCITY, {stage.actors[body_].body}, v);
    const Eigen::Map<const Vec> u(v.data()), w(v.data() + 3);
    const Vec spin = stage.orientation(body_).conjugate() * w;
    const double round = coin_.radius * coin_.radius, across = round / 4 + coin_.half * coin_.half / 3;
    const double energy = kGravity * (stage.position(body_).y() - coin_.half) + u.squaredNorm() / 2 +
                          (across * (spin.x() * spin.x() + spin.z() * spin.z()) + round / 2 * spin.y() * spin.y()) / 2;
    const double first = coin_.energy(kTilt, kGravity);
    if (energy > kHalfLeft * first) half_ = time;
    if (energy > kRest * first) rest_ = time;
    now_ = energy / first;
  }
  std::vector<double> errors(const Stage&) const override {
    return {now_ > kRest ? INFINITY : off(rest_, kRest), now_ > kHalfLeft ? INFINITY : off(half_, kHalfLeft)};
  }

 private:
  double off(double time, double share) const {
    const double then = coin_.tilt_of(share * coin_.energy(kTilt, kGravity), kGravity);
    return std::fabs(time / coin_.time_between(kTilt, then, rolling_, kGravity) - 1);
  }

  std::size_t body_;
  Coin coin_;
  double rolling_, half_ = 0, rest_ = 0, now_ = 1;
};

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const Coin coin{knobs[0], 0.02 * knobs[0]};
  const double rolling = knobs[1] * coin.radius, s = std::sin(kTilt), c = std::cos(kTilt);
  Actor actor;
  actor.kind = "coin", actor.name = "coin";
  actor.position = Vec(0, coin.radius * s + coin.half * c, 0);
  actor.orientation = Quat(Eigen::AngleAxisd(-kTilt, Vec::UnitZ()));
  actor.angular_velocity =
      coin.round(kTilt, kGravity) * s * Vec(coin.half / coin.radius * s - c, s + coin.half / coin.radius * c, 0);
  actor.mass = 1;
  Part part;
  part.shape = "cylinder", part.params = {coin.radius, coin.half};
  Part ground;
  ground.shape = "half_space", ground.params = {0, 1, 0, 0};
  Actor floor;
  floor.kind = floor.name = "ground", floor.type = CAROM_BODY_STATIC;
  for (auto [each, whose] : {std::pair{part, &actor}, {ground, &floor}}) {
    each.friction = knobs[2], each.rolling = rolling;
    whose->parts.push_back(std::move(each));
  }
  stage.add(std::move(floor));
  const std::size_t body = stage.add(std::move(actor));
  stage.camera_from = Vec(0, 2, 4) * coin.radius, stage.camera_to = Vec::Zero();
  return std::make_unique<CoinTrial>(body, coin, rolling);
}

}  // namespace

Challenge coin_challenge() {
  return {21,
          {"coin",
           "A disk rolls round on its rim over ground that resists rolling (Euler's disk).",
           "a coin that goes round ever faster and lies down",
           {{"radius", "m", "of the disk", 0.5, 0.01, 10},
            {"rolling", "", "resistance of the ground, of the radius", 0.005, 1e-4, 0.1},
            {"friction", "", "of the ground", kFriction, 0.1, 100}},
           40,
           1.0 / 60,
           fill},
          "its energy against what the moment takes",
          {{"time to rest, relative", "", 0.05}, {"time to half of the energy, relative", "", 0.05}},
          {},
          {}};
}

}  // namespace carom::tools::accuracy
