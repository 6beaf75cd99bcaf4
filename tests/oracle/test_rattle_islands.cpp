// Islands that joints alone hold, moved by RATTLE: gaps at rounding, energy in the long run, how islands come and go.
#include <algorithm>

#include "carom_test.h"
#include "rattle_scenes.h"
#include "sliced.h"

using namespace carom;
using namespace carom::test;

/// 40 links of 0.1 m, let go from the horizontal: no gap beyond rounding of their places, though the end cracks like a
/// whip. Trees and stars likewise.
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
    std::printf("  order %d: gap %.2g m, energy %.2g J\n", order, gap, energy_of(t) - before);
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

/// Square nets in flight: small ones move by RATTLE, large ones, whose factor would take seconds, as without the dial.
static void large_nets_are_left_to_the_solver(void**) {
  for (const std::uint32_t n : {3u, 5u, 30u}) {
    TestWorld t;
    by_rattle(t, 2, 4);
    std::vector<std::uint32_t> bodies;
    for (std::uint32_t i = 0; i < n * n; ++i)
      bodies.push_back(add_body(t, Vec3(0.3 * (i % n), 0, 0.3 * (i / n)), 0.1, Vec3(0.001, 0.001, 0.001)));
    for (std::uint32_t i = 0; i < n * n; ++i) {
      const Vec3 at = t.world.state.x[bodies[i]];
      if (i % n + 1 < n) join(t, JointKind::ball, bodies[i], bodies[i + 1], at + Vec3(0.15, 0, 0));
      if (i + n < n * n) join(t, JointKind::ball, bodies[i], bodies[i + n], at + Vec3(0, 0, 0.15));
    }
    t.world.step(1.0 / 60);
    assert_int_equal(held(t), n < 30);
  }
}

/// A million steps, by night: energy swings with the rod and does not drift. What its least and greatest over the first and the
/// last tenth differ by is rounding: as many times, each of it at most a unit of 20 J.
static void energy_does_not_drift(void**) {
  TestWorld t;
  by_rattle(t, 2);
  hang_rod(t, 2);
  Real least[2] = {1e9, 1e9}, most[2] = {-1e9, -1e9};
  const int steps = sliced(1000000, 300000, 100000);
  for (int i = 0; i < steps; ++i) {
    t.world.step(1.0 / 240);
    const int part = i < steps / 10 ? 0 : i >= steps / 10 * 9 ? 1 : -1;
    if (part < 0) continue;
    const Real energy = energy_of(t);
    least[part] = std::min(least[part], energy), most[part] = std::max(most[part], energy);
  }
  std::printf("  energy %.12g to %.12g J, then %.12g to %.12g\n", least[0], most[0], least[1], most[1]);
  const Real roundings = steps * 20 * kEpsilon;
  assert_true(std::fabs(least[1] - least[0]) < roundings && std::fabs(most[1] - most[0]) < roundings);
}

/// A ball on a rod swings into a wall and back: with a contact it is answered as without the dial, and comes back. No
/// step gives energy but by what RATTLE's own energy swings.
static void contacts_come_and_go(void**) {
  TestWorld t;
  by_rattle(t, 4, 4);
  const std::uint32_t ball = t.add(t.keep(sphere(0.1)), Vec3(-0.8, -0.6, 0));
  join(t, JointKind::ball, kInvalid, ball, Vec3::zero());
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

/// A limit that is not reached changes no bit; one that is reached holds what comes to rest on it.
static void limits_hold(void**) {
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
  assert_true(with >= 290);
  assert_true(std::fabs(std::fabs(coordinate(t, 0, Coordinate::twist) + 0.2) - 0.3) < 1e-13);  // at one of the two
}

/// Threads, and islands that it has nothing to do with, change no bit of an island.
static void islands_are_their_own(void**) {
  struct Many : TestWorld {
    Many() {
      by_rattle(*this, 4, 2);
      for (int k = 0; k < 12; ++k) {
        std::uint32_t before = kInvalid;
        for (int i = 0; i < 3 + k; ++i) {
          const std::uint32_t next = add_body(*this, Vec3(i + 0.5, 0, 3 * k), 1 + k, Vec3(0.1, 0.2, 0.25));
          join(*this, i % 2 ? JointKind::ball : JointKind::hinge, before, next, Vec3(i, 0, 3 * k),
               x_along(Vec3(0, 0, 1)));
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

/// A distance joint with a spring has no lock, so an island of one has no row. A ball that hangs on it swings by a
/// cosine; one beside it has locks, and one hangs on two such springs.
static void springs_alone_are_held_too(void**) {
  const Real f = 1.5, w = 2 * kPi * f, time = 1.1;
  const auto error_of = [&](int order, int steps, int springs) {
    TestWorld t;
    by_rattle(t, order);
    const std::uint32_t ball = add_body(t, Vec3(3, 5, 0), 2, Vec3::constant(0.1));
    for (int k = 0; k < springs; ++k) {
      JointDef def = joint_at(t, JointKind::distance, kInvalid, ball, Vec3(3, 5, 0));
      def.frame_a.p = Vec3(3, k == 0 ? 7 : 3, 0);
      set_spring(t, handle_slot(t.world.add_joint(def)), Coordinate::distance, 2, f, 0);
    }
    hang_rod(t, 0.5);
    t.run(steps, time / steps);
    assert_int_equal(held(t), 2);
    const Real rate = w * std::sqrt(Real(springs)), sag = kG / (rate * rate);
    return std::fabs(t.world.state.x[ball].y() - (5 - sag * (1 - std::cos(rate * time))));
  };
  for (const int springs : {1, 2})
    for (const int order : {2, 4, 6}) {
      const Real coarse = error_of(order, 40, springs), fine = error_of(order, 80, springs);
      std::printf("  %d springs, order %d: %.2e m, halved %.2e m\n", springs, order, coarse, fine);
      assert_true(coarse < (order == 2 ? 1e-2 : 1e-4));
      if (fine > 1e-12) assert_true(std::fabs(std::log2(coarse / fine) - order) < 0.5);
    }
}

namespace {

void tie(TestWorld& t, std::uint32_t a, std::uint32_t b, const Vec3& at_a, const Vec3& at_b, Real rest, Real stiffness,
         Real damping = 0) {
  SpringDef def;
  def.body_a = a, def.body_b = b, def.anchor_a = at_a, def.anchor_b = at_b;
  def.rest = rest, def.stiffness = stiffness, def.damping = damping;
  t.world.add_spring(def);
}

/// m: by how far two masses between walls, on three springs of 50 N/m, are off after 3 s: the sum of two modes.
Real masses_on_springs(int order, int steps) {
  TestWorld t(Vec3::zero());
  by_rattle(t, order);
  const std::uint32_t a = add_body(t, Vec3(1.2, 0, 0), 1, Vec3(1, 1, 1)),
                      b = add_body(t, Vec3(2, 0, 0), 1, Vec3(1, 1, 1));
  tie(t, kInvalid, a, Vec3::zero(), Vec3::zero(), 1, 50), tie(t, a, b, Vec3::zero(), Vec3::zero(), 1, 50);
  tie(t, kInvalid, b, Vec3(3, 0, 0), Vec3::zero(), 1, 50);
  t.run(steps, 3.0 / steps);
  const Real both = 0.1 * std::cos(std::sqrt(Real(50)) * 3), apart = 0.1 * std::cos(std::sqrt(Real(150)) * 3);
  return std::fabs(t.world.state.x[a].x() - (1 + both + apart)) +
         std::fabs(t.world.state.x[b].x() - (2 + both - apart));
}

/// m: a ball that swings on a spring in space, beside its equation of motion in steps of a thousandth.
Real ball_on_a_spring(int order, int steps) {
  constexpr Real kStiff = 80, kRest = 0.5, kMass = 2, kTime = 2;
  TestWorld t;
  by_rattle(t, order);
  const std::uint32_t ball = add_body(t, Vec3(0.6, 1, 0.2), kMass, Vec3(1, 1, 1));
  t.world.set_velocity(ball, Vec3(0, 0.5, 1), Vec3::zero());
  tie(t, kInvalid, ball, Vec3(0, 2, 0), Vec3::zero(), kRest, kStiff);
  t.run(steps, kTime / steps);
  Vec3 x(0.6, 1, 0.2), v(0, 0.5, 1);
  const auto accel = [&](const Vec3& at) {
    const Vec3 r = at - Vec3(0, 2, 0);
    return Vec3(Vec3(0, -kG, 0) - (kStiff / kMass * (1 - kRest / r.norm())) * r);
  };
  constexpr int kFine = 20000;
  for (int i = 0; i < kFine; ++i) {
    const Real h = kTime / kFine;
    const Vec3 a = accel(x), b = accel(x + h / 2 * v), c = accel(x + h / 2 * v + h * h / 4 * a),
               d = accel(x + h * v + h * h / 2 * b);
    x += h * v + h * h / 6 * (a + b + c), v += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return (t.world.state.x[ball] - x).norm();
}

/// m/s: what quadratic drag leaves of a speed: v / (1 + c v t / m).
Real dragged(int order, int steps) {
  TestWorld t(Vec3::zero());
  by_rattle(t, order);
  const std::uint32_t body = add_body(t, Vec3::zero(), 2, Vec3(1, 1, 1));
  t.world.set_velocity(body, Vec3(8, 0, 0), Vec3::zero());
  t.world.set_attribute(body, AttributeId::drag, {0, 0.3});
  t.run(steps, 1.5 / steps);
  return std::fabs(t.world.state.v[body].x() - 8 / (1 + 0.3 * 8 * 1.5 / 2));
}

}  // namespace

/// Where a host asks for order 4 or 6, forces have it without any joint; what reads velocities is of third order.
static void forces_alone_are_of_the_order_asked_for(void**) {
  struct Case {
    const char* what;
    Real (*error)(int order, int steps);
    int steps;
    Real order_of_4, order_of_6;
  };
  for (const Case& c : {Case{"masses", masses_on_springs, 180, 4, 6},
                        {"ball", ball_on_a_spring, 120, 4, 6},
                        {"drag", dragged, 40, 3, 3}})
    for (const int order : {2, 4, 6}) {
      const Real coarse = c.error(order, c.steps), fine = c.error(order, 2 * c.steps);
      std::printf("  %s, order %d: %.2e, halved %.2e\n", c.what, order, coarse, fine);
      const Real least = order == 2 ? 2 : order == 4 ? c.order_of_4 : c.order_of_6;
      if (fine > 1e-11) assert_true(std::log2(coarse / fine) > least - 0.4);
    }
}

/// A ball on a spring that reaches the ground is the solver's while it touches, and its forces' again in the air.
static void what_forces_move_may_land(void**) {
  TestWorld t;
  by_rattle(t, 4);
  t.ground();
  const std::uint32_t ball = t.add(t.keep(sphere(0.2)), Vec3(0, 1.2, 0));
  tie(t, kInvalid, ball, Vec3(0, 3, 0), Vec3::zero(), 1, 100);
  std::size_t in_air = 0, touching = 0;
  for (int i = 0; i < 240; ++i) {
    t.world.step(1.0 / 60);
    ++(held(t) ? in_air : touching);
    assert_true(t.world.state.x[ball].y() > 0.19);
  }
  assert_true(in_air > 0 && touching > 0);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(chains_and_trees_do_not_gape),
      cmocka_unit_test(large_nets_are_left_to_the_solver),
      cmocka_unit_test(energy_does_not_drift),
      cmocka_unit_test(contacts_come_and_go),
      cmocka_unit_test(limits_hold),
      cmocka_unit_test(islands_are_their_own),
      cmocka_unit_test(forces_are_told),
      cmocka_unit_test(springs_alone_are_held_too),
      cmocka_unit_test(forces_alone_are_of_the_order_asked_for),
      cmocka_unit_test(what_forces_move_may_land),
  };
  return cmocka_run_group_tests_name("oracle/rattle_islands", tests, nullptr, nullptr);
}
