// Joints and a motor: a motor turns a hinge at 1 rad/s, and a limit stops it at 1 rad.
#include <carom/carom.hpp>
#include <cmath>
#include <cstdio>

int main() {
  auto engine = carom::Engine::create();
  auto world = engine.world();
  const auto rod = world.body(engine.shape("box", {0.5, 0.05, 0.05}), {.position = {0.5, 0, 0}});
  auto desc = carom::make<carom_joint_desc>();
  desc.kind = CAROM_JOINT_HINGE, desc.fields = CAROM_JOINT_WORLD_FRAME, desc.body_b = rod.handle();  // at the origin
  desc.orientation_a[1] = -std::sqrt(0.5), desc.orientation_a[3] = std::sqrt(0.5);  // its x axis is the world's z axis
  const auto hinge = world.make<carom_joint>(carom_joint_create, &desc);
  auto motor = carom::make<carom_joint_motor>();
  motor.enabled = 1, motor.speed = 1, motor.max_force = 200;  // rad/s, N m
  world.call(carom_joint_set_motor, hinge, CAROM_COORDINATE_TWIST, &motor);
  auto limit = carom::make<carom_joint_limit>();
  limit.enabled = 1, limit.lower = -1, limit.upper = 1;  // rad
  world.call(carom_joint_set_limit, hinge, CAROM_COORDINATE_TWIST, &limit);
  double angle[2];
  for (int i = 0; i < 2; i++) {
    for (int step = 0; step < 30 + 90 * i; step++) world.step(1.0 / 60);
    auto state = carom::make<carom_joint_state>();
    world.call(carom_joint_get_state, hinge, &state);
    angle[i] = state.coordinate[CAROM_COORDINATE_TWIST];
  }
  std::printf("%.2f rad after 0.5 s, %.2f rad after 2.5 s, at the limit\n", angle[0], angle[1]);
  const bool good = std::abs(angle[0] - 0.5) < 0.02 && std::abs(angle[1] - 1) < 0.01;
  if (good) return 0;
  std::fputs("wrong\n", stderr);
  return 1;
}
