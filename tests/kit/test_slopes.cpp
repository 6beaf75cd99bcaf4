// Ground: what is firm and what is steep, seams of flush boxes, of meshes and of height fields, hills and valleys.
#include "stage.h"

namespace {

using namespace kit;

/// Speed over ground and height above it, frame by frame. Both may err by what the oracle of the issue allows, 0.1 mm.
constexpr double kBound = 1e-4;

void walks_as_wished(Walker& w, const V& walk, double dt, int frames, double height) {
  double worst = 0, lag = 0;
  for (int i = 0; i < frames; ++i) {
    const V before = {w.position[0], w.position[1], w.position[2]};
    w.move(walk, dt);
    worst = std::fmax(worst, std::fabs(w.feet() - height));
    lag =
        std::fmax(lag, std::hypot(w.position[0] - before[0] - walk[0] * dt, w.position[2] - before[2] - walk[2] * dt));
    assert_true(w.firm());
  }
  print_message("height within %.2g m, way within %.2g m a frame\n", worst, lag);
  assert_true(near_to(worst, 0, kBound));
  assert_true(near_to(lag, 0, kBound * dt));
}

void firm_up_to_the_limit_and_not_beyond(void**) {
  for (const double degrees : {10., 30., 45., 60.})
    for (const double off : {-0.1, 0.1}) {
      Stage s;
      s.ground();
      // A slope that begins at x = 0.
      s.body(CAROM_BODY_STATIC, s.shape("box", {20, 1, 20}),
             {20 * std::cos((degrees + off) * kPi / 180) + std::sin((degrees + off) * kPi / 180),
              20 * std::sin((degrees + off) * kPi / 180) - std::cos((degrees + off) * kPi / 180), 0},
             about_z((degrees + off) * kPi / 180));
      Walker w(s, {-1, 0, 0});
      w.desc.max_slope = degrees * kPi / 180;
      w.moves({2, 0, 0}, 1. / 60, 180);
      if (off < 0) {  // horizontally as on flat ground, but for the first metre
        assert_true(near_to(w.position[0], 5, 0.05));
        assert_true(w.firm() && w.feet() > 3 * std::sin((degrees + off) * kPi / 180));
        w.move({0, 0, 0}, 1. / 60);
        const double x = w.position[0], y = w.position[1];
        w.moves({0, 0, 0}, 1. / 60, 600);
        assert_true(w.position[0] == x && w.position[1] == y);  // it does not creep, by a bit
      } else {
        assert_true(w.position[0] < 0.05 && near_to(w.feet(), 0, kBound));
        // Put on it, it slides down, and cannot walk up.
        w.position[0] = 3, w.position[1] += 3 * std::tan((degrees + off) * kPi / 180) + 1, w.ground = CAROM_GROUND_AIR;
        double highest = 1e9;
        int steep = 0;
        for (int i = 0; i < 300; ++i) {
          w.move({steep ? 2. : 0, 0, 0}, 1. / 60);
          steep += w.ground == CAROM_GROUND_STEEP;
          assert_true(w.feet() <= highest + 1e-6);
          highest = w.feet();
        }
        assert_true(steep > 10);
      }
    }
}

void seams_of_flush_boxes_are_not_felt(void**) {
  for (const double dt : {1. / 30, 1. / 60, 1. / 240}) {
    Stage s;
    for (int i = -2; i < 12; ++i)
      for (int k = -2; k < 12; ++k) s.box({1. * i, -1, 1. * k}, {i + 1., 0, k + 1.});
    Walker w(s, {0.3, 0, 0.2});
    w.move({0, 0, 0}, dt);
    walks_as_wished(w, {3, 0, 2.5}, dt, static_cast<int>(3 / dt), 0);
    walks_as_wished(w, {-3, 0, 0}, dt, static_cast<int>(2 / dt), 0);
  }
}

void seams_of_meshes_and_fields_are_not_felt(void**) {
  for (const bool tilted : {false, true}) {
    const double slope = tilted ? 0.5 : 0;
    Stage s;
    std::vector<double> v;
    std::vector<uint32_t> t;
    const uint32_t n = 14;
    for (uint32_t i = 0; i <= n; ++i)
      for (uint32_t k = 0; k <= n; ++k) v.insert(v.end(), {i - 2., slope * (i - 2.), k - 2.});
    for (uint32_t i = 0; i < n; ++i)
      for (uint32_t k = 0; k < n; ++k) {
        const uint32_t a = i * (n + 1) + k, b = a + 1, c = a + n + 1, d = c + 1;
        if ((i + k) % 2)
          t.insert(t.end(), {a, b, c, b, d, c});
        else
          t.insert(t.end(), {a, b, d, a, d, c});
      }
    s.body(CAROM_BODY_STATIC, s.mesh(v, t), {0, 0, 0});
    s.body(CAROM_BODY_STATIC, s.field(15, 15, 1, [&](double x, double) { return slope * (x - 2); }), {-2, 0, 98});
    for (const double z : {0., 100.}) {
      Walker w(s, {0.3, slope * 0.3 + 0.2, z + 0.2});
      w.moves({0, 0, 0}, 1. / 60, 60);
      assert_true(w.firm());
      const double above = w.feet() - slope * w.position[0];
      double worst = 0, lag = 0;
      for (int i = 0; i < 180; ++i) {
        const double x = w.position[0], y = w.position[2];
        w.move({2.5, 0, 2}, 1. / 60);
        assert_true(w.firm());
        worst = std::fmax(worst, std::fabs(w.feet() - slope * w.position[0] - above));
        lag = std::fmax(lag, std::hypot(w.position[0] - x - 2.5 / 60, w.position[2] - y - 2. / 60));
      }
      print_message("slope %g: height within %.2g m, way within %.2g m a frame\n", slope, worst, lag);
      assert_true(near_to(worst, 0, kBound) && near_to(lag, 0, kBound / 60));
    }
  }
}

/// Tiles as builders lay them: off by up to 5 cm, each a step or an edge to roll over.
void tiles_that_are_not_quite_flush(void**) {
  for (const int kind : {0, 1, 2})
    for (const double off : {1e-3, 3e-3, 1e-2, 5e-2}) {
      Stage s;
      uint64_t state = 5;
      for (int i = 0; i < 20; ++i)
        for (int k = 0; k < 20; ++k) {
          state = state * 6364136223846793005ull + 1442695040888963407ull;
          const double top = off * static_cast<double>(state >> 40) / 16777216;
          s.box({i * 0.7 - 1, -1, k * 0.7 - 5}, {i * 0.7 - 0.3, top, k * 0.7 - 4.3});
        }
      Walker w(s, {0, 0.1, 0},
               kind == 0   ? CAROM_NULL_HANDLE
               : kind == 1 ? s.shape("cylinder", {0.3, 0.9})
                           : s.shape("box", {0.3, 0.9, 0.2}));
      w.moves({0, 0, 0}, 1. / 60, 60);
      const double x = w.position[0], z = w.position[2];
      for (int i = 0; i < 240; ++i) {
        w.move({2, 0, 0.5}, 1. / 60);
        assert_true(w.firm() && w.feet() > -1e-6 && w.feet() < off + 1e-4);
      }
      assert_true(near_to(w.position[0] - x, 8, 1e-4) && near_to(w.position[2] - z, 2, 1e-4));
    }
}

void hills_are_walked_at_a_steady_speed_and_never_left(void**) {
  Stage s;
  s.body(CAROM_BODY_STATIC,
         s.field(80, 80, 0.5, [](double x, double z) { return 0.6 * std::sin(0.9 * x) * std::cos(0.7 * z); }),
         {0, 0, 0});
  for (const double dt : {1. / 30, 1. / 120}) {
    Walker w(s, {3, 2, 3});
    w.moves({0, 0, 0}, dt, static_cast<int>(2 / dt));
    assert_true(w.firm());
    const double x = w.position[0], z = w.position[2];
    for (int i = 0; i < static_cast<int>(6 / dt); ++i) {
      w.move({4, 0, 3}, dt);
      assert_true(w.firm());
    }
    // Horizontal speed is what is wished, uphill and down.
    assert_true(near_to(w.position[0] - x, 24, 1e-3) && near_to(w.position[2] - z, 18, 1e-3));
  }
}

void between_two_steep_slopes_it_stands(void**) {
  Stage s;
  for (const double side : {-1., 1.})
    s.body(CAROM_BODY_STATIC, s.shape("box", {5, 1, 20}),
           {side * (5 * std::cos(1.1) + std::sin(1.1)), 5 * std::sin(1.1) - std::cos(1.1), 0}, about_z(side * 1.1));
  Walker w(s, {0.3, 3, 0});
  w.moves({0, 0, 0}, 1. / 60, 240);
  assert_true(w.firm());
  const double y = w.position[1];
  w.moves({0, 0, 0}, 1. / 60, 60);
  assert_true(w.firm() && near_to(w.position[1], y, 1e-6));
  w.moves({0, 0, 2}, 1. / 60, 60);  // along the valley
  assert_true(near_to(w.position[2], 2, 0.05));
  w.move({0, 0, 0}, 1. / 60, 5);
  assert_true(w.ground == CAROM_GROUND_AIR && w.position[1] > y + 0.05);
}

void it_falls_off_a_cliff(void**) {
  Stage s;
  s.box({-5, -1, -5}, {0, 0, 5});
  s.box({-5, -11, -5}, {50, -10, 5});
  for (const double dt : {1. / 30, 1. / 120}) {
    Walker w(s, {-1, 0, 0});
    w.move({0, 0, 0}, dt);
    double left_at = 0;
    int i = 0;
    for (; i < 1000 && w.position[1] > -5; ++i) {
      w.move({3, 0, 0}, dt);
      if (w.ground == CAROM_GROUND_AIR && left_at == 0) left_at = w.position[0];
    }
    // Its round end holds on the edge up to the slope that is firm, and not a frame longer.
    const double holds = (Walker::kRadius + Walker::kGap) * std::sin(w.desc.max_slope);
    assert_true(left_at > holds && left_at < holds + 3 * dt + 1e-3);
    while (!w.firm()) w.move({3, 0, 0}, dt);
    assert_true(near_to(w.feet(), -10, kBound));
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(firm_up_to_the_limit_and_not_beyond),
      cmocka_unit_test(seams_of_flush_boxes_are_not_felt),
      cmocka_unit_test(seams_of_meshes_and_fields_are_not_felt),
      cmocka_unit_test(tiles_that_are_not_quite_flush),
      cmocka_unit_test(hills_are_walked_at_a_steady_speed_and_never_left),
      cmocka_unit_test(between_two_steep_slopes_it_stands),
      cmocka_unit_test(it_falls_off_a_cliff),
  };
  return cmocka_run_group_tests_name("kit/slopes", tests, nullptr, nullptr);
}
