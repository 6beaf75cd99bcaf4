// Particles of a set against closed forms of flight (order of the error in h for each integrator, with and without
// drag), and against their slow twin: a body without a shape, whose bits they must have.
#include "carom_test.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kExplicitEuler = 0, kSemiImplicit = 1, kRk4 = 2, kVerlet = 3;
constexpr Real kIntegrators[] = {kExplicitEuler, kSemiImplicit, kRk4, kVerlet};

std::uint32_t add_set(World& world, const ParticleDef& def) { return handle_slot(world.particles.create(def, 0)); }
void throw_one(World& world, std::uint32_t set, const Vec3& x, const Vec3& v) {
  const std::size_t i = world.particles.extend(set, 1);
  world.particles.place(set, i, x);
  world.particles.set_velocity(set, i, v);
}

Real slope(Real coarse, Real fine) { return std::log2(coarse / fine); }

/// m: position error after T of a particle thrown in gravity with drag c, h = T/n.
///   x(T) = v_t T + (v_0 - v_t) (1 - e^-cT)/c,  v_t = f g/c;  without drag the parabola.
Real flight_error(Real integrator, Real c, Real factor, int n) {
  const Real T = 2;
  const Vec3 g(0, -9.8, 0), v0(3, 1, 4);
  TestWorld t(g);
  t.world.set_dial(Dial::integrator, integrator);
  t.world.set_dial(Dial::substeps, 1);  // laws are of the step
  const std::uint32_t s = add_set(t.world, {factor, c, 1});
  throw_one(t.world, s, Vec3::zero(), v0);
  t.run(n, T / n);
  const Vec3 fg = factor * g;
  const Vec3 want =
      c > 0 ? Vec3(fg / c * T + (v0 - fg / c) * ((1 - std::exp(-c * T)) / c)) : Vec3(v0 * T + fg * (T * T / 2));
  return (t.world.particles.set[s].position(0) - want).norm();
}

}  // namespace

static void free_fall_has_the_error_that_theory_gives(void**) {
  // Exactly: |x_n - x(T)| = f g T h/2 for both Eulers; RK4 and Verlet are exact. n roundings of terms below 20 f m.
  for (const Real factor : {1.0, 0.25, -3.0})
    for (const int n : {60, 120, 240}) {
      const Real f = std::fabs(factor), euler = f * 9.8 * 2 * (2.0 / n) / 2;
      const Real rounding = 20 * std::max(f, Real(1)) * n * kEpsilon;
      assert_true(std::fabs(flight_error(kExplicitEuler, 0, factor, n) - euler) < rounding);
      assert_true(std::fabs(flight_error(kSemiImplicit, 0, factor, n) - euler) < rounding);
      assert_true(flight_error(kRk4, 0, factor, n) < rounding);
      assert_true(flight_error(kVerlet, 0, factor, n) < rounding);
    }
  // Without gravity all are exact.
  for (const Real integrator : kIntegrators) assert_true(flight_error(integrator, 0, 0, 60) < 60 * 20 * kEpsilon);
}

static void drag_converges_with_orders_one_one_four_and_two(void**) {
  const Real c = 0.8;  // c h = 0.1 at n = 16: the next term of the error is that much of it
  const struct {
    Real integrator, order;
    int n;
  } cases[] = {{kExplicitEuler, 1, 64}, {kSemiImplicit, 1, 64}, {kRk4, 4, 16}, {kVerlet, 2, 16}};
  for (const auto& k : cases)
    for (const Real factor : {1.0, 0.5})
      assert_true(
          std::fabs(slope(flight_error(k.integrator, c, factor, k.n), flight_error(k.integrator, c, factor, 2 * k.n)) -
                    k.order) < 0.15);
}

static void drag_alone_is_exact_at_any_step_and_stable_at_any_rate(void**) {
  for (const Real integrator : kIntegrators)
    for (const Real c : {0.5, 100.0, 1e6}) {
      TestWorld t(Vec3::zero());
      t.world.set_dial(Dial::integrator, integrator);
      t.world.set_dial(Dial::substeps, 1);  // laws are of the step
      const std::uint32_t s = add_set(t.world, {1, c, 1});
      throw_one(t.world, s, Vec3::zero(), Vec3(1, 2, 3));
      t.run(30, 1.0 / 60);
      const Real want = std::exp(-c / 2);
      // RK4 integrates slow decay as a force: local error (c h)^5/120 a step. Flows round 30 times, halves 60.
      const Real ch = c / 60, method = integrator == kRk4 && ch < 1 ? 30 * std::pow(ch, 5) / 120 : 0;
      assert_true((t.world.particles.set[s].velocity(0) - want * Vec3(1, 2, 3)).norm() <=
                  4 * want * (method + 120 * kEpsilon));
    }
}

/// Bodies without shape and particles side by side, also with substeps, and where others can touch.
static void a_particle_has_the_bits_of_a_body_without_a_shape(void**) {
  for (const Real integrator : kIntegrators)
    for (const Real c : {0.0, 0.5, 70.0, 1e5})
      for (const bool substeps : {false, true}) {
        TestWorld t(Vec3(0.3, -9.81, 0.1));
        t.world.set_dial(Dial::integrator, integrator);
        const Real choice = t.world.scene.dials[Dial::integrator];
        assert_true(choice == integrator);
        t.world.set_dial(Dial::substeps, substeps ? 3 : 1);
        if (substeps && c > 0)
          for (const Real x : {1e3, 2e3}) t.add(t.keep(sphere(0.5)), Vec3(x, 0, 0));
        const std::uint32_t s = add_set(t.world, {1, c, 1});
        std::vector<std::uint32_t> bodies;
        for (int i = 0; i < 7; ++i) {
          BodyDef def;
          def.pose.p = Vec3(0.1 * i, 1 - i, 3);
          def.velocity = Vec3(i, 2.7, -0.3 * i);
          def.linear_damping = c;
          bodies.push_back(handle_slot(t.world.add_body(def)));
          throw_one(t.world, s, def.pose.p, def.velocity);
        }
        t.run(50, 1.0 / 60);
        assert_int_equal(t.world.plan->substeps, substeps ? 3 : 1);
        for (std::size_t i = 0; i < bodies.size(); ++i) {
          assert_true(t.world.particles.set[s].position(i) == t.world.state.x[bodies[i]]);
          assert_true(t.world.particles.set[s].velocity(i) == t.world.state.v[bodies[i]]);
        }
      }
}

static void energy_of_the_report_is_that_of_all_particles(void**) {
  TestWorld t;
  t.world.set_dial(Dial::integrator, kVerlet);
  const std::uint32_t alike = add_set(t.world, {1, 0, 0.5}), weighed = add_set(t.world, {1, 0, 2});
  BodyDef def;
  def.velocity = Vec3(1, 0, 0);
  const std::uint32_t body = handle_slot(t.world.add_body(def));
  for (int i = 0; i < 1100; ++i) {
    throw_one(t.world, alike, Vec3::zero(), Vec3(i % 7, 2, 0));
    throw_one(t.world, weighed, Vec3::zero(), Vec3(0, i % 5, 1));
  }
  t.world.particles.reserve_masses(weighed);
  for (std::size_t i = 0; i < 1100; ++i) t.world.particles.set_mass(weighed, i, 1 + static_cast<Real>(i % 3));
  t.run(10, 1.0 / 60);
  Real want = 0.5 * t.world.state.v[body].squared_norm();
  for (std::size_t i = 0; i < 1100; ++i)
    want += 0.5 * 0.5 * t.world.particles.set[alike].velocity(i).squared_norm() +
            0.5 * (1 + static_cast<Real>(i % 3)) * t.world.particles.set[weighed].velocity(i).squared_norm();
  // 2,201 positive terms, each sum and product rounded.
  assert_true(std::fabs(t.world.report.linear_energy - want) <= 2 * 2210 * kEpsilon * want);
  assert_int_equal(t.world.report.particles, 2200);
  assert_int_equal(t.world.report.bodies, 1);
  assert_int_equal(t.world.report.dynamic_bodies, 1);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(free_fall_has_the_error_that_theory_gives),
      cmocka_unit_test(drag_converges_with_orders_one_one_four_and_two),
      cmocka_unit_test(drag_alone_is_exact_at_any_step_and_stable_at_any_rate),
      cmocka_unit_test(a_particle_has_the_bits_of_a_body_without_a_shape),
      cmocka_unit_test(energy_of_the_report_is_that_of_all_particles),
  };
  return cmocka_run_group_tests_name("oracle/particles", tests, nullptr, nullptr);
}
