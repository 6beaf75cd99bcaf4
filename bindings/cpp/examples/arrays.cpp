// Bulk arrays: velocities of 1000 balls are set in one call, their positions read in one.
#include <carom/carom.hpp>
#include <cmath>
#include <cstdio>

static double mean_height(const std::vector<carom::Vec3>& positions) {
  double sum = 0;
  for (const auto& position : positions) sum += position[1];
  return sum / double(positions.size());
}

int main() {
  auto engine = carom::Engine::create();
  auto world = engine.world();
  const auto sphere = engine.shape("sphere", {0.5});
  std::vector<carom_body> balls;
  std::vector<carom::Vec3> positions, velocities(1000, {0, 9.81 / 2, 0});
  for (int i = 0; i < 1000; i++) {
    positions.push_back({2.0 * (i / 100), 5 + 2.0 * (i / 10 % 10), 2.0 * (i % 10)});
    balls.push_back(world.body(sphere, {.position = positions.back()}).handle());
  }
  world.write(CAROM_FIELD_LINEAR_VELOCITY, velocities, balls);
  double height[3] = {mean_height(positions)};
  for (int i = 1; i < 3; i++) {
    for (int step = 0; step < 30; step++) world.step(1.0 / 60);
    world.read(CAROM_FIELD_POSITION, positions, balls);
    height[i] = mean_height(positions);
  }
  const double rise = height[1] - height[0], off = std::abs(height[2] - height[0]);
  std::printf("%zu balls rise by %.3f m and are back after 1 s, %.3f m off\n", balls.size(), rise, off);
  const bool good = std::abs(rise - 9.81 / 8) < 1e-9 && off < 1e-9;
  if (good) return 0;
  std::fputs("wrong\n", stderr);
  return 1;
}
