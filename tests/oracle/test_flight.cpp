// Flight without contacts against closed forms: order of the error in h for each integrator, drag, and the torque-free
// top.
//
// An integrator of order p halves h to divide its error by 2^p; slopes are read between two halvings far above
// rounding. The next term of the error is of relative size h times a rate of the problem (at most 0.1 here, so the
// slope is within 0.15).
#include "carom_test.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kExplicitEuler = 0, kSemiImplicit = 1, kRk4 = 2;

Real slope(Real coarse, Real fine) { return std::log2(coarse / fine); }

/// m: position error after T of a body thrown in gravity with linear damping c, h = T/n.
///   x(T) = v_t T + (v_0 - v_t) (1 - e^-cT)/c,  v_t = g/c;  without damping the parabola.
Real drag_error(Real integrator, Real c, int n) {
  const Real T = 2;
  const Vec3 g(0, -9.8, 0), v0(3, 1, 4);
  TestWorld t(g);
  t.world.set_dial(Dial::integrator, integrator);
  t.world.set_dial(Dial::substeps, 1);  // laws are of the step
  BodyDef def;
  def.velocity = v0;
  def.linear_damping = c;
  const std::uint32_t b = handle_slot(t.world.add_body(def));
  t.run(n, T / n);
  const Vec3 want =
      c > 0 ? Vec3(g / c * T + (v0 - g / c) * ((1 - std::exp(-c * T)) / c)) : Vec3(v0 * T + g * (T * T / 2));
  return (t.world.state.x[b] - want).norm();
}

struct Top {
  Quat q;
  Vec3 momentum;
  Real energy;
};

/// A box 1 x 2 x 3 m left spinning for T = 2 s in n steps.
Top spin(Real integrator, Real rotation, int n) {
  TestWorld t(Vec3::zero());
  t.world.set_dial(Dial::integrator, integrator);
  t.world.set_dial(Dial::rotation, rotation);
  t.world.set_dial(Dial::substeps, 1);  // laws are of the step
  const std::uint32_t b = t.add(t.keep(box(Vec3(0.5, 1, 1.5))), Vec3::zero());
  t.world.set_velocity(b, Vec3::zero(), Vec3(4, 1, 2));
  t.run(n, 2.0 / n);
  const Quat& q = t.world.state.q[b];
  const Mat3& inertia = t.world.scene.inertia[b];
  const Vec3 w = q.conjugate() * t.world.state.omega[b];
  return {q, q * (inertia * w), 0.5 * w.dot(inertia * w)};
}

Real angle(const Quat& a, const Quat& b) { return 2 * (a.conjugate() * b).vec().norm(); }

}  // namespace

static void free_fall_has_the_error_that_theory_gives(void**) {
  // Exactly: x_n - x(T) = -+ g T h/2 for explicit and semi-implicit Euler; RK4 is exact. n roundings of terms below 20
  // m.
  for (int n : {60, 120, 240}) {
    const Real euler = 9.8 * 2 * (2.0 / n) / 2, rounding = 20 * n * kEpsilon;
    assert_true(std::fabs(drag_error(kExplicitEuler, 0, n) - euler) < rounding);
    assert_true(std::fabs(drag_error(kSemiImplicit, 0, n) - euler) < rounding);
    assert_true(drag_error(kRk4, 0, n) < rounding);
  }
}

static void drag_converges_with_orders_one_one_and_four(void**) {
  const Real c = 0.8;  // c h = 0.1 at n = 16
  for (int n : {64, 128}) {
    const Real e = slope(drag_error(kExplicitEuler, c, n), drag_error(kExplicitEuler, c, 2 * n));
    const Real s = slope(drag_error(kSemiImplicit, c, n), drag_error(kSemiImplicit, c, 2 * n));
    assert_true(e > 0.85 && e < 1.15);
    assert_true(s > 0.85 && s < 1.15);
  }
  const Real r = slope(drag_error(kRk4, c, 16), drag_error(kRk4, c, 32));
  assert_true(r > 3.85 && r < 4.15);
}

static void damping_alone_is_exact_at_any_step_and_stable_at_any_rate(void**) {
  for (const Real integrator : {kExplicitEuler, kSemiImplicit, kRk4}) {
    for (const Real c : {0.5, 100.0, 1e6}) {
      TestWorld t(Vec3::zero());
      t.world.set_dial(Dial::integrator, integrator);
      t.world.set_dial(Dial::substeps, 1);  // laws are of the step
      BodyDef def;
      def.velocity = Vec3(1, 2, 3);
      def.linear_damping = c;
      const std::uint32_t b = handle_slot(t.world.add_body(def));
      t.run(30, 1.0 / 60);
      const Real want = std::exp(-c / 2);
      // RK4 integrates slow decay as a force: local error (c h)^5/120 a step. Flows round 30 times.
      const Real ch = c / 60, method = integrator == kRk4 && ch < 1 ? 30 * std::pow(ch, 5) / 120 : 0;
      assert_true((t.world.state.v[b] - want * Vec3(1, 2, 3)).norm() <= 4 * want * (method + 60 * kEpsilon));
    }
  }
}

static void the_torque_free_top_converges_to_itself_and_keeps_its_momentum(void**) {
  const Top exact = spin(kRk4, 1, 4096);
  const Real m = 1000 * 6;
  const Vec3 l0(m / 12 * 13 * 4, m / 12 * 10 * 1, m / 12 * 5 * 2);
  const Real e0 = 0.5 * l0.dot(Vec3(4, 1, 2));
  Real angle_error[2], l_error[2], e_error[2];
  for (int k = 0; k < 2; ++k) {
    const Top top = spin(kRk4, 1, 64 << k);
    angle_error[k] = angle(top.q, exact.q);
    l_error[k] = (top.momentum - l0).norm() / l0.norm();
    e_error[k] = std::fabs(top.energy - e0) / e0;
  }
  // h |omega| = 0.14 and 0.07: the next term is within 0.3 of the slope. Invariants may do better than the pose, not
  // worse.
  assert_true(std::fabs(slope(angle_error[0], angle_error[1]) - 4) < 0.4);
  assert_true(slope(l_error[0], l_error[1]) > 3.6);
  assert_true(slope(e_error[0], e_error[1]) > 3.6);
  assert_true((exact.momentum - l0).norm() < 1e-9 * l0.norm());
}

static void gyroscopic_dials_under_euler_are_of_first_order(void**) {
  const Top exact = spin(kRk4, 1, 4096);
  for (const Real rotation : {1.0, 2.0}) {
    const Real coarse = angle(spin(kSemiImplicit, rotation, 2048).q, exact.q);
    const Real fine = angle(spin(kSemiImplicit, rotation, 4096).q, exact.q);
    assert_true(std::fabs(slope(coarse, fine) - 1) < 0.15);
  }
  // Without the term the body keeps its spin in the world, which is wrong by a finite angle at every h.
  assert_true(angle(spin(kSemiImplicit, 0, 4096).q, exact.q) > 0.1);
}

static void the_implicit_step_never_gains_energy(void**) {
  const Real e0 = spin(kRk4, 1, 4096).energy;
  for (int n : {20, 60, 240}) {
    const Top top = spin(kSemiImplicit, 2, n);
    assert_true(top.energy <= e0 * (1 + 1e-9));
  }
}

static void a_force_acts_for_one_step_and_a_torque_turns_about_the_centre(void**) {
  for (const Real integrator : {kExplicitEuler, kSemiImplicit, kRk4}) {
    TestWorld t(Vec3::zero());
    t.world.set_dial(Dial::integrator, integrator);
    const std::uint32_t b = t.add(t.keep(sphere(0.5)), Vec3::zero());
    const Real m = t.world.scene.mass[b], i = 0.4 * m * 0.25;
    t.world.add_force(b, Vec3(m, 0, 0), Vec3(0, i, 0));
    t.world.set_dial(Dial::substeps, 4);  // the force lasts through all substeps of its step
    t.run(5, 0.1);
    assert_true((t.world.state.v[b] - Vec3(0.1, 0, 0)).norm() < 1e-15);
    assert_true((t.world.state.omega[b] - Vec3(0, 0.1, 0)).norm() < 1e-15);
  }
}

static void a_kinematic_body_moves_by_its_velocity(void**) {
  TestWorld t;
  const std::uint32_t b = t.add(t.keep(sphere(0.5)), Vec3(1, 2, 3), BodyType::kinematic);
  t.world.set_velocity(b, Vec3(1, 0, 0), Vec3(0, 1, 0));
  t.run(60, 1.0 / 60);
  assert_true((t.world.state.x[b] - Vec3(2, 2, 3)).norm() < 60 * 4 * kEpsilon);
  assert_true(angle(t.world.state.q[b], exp_map(Vec3(0, 1, 0))) < 60 * 4 * kEpsilon);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(free_fall_has_the_error_that_theory_gives),
      cmocka_unit_test(drag_converges_with_orders_one_one_and_four),
      cmocka_unit_test(damping_alone_is_exact_at_any_step_and_stable_at_any_rate),
      cmocka_unit_test(the_torque_free_top_converges_to_itself_and_keeps_its_momentum),
      cmocka_unit_test(gyroscopic_dials_under_euler_are_of_first_order),
      cmocka_unit_test(the_implicit_step_never_gains_energy),
      cmocka_unit_test(a_force_acts_for_one_step_and_a_torque_turns_about_the_centre),
      cmocka_unit_test(a_kinematic_body_moves_by_its_velocity),
  };
  return cmocka_run_group_tests_name("oracle/flight", tests, nullptr, nullptr);
}
