// A character walks over three steps of 0.2 m, and pushes a crate that stands there.
#include <carom/carom.hpp>
#include <cmath>
#include <cstdio>

int main() {
  auto engine = carom::Engine::create();
  auto world = engine.world();
  world.ground();
  const auto slab = engine.shape("box", {2, 0.1, 2});
  for (int i = 0; i < 3; i++)
    world.body(slab, {.type = CAROM_BODY_STATIC, .position = {3 + 0.5 * i, 0.1 + 0.2 * i, 0}});
  const auto crate = world.body(engine.shape("box", {0.2, 0.2, 0.2}), {.position = {3, 0.8, 0}});
  auto desc = carom::make<carom_character_desc>();
  auto walker = carom::make<carom_character>();
  desc.step_up = 0.25, walker.position[1] = 1;
  engine.call(carom_character_set_shape, world.get(), &desc, &walker, engine.shape("capsule", {0.3, 0.6}), nullptr);
  const double walk[3] = {1.5, 0, 0}, dt = 1.0 / 60;
  for (int i = 0; i < 180; i++) {
    world.step(dt);
    world.call(carom_character_move, &desc, &walker, walk, 0, dt);
    world.call(carom_character_push, &desc, &walker, dt);
  }
  const double pushed = crate.position()[0] - 3, feet = walker.position[1] - walker.foot;
  const bool firm = walker.ground == CAROM_GROUND_FIRM;
  std::printf("after 3 s it stands on %s ground, %.2f m up, and has pushed a crate by %.1f m\n",
              firm ? "firm" : "no firm", feet, pushed);
  const bool good = firm && std::abs(feet - 0.6 - 0.0102) < 1e-4 &&  // a skin of 0.01 m and 2 % lies between
                    pushed > 1 && pushed < 2 && walker.contact_count == 1 && walker.contact_bodies[0] == crate.handle();
  if (good) return 0;
  std::fputs("wrong\n", stderr);
  return 1;
}
