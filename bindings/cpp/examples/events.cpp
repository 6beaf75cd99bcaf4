// Events of contacts: when a ball that falls 2 m hits the ground, and how fast.
#include <carom/carom.hpp>
#include <cmath>
#include <cstdio>

int main() {
  auto engine = carom::Engine::create();
  auto world = engine.world();
  world.ground();
  const auto ball = world.body(engine.shape("sphere", {0.5}), {.position = {0, 2.5, 0}}).handle();
  world.call(carom_world_collect_events, CAROM_EVENTS_CONTACT, 1.0);
  carom_contact_event hit{};
  int hits = 0;
  double at = 0;
  for (int step = 0; step < 60; step++) {
    world.step(1.0 / 60);  // events are those of the last step
    carom_contact_event events[8];
    const auto count = world.make<std::uint64_t>(carom_world_get_contact_events, events, sizeof *events, 8);
    for (const auto& event : std::span(events).first(std::min<std::size_t>(count, 8)))
      if (event.kind == CAROM_CONTACT_HIT && !hits++) hit = event, at = (step + 1) / 60.0;
  }
  std::printf("%d hit, after %.2f s, at %.2f m/s\n", hits, at, hit.approach_speed);
  const double fall = std::sqrt(2 * 2 / 9.81);  // s
  const bool good = hits == 1 && (hit.body_a == ball || hit.body_b == ball) && std::abs(at - fall) < 2.0 / 60 &&
                    std::abs(hit.approach_speed - 9.81 * fall) < 9.81 / 60;
  if (good) return 0;
  std::fputs("wrong\n", stderr);
  return 1;
}
