// The scene of scene.c by way of carom.hpp, and the double cone of plugins/template as a lambda.
#ifndef CAROM_TESTS_SCENE_HPP
#define CAROM_TESTS_SCENE_HPP
#include <carom/carom.hpp>
#include <cmath>

/// plugins/template/template.c, operation by operation.
inline carom::Vec3 top_support(std::span<const double> params, const carom::Vec3& d) {
  const double r = params[0], h = params[1], side = std::fmax(std::fabs(d[0]), std::fabs(d[2]));
  const double largest = std::fmax(side, std::fabs(d[1]));
  double x = d[0], z = d[2], length = 0;
  if (side > 0) {
    x /= side, z /= side;
    length = std::sqrt(x * x + z * z);
    x /= length, z /= length;
  }
  if (h * (std::fabs(d[1]) / largest) > r * (length * (side / largest))) return {0, d[1] >= 0 ? h : -h, 0};
  return {r * x, 0, r * z};
}

/// Hashes after 1, 2 and 3 s.
inline std::array<std::uint64_t, 3> scene_hashes(carom::Engine& engine, carom_shape top) {
  const carom_shape shapes[] = {engine.shape("sphere", {0.3}), engine.shape("box", {0.4, 0.25, 0.3}), top};
  auto world = engine.world();
  world.call(carom_world_set_dial, CAROM_DIAL_SUBSTEPS, 5);
  const carom::Vec3 wind{1.5, 0, 0.5};
  world.call(carom_world_set_wind, wind.data());
  auto surface = carom::make<carom_material_desc>();
  surface.friction = 0.6, surface.restitution = 0.3;
  const auto material = world.make<carom_material>(carom_material_create, &surface);
  world.body(engine.shape("half_space", {0, 1, 0, 0}), {.type = CAROM_BODY_STATIC, .material = material});
  for (int i = 1; i < 19; i++)
    world
        .body(shapes[i % 3], {.position = {(i % 3) * 0.5, 0.6 + i * 0.55, (i % 2) * 0.4},
                              .angular_velocity = {0.5 * i, 0, 1},
                              .density = 400.0 + 50 * i,
                              .material = material})
        .call(carom_body_set_drag, 0.1, 0.02);
  const auto door = world.body(shapes[1], {.position = {4.5, 3, 0}});
  auto hinge = carom::make<carom_joint_desc>();
  hinge.kind = CAROM_JOINT_HINGE, hinge.fields = CAROM_JOINT_WORLD_FRAME, hinge.body_b = door.handle();
  std::ranges::copy(carom::Vec3{4, 3, 0}, hinge.position_a),
      std::ranges::copy(carom::Quat{0, -0.6, 0, 0.8}, hinge.orientation_a);
  world.make<carom_joint>(carom_joint_create, &hinge);
  std::array<std::uint64_t, 3> hashes;
  for (auto& hash : hashes) {
    for (int i = 0; i < 60; i++) world.step(1.0 / 60);
    hash = world.hash();
  }
  return hashes;
}
#endif
