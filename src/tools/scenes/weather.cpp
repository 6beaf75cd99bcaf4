// weather: crates, boats and buoys on a river, balloons on bungees in the wind, leaves in a whirlwind.
#include <algorithm>
#include <cmath>

#include "scenes/random.h"
#include "scenes/scene.h"

namespace carom::tools {
namespace {

constexpr double kCurrent = 0.3;       // m/s
constexpr double kAir = 1.2;           // kg/m^3
constexpr double kBalloon = 0.35;      // m, radius
constexpr double kLift = -0.3;         // gravity factor of a balloon: the air it displaces
constexpr std::uint32_t kWhirled = 2;  // mask of who feels the whirlwind
constexpr double kWhirlHeight = 7;     // m
const Vec kWhirl(7, 0, -3);            // m, foot of the whirlwind
constexpr double kLeafFall = 1.3;      // m/s, how fast a leaf sinks in still air
constexpr std::size_t kBoats = 3, kBuoys = 11;

Part box(const Vec& half, const Vec& at, double density) {
  Part part;
  part.shape = "box";
  part.params = {half.x(), half.y(), half.z()};
  part.position = at;
  part.density = density;
  return part;
}
Part ball(double radius, double density) {
  Part part;
  part.shape = "sphere";
  part.params = {radius};
  part.density = density;
  return part;
}

Actor named(const std::string& kind, std::size_t number, const Vec& at) {
  Actor actor;
  actor.kind = kind;
  actor.name = kind + " " + std::to_string(number + 1);
  actor.position = at;
  return actor;
}

/// A hull, a cabin and a sail, which alone resists the wind; and two balloons on bungees.
void add_boat(Stage& stage, std::size_t number, const Vec& at) {
  Actor boat = named("boat", number, at);
  boat.parts = {box({1.1, 0.22, 0.45}, {0, 0, 0}, 350), box({0.35, 0.2, 0.3}, {-0.5, 0.42, 0}, 120),
                box({0.04, 0.7, 0.3}, {0.25, 0.92, 0}, 15)};
  const std::size_t hull = stage.add(std::move(boat));
  stage.set_drag(hull, 0, 0.5 * kAir * 1.2 * 3.4);
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec knot(-1, 0.22, k == 0 ? -0.3 : 0.3);
    Actor balloon = named("balloon", 2 * number + k, at + knot + Vec(0, 1.6, 0));
    balloon.parts = {ball(kBalloon, 1)};
    const std::size_t i = stage.add(std::move(balloon));
    stage.set_gravity_factor(i, kLift);
    stage.set_drag(i, 0.02, 0.5 * kAir * 0.47 * EIGEN_PI * kBalloon * kBalloon);
    stage.add_spring({hull, i, knot, Vec(0, -kBalloon, 0), 1.2, 8, 0.3});
  }
}

/// A string of buoys across the current, between two posts.
void add_buoys(Stage& stage, double x, double across) {
  const double pitch = 2 * across / (kBuoys + 1);
  std::size_t last = Bungee::kWorld;
  for (std::size_t i = 0; i < kBuoys; ++i) {
    Actor buoy = named("buoy", i, Vec(x, 0, pitch * static_cast<double>(i + 1) - across));
    buoy.parts = {ball(0.22, 400)};
    const std::size_t here = stage.add(std::move(buoy));
    Bungee rope{last, here, Vec::Zero(), Vec::Zero(), 0.6 * pitch, 250, 10};
    if (last == Bungee::kWorld) rope.at_a = Vec(x, 0.3, -across);
    stage.add_spring(rope);
    last = here;
  }
  stage.add_spring({last, Bungee::kWorld, Vec::Zero(), Vec(x, 0.3, across), 0.6 * pitch, 250, 10});
}

class WeatherStory : public Observer {
 public:
  WeatherStory(std::size_t crates, std::size_t crate_count, std::size_t leaves, std::size_t leaf_count)
      : crates_(crates), crate_count_(crate_count), leaves_(leaves), high_(leaf_count, 0.0) {}

  void watch(const Stage& stage, double) override {
    for (std::size_t i = 0; i < high_.size(); ++i) high_[i] = std::max(high_[i], stage.position(leaves_ + i).y());
  }
  std::vector<std::string> tell(const Stage& stage) const override {
    return {std::to_string(afloat(stage)) + " of " + std::to_string(crate_count_) + " crates float",
            std::to_string(lifted()) + " of " + std::to_string(high_.size()) +
                " leaves were lifted to the top of the whirlwind"};
  }
  bool came_off(const Stage& stage) const override { return afloat(stage) == crate_count_ && lifted() > 0; }

 private:
  /// Within its own size of the surface.
  std::size_t afloat(const Stage& stage) const {
    std::size_t n = 0;
    for (std::size_t i = crates_; i < crates_ + crate_count_; ++i) n += std::fabs(stage.position(i).y()) < 0.7;
    return n;
  }
  std::size_t lifted() const {
    return static_cast<std::size_t>(
        std::count_if(high_.begin(), high_.end(), [](double y) { return y > kWhirlHeight; }));
  }
  std::size_t crates_, crate_count_, leaves_;
  std::vector<double> high_;  // m, of each leaf so far
};

void add_whirlwind(Stage& stage) {
  carom_force_field_desc whirl;
  carom_force_field_desc_init(&whirl, sizeof whirl);
  whirl.kind = CAROM_FORCE_FIELD_VORTEX;
  whirl.mask = kWhirled;
  std::copy(kWhirl.data(), kWhirl.data() + 3, whirl.position);
  whirl.position[1] = kWhirlHeight / 2;
  whirl.half[1] = kWhirlHeight / 2 + 0.5;
  whirl.strength = 30, whirl.pull = 10, whirl.lift = 26;
  whirl.falloff = 1, whirl.core = 1, whirl.reach = 8;
  stage.add_field(whirl);
}

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const auto crates = static_cast<std::size_t>(knobs[0]), leaves = static_cast<std::size_t>(knobs[1]);
  Random random(20111115);
  carom_water water;
  carom_water_init(&water, sizeof water);
  water.current[0] = kCurrent;
  stage.set_water(water);
  stage.set_wind(Vec(knobs[2], 0, 0.2 * knobs[2]));
  add_whirlwind(stage);

  const auto side = static_cast<std::size_t>(std::max(1.0, std::ceil(std::sqrt(static_cast<double>(crates) / 2))));
  const std::size_t first_crate = stage.actors.size();
  for (std::size_t i = 0; i < crates; ++i) {
    const double middle = 0.5 * static_cast<double>(side - 1);
    Actor crate = named(
        "crate", i,
        Vec(1.4 * (static_cast<double>(i % side) - middle) - 3, 0.6 + 1.4 * static_cast<double>(i / (side * side)),
            1.4 * (static_cast<double>(i / side % side) - middle) - 2.5));
    crate.orientation = random.rotation();
    const double density = random.between(250, 750);
    const Vec half = random.within(Vec(0.25, 0.2, 0.25), Vec(0.4, 0.35, 0.4));
    crate.parts = {box(half, Vec::Zero(), density)};
    stage.add(std::move(crate));
  }
  for (std::size_t i = 0; i < kBoats; ++i)
    add_boat(stage, i, Vec(3.2 * static_cast<double>(i) - 4, 0.1, 2.2 + 1.1 * static_cast<double>(i % 2)));
  add_buoys(stage, 4, 5.5);

  const std::size_t first_leaf = stage.actors.size();
  for (std::size_t i = 0; i < leaves; ++i) {
    const double turn = random.between(0, 2 * EIGEN_PI), out = random.between(0.7, 4);
    const double height = random.between(0.5, 4);
    Actor leaf = named("leaf", i, kWhirl + Vec(out * std::cos(turn), height, out * std::sin(turn)));
    leaf.orientation = random.rotation();
    const Vec half(0.12, 0.012, 0.08);
    leaf.parts = {box(half, Vec::Zero(), 200)};
    const std::size_t here = stage.add(std::move(leaf));
    stage.set_drag(here, 0, 200 * 8 * half.prod() * 9.81 / (kLeafFall * kLeafFall));
    stage.set_field_mask(here, kWhirled);
  }
  stage.bounds_min = Vec::Constant(-60), stage.bounds_max = Vec::Constant(60);
  stage.ground_half_width = 14;
  stage.camera_from = Vec(-3, 6, 15), stage.camera_to = Vec(1, 1, -1);
  return std::make_unique<WeatherStory>(first_crate, crates, first_leaf, leaves);
}

}  // namespace

Scene weather_scene() {
  return {
      "weather",
      "Crates, boats and buoys on a river, balloons on bungees in the wind, leaves in a whirlwind.",
      "what is lighter than water floats as deep as it weighs; each force acts on those alone that feel it (carom plan "
      "weather)",
      {{"n", "", "crates", 24, 1, 2000, true},
       {"leaves", "", "in the whirlwind", 60, 0, 5000, true},
       {"wind", "m/s", "along the river", 1.2, -10, 10, false}},
      12.0,
      1.0 / 60,
      fill};
}

}  // namespace carom::tools
