// Snapshots and rollback: a guess about a player was wrong, so 30 steps are made again with what was really done.
#include <carom/carom.hpp>
#include <cmath>
#include <cstdio>

static void play(carom::World& world, carom::Body ball, bool pushed, int from, int to) {
  for (int step = from; step < to; step++) {
    if (pushed && step == 70) ball.set_velocity({2, 0, 0}, {});
    world.step(1.0 / 60);
  }
}

int main() {
  auto engine = carom::Engine::create();
  auto world = engine.world();
  world.ground();
  const auto ball = world.body(engine.shape("sphere", {0.5}), {.position = {0, 0.5, 0}});
  play(world, ball, false, 0, 60);
  auto truth = world.fork();  // a world in which nothing is guessed
  carom_body twin = ball.handle();
  truth.call(carom_world_translate_handles, &twin, 1, &twin);  // the ball there
  const auto saved = world.save();
  play(world, ball, false, 60, 90);  // the guess: no push
  const double guess = ball.position()[0];
  world.restore(saved);
  play(world, ball, true, 60, 90);
  play(truth, carom::Body(truth.get(), twin), true, 60, 90);
  const double x = ball.position()[0];
  const bool same = world.hash() == truth.hash();
  std::printf("guessed x = %.2f m, it was %.2f m; the same bits as without a guess: %s\n", guess, x,
              same ? "yes" : "no");
  const bool good = same && std::abs(guess) < 1e-6 && x > 0.4;
  if (good) return 0;
  std::fputs("wrong\n", stderr);
  return 1;
}
