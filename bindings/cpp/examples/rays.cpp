// Rays: what is below a point, how far, and that beside it lies the ground.
#include <carom/carom.hpp>
#include <cmath>
#include <cstdio>

/// What lies along a direction; time counts in lengths of it.
static carom_world_hit cast(const carom::World& world, carom::Vec3 from, carom::Vec3 direction) {
  carom_world_hit hit;
  world.call(carom_world_cast_ray, from.data(), direction.data(), HUGE_VAL, nullptr, &hit, sizeof hit);
  return hit;
}

int main() {
  auto engine = carom::Engine::create();
  auto world = engine.world();
  const auto ground = world.ground();
  const auto ball = world.body(engine.shape("sphere", {0.5}), {.position = {0, 2, 0}});
  for (int i = 0; i < 120; i++) world.step(1.0 / 60);
  const auto hit = cast(world, {0, 5, 0}, {0, -1, 0});
  const auto beside = cast(world, {3, 5, 0}, {0, -1, 0});
  const auto above = cast(world, {0, 5, 0}, {0, 1, 0});
  std::printf("%.2f m down lies the ball, beside it %.2f m down the ground, above it nothing\n", hit.time, beside.time);
  const bool good = hit.body == ball.handle() && std::abs(hit.time - 4) < 0.01 && beside.body == ground.handle() &&
                    std::abs(beside.time - 5) < 1e-6 && above.outcome == CAROM_CAST_MISS;
  if (good) return 0;
  std::fputs("wrong\n", stderr);
  return 1;
}
