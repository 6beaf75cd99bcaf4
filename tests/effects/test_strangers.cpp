// What a body does never depends on bodies that it never meets: the same bits with and without them, whatever acts on it,
// at any substeps and integrator; and what nobody notices costs nothing.
#include <cmath>
#include <string>

#include "carom_test.h"
#include "dynamics/plan_view.h"
#include "dynamics/presets.h"
#include "subjects.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kFar = 1000;  // m

/// A ball at rest on a box, a pendulum, a bullet, what air and damping stop at once, springs of another rate, what turns
/// by a host's hand among what stands, particles: kilometres away.
void add_strangers(TestWorld& t) {
  World& w = t.world;
  const Shape *ball = t.keep(sphere(0.5)), *cube = t.keep(box(Vec3::constant(0.5)));
  const auto place = [](int k, Real x = 0) { return Vec3(kFar * k + x, 60, 0); };
  t.add(cube, place(1), BodyType::fixed);
  t.add(ball, place(1, 0.99));
  JointDef hinge;
  hinge.kind = JointKind::hinge;
  hinge.body_a = t.add(cube, place(2));
  hinge.frame_b.p = place(2, 0.7);
  w.add_joint(hinge);
  const std::uint32_t bullet = t.add(ball, place(-5));
  w.set_continuous(bullet, SweepMode::always);
  w.set_velocity(bullet, Vec3(0, 0, 3000), Vec3::zero());
  BodyDef stiff;
  stiff.pose.p = place(4), stiff.velocity = Vec3(1, 2, 3), stiff.omega = Vec3(3, 2, 1);
  stiff.linear_damping = stiff.angular_damping = 1e5;
  stiff.has_mass = stiff.has_inertia = true, stiff.mass = 1, stiff.inertia = Mat3::diagonal(Vec3(1, 2, 2.5));
  w.set_attribute(handle_slot(w.add_body(stiff)), AttributeId::drag, {1e4, 1e4});
  SpringDef spring;
  spring.body_a = t.add(ball, place(6)), spring.body_b = t.add(ball, place(6, 4));
  spring.rest = 1, spring.stiffness = 1e6, spring.damping = 100;
  w.add_spring(spring);
  const std::uint32_t driven = t.add(cube, place(7), BodyType::kinematic);
  w.set_velocity(driven, Vec3(1, 0, 0), Vec3(0, 1, 0));
  for (int i = 0; i < 5; ++i) t.add(cube, place(7, i), BodyType::fixed);
  w.particles.extend(handle_slot(w.particles.create({}, 1)), 3);
}

void assert_same(const TestWorld& one, const TestWorld& other, std::uint32_t bodies, const char* what) {
  const State &a = one.world.state, &b = other.world.state;
  for (std::uint32_t i = 0; i < bodies; ++i) {
    if (a.x[i] == b.x[i] && a.q[i] == b.q[i] && a.v[i] == b.v[i] && a.omega[i] == b.omega[i]) continue;
    print_error("%s: body %u differs, by %g m\n", what, i, (a.x[i] - b.x[i]).norm());
    assert_true(false);
  }
}

/// What asks for orientations and inertias of all in the middle of a step: a block that the direct solver holds on a
/// light one, a ball that resists rolling, and one that bounces.
void add_strangers_on_the_ground(TestWorld& t) {
  World& w = t.world;
  Material rough;
  rough.rolling = 0.01, rough.spinning = 0.01;
  const std::uint32_t resists = handle_slot(w.add_material(rough)), bounces = t.material(0.4, 0.8);
  const auto place = [](int k, Real y) { return Vec3(-kFar * k, y, 0.1); };
  t.add(t.keep(box(Vec3::constant(0.1))), place(1, 0.1));
  t.add(t.keep(box(Vec3::constant(1))), place(1, 1.2));
  const std::uint32_t ball = t.add(t.keep(sphere(0.5)), place(2, 0.499), BodyType::dynamic, Quat::identity(), resists);
  w.set_velocity(ball, Vec3(1, 0, 0.3), Vec3(0.2, 3, 0));
  t.add(t.keep(sphere(0.5)), place(3, 2), BodyType::dynamic, Quat::identity(), bounces);
}

/// Each by itself: a rod that slides and turns, one that rolls, a box that slides and spins, a plate that falls flat.
void add_sliders(TestWorld& t) {
  const std::uint32_t m = t.material(0.4, 0);
  t.ground(m);
  const Quat lying = normalized(Quat(1, 0, 0, 1));
  const auto add = [&](int k, const Shape& shape, Real y, const Quat& q, const Vec3& v, const Vec3& omega) {
    t.world.set_velocity(t.add(t.keep(shape), Vec3(5 * k, y, 0), BodyType::dynamic, q, m), v, omega);
  };
  add(0, cylinder(0.2, 0.6), 0.2, lying, Vec3(2, 0, 1), Vec3(0.1, 3, 0));
  add(1, cylinder(0.3, 0.4), 0.3, lying, Vec3(0, 0, 3), Vec3(10, 0.4, 0));
  add(2, box(Vec3(0.5, 0.1, 0.3)), 0.1, Quat::identity(), Vec3(3, 0, 0.2), Vec3(0, 6, 0));
  add(3, box(Vec3(0.4, 0.02, 0.4)), 0.5, normalized(Quat(1, 0.1, 0, 0.05)), Vec3(1, 0, 0), Vec3(0, 2, 0));
}

/// Steps of a scene alone and beside strangers.
template <class Make>
void compare(const Make& make, const char* what) {
  for (int integrator = 0; integrator < 4; ++integrator)
    for (const Real substeps : {1, 3, 4, 16})
      for (const bool ledger : {false, true}) {
        TestWorld alone, among;
        for (TestWorld* t : {&alone, &among}) {
          t->world.set_dial(Dial::integrator, integrator), t->world.set_dial(Dial::substeps, substeps);
          make(*t);
        }
        const std::uint32_t bodies = alone.world.scene.bodies.slots();
        add_strangers(among);
        among.world.keep_ledger(ledger);
        for (int k = 0; k < 40; ++k) {
          alone.run(1, 1.0 / 60), among.run(1, 1.0 / 60);
          assert_same(alone, among, bodies, what);
        }
      }
}

std::uint32_t add_body(TestWorld& t, const Vec3& x, const Vec3& v, const Vec3& inertia = Vec3::constant(0.3)) {
  BodyDef def;
  def.pose.p = x, def.velocity = v, def.omega = Vec3(1, -2, 0.5);
  def.has_mass = def.has_inertia = true, def.mass = 2, def.inertia = Mat3::diagonal(inertia);
  return handle_slot(t.world.add_body(def));
}

/// Two masses between three springs, and one that the air brakes.
void three_springs(TestWorld& t) {
  const std::uint32_t a = add_body(t, Vec3(1.2, 0, 0), Vec3::zero()), b = add_body(t, Vec3(2, 0, 0), Vec3::zero());
  SpringDef s;
  s.rest = 1, s.stiffness = 100;
  s.body_a = a, s.anchor_b = Vec3::zero();
  t.world.add_spring(s);
  s.body_b = b;
  t.world.add_spring(s);
  s.body_a = b, s.body_b = kInvalid, s.anchor_b = Vec3(3, 0, 0), s.damping = 0.5;
  t.world.add_spring(s);
  t.world.set_attribute(add_body(t, Vec3(0, 50, 0), Vec3(20, 10, 0)), AttributeId::drag, {0.1, 0.05});
}

/// A brick that tumbles and is damped, a dipole in a field, one that floats, one with a locked axis, and balls that fly.
void many_forces(TestWorld& t) {
  BodyDef brick;
  brick.pose.p = Vec3(5, 20, 0), brick.omega = Vec3(3, 0.1, 2), brick.linear_damping = 0.7, brick.angular_damping = 2;
  brick.has_mass = brick.has_inertia = true, brick.mass = 3, brick.inertia = Mat3::diagonal(Vec3(0.1, 0.2, 0.25));
  t.world.add_body(brick);
  FieldDef f;
  f.kind = FieldKind::magnetic, f.vector = Vec3(0, 2, 0), f.mask = 3;
  t.world.add_field(f);
  const std::uint32_t magnet = add_body(t, Vec3(8, 20, 0), Vec3(1, 0, 0), Vec3(0.1, 0.2, 0.15));
  t.world.set_attribute(magnet, AttributeId::magnetic_moment, {3, 0, 1});
  WaterDef water;
  water.drag = 1;
  t.world.set_water(&water);
  t.add(t.keep(sphere(0.3)), Vec3(0, 0.1, 9)), t.add(t.keep(box(Vec3(0.3, 0.1, 0.2))), Vec3(4, -1, 9));
  t.world.set_attribute(add_body(t, Vec3(12, 20, 0), Vec3(1, 2, 3)), AttributeId::locks, {Real(1)});
  for (int i = 0; i < 4; ++i) {
    const std::uint32_t ball = t.add(t.keep(sphere(0.2)), Vec3(3 * i, 200, 0));
    t.world.set_velocity(ball, Vec3(0.1 * i, 3, -1), Vec3(0.3, i, 2));
  }
}

/// A pendulum, a body that a host drives, and one that hangs on it by a spring.
void joints_and_hands(TestWorld& t) {
  const Shape* cube = t.keep(box(Vec3(0.1, 0.2, 0.3)));
  JointDef ball;
  ball.body_a = t.add(cube, Vec3(0, 20, 0));
  ball.frame_a.p = Vec3(1, 0.3, 0), ball.frame_b.p = Vec3(1, 20.3, 0);
  t.world.add_joint(ball);
  const std::uint32_t hand = t.add(cube, Vec3(6, 20, 0), BodyType::kinematic);
  t.world.set_velocity(hand, Vec3(0.1, 0.2, 0.3), Vec3(0.7, -3, 1));
  SpringDef s;
  s.body_a = hand, s.body_b = t.add(t.keep(sphere(0.2)), Vec3(8, 20, 0)), s.rest = 1, s.stiffness = 300, s.damping = 1;
  t.world.add_spring(s);
}

/// A body that a host drives, alone: nobody asks for substeps.
void one_hand(TestWorld& t) {
  const std::uint32_t hand = t.add(t.keep(box(Vec3(0.1, 0.2, 0.3))), Vec3(6, 20, 0), BodyType::kinematic);
  t.world.set_velocity(hand, Vec3(0.1, 0.2, 0.3), Vec3(0.7, -3, 1));
}

/// m: how far a mass on springs is off its closed form, at most in 5 s.
Real error_of_springs(Preset preset) {
  TestWorld t(Vec3::zero());
  for (std::size_t d = 0; d < kDialCount; ++d)
    if (const auto value = preset_value(preset, static_cast<Dial>(d))) t.world.set_dial(static_cast<Dial>(d), *value);
  three_springs(t);
  t.world.scene.springs.def[2].damping = 0, ++t.world.scene.revision;
  const Real slow = std::sqrt(100 / 2.0), fast = std::sqrt(3 * 100 / 2.0);
  Real worst = 0;
  for (int i = 1; i <= 300; ++i) {
    t.run(1, 1.0 / 60);
    const Real s = i / 60.0;
    worst =
        std::max(worst, std::fabs(t.world.state.x[0].x() - (1 + 0.1 * std::cos(slow * s) + 0.1 * std::cos(fast * s))));
  }
  return worst;
}

}  // namespace

static void every_effect_acts_alike_beside_strangers(void**) {
  for (const Subject& subject : subjects()) {
    if (!subject.flies || subject.row == +EffectId::events || subject.row == +EffectId::sleep ||
        subject.row == +EffectId::ledger)
      continue;
    for (int integrator = 0; integrator < 4; ++integrator)
      for (const Real substeps : {1, 4, 7}) {
        Stage0 alone, among;
        for (Stage0* s : {&alone, &among}) {
          s->t.world.set_dial(Dial::integrator, integrator), s->t.world.set_dial(Dial::substeps, substeps);
          subject.call(*s);
        }
        const std::uint32_t bodies = alone.t.world.scene.bodies.slots();
        add_strangers(among.t);
        alone.steps(30), among.steps(30);
        assert_same(alone.t, among.t, bodies, effect_table()[subject.row].name);
      }
  }
}

static void springs_and_air_know_no_strangers(void**) { compare(three_springs, "springs"); }
static void forces_know_no_strangers(void**) { compare(many_forces, "forces"); }
static void joints_and_hands_know_no_strangers(void**) {
  compare(joints_and_hands, "joints"), compare(one_hand, "hand");
}

static void what_slides_knows_no_strangers(void**) {
  for (int solver = 0; solver < kSolverChoices; ++solver)
    for (const Real substeps : {1, 4})
      for (const Real hz : {64, 50}) {
        TestWorld alone, among;
        for (TestWorld* t : {&alone, &among}) {
          t->world.set_dial(Dial::solver, solver), t->world.set_dial(Dial::substeps, substeps);
          add_sliders(*t);
        }
        const std::uint32_t bodies = alone.world.scene.bodies.slots();
        add_strangers_on_the_ground(among);
        for (int k = 0; k < 90; ++k) {
          alone.run(1, 1 / hz), among.run(1, 1 / hz);
          assert_same(alone, among, bodies, ("sliders, solver " + std::to_string(solver)).c_str());
        }
      }
}

static void presets_act_without_colliders(void**) {
  const Real fast = error_of_springs(Preset::fast), balanced = error_of_springs(Preset::balanced),
             accurate = error_of_springs(Preset::accurate);
  print_message("springs: fast %.2g m, balanced %.2g m, accurate %.2g m\n", fast, balanced, accurate);
  assert_true(balanced < fast / 8 && accurate < balanced / 8);  // 1 and 4 substeps of second order, 8 of fourth
}

static void who_only_drives_among_what_stands_makes_no_pairs(void**) {
  TestWorld t;
  const Shape* cube = t.keep(box(Vec3::constant(0.5)));
  for (int i = 0; i < 50; ++i) t.add(cube, Vec3(1.5 * i, 0, 0), BodyType::fixed);
  std::uint32_t hand = 0;
  for (int i = 0; i < 10; ++i)
    t.world.set_velocity(hand = t.add(cube, Vec3(6 * i, 0.7, 0), BodyType::kinematic), Vec3(1, 0, 0), Vec3::zero());
  for (Real broad = 0; broad < 4; ++broad) {
    t.world.set_dial(Dial::broad_phase, broad);
    t.run(2, 1.0 / 60);
    assert_int_equal(t.world.report.broad_pairs, 0);
    assert_false(t.world.plan->runs[static_cast<std::size_t>(Stage::broad)]);
  }
  // Nor with a ball far away; what touches the ball is found all the same.
  const std::uint32_t ball = t.add(t.keep(sphere(0.5)), Vec3(0, 500, 0));
  for (Real broad = 0; broad < 4; ++broad) {
    t.world.set_dial(Dial::broad_phase, broad);
    t.run(2, 1.0 / 60);
    assert_int_equal(t.world.report.broad_pairs, 0);
  }
  Pose there;
  there.p = t.world.pose(hand).p + Vec3(0, 0.99, 0);
  t.world.set_pose(ball, there);
  for (Real broad = 0; broad < 4; ++broad) {
    t.world.set_dial(Dial::broad_phase, broad);
    t.run(1, 1.0 / 60);
    assert_true(t.world.report.broad_pairs > 0 && t.world.report.contact_points > 0);
  }
  // What senses notices, whether it moves or stands, and no longer once it is no sensor.
  t.world.remove_body(ball);
  const std::uint32_t slot = t.world.scene.first_collider[0];
  t.world.set_pose(hand, Pose{});
  for (Real broad = 0; broad < 4; ++broad) {
    t.world.set_dial(Dial::broad_phase, broad);
    t.world.set_sensor(slot, true);
    collect(t.world, Events::sensor, 1);
    t.run(1, 1e-3);
    assert_true(t.world.events->within.size() > 0);
    t.world.set_sensor(slot, false);
    t.run(1, 1e-3);
    assert_int_equal(t.world.events->within.size(), 0);
    assert_int_equal(t.world.report.broad_pairs, 0);
  }
}

static void the_plan_says_that_all_sleep(void**) {
  TestWorld t;
  t.world.set_dial(Dial::sleep, 1);
  t.ground();
  const std::uint32_t cube = t.add(t.keep(box(Vec3::constant(0.5))), Vec3(0, 0.5, 0));
  t.run(300, 1.0 / 60);
  assert_true(t.world.state.sleeps(cube));
  const auto says = [&](std::size_t line) { return std::string(plan_line(t.world, line).reason); };
  for (const Stage s : {Stage::broad, Stage::narrow, Stage::group, Stage::integrate, Stage::solve, Stage::relax})
    assert_true(says(static_cast<std::size_t>(s)) == "all asleep");
  assert_true(says(kStageCount + +EffectId::gravity) == "all asleep");
  assert_true(says(kStageCount + +EffectId::collision) == "all asleep");
  assert_true(says(kStageCount + +EffectId::drag) ==
              effect_table()[+EffectId::drag].missing);  // nobody has any, awake or not
  t.world.set_velocity(cube, Vec3(0, 3, 0), Vec3::zero());
  t.run(1, 1.0 / 60);
  assert_true(says(kStageCount + +EffectId::gravity) == effect_table()[+EffectId::gravity].called_by);
}

int main(void) {
  const CMUnitTest tests[] = {
      cmocka_unit_test(every_effect_acts_alike_beside_strangers),
      cmocka_unit_test(springs_and_air_know_no_strangers),
      cmocka_unit_test(forces_know_no_strangers),
      cmocka_unit_test(joints_and_hands_know_no_strangers),
      cmocka_unit_test(what_slides_knows_no_strangers),
      cmocka_unit_test(presets_act_without_colliders),
      cmocka_unit_test(who_only_drives_among_what_stands_makes_no_pairs),
      cmocka_unit_test(the_plan_says_that_all_sleep),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
