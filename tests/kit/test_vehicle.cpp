// Vehicles against closed forms: sag of springs, stopping distance, circles, the limit of side grip, slopes, anti-roll
// bars, gears; seams, fields, platforms; frame rates; the same bits.
#include "car.h"

namespace {

using namespace kit;

constexpr double kG = 9.81;

void springs_sag_by_the_weight(void**) {
  for (const double rate : {30., 60., 240.}) {
    Stage s;
    s.ground();
    Car car(s, {0, 0.7, 0});
    car.frames(static_cast<int>(6 * rate), 1 / rate);
    for (const carom_wheel& w : car.wheels) {
      assert_true(w.touches == 1 && near_to(w.compression, Car::kMass * kG / (4 * 30000), 1e-6));
      assert_true(near_to(w.load, Car::kMass * kG / 4, 1e-3));
    }
    const V v = car.velocity();
    assert_true(near_to(std::hypot(v[0], v[1], v[2]), 0, 1e-7));
  }
}

/// v^2 / (2 mu g): wheels lock at once, and the tyre builds up its force within its relaxation length, so that the way is
/// longer by about that. The end is the swing of the tyres, of centimetres.
void it_stops_in_the_distance_that_grip_allows(void**) {
  for (const double rate : {30., 60., 240.})
    for (const double speed : {10., 30.})
      for (const double grip : {0.5, 1.}) {
        Stage s;
        s.ground();
        Car car(s, {0, 0.6, 0});
        car.frames(static_cast<int>(2 * rate), 1 / rate);
        car.roll_at(speed);
        car.input.brake = 1, car.input.gear = 0;
        for (carom_wheel_desc& w : car.wheel_descs) w.brake = 1e5, w.slide = 1, w.grip = w.side_grip = grip;
        const double z = car.place()[2];
        car.frames(static_cast<int>((speed / (grip * kG) + 1.5) * rate), 1 / rate);
        const double way = car.place()[2] - z, oracle = speed * speed / (2 * grip * kG);
        if (!near_to(way, oracle, 0.3 + 0.01 * oracle)) print_error("%g Hz, %g m/s, grip %g\n", rate, speed, grip);
        assert_true(near_to(way, oracle, 0.3 + 0.01 * oracle));
        assert_true(near_to(car.velocity()[2], 0, 1e-3));
      }
}

void slow_circles_have_the_radius_of_the_steering(void**) {
  for (const double angle : {0.1, 0.3, 0.55}) {
    Stage s;
    s.ground();
    Car car(s, {0, 0.6, 0});
    car.frames(60);
    car.roll_at(2);
    car.input.steer = angle / 0.6;
    car.input.throttle = 0, car.input.gear = 0;
    for (carom_wheel_desc& w : car.wheel_descs) w.rolling = 0, w.side_peak_slip = 0.05;
    car.frames(120);
    // Of the middle of the rear axle, about the centre of turn: base / tan.
    const V v = car.velocity(), w = car.spin();
    const double speed = std::hypot(v[0], v[2]), radius = speed / w[1];
    const double oracle = std::hypot(Car::kBase / std::tan(angle), Car::kBase / 2);
    assert_true(near_to(radius / oracle, 1, 0.02));
  }
}

/// Side grip bears mu g at most, and a car that steers more and more comes near it.
void it_turns_no_faster_than_side_grip_allows(void**) {
  for (const double grip : {0.4, 0.8}) {
    Stage s;
    s.ground();
    Car car(s, {0, 0.6, 0});
    for (carom_wheel_desc& w : car.wheel_descs) w.grip = w.side_grip = grip, w.slide = 1, w.anti_roll = 20000;
    car.wheel_descs[0].anti_roll_partner = 1, car.wheel_descs[2].anti_roll_partner = 3;
    car.frames(60);
    car.roll_at(18);
    car.input.gear = 0;
    double most = 0;
    for (int i = 0; i < 240; ++i) {
      car.input.steer = std::fmin(1, i / 240.) * 0.5;
      const V before = car.velocity();
      car.frame();
      const V after = car.velocity();
      const double speed = std::hypot(after[0], after[2]);
      const double side =
          std::fabs((after[0] - before[0]) * after[2] - (after[2] - before[2]) * after[0]) / speed / kDt;
      most = std::fmax(most, side);
      assert_true(std::hypot(after[0] - before[0], after[2] - before[2]) / kDt < grip * kG * 1.02 + 0.05);
    }
    print_message("grip %g: %.3f of it sideways\n", grip, most / (grip * kG));
    assert_true(most > 0.95 * grip * kG);
  }
}

void parked_on_a_slope_it_stays(void**) {
  for (const double degrees : {5., 15., 25.})
    for (const bool by_hand : {false, true})
      for (const double rate : {30., 60.}) {
        Stage s;
        const double a = degrees * kPi / 180;
        carom_shape plane;
        const double up[3] = {0, 1, 0};
        GOOD(carom_shape_create_half_space(s.engine, up, 0, &plane, nullptr));
        const Q turn = about({1, 0, 0}, -a);  // it looks uphill
        s.body(CAROM_BODY_STATIC, plane, {0, 0, 0}, turn);
        Car car(s, {0, 0.62 * std::cos(a), -0.62 * std::sin(a)}, turn);
        car.input.gear = 0;
        (by_hand ? car.input.handbrake : car.input.brake) = 1;
        for (carom_wheel_desc& w : car.wheel_descs) w.handbrake = by_hand ? 3000 : 0;
        car.frames(static_cast<int>(5 * rate), 1 / rate);
        const V before = car.place();
        car.frames(static_cast<int>(60 * rate), 1 / rate);
        const V after = car.place();
        const double crept = std::hypot(after[0] - before[0], after[1] - before[1], after[2] - before[2]);
        if (!near_to(crept, 0, 1e-5))
          print_error("%g degrees, %s, %g Hz\n", degrees, by_hand ? "by hand" : "by foot", rate);
        assert_true(near_to(crept, 0, 1e-5));
      }
}

/// A torque T about the axis of roll: T / (sum over axles of k t^2 / 2 + K t^2).
void anti_roll_bars_are_as_stiff_as_they_say(void**) {
  for (const double bar : {0., 10000., 40000.}) {
    Stage s;
    s.ground();
    Car car(s, {0, 0.6, 0});
    for (carom_wheel_desc& w : car.wheel_descs) w.anti_roll = bar, w.handbrake = 0;
    car.wheel_descs[0].anti_roll_partner = 1, car.wheel_descs[2].anti_roll_partner = 3;
    car.input.gear = 0;
    const V none = {0, 0, 0}, torque = {0, 0, 300};
    for (int i = 0; i < 600; ++i) {
      GOOD(carom_body_add_force(s.world, car.body, none.data(), torque.data(), nullptr));
      car.frame();
    }
    double q[4];
    GOOD(carom_body_get_pose(s.world, car.body, nullptr, q, nullptr));
    const double t2 = Car::kTrack * Car::kTrack, stiff = 2 * (30000 * t2 / 2 + bar * t2);
    // The weight falls over as it rolls: it takes away m g h, with h of the centre above the ground's contact.
    const double roll = 2 * std::asin(q[2]), height = car.place()[1];
    assert_true(near_to(roll * (stiff - Car::kMass * kG * height) / 300, 1, 0.03));
  }
}

void each_gear_ends_at_the_speed_of_the_engine(void**) {
  Stage s;
  s.ground();
  for (int gear = -1; gear <= 3; ++gear) {
    if (gear == 0) continue;
    Car car(s, {0, 0.6, 0});
    car.desc.flags = 0;
    for (carom_wheel_desc& w : car.wheel_descs) w.rolling = 0;
    car.input.gear = gear, car.input.throttle = 1;
    car.frames(60 * 40);
    const double ratio = car.desc.final_drive * (gear < 0 ? -car.desc.reverse : car.desc.gears[gear - 1]);
    const double top = car.desc.max_speed / ratio * Car::kRadius;
    assert_true(near_to(car.state.speed / top, 1, 0.02));
    assert_true(near_to(car.state.engine_speed / car.desc.max_speed, 1, 0.02));
    GOOD(carom_body_destroy(s.world, car.body, nullptr));
  }
}

void an_automatic_goes_through_its_gears(void**) {
  Stage s;
  s.ground();
  Car car(s, {0, 0.6, 0});
  car.frames(60);
  assert_true(near_to(car.velocity()[2], 0, 1e-4));  // in gear at idle it does not creep
  car.input.throttle = 1;
  int changes = 0, gear = car.state.gear;
  for (int i = 0; i < 60 * 25; ++i) {
    car.frame();
    if (car.state.gear != gear) {
      ++changes;
      assert_true(car.state.gear > gear);  // it does not hunt
    }
    gear = car.state.gear;
  }
  assert_true(gear >= 4 && changes == gear - 1 && car.state.speed > 40);
  car.input.throttle = 0, car.input.brake = 0.6;
  for (int i = 0; i < 60 * 12; ++i) car.frame();
  assert_true(near_to(car.state.speed, 0, 1e-3) && car.state.gear <= 2);
  assert_true(near_to(car.state.engine_speed, 90, 10));
}

void seams_and_fields_are_not_felt(void**) {
  const auto bumps = [](Stage& s, const V& at) {
    Car car(s, {at[0], at[1] + 0.6, at[2]});
    car.frames(120);
    car.roll_at(20);
    car.input.gear = 0;
    double low = 1e9, high = -1e9, side = 0;
    for (int i = 0; i < 240; ++i) {
      car.frame();
      const double y = car.place()[1];
      low = std::fmin(low, y), high = std::fmax(high, y), side = std::fmax(side, std::fabs(car.place()[0] - at[0]));
    }
    print_message("height within %.2g m, off its line by %.2g m\n", high - low, side);
    assert_true(near_to(high - low, 0, 1e-3) && near_to(side, 0, 1e-4));
  };
  {
    Stage s;
    for (int i = 0; i < 70; ++i) s.box({-3, -1, 1.5 * i - 5}, {3, 0, 1.5 * i - 3.5});
    bumps(s, {0.2, 0, 0});
  }
  {
    Stage s;
    s.body(CAROM_BODY_STATIC, s.field(12, 80, 1.3, [](double, double) { return 0; }), {-6, 0, -5});
    bumps(s, {0.2, 0, 0});
  }
}

void what_it_pushes_off_moves_the_other_way(void**) {
  Stage s;
  const carom_body floor =
      s.body(CAROM_BODY_STATIC, s.shape("box", {90, 0.5, 90}), {0, -0.5, 0}, {0, 0, 0, 1}, 1000, 0);
  (void)floor;
  const carom_body raft = s.body(CAROM_BODY_DYNAMIC, s.shape("box", {5, 0.25, 40}), {0, 0.25, 0}, {0, 0, 0, 1}, 100, 0);
  GOOD(carom_body_set_locks(s.world, raft,
                            CAROM_LOCK_ANGULAR_X | CAROM_LOCK_ANGULAR_Y | CAROM_LOCK_ANGULAR_Z | CAROM_LOCK_LINEAR_Y,
                            nullptr));
  double mass;
  GOOD(carom_body_get_mass(s.world, raft, &mass, nullptr, nullptr, nullptr));
  Car car(s, {0, 1.1, -20});
  car.input.throttle = 1;
  double worst = 0;
  for (int i = 0; i < 180; ++i) {
    car.frame();
    V v;
    GOOD(carom_body_get_velocity(s.world, raft, v.data(), nullptr, nullptr));
    worst = std::fmax(worst, std::fabs(mass * v[2] + Car::kMass * car.velocity()[2]));
  }
  print_message("momentum within %.2g N s of %.0f\n", worst, Car::kMass * car.velocity()[2]);
  assert_true(car.state.speed > 5 && near_to(worst / (Car::kMass * car.velocity()[2]), 0, 1e-6));
}

void any_rate_drives_the_same_way(void**) {
  V end[5];
  int k = 0;
  for (const double rate : {30., 60., 120., 240., 50.}) {
    Stage s;
    s.ground();
    Car car(s, {0, 0.55, 0});
    car.wheel_descs[0].anti_roll_partner = 1, car.wheel_descs[0].anti_roll = 15000;
    for (int i = 0; i < 8 * rate; ++i) {
      const double t = i / rate;
      car.input.throttle = t < 4 ? 0.7 : 0;
      car.input.brake = t >= 6 ? 0.5 : 0;
      car.input.steer = t >= 2 && t < 5 ? 0.15 : 0;
      car.frame(1 / rate);
    }
    end[k++] = car.place();
  }
  double worst = 0;
  const double way = std::hypot(end[3][0], end[3][2]);
  for (const V& e : end) worst = std::fmax(worst, std::hypot(e[0] - end[3][0], e[2] - end[3][2]));
  print_message("30 to 240 Hz: %.3f m apart after %.1f m\n", worst, way);
  assert_true(way > 30 && worst < 1e-3 * way);
}

std::string bits_of_a_drive() {
  Stage s;
  s.body(CAROM_BODY_STATIC,
         s.field(60, 60, 1,
                 [](double x, double z) { return 0.3 * std::floor(3 * std::fmod(0.37 * x + 0.61 * z, 1)) / 3; }),
         {-30, -1, -30});
  Car car(s, {0, 1.2, 0});
  std::string bits;
  for (int i = 0; i < 600; ++i) {
    car.input.throttle = (i / 70) % 2 ? 0.8 : 0.2, car.input.steer = ((i / 40) % 5 - 2) * 0.4;
    car.input.brake = (i / 130) % 3 == 2 ? 0.7 : 0;
    car.frame();
    const V p = car.place();
    bits.append(reinterpret_cast<const char*>(p.data()), sizeof p);
    for (carom_wheel w : car.wheels) {  // handles have the number of their world in them
      w.body = w.collider = CAROM_NULL_HANDLE;
      bits.append(reinterpret_cast<const char*>(&w), sizeof w);
    }
    assert_true(std::isfinite(p[0]) && std::isfinite(p[1]) && p[1] > -1);
  }
  return bits;
}
void the_same_bits_twice(void**) { assert_true(bits_of_a_drive() == bits_of_a_drive()); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(springs_sag_by_the_weight),
      cmocka_unit_test(it_stops_in_the_distance_that_grip_allows),
      cmocka_unit_test(slow_circles_have_the_radius_of_the_steering),
      cmocka_unit_test(it_turns_no_faster_than_side_grip_allows),
      cmocka_unit_test(parked_on_a_slope_it_stays),
      cmocka_unit_test(anti_roll_bars_are_as_stiff_as_they_say),
      cmocka_unit_test(each_gear_ends_at_the_speed_of_the_engine),
      cmocka_unit_test(an_automatic_goes_through_its_gears),
      cmocka_unit_test(seams_and_fields_are_not_felt),
      cmocka_unit_test(what_it_pushes_off_moves_the_other_way),
      cmocka_unit_test(any_rate_drives_the_same_way),
      cmocka_unit_test(the_same_bits_twice),
  };
  return cmocka_run_group_tests_name("kit/vehicle", tests, nullptr, nullptr);
}
