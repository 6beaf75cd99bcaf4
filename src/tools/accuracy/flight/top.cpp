// gzbox, top, dzhanibekov: boxes with three unlike moments of inertia, left spinning.
#include <cmath>
#include <numbers>

#include "accuracy/free_top.h"
#include "accuracy/scene_bodies.h"

namespace carom::tools::accuracy {
namespace {

/// How a box is let go; its axes are those of the world then.
struct Throw {
  Vec sides;        // m
  Vec speed, spin;  // m/s, rad/s
  double g;         // m/s^2, along -y

  static constexpr double kMass = 1;  // kg
  Vec inertia() const {               // kg m^2, principal
    const Vec squares = sides.cwiseProduct(sides);
    return kMass / 12 * (Vec::Constant(squares.sum()) - squares);
  }
};

/// What a lone box does now.
struct Motion {
  Vec place, speed, spin;  // m, m/s, rad/s; the spin about its own axes
  Quat turned;
};

Motion motion_of(const Stage& stage) {
  std::vector<double> velocity;
  stage.read(CAROM_FIELD_VELOCITY, velocity);
  const Quat turned = stage.orientation(0);
  const Eigen::Map<const Vec> speed(velocity.data()), spin(velocity.data() + 3);
  return {stage.position(0), speed, turned.conjugate() * spin, turned};
}

/// Where it is and how it has turned at the end; what it keeps, after every step.
class TopTrial : public Trial {
 public:
  explicit TopTrial(const Throw& start)
      : start_(start), inertia_(start.inertia()), momentum_(inertia_.cwiseProduct(start.spin)) {}

  void watch(const Stage& stage, double time) override {
    time_ = time;
    last_ = motion_of(stage);
    const Vec momentum = last_.turned * inertia_.cwiseProduct(last_.spin);
    momentum_error_ = std::max(momentum_error_, (momentum - momentum_).norm() / momentum_.norm());
    energy_error_ = std::max(
        energy_error_,
        std::fabs(energy(last_.place.y(), last_.speed, last_.spin) / energy(0, start_.speed, start_.spin) - 1));
  }
  std::vector<double> errors(const Stage&) const override {
    const TruePose at_end = truth(time_)[0];
    const Quat off = at_end.orientation->conjugate() * last_.turned;
    const double turn = 2 * std::atan2(off.vec().norm(), std::fabs(off.w()));
    return {turn, momentum_error_, energy_error_, (last_.place - at_end.position).norm()};
  }
  std::vector<TruePose> truth(double time) const override {
    return {{0, start_.speed * time - start_.g * time * time / 2 * Vec::UnitY(),
             FreeTop(inertia_, start_.spin).orientation(time)}};
  }

 private:
  double energy(double height, const Vec& speed, const Vec& spin) const {  // J
    return Throw::kMass * (start_.g * height + speed.squaredNorm() / 2) + spin.dot(inertia_.cwiseProduct(spin)) / 2;
  }

  Throw start_;
  Vec inertia_, momentum_;
  Motion last_{};
  double time_ = 0, momentum_error_ = 0, energy_error_ = 0;
};

/// When the spin about the middle axis passes through zero: between two steps by the cubic that has their spins and,
/// from Euler's equations, their rates; it is off by a rate^4 h^4 / 384 share of a turn.
class FlipTrial : public Trial {
 public:
  explicit FlipTrial(const Throw& start)
      : inertia_(start.inertia()),
        top_(inertia_, start.spin),
        spin_(start.spin[top_.middle()]),
        rate_(rate(start.spin)) {}

  void watch(const Stage& stage, double time) override {
    const Vec w = motion_of(stage).spin;
    const double spin = w[top_.middle()], now = rate(w);
    if ((spin > 0) != (spin_ > 0)) flips_.push_back(time_ + (time - time_) * crossing(spin, now, time - time_));
    spin_ = spin, rate_ = now, time_ = time;
  }
  /// A flip that ought to have been, and was not, is as late as the run is long after it.
  std::vector<double> errors(const Stage&) const override {
    double worst = 0;
    for (std::size_t n = 0; n < flips_.size() || top_.zero(static_cast<int>(n)) < time_; ++n)
      worst = std::max(worst, std::fabs((n < flips_.size() ? flips_[n] : time_) - top_.zero(static_cast<int>(n))));
    return {worst};
  }
  std::vector<TruePose> truth(double time) const override { return {{0, Vec::Zero(), top_.orientation(time)}}; }
  std::vector<std::string> tell(const Stage&) const override {
    return {"it flipped " + std::to_string(flips_.size()) + " times"};
  }

 private:
  double rate(const Vec& w) const {  // rad/s^2, of the spin about the middle axis
    const Vec torque = inertia_.cwiseProduct(w).cross(w);
    return torque[top_.middle()] / inertia_[top_.middle()];
  }
  /// Share of the step.
  double crossing(double spin, double now, double h) const {
    double low = 0, high = 1;
    for (int i = 0; i < 50; ++i) {
      const double s = (low + high) / 2, back = 1 - s;
      const double at =
          back * back * ((1 + 2 * s) * spin_ + s * h * rate_) + s * s * ((3 - 2 * s) * spin - back * h * now);
      ((at > 0) == (spin_ > 0) ? low : high) = s;
    }
    return low;
  }

  Vec inertia_;
  FreeTop top_;
  double spin_, rate_, time_ = 0;
  std::vector<double> flips_;  // s
};

void let_go(Stage& stage, const Throw& start) {
  set_gravity(stage, start.g);
  const std::size_t box = add_box(stage, Vec::Zero(), start.sides / 2, Throw::kMass, {});
  set_moving(stage, box, start.speed, start.spin);
  stage.bounds_min = Vec::Constant(-1e3);
  stage.ground_half_width = 0;
  stage.camera_from = Vec(2, 4, 12);
}

std::unique_ptr<Observer> fill_gzbox(Stage& stage, const std::vector<double>&, const std::string&) {
  const Throw start{Vec(1, 4, 9), Vec(-2, 2, 8), Vec(0.1, 5, 0.1), 9.8};
  let_go(stage, start);
  return std::make_unique<TopTrial>(start);
}

std::unique_ptr<Observer> fill_top(Stage& stage, const std::vector<double>&, const std::string&) {
  const Throw start{Vec(1, 2, 3), Vec::Zero(), Vec(4, 1, 2), 0};
  let_go(stage, start);
  return std::make_unique<TopTrial>(start);
}

std::unique_ptr<Observer> fill_dzhanibekov(Stage& stage, const std::vector<double>&, const std::string&) {
  const Throw start{Vec(1, 2, 3), Vec::Zero(), Vec(0.01, 5, 0.01), 0};
  let_go(stage, start);
  return std::make_unique<FlipTrial>(start);
}

std::vector<Metric> spin_metrics(double place_bound) {
  return {{"turn, at the end", "rad", 1e-6},
          {"angular momentum, relative, at worst", "", 1e-14},
          {"energy, relative, at worst", "", kNoBound},
          {"place, at the end", "m", place_bound}};
}

}  // namespace

Challenge gzbox_challenge() {
  return {3,
          {"gzbox",
           "A box of 1 x 4 x 9 m is thrown at (-2, 2, 8) m/s and spins at (0.1, 5, 0.1) rad/s, near its middle axis.",
           "a parabola, and a box that turns over and over",
           {},
           10,
           1.0 / 60,
           fill_gzbox},
          "Jacobi's elliptic functions and a parabola",
          spin_metrics(1e-9),
          {2.8e-3, "MuJoCo RK4"},
          {1.1e-5, "MuJoCo RK4, 1/960"}};
}

Challenge top_challenge() {
  return {4,
          {"top",
           "A box of 1 x 2 x 3 m spins freely at (4, 1, 2) rad/s for a minute.",
           "a wobble that neither grows nor dies",
           {},
           60,
           1.0 / 60,
           fill_top},
          "Jacobi's elliptic functions",
          spin_metrics(1e-9),
          {8.3e-3, "MuJoCo RK4"},
          {3.3e-5, "MuJoCo RK4, 1/960"}};
}

Challenge dzhanibekov_challenge() {
  return {5,
          {"dzhanibekov",
           "A box of 1 x 2 x 3 m spins at 5 rad/s about its middle axis, but for 0.01 rad/s about the others.",
           "five sudden flips in 35 s, as far apart as 2 K(k)",
           {},
           35,
           1.0 / 60,
           fill_dzhanibekov},
          "Jacobi's elliptic functions: sn is 0 every 2 K",
          {{"time of a flip, worst", "s", 1e-3}},
          {},
          {6e-4, "MuJoCo RK4"}};
}

}  // namespace carom::tools::accuracy
