// The solver that chooses: what it chooses and why, and that groups are answered as if alone.
#include <vector>

#include "carom_test.h"
#include "core/job_pool.h"
#include "dynamics/solver/direct.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kStep = 1.0 / 60;

void use(TestWorld& t, Real solver) {
  t.world.set_dial(Dial::solver, solver);
  t.world.set_dial(Dial::substeps, 4);
}

std::vector<std::uint32_t> stack(TestWorld& t, int count, Real x) {
  const Shape* cube = t.keep(box(Vec3::constant(0.5)));
  std::vector<std::uint32_t> bodies;
  for (int i = 0; i < count; ++i) bodies.push_back(t.add(cube, Vec3(x, i + 0.5, 0)));
  return bodies;
}

/// A ball that rolls, spins and bumps into a box.
std::vector<std::uint32_t> bowling(TestWorld& t, Real x) {
  std::vector<std::uint32_t> bodies = {t.add(t.keep(sphere(0.5)), Vec3(x, 0.5, 0)),
                                       t.add(t.keep(box(Vec3::constant(0.4))), Vec3(x + 2, 0.4, 0.1))};
  t.world.set_velocity(bodies[0], Vec3(3, 0, 0), Vec3(0, 1, -2));
  return bodies;
}

constexpr std::uint32_t kPile = 96;

/// Three layers of boxes that come down on each other askew, and go to pieces.
void loose_pile(TestWorld& t, std::uint64_t seed) {
  Random random(seed);
  const Shape *block = t.keep(box(Vec3(0.3, 0.2, 0.4))), *smaller = t.keep(box(Vec3(0.29, 0.2, 0.4)));
  for (std::uint32_t i = 0; i < kPile; ++i) {
    const Vec3 askew{random.uniform(-0.1, 0.1), random.uniform(0, 0.05), random.uniform(-0.1, 0.1)};
    const Vec3 at(0.65 * (i % 4), 0.25 + 0.45 * (i / 16), 0.85 * (i / 4 % 4));
    t.add(i % 2 ? block : smaller, at + askew);
  }
}

/// Of the group with so many bodies; one of no bodies if there is none.
GroupView group_of(const TestWorld& t, std::uint32_t bodies) {
  for (const GroupView& g : t.world.group_views)
    if (g.bodies == bodies) return g;
  return {};
}

}  // namespace

static void it_names_what_it_chose_and_why(void**) {
  TestWorld t;
  use(t, kAutoChoice);
  t.world.set_dial(Dial::direct_sink, 0.005);  // what a cube of 1 m sinks under nine others
  t.ground();
  const Shape* cube = t.keep(box(Vec3::constant(0.5)));
  stack(t, 150, 0);
  for (int row = 0; row < 3; ++row)  // a low wall of more, that does not lie still as it is built
    for (int i = 0; i < 40; ++i)
      t.world.set_velocity(t.add(cube, Vec3(50 + i, row + 0.5, 0)), Vec3(0.4, 0, 0), Vec3::zero());
  for (int i = 0; i < 80; ++i) t.add(cube, Vec3(-20 - i, 0.5, 0));
  t.world.add_collider(t.add(nullptr, Vec3(-20, 1.5, 0)), cube, Pose{}, 1e6, Colliders::kNoMaterial);
  stack(t, 32, 40);
  t.run(100, kStep);
  const GroupView tall = group_of(t, 150), low = group_of(t, 120), uneven = group_of(t, 81), few = group_of(t, 32);
  assert_true(tall.bodies && low.bodies && uneven.bodies && few.bodies);
  assert_int_equal(t.world.report.direct_groups, 3);
  assert_true(tall.direct && tall.reason == GroupReason::sink);
  // 149 cubes on a joint at 30 Hz: each corner bears a quarter of 149 m g with an eighth of m: 2 * 149 g / w^2, of 1 m.
  const Real w = 2 * 3.14159265358979 * 30;
  assert_true(std::fabs(tall.sink - 2 * 149 * 9.81 / (w * w)) < 0.01 * tall.sink);
  assert_true(!low.direct && low.reason == GroupReason::ordinary);
  assert_true(uneven.direct && uneven.reason == GroupReason::mass_ratio);
  assert_true(std::fabs(uneven.mass_ratio - 1000) < 1e-9);
  assert_true(few.direct && few.reason == GroupReason::few);
}

/// Each group to the bit as in a world of its own.
static void groups_are_answered_as_if_alone(void**) {
  TestWorld both, tall, low;
  for (TestWorld* t : {&both, &tall, &low}) t->ground();
  use(both, kAutoChoice), use(tall, kAutoChoice), use(low, kAutoChoice);
  const std::vector<std::uint32_t> a = stack(both, 20, -10), b = bowling(both, 0), only_a = stack(tall, 20, -10),
                                   only_b = bowling(low, 0);
  for (int step = 0; step < 120; ++step) {
    for (TestWorld* t : {&both, &tall, &low}) t->world.step(kStep);
    for (std::size_t i = 0; i < a.size(); ++i) {
      assert_true(both.world.state.x[a[i]] == tall.world.state.x[only_a[i]]);
      assert_true(both.world.state.omega[a[i]] == tall.world.state.omega[only_a[i]]);
    }
    for (std::size_t i = 0; i < b.size(); ++i) {
      assert_true(both.world.state.x[b[i]] == low.world.state.x[only_b[i]]);
      assert_true(both.world.state.omega[b[i]] == low.world.state.omega[only_b[i]]);
    }
  }
  assert_true(low.world.state.x[only_b[1]].x() > 2.1);  // the box was hit
}

static void a_stack_of_forty_stands_under_either_choice_of_substeps(void**) {
  for (const Real substeps : {1.0, 4.0}) {
    TestWorld t;
    use(t, kAutoChoice);
    t.world.set_dial(Dial::substeps, substeps);
    t.ground();
    const std::vector<std::uint32_t> cubes = stack(t, 40, 0);
    t.run(600, kStep);
    // It is known to be tall from the first step on: nothing sinks but by the residual, 1e-6 m/s for 10 s a contact.
    for (std::size_t i = 0; i < cubes.size(); ++i)
      assert_true((t.world.state.x[cubes[i]] - Vec3(0, static_cast<Real>(i) + 0.5, 0)).norm() < 40 * 10 * 1e-6);
  }
}

static void soft_contacts_take_the_blow_that_strikes_a_stack(void**) {
  TestWorld t;
  use(t, kAutoChoice);
  t.ground();
  stack(t, 150, 0);
  const std::uint32_t ball = t.add(t.keep(sphere(0.5)), Vec3(-7, 10, 0));
  t.world.set_velocity(ball, Vec3(20, 0, 0), Vec3::zero());
  bool held = false, struck = false;
  for (int step = 0; step < 60; ++step) {
    t.world.step(kStep);
    const GroupView tall = group_of(t, 150), hit = group_of(t, 151);
    held |= tall.direct && tall.reason == GroupReason::sink;
    struck |= hit.bodies && !hit.direct && hit.reason == GroupReason::impact;
    assert_true(!(hit.bodies && hit.direct) || struck);  // never the first step of it
  }
  assert_true(held && struck);
}

static void a_group_beyond_its_work_is_left_to_soft_contacts_for_a_while(void**) {
  TestWorld t;
  use(t, kAutoChoice);
  t.world.set_dial(Dial::direct_work, 0);
  t.world.set_dial(Dial::direct_sink, 0);  // any load will do
  t.ground();
  loose_pile(t, 5);
  int direct = 0, spared = 0;
  for (int step = 0; step < 200; ++step) {
    t.world.step(kStep);
    for (const GroupView& g : t.world.group_views) {
      if (g.points / 4 <= kFew) continue;  // few
      direct += g.direct;
      spared += g.reason == GroupReason::too_much;
      assert_true(g.direct == (g.reason == GroupReason::sink));
    }
  }
  print_message("%d direct, %d spared\n", direct, spared);
  // Groups come and go while the heap falls; at least half of the 120 steps for which one is spared are among these.
  assert_true(direct > 0 && spared >= 60);
  for (std::uint32_t i = 1; i <= kPile; ++i) assert_true(t.world.state.x[i].y() > 0.1);
}

/// The same heap with some work allowed: a substep that comes nowhere near takes its share, and the next ones do not
/// try again.
static void who_gives_up_keeps_the_rest_of_its_work(void**) {
  constexpr Real kWork = 6000;
  int at_once = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    TestWorld t;
    use(t, kAutoChoice);
    t.world.set_dial(Dial::direct_ratio, 1);  // not one mass is as the other
    t.world.set_dial(Dial::direct_work, kWork);
    t.world.set_dial(Dial::direct_sink, 0);
    t.ground();
    loose_pile(t, seed);
    for (int step = 0; step < 100; ++step) {
      t.world.step(kStep);
      for (const GroupRest& rest : t.world.direct->rest)
        at_once += rest.gave_up && static_cast<Real>(rest.work) > kWork / 4;  // in the first of four substeps
    }
    for (std::uint32_t i = 1; i <= kPile; ++i) assert_true(t.world.state.x[i].y() > 0.1);
  }
  print_message("%d groups gave up at once\n", at_once);
  assert_true(at_once > 0);
}

/// A wall of 200 blocks that nobody touches, joints of the courses open by `joint`.
static void a_wall_that_stands_is_solved_now_and_then(void**) {
  constexpr int kColumns = 20, kRows = 10, kSteps = 300;
  for (const Real joint : {0.0, 0.005}) {  // m
    TestWorld t;
    t.ground();
    const Shape* block = t.keep(box(Vec3(0.15, 0.15, 0.3)));
    for (int row = 0; row < kRows; ++row)
      for (int k = 0; k < kColumns - row % 2; ++k)
        t.add(block, Vec3(0, 0.15 + 0.3 * row, (k + 0.5 * (row % 2)) * (0.6 + joint)));
    const Real tolerance = t.world.scene.dials[Dial::velocity_tolerance], work = t.world.scene.dials[Dial::direct_work];
    double sum = 0;
    for (int step = 0; step < kSteps; ++step) {
      t.world.step(kStep);
      const StepReport& report = t.world.report;
      assert_int_equal(report.direct_groups, 1);
      const auto newton = static_cast<double>(report.velocity_impulses + report.position_moves);
      assert_true(report.solver_residual < tolerance);
      assert_true(report.max_penetration < 1e-5);
      if (step == 0) continue;  // never solved before: to the end
      assert_true(newton <= 16 + work / static_cast<double>(t.world.direct->newton_work(0)));
      sum += newton;
    }
    print_message("%.2f steps of Newton a step\n", sum / (kSteps - 1));
    assert_true(sum / (kSteps - 1) < 2);
  }
}

static void a_blow_goes_through_a_row_of_balls_without_loss(void**) {
  TestWorld t(Vec3::zero());
  use(t, kAutoChoice);
  const std::vector<std::uint32_t> row = t.cradle();
  t.run(60, kStep);
  for (std::size_t i = 0; i < 5; ++i) assert_true(std::fabs(t.world.state.v[row[i]].x() - (i == 4 ? 1 : 0)) < 1e-12);
}

/// m, the deepest point of a pyramid over the last of two seconds.
/// @param cools_down  a block of it was in a small group just now that the direct solver gave up
static Real depth_of_pyramid(int base, bool cools_down) {
  TestWorld t;
  use(t, kAutoChoice);
  t.ground();
  const Shape* cube = t.keep(box(Vec3::constant(0.5)));
  std::uint32_t block = 0;
  for (int row = 0; row < base; ++row)
    for (int i = 0; i < base - row; ++i) block = t.add(cube, Vec3((i + Real(row) / 2) * 1.05, row + 0.5, 0));
  t.run(20, kStep);
  assert_int_equal(t.world.group_views.size(), 1);
  assert_true(t.world.group_views[0].bodies > 512 && !t.world.group_views[0].direct);
  constexpr std::uint8_t kSteps = 119;  // left of 120
  if (cools_down) t.world.state.cooldown_steps[block] = kSteps;
  t.run(100, kStep);
  if (cools_down) assert_int_equal(t.world.state.cooldown_steps[block], kSteps - 100);
  Real deepest = 0;
  for (int i = 0; i < 60; ++i) t.run(1, kStep), deepest = std::max<Real>(deepest, t.world.report.max_penetration);
  assert_int_equal(t.world.state.cooldown_steps[block], 0);
  return deepest;
}

/// Else the group would start from nothing in every step, and sink.
static void what_cools_down_in_a_large_group_takes_nobodys_impulses(void**) {
  for (const int base : {33, 36, 41}) {
    const Real alone = depth_of_pyramid(base, false), cooled = depth_of_pyramid(base, true);
    print_message("base %d: %.2f mm, %.2f mm\n", base, 1e3 * alone, 1e3 * cooled);
    assert_true(cooled < 1.1 * alone);
  }
}

/// Several groups at a time on several threads: the same bits.
static void threads_do_not_change_a_bit(void**) {
  std::uint64_t hash[2];
  JobPool pool(
      4, [] {}, std::pmr::new_delete_resource());
  for (const bool shared : {false, true}) {
    TestWorld t;
    t.world.jobs = shared ? &pool : nullptr;
    use(t, kAutoChoice);
    t.ground();
    for (int i = 0; i < 8; ++i) stack(t, 12, 3 * i);
    bowling(t, -4);
    t.run(60, kStep);
    assert_true(t.world.report.direct_groups >= 8);
    hash[shared] = t.world.hash();
  }
  assert_true(hash[0] == hash[1]);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(it_names_what_it_chose_and_why),
      cmocka_unit_test(groups_are_answered_as_if_alone),
      cmocka_unit_test(a_stack_of_forty_stands_under_either_choice_of_substeps),
      cmocka_unit_test(who_gives_up_keeps_the_rest_of_its_work),
      cmocka_unit_test(a_wall_that_stands_is_solved_now_and_then),
      cmocka_unit_test(a_blow_goes_through_a_row_of_balls_without_loss),
      cmocka_unit_test(what_cools_down_in_a_large_group_takes_nobodys_impulses),
      cmocka_unit_test(threads_do_not_change_a_bit),
      cmocka_unit_test(soft_contacts_take_the_blow_that_strikes_a_stack),
      cmocka_unit_test(a_group_beyond_its_work_is_left_to_soft_contacts_for_a_while),
  };
  return cmocka_run_group_tests_name("oracle/auto", tests, nullptr, nullptr);
}
