// pyramid, stacks, sleepers: boxes that rest one on the other or on the ground and ought to stay where they are.
#include "scenes/tower.h"

#include <cmath>
#include <cstdio>

#include "scenes/random.h"

namespace carom::tools {

Standing standing(const Stage& stage, const std::vector<Vec>& positions) {
  Standing s;
  for (std::size_t i = 0; i < stage.actors.size(); ++i) {
    const Actor& block = stage.actors[i];
    if (block.kind != "block") continue;
    ++s.blocks;
    if (!positions[i].allFinite()) {
      ++s.fallen;
      continue;
    }
    const std::vector<double>& half = block.parts.at(0).params;
    const double allowed = *std::min_element(half.begin(), half.end()) + 0.01 * block.position.y();
    const Vec moved = positions[i] - block.position;
    const double drift = std::hypot(moved.x(), moved.z());
    s.fallen += -moved.y() > allowed || drift > allowed;
    s.drop = std::max(s.drop, -moved.y());
    s.drift = std::max(s.drift, drift);
  }
  return s;
}

Standing standing(const Stage& stage) {
  std::vector<double> xyz;
  stage.read(CAROM_FIELD_POSITION, xyz);
  std::vector<Vec> positions;
  for (std::size_t i = 0; i < stage.actors.size(); ++i) positions.emplace_back(&xyz[3 * i]);
  return standing(stage, positions);
}

void TowerStory::watch(const Stage& stage, double time) {
  if (fell_at_ >= 0 || time < next_look_) return;
  next_look_ = time + 0.1;  // s: often enough for a story
  if (standing(stage).fallen) fell_at_ = time;
}

std::vector<std::string> TowerStory::tell(const Stage& stage) const {
  const Standing s = standing(stage);
  char line[200];
  if (s.fallen)
    std::snprintf(line, sizeof line, "%zu of %zu blocks have fallen, the first by t = %.1f s", s.fallen, s.blocks,
                  std::max(fell_at_, 0.0));
  else
    std::snprintf(line, sizeof line,
                  "all %zu blocks stand; the one that sank most did so by %.1f mm, none strayed more "
                  "than %.1f mm",
                  s.blocks, 1e3 * s.drop, 1e3 * s.drift);
  return {line};
}

namespace {

Actor block(std::size_t number, const Vec& position, double half) {
  Actor actor;
  actor.kind = "block";
  actor.name = "block " + std::to_string(number);
  actor.position = position;
  Part part;
  part.shape = "box";
  part.params = {half, half, half};
  actor.parts.push_back(std::move(part));
  return actor;
}

constexpr double kHalf = 0.5;  // m: cubes of a metre, a tonne each

std::unique_ptr<Observer> fill_pyramid(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const int base = static_cast<int>(knobs[0]);
  const double pitch = 2 * kHalf + knobs[1];
  stage.add_half_space("ground", {0, 1, 0}, {0, 0, 0});
  std::size_t number = 0;
  for (int row = 0; row < base; ++row)
    for (int i = 0; i < base - row; ++i)
      stage.add(block(++number, Vec(pitch * (i - (base - row - 1) / 2.0), kHalf * (2 * row + 1), 0), kHalf));
  stage.ground_half_width = base;
  stage.camera_from = Vec(0, 0.5 * base, 1.5 * base);
  stage.camera_to = Vec(0, 0.4 * base, 0);
  return std::make_unique<TowerStory>();
}

std::unique_ptr<Observer> fill_stacks(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const int count = static_cast<int>(knobs[0]), height = static_cast<int>(knobs[1]);
  const int side = static_cast<int>(std::ceil(std::sqrt(count) - 1e-9));
  const double askew = knobs[2], spacing = 4;  // m
  stage.add_half_space("ground", {0, 1, 0}, {0, 0, 0});
  Random random(16040);
  std::size_t number = 0;
  for (int i = 0; i < count; ++i)
    for (int level = 0; level < height; ++level) {
      const Vec axis(spacing * (i % side - (side - 1) / 2.0), kHalf * (2 * level + 1),
                     spacing * (i / side - (side - 1) / 2.0));
      const double x = random.between(-askew, askew), z = random.between(-askew, askew);
      stage.add(block(++number, axis + Vec(x, 0, z), kHalf));
    }
  stage.ground_half_width = spacing * side;
  stage.camera_from = Vec(0, 0.6 * height, 1.5 * height + spacing * side);
  stage.camera_to = Vec(0, 0.4 * height, 0);
  return std::make_unique<TowerStory>();
}

std::unique_ptr<Observer> fill_sleepers(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const int count = static_cast<int>(knobs[0]), movers = static_cast<int>(knobs[1]);
  const int side = static_cast<int>(std::ceil(std::sqrt(count) - 1e-9));
  const double half = 0.25, pitch = 0.7, speed = 3;  // m, m, m/s
  stage.add_half_space("ground", {0, 1, 0}, {0, 0, 0});
  for (int i = 0; i < count; ++i)
    stage.add(block(static_cast<std::size_t>(i) + 1, Vec(pitch * (i % side), half, pitch * (i / side)), half));
  for (int i = 0; i < movers; ++i) {  // in lanes beside the boxes: none is woken
    Actor ball;
    ball.kind = "ball";
    ball.name = "ball " + std::to_string(i + 1);
    ball.position = Vec(0, half, -pitch * (i + 2));
    ball.linear_velocity = Vec(speed, 0, 0);
    ball.angular_velocity = Vec(0, 0, -speed / half);  // it rolls, and nothing stops it
    Part part;
    part.shape = "sphere";
    part.params = {half};
    ball.parts.push_back(std::move(part));
    stage.add(std::move(ball));
  }
  stage.ground_half_width = pitch * (side + movers);
  stage.camera_from = Vec(pitch * side / 2, 0.3 * side, -0.5 * side);
  stage.camera_to = Vec(pitch * side / 2, 0, pitch * side / 3);
  return std::make_unique<TowerStory>();
}

}  // namespace

Scene pyramid_scene() {
  return {
      "pyramid",
      "A pyramid of cubes, one thick.",
      "that it stands",
      {{"n", "", "cubes in the lowest row", 30, 1, 400, true}, {"gap", "m", "between cubes of a row", 0.05, 0, 0.5}},
      10.0,
      1.0 / 60,
      fill_pyramid};
}

Scene stacks_scene() {
  return {"stacks",
          "Stacks of cubes, each cube a little askew.",
          "that they stand",
          {{"n", "", "number of stacks", 16, 1, 1000, true},
           {"height", "", "cubes in a stack", 40, 1, 400, true},
           {"askew", "m", "how far at most a cube stands from its stack's axis, along either axis", 1e-3, 0, 0.4}},
          10.0,
          1.0 / 60,
          fill_stacks};
}

Scene sleepers_scene() {
  return {"sleepers",
          "Boxes lie on the ground, each by itself, and a few balls roll past.",
          "with --dial sleep=on: that the boxes cost nothing once they sleep",
          {{"n", "", "number of boxes", 10000, 1, 100000, true}, {"moving", "", "number of balls", 10, 0, 1000, true}},
          5.0,
          1.0 / 60,
          fill_sleepers};
}

}  // namespace carom::tools
