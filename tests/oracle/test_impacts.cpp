// Impacts against closed forms: what keeps energy keeps it to rounding, and poses are those of parabolas between
// bounces.
#include <vector>

#include "carom_test.h"
#include "dynamics/contact/impact.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kG = 9.81;
constexpr Real kSolvers[] = {kSeverityChoice, kSoftChoice, kDirectChoice, kAutoChoice};
constexpr Real kIntegrators[] = {0, 1, 2, 3};  // CAROM_INTEGRATOR_*
constexpr Real kVerlet = 3;

struct Room : TestWorld {
  Real ahead;  // substeps: the moment of the stored velocity is that much later than that of the pose
  Real substeps;
  Room(Real solver, Real integrator, Real substeps_) : substeps(substeps_) {
    constexpr Real kAhead[] = {0.5, -0.5, 0, 0};  // explicit and semi-implicit Euler, RK4, Verlet
    ahead = kAhead[static_cast<std::size_t>(integrator)];
    world.set_dial(Dial::solver, solver);
    world.set_dial(Dial::integrator, integrator);
    world.set_dial(Dial::substeps, substeps);
    world.set_dial(Dial::restitution_speed, 0.01);
  }
  /// J, over y = 0, with the velocity that belongs to the pose.
  Real energy(Real step) const {
    Real sum = 0;
    for (std::uint32_t i = 0; i < world.scene.bodies.slots(); ++i) {
      if (!(world.scene.inv_mass[i] > 0)) continue;
      const Vec3 v = world.state.v[i] - ahead * step / substeps * world.scene.gravity;
      const Vec3 w = world.state.q[i].conjugate() * world.state.omega[i];
      sum += world.scene.mass[i] * (v.squared_norm() / 2 + kG * world.state.x[i].y()) +
             w.dot(world.scene.inertia[i] * w) / 2;
    }
    return sum;
  }
};

/// Of an energy, after so many substeps: each is a few sums and products, which round by u; they add up linearly.
Real rounding(Real substeps) { return 16 * kUnitRoundoff * substeps; }

/// m, of a ball let go at `drop` that keeps a share e of its speed: parabola after parabola.
Real height_at(Real t, Real drop, Real e) {
  Real speed = std::sqrt(2 * kG * drop);
  t -= speed / kG;
  if (t < 0) return drop - kG * (t + speed / kG) * (t + speed / kG) / 2;
  for (speed *= e; t > 2 * speed / kG; speed *= e) t -= 2 * speed / kG;
  return t * (speed - kG * t / 2);
}

void a_ball_keeps_its_energy_from_bounce_to_bounce(void**) {
  for (const Real solver : kSolvers)
    for (const Real integrator : kIntegrators)
      for (const Real substeps : {1.0, 4.0}) {
        Room t(solver, integrator, substeps);
        const std::uint32_t m = t.material(0, 1);
        t.ground(m);
        t.add(t.keep(sphere(0.1)), Vec3(0, 1.1, 0), BodyType::dynamic, Quat::identity(), m);
        const Real step = 1.0 / 60;
        t.world.step(step);
        const Real start = t.energy(step);
        int bounces = 0;
        for (int i = 0; i < 1200; ++i) {
          const bool down = t.world.state.v[1].y() < 0;
          t.world.step(step);
          bounces += down && t.world.state.v[1].y() > 0;
          assert_true(std::fabs(t.energy(step) - start) < rounding(1200 * substeps) * start);
        }
        assert_true(bounces >= 21);  // 20 s of flights of 0.903 s
      }
}

void a_ball_is_where_its_parabolas_are(void**) {
  for (const Real solver : kSolvers)
    for (const Real e : {0.6, 0.9}) {
      const Real step = 1.0 / 60;
      Room t(solver, kVerlet, 1);
      const std::uint32_t m = t.material(0, e);
      t.ground(m);
      t.add(t.keep(sphere(0.1)), Vec3(0, 1.1, 0), BodyType::dynamic, Quat::identity(), m);
      // Until the fourth impact, the slowest at e^3 times 4.4 m/s, whose moment is off by rounding alone.
      for (int i = 1; i * step < 2 * std::sqrt(2 / kG) * (0.5 + e + e * e + e * e * e); ++i) {
        t.world.step(step);
        assert_true(std::fabs(t.world.state.x[1].y() - 0.1 - height_at(i * step, 1, e)) < 1e3 * kUnitRoundoff);
      }
    }
}

/// Its four corners meet the ground together, and none of them first: it does not turn.
void a_box_that_falls_flat_bounces_flat(void**) {
  for (const Real solver : kSolvers)
    for (const Real e : {1.0, 0.5}) {
      const Real step = 1.0 / 60;
      Room t(solver, kVerlet, 1);
      const std::uint32_t m = t.material(0.5, e);
      t.ground(m);
      t.add(t.keep(box(Vec3(0.5, 0.25, 0.4))), Vec3(0, 1.25, 0), BodyType::dynamic, Quat::identity(), m);
      const Real flight = 2 * std::sqrt(2 / kG);
      for (int i = 1; i * step < flight * (0.5 + e); ++i) {
        t.world.step(step);
        // An impact is found to 1e-13 of its speed, 4.4 m/s; its error grows with the time after it.
        assert_true(std::fabs(t.world.state.x[1].y() - 0.25 - height_at(i * step, 1, e)) < 1e-12);
        assert_true(t.world.state.omega[1].norm() < 1e-11);
      }
    }
}

/// Edge and corner first, over and over, without friction. Only solvers whose contacts are hard, and with nothing that
/// lifts a body out of the ground: that is work done on it.
void a_tumbling_cube_keeps_its_energy(void**) {
  for (const Real solver : {kSeverityChoice, kDirectChoice}) {
    const Real step = 1.0 / 240;
    Room t(solver, kVerlet, 1);
    t.world.set_dial(Dial::position_iterations, 0);
    const std::uint32_t m = t.material(0, 1);
    t.ground(m);
    t.add(t.keep(box(Vec3::constant(0.25))), Vec3(0, 1.5, 0), BodyType::dynamic, exp_map(Vec3(0.3, 0.2, 0.5)), m);
    const Real start = t.energy(step);
    for (int i = 0; i < 1200; ++i) t.world.step(step);
    // Each of some hundred impacts is found to 1e-13 of its speed.
    assert_true(std::fabs(t.energy(step) - start) < 1e-11 * start);
    assert_true(t.world.state.omega[1].norm() > 0.1);
  }
}

/// Balls that fall on the ground and on each other, off centre, light on heavy: every impact keeps momentum and energy.
void a_crowd_keeps_its_energy(void**) {
  for (const Real solver : kSolvers) {
    const Real step = 1.0 / 60;
    Room t(solver, kVerlet, 1);
    t.world.set_dial(Dial::restitution_speed, 0);
    const std::uint32_t m = t.material(0, 1);
    t.ground(m);
    const Shape *small = t.keep(sphere(0.1)), *large = t.keep(sphere(0.14));
    for (int i = 0; i < 36; ++i)
      t.add(i % 3 ? small : large,
            Vec3(0.4 * (i % 3) + 0.01 * (i % 7), 1 + 0.3 * (i / 9), 0.4 * (i / 3 % 3) + 0.02 * (i % 4)),
            BodyType::dynamic, Quat::identity(), m);
    const Real start = t.energy(step);
    std::uint64_t pairs = 0;
    for (int i = 0; i < 300; ++i) t.world.step(step), pairs += t.world.report.contact_pairs;
    assert_true(pairs > 1000);
    assert_true(std::fabs(t.energy(step) - start) < rounding(300 * 36) * start);
  }
}

/// A press closes on a ball: there are more impacts than can be answered, and yet an end, and nothing is thrown away.
void between_jaws_a_step_comes_to_its_end(void**) {
  for (const Real solver : kSolvers) {
    Room t(solver, kVerlet, 1);
    const std::uint32_t m = t.material(0, 1);
    const Shape* plate = t.keep(box(Vec3(1, 0.1, 1)));
    const std::uint32_t low = t.add(plate, Vec3(0, -0.1, 0), BodyType::kinematic, Quat::identity(), m);
    const std::uint32_t high = t.add(plate, Vec3(0, 0.35, 0), BodyType::kinematic, Quat::identity(), m);
    const std::uint32_t ball = t.add(t.keep(sphere(0.1)), Vec3(0, 0.12, 0), BodyType::dynamic, Quat::identity(), m);
    t.world.set_velocity(low, Vec3(0, 0.5, 0), Vec3::zero());
    t.world.set_velocity(high, Vec3(0, -0.5, 0), Vec3::zero());
    for (int i = 0; i < 30; ++i) {
      t.world.step(1.0 / 60);
      assert_true(finite(t.world.state.x[ball]) && finite(t.world.state.v[ball]));
    }
  }
}

void points_meet_when_and_as_fast_as_their_parabolas_say(void**) {
  const Real never = -1.0 / 60;
  const auto same = [](const Touch& t, Real time, Real speed) {
    // A root of what is of order 1: a few roundings.
    assert_true(std::fabs(t.time - time) < 8 * kUnitRoundoff && std::fabs(t.speed - speed) < 8 * kUnitRoundoff);
  };
  same(find_touch(0.5, 0, 1, never), 1, 1);         // let go
  same(find_touch(1.5, 1, 1, never), 1, 2);         // thrown
  same(find_touch(1, 2, 0, never), 0.5, 2);         // nothing pulls
  same(find_touch(0, -1, 2, 0), 1, 1);              // thrown up from there, comes back
  same(find_touch(0.375, 1, -1, never), 0.5, 0.5);  // slowed down on the way
  same(find_touch(-0.01, 1, 0, never), -0.01, 1);   // it was a moment ago
  same(find_touch(-1, 1, 0, never), 0, 1);          // too long ago
  same(find_touch(-0.01, 1, 0, 0), 0, 1);           // not before the last impact
  same(find_touch(1, 1, 0, 0.25), 1, 1);
  assert_true(find_touch(1, 1, -1, never).speed == 0);  // turns round before
  assert_true(find_touch(1, -1, 0, never).speed == 0);  // parts
  assert_true(find_touch(0, 0, 0, never).speed == 0);   // lies
  assert_true(find_touch(0, -1, -1, 0).speed == 0);
  assert_true(!(find_touch(kInfinity - kInfinity, 1, 1, 0).speed > 0));
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_ball_keeps_its_energy_from_bounce_to_bounce),
      cmocka_unit_test(a_ball_is_where_its_parabolas_are),
      cmocka_unit_test(a_box_that_falls_flat_bounces_flat),
      cmocka_unit_test(a_tumbling_cube_keeps_its_energy),
      cmocka_unit_test(a_crowd_keeps_its_energy),
      cmocka_unit_test(between_jaws_a_step_comes_to_its_end),
      cmocka_unit_test(points_meet_when_and_as_fast_as_their_parabolas_say),
  };
  return cmocka_run_group_tests_name("oracle/impacts", tests, nullptr, nullptr);
}
