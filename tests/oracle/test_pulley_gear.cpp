// Pulleys and gears against closed forms, under every solver that knows joints and at two substeps.
#include <algorithm>

#include "carom_test.h"
#include "dynamics/ledger/ledger.h"
#include "joint_scenes.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr int kJointSolvers[] = {kSoftChoice, kDirectChoice, kAutoChoice};
constexpr Real kDt = 1.0 / 60;

/// A rope from the middle of one body over two places 2 m apart to that of another.
std::uint32_t hang(TestWorld& t, std::uint32_t a, std::uint32_t b, Real ratio, const Vec3& point_a = Vec3::zero()) {
  JointDef def;
  def.kind = JointKind::pulley;
  def.body_a = a, def.body_b = b;
  def.frame_a.p = point_a;
  const std::uint32_t pulley = handle_slot(t.world.add_joint(def));
  Transmission over{ratio, Vec3(0, 0, 0), Vec3(2, 0, 0), 0};
  t.world.set_transmission(pulley, over);
  over.length = coordinate(t, pulley, Coordinate::distance);
  t.world.set_transmission(pulley, over);
  return pulley;
}

struct Atwood {
  Real mass_a, mass_b, ratio;
  /// N, what A is pulled with: T (1/m_a + r^2/m_b) = g (1 + r).
  Real tension() const { return kG * (1 + ratio) / (1 / mass_a + ratio * ratio / mass_b); }
  /// m/s^2, downwards.
  Real a() const { return kG - tension() / mass_a; }
  Real b() const { return kG - ratio * tension() / mass_b; }
};

}  // namespace

/// Two weights over a pulley: their accelerations are g (m1 - m2) / (m1 + m2), and with a ratio likewise in closed form.
/// Uniform, so the method makes no error: what is left is rounding, a few roundings of the largest speed a substep. Softness
/// lets a rope give way by less than its ends would fall apart in a substep, and the weights lag by as much.
static void weights_fall_as_of_atwood(void**) {
  for (const Atwood& m : {Atwood{3, 2, 1}, Atwood{1, 2, 2}, Atwood{5, 1, 0.5}})
    for (const int solver : kJointSolvers)
      for (const int substeps : {4, 8}) {
        TestWorld t;
        choose(t, solver, substeps);
        const std::uint32_t a = add_body(t, Vec3(0, -5, 0), m.mass_a, Vec3::constant(0.1)),
                            b = add_body(t, Vec3(2, -5, 0), m.mass_b, Vec3::constant(0.1));
        const std::uint32_t pulley = hang(t, a, b, m.ratio);
        const Real h = kDt / substeps, gives = kG * (1 + m.ratio) * h * h;
        Real worst_gap_seen = 0;
        const int steps = 40;
        for (int i = 0; i < steps; ++i) t.world.step(kDt), worst_gap_seen = std::max(worst_gap_seen, gap_of(t, pulley));
        const Real time = steps * kDt, fastest = kG * time;
        const Real rounding = 8 * steps * substeps * kUnitRoundoff * fastest;
        const State& s = t.world.state;
        const Real off_a = std::fabs(s.v[a].y() + m.a() * time), off_b = std::fabs(s.v[b].y() + m.b() * time);
        const Real off_x = std::fabs(s.x[a].y() + 5 + m.a() * time * time / 2);
        const Real off_p = std::fabs(joint(t, pulley).force.y() / (m.ratio * m.tension()) - 1);
        assert_true(off_a <= rounding && off_b <= rounding);
        assert_true(off_x <= gives + time * rounding);
        assert_true(off_p <= rounding);
        assert_true(worst_gap_seen <= (solver >= kDirectChoice ? 2e-9 : gives));
      }
}

namespace {

struct SwingErrors {
  Real energy = 0, gap = 0;
};

/// A weight that swings at one end, from 0.8 rad, and a heavier one that hangs at the other.
SwingErrors swing(int solver, int substeps, bool by_an_arm) {
  TestWorld t;
  choose(t, solver, substeps);
  leave_joints_to_solver(t);
  const Vec3 arm = by_an_arm ? Vec3(0, 0.2, 0) : Vec3::zero();
  const std::uint32_t a = add_body(t, Vec3(2 * std::sin(0.8), -2 * std::cos(0.8), 0) - arm, 1, Vec3::constant(0.05)),
                      b = add_body(t, Vec3(2, -3, 0), 1.5, Vec3::constant(0.05));
  const std::uint32_t pulley = hang(t, a, b, 1, arm);
  const Real before = energy_of(t);
  SwingErrors worst;
  for (int i = 0; i < 120; ++i) {
    t.world.step(kDt);
    worst.energy = std::max(worst.energy, std::fabs(energy_of(t) - before));
    worst.gap = std::max(worst.gap, gap_of(t, pulley));
  }
  return worst;
}

}  // namespace

/// A pendulum over a pulley: energy and the rope's length are kept in second order, a tenth of leeway for the next order.
static void a_pendulum_over_a_pulley_keeps_its_energy(void**) {
  for (const int solver : kJointSolvers)
    for (const bool by_an_arm : {false, true}) {
      const SwingErrors coarse = swing(solver, 4, by_an_arm), fine = swing(solver, 8, by_an_arm);
      assert_true(fine.energy < coarse.energy / 3.6);
      if (solver >= kDirectChoice)
        assert_true(coarse.gap < 2e-9 && fine.gap < 2e-9);  // what is less is not parted
      else
        assert_true(fine.gap < coarse.gap / 3.6);
    }
}

/// A rope that keeps its length does no work on its two bodies together: what it gives one it takes of the other, along
/// another line. Books of both sides close to rounding of what goes to and fro.
static void a_rope_does_no_work(void**) {
  for (const int solver : kJointSolvers) {
    TestWorld t;
    choose(t, solver, 4);
    const std::uint32_t a = add_body(t, Vec3(0, -5, 0), 3, Vec3::constant(0.1)),
                        b = add_body(t, Vec3(2, -5, 0), 2, Vec3::constant(0.1));
    hang(t, a, b, 2);
    t.world.keep_ledger(true);
    const int steps = 40;
    t.run(steps, kDt);
    const auto of = [&](Cause cause) { return t.world.ledger->since[index_of(cause)].value(); };
    const Atwood m{3, 2, 2};
    const Real fell = m.a() * (steps * kDt) * (steps * kDt) / 2,
               through = std::fabs(m.tension() * fell);  // J, A's to B
    const Real gives = kG * 3 / (240.0 * 240.0);         // m: a soft rope, in its first substep
    assert_true(through > 1 && std::fabs(of(Cause::joints).kinetic) <= m.tension() * gives);
    assert_true(std::fabs(of(Cause::unassigned).energy()) <= 8 * steps * 4 * kUnitRoundoff * through);
    const Vec3 up = of(Cause::joints).linear;  // N s: both sides pull upwards, T and 2 T
    assert_true((up - Vec3(0, 3 * m.tension() * steps * kDt, 0)).norm() <= 8 * steps * 4 * kUnitRoundoff * up.norm());
  }
}

/// With a limit the rope may be slack: a weight thrown up falls free until it is taut again, and never is the rope longer
/// than by what the fastest end goes in a substep.
static void a_rope_may_be_slack(void**) {
  for (const int solver : kJointSolvers)
    for (const int substeps : {4, 8}) {
      TestWorld t;
      choose(t, solver, substeps);
      const std::uint32_t a = add_body(t, Vec3(0, -5, 0), 1, Vec3::constant(0.1)),
                          b = add_body(t, Vec3(2, -5, 0), 1, Vec3::constant(0.1));
      const std::uint32_t pulley = hang(t, a, b, 1);
      set_limit(t, pulley, Coordinate::distance, 0, 10);
      t.world.set_velocity(a, Vec3(0, 3, 0), Vec3::zero());
      Real shortest = 10, longest = 0;
      for (int i = 0; i < 60; ++i) {
        t.world.step(kDt);
        const Real length = coordinate(t, pulley, Coordinate::distance);
        shortest = std::min(shortest, length), longest = std::max(longest, length);
        if (i == 5) {  // both are free: they fall alike
          const Real apart = t.world.state.v[a].y() - t.world.state.v[b].y();
          assert_true(std::fabs(apart - 3) < 1e-12);
        }
      }
      assert_true(shortest < 9.8 && longest <= 10 + 2 * 10 * kDt / substeps);
    }
}

/// Rows along two directions are rates of the rope's length, wherever bodies and points are.
static void a_rope_s_row_is_the_rate_of_its_length(void**) {
  std::uint32_t seed = 7;
  const auto random = [&] {
    seed = seed * 1664525u + 1013904223u;
    return Real(seed >> 8) / (1 << 23) - 1;
  };
  const auto vector = [&] { return Vec3{random(), random(), random()}; };
  for (int i = 0; i < 50; ++i) {
    TestWorld t(Vec3::zero());
    choose(t, kSoftChoice, 1);
    const auto place = [&] { return normalized(Quat(1.5, random(), random(), random())); };
    const std::uint32_t a = add_body(t, vector(), 1, Vec3(1, 2, 3), BodyType::dynamic, place()),
                        b = add_body(t, vector(), 2, Vec3(2, 3, 1), BodyType::dynamic, place());
    JointDef def;
    def.kind = JointKind::pulley;
    def.body_a = a, def.body_b = b;
    def.frame_a = {place(), vector()}, def.frame_b = {place(), vector()};
    const std::uint32_t j = handle_slot(t.world.add_joint(def));
    t.world.set_transmission(j, {1 + 0.5 * random(), vector() + Vec3(0, 5, 0), vector() + Vec3(3, 4, 0), 3});
    plan_joints(t.world, t.world.joints);
    t.world.step(1e-9);  // makes rows
    const WideJoints& w = *t.world.wide_joints;
    const auto of = [](const LaneVec& v) { return Vec3(v.x[0], v.y[0], v.z[0]); };
    const JointRowLanes& row = w.rows[0];
    const Vec3 va = vector(), wa = vector(), vb = vector(), wb = vector();
    const Real rate = of(row.d).dot(vb) - of(w.pulls[0].d_a).dot(va) + of(row.w_b).dot(wb) - of(row.w_a).dot(wa);
    const Pose pa = t.world.pose(a), pb = t.world.pose(b);
    const Real e = 1e-5;
    const auto at = [&](Real time) {
      const auto moved = [&](const Pose& p, const Vec3& v, const Vec3& turn) {
        return Pose{normalized(exp_map(time * turn) * p.q), p.p + time * v};
      };
      t.world.set_pose(a, moved(pa, va, wa)), t.world.set_pose(b, moved(pb, vb, wb));
      return coordinate(t, j, Coordinate::distance);
    };
    const Real difference = (at(e) - at(-e)) / (2 * e);
    assert_true(std::fabs(difference - rate) < 1e-6 * (1 + std::fabs(rate)) + 1e-7);
  }
}

namespace {

constexpr Real kWhole = 2 * 3.14159265358979323846;

/// Two flywheels that turn about z, a metre apart. @return the gear
struct Flywheels {
  Flywheels(int solver, int substeps, Real ratio_of_gear, Real inertia_a, Real inertia_b)
      : t(Vec3::zero()), ratio(ratio_of_gear), i_a(inertia_a), i_b(inertia_b) {
    choose(t, solver, substeps);
    a = add_body(t, Vec3(0, 0, 0), 1, Vec3(i_a, i_a, i_a)), b = add_body(t, Vec3(1, 0, 0), 1, Vec3(i_b, i_b, i_b));
  }
  std::uint32_t mesh() {
    const std::uint32_t gear = join(t, JointKind::gear, a, b, Vec3::zero(), x_along(Vec3(0, 0, 1)));
    t.world.set_transmission(gear, {ratio});
    return gear;
  }
  Real spin(std::uint32_t body) const { return t.world.state.omega[body].z(); }
  Real angle(std::uint32_t body) const {
    const Quat& q = t.world.state.q[body];
    return 2 * std::atan2(q.z(), q.w());
  }
  TestWorld t;
  Real ratio, i_a, i_b;
  std::uint32_t a = 0, b = 0;
};

}  // namespace

/// Torque on one of two flywheels: angle a + r angle b stays, so it turns I_a + I_b / r^2. The torque is uniform: rounding
/// is all that is off. A soft gear slips by less than the torque turns A alone in a substep, and the direct solver leaves 1e-9.
static void geared_flywheels_speed_up_in_closed_form(void**) {
  const Real torque = 3;
  for (const Real ratio : {1.0, -2.0, 0.3})
    for (const int solver : kJointSolvers)
      for (const int substeps : {4, 8}) {
        Flywheels f(solver, substeps, ratio, 0.5, 2);
        const std::uint32_t hinge = join(f.t, JointKind::hinge, kInvalid, f.a, Vec3::zero(), x_along(Vec3(0, 0, 1)));
        join(f.t, JointKind::hinge, kInvalid, f.b, Vec3(1, 0, 0), x_along(Vec3(0, 0, 1)));
        const std::uint32_t gear = f.mesh();
        set_motor(f.t, hinge, Coordinate::twist, 1e6, torque);
        const int steps = 60;
        f.t.run(steps, kDt);
        const Real a = torque / (f.i_a + f.i_b / (ratio * ratio)), time = steps * kDt;
        const Real rounding = 8 * steps * substeps * kUnitRoundoff * a * time * std::max(1.0, 1 / std::fabs(ratio));
        assert_true(std::fabs(f.spin(f.a) - a * time) <= rounding);
        assert_true(std::fabs(f.spin(f.b) + a * time / ratio) <= rounding);
        assert_true(std::fabs(joint(f.t, gear).torque.z() / (-f.i_b * a / ratio) - 1) <=
                    8 * steps * substeps * kUnitRoundoff);
        const Real h = kDt / substeps, gives = solver >= kDirectChoice ? 1e-9 : torque / f.i_a * h * h;
        assert_true(place_of(f.t.world, joint(f.t, gear)).angle <= gives);
      }
}

/// One flywheel spins, and is geared to another at rest: of what the gear exchanges, A gets p and B r p, so w_a becomes
/// w I_a / (I_a + I_b / r^2).
static void gears_exchange_momentum(void**) {
  for (const Real ratio : {1.0, -2.0, 0.3})
    for (const int solver : kJointSolvers)
      for (const int substeps : {4, 8}) {
        Flywheels f(solver, substeps, ratio, 0.5, 2);
        f.t.world.set_velocity(f.a, Vec3::zero(), Vec3(0, 0, 7));
        f.mesh();
        f.t.run(30, kDt);
        const Real after = 7 * f.i_a / (f.i_a + f.i_b / (ratio * ratio));
        const Real rounding = 8 * 30 * substeps * kUnitRoundoff * 7 * std::max(1.0, 1 / std::fabs(ratio));
        assert_true(std::fabs(f.spin(f.a) - after) <= rounding);
        assert_true(std::fabs(f.spin(f.b) + after / ratio) <= rounding);
      }
}

/// A thousand turns and more, up to three a substep: twice angle a + 2.5 angle b, told by where both wheels are, is a whole
/// number of turns to what rounding makes of a substep's turn w h, a few units of 1 + w h.
static void gears_do_not_drift(void**) {
  for (const Real turns_a_second : {25.0, 100.0, 700.0})
    for (const int solver : kJointSolvers)
      for (const int substeps : {4, 8}) {
        Flywheels f(solver, substeps, 2.5, 0.5, 0.4);
        const Real w = kWhole * turns_a_second;
        f.t.world.set_velocity(f.a, Vec3::zero(), Vec3(0, 0, w));
        f.t.world.set_velocity(f.b, Vec3::zero(), Vec3(0, 0, -w / 2.5));
        const std::uint32_t gear = f.mesh();
        const int steps = static_cast<int>(1000 / turns_a_second / kDt) + 60;
        f.t.run(steps, kDt);
        const Real off = std::remainder(2 * f.angle(f.a) + 5 * f.angle(f.b), kWhole) / 2;
        const Real rounding = 8 * steps * substeps * kUnitRoundoff * (1 + 2.5) * (1 + w * kDt / substeps);
        assert_true(std::fabs(off) <= rounding);
        assert_true(std::fabs(joint(f.t, gear).transmission.phase) <= rounding);
        assert_true(std::fabs(f.spin(f.a) / w - 1) <= rounding);
      }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(weights_fall_as_of_atwood),
      cmocka_unit_test(a_pendulum_over_a_pulley_keeps_its_energy),
      cmocka_unit_test(a_rope_does_no_work),
      cmocka_unit_test(a_rope_may_be_slack),
      cmocka_unit_test(a_rope_s_row_is_the_rate_of_its_length),
      cmocka_unit_test(geared_flywheels_speed_up_in_closed_form),
      cmocka_unit_test(gears_exchange_momentum),
      cmocka_unit_test(gears_do_not_drift),
  };
  return cmocka_run_group_tests_name("oracle/pulley_gear", tests, nullptr, nullptr);
}
