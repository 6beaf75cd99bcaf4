// What it does to bodies and they to it: pushes with a bounded force, doors that close, overlap at the start, crouching,
// filters, a body of its own; the same bits twice.
#include <thread>

#include "stage.h"

namespace {

using namespace kit;

constexpr double kDt = 1. / 60;

void pushes_are_bounded_by_the_force(void**) {
  // A crate of 1 m^3 without friction: it accelerates at push_force / m, until it is as fast as the character.
  for (const double mass : {50., 200., 1000.}) {
    Stage s;
    s.body(CAROM_BODY_STATIC, s.shape("box", {50, 0.5, 50}), {0, -0.5, 0}, {0, 0, 0, 1}, 1000, 0);
    const carom_body crate =
        s.body(CAROM_BODY_DYNAMIC, s.shape("box", {0.5, 0.5, 0.5}), {1, 0.5, 0}, {0, 0, 0, 1}, mass, 0);
    GOOD(carom_body_set_locks(s.world, crate, CAROM_LOCK_ANGULAR_X | CAROM_LOCK_ANGULAR_Y | CAROM_LOCK_ANGULAR_Z,
                              nullptr));
    Walker w(s, {0, 0, 0});
    double before = 0, most = 0;
    for (int i = 0; i < 240; ++i) {
      w.frame({2, 0, 0}, kDt);
      V v;
      GOOD(carom_body_get_velocity(s.world, crate, v.data(), nullptr, nullptr));
      most = std::fmax(most, (v[0] - before) / kDt);
      before = v[0];
      assert_true(w.position[0] <= s.place(crate)[0] - 0.5 - 0.3 - 0.0099);
    }
    assert_true(most <= 500 / mass * (1 + 1e-6));
    assert_true(most > 500 / mass * 0.9);
    assert_true(before <= 2 + 1e-6 && before > (mass < 500 ? 1.9 : 1.2));
  }
}

void friction_that_is_stronger_holds_the_crate(void**) {
  for (const double mass : {80., 140.}) {  // 0.5 m g: 392 N, 687 N
    Stage s;
    s.ground();
    const carom_body crate =
        s.body(CAROM_BODY_DYNAMIC, s.shape("box", {0.5, 0.5, 0.5}), {1, 0.5, 0}, {0, 0, 0, 1}, mass);
    Walker w(s, {0, 0, 0});
    for (int i = 0; i < 240; ++i) w.frame({1.5, 0, 0}, kDt);
    const double moved = s.place(crate)[0] - 1;
    assert_true(mass < 100 ? moved > 3 : std::fabs(moved) < 1e-2);
  }
}

void it_is_not_pushed_through_walls(void**) {
  // A door closes on it, with the strength of all kinematic bodies.
  Stage s;
  s.ground();
  s.box({1, -1, -5}, {1.5, 3, 5});
  const carom_body door = s.body(CAROM_BODY_KINEMATIC, s.shape("box", {0.1, 1.5, 2}), {-1, 1.5, 0});
  Walker w(s, {0, 0, 0});
  for (int i = 0; i < 300; ++i) {
    const V v = {i < 150 ? 0.8 : 0, 0, 0}, none = {0, 0, 0};
    GOOD(carom_body_set_velocity(s.world, door, v.data(), none.data(), nullptr));
    w.frame({0, 0, 0}, kDt);
    assert_true(w.position[0] < 1 - 0.3 + 1e-3 && std::isfinite(w.position[1]));
  }
  // Alone it is pushed along.
  const V at = {-8, 1.5, 0};
  const Q still = {0, 0, 0, 1};
  GOOD(carom_body_set_pose(s.world, door, at.data(), still.data(), nullptr));
  w.position[0] = -6, w.position[1] = Walker::kFoot + Walker::kGap, w.position[2] = 0, w.ground = CAROM_GROUND_AIR;
  for (int i = 0; i < 120; ++i) {
    const V v = {1.5, 0, 0}, none = {0, 0, 0};
    GOOD(carom_body_set_velocity(s.world, door, v.data(), none.data(), nullptr));
    w.frame({0, 0, 0}, kDt);
  }
  assert_true(near_to(w.position[0], s.place(door)[0] + 0.1 + 0.3 + 0.01, 2e-3));
}

void overlap_at_the_start_is_left_at_a_bounded_speed(void**) {
  Stage s;
  s.ground();
  s.box({-1, -1, -5}, {0, 4, 5});
  Walker w(s, {5, 0, 0});
  w.position[0] = 0.1, w.ground = CAROM_GROUND_AIR;  // 0.2 m in
  w.desc.recover_speed = 0.6;
  double x = w.position[0];
  int frames = 0;
  while (w.position[0] < 0.31 - 1e-4 && frames < 200) {
    w.move({0, 0, 0}, kDt);
    assert_true(w.position[0] - x <= 0.6 * kDt + 1e-9);
    x = w.position[0], ++frames;
  }
  assert_true(frames >= 20 && frames < 25);  // 0.21 m at 0.01 m a frame
  // Into the ground, to the waist.
  w.position[0] = 5, w.position[1] = 0.3, w.ground = CAROM_GROUND_AIR;
  w.moves({0, 0, 0}, kDt, 200);
  assert_true(w.firm() && near_to(w.feet(), 0, 1e-3));
}

void it_crouches_under_a_beam_and_stands_up_behind(void**) {
  Stage s;
  s.ground();
  s.box({1, 1.3, -5}, {3, 4, 5});
  Walker w(s, {0, 0, 0});
  const carom_shape tall = w.shape, low = s.shape("capsule", {0.3, 0.3});
  w.moves({1.5, 0, 0}, kDt, 120);
  assert_true(w.position[0] < 1);
  uint32_t fits = 9;
  GOOD(carom_character_set_shape(s.engine, s.world, &w.desc, &w, low, &fits, nullptr));
  assert_true(fits == 1 && near_to(w.feet(), 0, 1e-4) && w.shape == low);
  w.moves({1.5, 0, 0}, kDt, 60);
  assert_true(w.position[0] > 1.5);
  const carom_character before = w;
  GOOD(carom_character_set_shape(s.engine, s.world, &w.desc, &w, tall, &fits, nullptr));
  assert_true(fits == 0);
  assert_memory_equal(&before, static_cast<carom_character*>(&w), sizeof before);
  w.moves({1.5, 0, 0}, kDt, 120);
  GOOD(carom_character_set_shape(s.engine, s.world, &w.desc, &w, tall, &fits, nullptr));
  assert_true(fits == 1 && w.shape == tall);
  w.move({0, 0, 0}, kDt);
  assert_true(w.firm() && near_to(w.feet(), 0, 1e-4));
}

void filters_and_sensors_are_obeyed(void**) {
  Stage s;
  s.ground();
  const carom_body ghost = s.box({1, -1, -5}, {1.2, 4, 5}), gate = s.box({2, -1, -5}, {2.2, 4, 5});
  GOOD(carom_body_set_filter(s.world, ghost, 2, ~0ull, 0, nullptr));
  carom_collider collider;
  uint64_t count;
  GOOD(carom_body_get_colliders(s.world, gate, &collider, 1, &count, nullptr));
  GOOD(carom_collider_set_sensor(s.world, collider, 1, nullptr));
  Walker w(s, {0, 0, 0});
  w.desc.mask = 1;
  w.moves({2, 0, 0}, kDt, 120);
  assert_true(near_to(w.position[0], 4, 1e-3));
  w.desc.mask = 3;
  w.moves({-2, 0, 0}, kDt, 120);
  assert_true(near_to(w.position[0], 1.2 + 0.3 + Walker::kGap, 1e-3));
}

void two_of_them_meet_by_their_bodies(void**) {
  Stage s;
  s.ground();
  Walker a(s, {-2, 0, 0}), b(s, {2, 0, 0});
  for (Walker* w : {&a, &b}) {
    w->desc.body = s.body(CAROM_BODY_KINEMATIC, w->shape, {w->position[0], w->position[1], w->position[2]});
  }
  for (int i = 0; i < 240; ++i) {
    s.step(kDt);
    a.move({1, 0, 0}, kDt), b.move({-1, 0, 0}, kDt);
    for (Walker* w : {&a, &b}) {
      GOOD(carom_character_push(s.world, &w->desc, w, kDt, nullptr));
      GOOD(carom_character_move_body(s.world, &w->desc, w, kDt, nullptr));
    }
  }
  // Each sees where the other's body was a step ago: apart by no less than their radii.
  assert_true(b.position[0] - a.position[0] > 0.6 && b.position[0] - a.position[0] < 0.7);
  s.step(kDt);
  assert_true(near_to(s.place(a.desc.body)[0], a.position[0], 1e-9));
}

void flyers_go_where_they_wish(void**) {
  Stage s;
  s.ground();
  s.box({3, -1, -5}, {4, 4, 5});
  Walker w(s, {0, 0, 0});
  w.desc.flags |= CAROM_CHARACTER_FLIES;
  w.moves({1, 1, 0}, kDt, 60);
  assert_true(near_to(w.position[0], 1, 1e-6) && near_to(w.feet(), 1, 1e-6) && !w.firm());
  w.moves({5, -1, 0}, kDt, 120);
  assert_true(near_to(w.position[0], 3 - 0.3 - Walker::kGap, 1e-3) && near_to(w.feet(), 0, 1e-3));
}

void any_direction_is_up(void**) {
  // On a planet of radius 5, round it, and back to where it was.
  Stage s;
  s.body(CAROM_BODY_STATIC, s.shape("sphere", {5}), {0, 0, 0});
  Walker w(s, {0, 5, 0});
  double angle = 0;
  for (int i = 0; i < 2000; ++i) {
    const V up = {std::sin(angle), std::cos(angle), 0};
    std::memcpy(w.desc.up, up.data(), sizeof w.desc.up);
    const Q turn = about_z(-angle);
    std::memcpy(w.orientation, turn.data(), sizeof w.orientation);
    w.move({3 * up[1], -3 * up[0], 0}, kDt);
    assert_true(w.firm());
    angle = std::atan2(w.position[0], w.position[1]);
    assert_true(
        near_to(std::hypot(w.position[0], w.position[1], w.position[2]), 5 + Walker::kFoot + Walker::kGap, 1e-3));
  }
}

std::string bits_of_a_walk() {
  Stage s;
  s.body(CAROM_BODY_STATIC,
         s.field(40, 40, 0.5, [](double x, double z) { return 0.4 * std::floor(2 * x) * 0.3 + 0.2 * std::floor(z); }),
         {-10, -2, -10});
  const carom_body lift = s.body(CAROM_BODY_KINEMATIC, s.shape("box", {1, 0.2, 1}), {0, 3, 0});
  for (int i = 0; i < 10; ++i)
    s.body(CAROM_BODY_DYNAMIC, s.shape("box", {0.3, 0.4, 0.3}), {i * 0.7 - 3, 5, 1.2}, {0, 0, 0, 1}, 100);
  Walker w(s, {0, 4, 0});
  std::string bits;
  for (int i = 0; i < 600; ++i) {
    const V v = {std::floor(i / 50.) * 0.1 - 0.5, (i / 100) % 2 ? -0.4 : 0.4, 0}, turn = {0, 0.3, 0};
    GOOD(carom_body_set_velocity(s.world, lift, v.data(), turn.data(), nullptr));
    w.frame({(i * 37 % 11 - 5) * 0.5, 0, (i * 17 % 13 - 6) * 0.4}, kDt, i % 90 == 0 ? 4 : 0);
    bits.append(reinterpret_cast<const char*>(w.position),
                sizeof w.position + sizeof w.orientation + sizeof w.velocity);
  }
  return bits;
}

void the_same_bits_twice(void**) { assert_true(bits_of_a_walk() == bits_of_a_walk()); }

void many_are_moved_on_threads_at_once(void**) {
  Stage s;
  s.body(CAROM_BODY_STATIC, s.field(40, 40, 0.5, [](double x, double z) { return 0.3 * std::sin(x) * std::sin(z); }),
         {-10, 0, -10});
  constexpr int kMany = 16;
  std::vector<carom_character> alone, together;
  const Walker first(s, {0, 1, 0});
  for (int i = 0; i < kMany; ++i) {
    alone.push_back(first);
    alone.back().position[0] = i - 8;
  }
  together = alone;
  const auto move = [&](carom_character& c, int i) {
    const V walk = {std::sin(i), 0, std::cos(i)};
    for (int k = 0; k < 200; ++k)
      if (carom_character_move(s.world, &first.desc, &c, walk.data(), 0, kDt, nullptr) != CAROM_OK) c.position[0] = 1e9;
  };
  for (int i = 0; i < kMany; ++i) move(alone[static_cast<std::size_t>(i)], i);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int i = t; i < kMany; i += 4) move(together[static_cast<std::size_t>(i)], i);
    });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < kMany; ++i) assert_memory_equal(&alone[i], &together[i], sizeof alone[i]);
  assert_true(near_to(alone[3].position[2], std::cos(3) * 200 * kDt, 0.5));
}

void a_copy_of_the_struct_goes_back_in_time(void**) {
  Stage s;
  s.ground();
  s.box({1, -1, -5}, {3, 0.25, 5});
  Walker w(s, {0, 0, 0});
  w.moves({1, 0, 0.3}, kDt, 40);
  const carom_character saved = w;
  w.moves({1, 0, 0.3}, kDt, 100);
  const carom_character there = w;
  static_cast<carom_character&>(w) = saved;
  w.moves({1, 0, 0.3}, kDt, 100);
  assert_memory_equal(&there, static_cast<carom_character*>(&w), sizeof there);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(pushes_are_bounded_by_the_force),
      cmocka_unit_test(friction_that_is_stronger_holds_the_crate),
      cmocka_unit_test(it_is_not_pushed_through_walls),
      cmocka_unit_test(overlap_at_the_start_is_left_at_a_bounded_speed),
      cmocka_unit_test(it_crouches_under_a_beam_and_stands_up_behind),
      cmocka_unit_test(filters_and_sensors_are_obeyed),
      cmocka_unit_test(two_of_them_meet_by_their_bodies),
      cmocka_unit_test(flyers_go_where_they_wish),
      cmocka_unit_test(any_direction_is_up),
      cmocka_unit_test(the_same_bits_twice),
      cmocka_unit_test(many_are_moved_on_threads_at_once),
      cmocka_unit_test(a_copy_of_the_struct_goes_back_in_time),
  };
  return cmocka_run_group_tests_name("kit/pushes", tests, nullptr, nullptr);
}
