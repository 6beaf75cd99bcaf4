// Filters, bodies that are ignored: which touch, from the next step on, under every broad phase; and that nobody pays
// who sets none.
#include "carom_test.h"
#include "dynamics/contact_views.h"
#include "dynamics/filter.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

/// Balls that overlap a static slab, at rest in space.
struct Row : TestWorld {
  explicit Row(int count) : TestWorld(Vec3::zero()) {
    slab = add(keep(box(Vec3(50, 1, 5))), Vec3(0, -1.4, 0), BodyType::fixed);
    const Shape* ball = keep(sphere(0.5));
    for (int i = 0; i < count; ++i) balls.push_back(add(ball, Vec3(2 * i, 0, 0)));
  }
  std::uint32_t collider(std::uint32_t body) const { return world.scene.first_collider[body]; }
  /// Whether a body was in a contact of the last step.
  bool touches(std::uint32_t body) const {
    for (const ContactView& v : world.contact_views())
      if (world.scene.colliders.body[v.collider_a] == body || world.scene.colliders.body[v.collider_b] == body)
        return true;
    return false;
  }
  std::uint32_t slab;
  std::vector<std::uint32_t> balls;
};

}  // namespace

static void two_touch_as_their_filters_say(void**) {
  const std::uint64_t all = ~std::uint64_t(0);
  const struct {
    Filter slab, ball;
    bool touch;
  } cases[] = {
      {{1, all, 0}, {1, all, 0}, true},     // the defaults
      {{1, all, 0}, {2, all, 0}, true},     // categories alone say nothing
      {{1, all, 0}, {2, 2, 0}, false},      // the ball's mask has no 1
      {{1, 1, 0}, {2, all, 0}, false},      // the slab's has no 2
      {{4, 2, 0}, {2, 4, 0}, true},         // each has the other's
      {{1, all, 0}, {0, all, 0}, false},    // of no category
      {{1, 0, 3}, {2, 0, 3}, true},         // one group, positive: always
      {{1, all, -3}, {1, all, -3}, false},  // negative: never
      {{1, all, -3}, {1, all, -4}, true},   // two groups say nothing
      {{1, all, 3}, {1, 2, 0}, false},     {{1ull << 63, 1ull << 62, 0}, {1ull << 62, 1ull << 63, 0}, true},
  };
  for (const auto& c : cases)
    for (int broad = 0; broad < 4; ++broad) {
      Row row(1);
      row.world.set_dial(Dial::broad_phase, broad);
      row.world.set_filter(row.collider(row.slab), c.slab);
      row.world.set_filter(row.collider(row.balls[0]), c.ball);
      row.run(2, 1.0 / 60);
      assert_true(row.touches(row.balls[0]) == c.touch);
      assert_true(lets_touch(row.world.scene, row.collider(row.slab), row.collider(row.balls[0])) == c.touch);
    }
}

static void a_change_holds_from_the_next_step_on(void**) {
  for (int broad = 0; broad < 4; ++broad) {
    Row row(3);
    row.world.set_dial(Dial::broad_phase, broad);
    row.run(1, 1.0 / 60);
    for (const std::uint32_t ball : row.balls) assert_true(row.touches(ball));
    row.world.set_filter(row.collider(row.balls[1]), {2, 2, 0});  // in touch, and no more
    row.run(1, 1.0 / 60);
    assert_true(row.touches(row.balls[0]) && !row.touches(row.balls[1]) && row.touches(row.balls[2]));
    row.world.set_filter(row.collider(row.balls[1]), Filter());
    row.world.ignore_collision(row.balls[2], row.slab);
    row.run(1, 1.0 / 60);
    assert_true(row.touches(row.balls[1]) && !row.touches(row.balls[2]));
    row.world.ignore_collision(row.slab, row.balls[2]);
    row.world.restore_collision(row.balls[2], row.slab);  // once of twice
    row.run(1, 1.0 / 60);
    assert_false(row.touches(row.balls[2]));
    row.world.restore_collision(row.balls[2], row.slab);
    row.world.restore_collision(row.balls[2], row.slab);  // of nothing
    row.run(1, 1.0 / 60);
    assert_true(row.touches(row.balls[2]));
    assert_true(row.world.scene.apart.empty());
  }
}

static void what_takes_a_slot_takes_no_filter(void**) {
  Row row(2);
  row.world.set_filter(row.collider(row.balls[1]), {2, 2, 0});
  row.world.ignore_collision(row.balls[1], row.slab);
  row.world.remove_body(row.balls[1]);
  assert_true(row.world.scene.apart.empty());
  const std::uint32_t other = row.add(row.keep(sphere(0.5)), Vec3(2, 0, 0));
  assert_int_equal(other, row.balls[1]);
  row.run(1, 1.0 / 60);
  assert_true(row.touches(other));
}

static void sleepers_wake_where_a_filter_lets_them_fall(void**) {
  TestWorld t;
  t.world.set_dial(Dial::sleep, 1);
  const std::uint32_t ground = t.ground();
  const std::uint32_t ball = t.add(t.keep(sphere(0.5)), Vec3(0, 0.5, 0));
  t.run(120, 1.0 / 60);
  assert_true(t.world.asleep(ball));
  t.world.ignore_collision(ground, ball);
  t.run(60, 1.0 / 60);
  assert_true(!t.world.asleep(ball) && t.world.state.x[ball].y() < -3);  // g/2 for a second

  // A mover does not wake whom it may not touch.
  TestWorld u;
  u.world.set_dial(Dial::sleep, 1);
  u.ground();
  const std::uint32_t rests = u.add(u.keep(sphere(0.5)), Vec3(0, 0.5, 0));
  u.run(120, 1.0 / 60);
  const std::uint32_t comes = u.add(u.keep(sphere(0.5)), Vec3(0, 3, 0));
  u.world.set_filter(u.world.scene.first_collider[comes], {2, 1, 0});
  u.world.set_filter(u.world.scene.first_collider[rests], {4, 1, 0});
  u.run(240, 1.0 / 60);
  assert_true(u.world.asleep(rests) && std::fabs(u.world.state.x[comes].y() - 0.5) < 0.01);
}

static void a_world_without_filters_goes_the_same_way(void**) {
  // To the bit, also where a filter came and went, and no participant is left of it.
  const auto run = [](bool once) {
    Row row(3);
    row.world.set_gravity(Vec3(0.5, -9.81, 0));
    if (once) {
      row.world.set_filter(row.collider(row.balls[0]), {2, 2, 0});
      row.world.set_filter(row.collider(row.balls[0]), Filter());
    }
    row.run(60, 1.0 / 60);
    assert_int_equal(row.world.plan->effects[+EffectId::filter].participants.count, 0);
    assert_false(any_held_apart(row.world));
    return row.world.hash();
  };
  assert_true(run(false) == run(true));
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(two_touch_as_their_filters_say),
      cmocka_unit_test(a_change_holds_from_the_next_step_on),
      cmocka_unit_test(what_takes_a_slot_takes_no_filter),
      cmocka_unit_test(sleepers_wake_where_a_filter_lets_them_fall),
      cmocka_unit_test(a_world_without_filters_goes_the_same_way),
  };
  return cmocka_run_group_tests_name("unit/dynamics/filter", tests, nullptr, nullptr);
}
