// Walls: corners acute and obtuse, gaps, ceilings, posts; and that nothing lets it through.
#include "stage.h"

namespace {

using namespace kit;

constexpr double kBound = 1e-4;

/// Walls on both sides of the x axis that meet at the origin, `angle` between them; open towards -x.
void corner(Stage& s, double angle) {
  for (const double side : {-1., 1.}) {
    const Q turn = about({0, 1, 0}, side * angle / 2);
    const double c = std::cos(angle / 2), n = std::sin(angle / 2);
    // Half of 10 m along the wall, from the corner outwards, 0.5 m thick.
    s.body(CAROM_BODY_STATIC, s.shape("box", {6, 5, 0.5}), {-5 * c + 0.5 * n, 0, side * (5 * n + 0.5 * c)}, turn);
  }
}

void corners_hold_it_still(void**) {
  for (const double degrees : {20., 45., 90., 135., 170.})
    for (const double off : {0., 0.3, -0.9}) {
      Stage s;
      s.ground();
      corner(s, degrees * kPi / 180);
      Walker w(s, {-3, 0, 0});
      const V walk = {2.5, 0, 2.5 * off};
      w.moves(walk, 1. / 60, 1800);
      double trembles = 0;
      const double x = w.position[0], z = w.position[2];
      const bool slides_out = degrees / 2 > 90 - std::atan(std::fabs(off)) * 180 / kPi;  // the way out is along a wall
      for (int i = 0; i < 120 && !slides_out; ++i) {
        w.move(walk, 1. / 60);
        trembles = std::fmax(trembles, std::hypot(w.position[0] - x, w.position[2] - z));
      }
      if (!near_to(trembles, 0, 1e-6)) print_error("corner of %g degrees, off by %g\n", degrees, off);
      assert_true(near_to(trembles, 0, 1e-6));
      // As deep in as its radius and the gap allow.
      if (off == 0 && degrees < 180)
        assert_true(near_to(x, -(Walker::kRadius + 0.01) / std::sin(degrees * kPi / 360),
                            0.025 * 0.01 / std::sin(degrees * kPi / 360)));
    }
}

void along_a_wall_it_slides_at_the_speed_that_is_left(void**) {
  Stage s;
  s.ground();
  s.box({-50, -1, 1}, {50, 5, 2});
  for (const double rate : {30., 240.}) {
    Walker w(s, {-20, 0, 1 - Walker::kRadius - Walker::kGap});
    w.moves({2, 0, 3}, 1 / rate, static_cast<int>(5 * rate));
    assert_true(near_to(w.position[0], -10, 1e-3) && near_to(w.position[2], 1 - Walker::kRadius - Walker::kGap, 1e-5));
    assert_true(near_to(w.velocity[0], 2, 1e-9) && near_to(w.velocity[2], 0, 1e-9));
  }
}

void a_gap_is_entered_if_it_is_wide_enough(void**) {
  for (const double off : {-1e-3, 1e-3}) {
    Stage s;
    s.ground();
    const double half = Walker::kRadius + Walker::kGap + off;
    s.box({0, -1, half}, {2, 5, 5});
    s.box({0, -1, -5}, {2, 5, -half});
    Walker w(s, {-1, 0, 0});
    w.moves({1.5, 0, 0}, 1. / 60, 240);
    assert_true(off > 0 ? near_to(w.position[0], 5, 1e-2) : w.position[0] < 0);
    assert_true(near_to(w.feet(), 0, kBound));
  }
}

void ramps_under_a_ceiling_end_where_it_touches(void**) {
  Stage s;
  s.ground();
  const double slope = 0.4;
  s.body(CAROM_BODY_STATIC, s.shape("box", {10, 1, 5}),
         {10 * std::cos(slope) + std::sin(slope), 10 * std::sin(slope) - std::cos(slope), 0}, about_z(slope));
  s.box({-20, 3, -5}, {20, 4, 5});
  Walker w(s, {-1, 0, 0});
  w.moves({2, 0, 0}, 1. / 60, 300);
  const double x = w.position[0], y = w.position[1];
  // The top of it is a gap below the ceiling.
  assert_true(near_to(y + 0.9, 3 - 0.01, 1e-3) && w.firm());
  w.moves({2, 0, 0}, 1. / 60, 120);
  assert_true(near_to(w.position[0], x, 1e-6) && near_to(w.position[1], y, 1e-6));
  w.moves({2, 0, 1}, 1. / 60, 60);  // along it, sideways
  assert_true(near_to(w.position[2], 1, 1e-2));
  w.moves({-2, 0, 0}, 1. / 60, 60);
  assert_true(near_to(w.position[0], x - 2, 1e-2));
}

void nothing_lets_it_through_at_any_speed(void**) {
  Stage s;
  s.ground();
  s.box({3, -1, -50}, {3.001, 9, 50});
  std::vector<double> v = {-3, -1, -50, -3, -1, 50, -3, 9, -50, -3, 9, 50};
  s.body(CAROM_BODY_STATIC, s.mesh(v, {0, 2, 1, 1, 2, 3}), {0, 0, 0});
  for (const double speed : {1., 30., 1e3, 1e6})
    for (const double dt : {1. / 240, 1. / 60, 1.}) {
      Walker w(s, {0, 0, 0});
      for (int i = 0; i < 20; ++i) w.move({speed, 0, 0.1}, dt);
      if (speed * dt * 20 > 3) assert_true(near_to(w.position[0], 3 - Walker::kRadius - Walker::kGap, 1e-3));
      for (int i = 0; i < 20; ++i) w.move({-speed, 0, -0.1}, dt);
      if (speed * dt * 20 > 6) assert_true(near_to(w.position[0], -3 + Walker::kRadius + Walker::kGap, 1e-3));
    }
}

void posts_are_walked_round(void**) {
  Stage s;
  s.ground();
  for (int i = 0; i < 8; ++i) s.body(CAROM_BODY_STATIC, s.shape("cylinder", {0.4, 2}), {2. * i, 1, 0.05 * (i % 3)});
  Walker w(s, {-2, 0, 0.1});
  w.moves({2, 0, 0}, 1. / 60, 900);
  assert_true(w.position[0] > 14 && near_to(w.feet(), 0, kBound));
}

void jumps_follow_the_parabola_and_ceilings_end_them(void**) {
  for (const double rate : {30., 60., 240.}) {
    Stage s;
    s.ground();
    Walker w(s, {0, 0, 0});
    w.move({2, 0, 0}, 1 / rate);
    w.move({2, 0, 0}, 1 / rate, 4);
    const int frames = static_cast<int>(0.4 * rate);
    for (int i = 1; i < frames; ++i) w.move({2, 0, 0}, 1 / rate, 4);  // in the air a jump does nothing
    const double t = frames / rate;
    assert_true(near_to(w.feet(), 4 * t - 9.81 / 2 * t * t, 1e-6) && near_to(w.position[0], 2 * (t + 1 / rate), 1e-6));
    w.moves({2, 0, 0}, 1 / rate, static_cast<int>(rate));
    assert_true(w.firm() && near_to(w.feet(), 0, kBound) &&
                near_to(w.position[0], 2 * (static_cast<int>(rate) / rate + t + 1 / rate), 1e-3));
    s.box({-50, 2.2, -5}, {50, 3, 5});
    w.move({0, 0, 0}, 1 / rate, 6);
    double highest = 0;
    int air = 0;
    for (int i = 0; i < static_cast<int>(rate); ++i)
      w.move({0, 0, 0}, 1 / rate), highest = std::fmax(highest, w.position[1]), air += !w.firm();
    assert_true(near_to(highest, 2.2 - 0.9 - 0.01, 1e-3));
    assert_true(air / rate < 0.45);  // it falls at once: 0.4 m take 0.29 s
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(corners_hold_it_still),
      cmocka_unit_test(along_a_wall_it_slides_at_the_speed_that_is_left),
      cmocka_unit_test(a_gap_is_entered_if_it_is_wide_enough),
      cmocka_unit_test(ramps_under_a_ceiling_end_where_it_touches),
      cmocka_unit_test(nothing_lets_it_through_at_any_speed),
      cmocka_unit_test(posts_are_walked_round),
      cmocka_unit_test(jumps_follow_the_parabola_and_ceilings_end_them),
  };
  return cmocka_run_group_tests_name("kit/walls", tests, nullptr, nullptr);
}
