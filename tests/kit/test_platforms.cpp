// Ground that moves: lifts, turntables, trains, rafts, conveyors; what a jump takes with it; platforms that go away.
#include "stage.h"

namespace {

using namespace kit;

carom_body platform(Stage& s, const V& half, const V& at) {
  return s.body(CAROM_BODY_KINEMATIC, s.shape("box", {half[0], half[1], half[2]}), at);
}
void drive(Stage& s, carom_body of, const V& linear, const V& angular = {0, 0, 0}) {
  GOOD(carom_body_set_velocity(s.world, of, linear.data(), angular.data(), nullptr));
}

void a_platform_that_moves_takes_it_along(void**) {
  for (const double rate : {30., 60., 240.}) {
    Stage s;
    const carom_body train = platform(s, {3, 0.5, 3}, {0, -0.5, 0});
    Walker w(s, {1, 0, 0.5});
    double worst = 0;
    for (int i = 0; i < 10 * rate; ++i) {
      const double t = i / rate;
      drive(s, train, {3 * std::cos(t), 2 * std::sin(1.3 * t), -1.5});
      w.frame({0, 0, 0}, 1 / rate);
      assert_true(w.firm());
      const V p = s.place(train);
      worst = std::fmax(worst, std::hypot(w.position[0] - p[0] - 1, w.feet() - p[1] - 0.5, w.position[2] - p[2] - 0.5));
    }
    print_message("%g Hz: %.2g m off its place on the platform\n", rate, worst);
    assert_true(near_to(worst, 0, 1e-6));
  }
}

/// The oracle of the issue: 1e-3 of the radius in 100 turns.
void a_turntable_takes_it_round(void**) {
  Stage s;
  const carom_body table = platform(s, {4, 0.5, 4}, {0, -0.5, 0});
  Walker w(s, {2.5, 0, 0});
  const double dt = 1. / 60, omega = 2 * kPi / 2;  // a turn in 2 s
  drive(s, table, {0, 0, 0}, {0, omega, 0});
  const int frames = 100 * 120;
  double worst = 0, seen = 0;
  for (int i = 1; i <= frames; ++i) {
    w.frame({0, 0, 0}, dt);
    // Where the platform is says where it is to be.
    double q[4];
    GOOD(carom_body_get_pose(s.world, table, nullptr, q, nullptr));
    const double c = 1 - 2 * q[1] * q[1], n = 2 * q[1] * q[3];
    worst = std::fmax(worst, std::hypot(w.position[0] - 2.5 * c, w.position[2] + 2.5 * n));
    seen = std::fmax(seen, std::fabs(std::fabs(w.orientation[1]) - std::fabs(q[1])));
    assert_true(w.firm());
  }
  print_message("100 turns: %.2g of the radius off, %.2g of its turn\n", worst / 2.5, seen);
  assert_true(near_to(worst / 2.5, 0, 1e-6) && near_to(seen, 0, 1e-9));
  assert_true(near_to(std::hypot(w.ground_velocity[0], w.ground_velocity[2]), 2.5 * omega, 1e-4));
}

void poses_of_the_host_move_it_too(void**) {
  Stage s;
  const carom_body lift = platform(s, {2, 0.5, 2}, {0, -0.5, 0});
  Walker w(s, {0.5, 0, 0});
  const Q still = {0, 0, 0, 1};
  for (int i = 1; i <= 240; ++i) {
    const double y = -0.5 + std::sin(i * 0.05);
    const V at = {0.02 * i, y, 0};
    GOOD(carom_body_set_pose(s.world, lift, at.data(), still.data(), nullptr));
    w.move({0, 0, 0}, 1. / 60);
    assert_true(near_to(w.feet(), y + 0.5, 1e-6) && near_to(w.position[0], 0.5 + 0.02 * i, 1e-6) && w.firm());
  }
  assert_true(near_to(w.ground_velocity[0], 0.02 * 60, 1e-6));
}

void a_jump_takes_the_velocity_of_the_ground(void**) {
  Stage s;
  s.ground();
  const carom_body train = platform(s, {30, 0.5, 3}, {0, 0.5, 0});
  drive(s, train, {8, 0, 0});
  Walker w(s, {0, 1, 0});
  const double dt = 1. / 60;
  for (int i = 0; i < 30; ++i) w.frame({0, 0, 0}, dt);
  const double x = w.position[0] - s.place(train)[0];
  w.frame({0, 0, 0}, dt, 4);
  assert_true(!w.firm() && near_to(w.velocity[0], 8, 1e-9));
  int air = 0;
  while (!w.firm()) w.frame({0, 0, 0}, dt), ++air;
  assert_true(air > 40);  // 0.8 s
  assert_true(near_to(w.position[0] - s.place(train)[0], x, 1e-3));
  for (int i = 0; i < 10; ++i) w.frame({0, 0, 0}, dt);
  assert_true(near_to(w.position[0] - s.place(train)[0], x, 1e-3) && near_to(w.velocity[0], 0, 1e-9));
}

void a_conveyor_moves_it(void**) {
  Stage s;
  const carom_body belt = s.box({-20, -1, -20}, {20, 0, 20});
  carom_collider collider;
  uint64_t count;
  GOOD(carom_body_get_colliders(s.world, belt, &collider, 1, &count, nullptr));
  const V linear = {1.5, 0, 0}, angular = {0, 0, 0};
  GOOD(carom_collider_set_surface_velocity(s.world, collider, linear.data(), angular.data(), nullptr));
  Walker w(s, {0, 0, 0});
  for (int i = 0; i < 120; ++i) w.frame({0, 0, 0.5}, 1. / 60);
  assert_true(near_to(w.position[0], 3, 1e-6) && near_to(w.position[2], 1, 1e-6));
}

void a_raft_on_springs_bears_it_and_sinks_by_its_weight(void**) {
  Stage s;
  const carom_body raft =
      s.body(CAROM_BODY_DYNAMIC, s.shape("box", {1.5, 0.25, 1.5}), {0, -0.25, 0}, {0, 0, 0, 1}, 100);
  GOOD(carom_body_set_locks(s.world, raft, CAROM_LOCK_ALL & ~CAROM_LOCK_LINEAR_Y, nullptr));
  GOOD(carom_body_set_gravity_factor(s.world, raft, 0, nullptr));
  carom_spring_desc d;
  carom_spring_desc_init(&d, sizeof d);
  const double k = 8000;
  d.body_a = raft;
  d.anchor_b[1] = -10.25;
  d.rest = 10, d.stiffness = k, d.damping = 800;
  carom_spring spring;
  GOOD(carom_spring_create(s.world, &d, &spring, nullptr));
  Walker w(s, {0.2, 0, 0.1});
  for (int i = 0; i < 600; ++i) w.frame({0, 0, 0}, 1. / 60), assert_true(w.firm());
  // m g / k, to what the step leaves of the spring's motion.
  assert_true(near_to(s.place(raft)[1] + 0.25, -80 * 9.81 / k, 1e-3));
  assert_true(near_to(w.feet(), s.place(raft)[1] + 0.25, 1e-4));
}

void a_wall_stops_it_while_the_platform_goes_on(void**) {
  Stage s;
  const carom_body lift = platform(s, {2, 0.5, 2}, {0, -0.5, 0});
  s.box({1.5, 0.2, -9}, {2, 9, 9});
  Walker w(s, {0, 0, 0});
  drive(s, lift, {1, 0, 0});
  for (int i = 0; i < 150; ++i) w.frame({0, 0, 0}, 1. / 60);
  assert_true(near_to(w.position[0], 1.5 - 0.3 - Walker::kGap, 1e-3) && w.firm());
}

void platforms_that_vanish_let_it_fall(void**) {
  Stage s;
  s.box({-5, -3, -5}, {5, -2, 5});
  const carom_body lift = platform(s, {2, 0.5, 2}, {0, -0.5, 0});
  Walker w(s, {0, 0, 0});
  assert_true(w.firm() && w.ground_body == lift);
  GOOD(carom_body_destroy(s.world, lift, nullptr));
  w.frame({0, 0, 0}, 1. / 60);
  assert_true(!w.firm());
  for (int i = 0; i < 60; ++i) w.frame({0, 0, 0}, 1. / 60);
  assert_true(w.firm() && near_to(w.feet(), -2, 1e-4));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_platform_that_moves_takes_it_along),
      cmocka_unit_test(a_turntable_takes_it_round),
      cmocka_unit_test(poses_of_the_host_move_it_too),
      cmocka_unit_test(a_jump_takes_the_velocity_of_the_ground),
      cmocka_unit_test(a_conveyor_moves_it),
      cmocka_unit_test(a_raft_on_springs_bears_it_and_sinks_by_its_weight),
      cmocka_unit_test(a_wall_stops_it_while_the_platform_goes_on),
      cmocka_unit_test(platforms_that_vanish_let_it_fall),
  };
  return cmocka_run_group_tests_name("kit/platforms", tests, nullptr, nullptr);
}
