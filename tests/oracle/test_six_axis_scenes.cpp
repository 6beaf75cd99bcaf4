// Scenes of six-axis joints that were looked at once all of it worked: other sizes, masses, steps and settings.
#include <algorithm>

#include "carom_test.h"
#include "dynamics/joint/axis_parts.h"
#include "dynamics/ledger/ledger.h"
#include "dynamics/solver/direct.h"
#include "joint_scenes.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr int kTheSolvers[] = {kSoftChoice, kDirectChoice, kAutoChoice};

JointAxis held() {
  JointAxis a;
  a.mode = AxisMode::locked;
  return a;
}
void hold_all_but(TestWorld& t, std::uint32_t j, std::uint32_t axis) {
  for (std::uint32_t k = 0; k < kAxes; ++k)
    if (k != axis) t.world.set_joint_axis(j, k, held());
}
Real where(const TestWorld& t, std::uint32_t j, std::uint32_t k) {
  const JointPlace place = place_of(t.world, joint(t, j));
  return axes_at(place, place.turned)[k];
}

}  // namespace

namespace {

/// A quarter of a car on its wheel, which is heavy and held: spring, damper and bump stop of one axis, all in SI, share its
/// weight: k x + s (x + 0.05) = -m g. The stop bears what the spring does not.
struct Rest {
  Real off, force;  // m; of its weight
};
Rest rest_on_bump_stop(int solver, int substeps) {
  const Real m = 350, k = 2e4, s = 2e5, expected = -(m * kG + s * 0.05) / (k + s);
  TestWorld t;
  choose(t, solver, substeps);
  t.world.set_dial(Dial::velocity_tolerance, 1e-9);
  const std::uint32_t wheel = add_body(t, Vec3(7, 0.3, -4), 40, Vec3::constant(2), BodyType::kinematic),
                      car = add_body(t, Vec3(7.2, 0.9, -4), m, Vec3(120, 300, 250));
  const std::uint32_t j = join(t, JointKind::six_axis, wheel, car, Vec3(7, 0.6, -4), x_along(Vec3(0, 0, 1)));
  JointAxis a;
  a.mode = AxisMode::limited, a.lower = -0.05, a.upper = 0.05, a.stop = {Gains::force, s, 2e3};
  a.spring = {Gains::force, k, 1.5e3};
  hold_all_but(t, j, 1);
  t.world.set_joint_axis(j, 1, a);  // A's y axis is the world's
  t.run(600, 1.0 / 100);
  return {std::fabs(where(t, j, 1) - expected), std::fabs(joint(t, j).force.y() / (m * kG) - 1)};
}

}  // namespace

/// Off its centre too, where locks bear the weight's moment.
static void a_suspension_rests_on_its_bump_stop(void**) {
  for (const int solver : kTheSolvers)
    for (const int substeps : {2, 4}) {
      const Rest rest = rest_on_bump_stop(solver, substeps);
      assert_true(rest.off < 1e-9 && rest.force < 1e-9);
    }
}

namespace {

/// Two links of an arm in the plane of x and y, the second about the end of the first, with drives to positions in N m/rad.
struct Arm {
  static constexpr Real m1 = 6, m2 = 2.5, l1 = 0.8, l2 = 0.5, k1 = 400, k2 = 90, t1 = 0.4, t2 = -0.9;
  /// N m: what the drives and the weights leave, and its slope.
  static std::array<Real, 2> left(Real a, Real b) {
    const Real w2 = m2 * kG * (l2 / 2) * std::cos(a + b), w1 = (m1 / 2 + m2) * kG * l1 * std::cos(a) + w2;
    return {k1 * (t1 - a) - w1, k2 * (t2 - b) - w2};
  }
  static std::array<Real, 2> rest() {
    Real a = t1, b = t2;
    for (int i = 0; i < 200; ++i) {  // a contraction: weights vary by less than drives do
      const auto r = left(a, b);
      a += r[0] / k1, b += r[1] / k2;
    }
    return {a, b};
  }
};

}  // namespace

/// @param solver  0: RATTLE, which holds the arm whatever the solver
static Real sag(int solver, int substeps, bool about_y) {
  const auto expected = Arm::rest();
  TestWorld t;
  choose(t, solver ? solver : int(kAutoChoice), substeps);
  if (solver) leave_joints_to_solver(t);
  t.world.set_dial(Dial::velocity_tolerance, 1e-8);
  const std::uint32_t one = add_body(t, Vec3(Arm::l1 / 2, 0, 0), Arm::m1, Vec3(0.01, 0.32, 0.32)),
                      two = add_body(t, Vec3(Arm::l1 + Arm::l2 / 2, 0, 0), Arm::m2, Vec3(0.01, 0.052, 0.052));
  const std::uint32_t axis = about_y ? 4 : 5;
  // The frame's y axis, or its z axis, is the world's z.
  const Quat frame = about_y ? turn_between(Vec3(0, 1, 0), Vec3(0, 0, 1)) : Quat::identity();
  const std::uint32_t joints[] = {join(t, JointKind::six_axis, kInvalid, one, Vec3::zero(), frame),
                                  join(t, JointKind::six_axis, one, two, Vec3(Arm::l1, 0, 0), frame)};
  JointAxis a;
  a.drive = AxisDrive::position;
  for (const int i : {0, 1}) {
    hold_all_but(t, joints[i], axis);
    a.target = i ? Arm::t2 : Arm::t1, a.gains = {Gains::force, i ? Arm::k2 : Arm::k1, i ? 6.0 : 30.0};
    t.world.set_joint_axis(joints[i], axis, a);
  }
  t.world.keep_ledger(true);
  t.run(1200, 1.0 / 120);
  const auto since = [&](Cause cause) { return t.world.ledger->since[index_of(cause)].value().energy(); };
  assert_true(std::fabs(since(Cause::unassigned)) < 1e-9 && std::fabs(since(Cause::drives)) > 1);
  return std::max(std::fabs(where(t, joints[0], axis) - expected[0]),
                  std::fabs(where(t, joints[1], axis) - expected[1]));
}

/// It sags to where drives balance its weight, a fixed point that is found without the engine; what drives and joints give is
/// booked. Where a sweep answers joint by joint, a spring's damper meets what the other joint is yet to do: soft_step, which
/// sweeps once, rests off by c / k of such a velocity, that half a substep of what drives and weights bear, 65 N m, gives the
/// first link about its middle, 0.32 kg m^2: in first order.
static void an_arm_sags_under_its_weight(void**) {
  for (const bool about_y : {false, true}) assert_true(sag(0, 3, about_y) < 1e-12);
  for (const int solver : kTheSolvers)
    for (const bool about_y : {false, true}) {
      const Real coarse = sag(solver, 3, about_y), fine = sag(solver, 6, about_y), h = 1.0 / 360;
      if (solver >= kDirectChoice)
        assert_true(coarse < 1e-7 && fine < 1e-7);
      else
        assert_true(coarse < 30 / Arm::k1 * 65 / 0.32 * h / 2 && fine < coarse / 1.9);
    }
}

/// Two bodies about one centre that fly and turn against each other from 2.9 rad, overdamped, in N m/rad: with I the inertia of
/// both together, e = (r2 exp(r1 t) - r1 exp(r2 t)) e0 / (r2 - r1), r the roots of I r^2 + c r + k; their angular momenta
/// cancel.
static void a_gimbal_turns_overdamped(void**) {
  const Real i1 = 9, i2 = 0.6, both = i1 * i2 / (i1 + i2), k = 8, c = 12, e0 = 2.9;
  const Real root = std::sqrt(c * c - 4 * both * k), r1 = (-c + root) / (2 * both), r2 = (-c - root) / (2 * both);
  const Vec3 axis = Vec3(-2, 3, 6) / 7;
  for (const int solver : kTheSolvers) {
    Real errors[2];
    for (const int fine : {0, 1}) {
      TestWorld t(Vec3::zero());
      choose(t, solver, fine ? 12 : 6);
      t.world.set_dial(Dial::velocity_tolerance, 1e-9);
      const std::uint32_t a = add_body(t, Vec3(50, -20, 10), 30, Vec3::constant(i1)),
                          b = add_body(t, Vec3(50, -20, 10), 4, Vec3::constant(i2), BodyType::dynamic,
                                       normalized(exp_map(e0 * axis)));
      JointDef def;
      def.kind = JointKind::ball;
      def.body_a = a, def.body_b = b;
      const std::uint32_t j = handle_slot(t.world.add_joint(def));
      TurnDrive d;
      d.mode = AxisDrive::position, d.gains = {Gains::force, k, c};
      t.world.set_joint_turn(j, d);
      Real worst = 0, spin = 0, across = 0;
      for (int i = 1; i <= 100; ++i) {
        t.world.step(1.0 / 50);
        const State& s = t.world.state;
        const Quat off = s.q[a].conjugate() * s.q[b];
        const Real left = 2 * std::atan2(off.vec().norm(), std::fabs(off.w())), time = i / 50.0;
        worst =
            std::max(worst, std::fabs(left - e0 * (r2 * std::exp(r1 * time) - r1 * std::exp(r2 * time)) / (r2 - r1)));
        spin = std::max(spin, (i1 * s.omega[a] + i2 * s.omega[b]).norm());
        across = std::max(across, off.vec().cross(axis).norm());
      }
      errors[fine] = worst;
      assert_true(spin < 1e-12 && across < 1e-11);
    }
    // First order in the substep.
    assert_true(errors[0] < e0 * (c / both) / 300 && errors[1] < errors[0] / 1.9);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_suspension_rests_on_its_bump_stop),
      cmocka_unit_test(an_arm_sags_under_its_weight),
      cmocka_unit_test(a_gimbal_turns_overdamped),
  };
  return cmocka_run_group_tests_name("oracle/six_axis_scenes", tests, nullptr, nullptr);
}
