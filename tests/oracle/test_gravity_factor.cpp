// Bodies that gravity pulls by a factor of their own, against closed forms and against worlds with another gravity.
#include "carom_test.h"
#include "dynamics/contact_views.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kG = 9.81;
constexpr Real kVerlet = 3;

std::uint32_t thrown(TestWorld& t, const Vec3& velocity, Real factor) {
  BodyDef def;
  def.velocity = velocity;
  const std::uint32_t body = handle_slot(t.world.add_body(def));
  t.world.set_attribute(body, AttributeId::gravity_factor, {factor});
  return body;
}

/// N s: what a world's contacts press in a step.
Real pressed(const World& world) {
  Real sum = 0;
  for (const ContactView& view : world.contact_views()) sum += view.normal_impulse;
  return sum;
}

/// A pile that `factor` times `gravity` pulls together, after a second.
std::uint64_t pile(std::uint32_t solver, const Vec3& gravity, Real factor) {
  TestWorld t(gravity);
  t.world.set_dial(Dial::solver, solver);
  t.ground();
  const Shape *cube = t.keep(box(Vec3::constant(0.5))), *ball = t.keep(sphere(0.4));
  std::vector<std::uint32_t> bodies;
  for (int i = 0; i < 6; ++i) bodies.push_back(t.add(cube, Vec3(0, 0.5 + i, 0)));  // enough for auto to see it sink
  for (int i = 0; i < 4; ++i) bodies.push_back(t.add(ball, Vec3(3 + 0.3 * i, 0.6 + i, 0.1 * i)));
  for (const std::uint32_t body : bodies) t.world.set_attribute(body, AttributeId::gravity_factor, {factor});
  t.run(60, 1.0 / 60);
  return t.world.hash();
}

}  // namespace

static void a_body_falls_by_its_factor(void**) {
  const Vec3 v0(3, 1, -2);
  TestWorld t(Vec3(0, -kG, 0));
  t.world.set_dial(Dial::integrator, kVerlet);
  const Real factors[] = {1, 0, -1, 2.5, 1.0 / 6};
  std::vector<std::uint32_t> bodies;
  for (const Real f : factors) bodies.push_back(thrown(t, v0, f));
  constexpr int kSteps = 120;
  const Real T = 2;
  t.run(kSteps, T / kSteps);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Vec3 want = v0 * T + factors[i] * Vec3(0, -kG, 0) * (T * T / 2);  // exact but for a rounding a step
    assert_true((t.world.state.x[bodies[i]] - want).norm() < kSteps * kEpsilon * (want.norm() + 10));
  }
  const PlannedEffect* gravity = t.world.plan->find("gravity");
  assert_int_equal(gravity->participants.count, 4);        // what floats is none
  assert_int_equal(gravity->evaluations, 2 * 4 * kSteps);  // Verlet kicks twice
}

static void only_bodies_that_float_leave_nothing_to_do(void**) {
  TestWorld t(Vec3(0, -kG, 0));
  for (int i = 0; i < 3; ++i) thrown(t, Vec3(1, 0, 0), 0);
  t.run(60, 1.0 / 60);
  assert_int_equal(t.world.plan->find("gravity")->evaluations, 0);
  for (std::uint32_t i = 0; i < 3; ++i) assert_true(t.world.state.v[i] == Vec3(1, 0, 0));
}

static void a_slot_that_is_used_again_has_the_factor_of_a_new_body(void**) {
  TestWorld t(Vec3(0, -kG, 0));
  const std::uint32_t first = thrown(t, Vec3::zero(), 0);
  t.world.remove_body(first);
  const std::uint32_t second = handle_slot(t.world.add_body(BodyDef{}));
  assert_int_equal(first, second);
  assert_true(t.world.scene.gravity_factor_of(second) == 1);
}

static void contacts_bear_the_weight_that_there_is(void**) {
  for (std::uint32_t solver = 0; solver < kSolverChoices; ++solver)
    for (const Real factor : {0.25, 3.0, -2.0}) {
      TestWorld t(Vec3(0, -kG, 0));
      t.world.set_dial(Dial::solver, solver);
      t.world.set_dial(Dial::velocity_tolerance, 1e-8);
      t.ground();
      t.add(t.keep(box(Vec3(5, 0.5, 5))), Vec3(0, 1.5, 0), BodyType::fixed);  // 1 m above it, a ceiling
      const std::uint32_t body = t.add(t.keep(box(Vec3::constant(0.5))), Vec3(0, 0.5, 0));
      t.world.set_attribute(body, AttributeId::gravity_factor, {factor});
      t.run(120, 1.0 / 60);
      // Tolerance 1e-8 m/s of 0.04 m/s a step, for each of 4 points; springs of the soft solver have long come to rest.
      const Real weight = std::fabs(factor) * t.world.scene.mass[body] * kG / 60;
      assert_true(std::fabs(pressed(t.world) - weight) < 1e-5 * weight);
      Real up = 0;  // impulse on the body
      for (const ContactView& v : t.world.contact_views()) {
        const bool is_b = t.world.scene.colliders.body[v.collider_b] == body;
        up += (is_b ? 1 : -1) * v.normal.y() * v.normal_impulse;
      }
      assert_true((up > 0) == (factor > 0));
    }
}

// 2 (h g) and h (2 g) are the same number, so whatever looks at gravity on its way must have looked at both.
static void a_factor_for_all_is_another_gravity_to_the_bit(void**) {
  for (std::uint32_t solver = 0; solver < kSolverChoices; ++solver)
    for (const Real factor : {0.5, 4.0}) {
      const Vec3 g(0, -kG, 0);
      assert_true(pile(solver, g, factor) == pile(solver, factor * g, 1));
      assert_true(pile(solver, g, factor) != pile(solver, g, 1));
    }
}

static void a_sleeper_whose_factor_changes_wakes(void**) {
  TestWorld t(Vec3(0, -kG, 0));
  t.world.set_dial(Dial::sleep, 1);
  t.ground();
  const std::uint32_t body = t.add(t.keep(box(Vec3::constant(0.5))), Vec3(0, 0.5, 0));
  t.run(180, 1.0 / 60);
  assert_true(t.world.asleep(body));
  t.world.set_attribute(body, AttributeId::gravity_factor, {-1});
  t.run(60, 1.0 / 60);
  assert_true(!t.world.asleep(body) && t.world.state.x[body].y() > 1);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_body_falls_by_its_factor),
      cmocka_unit_test(only_bodies_that_float_leave_nothing_to_do),
      cmocka_unit_test(a_slot_that_is_used_again_has_the_factor_of_a_new_body),
      cmocka_unit_test(contacts_bear_the_weight_that_there_is),
      cmocka_unit_test(a_factor_for_all_is_another_gravity_to_the_bit),
      cmocka_unit_test(a_sleeper_whose_factor_changes_wakes),
  };
  return cmocka_run_group_tests_name("oracle/gravity_factor", tests, nullptr, nullptr);
}
