// Waking is exact: to who slept, no time has passed; and a world in which nobody has slept yet is that without sleep.
#include <vector>

#include "carom_test.h"
#include "dynamics/sleep/sleep.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kStep = 1.0 / 60;

struct Setting {
  Real solver, manifold, broad, routines;
};
constexpr Setting kSettings[] = {{kSeverityChoice, 3, 1, 1},
                                 {kSeverityChoice, 1, 0, 0},
                                 {kSoftChoice, 2, 2, 0},
                                 {kSoftChoice, 3, 3, 1},
                                 {kSoftChoice, 1, 1, 0}};

/// A small heap of unlike shapes that leans and settles, on the ground.
void build_heap(TestWorld& t, const Setting& s) {
  t.world.set_dial(Dial::solver, s.solver);
  t.world.set_dial(Dial::manifold, s.manifold);
  t.world.set_dial(Dial::broad_phase, s.broad);
  t.world.set_dial(Dial::pair_routines, s.routines);
  if (s.solver > 0) t.world.set_dial(Dial::substeps, 4);
  t.ground();
  const Shape* cube = t.keep(box(Vec3(0.5, 0.4, 0.6)));
  const Shape* pill = t.keep(cylinder(0.4, 0.5));
  t.add(cube, Vec3(0, 0.4, 0));
  t.add(cube, Vec3(0.3, 1.21, 0.1));
  t.add(pill, Vec3(0.2, 2.12, 0));
  t.add(cube, Vec3(1.2, 0.4, 0.2));
  t.add(cube, Vec3(0.2, 3.03, 0.1));
  t.add(cube, Vec3(40, 3, 0), BodyType::kinematic);  // could move, so that the broad phase runs while the heap sleeps
}

void expect_equal_states(const World& a, const World& b) {
  for (std::uint32_t i = 0; i < a.scene.bodies.slots(); ++i) {
    assert_true(a.state.x[i] == b.state.x[i] && a.state.q[i] == b.state.q[i]);
    assert_true(a.state.v[i] == b.state.v[i] && a.state.omega[i] == b.state.omega[i]);
  }
}

/// Let the heap come to rest in two worlds, one that sleeps and one that does not. @return the step in which all slept
int until_asleep(TestWorld& sleeps, TestWorld& wakes) {
  sleeps.world.set_dial(Dial::sleep, 1);
  for (int step = 0; step < 1200; ++step) {
    sleeps.world.step(kStep), wakes.world.step(kStep);
    if (sleeps.world.report.asleep_bodies > 0) return step;
    assert_true(sleeps.world.hash() == wakes.world.hash());
  }
  assert_true(false);  // the heap did not come to rest
  return -1;
}

}  // namespace

static void until_the_first_sleep_a_world_is_that_without(void**) {
  for (const Setting& s : kSettings) {
    TestWorld a, b;
    build_heap(a, s), build_heap(b, s);
    assert_true(until_asleep(a, b) > 0);  // compares
    assert_true(a.world.hash() != b.world.hash());
    for (std::uint32_t i = 0; i < a.world.scene.bodies.slots(); ++i)
      assert_true(a.world.state.x[i] == b.world.state.x[i] && a.world.state.q[i] == b.world.state.q[i]);
  }
}

static void to_sleepers_no_time_has_passed(void**) {
  for (const Setting& s : kSettings)
    for (const int night : {0, 1, 100}) {
      // In the other world velocities become zero where the first falls asleep, and it goes on at once.
      TestWorld a, b;
      build_heap(a, s), build_heap(b, s);
      until_asleep(a, b);
      assert_int_equal(a.world.report.asleep_bodies, 5);
      a.run(night, kStep);
      for (std::uint32_t i = 0; i < b.world.scene.bodies.slots(); ++i) {
        b.world.state.v[i] = b.world.state.omega[i] = b.world.state.momentum[i] = Vec3::zero();
        b.world.state.mark_written(i);
      }
      for (std::uint32_t i = 1; i <= 5; ++i) a.world.wake_body(i);
      for (int k = 0; k < 25; ++k) {  // fewer than sleep_time
        a.world.step(kStep), b.world.step(kStep);
        assert_int_equal(a.world.report.asleep_bodies, 0);
        expect_equal_states(a.world, b.world);
        assert_true(a.world.hash() == b.world.hash());  // manifolds, ages and impulses too
        assert_int_equal(a.world.report.contact_points, b.world.report.contact_points);
      }
    }
}

static void a_blow_to_sleepers_is_that_to_bodies_at_rest(void**) {
  // Without gravity bodies that touch and have no velocity stay as they are, so nothing but sleep tells the two worlds
  // apart; to the bit.
  for (const Setting& s : kSettings)
    for (const Real spin : {0.0, 3.0}) {
      TestWorld worlds[2] = {TestWorld(Vec3::zero()), TestWorld(Vec3::zero())};
      for (TestWorld& t : worlds) {
        t.world.set_dial(Dial::solver, s.solver);
        t.world.set_dial(Dial::manifold, s.manifold);
        t.world.set_dial(Dial::broad_phase, s.broad);
        t.world.set_dial(Dial::pair_routines, s.routines);
        t.world.set_dial(Dial::substeps, 4);
        const Shape* cube = t.keep(box(Vec3::constant(0.5)));
        for (int i = 0; i < 4; ++i) t.add(cube, Vec3(i, 0.1 * i, 0));
        t.add(cube, Vec3(0, 30, 0));
        const std::uint32_t ball = t.add(t.keep(sphere(0.3)), Vec3(-6, 0.2, 0.1));
        t.world.set_velocity(ball, Vec3(4, 0, 0), Vec3(0, 0, spin));
      }
      worlds[0].world.set_dial(Dial::sleep, 1);
      Vec3 before = Vec3::zero();
      std::uint64_t most_asleep = 0;
      for (int k = 0; k < 150; ++k) {
        for (TestWorld& t : worlds) t.world.step(kStep);
        most_asleep = std::max(most_asleep, worlds[0].world.report.asleep_bodies);
        expect_equal_states(worlds[0].world, worlds[1].world);
        Vec3 momentum = Vec3::zero();
        const World& w = worlds[0].world;
        for (std::uint32_t i = 0; i < w.scene.bodies.slots(); ++i) momentum += w.scene.mass[i] * w.state.v[i];
        if (k == 0) before = momentum;
        // Impulses are equal and opposite; each of some 100 contacts a step rounds by an u of what it passes on.
        assert_true((momentum - before).norm() <= 100 * 150 * kUnitRoundoff * before.norm());
      }
      assert_int_equal(most_asleep, 5);
      assert_int_equal(worlds[0].world.report.asleep_bodies, 1);  // whom nobody hit
      assert_true(worlds[0].world.state.v[3].x() > 0);            // the last of the row was reached
    }
}

static void the_cost_in_calls_does_not_grow_with_the_number_asleep(void**) {
  // Ten awake boxes, that fall far from everybody, beside few or many sleepers: the same participants.
  std::uint64_t calls[2][4];
  for (const int many : {0, 1}) {
    TestWorld t;
    t.world.set_dial(Dial::sleep, 1);
    t.ground();
    const Shape* cube = t.keep(box(Vec3::constant(0.5)));
    for (int i = 0; i < (many ? 400 : 20); ++i) t.add(cube, Vec3(3 * (i % 20), 0.5, 3 * (i / 20)));
    t.run(120, kStep);
    for (int i = 0; i < 10; ++i) t.add(cube, Vec3(3 * i, 2e4, -50));
    t.run(2, kStep);
    assert_int_equal(t.world.report.asleep_bodies, many ? 400 : 20);
    calls[many][0] = t.world.plan->find("gravity")->participants.count;
    calls[many][1] = t.world.plan->find("collision")->participants.count;
    calls[many][2] = t.world.pairs.size();
    calls[many][3] = t.world.plan->find("sleep")->participants.count;
  }
  for (int k = 0; k < 4; ++k) assert_int_equal(calls[0][k], calls[1][k]);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(until_the_first_sleep_a_world_is_that_without),
      cmocka_unit_test(to_sleepers_no_time_has_passed),
      cmocka_unit_test(a_blow_to_sleepers_is_that_to_bodies_at_rest),
      cmocka_unit_test(the_cost_in_calls_does_not_grow_with_the_number_asleep),
  };
  return cmocka_run_group_tests_name("oracle/waking", tests, nullptr, nullptr);
}
