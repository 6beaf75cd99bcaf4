// A car brakes: from 20 m/s on tyres of grip 1 it needs v^2 / (2 g) = 20.4 m.
#include <carom/carom.hpp>
#include <cmath>
#include <cstdio>

int main() {
  auto engine = carom::Engine::create();
  auto world = engine.world();
  world.ground();
  auto about = carom::make<carom_body_desc>();
  about.fields = CAROM_BODY_FIELD_MASS | CAROM_BODY_FIELD_CENTER | CAROM_BODY_FIELD_INERTIA, about.mass = 1200;
  about.inertia[0] = 1600, about.inertia[4] = 1800, about.inertia[8] = 500, about.position[1] = 0.6;
  auto part = carom::make<carom_collider_desc>();
  part.shape = engine.shape("box", {0.85, 0.3, 2}), part.position[1] = 0.15;
  const auto body = world.body(about, {&part, 1});
  auto desc = carom::make<carom_vehicle_desc>();
  auto input = carom::make<carom_vehicle_input>();
  auto car = carom::make<carom_vehicle>();
  desc.chassis = body.handle(), input.gear = 0;
  std::vector wheels(4, carom::make<carom_wheel_desc>());
  std::vector states(4, carom::make<carom_wheel>());
  for (int i = 0; i < 4; i++) {
    wheels[i].position[0] = i % 2 ? -0.75 : 0.75, wheels[i].position[2] = i < 2 ? 1.3 : -1.3;
    wheels[i].position[1] = -0.32, wheels[i].brake = 1e5, wheels[i].slide = 1;
  }
  double begin = 0;
  for (int step = 0; step < 330; step++) {
    if (step == 120) {  // until then it settles on its springs
      body.set_velocity({0, 0, 20}, {});
      begin = body.position()[2], input.brake = 1;
      for (auto& state : states) state.spin = 20 / 0.33;
    }
    world.call(carom_vehicle_drive, &desc, wheels.data(), 4, &input, &car, states.data(), 1.0 / 60);
    world.step(1.0 / 60);
  }
  const double way = body.position()[2] - begin;
  std::printf("it brakes from 20 m/s in %.1f m and stands: %.2f m/s\n", way, std::abs(car.speed));
  const bool good = std::abs(way - 400 / (2 * 9.81)) < 0.5 && std::abs(car.speed) < 1e-3;
  if (good) return 0;
  std::fputs("wrong\n", stderr);
  return 1;
}
