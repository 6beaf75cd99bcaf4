// Bodies and stacks: ten boxes stand on each other, to a millimetre a box.
#include <carom/carom.hpp>
#include <cmath>
#include <cstdio>

int main() {
  auto engine = carom::Engine::create();
  auto world = engine.world();
  world.ground();
  const auto box = engine.shape("box", {0.5, 0.5, 0.5});  // half extents, m; of 1000 kg/m^3, where nothing else is said
  std::vector<carom::Body> boxes;
  for (int i = 0; i < 10; i++) boxes.push_back(world.body(box, {.position = {0, 0.52 + 1.02 * i, 0}}));
  for (int i = 0; i < 180; i++) world.step(1.0 / 60);
  const auto [x, y, z] = boxes[9].position();
  double mass;
  boxes[0].call(carom_body_get_mass, &mass, nullptr, nullptr);
  std::printf("10 boxes of %.0f kg stand for 3 s, the top one at y = %.2f m\n", mass, y);
  const bool good = std::abs(y - 9.5) < 0.01 && std::abs(x) < 0.01 && std::abs(z) < 0.01;
  if (good) return 0;
  std::fputs("wrong\n", stderr);
  return 1;
}
