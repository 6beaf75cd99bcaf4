// Joints against closed forms: pendulums, springs, motors, limits, what a clamp bears.
#include <algorithm>

#include "carom_test.h"
#include "dynamics/stages.h"
#include "fine_top.h"
#include "joint_scenes.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kPi = 3.14159265358979323846;
constexpr int kAllSolvers[] = {kSoftChoice, kDirectChoice, kAutoChoice};

/// Period of a pendulum of amplitude a: 4 K(sin a/2) / w0, by the arithmetic-geometric mean.
Real period(Real w0, Real amplitude) {
  Real a = 1, b = std::cos(amplitude / 2);
  for (int i = 0; i < 40; ++i) {
    const Real m = (a + b) / 2;
    b = std::sqrt(a * b), a = m;
  }
  return 2 * kPi / (w0 * a);
}

struct PendulumErrors {
  Real place = 0, energy = 0, gap = 0;
};

/// A thin rod of 1 m and 1 kg hung by one end, let go from the horizontal; after one period it is there again.
PendulumErrors swing_rod(int solver, int substeps, int steps) {
  TestWorld t;
  choose(t, solver, substeps), leave_joints_to_solver(t);
  const Real inertia = 1.0 / 12;
  const std::uint32_t rod = add_body(t, Vec3(0.5, 0, 0), 1, Vec3::constant(inertia));
  join(t, JointKind::ball, kInvalid, rod, Vec3::zero());
  const Real w0 = std::sqrt(kG * 0.5 / (inertia + 0.25)), all = period(w0, kPi / 2);
  PendulumErrors worst;
  for (int i = 0; i < steps; ++i) {
    t.world.step(all / steps);
    worst.energy = std::max(worst.energy, std::fabs(energy_of(t)) / (kG * 0.5));
    worst.gap = std::max(worst.gap, gap_of(t, 0));
  }
  worst.place = (t.world.state.x[rod] - Vec3(0.5, 0, 0)).norm();
  return worst;
}

Quat axis_z() { return x_along(Vec3(0, 0, 1)); }

}  // namespace

/// Second order: what energy and gap err by at most falls by four with half the substep (a tenth of leeway for the next
/// order). Where it ends errs by less than the amplitude of a leapfrog's swing does, (w h)^2 / 24, w 5.4 rad/s at the
/// bottom: of several parts that have either sign, so it has no slope of its own.
static void a_pendulum_is_of_second_order(void**) {
  for (const int solver : kAllSolvers) {
    PendulumErrors before = swing_rod(solver, 4, 97);
    for (const int substeps : {8, 16}) {
      const PendulumErrors now = swing_rod(solver, substeps, 97);
      const Real h = 1.622 / 97 / substeps;
      assert_true(now.energy < before.energy / 3.6 && now.place < 5.4 * 5.4 * h * h / 24);
      if (solver == kSoftChoice) assert_true(now.gap < before.gap / 3.6);
      before = now;
    }
    assert_true(before.energy < 5.4 * 5.4 * 1.1e-6);              // (w h)^2
    if (solver >= kDirectChoice) assert_true(before.gap < 2e-9);  // what is less is not parted
  }
}

/// A wheel on a hinge with a spring: its frequency is what was asked for, to (w h)^2 / 24.
static void a_spring_swings_at_its_frequency(void**) {
  const Real f = 2, w = 2 * kPi * f;
  for (const int solver : kAllSolvers)
    for (const bool off_centre : {false, true}) {
      TestWorld t(Vec3::zero());
      choose(t, solver);
      // Off its centre of mass the hinge has all of m r^2 to turn: the spring knows.
      const Vec3 at = off_centre ? Vec3(0.7, 0, 0) : Vec3::zero();
      const std::uint32_t wheel = add_body(t, at, 3, Vec3(0.5, 0.6, 0.8));
      const std::uint32_t hinge = join(t, JointKind::hinge, kInvalid, wheel, Vec3::zero(), axis_z());
      set_spring(t, hinge, Coordinate::twist, 0.1, f, 0);  // let go at an amplitude of 0.1
      const Real dt = 1.0 / 240, h = dt / 4;
      Real before = -0.1, crossing = 0, amplitude = 0;
      int count = 0;
      for (int i = 1; count < 9; ++i) {
        t.world.step(dt);
        const Real x = coordinate(t, hinge, Coordinate::twist) - 0.1;
        amplitude = std::max(amplitude, x);
        if ((x > 0) != (before > 0)) crossing = dt * (i - 1 + before / (before - x)), ++count;
        before = x;
      }
      const Real expected = 8.5 / 2 / f;  // the ninth crossing
      // And a chord for the arc between two steps: (w dt)^2/16 of dt at most, next to nothing at a zero.
      const Real tolerance = w * w * h * h / 24 * expected + h / 2;  // half a substep: who moves first
      assert_true(std::fabs(crossing - expected) < 1.02 * tolerance);
      assert_true(std::fabs(amplitude - 0.1) < 0.1 * w * h);
    }
}

/// Damped, its swings fade by exp(-2 pi zeta / sqrt(1 - zeta^2)) each, to zeta w h of the exponent.
static void a_damped_spring_fades(void**) {
  const Real f = 2, w = 2 * kPi * f, zeta = 0.1;
  for (const int solver : kAllSolvers) {
    TestWorld t(Vec3::zero());
    choose(t, solver);
    const std::uint32_t cart = add_body(t, Vec3(0, 0, 0), 3, Vec3(0.5, 0.6, 0.8));
    const std::uint32_t slider = join(t, JointKind::slider, kInvalid, cart, Vec3::zero(), axis_z());
    set_spring(t, slider, Coordinate::slide, 0.1, f, zeta);
    const Real dt = 1.0 / 240, h = dt / 4, wd = w * std::sqrt(1 - zeta * zeta);
    Real lowest = 0;  // the first swing back, one period after
    for (int i = 1; i * dt < 1.2 * 2 * kPi / wd; ++i) {
      t.world.step(dt);
      if (i * dt > 0.8 * 2 * kPi / wd) lowest = std::min(lowest, coordinate(t, slider, Coordinate::slide) - 0.1);
    }
    const Real exponent = zeta * w * 2 * kPi / wd, expected = -0.1 * std::exp(-exponent);
    assert_true(std::fabs(lowest / expected - 1) < 1.5 * exponent * zeta * w * h + w * w * dt * dt / 8);
  }
}

/// Loaded, it sags by g / w^2, whatever the damping and the substep.
static void a_spring_sags_by_its_load(void**) {
  const Real f = 3, w = 2 * kPi * f;
  for (const int solver : kAllSolvers)
    for (const int substeps : {1, 4}) {
      TestWorld t;
      choose(t, solver, substeps);
      const std::uint32_t cart = add_body(t, Vec3(0, 5, 0), 7, Vec3(0.5, 0.6, 0.8));
      const std::uint32_t slider = join(t, JointKind::slider, kInvalid, cart, Vec3(0, 5, 0), x_along(Vec3(0, 1, 0)));
      set_spring(t, slider, Coordinate::slide, 0, f, 1);
      const std::uint32_t hung = add_body(t, Vec3(3, 5, 0), 2, Vec3::constant(0.1));
      JointDef def = joint_at(t, JointKind::distance, kInvalid, hung, Vec3(3, 5, 0));
      def.frame_a.p = Vec3(3, 7, 0);
      const std::uint32_t spring = handle_slot(t.world.add_joint(def));
      set_spring(t, spring, Coordinate::distance, 2, f, 1);
      t.run(600, 1.0 / 60);
      assert_true(std::fabs(coordinate(t, slider, Coordinate::slide) + kG / (w * w)) < 1e-7);
      assert_true(std::fabs(coordinate(t, spring, Coordinate::distance) - 2 - kG / (w * w)) < 1e-7);
      assert_true(std::fabs(joint(t, spring).force.y() - 2 * kG) < 1e-5);
    }
}

/// A motor of 6 N m brings a wheel of 0.8 kg m^2 to 5 rad/s in 2/3 s, evenly, and keeps it there; a heavier load stops
/// it.
static void a_motor_reaches_its_speed(void**) {
  for (const int solver : kAllSolvers) {
    TestWorld t(Vec3::zero());
    choose(t, solver);
    const std::uint32_t wheel = add_body(t, Vec3::zero(), 3, Vec3(0.5, 0.6, 0.8));
    const std::uint32_t hinge = join(t, JointKind::hinge, kInvalid, wheel, Vec3::zero(), axis_z());
    set_motor(t, hinge, Coordinate::twist, 5, 6);
    t.run(30, 1.0 / 60);
    assert_true(std::fabs(t.world.state.omega[wheel].z() - 6 / 0.8 * 0.5) < 1e-6);
    assert_true((joint(t, hinge).torque - Vec3(0, 0, 6)).norm() < 1e-5);
    t.run(30, 1.0 / 60);
    assert_true(std::fabs(t.world.state.omega[wheel].z() - 5) < 1e-6);
    assert_true(joint(t, hinge).torque.norm() < 1e-4);
    t.world.set_force(wheel, Vec3::zero(), Vec3(0, 0, -8));
    t.world.step(1.0 / 60);
    assert_true(std::fabs(t.world.state.omega[wheel].z() - (5 - 2 / 0.8 / 60)) < 1e-6);
  }
}

/// What slides down a rail of 30 degrees stops at its end and is borne there; a cone and a rope hold likewise.
static void limits_hold(void**) {
  for (const int solver : kAllSolvers) {
    TestWorld t;
    choose(t, solver);
    const Vec3 down = Vec3(std::cos(kPi / 6), -0.5, 0);
    const std::uint32_t cart = add_body(t, Vec3::zero(), 4, Vec3(0.5, 0.6, 0.8));
    const std::uint32_t rail = join(t, JointKind::slider, kInvalid, cart, Vec3::zero(), x_along(down));
    set_limit(t, rail, Coordinate::slide, -1, 0.5);
    const std::uint32_t rod = add_body(t, Vec3(10, 0.5, 0), 1, Vec3::constant(1.0 / 12));
    const std::uint32_t cone = join(t, JointKind::ball, kInvalid, rod, Vec3(10, 0, 0), x_along(Vec3(0, 1, 0)));
    set_limit(t, cone, Coordinate::swing, 0, 0.4);
    t.world.set_velocity(rod, Vec3(0.5, 0, 0.1), Vec3::zero());
    const std::uint32_t ball = add_body(t, Vec3(21, 0, 0), 1, Vec3::constant(0.1));
    JointDef def = joint_at(t, JointKind::distance, kInvalid, ball, Vec3(21, 0, 0));
    def.frame_a.p = Vec3(20, 0, 0);
    const std::uint32_t rope = handle_slot(t.world.add_joint(def));
    set_limit(t, rope, Coordinate::distance, 0, 1.5);
    Real widest = 0, farthest = 0, longest = 0;
    for (int i = 0; i < 600; ++i) {
      t.world.step(1.0 / 60);
      widest = std::max(widest, coordinate(t, cone, Coordinate::swing));
      farthest = std::max(farthest, coordinate(t, rail, Coordinate::slide));
      longest = std::max(longest, coordinate(t, rope, Coordinate::distance));
    }
    // A limit that was closed at speed u lets by what curves within a substep, and gives by (g / w^2) where it is soft.
    assert_true(widest < 0.4 + 2e-3 && farthest < 0.5 + 2e-3 && longest < 1.5 + 5e-3);
    assert_true(std::fabs(coordinate(t, rail, Coordinate::slide) - 0.5) < 2e-4);
    assert_true((joint(t, rail).force - Vec3(0, 4 * kG, 0)).norm() < 1e-3);
    assert_true(std::fabs(coordinate(t, cone, Coordinate::swing) - 0.4) < 2e-3);
  }
}

/// A cantilever of three boxes: each weld bears the weight beyond it, and its moment.
static void a_cantilever_is_borne(void**) {
  for (const int solver : kAllSolvers) {
    TestWorld t;
    choose(t, solver);
    std::uint32_t before = kInvalid, welds[3];
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t box = add_body(t, Vec3(i + 0.5, 0, 0), 2, Vec3::constant(1.0 / 3));
      welds[i] = join(t, JointKind::weld, before, box, Vec3(i, 0, 0));
      before = box;
    }
    t.run(1200, 1.0 / 60);
    for (int i = 0; i < 3; ++i) {
      const Real weight = 2 * kG * (3 - i), arm = 0.5 * (3 - i);
      assert_true((joint(t, welds[i]).force - Vec3(0, weight, 0)).norm() < 1e-4 * weight);
      assert_true((joint(t, welds[i]).torque - Vec3(0, 0, weight * arm)).norm() < 1e-4 * weight * arm);
    }
  }
}

/// The rows of every kind are the rates of its errors: against differences of where the joint is, at any pose.
static void rows_are_rates_of_errors(void**) {
  std::uint32_t seed = 7;
  const auto random = [&] {
    seed = seed * 1664525u + 1013904223u;
    return static_cast<Real>(seed >> 8) / (1 << 23) - 1;
  };
  const auto vector = [&] { return Vec3{random(), random(), random()}; };
  for (int trial = 0; trial < 100; ++trial)
    for (const auto& freedom : {std::pair(JointKind::ball, Coordinate::twist),
                                {JointKind::ball, Coordinate::swing},
                                {JointKind::hinge, Coordinate::twist},
                                {JointKind::slider, Coordinate::slide},
                                {JointKind::distance, Coordinate::distance},
                                {JointKind::universal, Coordinate::swing}}) {
      const JointKind kind = freedom.first;
      const Coordinate c = freedom.second;
      TestWorld t(Vec3::zero());
      choose(t, kSoftChoice, 1), leave_joints_to_solver(t);
      const auto place = [&] { return normalized(Quat(1.5, random(), random(), random())); };
      const std::uint32_t a = add_body(t, vector(), 1, Vec3(1, 2, 3), BodyType::dynamic, place()),
                          b = add_body(t, vector(), 2, Vec3(2, 3, 1), BodyType::dynamic, place());
      JointDef def;
      def.kind = kind;
      def.body_a = a, def.body_b = b;
      def.frame_a = {place(), vector()}, def.frame_b = {place(), vector()};
      const std::uint32_t j = handle_slot(t.world.add_joint(def));
      set_limit(t, j, c, -1, 1);
      t.world.set_velocity(a, vector(), vector());
      t.world.set_velocity(b, vector(), vector());
      Runs<refresh>::run(t.world, {1e-6, 1e-6});
      const Real before = coordinate(t, j, c);
      plan_joints(t.world, t.world.joints);
      t.world.step(1e-9);  // makes rows
      const JointRowLanes& row = t.world.wide_joints->drives[0].row;
      assert_true(std::fabs(row.error[0] - before) < 1e-7);
      // Move both as free bodies do, and look again.
      const Vec3 va = vector(), wa = vector(), vb = vector(), wb = vector();
      const auto get = [](const LaneVec& v) { return Vec3(v.x[0], v.y[0], v.z[0]); };
      const Real rate = get(row.d).dot(vb - va) + get(row.w_b).dot(wb) - get(row.w_a).dot(wa);
      const Pose pa = t.world.pose(a), pb = t.world.pose(b);
      const Real e = 1e-5;
      const auto at = [&](Real time) {
        const auto moved = [&](const Pose& p, const Vec3& v, const Vec3& w) {
          return Pose{normalized(exp_map(time * w) * p.q), p.p + time * v};
        };
        t.world.set_pose(a, moved(pa, va, wa)), t.world.set_pose(b, moved(pb, vb, wb));
        return coordinate(t, j, c);
      };
      const Real difference = (at(e) - at(-e)) / (2 * e);
      if (c == Coordinate::swing && (before < 0.1 || before > 3)) continue;  // the cone's tip: no direction
      if (c == Coordinate::twist && std::fabs(before) > 3) continue;         // where it winds round
      assert_true(std::fabs(difference - rate) < 1e-6 * (1 + std::fabs(rate)) + 1e-7);
    }
}

namespace {

// The suite's heavy top: a disk that spins at the end of a level stick, whose other end a ball joint holds.
constexpr Real kStick = 0.5, kSpin = 40;
constexpr Real kAxial = 0.5 * 0.5 / 2, kAcross = (3 * 0.5 * 0.5 + 0.1 * 0.1) / 12;  // of 1 kg, r 0.5 m, 0.1 m thick

/// [10] m: where its middle is every 0.2 s.
const std::vector<Vec3>& heavy_top_places() {
  static const std::vector<Vec3> places = [] {
    const Real about_tip = kAcross + kStick * kStick;
    const auto weight = [](Real, const Quat& at) { return (kStick * (at * Vec3::unit_x())).cross(Vec3(0, -kG, 0)); };
    std::vector<Vec3> at;
    for (int k = 1; k <= 10; ++k)
      at.push_back(kStick *
                   (fine_top(Vec3(kAxial, about_tip, about_tip), Vec3(kSpin, 0, 0), 0.2 * k, 2000 * k, weight) *
                    Vec3::unit_x()));
    return at;
  }();
  return places;
}

/// m: how far its middle is off at the worst of these.
Real heavy_top_error(int solver, int substeps) {
  TestWorld t;
  choose(t, solver, substeps), leave_joints_to_solver(t);
  const std::uint32_t disk = add_body(t, Vec3(kStick, 0, 0), 1, Vec3(kAxial, kAcross, kAcross));
  t.world.set_velocity(disk, Vec3::zero(), Vec3(kSpin, 0, 0));
  join(t, JointKind::ball, kInvalid, disk, Vec3::zero());
  Real worst = 0;
  for (const Vec3& place : heavy_top_places()) {
    t.run(12, 1.0 / 60);
    worst = std::max(worst, (t.world.state.x[disk] - place).norm());
  }
  return worst;
}

}  // namespace

/// A tenth of leeway for the next order, (h |omega|)^2 of 1/36 at first.
static void a_heavy_top_is_of_second_order(void**) {
  for (const int solver : kAllSolvers) {
    Real before = heavy_top_error(solver, 4);
    for (const int substeps : {8, 16}) {
      const Real now = heavy_top_error(solver, substeps);
      std::printf("  solver %d, %d substeps: %.3g m, after %.3g\n", solver, substeps, now, before);
      assert_true(now < before / 3.6);
      before = now;
    }
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_pendulum_is_of_second_order),
      cmocka_unit_test(a_heavy_top_is_of_second_order),
      cmocka_unit_test(a_spring_swings_at_its_frequency),
      cmocka_unit_test(a_damped_spring_fades),
      cmocka_unit_test(a_spring_sags_by_its_load),
      cmocka_unit_test(a_motor_reaches_its_speed),
      cmocka_unit_test(limits_hold),
      cmocka_unit_test(a_cantilever_is_borne),
      cmocka_unit_test(rows_are_rates_of_errors),
  };
  return cmocka_run_group_tests_name("oracle/joints", tests, nullptr, nullptr);
}
