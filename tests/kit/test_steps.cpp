// Steps: how high they may be, stairs at any frame rate, ledges, curbs that are round or thin, ceilings over them.
#include "stage.h"

namespace {

using namespace kit;

/// Heights come from casts of relative tolerance 1e-7; a step may be 1e-5 m higher than step_up.
constexpr double kBound = 1e-4;

void just_below_the_limit_passes_and_just_above_stops(void**) {
  // A round end rolls over edges up to its radius times 1 - cos max_slope, 0.11 m here: of low steps a flat one is asked.
  for (const double limit : {0.02, 0.1, 0.3, 0.55})
    for (const double rate : {30., 60., 240.})
      for (const bool above : {false, true}) {
        const double height = limit + (above ? 1e-4 : -1e-4);
        Stage s;
        s.ground();
        s.box({0, -1, -5}, {5, height, 5});
        Walker w(s, {-1, 0, 0}, limit < 0.2 ? s.shape("cylinder", {0.3, 0.9}) : CAROM_NULL_HANDLE);
        w.desc.step_up = limit;
        w.moves({1.5, 0, 0}, 1 / rate, static_cast<int>(2 * rate));
        if (above) {
          assert_true(near_to(w.feet(), 0, kBound) && w.position[0] < 0);
        } else {
          assert_true(near_to(w.feet(), height, kBound) && w.firm());
          assert_true(near_to(w.position[0], 2, 1e-3));  // it has not lost way
        }
      }
}

double stairs(Stage& s, double rise, double tread, int n) {
  for (int i = 0; i < n; ++i) s.box({i * tread, -1, -5}, {(i + 1) * tread, (i + 1) * rise, 5});
  s.box({n * tread, -1, -5}, {n * tread + 20, n * rise, 5});
  return n * tread;
}

void stairs_up_and_down_take_no_time_at_any_rate(void**) {
  for (const double rise : {0.15, 0.25})
    for (const double rate : {20., 30., 60., 144., 240.}) {
      Stage s;
      s.ground();
      const double end = stairs(s, rise, 0.3, 12);
      Walker w(s, {-1.5, 0, 0});
      const int frames = static_cast<int>(3.5 * rate);
      double lowest = 1e9;
      for (int i = 0; i < frames; ++i) {
        w.move({2, 0, 0}, 1 / rate);
        assert_true(w.firm());
      }
      assert_true(near_to(w.position[0], 5.5, 1e-3) && w.position[0] > end);
      assert_true(near_to(w.feet(), 12 * rise, kBound));
      for (int i = 0; i < frames; ++i) {
        w.move({-2, 0, 0}, 1 / rate);
        assert_true(w.firm());
        lowest = std::fmin(lowest, w.feet());
      }
      assert_true(near_to(w.position[0], -1.5, 1e-3) && near_to(w.feet(), 0, kBound) && lowest > -kBound);
    }
}

void stairs_askew_and_of_meshes(void**) {
  Stage s;
  // Of triangles: treads and risers as one surface.
  std::vector<double> v;
  std::vector<uint32_t> t;
  const int n = 8;
  const auto strip = [&](double x0, double y0, double x1, double y1) {
    const auto a = static_cast<uint32_t>(v.size() / 3);
    v.insert(v.end(), {x0, y0, -5, x1, y1, -5, x0, y0, 5, x1, y1, 5});
    t.insert(t.end(), {a, a + 2, a + 1, a + 1, a + 2, a + 3});
  };
  strip(-10, 0, 0, 0);
  for (int i = 0; i < n; ++i)
    strip(0.35 * i, 0.2 * i, 0.35 * i, 0.2 * (i + 1)), strip(0.35 * i, 0.2 * (i + 1), 0.35 * (i + 1), 0.2 * (i + 1));
  strip(0.35 * n, 0.2 * n, 30, 0.2 * n);
  s.body(CAROM_BODY_STATIC, s.mesh(v, t), {0, 0, 0});
  for (const double slant : {0., 0.5, 1.1}) {
    Walker w(s, {-2, 0, 0});
    const V walk = {2 * std::cos(slant), 0, 2 * std::sin(slant)};
    const int frames = static_cast<int>(5.5 / walk[0] * 60);
    int lost = 0;
    for (int i = 0; i < frames && w.position[2] < 4.5; ++i) w.move(walk, 1. / 60), lost += !w.firm();
    assert_true(lost == 0);
    if (slant < 1)
      assert_true(near_to(w.feet(), 0.2 * n, kBound) && near_to(w.position[0], -2 + frames / 60. * walk[0], 1e-3));
  }
}

void a_high_wall_is_not_climbed_bit_by_bit(void**) {
  Stage s;
  s.ground();
  s.box({0, -1, -5}, {5, 0.5, 5});
  Walker w(s, {-1, 0, 0});
  for (int i = 0; i < 1200; ++i) {
    w.move({1 + (i % 7) * 0.3, 0, 0.3 * ((i % 5) - 2)}, 1. / (30 + 30 * (i % 4)));
    assert_true(near_to(w.feet(), 0, kBound) && w.position[0] < -Walker::kRadius);
  }
}

void curbs_that_are_round_or_thin(void**) {
  for (const int kind : {0, 1}) {
    Stage s;
    s.ground();
    if (kind == 0)  // half a pipe out of the ground
      s.body(CAROM_BODY_STATIC, s.shape("capsule", {0.2, 5}), {0, 0, 0}, about({1, 0, 0}, kPi / 2));
    else  // a plank on edge
      s.box({-0.01, -1, -5}, {0.01, 0.25, 5});
    for (const double rate : {30., 120.}) {
      Walker w(s, {-1, 0, 0});
      w.moves({1.5, 0, 0}, 1 / rate, static_cast<int>(2 * rate));
      assert_true(near_to(w.position[0], 2, 5e-3) && near_to(w.feet(), 0, kBound) && w.firm());
    }
  }
}

void no_step_under_a_low_ceiling(void**) {
  Stage s;
  s.ground();
  s.box({0, -1, -5}, {5, 0.25, 5});
  s.box({-5, 1.95, -5}, {5, 3, 5});  // 1.7 m above the step, and it is 1.8 m tall
  Walker w(s, {-1, 0, 0});
  w.moves({1.5, 0, 0}, 1. / 60, 120);
  assert_true(w.position[0] < 0 && near_to(w.feet(), 0, kBound));
}

void down_a_ledge_that_is_higher_than_step_down_it_falls(void**) {
  // A round end rolls off the edge first: 0.11 m.
  for (const double height : {0.29, 0.45}) {
    Stage s;
    s.ground();
    s.box({-5, -1, -5}, {0, height, 5});
    Walker w(s, {-1, height, 0});
    int in_air = 0;
    for (int i = 0; i < 120; ++i) w.move({1.5, 0, 0}, 1. / 60), in_air += !w.firm();
    assert_true(height < 0.3 ? in_air == 0 : in_air > 0);
    assert_true(near_to(w.feet(), 0, kBound) && near_to(w.position[0], 2, 1e-3));
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(just_below_the_limit_passes_and_just_above_stops),
      cmocka_unit_test(stairs_up_and_down_take_no_time_at_any_rate),
      cmocka_unit_test(stairs_askew_and_of_meshes),
      cmocka_unit_test(a_high_wall_is_not_climbed_bit_by_bit),
      cmocka_unit_test(curbs_that_are_round_or_thin),
      cmocka_unit_test(no_step_under_a_low_ceiling),
      cmocka_unit_test(down_a_ledge_that_is_higher_than_step_down_it_falls),
  };
  return cmocka_run_group_tests_name("kit/steps", tests, nullptr, nullptr);
}
