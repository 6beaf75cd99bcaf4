// What stands on ground whose velocity a host changes from step to step: lorries in a bend, trays that shake, lifts that
// brake. Friction and weight that suffice for the motion keep it in its place, with any number of substeps.
#include <algorithm>
#include <cmath>
#include <functional>

#include "carom_test.h"
#include "dynamics/snapshot/snapshot.h"
#include "joint_scenes.h"
#include "sliced.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kTau = 6.283185307179586;
constexpr Real kBegins = 1;       // s, until all bears what it will
constexpr Real kSolved = 2.5e-5;  // m/s: a quarter of velocity_tolerance, as loads change to and fro

/// A way as a function of time: where the bed is, and how it is turned about an axis.
struct Way {
  std::function<Vec3(Real)> at;
  Vec3 axis = Vec3(0, 1, 0);
  std::function<Real(Real)> angle = [](Real) { return 0.0; };
};

struct Load {
  Vec3 half;  // m
  bool is_round;
  Vec3 place;  // m, of its middle on the bed
  int bodies = 1;
};

struct Ride {
  Real dt = 1.0 / 60, substeps = 4, friction = 1;
  std::uint32_t solver = kAutoChoice;

  /// m, how far any of the loads leaves its place on the bed. The host says the velocity that leads the bed where its way
  /// is at the end of each step.
  Real off(const Way& way, const Load& load, Real seconds) const {
    TestWorld t;
    choose(t, static_cast<int>(solver), static_cast<int>(substeps));
    const std::uint32_t m = t.material(friction, 0);
    const Quat first = exp_map(way.angle(0) * way.axis);
    const std::uint32_t bed = t.add(t.keep(box(Vec3(3, 0.1, 3))), way.at(0), BodyType::kinematic, first, m);
    std::vector<std::uint32_t> loads;
    const Vec3 v = (way.at(dt) - way.at(0)) / dt, omega = (way.angle(dt) - way.angle(0)) / dt * way.axis;
    for (int i = 0; i < load.bodies; ++i) {
      const Vec3 place = first * (load.place + Vec3(0, 0.1 + (2 * i + 1) * load.half.y(), 0));
      const Shape* shape = t.keep(load.is_round ? cylinder(load.half.x(), load.half.y()) : box(load.half));
      loads.push_back(t.add(shape, way.at(0) + place, BodyType::dynamic, first, m));
      t.world.set_velocity(loads.back(), v + omega.cross(place), omega);
    }
    std::vector<Vec3> begun(loads.size());
    Real worst = 0;
    const int steps = static_cast<int>(std::lround(seconds / dt)), begins = static_cast<int>(std::lround(kBegins / dt));
    for (int i = 0; i < begins + steps; ++i) {
      const Real now = i * dt, then = now + dt;
      t.world.set_velocity(bed, (way.at(then) - t.world.state.x[bed]) / dt,
                           (way.angle(then) - way.angle(now)) / dt * way.axis);
      t.world.step(dt);
      for (std::size_t k = 0; k < loads.size(); ++k) {
        const Vec3 seen = t.world.state.q[bed].conjugate() * (t.world.state.x[loads[k]] - t.world.state.x[bed]);
        if (i < begins)
          begun[k] = seen;
        else
          worst = std::max(worst, (seen - begun[k]).norm());
      }
    }
    return worst;
  }
};

Way bend(Real radius, Real spin) {
  return {[=](Real t) { return Vec3(radius * std::cos(spin * t), 0, -radius * std::sin(spin * t)); }, Vec3(0, 1, 0),
          [=](Real t) { return spin * t; }};
}
/// Along an axis, to and fro or up and down.
Way shake(const Vec3& axis, Real most, Real rate) {
  return {[=](Real t) { return Vec3(most / (rate * rate) * std::sin(rate * t) * axis); }};
}

const Load kLoads[] = {{Vec3(0.2, 0.2, 0.2), false, Vec3(0, 0, 0)},
                       {Vec3(0.25, 0.2, 0.25), true, Vec3(0.5, 0, 1)},
                       {Vec3(0.4, 0.15, 0.3), false, Vec3(-0.6, 0, -2)}};

}  // namespace

/// Up to two thirds of what friction bears. A thousandth of the radius in a hundred turns.
static void what_a_lorry_carries_round_a_bend_stays(void**) {
  struct Case {
    Real spin, radius;
  };
  for (const Case& c : {Case{0.1, 60}, Case{0.2, 40}, Case{0.4, 25}, Case{0.4, 10}, Case{0.5, 12}, Case{1, 4}})
    for (const Load& load : kLoads) {
      const Real turns = sliced<Real>(3, 1, 0.3), bar = 1e-3 * c.radius * turns / 100;
      const Real off = Ride().off(bend(c.radius, c.spin), load, turns * kTau / c.spin);
      print_message("%.1f rad/s, %.0f m, %s: off %.1e m of %.1e\n", c.spin, c.radius, load.is_round ? "drum" : "box",
                    off, bar);
      assert_true(off < bar);
    }
}

/// A way that any number of substeps, rates and solvers follow; what is soft gives way by its springs.
static void nor_does_it_leave_its_place_at_other_steps(void**) {
  for (const Real dt : {1.0 / 30, 1.0 / 60, 1.0 / 240})
    for (const Real substeps : {1.0, 2.0, 8.0})
      for (const std::uint32_t solver : {std::uint32_t(kSoftChoice), std::uint32_t(kDirectChoice)}) {
        Ride ride;
        ride.dt = dt, ride.substeps = substeps, ride.solver = solver;
        const Real off = ride.off(bend(9, 0.7), kLoads[0], 10);
        print_message("solver %u, 1/%.0f s, %.0f substeps: off %.1e m\n", solver, 1 / dt, substeps, off);
        assert_true(off < 1e-4);
      }
}

/// Trays that go to and fro with up to 0.8 of what friction bears, lifts that fall with up to 0.9 of gravity. What lifts
/// rise under may sink by what the solver leaves of a velocity, which is no slip.
static void what_stands_on_what_shakes_stays(void**) {
  struct Case {
    Vec3 axis;
    Real most, rate, friction;
  };
  for (const Case& c :
       {Case{Vec3(1, 0, 0), 7.8, 3, 1}, Case{Vec3(1, 0, 0), 2.4, 7, 0.3}, Case{Vec3(0, 1, 0), 8.8, 4, 1},
        Case{Vec3(0, 1, 0), 5, 12, 0.5}, Case{Vec3(0.8, 0.6, 0), 4, 5, 1}})
    for (const Load& load : kLoads) {
      Ride ride;
      ride.friction = c.friction;
      const Real off = ride.off(shake(c.axis, c.most, c.rate), load, 10);
      print_message("%.1f m/s^2 at %.0f rad/s, friction %.1f: off %.1e m\n", c.most, c.rate, c.friction, off);
      const Real borne = kSolved * (kBegins + 10);
      assert_true(off < (c.axis.y() > 0 ? borne : 1e-5));
    }
}

// ---- scenes that nothing was made for ----

/// A ship rolls about its length and heaves.
static void what_lies_on_a_deck_stays(void**) {
  for (const Load& load : kLoads) {
    const Way ship = {[](Real t) { return Vec3(2 * t, 0.8 * std::sin(0.9 * t), 0.5 * std::sin(0.4 * t)); },
                      Vec3(1, 0, 0), [](Real t) { return 0.2 * std::sin(0.7 * t); }};
    const Real off = Ride().off(ship, load, 30);
    print_message("deck: off %.1e m\n", off);
    assert_true(off < 2e-4);
  }
}

/// A disc that is sped up and slowed down again, with a stack on it.
static void a_stack_on_a_disc_that_changes_its_speed_stays(void**) {
  const Way disc = {[](Real) { return Vec3(0, 0, 0); }, Vec3(0, 1, 0), [](Real t) { return 3 * std::sin(0.5 * t); }};
  const Load stack = {Vec3(0.15, 0.1, 0.15), false, Vec3(1.2, 0, 0.4), 3};
  const Real off = Ride().off(disc, stack, 25);
  print_message("disc: off %.1e m\n", off);
  assert_true(off < 2e-4);
}

/// A bus brakes, stands, pulls away and turns off: its speed is a smooth curve, its way the integral.
static void what_stands_in_a_bus_stays(void**) {
  const auto heading = [](Real t) { return 0.6 * (1 - std::cos(0.3 * t)); };
  const Way bus = {[=](Real t) {
                     Vec3 x = Vec3::zero();
                     constexpr int kParts = 400;
                     for (int i = 0; i < kParts; ++i) {
                       const Real at = t * (i + 0.5) / kParts, speed = 6 + 6 * std::cos(0.5 * at), a = heading(at);
                       x += t / kParts * speed * Vec3(std::cos(a), 0, -std::sin(a));
                     }
                     return x;
                   },
                   Vec3(0, 1, 0), heading};
  for (const Load& load : kLoads) {
    const Real off = Ride().off(bus, load, 20);
    print_message("bus: off %.1e m\n", off);
    assert_true(off < 2e-4);
  }
}

/// What comes alone is a jump, as the host says: nothing swings past it. And after each step the body is where the host's
/// velocity leads, with that velocity.
static void a_jump_stays_a_jump(void**) {
  TestWorld t(Vec3::zero());
  choose(t, kAutoChoice, 4);
  const Shape* const pad = t.keep(box(Vec3(0.1, 0.5, 0.5)));
  const std::uint32_t paddle = t.add(pad, Vec3::zero(), BodyType::kinematic);
  const std::uint32_t ball = t.add(t.keep(sphere(0.1)), Vec3(0.2 + 1e-9, 0, 0), BodyType::dynamic);
  const Real dt = 1.0 / 60;
  for (const Real speed : {0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0}) {
    t.world.set_velocity(paddle, Vec3(speed, 0, 0), Vec3::zero());
    t.world.step(dt);
  }
  const Real fastest = t.world.state.v[ball].x();
  print_message("ball goes at %.9f m/s\n", fastest);
  assert_true(std::fabs(fastest - 1) < 1e-6);

  const std::uint32_t top = t.add(pad, Vec3(5, 5, 5), BodyType::kinematic);
  t.add(t.keep(box(Vec3::constant(0.1))), Vec3(5.2, 5, 5));  // else nothing needs substeps
  for (int i = 0; i < 100; ++i) {
    const Vec3 v(std::sin(0.1 * i), std::cos(0.07 * i), 0.02 * i), omega(0.1 * i, 3 * std::cos(0.05 * i), 1);
    const Vec3 x = t.world.state.x[top];
    const Quat q = t.world.state.q[top];
    t.world.set_velocity(top, v, omega);
    t.world.step(dt);
    assert_true(t.world.state.v[top] == v && t.world.state.omega[top] == omega);
    assert_true((t.world.state.x[top] - (x + dt * v)).norm() < 1e-14);
    const Quat left = t.world.state.q[top] * (exp_map(dt * omega) * q).conjugate();
    assert_true(left.vec().norm() < 1e-12);
  }
}

/// A world goes on from a snapshot as it went on itself.
static void it_is_saved_and_restored(void**) {
  TestWorld t;
  const std::uint32_t m = t.material(1, 0);
  const std::uint32_t bed = t.add(t.keep(box(Vec3(2, 0.1, 2))), Vec3::zero(), BodyType::kinematic, Quat::identity(), m);
  const std::uint32_t gone =
      t.add(t.keep(box(Vec3(1, 0.1, 1))), Vec3(9, 0, 0), BodyType::kinematic, Quat::identity(), m);
  const std::uint32_t load = t.add(t.keep(box(Vec3::constant(0.2))), Vec3(0.5, 0.3, 0), BodyType::dynamic);
  const auto run = [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      t.world.set_velocity(bed, Vec3(std::sin(0.05 * i), 0, 0), Vec3(0, 0.02 * i, 0));
      t.world.step(1.0 / 60);
    }
    return t.world.state.x[load];
  };
  t.world.set_velocity(gone, Vec3(0, 1, 0), Vec3::zero());
  run(0, 30);
  t.world.remove_body(gone);
  std::vector<std::byte> bytes(save_state(t.world, nullptr, 0));
  save_state(t.world, bytes.data(), bytes.size());
  assert_int_equal(t.world.state.driven.size(), 2);
  const Vec3 once = run(30, 60);
  SnapshotFault fault;
  assert_true(restore_state(t.world, bytes.data(), bytes.size(), fault));
  assert_int_equal(t.world.state.driven.size(), 1);
  assert_true(run(30, 60) == once);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(what_a_lorry_carries_round_a_bend_stays),
      cmocka_unit_test(nor_does_it_leave_its_place_at_other_steps),
      cmocka_unit_test(what_stands_on_what_shakes_stays),
      cmocka_unit_test(what_lies_on_a_deck_stays),
      cmocka_unit_test(a_stack_on_a_disc_that_changes_its_speed_stays),
      cmocka_unit_test(what_stands_in_a_bus_stays),
      cmocka_unit_test(a_jump_stays_a_jump),
      cmocka_unit_test(it_is_saved_and_restored),
  };
  return cmocka_run_group_tests_name("oracle/driven", tests, nullptr, nullptr);
}
