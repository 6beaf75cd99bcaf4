// Who falls asleep and when, what wakes whom, and that sleepers are in nobody's way.
#include <functional>
#include <memory_resource>
#include <new>
#include <string>
#include <vector>

#include "carom_test.h"
#include "dynamics/contact_views.h"
#include "dynamics/sleep/sleep.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kStep = 1.0 / 60;

/// Three cubes on the ground, a lone cube 20 m beside them, a plank that can be moved far away; all asleep.
struct Camp {
  explicit Camp(int solver = kSeverityChoice) {
    t.world.set_dial(Dial::sleep, 1);
    t.world.set_dial(Dial::solver, solver);
    if (solver != kSeverityChoice) t.world.set_dial(Dial::substeps, 4);
    ground_material = t.material(0.5, 0);
    wood = t.material(0.6, 0);
    cube = t.keep(box(Vec3::constant(0.5)));
    ground = t.ground(ground_material);
    for (int i = 0; i < 3; ++i)
      stack.push_back(t.add(cube, Vec3(0, i + 0.5, 0), BodyType::dynamic, Quat::identity(), wood));
    lone = t.add(cube, Vec3(20, 0.5, 0));
    plank = t.add(t.keep(box(Vec3(0.5, 0.1, 0.5))), Vec3(0, 50, 0), BodyType::kinematic);
    rest();
  }
  void rest() {
    for (int i = 0; i < 600 && !(stack_sleeps() && t.world.asleep(lone)); ++i) t.world.step(kStep);
  }
  bool stack_sleeps() const { return t.world.asleep(stack[0]) && t.world.asleep(stack[1]) && t.world.asleep(stack[2]); }
  bool stack_is_awake() const {
    return !t.world.asleep(stack[0]) && !t.world.asleep(stack[1]) && !t.world.asleep(stack[2]);
  }

  TestWorld t;
  const Shape* cube;
  std::uint32_t ground_material, wood, ground, lone, plank;
  std::vector<std::uint32_t> stack;
};

std::uint32_t collider_of(const World& w, std::uint32_t body) { return w.scene.first_collider[body]; }

}  // namespace

static void nobody_sleeps_unless_the_dial_is_on(void**) {
  TestWorld t;
  t.ground();
  t.add(t.keep(box(Vec3::constant(0.5))), Vec3(0, 0.5, 0));
  t.run(300, kStep);
  assert_int_equal(t.world.report.asleep_bodies, 0);
  assert_int_equal(t.world.plan->find("sleep")->evaluations, 0);
  assert_int_equal(t.world.state.asleep.capacity(), 0);
  assert_int_equal(t.world.sleep->tree.size(), 0);
}

static void a_stack_sleeps_within_seconds_and_then_nothing_runs(void**) {
  for (const int solver : {kSeverityChoice, kSoftChoice}) {
    Camp c(solver);
    assert_true(c.stack_sleeps() && c.t.world.asleep(c.lone));
    assert_int_equal(c.t.world.report.asleep_bodies, 4);
    assert_int_equal(c.t.world.report.dynamic_bodies, 4);
    c.t.world.step(kStep);
    assert_int_equal(c.t.world.report.fell_asleep, 0);
    // But for the plank, that could move: it is no dynamic body, and meets nobody.
    c.t.world.remove_body(c.plank);
    c.t.world.step(kStep);
    assert_int_equal(c.t.world.report.asleep_bodies, 4);
    std::vector<std::uint64_t> before;
    for (const PlannedEffect& row : c.t.world.plan->effects) before.push_back(row.evaluations);
    c.t.run(10, kStep);
    for (std::size_t k = 0; k < before.size(); ++k) {
      assert_int_equal(c.t.world.plan->effects[k].evaluations, before[k]);
      if (c.t.world.plan->effects[k].effect->stage != Stage::solve)
        assert_int_equal(c.t.world.plan->effects[k].participants.count, 0);
    }
    for (const Stage s : {Stage::broad, Stage::narrow, Stage::group, Stage::integrate, Stage::solve, Stage::relax})
      assert_true(c.t.world.report.stage_seconds[static_cast<std::size_t>(s)] == 0);
    for (const std::uint32_t i : c.stack) assert_true(c.t.world.state.v[i] == Vec3::zero());
  }
}

static void a_body_at_rest_in_empty_space_sleeps_after_its_time(void**) {
  TestWorld t(Vec3::zero());
  t.world.set_dial(Dial::sleep, 1);
  const std::uint32_t rock = t.add(t.keep(sphere(1)), Vec3::zero()), point = t.add(nullptr, Vec3(5, 0, 0));
  const std::uint32_t spun = t.add(t.keep(sphere(1)), Vec3(9, 0, 0)), spins = t.add(t.keep(sphere(1)), Vec3(15, 0, 0));
  t.world.set_velocity(spun, Vec3::zero(), Vec3(0, 0.04, 0));   // 0.04 m/s at its surface, within sleep_speed
  t.world.set_velocity(spins, Vec3::zero(), Vec3(0, 0.06, 0));  // beyond
  for (int i = 1; i <= 40; ++i) {
    t.world.step(kStep);
    // sleep_time is 0.5 s; thirty times 1/60 s may round to either side of it.
    if (i < 30) assert_int_equal(t.world.report.asleep_bodies, 0);
  }
  assert_true(t.world.asleep(rock) && t.world.asleep(point) && t.world.asleep(spun) && !t.world.asleep(spins));
  assert_true(t.world.state.omega[spun] == Vec3::zero());
}

static void a_body_that_is_moved_without_a_velocity_stays_awake(void**) {
  // As a solver does that undoes penetration: not slow, though the velocity is 0.
  TestWorld t(Vec3::zero());
  t.world.set_dial(Dial::sleep, 1);
  t.world.set_dial(Dial::sleep_speed, 1e-3);
  const std::uint32_t a = t.add(t.keep(sphere(1)), Vec3::zero());
  for (int i = 0; i < 60; ++i) {
    t.world.step(kStep);
    t.world.state.x[a].x() += 1e-3 * kStep * 2;  // twice the speed
  }
  assert_false(t.world.asleep(a));
  t.run(33, kStep);  // one to notice, 30 or 31 to count to half a second
  assert_true(t.world.asleep(a));
}

static void who_must_stay_awake_keeps_its_island_awake(void**) {
  TestWorld t;
  t.world.set_dial(Dial::sleep, 1);
  t.ground();
  const Shape* cube = t.keep(box(Vec3::constant(0.5)));
  BodyDef def;
  def.stays_awake = true;
  def.pose.p = Vec3(0, 1.5, 0);
  const std::uint32_t under = t.add(cube, Vec3(0, 0.5, 0)), beside = t.add(cube, Vec3(9, 0.5, 0));
  const std::uint32_t guard = handle_slot(t.world.add_body(def));
  t.world.add_collider(guard, cube, Pose{}, 1000, Colliders::kNoMaterial);
  t.run(300, kStep);
  assert_true(t.world.asleep(beside) && !t.world.asleep(under) && !t.world.asleep(guard));
}

static void an_island_on_a_belt_that_creeps_stays_awake(void**) {
  TestWorld t;
  t.world.set_dial(Dial::sleep, 1);
  const std::uint32_t belt = t.add(t.keep(box(Vec3(5, 0.5, 5))), Vec3(0, -0.5, 0), BodyType::kinematic);
  const std::uint32_t parcel = t.add(t.keep(box(Vec3::constant(0.5))), Vec3(0, 0.5, 0));
  t.world.set_velocity(belt, Vec3(0.01, 0, 0), Vec3::zero());  // slower than sleep_speed
  t.run(300, kStep);
  assert_false(t.world.asleep(parcel));
  t.world.set_velocity(belt, Vec3::zero(), Vec3::zero());
  t.run(60, kStep);
  assert_true(t.world.asleep(parcel));
  t.world.step(kStep);  // inactive by now
  t.world.set_velocity(belt, Vec3(0.01, 0, 0), Vec3::zero());
  t.world.step(kStep);
  assert_false(t.world.asleep(parcel));
}

/// Everything a host may write, and whom it wakes.
static void every_edit_wakes_those_whom_it_concerns(void**) {
  struct Cause {
    const char* name;
    bool wakes_stack, wakes_lone;
    std::function<void(Camp&)> edit;
  };
  const Cause causes[] = {
      {"pose", true, false, [](Camp& c) { c.t.world.set_pose(c.stack[2], c.t.world.pose(c.stack[2])); }},
      {"velocity", true, false, [](Camp& c) { c.t.world.set_velocity(c.stack[1], Vec3(0.1, 0, 0), Vec3::zero()); }},
      {"spin", true, false, [](Camp& c) { c.t.world.set_velocity(c.stack[1], Vec3::zero(), Vec3(0, 1, 0)); }},
      {"zero velocity", false, false, [](Camp& c) { c.t.world.set_velocity(c.stack[1], Vec3::zero(), Vec3::zero()); }},
      {"force", true, false, [](Camp& c) { c.t.world.add_force(c.stack[0], Vec3(1, 0, 0), Vec3::zero()); }},
      {"torque", true, false, [](Camp& c) { c.t.world.set_force(c.stack[0], Vec3::zero(), Vec3(0, 1, 0)); }},
      {"zero force", false, false, [](Camp& c) { c.t.world.set_force(c.stack[0], Vec3::zero(), Vec3::zero()); }},
      {"impulse", true, false, [](Camp& c) { c.t.world.add_impulse(c.stack[0], Vec3(1, 0, 0), Vec3::zero()); }},
      {"call", true, false, [](Camp& c) { c.t.world.wake_body(c.stack[0]); }},
      {"own material", true, false, [](Camp& c) { c.t.world.set_material(c.wood, Material{}); }},
      {"the ground's material", true, true, [](Camp& c) { c.t.world.set_material(c.ground_material, Material{}); }},
      {"nobody's material", false, false, [](Camp& c) { c.t.world.set_material(c.t.material(1, 0), Material{}); }},
      {"a new collider", true, false,
       [](Camp& c) { c.t.world.add_collider(c.stack[2], c.cube, Pose{}, 1, Colliders::kNoMaterial); }},
      {"a lost collider", true, false, [](Camp& c) { c.t.world.remove_collider(collider_of(c.t.world, c.stack[1])); }},
      {"the ground's collider", true, true,
       [](Camp& c) { c.t.world.remove_collider(collider_of(c.t.world, c.ground)); }},
      {"the ground", true, true, [](Camp& c) { c.t.world.remove_body(c.ground); }},
      {"the ground moved", true, true,
       [](Camp& c) {
         c.t.world.set_pose(c.ground, {Quat::identity(), Vec3(0, -1, 0)});
       }},
      {"the ground where it is", false, false, [](Camp& c) { c.t.world.set_pose(c.ground, c.t.world.pose(c.ground)); }},
      {"gravity", true, true, [](Camp& c) { c.t.world.set_gravity(Vec3(0, -1, 0)); }},
      {"the same gravity", false, false, [](Camp& c) { c.t.world.set_gravity(Vec3(0, -9.81, 0)); }},
      {"a dial", true, true, [](Camp& c) { c.t.world.set_dial(Dial::velocity_iterations, 9); }},
      {"sleep off", true, true, [](Camp& c) { c.t.world.set_dial(Dial::sleep, 0); }},
      {"a body far off", false, false, [](Camp& c) { c.t.add(c.cube, Vec3(0, 100, 0)); }},
      {"a body in touch", true, false, [](Camp& c) { c.t.add(c.cube, Vec3(0, 3.5, 0)); }},
      {"a static body in touch", true, false, [](Camp& c) { c.t.add(c.cube, Vec3(0.99, 0.5, 0), BodyType::fixed); }},
      {"a static body near", false, false, [](Camp& c) { c.t.add(c.cube, Vec3(1.03, 0.5, 0), BodyType::fixed); }},
      {"the plank put there", true, false,
       [](Camp& c) {
         c.t.world.set_pose(c.plank, {Quat::identity(), Vec3(0, 3.09, 0)});
       }},
      {"the plank moves there", true, false,
       [](Camp& c) {
         c.t.world.set_pose(c.plank, {Quat::identity(), Vec3(0, 3.12, 0)});
         c.t.world.set_velocity(c.plank, Vec3(0, -3, 0), Vec3::zero());  // 5 cm in the step, the gap is 2 cm
       }},
  };
  for (const bool inactive : {false, true})
    for (const Cause& cause : causes) {
      Camp c;
      assert_true(c.stack_sleeps() && c.t.world.asleep(c.lone));
      if (inactive) c.t.world.step(kStep);
      cause.edit(c);
      c.t.world.step(kStep);
      const bool stack_as_told = cause.wakes_stack ? c.stack_is_awake() : c.stack_sleeps();
      if (!stack_as_told || c.t.world.asleep(c.lone) == cause.wakes_lone)
        print_error("%s (%s)\n", cause.name, inactive ? "inactive" : "just asleep");
      assert_true(stack_as_told);
      assert_true(c.t.world.asleep(c.lone) != cause.wakes_lone);
      c.t.run(5, kStep);
    }
}

static void a_stack_whose_lowest_cube_is_taken_falls(void**) {
  Camp c;
  c.t.run(2, kStep);
  c.t.world.remove_body(c.stack[0]);
  c.t.world.step(kStep);
  assert_true(!c.t.world.asleep(c.stack[1]) && !c.t.world.asleep(c.stack[2]) && c.t.world.asleep(c.lone));
  c.t.run(300, kStep);
  assert_true(std::fabs(c.t.world.state.x[c.stack[1]].y() - 0.5) < 0.01);
  assert_true(std::fabs(c.t.world.state.x[c.stack[2]].y() - 1.5) < 0.01);
  assert_true(c.t.world.asleep(c.stack[1]) && c.t.world.asleep(c.stack[2]));
}

static void a_touch_wakes_the_island_in_the_same_step_and_nobody_else(void**) {
  for (const Real broad : {0.0, 1.0, 2.0, 3.0}) {
    Camp c;
    c.t.world.set_dial(Dial::broad_phase, broad);
    c.rest();
    const std::uint32_t ball = c.t.add(c.t.keep(sphere(0.25)), Vec3(-3, 1.5, 0));
    c.t.world.set_velocity(ball, Vec3(8, 1.5, 0), Vec3::zero());
    bool met = false;
    for (int i = 0; i < 60 && !met; ++i) {
      assert_true(c.stack_sleeps());
      c.t.world.step(kStep);
      // A contact of the ball with the stack is in the step's list; the step in which it is there is the step of
      // waking.
      for (const ContactView& v : c.t.world.contact_views()) {
        const std::uint32_t a = c.t.world.scene.colliders.body[v.collider_a],
                            b = c.t.world.scene.colliders.body[v.collider_b];
        met |= (a == ball || b == ball) && a != c.ground && b != c.ground;
      }
      assert_true(met ? c.stack_is_awake() : c.stack_sleeps());
    }
    assert_true(met);
    assert_int_equal(c.t.world.report.woke_up, 3);
    assert_true(c.t.world.asleep(c.lone));
    c.t.run(600, kStep);
    assert_true(c.stack_sleeps());  // the ball rolls on
  }
}

static void islands_that_meet_are_one_and_sleep_and_wake_together(void**) {
  Camp c;
  c.t.world.set_pose(c.lone, {Quat::identity(), Vec3(0, 3.5, 0)});
  c.t.run(2, kStep);
  assert_true(c.stack_is_awake());
  c.rest();
  assert_true(c.stack_sleeps() && c.t.world.asleep(c.lone));
  c.t.run(3, kStep);
  c.t.world.wake_body(c.lone);
  assert_true(c.stack_is_awake());
}

static void sleepers_are_out_of_the_lists_and_their_records_are_kept(void**) {
  Camp c;
  const std::size_t records = c.t.world.pairs.size();
  c.t.world.step(kStep);
  assert_int_equal(c.t.world.pairs.size(), 0);  // the plank is 50 m above all
  assert_int_equal(c.t.world.pairs.inactive_count(), records);
  assert_int_equal(c.t.world.impulses.old.size(), 0);
  assert_int_equal(c.t.world.scene.colliders.active.size(), 2);  // ground and plank
  assert_int_equal(c.t.world.plan->linear.count + c.t.world.plan->rotating.count, 0);
  assert_int_equal(c.t.world.sleep->tree.size(), 4);
  c.t.world.wake_body(c.lone);
  c.t.world.wake_body(c.stack[0]);
  c.t.world.step(kStep);
  assert_int_equal(c.t.world.pairs.size(), records);
  assert_int_equal(c.t.world.pairs.inactive_count(), 0);
  assert_int_equal(c.t.world.sleep->tree.size(), 0);
}

static void a_slot_that_is_used_again_is_awake(void**) {
  Camp c;
  c.t.run(2, kStep);
  c.t.world.remove_body(c.lone);
  const std::uint32_t again = c.t.add(c.cube, Vec3(20, 5, 0));
  assert_int_equal(again, c.lone);
  assert_false(c.t.world.asleep(again));
  c.t.world.step(kStep);
  assert_true(c.t.world.state.v[again].y() < 0);
  assert_true(c.stack_sleeps());
}

static void a_body_in_quarantine_wakes_all_and_sleeps_no_more(void**) {
  Camp c;
  c.t.world.step(kStep);
  c.t.world.state.v[c.stack[1]] = Vec3(0, kInfinity, 0);
  c.t.world.set_pose(c.stack[1], c.t.world.pose(c.stack[1]));
  c.t.run(2, kStep);
  assert_int_equal(c.t.world.report.quarantined_bodies, 1);
  c.t.run(2, kStep);
  assert_true(!c.t.world.asleep(c.stack[0]) && !c.t.world.asleep(c.lone));
  c.t.run(300, kStep);
  assert_true(!c.t.world.asleep(c.stack[1]) && c.t.world.asleep(c.lone) && c.t.world.asleep(c.stack[0]));
  assert_int_equal(c.t.world.report.quarantined_bodies, 1);
}

/// The k-th allocation after a heap fell asleep fails, once: whatever it was for, nothing is lost but sleep and caches.
static void running_out_of_memory_loses_nobody(void**) {
  struct Failing : std::pmr::memory_resource {
    std::uint64_t calls = 0, fail_at = ~std::uint64_t{0};
    void* do_allocate(std::size_t bytes, std::size_t align) override {
      if (calls++ == fail_at) throw std::bad_alloc();
      return std::pmr::new_delete_resource()->allocate(bytes, align);
    }
    void do_deallocate(void* p, std::size_t bytes, std::size_t align) override {
      std::pmr::new_delete_resource()->deallocate(p, bytes, align);
    }
    bool do_is_equal(const memory_resource& o) const noexcept override { return this == &o; }
  };
  TestWorld shapes;
  const Shape* cube = shapes.keep(box(Vec3::constant(0.5)));
  const Shape* slab = shapes.keep(box(Vec3(9, 0.5, 9)));
  std::uint64_t failures = 0;
  for (std::uint64_t k = 0;; ++k) {
    Failing memory;
    World world(1, Vec3(0, -9.81, 0), 0, &memory);
    world.set_dial(Dial::sleep, 1);
    const auto add = [&](const Shape* shape, const Vec3& p, BodyType type) {
      BodyDef def;
      def.type = type;
      def.pose.p = p;
      const std::uint32_t body = handle_slot(world.add_body(def));
      world.add_collider(body, shape, Pose{}, 1000, Colliders::kNoMaterial);
      return body;
    };
    const std::uint32_t floor = add(slab, Vec3(0, -0.5, 0), BodyType::fixed);
    std::vector<std::uint32_t> cubes;
    for (int i = 0; i < 3; ++i) cubes.push_back(add(cube, Vec3(0, i + 0.5, 0), BodyType::dynamic));
    const std::uint32_t runner = add(cube, Vec3(-4, 0.5, 0), BodyType::kinematic);
    while (world.report.asleep_bodies == 0) world.step(kStep);
    memory.fail_at = memory.calls + k;
    bool failed = false;
    const auto step = [&] {
      try {
        world.step(kStep);
      } catch (const std::bad_alloc&) {
        failed = true;
      }
    };
    for (int i = 0; i < 3; ++i) step();
    world.set_velocity(runner, Vec3(6, 0, 0), Vec3::zero());  // it runs into the stack
    for (int i = 0; i < 40; ++i) step();
    world.set_velocity(runner, Vec3::zero(), Vec3::zero());
    for (int i = 0; i < 200; ++i) step();
    for (const std::uint32_t i : cubes) assert_true(finite(world.state.x[i]) && world.state.x[i].y() > 0.48);
    memory.fail_at = ~std::uint64_t{0};
    world.remove_body(floor), world.remove_body(runner);  // some may lie on it by now
    for (int i = 0; i < 30; ++i) world.step(kStep);
    for (const std::uint32_t i : cubes) assert_true(world.state.v[i].y() < -1);  // nobody hangs in the air
    failures += failed;
    if (!failed) break;  // more would come later than all
  }
  assert_true(failures > 5);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(nobody_sleeps_unless_the_dial_is_on),
      cmocka_unit_test(a_stack_sleeps_within_seconds_and_then_nothing_runs),
      cmocka_unit_test(a_body_at_rest_in_empty_space_sleeps_after_its_time),
      cmocka_unit_test(a_body_that_is_moved_without_a_velocity_stays_awake),
      cmocka_unit_test(who_must_stay_awake_keeps_its_island_awake),
      cmocka_unit_test(an_island_on_a_belt_that_creeps_stays_awake),
      cmocka_unit_test(every_edit_wakes_those_whom_it_concerns),
      cmocka_unit_test(a_stack_whose_lowest_cube_is_taken_falls),
      cmocka_unit_test(a_touch_wakes_the_island_in_the_same_step_and_nobody_else),
      cmocka_unit_test(islands_that_meet_are_one_and_sleep_and_wake_together),
      cmocka_unit_test(sleepers_are_out_of_the_lists_and_their_records_are_kept),
      cmocka_unit_test(a_slot_that_is_used_again_is_awake),
      cmocka_unit_test(running_out_of_memory_loses_nobody),
      cmocka_unit_test(a_body_in_quarantine_wakes_all_and_sleeps_no_more),
  };
  return cmocka_run_group_tests_name("dynamics/sleep", tests, nullptr, nullptr);
}
