// bullet: a ball flies through a wall of blocks, faster in a step than the wall is thick, and stays in the next one.
#include <algorithm>

#include "scenes/wall.h"

namespace carom::tools {
namespace {

constexpr double kSteel = 7800, kBehind = 6;  // kg/m^3; m, of the plate behind the wall

class BulletStory : public Observer {
 public:
  BulletStory(std::size_t ball, std::vector<std::size_t> blocks) : ball_(ball), blocks_(std::move(blocks)) {}
  void watch(const Stage& stage, double) override {
    farthest_ = std::max(farthest_, stage.position(ball_).x());
    for (const std::size_t b : blocks_) beyond_ = std::max(beyond_, stage.position(b).x());
  }
  std::vector<std::string> tell(const Stage&) const override {
    return {came_through() ? "something came through the plate" : "the plate held everything back"};
  }
  bool came_off(const Stage&) const override { return !came_through(); }

 private:
  bool came_through() const { return std::max(farthest_, beyond_) > kBehind; }
  std::size_t ball_;
  std::vector<std::size_t> blocks_;
  double farthest_ = -1e300, beyond_ = -1e300;  // m, along x
};

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  stage.add_half_space("ground", {0, 1, 0}, {0, 0, 0});
  Wall wall;
  wall.density = 500;
  const std::vector<std::size_t> blocks = wall.add_to(stage);
  Actor plate;
  plate.kind = plate.name = "plate";
  plate.type = CAROM_BODY_STATIC;
  plate.position = Vec(kBehind, 5, 0);
  Part sheet;
  sheet.shape = "box";
  sheet.params = {0.001, 5, 10};
  plate.parts.push_back(sheet);
  stage.add(std::move(plate));
  Actor bullet;
  bullet.kind = bullet.name = "bullet";
  bullet.position = Vec(-12, 1, 0.1);
  bullet.linear_velocity = Vec(knobs[0], 0, 0);
  Part body;
  body.shape = "sphere";
  body.params = {knobs[1]};
  body.density = kSteel;
  bullet.parts.push_back(std::move(body));
  const std::size_t ball = stage.add(std::move(bullet));
  stage.bounds_min = Vec(-200, -1, -200), stage.bounds_max = Vec(200, 200, 200);
  stage.camera_from = Vec(-6, 4, 12), stage.camera_to = Vec(2, 1, 0);
  return std::make_unique<BulletStory>(ball, blocks);
}

}  // namespace

Scene bullet_scene() {
  return {"bullet",
          "A steel ball at 200 m/s goes through a wall of blocks and meets a plate of 2 mm behind it.",
          "blocks that burst out of the wall; nothing behind the plate",
          {{"speed", "m/s", "of the ball", 200, 1, 1000}, {"radius", "m", "of the ball", 0.1, 0.01, 0.5}},
          3.0,
          1.0 / 60,
          fill};
}

}  // namespace carom::tools
