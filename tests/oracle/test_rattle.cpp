// Islands that joints alone hold, moved by RATTLE: orders against closed forms and equations of motion, gaps at rounding,
// energy, loops, trees, and how islands come and go.
#include <algorithm>
#include <functional>

#include "carom_test.h"
#include "dynamics/joint/rattle/rattle.h"
#include "joint_scenes.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kPi = 3.14159265358979323846;
constexpr int kOrders[] = {2, 4, 6};
constexpr Real kLeeway = 0.2;  // of an order: what the next term adds at the steps used here

void by_rattle(TestWorld& t, int order, int substeps = 1) {
  t.world.set_dial(Dial::joint_order, order);
  t.world.set_dial(Dial::substeps, substeps);
}
std::size_t held(const TestWorld& t) {
  return static_cast<std::size_t>(std::ranges::count_if(t.world.rattle->islands, [](const auto& i) { return i.went_well; }));
}

/// Period of a pendulum of amplitude a: 4 K(sin a/2) / w0, by the arithmetic-geometric mean.
Real period(Real w0, Real amplitude) {
  Real a = 1, b = std::cos(amplitude / 2);
  for (int i = 0; i < 40; ++i) {
    const Real m = (a + b) / 2;
    b = std::sqrt(a * b), a = m;
  }
  return 2 * kPi / (w0 * a);
}

/// A thin rod of 1 m hung by one end, let go at an angle from straight down. @return the rod
std::uint32_t hang_rod(TestWorld& t, Real angle, JointKind kind = JointKind::hinge) {
  const Vec3 down(std::sin(angle), -std::cos(angle), 0);
  const Quat q = turn_between(Vec3(0, -1, 0), down);
  const std::uint32_t rod = add_body(t, 0.5 * down, 1, Vec3(1.0 / 12, 1e-3, 1.0 / 12), BodyType::dynamic, q);
  join(t, kind, kTheWorld, rod, Vec3::zero(), x_along(Vec3(0, 0, 1)));
  return rod;
}

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

std::uint32_t hang_two(TestWorld& t, Real a, Real b, JointKind kind) {
  Vec3 at = Vec3::zero();
  std::uint32_t before = kTheWorld;
  for (const Real angle : {a, b}) {
    const Vec3 down(std::sin(angle), -std::cos(angle), 0);
    const std::uint32_t rod = add_body(t, at + 0.25 * down, 1, Vec3(0.25 / 12, 1e-3, 0.25 / 12), BodyType::dynamic,
                                       turn_between(Vec3(0, -1, 0), down));
    join(t, kind, before, rod, at, x_along(Vec3(0, 0, 1)));
    before = rod;
    at += 0.5 * down;
  }
  return before;
}

}  // namespace

/// From 170 degrees a quarter of the period leads to the bottom, where it is fastest; five of them, by elliptic integral.
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
  const Vec3 truth(0.5 * std::sin(end[0]) + 0.25 * std::sin(end[1]), -0.5 * std::cos(end[0]) - 0.25 * std::cos(end[1]), 0);
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
      join(t, JointKind::ball, kTheWorld, top, Vec3::zero());
      const Vec3 omega(4, -3, 2);
      t.world.set_velocity(top, omega.cross(t.world.state.x[top]), omega);
      for (int i = 0; i < steps; ++i) t.world.step(1.0 / steps);
      assert_int_equal(held(t), 1);
      return t.world.state.x[top];
    };
    const int steps = order == 2 ? 400 : order == 4 ? 100 : 50;
    const Vec3 finest = end(8 * steps);
    const Real coarse = (end(steps) - finest).norm(), fine = (end(2 * steps) - finest).norm(), got = std::log2(coarse / fine);
    std::printf("  order %d: %.3f, error %.2g m\n", order, got, fine);
    assert_true(std::fabs(got - order) < kLeeway);
  }
}

/// Bent at a right angle and let go, 40 links of 0.1 m: no gap beyond rounding of their places, and energy to the step's
/// order though the end cracks like a whip. Trees and stars likewise.
static void chains_and_trees_do_not_gape(void**) {
  for (const int order : kOrders) {
    TestWorld t;
    by_rattle(t, order, 4);
    chain(t, 40, 0.1, 0.5, 0.5);
    const Real before = energy_of(t);
    Real gap = 0;
    for (int i = 0; i < 120; ++i) {
      t.world.step(1.0 / 60);
      assert_int_equal(held(t), 1);
      gap = std::max(gap, worst_gap(t));
    }
    std::printf("  order %d: gap %.2g m, energy %.2g J of %.3g\n", order, gap, energy_of(t) - before, 41 * 0.5 * kG * 4);
    assert_true(gap < 1e-12);
  }
  for (const bool star : {false, true}) {
    TestWorld t;
    by_rattle(t, 4, 2);
    std::vector<std::uint32_t> bodies = {add_body(t, Vec3::zero(), 5, Vec3(0.4, 0.5, 0.6))};
    t.world.set_velocity(bodies[0], Vec3::zero(), Vec3(0.2, 1, 0.1));
    for (int i = 1; i < 31; ++i) {
      const std::uint32_t parent = star ? bodies[0] : bodies[static_cast<std::size_t>(i - 1) / 2];
      const Real angle = 0.7 * i;
      const Vec3 way(std::cos(angle), std::sin(3 * angle), std::sin(angle)), at = t.world.state.x[parent] + 0.3 * way;
      bodies.push_back(add_body(t, at + 0.2 * way, 1, Vec3(0.02, 0.03, 0.04)));
      join(t, i % 3 ? JointKind::ball : JointKind::universal, parent, bodies.back(), at);
    }
    for (int i = 0; i < 120; ++i) t.world.step(1.0 / 60), assert_int_equal(held(t), 1);
    Real gap = 0;
    for (std::uint32_t j = 0; j < 30; ++j) gap = std::max(gap, gap_of(t, j));
    assert_true(gap < 1e-12);
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
      join(t, JointKind::hinge, kTheWorld, one, Vec3::zero(), z);
      join(t, JointKind::hinge, kTheWorld, other, right, z);
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

/// A million steps: energy swings with the rod and does not drift. Of its least and greatest over the first and the last
/// tenth, nothing but rounding is left: a million times, each of it at most a unit of 20 J.
static void energy_does_not_drift(void**) {
  TestWorld t;
  by_rattle(t, 2);
  hang_rod(t, 2);
  Real least[2] = {1e9, 1e9}, most[2] = {-1e9, -1e9};
  for (int i = 0; i < 1000000; ++i) {
    t.world.step(1.0 / 240);
    const int part = i < 100000 ? 0 : i >= 900000 ? 1 : -1;
    if (part < 0) continue;
    const Real energy = energy_of(t);
    least[part] = std::min(least[part], energy), most[part] = std::max(most[part], energy);
  }
  std::printf("  energy %.12g to %.12g J, then %.12g to %.12g\n", least[0], most[0], least[1], most[1]);
  assert_true(std::fabs(least[1] - least[0]) < 1e6 * 20 * kEpsilon * 1e2 && std::fabs(most[1] - most[0]) < 1e6 * 20 * kEpsilon * 1e2);
}

/// A ball on a rod swings into a wall and back: with a contact it is answered as without the dial, and comes back. No
/// step gives energy but by what RATTLE's own energy swings.
static void contacts_come_and_go(void**) {
  TestWorld t;
  by_rattle(t, 4, 4);
  const std::uint32_t ball = t.add(t.keep(sphere(0.1)), Vec3(-0.8, -0.6, 0));
  join(t, JointKind::ball, kTheWorld, ball, Vec3::zero());
  t.add(t.keep(box(Vec3(0.1, 1, 1))), Vec3(0.25, -1, 0), BodyType::fixed);
  int with = 0, without = 0, changes = 0;
  bool before = true;
  Real energy = energy_of(t);
  for (int i = 0; i < 300; ++i) {
    t.world.step(1.0 / 60);
    const bool now = held(t) == 1;
    ++(now ? with : without);
    changes += now != before;
    before = now;
    const Real next = energy_of(t);
    assert_true(next < energy + 1e-5 * kG);
    energy = next;
    assert_true(gap_of(t, 0) < (now ? 1e-13 : 1e-3));
  }
  assert_true(with > 30 && without > 1 && changes >= 2);
}

/// A limit that is not reached costs nothing and changes no bit; one that is reached holds.
static void limits_fall_back(void**) {
  std::uint64_t hash[2];
  for (const bool wide : {false, true}) {
    TestWorld t;
    by_rattle(t, 2, 4);
    hang_rod(t, 1);
    if (wide) set_limit(t, 0, Coordinate::twist, -3, 3);
    t.run(100, 1.0 / 60);
    hash[wide] = t.world.hash();
    assert_int_equal(held(t), 1);
  }
  assert_int_equal(hash[0], hash[1]);
  TestWorld t;
  by_rattle(t, 4, 4);
  hang_rod(t, 1);
  set_limit(t, 0, Coordinate::twist, -0.5, 0.1);  // halfway down, where it comes to lie
  Real energy = energy_of(t);
  int with = 0, without = 0;
  for (int i = 0; i < 300; ++i) {
    t.world.step(1.0 / 60);
    ++(held(t) ? with : without);
    const Real angle = coordinate(t, 0, Coordinate::twist);
    assert_true(angle > -0.55 && angle < 0.15);
    assert_true(energy_of(t) < energy + 1e-4 * kG);
    energy = energy_of(t);
  }
  assert_true(with > 1 && without > 1);
}

/// Threads, and islands that it has nothing to do with, change no bit of an island.
static void islands_are_their_own(void**) {
  struct Many : TestWorld {
    Many() {
      by_rattle(*this, 4, 2);
      for (int k = 0; k < 12; ++k) {
        std::uint32_t before = kTheWorld;
        for (int i = 0; i < 3 + k; ++i) {
          const std::uint32_t next = add_body(*this, Vec3(i + 0.5, 0, 3 * k), 1 + k, Vec3(0.1, 0.2, 0.25));
          join(*this, i % 2 ? JointKind::ball : JointKind::hinge, before, next, Vec3(i, 0, 3 * k), x_along(Vec3(0, 0, 1)));
          before = next;
        }
      }
    }
  };
  const std::uint64_t one = hash_of_run<Many>(kAutoChoice, 1, 60);
  for (const std::uint32_t threads : {2u, 4u}) assert_int_equal(one, hash_of_run<Many>(kAutoChoice, threads, 60));
  TestWorld alone, among;
  for (TestWorld* t : {&alone, &among}) {
    by_rattle(*t, 6);
    hang_two(*t, 1, 2, JointKind::ball);
    if (t == &among) hang_rod(*t, 1), chain(*t, 5, 0.2, 1, 3);
    t->run(60, 1.0 / 60);
  }
  for (std::uint32_t i = 0; i < 2; ++i) {
    assert_true(alone.world.state.x[i] == among.world.state.x[i] && alone.world.state.q[i] == among.world.state.q[i]);
    assert_true(alone.world.state.omega[i] == among.world.state.omega[i]);
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
      join(t, JointKind::hinge, kTheWorld, rod, Vec3::zero(), x_along(Vec3(0, 0, 1)));
      SpringDef spring;
      spring.body_b = rod, spring.anchor_a = Vec3(1, 0, 0), spring.rest = 0.5, spring.stiffness = 10, spring.damping = 1;
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
        join(t, slides ? JointKind::slider : JointKind::hinge, kTheWorld, body, Vec3::zero(), x_along(Vec3(0, 0, 1)));
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

/// What joints bear: of a rod that hangs at rest its weight, of one that swings through the bottom m (g + w^2 l / 2).
static void forces_are_told(void**) {
  for (const int order : {0, 2, 6}) {
    TestWorld t;
    by_rattle(t, order);
    hang_rod(t, 0);
    t.run(10, 1.0 / 60);
    assert_true(std::fabs(joint(t, 0).force.y() - kG) < 1e-9 && joint(t, 0).torque.norm() < 1e-9);
    TestWorld swinging;
    by_rattle(swinging, order);
    const std::uint32_t rod = hang_rod(swinging, 0);
    swinging.world.set_velocity(rod, Vec3(1, 0, 0), Vec3(0, 0, 2));
    swinging.world.step(1e-4);
    assert_true(std::fabs(joint(swinging, 0).force.y() - (kG + 2)) < 1e-3);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_pendulum_has_its_order),
      cmocka_unit_test(a_double_pendulum_has_its_order),
      cmocka_unit_test(a_lopsided_top_has_its_order),
      cmocka_unit_test(chains_and_trees_do_not_gape),
      cmocka_unit_test(a_loop_has_its_order),
      cmocka_unit_test(energy_does_not_drift),
      cmocka_unit_test(contacts_come_and_go),
      cmocka_unit_test(limits_fall_back),
      cmocka_unit_test(islands_are_their_own),
      cmocka_unit_test(what_reads_velocities_is_of_second_order),
      cmocka_unit_test(springs_have_their_order),
      cmocka_unit_test(rk4_has_its_order_with_joints),
      cmocka_unit_test(forces_are_told),
  };
  return cmocka_run_group_tests_name("oracle/rattle", tests, nullptr, nullptr);
}
