// Casts and overlaps: how far a crate can be moved before it touches, and what a blast of 2 m reaches.
#include <carom/carom.hpp>
#include <cmath>
#include <cstdio>

int main() {
  auto engine = carom::Engine::create();
  auto world = engine.world();
  world.ground();
  const auto wall = world.body(engine.shape("box", {0.5, 2, 2}), {.type = CAROM_BODY_STATIC, .position = {5, 2, 0}});
  const auto sphere = engine.shape("sphere", {0.5});
  std::vector<carom::Body> balls;
  for (const double z : {1, -2, 4}) balls.push_back(world.body(sphere, {.position = {0, 6, z}}));
  for (int i = 0; i < 120; i++) world.step(1.0 / 60);  // they fall to the ground
  const auto crate = engine.shape("box", {0.5, 0.5, 0.5}), blast = engine.shape("sphere", {2});  // of no body
  const carom::Vec3 from{0, 1, 0}, way{8, 0, 0}, middle{0, 0.5, 0};
  auto ask = carom::make<carom_query_shapes>();
  ask.scalar = CAROM_SCALAR_F64, ask.count = 1, ask.shapes = &crate, ask.positions = &from, ask.motions = &way;
  carom_world_hit hit, found[8];
  world.call(carom_world_cast_shapes, &ask, CAROM_WANT_FIRST, nullptr, &hit, sizeof hit);
  ask.shapes = &blast, ask.positions = &middle, ask.motions = nullptr;
  const auto count = world.make<std::uint64_t>(carom_world_overlap_shapes, &ask, nullptr, found, sizeof hit, 8);
  int reached = 0;
  for (const auto& one : std::span(found, std::min<std::size_t>(count, 8)))
    reached += std::ranges::any_of(balls, [&](const carom::Body& ball) { return ball.handle() == one.body; });
  // Time is a fraction of the way.
  std::printf("%.2f m to the wall, and %d of 3 balls lie within 2 m\n", 8 * hit.time, reached);
  const bool good = hit.body == wall.handle() && std::abs(8 * hit.time - 4) < 1e-4 && reached == 2;
  if (good) return 0;
  std::fputs("wrong\n", stderr);
  return 1;
}
