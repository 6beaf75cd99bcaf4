// Ground of a height field, in whose valley a ball comes to rest, and of triangles, down which a crate slides.
#include <carom/carom.hpp>
#include <cmath>
#include <cstdio>
#include <numbers>

int main() {
  auto engine = carom::Engine::create();
  auto world = engine.world();
  std::vector<double> heights;  // m, rows along z
  for (int z = -4; z <= 4; z++)
    for (int x = -4; x <= 4; x++) heights.push_back(0.25 * std::max(0.0, std::hypot(x, z) - 1));
  auto valley = carom::make<carom_height_field_desc>();
  valley.heights = heights.data(), valley.columns = valley.rows = 9;
  world.body(engine.make<carom_shape>(carom_shape_create_height_field, &valley),
             {.type = CAROM_BODY_STATIC, .position = {-4, 0, -4}});  // of its corner
  const double tilt = std::numbers::pi / 6, s = std::sin(tilt), c = std::cos(tilt);
  const double x1 = 6 + 9 * c, y1 = 4 - 9 * s, y2 = y1 + 3;  // a wall at its end
  const double corners[] = {6, 4, -2, 6, 4, 2, x1, y1, -2, x1, y1, 2, x1, y2, -2, x1, y2, 2};
  const std::uint32_t triangles[] = {0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5};
  auto ramp = carom::make<carom_mesh_desc>();
  ramp.vertices = corners, ramp.vertex_count = 6, ramp.triangles = triangles, ramp.triangle_count = 4;
  world.body(engine.make<carom_shape>(carom_shape_create_mesh, &ramp), {.type = CAROM_BODY_STATIC});
  auto slippery = carom::make<carom_material_desc>();
  slippery.friction = 0;
  const auto smooth = world.make<carom_material>(carom_material_create, &slippery);
  const carom::Vec3 start{6 + c + 0.5 * s, 4 - s + 0.5 * c, 0};  // 1 m down
  const auto crate = world.body(
      engine.shape("box", {0.5, 0.5, 0.5}),
      {.position = start, .orientation = {0, 0, -std::sin(tilt / 2), std::cos(tilt / 2)}, .material = smooth});
  auto about = carom::make<carom_body_desc>();
  auto part = carom::make<carom_collider_desc>();
  about.position[0] = 3, about.position[1] = 2, about.position[2] = 1;
  about.linear_damping = about.angular_damping = 0.5, part.shape = engine.shape("sphere", {0.5});
  const auto ball = world.body(about, {&part, 1});
  for (int i = 0; i < 60; i++) world.step(1.0 / 60);
  const auto slid = crate.position();
  const double way = std::hypot(slid[0] - start[0], slid[1] - start[1]);
  for (int i = 0; i < 600; i++) world.step(1.0 / 60);
  const auto [x, y, z] = ball.position();
  std::printf("the crate slides by %.2f m in 1 s, and the ball lies at y = %.2f m\n", way, y);
  const bool good = std::abs(way - 9.81 * s / 2) < 0.01 && std::abs(y - 0.5) < 0.005 && std::abs(x) < 2;
  if (good) return 0;
  std::fputs("wrong\n", stderr);
  return 1;
}
