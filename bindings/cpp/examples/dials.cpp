// Dials: a pendulum of a preset for crowds, and the same with one dial turned.
#include <carom/carom.hpp>
#include <cmath>
#include <cstdio>
#include <utility>

/// m, after 2 s; where the ball should be follows from the equation of motion.
double error(std::initializer_list<std::pair<std::uint32_t, double>> dials) {
  auto engine = carom::Engine::create();
  auto world = engine.world();
  world.call(carom_world_set_preset, CAROM_PRESET_FAST);
  for (const auto& [dial, value] : dials) world.call(carom_world_set_dial, dial, value);
  const auto ball = world.body(engine.shape("sphere", {0.1}), {.position = {1, 0, 0}});
  auto desc = carom::make<carom_joint_desc>();
  desc.kind = CAROM_JOINT_BALL, desc.fields = CAROM_JOINT_WORLD_FRAME, desc.body_b = ball.handle();  // at the origin
  world.make<carom_joint>(carom_joint_create, &desc);
  for (int i = 0; i < 120; i++) world.step(1.0 / 60);
  return std::abs(ball.position()[0] - 0.7850683);
}

int main() {
  const double fast = error({}), finer = error({{CAROM_DIAL_SUBSTEPS, 8}});
  const double exact = error({{CAROM_DIAL_SUBSTEPS, 8}, {CAROM_DIAL_JOINT_ORDER, 4}});
  std::printf("off by %.2f mm; with 8 substeps by %.3f mm; of order 4 by less than 1 um: %s\n", 1e3 * fast, 1e3 * finer,
              exact < 1e-6 ? "yes" : "no");
  if (fast > 1e-3 && 1e-3 > 10 * finer && exact < 1e-6) return 0;
  std::fputs("wrong\n", stderr);
  return 1;
}
