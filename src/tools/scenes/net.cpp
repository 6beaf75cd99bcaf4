// net: balls joined to their neighbours, held along one edge, let go level.
#include "scenes/scene.h"

namespace carom::tools {
namespace {

constexpr double kRadius = 0.2, kPitch = 0.5;  // m

std::unique_ptr<Observer> fill(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  const int n = static_cast<int>(knobs[0]);
  const double width = kPitch * (n - 1);
  const auto place = [&](double row, double column) {
    return Vec(kPitch * column - width / 2, width + 2, kPitch * row - width / 2);
  };
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column) {
      Actor knot;
      knot.kind = row == 0 ? "hook" : "knot";
      knot.name = knot.kind + " " + std::to_string(row) + ", " + std::to_string(column);
      knot.type = row == 0 ? CAROM_BODY_STATIC : CAROM_BODY_DYNAMIC;
      knot.position = place(row, column);
      knot.mass = row == 0 ? 0 : 1;
      Part ball;
      ball.shape = "sphere";
      ball.params = {kRadius};
      knot.parts.push_back(std::move(ball));
      stage.add(std::move(knot));
    }
  const auto at = [&](int row, int column) { return static_cast<std::size_t>(row * n + column); };
  for (int row = 0; row < n; ++row)
    for (int column = 0; column < n; ++column) {
      if (row > 0 && column + 1 < n)
        stage.join(CAROM_JOINT_BALL, at(row, column), at(row, column + 1), place(row, column + 0.5));
      if (row + 1 < n) stage.join(CAROM_JOINT_BALL, at(row, column), at(row + 1, column), place(row + 0.5, column));
    }
  stage.bounds_min = Vec(-2 * width - 5, -width - 5, -2 * width - 5);
  stage.bounds_max = Vec(2 * width + 5, 3 * width + 5, 2 * width + 5);
  stage.ground_half_width = 0;
  stage.camera_from = Vec(1.5 * width, width + 4, 1.5 * width), stage.camera_to = Vec(0, width / 2, 0);
  return nullptr;
}

}  // namespace

Scene net_scene() {
  return {"net",
          "A net of balls, each joined to its neighbours, falls from the level and swings by one edge.",
          "joints that stay shut when it slaps",
          {{"n", "", "balls along each edge", 30, 2, 200, true}},
          5.0,
          1.0 / 60,
          fill};
}

}  // namespace carom::tools
