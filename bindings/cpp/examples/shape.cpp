// A shape of your own: a support function is all of it. An elliptic cylinder, its axis upright.
#include <carom/carom.hpp>
#include <cmath>
#include <cstdio>

/// The farthest point of the shape along a direction.
static carom::Vec3 support(std::span<const double> p, const carom::Vec3& d) {
  const double length = std::hypot(p[0] * d[0], p[2] * d[2]);
  return {length > 0 ? p[0] * p[0] * d[0] / length : 0, std::copysign(p[1], d[1]),
          length > 0 ? p[2] * p[2] * d[2] / length : 0};
}

int main() {
  auto engine = carom::Engine::create();
  auto world = engine.world();
  world.ground();
  const auto kind = engine.plugin("example.elliptic_cylinder",
                                  {{"a", "m", 1e-6, 1e3}, {"h", "m", 1e-6, 1e3}, {"b", "m", 1e-6, 1e3}}, support);
  const auto body = world.body(engine.shape(kind, {0.6, 0.2, 0.3}), {.position = {0, 1, 0}});  // 1000 kg/m^3
  for (int i = 0; i < 120; i++) world.step(1.0 / 60);
  double mass;
  body.call(carom_body_get_mass, &mass, nullptr, nullptr);
  const double y = body.position()[1];
  std::printf("it weighs %.0f kg and lies at y = %.2f m\n", mass, y);
  const double volume = std::acos(-1) * 0.6 * 0.3 * 0.4;
  const bool good = std::abs(mass / (1000 * volume) - 1) < 0.005 && std::abs(y - 0.2) < 0.005;
  if (good) return 0;
  std::fputs("wrong\n", stderr);
  return 1;
}
