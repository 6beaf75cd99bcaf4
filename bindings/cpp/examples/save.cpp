// Saving and loading: a world as bytes, for a file, goes on in another engine with the same bits.
#include <carom/carom.hpp>
#include <cmath>
#include <cstdio>

int main() {
  auto engine = carom::Engine::create(), other = carom::Engine::create();
  auto world = engine.world(), copy = other.world();
  world.ground();
  const auto box = engine.shape("box", {0.5, 0.5, 0.5});
  for (int i = 0; i < 5; i++) world.body(box, {.position = {0.1 * i, 0.5 + 1.1 * i, 0}});
  for (int i = 0; i < 60; i++) world.step(1.0 / 60);
  const auto saved = world.save(CAROM_SNAPSHOT_WHOLE);  // with bodies and shapes: write these bytes to a file
  other.shape("box", {0.5, 0.5, 0.5});                  // finds the plugin of what is loaded
  copy.restore(saved);                                  // into a world in which nothing was made yet
  for (int i = 0; i < 60; i++) world.step(1.0 / 60), copy.step(1.0 / 60);
  const bool same = world.hash() == copy.hash();
  std::vector<carom::Vec3> positions(copy.bodies().size());
  copy.positions(positions);
  const double top = positions.back()[1];
  std::printf("%zu bodies went on, the last one is at y = %.2f m; the same bits: %s\n", positions.size(), top,
              same ? "yes" : "no");
  if (same && std::abs(top - 4.5) < 0.01) return 0;
  std::fputs("wrong\n", stderr);
  return 1;
}
