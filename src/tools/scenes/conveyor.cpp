// conveyor: boxes on a belt, from there on a belt across, from there on a turntable. Nothing that carries them moves.
#include <algorithm>

#include "scenes/scene.h"

namespace carom::tools {
namespace {

constexpr double kHalf = 0.2;                 // m, of a box
constexpr double kPitch = 0.6;                // m, from box to box
constexpr double kWide = 0.7, kThick = 0.25;  // m, half of a belt
constexpr double kDrop = 0.15;                // m, from each to the next
constexpr double kLong = 3;                   // m, half of the belt across
constexpr double kRound = 2.5;                // m, of the turntable

Part belt(const Vec& half, const Vec& velocity) {
  Part part;
  part.shape = "box";
  part.params = {half.x(), half.y(), half.z()};
  part.friction = 0.7;
  part.surface_velocity = velocity;
  return part;
}

Actor still(const std::string& name, const Vec& at, Part part) {
  Actor actor;
  actor.kind = "belt";
  actor.name = name;
  actor.type = CAROM_BODY_STATIC;
  actor.position = at;
  actor.parts.push_back(std::move(part));
  return actor;
}

/// Counts what came from belt to belt.
class ConveyorStory : public Observer {
 public:
  ConveyorStory(std::size_t first, std::size_t count, double end) : first_(first), across_(count), end_(end) {}

  void watch(const Stage& stage, double time) override {
    for (std::size_t i = 0; i < across_.size(); ++i) {
      const Vec p = stage.position(first_ + i);
      if (across_[i] < 0 && p.z() > end_) across_[i] = time;
    }
  }
  std::vector<std::string> tell(const Stage& stage) const override {
    std::size_t riding = 0;
    for (std::size_t i = 0; i < across_.size(); ++i) {
      const Vec v = stage.velocity(first_ + i);
      riding += across_[i] >= 0 && stage.position(first_ + i).y() > kHalf && std::hypot(v.x(), v.z()) > 0.1;
    }
    const auto last = std::max_element(across_.begin(), across_.end());
    return {std::to_string(crossed()) + " of " + std::to_string(across_.size()) +
                " boxes went over both belts, the last after " + std::to_string(std::max(0.0, *last)) + " s",
            std::to_string(riding) + " of them ride the turntable"};
  }
  bool came_off(const Stage&) const override { return crossed() == across_.size(); }

 private:
  std::size_t crossed() const {
    return static_cast<std::size_t>(std::count_if(across_.begin(), across_.end(), [](double t) { return t >= 0; }));
  }

  /// When a box left the second belt; negative: it has not.
  struct Times : std::vector<double> {
    explicit Times(std::size_t n) : std::vector<double>(n, -1.0) {}
  };
  std::size_t first_;
  Times across_;
  double end_;  // m, where the belt across ends
};

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const auto n = static_cast<std::size_t>(knobs[0]);
  const double speed = knobs[1], turn = knobs[2];
  const double along = kPitch * static_cast<double>(n) / 2 + 1, top = 1;  // m, half of the first belt; its height
  stage.add_half_space("ground", {0, 1, 0}, {0, 0, 0});
  stage.add(still("belt", {-along, top - kThick, 0}, belt({along, kThick, kWide}, {speed, 0, 0})));
  const double across_z = kLong - kWide, across_end = across_z + kLong;
  stage.add(still("belt across", {kWide, top - kDrop - kThick, across_z}, belt({kWide, kThick, kLong}, {0, 0, speed})));
  Part board = belt({0.05, 0.5, kLong}, Vec::Zero());  // what comes too fast stays on the belt across
  board.friction = 0;
  stage.add(still("board", {2 * kWide + 0.05, top, across_z}, board));
  Part table;
  table.shape = "cylinder";
  table.params = {kRound, kThick};
  table.friction = 0.7;
  table.surface_spin = Vec(0, turn, 0);
  stage.add(still("turntable", {kWide, top - 2 * kDrop - kThick, across_end + kRound - kWide}, table));

  const std::size_t first = stage.actors.size();
  for (std::size_t i = 0; i < n; ++i) {
    Actor box;
    box.kind = "box";
    box.name = "box " + std::to_string(i + 1);
    box.position = Vec(-1 - kPitch * static_cast<double>(i), top + kHalf, 0.3 * (static_cast<double>(i % 3) - 1));
    Part part;
    part.shape = "box";
    part.params = {kHalf, kHalf, kHalf};
    part.density = 200;
    part.friction = 0.7;
    box.parts.push_back(std::move(part));
    stage.add(std::move(box));
  }
  stage.bounds_min = Vec(-2 * along - 5, -1, -10);
  stage.bounds_max = Vec(15, 10, 20);
  stage.ground_half_width = 2 * along;
  stage.camera_from = Vec(-4, 7, 14), stage.camera_to = Vec(0, 0.5, 2);
  return std::make_unique<ConveyorStory>(first, n, across_end);
}

}  // namespace

Scene conveyor_scene() {
  return {"conveyor",
          "Boxes ride a belt, fall on one that runs across, and from that on a turntable.",
          "the bodies below them do not move: surfaces do (carom_collider_set_surface_velocity)",
          {{"n", "", "boxes", 12, 1, 500, true},
           {"speed", "m/s", "of the belts", 1.5, 0.2, 4, false},
           {"turn", "rad/s", "of the turntable", 0.5, -2, 2, false}},
          15.0,
          1.0 / 60,
          fill};
}

}  // namespace carom::tools
