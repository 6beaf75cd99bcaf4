// Scenes that were written when all else worked, and looked at only then: a spiral stair, heaps of boxes at random, a deck
// that rocks, two trains side by side, a press, a soup of triangles, other shapes that walk.
#include "stage.h"

namespace {

using namespace kit;

constexpr double kDt = 1. / 60;

struct Random {
  uint64_t state;
  double unit() {
    uint64_t z = (state += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }
  double between(double a, double b) { return a + (b - a) * unit(); }
};

/// m: how far the walker is from what is nearest; negative in overlap.
double separation(Walker& w) {
  carom_query_shapes q{};
  q.struct_size = sizeof q, q.scalar = CAROM_SCALAR_F64, q.count = 1;
  q.shapes = &w.shape, q.positions = w.position, q.orientations = w.orientation;
  carom_world_hit hit;
  carom_query_desc d;
  carom_query_desc_init(&d, sizeof d);
  d.ignore = w.desc.body;
  GOOD(carom_world_find_nearest(w.stage.world, &q, 10, &d, &hit, sizeof hit, nullptr));
  return hit.outcome == CAROM_CAST_MISS ? 10 : hit.separation;
}

void a_spiral_stair_up_and_down(void**) {
  Stage s;
  s.ground();
  s.body(CAROM_BODY_STATIC, s.shape("cylinder", {0.5, 5}), {0, 5, 0});
  const int n = 40;
  const double rise = 0.18, turn = 2 * kPi / 16;
  for (int i = 0; i < n; ++i) {  // wedge by wedge, as boxes that overlap
    const double a = i * turn;
    s.body(CAROM_BODY_STATIC, s.shape("box", {1.2, 0.09, 0.45}),
           {1.5 * std::cos(a), (i + 1) * rise - 0.09, 1.5 * std::sin(a)}, about({0, 1, 0}, -a));
  }
  for (const double rate : {30., 60., 200.}) {
    Walker w(s, {1.7 * std::cos(-0.6), 0, 1.7 * std::sin(-0.6)});
    double highest = 0;
    int air = 0;
    for (int i = 0; i < 14 * rate; ++i) {
      const double a = std::atan2(w.position[2], w.position[0]), out = std::hypot(w.position[0], w.position[2]) - 1.7;
      const double way = i < 9 * rate ? 1.6 : -1.6;
      w.move({-std::sin(a) * way - out * std::cos(a), 0, std::cos(a) * way - out * std::sin(a)}, 1 / rate);
      highest = std::fmax(highest, w.feet());
      air += !w.firm();
      assert_true(std::fabs(out) < 0.4);
      if (i == static_cast<int>(7 * rate)) assert_true(w.feet() > 15 * rise);
    }
    print_message("%g Hz: up to %.3f m, in the air %d of %d moves\n", rate, highest, air, static_cast<int>(14 * rate));
    assert_true(highest > 20 * rise && near_to(w.feet(), highest - 13 * rise, 1.5 * rise));
  }
}

void heaps_at_random_are_never_entered(void**) {
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    Random r{seed};
    Stage s;
    s.ground();
    for (int i = 0; i < 120; ++i) {
      const V axis = {r.between(-1, 1), r.between(-1, 1), r.between(-1, 1)};
      const double l = std::hypot(axis[0], axis[1], axis[2]);
      const char* name = i % 3 == 0 ? "cylinder" : "box";
      std::vector<double> size = {r.between(0.1, 0.6), r.between(0.1, 0.5)};
      if (i % 3) size.push_back(r.between(0.1, 0.6));
      s.body(CAROM_BODY_STATIC, s.shape(name, size), {r.between(-6, 6), r.between(-0.3, 0.5), r.between(-6, 6)},
             about({axis[0] / l, axis[1] / l, axis[2] / l}, r.between(0, 3)));
    }
    Walker w(s, {0, 4, 0});
    double deepest = 1, walked = 0;
    V aim = {1, 0, 0};
    int air = 0;
    for (int i = 0; i < 900; ++i) {
      if (i % 60 == 0) {
        const double a = r.between(0, 2 * kPi);
        aim = {2.5 * std::cos(a), 0, 2.5 * std::sin(a)};
      }
      const V before = {w.position[0], w.position[1], w.position[2]};
      w.move(aim, kDt, i % 200 == 150 ? 4 : 0);
      const double way = std::hypot(w.position[0] - before[0], w.position[2] - before[2]);
      walked += way;
      air += !w.firm();
      assert_true(way <= 15 * kDt && std::isfinite(w.position[1]) && w.feet() > -1e-3);
      if (i > 120) deepest = std::fmin(deepest, separation(w));
    }
    print_message("heap %d: nearest %.4f m, walked %.1f m, in the air %d of 900\n", static_cast<int>(seed), deepest,
                  walked, air);
    assert_true(deepest > 0.005 && walked > 8);
  }
}

void a_deck_that_rocks_and_turns(void**) {
  Stage s;
  const carom_body deck = s.body(CAROM_BODY_KINEMATIC, s.shape("box", {6, 0.5, 6}), {0, -0.5, 0});
  Walker w(s, {2, 0, 1});
  for (int i = 0; i < 1800; ++i) {
    const double t = i * kDt;
    const V v = {std::sin(t), 0.7 * std::cos(1.1 * t), 0.4},
            omega = {0.25 * std::cos(0.9 * t), 0.3, 0.25 * std::sin(1.3 * t)};
    GOOD(carom_body_set_velocity(s.world, deck, v.data(), omega.data(), nullptr));
    const V before = s.place(deck);
    w.frame(i % 300 < 100 ? V{0.8, 0, 0} : i % 300 < 200 ? V{-0.8, 0, 0} : V{0, 0, 0}, kDt);
    (void)before;
    assert_true(w.firm());
    const double near = separation(w);
    assert_true(near > 0.005 && near < 0.03);
  }
}

void from_train_to_train(void**) {
  Stage s;
  s.ground();
  const carom_body slow = s.body(CAROM_BODY_KINEMATIC, s.shape("box", {40, 0.5, 2}), {0, 0.5, 0});
  const carom_body fast = s.body(CAROM_BODY_KINEMATIC, s.shape("box", {40, 0.5, 2}), {0, 0.5, 4});
  const V a = {3, 0, 0}, b = {7, 0, 0}, none = {0, 0, 0};
  GOOD(carom_body_set_velocity(s.world, slow, a.data(), none.data(), nullptr));
  GOOD(carom_body_set_velocity(s.world, fast, b.data(), none.data(), nullptr));
  Walker w(s, {0, 1, 1});
  for (int i = 0; i < 30; ++i) w.frame({0, 0, 0}, kDt);
  assert_true(w.ground_body == slow && near_to(w.position[0] - s.place(slow)[0], 0, 1e-6));
  for (int i = 0; i < 90; ++i) w.frame({0, 0, 1.5}, kDt), assert_true(w.firm() && near_to(w.feet(), 1, 1e-4));
  assert_true(w.ground_body == fast);
  const double x = w.position[0] - s.place(fast)[0];
  for (int i = 0; i < 120; ++i) w.frame({0, 0, 0}, kDt);
  assert_true(near_to(w.position[0] - s.place(fast)[0], x, 1e-6));
}

void a_press_holds_it_and_lets_it_go(void**) {
  Stage s;
  s.ground();
  const carom_body press = s.body(CAROM_BODY_KINEMATIC, s.shape("box", {2, 0.5, 2}), {0, 4, 0});
  Walker w(s, {0.4, 0, 0.2});
  const V none = {0, 0, 0};
  for (int i = 0; i < 600; ++i) {  // down to 1.5 m above the ground, where 1.8 m do not fit, and up again
    const V v = {0, i < 240 ? -0.5 : i < 300 ? 0. : 0.5, 0};
    GOOD(carom_body_set_velocity(s.world, press, v.data(), none.data(), nullptr));
    w.frame({0, 0, 0}, kDt);
    assert_true(w.feet() > -0.35 && w.feet() < 0.5 && std::fabs(w.position[0]) < 4 && std::isfinite(w.position[2]));
  }
  assert_true(w.firm() && near_to(w.feet(), 0, 1e-3));
}

void a_soup_of_triangles(void**) {
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    Random r{seed * 77};
    Stage s;
    s.ground();
    std::vector<double> v;
    std::vector<uint32_t> t;
    for (uint32_t i = 0; i < 300; ++i) {
      const V at = {r.between(-5, 5), r.between(-0.5, 1.5), r.between(-5, 5)};
      for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j) v.push_back(at[static_cast<std::size_t>(j)] + r.between(-0.6, 0.6));
      t.insert(t.end(), {3 * i, 3 * i + 1, 3 * i + 2});
    }
    s.body(CAROM_BODY_STATIC, s.mesh(v, t), {0, 0, 0});
    Walker w(s, {0, 5, 0});
    V aim = {1, 0, 0};
    for (int i = 0; i < 600; ++i) {
      if (i % 45 == 0) {
        const double a = r.between(0, 2 * kPi);
        aim = {2.5 * std::cos(a), 0, 2.5 * std::sin(a)};
      }
      const V before = {w.position[0], w.position[1], w.position[2]};
      w.move(aim, kDt);
      assert_true(std::isfinite(w.position[1]) && w.feet() > -1e-2);
      assert_true(std::hypot(w.position[0] - before[0], w.position[2] - before[2]) < 0.5);
    }
  }
}

void other_shapes_walk_too(void**) {
  for (const int kind : {0, 1, 2}) {
    Stage s;
    s.ground();
    for (int i = 0; i < 6; ++i) s.box({2 + 0.5 * i, -1, -5}, {2.5 + 0.5 * i, 0.2 * (i + 1), 5});
    s.box({5, -1, -5}, {30, 1.2, 5});
    const carom_shape shape = kind == 0   ? s.shape("box", {0.3, 0.9, 0.2})
                              : kind == 1 ? s.shape("cylinder", {0.3, 0.9})
                                          : s.shape("sphere", {0.9});
    Walker w(s, {0, 0, 0}, shape);
    w.moves({2, 0, 0.4}, kDt, 240);
    assert_true(near_to(w.position[0], 8, 1e-2) && near_to(w.feet(), 1.2, 1e-3) && w.firm());
    w.moves({-2, 0, -0.4}, kDt, 240);
    assert_true(near_to(w.position[0], 0, 2e-2) && near_to(w.feet(), 0, 1e-3) && w.firm());
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_spiral_stair_up_and_down),      cmocka_unit_test(heaps_at_random_are_never_entered),
      cmocka_unit_test(a_deck_that_rocks_and_turns),     cmocka_unit_test(from_train_to_train),
      cmocka_unit_test(a_press_holds_it_and_lets_it_go), cmocka_unit_test(a_soup_of_triangles),
      cmocka_unit_test(other_shapes_walk_too),
  };
  return cmocka_run_group_tests_name("kit/scenes", tests, nullptr, nullptr);
}
