// The solvers in lanes against what is known without them: springs, friction, momentum, heights.
#include <algorithm>
#include <vector>

#include "carom_test.h"
#include "dynamics/solver/soft_step.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kStep = 1.0 / 60, kGravity = 9.81;

Real square(Real x) { return x * x; }

/// A stack of cubes of 1 m on the ground, just touching.
std::vector<std::uint32_t> stack(TestWorld& t, int count) {
  t.ground();
  const Shape* cube = t.keep(box(Vec3::constant(0.5)));
  std::vector<std::uint32_t> bodies;
  for (int i = 0; i < count; ++i) bodies.push_back(t.add(cube, Vec3(0, i + 0.5, 0)));
  return bodies;
}

}  // namespace

/// At rest a contact bears a load P with its m, at each of its points the normal mass, by sinking s = P / (m w^2). For
/// a cube's four corners on what does not move m adds up to the cube's mass, M; between two cubes to half of it.
/// Contacts with the ground are twice as stiff.
static void a_stack_sinks_by_what_its_springs_give(void**) {
  for (const Real frequency : {20.0, 30.0}) {
    TestWorld t;
    t.world.set_dial(Dial::solver, kSoftChoice);
    t.world.set_dial(Dial::substeps, 4);
    t.world.set_dial(Dial::contact_frequency, frequency);
    t.world.set_dial(Dial::position_tolerance, 1);  // springs alone
    constexpr int kCubes = 6;
    const std::vector<std::uint32_t> cubes = stack(t, kCubes);
    t.run(1200, kStep);
    const Real w2 = square(2 * 3.14159265358979 * frequency);
    Real sunk = kCubes * kGravity / (4 * w2);
    for (int i = 0; i < kCubes; ++i) {
      const Vec3 moved = t.world.state.x[cubes[i]] - Vec3(0, i + 0.5, 0);
      // Springs are linear; what is left of the fall after 20 s and the lean of the stack are below a hundredth of it.
      assert_true(std::fabs(-moved.y() - sunk) < 0.01 * sunk);
      sunk += (kCubes - 1 - i) * kGravity / (0.5 * w2);
    }
  }
}

static void softness_is_that_of_a_damped_spring_stepped_implicitly(void**) {
  // One implicit step of m u' = -c u - k s over h, k = m w^2, c = 2 z m w, from u and s, with s taken at the end:
  //   u1 = (u - h w^2 s) / (1 + 2 z h w + h^2 w^2)
  for (const Real h : {1.0 / 60, 1.0 / 240})
    for (const Real frequency : {5.0, 30.0})
      for (const Real damping : {0.7, 10.0}) {
        const Softness soft = softness(frequency, damping, h);
        const Real w = 2 * 3.14159265358979 * frequency, u = -0.3, s = -0.01;
        const Real truth = (u - h * w * w * s) / (1 + 2 * damping * h * w + square(h * w));
        const Real u1 = u - soft.mass_scale * (u + soft.bias_rate * s);  // mass 1, no impulse before
        assert_true(std::fabs(u1 - truth) < 1e-14);
      }
}

static void stacks_of_ten_and_twenty_stand(void**) {
  struct Case {
    int cubes;
    Real substeps, frequency;
  };
  for (const Case& c : {Case{10, 4, 30}, Case{20, 8, 60}}) {
    TestWorld t;
    t.world.set_dial(Dial::solver, kSoftChoice);
    t.world.set_dial(Dial::substeps, c.substeps);
    t.world.set_dial(Dial::contact_frequency, c.frequency);
    const std::vector<std::uint32_t> cubes = stack(t, c.cubes);
    t.run(1200, kStep);
    const Vec3 moved = t.world.state.x[cubes.back()] - Vec3(0, c.cubes - 0.5, 0);
    // Sunk by its springs, as above, and its top still over its foot: half a cube aside would be on its way down.
    const Real w2 = square(2 * 3.14159265358979 * c.frequency), n = c.cubes;
    const Real sunk = n * kGravity / (4 * w2) + n * (n - 1) * kGravity / w2;
    assert_true(std::fabs(-moved.y() - sunk) < 0.05 * sunk);
    assert_true(std::hypot(moved.x(), moved.z()) < 0.1);
  }
}

static void a_sliding_slab_stops_where_friction_says_in_any_direction(void**) {
  constexpr Real kSpeed = 5, kFriction = 0.5, kWay = kSpeed * kSpeed / (2 * kFriction * kGravity);
  for (const int solver : {kSoftChoice, kDirectChoice})
    for (const Real angle : {0.0, 0.4, 0.8}) {
      for (const Real dt : {kStep, kStep / 2}) {
        TestWorld t;
        t.world.set_dial(Dial::solver, solver);
        t.world.set_dial(Dial::substeps, 4);
        const std::uint32_t m = t.material(kFriction, 0);
        t.ground(m);
        const std::uint32_t slab =
            t.add(t.keep(box(Vec3(0.5, 0.1, 0.5))), Vec3(0, 0.1, 0), BodyType::dynamic, Quat::identity(), m);
        const Vec3 ahead(std::cos(angle), 0, std::sin(angle)), sideways(-ahead.z(), 0, ahead.x());
        t.world.set_velocity(slab, kSpeed * ahead, Vec3::zero());
        t.run(static_cast<int>(std::lround(2 / dt)), dt);
        const Vec3 x = t.world.state.x[slab];
        // The cone is round: nothing pushes aside. The slab sinks as it slides, unevenly, by less than its spring
        // gives.
        assert_true(std::fabs(x.dot(sideways)) < 1e-3);
        assert_true(t.world.state.v[slab].norm() < 1e-3);
        // It moves by the mean speed of each substep. What is left is the substep in which it stops, and moves by
        // nothing any more: at most (mu g h)^2 / (2 mu g). And what it slides while springs let it sink, with less
        // friction.
        const Real h = dt / 4, last = kFriction * kGravity * h * h / 2;
        const Real sinks = solver == kSoftChoice ? kFriction * kGravity / (60 * 60 * 9.87) : 0;
        assert_true(std::fabs(kWay - x.dot(ahead)) < last + sinks + 1e-5);
      }
    }
}

/// A ball that rolls without slip needs no friction to go on, whatever the substeps: its point stays under its centre.
static void a_ball_rolls_on_as_it_is(void**) {
  constexpr Real kSpeed = 6, kRadius = 0.5;
  for (int solver = 0; solver < kSolverChoices; ++solver)
    for (const Real substeps : {1.0, 4.0}) {
      TestWorld t;
      t.world.set_dial(Dial::solver, solver);
      t.world.set_dial(Dial::substeps, substeps);
      t.ground();
      const std::uint32_t ball = t.add(t.keep(sphere(kRadius)), Vec3(0, kRadius, 0));
      t.world.set_velocity(ball, Vec3(kSpeed, 0, 0), Vec3(0, 0, -kSpeed / kRadius));
      t.run(120, kStep);
      const bool soft = solver == kSoftChoice;  // auto gives a lone ball that does not slip to the direct solver
      const Vec3 &x = t.world.state.x[ball], &v = t.world.state.v[ball], &omega = t.world.state.omega[ball];
      // Soft contacts sink by their load: below that only while they still settle.
      const Real w2 = square(2 * 3.14159265358979 * std::min(30.0, 15 * substeps));  // a quarter of the substep rate
      const Real sink = soft ? kGravity / (4 * w2) : 0;
      assert_true(std::fabs(x.x() - 120 * kStep * kSpeed) < 1e-9);
      assert_true(std::fabs(x.y() - (kRadius - sink)) < (soft ? 0.02 * sink : 1e-5) && std::fabs(x.z()) < 1e-12);
      assert_true(std::fabs(v.x() - kSpeed) < 1e-9 && std::fabs(omega.z() + kSpeed / kRadius) < 1e-9);
    }
}

static void collisions_keep_the_momentum(void**) {
  for (const int solver : {kSoftChoice, kDirectChoice}) {
    TestWorld t(Vec3::zero());
    t.world.set_dial(Dial::solver, solver);
    t.world.set_dial(Dial::substeps, 4);
    const Shape* cube = t.keep(box(Vec3::constant(0.5)));
    const Shape* ball = t.keep(sphere(0.4));
    std::vector<std::uint32_t> bodies;
    for (int i = 0; i < 27; ++i) {
      const Vec3 x(1.2 * (i % 3), 1.2 * (i / 3 % 3), 1.2 * (i / 9));
      bodies.push_back(t.add(i % 2 ? cube : ball, x));
      t.world.set_velocity(bodies.back(), -1.5 * (x - Vec3::constant(1.2)) + Vec3(0.1, 0.2, 0.3), Vec3(1, -2, 0.5));
    }
    const auto momentum = [&] {
      Vec3 sum = Vec3::zero();
      for (const std::uint32_t b : bodies) sum += t.world.scene.mass[b] * t.world.state.v[b];
      return sum;
    };
    const auto energy = [&] {
      Real sum = 0;
      for (const std::uint32_t b : bodies) {
        const Vec3 w = t.world.state.q[b].conjugate() * t.world.state.omega[b];
        sum +=
            0.5 * t.world.scene.mass[b] * t.world.state.v[b].squared_norm() + 0.5 * w.dot(t.world.scene.inertia[b] * w);
      }
      return sum;
    };
    const Vec3 before = momentum();
    const Real energy_before = energy();
    std::uint64_t touched = 0;
    for (int i = 0; i < 120; ++i) t.world.step(kStep), touched += t.world.report.contact_points;
    assert_true(touched > 100);
    // Some 1e5 impulses of 1e3 N s at most, each taken from one body and given to another to an ulp.
    assert_true((momentum() - before).norm() < 1e5 * 1e3 * 2.3e-16);
    assert_true(energy() < energy_before);  // restitution 0
  }
}

static void a_ball_bounces_as_high_as_its_restitution_says(void**) {
  for (const int solver : {kSoftChoice, kDirectChoice}) {
    TestWorld t;
    t.world.set_dial(Dial::solver, solver);
    t.world.set_dial(Dial::substeps, 4);
    const std::uint32_t m = t.material(0, 0.5);
    t.ground(m);
    const std::uint32_t ball = t.add(t.keep(sphere(0.1)), Vec3(0, 1.1, 0), BodyType::dynamic, Quat::identity(), m);
    Real top = 0;
    bool down = false;
    for (int i = 0; i < 50; ++i) {
      t.world.step(kStep);
      down |= t.world.state.v[ball].y() > 0;
      if (down) top = std::max(top, t.world.state.x[ball].y() - 0.1);
    }
    // The peak lies up to half a step beside a sample, g dt^2/8 higher; semi-implicit Euler starts at g h/2 downwards.
    assert_true(down && std::fabs(top - 0.25) < kGravity * kStep * kStep / 8);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_stack_sinks_by_what_its_springs_give),
      cmocka_unit_test(softness_is_that_of_a_damped_spring_stepped_implicitly),
      cmocka_unit_test(stacks_of_ten_and_twenty_stand),
      cmocka_unit_test(a_sliding_slab_stops_where_friction_says_in_any_direction),
      cmocka_unit_test(a_ball_rolls_on_as_it_is),
      cmocka_unit_test(collisions_keep_the_momentum),
      cmocka_unit_test(a_ball_bounces_as_high_as_its_restitution_says),
  };
  return cmocka_run_group_tests_name("oracle/solvers", tests, nullptr, nullptr);
}
