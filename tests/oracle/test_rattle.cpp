// Islands that joints alone hold, moved by RATTLE: their orders, against closed forms and equations of motion.
#include <algorithm>
#include <functional>

#include "carom_test.h"
#include "rattle_scenes.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kLeeway = 0.2;  // of an order: what the next term adds at the steps used here

/// Order by which error(steps) falls, from some steps to twice as many.
Real order_of(const std::function<Real(int)>& error, int steps) { return std::log2(error(steps) / error(2 * steps)); }

/// y' = f(y) by classical Runge-Kutta, of so many numbers.
template <std::size_t n, class F>
std::array<Real, n> integrate(std::array<Real, n> y, Real time, int steps, F&& f) {
  const Real h = time / steps;
  const auto plus = [](std::array<Real, n> a, Real s, const std::array<Real, n>& b) {
    for (std::size_t i = 0; i < n; ++i) a[i] += s * b[i];
    return a;
  };
  for (int k = 0; k < steps; ++k) {
    const auto k1 = f(y), k2 = f(plus(y, h / 2, k1)), k3 = f(plus(y, h / 2, k2)), k4 = f(plus(y, h, k3));
    for (std::size_t i = 0; i < n; ++i) y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  return y;
}

/// Two rods of 0.5 m and 1 kg, one below the other: angles from straight down, and their rates.
std::array<Real, 4> double_pendulum(const std::array<Real, 4>& y) {
  const Real l = 0.5, a = y[0], b = y[1], p = y[2], q = y[3], c = std::cos(a - b), s = std::sin(a - b);
  const Real r1 = -0.5 * s * q * q - 1.5 * kG / l * std::sin(a), r2 = 0.5 * s * p * p - 0.5 * kG / l * std::sin(b);
  const Real m11 = 4.0 / 3, m12 = 0.5 * c, m22 = 1.0 / 3, det = m11 * m22 - m12 * m12;
  return {p, q, (m22 * r1 - m12 * r2) / det, (m11 * r2 - m12 * r1) / det};
}

}  // namespace

/// From 170 degrees a quarter of the period leads to the bottom, where it is fastest; five of them, by elliptic
/// integral.
static void a_pendulum_has_its_order(void**) {
  const Real amplitude = 170 * kPi / 180, time = 1.25 * period(std::sqrt(1.5 * kG), amplitude);
  for (const int order : kOrders) {
    const auto error = [&](int steps) {
      TestWorld t;
      by_rattle(t, order);
      // About its axis a rod turns freely on a ball; on a hinge, not.
      const std::uint32_t rod = hang_rod(t, amplitude, order == 4 ? JointKind::ball : JointKind::hinge);
      for (int i = 0; i < steps; ++i) t.world.step(time / steps), assert_int_equal(held(t), 1);
      assert_true(worst_gap(t) < 2e-8);  // angles near 0 are roots of sums of squares
      assert_true(gap_of(t, 0) < 1e-14);
      return (t.world.state.x[rod] - Vec3(0, -0.5, 0)).norm();
    };
    const int steps = order == 2 ? 800 : order == 4 ? 400 : 200;
    const Real got = order_of(error, steps);
    std::printf("  order %d: %.3f, error %.2g m after %d steps\n", order, got, error(2 * steps), 2 * steps);
    assert_true(std::fabs(got - order) < kLeeway);
  }
}

/// Against the equations of motion in two angles.
static void a_double_pendulum_has_its_order(void**) {
  const Real a = kPi / 3, b = -kPi / 6, time = 1;
  const std::array<Real, 4> end = integrate<4>({a, b, 0, 0}, time, 20000, double_pendulum);
  const Vec3 truth(0.5 * std::sin(end[0]) + 0.25 * std::sin(end[1]), -0.5 * std::cos(end[0]) - 0.25 * std::cos(end[1]),
                   0);
  for (const int order : kOrders)
    for (const JointKind kind : {JointKind::ball, JointKind::hinge}) {
      const auto error = [&](int steps) {
        TestWorld t;
        by_rattle(t, order);
        const std::uint32_t rod = hang_two(t, a, b, kind);
        for (int i = 0; i < steps; ++i) t.world.step(time / steps);
        assert_int_equal(held(t), 1);
        return (t.world.state.x[rod] - truth).norm();
      };
      const int steps = order == 2 ? 400 : order == 4 ? 200 : 120;
      const Real got = order_of(error, steps);
      std::printf("  order %d: %.3f, error %.2g m after %d steps\n", order, got, error(2 * steps), 2 * steps);
      assert_true(std::fabs(got - order) < kLeeway);
    }
}

/// Three unlike moments, and a joint off all axes: the turn of a free body is split, and its order comes of it. Against
/// itself at steps a quarter as long.
static void a_lopsided_top_has_its_order(void**) {
  for (const int order : kOrders) {
    const auto end = [&](int steps) {
      TestWorld t;
      by_rattle(t, order);
      const std::uint32_t top = add_body(t, Vec3(0.3, 0.2, 0.1), 2, Vec3(0.05, 0.11, 0.14), BodyType::dynamic,
                                         normalized(Quat(0.8, 0.1, 0.5, -0.2)));
      join(t, JointKind::ball, kInvalid, top, Vec3::zero());
      const Vec3 omega(4, -3, 2);
      t.world.set_velocity(top, omega.cross(t.world.state.x[top]), omega);
      for (int i = 0; i < steps; ++i) t.world.step(1.0 / steps);
      assert_int_equal(held(t), 1);
      return t.world.state.x[top];
    };
    const int steps = order == 2 ? 400 : order == 4 ? 100 : 50;
    const Vec3 finest = end(8 * steps);
    const Real coarse = (end(steps) - finest).norm(), fine = (end(2 * steps) - finest).norm();
    const Real got = std::log2(coarse / fine);
    std::printf("  order %d: %.3f, error %.2g m\n", order, got, fine);
    assert_true(std::fabs(got - order) < kLeeway);
  }
}

/// Two cranks, equal and parallel, and a bar, on four hinges: more is locked than is free to be. One angle, as of a
/// pendulum: (m1 l^2 / 3 + m1 l^2 / 3 + m2 l^2) a'' = -(m1 + m2) g l sin a.
static void a_loop_has_its_order(void**) {
  const Real l = 1, time = 1.2, inertia = 2.0 / 3 + 1, weight = 2 * kG;
  const Real a0 = 1;
  const auto end = integrate<2>({a0, 0}, time, 20000, [&](const std::array<Real, 2>& y) {
    return std::array<Real, 2>{y[1], -weight / inertia * std::sin(y[0])};
  });
  for (const int order : kOrders) {
    const auto error = [&](int steps) {
      TestWorld t;
      by_rattle(t, order);
      const Vec3 down(std::sin(a0), -std::cos(a0), 0);
      const Quat q = turn_between(Vec3(0, -1, 0), down), z = x_along(Vec3(0, 0, 1));
      const Vec3 right(2, 0, 0), thin(1.0 / 12, 1e-3, 1.0 / 12);
      const std::uint32_t one = add_body(t, 0.5 * down, 1, thin, BodyType::dynamic, q),
                          other = add_body(t, right + 0.5 * down, 1, thin, BodyType::dynamic, q),
                          bar = add_body(t, 0.5 * right + l * down, 1, Vec3(1e-3, 1.0 / 3, 1.0 / 3));
      join(t, JointKind::hinge, kInvalid, one, Vec3::zero(), z);
      join(t, JointKind::hinge, kInvalid, other, right, z);
      join(t, JointKind::hinge, one, bar, l * down, z);
      join(t, JointKind::hinge, other, bar, right + l * down, z);
      for (int i = 0; i < steps; ++i) t.world.step(time / steps), assert_int_equal(held(t), 1);
      for (std::uint32_t j = 0; j < 4; ++j) assert_true(gap_of(t, j) < 1e-13);
      return (t.world.state.x[bar] - Vec3(1 + std::sin(end[0]), -std::cos(end[0]), 0)).norm();
    };
    const int steps = order == 6 ? 20 : 60;
    const Real got = order_of(error, steps);
    std::printf("  order %d: %.3f, error %.2g m after %d steps\n", order, got, error(2 * steps), 2 * steps);
    assert_true(std::fabs(got - order) < kLeeway);
  }
}

/// Damping and damped springs: second order, whatever is asked for.
static void what_reads_velocities_is_of_second_order(void**) {
  for (const int order : kOrders) {
    const auto end = [&](int steps) {
      TestWorld t;
      by_rattle(t, order);
      const Vec3 down(std::sin(1.), -std::cos(1.), 0);
      BodyDef def;
      def.pose = {turn_between(Vec3(0, -1, 0), down), 0.5 * down};
      def.has_mass = def.has_inertia = true;
      def.mass = 1, def.inertia = Mat3::diagonal(Vec3(1.0 / 12, 1e-3, 1.0 / 12));
      def.linear_damping = 0.5, def.angular_damping = 2;
      const std::uint32_t rod = handle_slot(t.world.add_body(def));
      join(t, JointKind::hinge, kInvalid, rod, Vec3::zero(), x_along(Vec3(0, 0, 1)));
      SpringDef spring;
      spring.body_b = rod, spring.anchor_a = Vec3(1, 0, 0);
      spring.rest = 0.5, spring.stiffness = 10, spring.damping = 1;
      t.world.add_spring(spring);
      for (int i = 0; i < steps; ++i) t.world.step(1.0 / steps);
      assert_int_equal(held(t), 1);
      return t.world.state.x[rod];
    };
    const int steps = 100;
    const Vec3 finest = end(16 * steps);
    const Real got = std::log2((end(steps) - finest).norm() / (end(2 * steps) - finest).norm());
    std::printf("  asked for %d: %.3f, error %.2g m\n", order, got, (end(2 * steps) - finest).norm());
    assert_true(got > 2 - kLeeway);
  }
}

/// A wheel on a hinge and a cart on a slider, off their centres, each with a spring: A cos(w t), w as asked for.
static void springs_have_their_order(void**) {
  const Real f = 1, w = 2 * kPi * f, time = 0.9;
  for (const int order : kOrders)
    for (const bool slides : {false, true}) {
      const auto error = [&](int steps) {
        TestWorld t(Vec3::zero());
        by_rattle(t, order);
        const std::uint32_t body = add_body(t, slides ? Vec3::zero() : Vec3(0.7, 0, 0), 3, Vec3(0.5, 0.6, 0.8));
        const Coordinate c = slides ? Coordinate::slide : Coordinate::twist;
        join(t, slides ? JointKind::slider : JointKind::hinge, kInvalid, body, Vec3::zero(), x_along(Vec3(0, 0, 1)));
        set_spring(t, 0, c, 0.3, f, 0);
        for (int i = 0; i < steps; ++i) t.world.step(time / steps), assert_int_equal(held(t), 1);
        return std::fabs(coordinate(t, 0, c) - 0.3 * (1 - std::cos(w * time)));
      };
      const int steps = order == 6 ? 20 : 60;
      const Real got = order_of(error, steps);
      std::printf("  order %d, %s: %.3f, error %.2g\n", order, slides ? "slider" : "hinge", got, error(2 * steps));
      assert_true(std::fabs(got - order) < kLeeway);
    }
}

/// Under rk4 joints are of fourth order, whatever the dial says but 6: that integrator alone would leave them at first.
static void rk4_has_its_order_with_joints(void**) {
  const Real amplitude = 2, time = 1.25 * period(std::sqrt(1.5 * kG), amplitude);
  const auto error = [&](int steps) {
    TestWorld t;
    t.world.set_dial(Dial::integrator, 2);
    t.world.set_dial(Dial::substeps, 1);
    const std::uint32_t rod = hang_rod(t, amplitude);
    for (int i = 0; i < steps; ++i) t.world.step(time / steps);
    return (t.world.state.x[rod] - Vec3(0, -0.5, 0)).norm();
  };
  assert_true(std::fabs(order_of(error, 100) - 4) < kLeeway);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_pendulum_has_its_order),
      cmocka_unit_test(a_double_pendulum_has_its_order),
      cmocka_unit_test(a_lopsided_top_has_its_order),
      cmocka_unit_test(a_loop_has_its_order),
      cmocka_unit_test(what_reads_velocities_is_of_second_order),
      cmocka_unit_test(springs_have_their_order),
      cmocka_unit_test(rk4_has_its_order_with_joints),
  };
  return cmocka_run_group_tests_name("oracle/rattle", tests, nullptr, nullptr);
}
