// A car to drive on a stage.
#pragma once

#include "stage.h"

namespace kit {

inline constexpr double kDt = 1. / 60;

/// A car of 1200 kg: axles at z = +-1.3, wheels at x = +-0.75, centre of mass 0.55 m above the ground.
struct Car {
  static constexpr double kMass = 1200, kRadius = 0.33, kBase = 2.6, kTrack = 1.5;
  Stage& stage;
  carom_body body;
  carom_vehicle_desc desc;
  carom_wheel_desc wheel_descs[4];  // front left, front right, rear left, rear right: left is +x
  carom_vehicle_input input;
  carom_vehicle state;
  carom_wheel wheels[4];

  Car(Stage& s, const V& at, const Q& turn = {0, 0, 0, 1}) : stage(s) {
    carom_body_desc d;
    carom_body_desc_init(&d, sizeof d);
    std::memcpy(d.position, at.data(), sizeof d.position);
    std::memcpy(d.orientation, turn.data(), sizeof d.orientation);
    d.fields = CAROM_BODY_FIELD_MASS | CAROM_BODY_FIELD_CENTER | CAROM_BODY_FIELD_INERTIA;
    d.mass = kMass, d.inertia[0] = 1600, d.inertia[4] = 1800, d.inertia[8] = 500;
    GOOD(carom_body_create(s.world, &d, &body, nullptr));
    carom_collider_desc c;
    carom_collider_desc_init(&c, sizeof c);
    c.shape = s.shape("box", {0.85, 0.3, 2});
    c.position[1] = 0.15;
    carom_collider collider;
    GOOD(carom_collider_create(s.world, body, &c, &collider, nullptr));
    GOOD(carom_vehicle_desc_init(&desc, sizeof desc));
    desc.chassis = body;
    GOOD(carom_vehicle_input_init(&input, sizeof input));
    GOOD(carom_vehicle_init(&state, sizeof state));
    for (int i = 0; i < 4; ++i) {
      carom_wheel_desc& w = wheel_descs[i];
      GOOD(carom_wheel_desc_init(&w, sizeof w));
      GOOD(carom_wheel_init(&wheels[i], sizeof wheels[i]));
      w.position[0] = (i % 2 ? -1 : 1) * kTrack / 2, w.position[1] = -0.32,
      w.position[2] = (i < 2 ? 1 : -1) * kBase / 2;
      if (i < 2) w.max_steer = 0.6;
      if (i >= 2) w.drive = 1, w.handbrake = 3000;
    }
  }
  void frame(double dt = kDt) {
    carom_error e = CAROM_ERROR_INIT;
    const int32_t r = carom_vehicle_drive(stage.world, &desc, wheel_descs, 4, &input, &state, wheels, dt, &e);
    if (r != CAROM_OK) print_error("%s\n", e.message);
    GOOD(r);
    stage.step(dt);
  }
  void frames(int n, double dt = kDt) {
    for (int i = 0; i < n; ++i) frame(dt);
  }
  V place() { return stage.place(body); }
  V velocity() {
    V v;
    GOOD(carom_body_get_velocity(stage.world, body, v.data(), nullptr, nullptr));
    return v;
  }
  V spin() {
    V w;
    GOOD(carom_body_get_velocity(stage.world, body, nullptr, w.data(), nullptr));
    return w;
  }
  void roll_at(double speed) {  // forward, wheels with it
    const V v = {0, 0, speed}, none = {0, 0, 0};
    GOOD(carom_body_set_velocity(stage.world, body, v.data(), none.data(), nullptr));
    for (carom_wheel& w : wheels) w.spin = speed / kRadius;
  }
  double load() const { return wheels[0].load + wheels[1].load + wheels[2].load + wheels[3].load; }
};

}  // namespace kit
