// An accuracy that is asked for: a pendulum is off by no more than a micrometre per second of motion.
#include <carom/carom.hpp>
#include <cmath>
#include <cstdio>

int main() {
  auto engine = carom::Engine::create();
  auto world = engine.world();
  const auto ball = world.body(engine.shape("sphere", {0.1}), {.position = {1, 0, 0}});
  auto desc = carom::make<carom_joint_desc>();
  desc.kind = CAROM_JOINT_BALL, desc.fields = CAROM_JOINT_WORLD_FRAME, desc.body_b = ball.handle();  // at the origin
  world.make<carom_joint>(carom_joint_create, &desc);
  auto asked = carom::make<carom_accuracy>();
  asked.place = asked.turn = 1e-6;  // m and rad per second
  world.call(carom_world_set_accuracy, &asked);
  for (int i = 0; i < 120; i++) world.step(1.0 / 60);
  carom_island worst;
  const auto islands = world.make<std::uint64_t>(carom_world_get_islands, &worst, sizeof worst, 1);
  const double x = ball.position()[0];
  const bool within = islands == 1 && worst.share <= 1;
  std::printf("after 2 s at x = %.5f m; the error is within what was asked: %s\n", x, within ? "yes" : "no");
  const bool good = within && std::abs(x - 0.785070) < 5e-6;  // by its equation of motion
  if (good) return 0;
  std::fputs("wrong\n", stderr);
  return 1;
}
