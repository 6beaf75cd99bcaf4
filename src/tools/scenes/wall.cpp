// wall: three hulls hit a wall of blocks; contacts of general polytopes with a structure that has to break.
#include "scenes/wall.h"

#include "scenes/tower.h"

namespace carom::tools {

std::vector<std::size_t> Wall::add_to(Stage& stage) const {
  std::vector<std::size_t> blocks;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns - row % 2; ++column) {
      Actor block;
      block.kind = "block";
      block.name = "block " + std::to_string(row + 1) + "." + std::to_string(column + 1);
      const double along = column + (row % 2) / 2.0 - (columns - 1) / 2.0;
      block.position = foot + Vec(0, half.y() + 2 * half.y() * row, along * (2 * half.z() + joint));
      Part brick;
      brick.shape = "box";
      brick.params = {half.x(), half.y(), half.z()};
      brick.density = density;
      block.parts.push_back(brick);
      blocks.push_back(stage.add(std::move(block)));
    }
  return blocks;
}

namespace {

/// The wall is there to be broken: it came off if blocks were knocked out of it.
class WallStory : public Observer {
 public:
  void watch(const Stage&, double) override {}
  std::vector<std::string> tell(const Stage& stage) const override {
    const Standing wall = standing(stage);
    return {std::to_string(wall.fallen) + " of " + std::to_string(wall.blocks) +
            " blocks were knocked out of the wall"};
  }
  bool came_off(const Stage& stage) const override { return standing(stage).fallen > 0; }
};

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string& mesh_path) {
  const Bunny bunny = load_bunny(mesh_path, 0.8, static_cast<std::size_t>(knobs[2]));
  stage.meshes.push_back(bunny.mesh);
  stage.remarks.insert(stage.remarks.end(), bunny.remarks.begin(), bunny.remarks.end());
  stage.add_half_space("ground", {0, 1, 0}, {0, 0, 0});
  Wall wall;
  wall.columns = static_cast<int>(knobs[0]);
  wall.rows = static_cast<int>(knobs[1]);
  wall.density = 500;
  wall.add_to(stage);
  const double height = wall.half.y() * wall.rows,
               width = 2 * wall.half.z() * wall.columns;  // m; half the wall's height
  for (int i = 0; i < 3; ++i) {
    Actor hull;
    hull.kind = "bunny";
    hull.name = "bunny " + std::to_string(i + 1);
    hull.position = Vec(-6, std::max(0.6, height), (i - 1) * width / 3);
    hull.linear_velocity = Vec(knobs[3], 2, 0);  // up a little: what gravity takes on the way
    Part body;
    body.shape = "hull";
    body.params = hull_params(bunny.hull.hull);
    body.mesh = 0;
    hull.parts.push_back(std::move(body));
    stage.add(std::move(hull));
  }
  stage.bounds_min = Vec(-80, -1, -80);
  stage.bounds_max = Vec(80, 80, 80);
  stage.camera_from = Vec(-6, 4, 12);
  stage.camera_to = Vec(0, height, 0);
  return std::make_unique<WallStory>();
}

}  // namespace

Scene wall_scene() {
  return {"wall",
          "Three bunnies, thrown side by side, hit a wall of blocks.",
          "three breaches; blocks that fly, slide and come to rest on one another",
          {{"columns", "", "blocks in a row of the wall", 20, 2, 200, true},
           {"rows", "", "rows of the wall", 10, 1, 100, true},
           {"hull_vertices", "", "vertices of a bunny's hull at most", 42, 8, 2000, true},
           {"speed", "m/s", "of the bunnies", 15, 0, 100}},
          5.0,
          1.0 / 60,
          fill};
}

}  // namespace carom::tools
