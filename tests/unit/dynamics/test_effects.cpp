// Only effects with participants run, and only on their participants.
#include "carom_test.h"
#include "dynamics/contact/contact.h"
#include "dynamics/effects.h"
#include "dynamics/force/force.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

/// Counts what is asked of it.
class CountingMemory : public std::pmr::memory_resource {
 public:
  std::uint64_t calls = 0;

 private:
  void* do_allocate(std::size_t bytes, std::size_t align) override {
    ++calls;
    return std::pmr::new_delete_resource()->allocate(bytes, align);
  }
  void do_deallocate(void* p, std::size_t bytes, std::size_t align) override {
    std::pmr::new_delete_resource()->deallocate(p, bytes, align);
  }
  bool do_is_equal(const memory_resource& o) const noexcept override { return this == &o; }
};

/// Asks for each force once a step.
constexpr Real kSemiImplicitChoice = 1;  // CAROM_INTEGRATOR_SEMI_IMPLICIT_EULER

std::uint64_t evaluations(World& w, const char* name) { return w.plan->find(name)->evaluations; }

}  // namespace

static void a_world_of_particles_runs_integration_and_nothing_else(void**) {
  TestWorld t;
  t.world.set_dial(Dial::integrator, kSemiImplicitChoice);
  t.world.set_dial(Dial::substeps, 1);
  for (int i = 0; i < 100; ++i) t.add(nullptr, Vec3(i, 0, 0));
  t.run(3, 1.0 / 60);
  for (const PlannedEffect& row : t.world.plan->effects)
    assert_int_equal(row.evaluations, std::string_view(row.effect->name) == "gravity" ? 300 : 0);
  for (const Stage s : {Stage::broad, Stage::narrow, Stage::group, Stage::solve, Stage::relax}) {
    assert_false(t.world.plan->runs[static_cast<std::size_t>(s)]);
    assert_true(t.world.report.stage_seconds[static_cast<std::size_t>(s)] == 0);
  }
  assert_true(t.world.report.stage_seconds[static_cast<std::size_t>(Stage::integrate)] > 0);
  assert_int_equal(t.world.contacts->rows.capacity(), 0);
  assert_int_equal(t.world.plan->rotation.capacity(), 0);
  assert_int_equal(t.world.plan->predicted.x.capacity(), 0);
  for (const auto& b : t.world.broad) assert_null(b.get());
}

/// Stages are timed by ticks, the step by a clock: what they took is in seconds, and no more than the step.
static void times_of_stages_add_up_to_the_step(void**) {
  TestWorld t;
  t.ground();
  for (int i = 0; i < 60; ++i) t.add(t.keep(box(Vec3(0.5, 0.4, 0.3))), Vec3(i % 4, 0.5 + i / 4, 0.1 * (i % 3)));
  double stages = 0, steps = 0;
  for (int k = 0; k < 100; ++k) {
    t.world.step(1.0 / 60);
    for (const double seconds : t.world.report.stage_seconds) {
      assert_true(seconds >= 0 && seconds <= 1.001 * t.world.report.total_seconds);
      stages += seconds;
    }
    steps += t.world.report.total_seconds;
  }
  assert_true(stages <= 1.001 * steps);
  assert_true(stages >= 0.5 * steps);  // the rest is a few lines between stages
}

static void each_effect_serves_its_participants_alone(void**) {
  TestWorld t;
  t.world.set_dial(Dial::integrator, kSemiImplicitChoice);
  t.world.set_dial(Dial::substeps, 1);
  const Shape* plank = t.keep(box(Vec3(1, 2, 3)));
  const Shape* cube = t.keep(box(Vec3(1, 1, 1)));
  const std::uint32_t spinning = t.add(plank, Vec3(0, 100, 0));
  t.add(plank, Vec3(20, 100, 0));
  const std::uint32_t die = t.add(cube, Vec3(40, 100, 0));
  BodyDef damped;
  damped.linear_damping = damped.angular_damping = 1;
  damped.pose.p = Vec3(60, 100, 0);
  t.world.add_body(damped);  // a particle: damped in flight, but nothing turns
  t.world.set_velocity(spinning, Vec3::zero(), Vec3(1, 2, 3));
  t.world.set_velocity(die, Vec3::zero(), Vec3(1, 2, 3));
  t.world.add_force(die, Vec3(1, 0, 0), Vec3(0, 1, 0));
  t.run(2, 1.0 / 60);
  assert_int_equal(evaluations(t.world, "gravity"), 8);
  assert_int_equal(evaluations(t.world, "gyroscopic"), 2);  // neither the cube nor the plank at rest
  assert_int_equal(evaluations(t.world, "linear_damping"), 2);
  assert_int_equal(evaluations(t.world, "angular_damping"), 0);
  assert_int_equal(evaluations(t.world, "user_force"), 1);  // for one step
  assert_int_equal(evaluations(t.world, "user_torque"), 1);
  t.world.set_dial(Dial::rotation, 0);
  t.run(1, 1.0 / 60);
  assert_int_equal(evaluations(t.world, "gyroscopic"), 2);
}

static void without_gravity_there_is_no_gravity_effect(void**) {
  TestWorld t(Vec3::zero());
  t.add(nullptr, Vec3::zero());
  t.run(1, 1.0 / 60);
  assert_int_equal(evaluations(t.world, "gravity"), 0);
}

static void rk4_evaluates_forces_four_times(void**) {
  TestWorld t;
  t.add(nullptr, Vec3::zero());
  t.world.set_dial(Dial::integrator, 2);
  t.run(1, 1.0 / 60);
  assert_int_equal(evaluations(t.world, "gravity"), 4 * 4);  // in each of four substeps, which a step has by default
}

static void friction_and_restitution_count_the_contacts_that_have_them(void**) {
  TestWorld t;
  const std::uint32_t ice = t.material(0, 0), rubber = t.material(1, 0.5);
  t.ground();
  const Shape* ball = t.keep(sphere(0.5));
  t.add(ball, Vec3(0, 0.5, 0), BodyType::dynamic, Quat::identity(), ice);
  t.world.step(1.0 / 60);
  assert_int_equal(t.world.plan->find("friction")->participants.count, 0);
  assert_int_equal(t.world.plan->find("restitution")->participants.count, 0);
  t.add(ball, Vec3(3, 0.5, 0), BodyType::dynamic, Quat::identity(), rubber);
  t.world.step(1.0 / 60);
  assert_int_equal(t.world.plan->find("friction")->participants.count, 1);
  assert_int_equal(t.world.plan->find("restitution")->participants.count, 1);
}

static void a_pile_at_rest_allocates_nothing(void**) {
  for (const Real integrator : {0.0, 1.0, 2.0}) {
    CountingMemory memory;
    World world(1, Vec3(0, -9.81, 0), 0, &memory);
    world.set_dial(Dial::integrator, integrator);
    TestWorld shapes;
    const Shape* cube = shapes.keep(box(Vec3::constant(0.5)));
    const auto add = [&](const Vec3& p, BodyType type) {
      BodyDef def;
      def.type = type;
      def.pose.p = p;
      world.add_collider(handle_slot(world.add_body(def)), cube, Pose{}, 1000, Colliders::kNoMaterial);
    };
    for (int i = 0; i < 4; ++i) add(Vec3(i, -0.5, 0), BodyType::fixed), add(Vec3(i, 0.5, 0), BodyType::dynamic);
    for (int i = 0; i < 120; ++i) world.step(1.0 / 60);
    const std::uint64_t before = memory.calls;
    for (int i = 0; i < 60; ++i) world.step(1.0 / 60);
    assert_int_equal(memory.calls, before);
    assert_true(world.report.contact_points >= 16);
  }
}

static void a_body_that_cannot_rotate_turns_by_its_hosts_hand(void**) {
  TestWorld t;
  t.ground();
  BodyDef def;
  def.has_mass = def.has_inertia = true;  // of zero inertia
  def.mass = 1;
  def.pose.p = Vec3(0, 2, 0);
  const std::uint32_t post = handle_slot(t.world.add_body(def));
  t.world.add_collider(post, t.keep(box(Vec3(0.1, 1, 0.1))), Pose{}, 1000, Colliders::kNoMaterial);
  t.run(3, 1.0 / 60);
  const Quat lying(std::sqrt(0.5), 0, 0, std::sqrt(0.5));
  t.world.set_pose(post, {lying, Vec3(0, 0.5, 0)});
  t.run(120, 1.0 / 60);
  assert_true(std::fabs(t.world.state.x[post].y() - 0.1) < 2 * t.world.scene.dials[Dial::position_tolerance]);
}

static void a_force_lives_for_one_step_also_after_one_that_failed(void**) {
  struct Failing : std::pmr::memory_resource {
    bool fails = false;
    void* do_allocate(std::size_t bytes, std::size_t align) override {
      if (fails) throw std::bad_alloc();
      return std::pmr::new_delete_resource()->allocate(bytes, align);
    }
    void do_deallocate(void* p, std::size_t bytes, std::size_t align) override {
      std::pmr::new_delete_resource()->deallocate(p, bytes, align);
    }
    bool do_is_equal(const memory_resource& o) const noexcept override { return this == &o; }
  } memory;
  World world(1, Vec3::zero(), 0, &memory);
  TestWorld shapes;
  const Shape* ball = shapes.keep(sphere(0.5));
  BodyDef def;
  for (int i = 0; i < 2; ++i) {
    def.pose.p = Vec3(3 * i, 0, 0);
    world.add_collider(handle_slot(world.add_body(def)), ball, Pose{}, 1000, Colliders::kNoMaterial);
  }
  world.step(1.0 / 60);
  world.set_dial(Dial::broad_phase, 2);  // whose first call allocates
  world.add_force(0, Vec3(1, 0, 0), Vec3::zero());
  memory.fails = true;
  bool failed = false;
  try {
    world.step(1.0 / 60);
  } catch (const std::bad_alloc&) {
    failed = true;
  }
  memory.fails = false;
  assert_true(failed);
  assert_true(world.state.v[0] == Vec3::zero());
  for (int i = 0; i < 3; ++i) world.step(1.0 / 60);
  const Real once = world.scene.inv_mass[0] / 60;
  assert_true(std::fabs(world.state.v[0].x() - once) <= 4 * kEpsilon * once);
}

static void decay_is_the_exponential(void**) {
  for (Real x = 0; x < 699; x += 0.1375) {
    const long double want = std::exp(-static_cast<long double>(x));
    assert_true(std::fabs(static_cast<Real>((decay(x) - want) / want)) <= 2 * kEpsilon);
  }
  assert_true(decay(0) == 1 && decay(1e6) == 0 && decay(1e300) == 0);
}

static void mixing_follows_the_larger_rule(void**) {
  assert_true(mix(Mix::geometric_mean, 4, Mix::geometric_mean, 9) == 6);
  assert_true(mix(Mix::geometric_mean, 4, Mix::maximum, 9) == 9);
  assert_true(mix(Mix::minimum, 4, Mix::maximum, 9) == 4);
  assert_true(mix(Mix::average, 4, Mix::minimum, 9) == 6.5);
  assert_true(mix(Mix::multiply, 4, Mix::average, 9) == 36);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_world_of_particles_runs_integration_and_nothing_else),
      cmocka_unit_test(times_of_stages_add_up_to_the_step),
      cmocka_unit_test(each_effect_serves_its_participants_alone),
      cmocka_unit_test(without_gravity_there_is_no_gravity_effect),
      cmocka_unit_test(rk4_evaluates_forces_four_times),
      cmocka_unit_test(friction_and_restitution_count_the_contacts_that_have_them),
      cmocka_unit_test(a_pile_at_rest_allocates_nothing),
      cmocka_unit_test(a_body_that_cannot_rotate_turns_by_its_hosts_hand),
      cmocka_unit_test(a_force_lives_for_one_step_also_after_one_that_failed),
      cmocka_unit_test(decay_is_the_exponential),
      cmocka_unit_test(mixing_follows_the_larger_rule),
  };
  return cmocka_run_group_tests_name("dynamics/effects", tests, nullptr, nullptr);
}
