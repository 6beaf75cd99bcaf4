// Rotations driven as one against closed forms, and six-axis joints against other kinds and other machines' registers.
#include <algorithm>

#include "carom_test.h"
#include "dynamics/solver/wide_contacts.h"
#include "six_axes.h"

using namespace carom;
using namespace carom::test;

namespace {

struct Turned {
  Real off, across, spin;
};
/// A ball of isotropic inertia, turned by an angle about an oblique axis from its target and let go: critically damped it comes
/// back along that axis by angle (1 + w t) exp(-w t).
Turned turn_back(int solver, int substeps, JointKind kind, Real angle, bool two) {
  const Real inertia = 0.4, hertz = 1.2, w = 2 * 3.14159265358979323846 * hertz;
  TestWorld t(Vec3::zero());
  choose(t, solver, substeps);
  const Vec3 axis = Vec3(0.48, -0.6, 0.64);
  const Quat target = normalized(Quat(0.5, 0.5, -0.3, 0.6));
  const std::uint32_t base = two ? add_body(t, Vec3(0, 1, 0), 3, Vec3::constant(1.2)) : kInvalid;
  const std::uint32_t body = add_body(t, Vec3::zero(), 3, Vec3::constant(inertia));
  const std::uint32_t j = join(t, kind, base, body, Vec3::zero(), kOblique);
  if (kind == JointKind::six_axis && !two) set_all(t, j, kAxes, locked_at(), true, false);
  if (two && kind == JointKind::six_axis) set_all(t, j, kAxes, JointAxis{}, true, false);
  TurnDrive d;
  d.mode = AxisDrive::position, d.target = target, d.gains = {Gains::frequency, hertz, 1};
  t.world.set_joint_turn(j, d);
  // B's frame in A's is exp(angle axis) target; frames stand alike in the bodies.
  const Quat q = exp_map(angle * axis) * target;
  t.world.set_pose(body, {normalized(kOblique * q * kOblique.conjugate()), Vec3::zero()});
  Turned worst = {0, 0, 0};
  for (int i = 1; i <= 60; ++i) {
    t.world.step(kStep);
    const JointEnds ends = ends_of(t.world, joint(t, j).def);
    const Quat off = (ends.a.q.conjugate() * ends.b.q) * target.conjugate();
    const Real sign = off.w() < 0 ? -1 : 1, left = 2 * std::atan2(off.vec().norm(), sign * off.w());
    const Real time = i * kStep, expected = angle * (1 + w * time) * std::exp(-w * time);
    worst.off = std::max(worst.off, std::fabs(left - expected));
    worst.across = std::max(worst.across, (sign * off.vec().cross(axis)).norm());
  }
  return worst;
}

}  // namespace

static void a_ball_turns_back_by_the_shortest_way(void**) {
  for (const int solver : kEverySolver)
    for (const JointKind kind : {JointKind::ball, JointKind::six_axis})
      for (const Real angle : {0.6, 2.5}) {
        const Turned coarse = turn_back(solver, 4, kind, angle, false), fine = turn_back(solver, 8, kind, angle, false);
        const Real w = 2 * 3.14159265358979323846 * 1.2, h = kStep / 4;
        assert_true(coarse.off < angle * w * h && fine.off < coarse.off / 1.9);
        assert_true(coarse.across < 1e-12 && fine.across < 1e-12);
      }
}

/// The same between two bodies that fly: gains per mass know what both weigh together.
static void two_bodies_turn_to_each_other(void**) {
  for (const int solver : kEverySolver) {
    const Turned coarse = turn_back(solver, 4, JointKind::six_axis, 2.5, true),
                 fine = turn_back(solver, 8, JointKind::six_axis, 2.5, true);
    const Real w = 2 * 3.14159265358979323846 * 1.2, h = kStep / 4;
    assert_true(coarse.off < 2.5 * w * h && fine.off < coarse.off / 1.9 && coarse.across < 1e-12);
  }
}

/// A ball driven at an angular velocity about an oblique axis gets there, as fast as its torque about each axis allows; by
/// effort it speeds up as of torque over inertia.
static void a_ball_is_driven_about_three_axes(void**) {
  const Real inertia = 0.5;
  const int steps = 60, substeps = 4;
  for (const int solver : kEverySolver)
    for (const AxisDrive mode : {AxisDrive::velocity, AxisDrive::effort}) {
      TestWorld t(Vec3::zero());
      choose(t, solver, substeps);
      const std::uint32_t body = add_body(t, Vec3::zero(), 2, Vec3::constant(inertia));
      const std::uint32_t j = join(t, JointKind::ball, kInvalid, body, Vec3::zero(), kOblique);
      TurnDrive d;
      d.mode = mode;
      d.velocity = {0.7, -3, 1.1}, d.effort = {0.2, -0.4, 0.3};
      d.max_force = mode == AxisDrive::velocity ? Vec3(1, 0.6, 1) : Vec3(1, 1, 0.1);
      t.world.set_joint_turn(j, d);
      t.run(steps, kStep);
      const Real time = steps * kStep;
      const Vec3 omega = kOblique.conjugate() * t.world.state.omega[body];
      const Vec3 expected =
          mode == AxisDrive::velocity ? Vec3(0.7, -0.6 / inertia * time, 1.1) : time / inertia * Vec3(0.2, -0.4, 0.1);
      assert_true((omega - expected).norm() < 16 * steps * substeps * kUnitRoundoff * 3);
    }
}

namespace {

/// Where a body on a joint of a kind, or on a six-axis joint that is set up as one, ends.
std::array<Pose, 2> end_of(int solver, int substeps, JointKind kind, bool as_axes, int drive) {
  TestWorld t;
  choose(t, solver, substeps), leave_joints_to_solver(t);
  const std::uint32_t a = add_body(t, Vec3::zero(), 4, Vec3(0.5, 0.6, 0.7)),
                      b = add_body(t, Vec3(1, 0.2, 0), 2, Vec3(0.2, 0.3, 0.35));
  join(t, JointKind::ball, kInvalid, a, Vec3(-0.5, 0, 0));
  const std::uint32_t j = join(t, as_axes ? JointKind::six_axis : kind, a, b, Vec3(0.5, 0, 0), kOblique);
  const bool turns = kind == JointKind::hinge || kind == JointKind::ball, slides = kind == JointKind::slider;
  if (as_axes) {
    set_all(t, j, slides ? 0 : kAxes, locked_at(), true, false);
    if (kind != JointKind::ball) set_all(t, j, turns ? 3 : kAxes, locked_at(), false, true);
  }
  const Coordinate c = slides ? Coordinate::slide : Coordinate::twist;
  JointAxis axis;
  if (drive == 1) axis.spring = {Gains::frequency, 2, 0.3}, axis.rest = 0.2;
  if (drive == 2) axis.drive = AxisDrive::velocity, axis.speed = 1, axis.max_force = 6;
  if (drive == 3) axis.mode = AxisMode::limited, axis.lower = -0.1, axis.upper = 0.15;
  if (as_axes && drive) t.world.set_joint_axis(j, slides ? 0 : 3, axis);
  if (!as_axes && drive == 1) set_spring(t, j, c, 0.2, 2, 0.3);
  if (!as_axes && drive == 2) set_motor(t, j, c, 1, 6);
  if (!as_axes && drive == 3) set_limit(t, j, c, -0.1, 0.15);
  t.run(30, kStep);
  return {t.world.pose(a), t.world.pose(b)};
}

}  // namespace

static Real unlike(int solver, int substeps, JointKind kind, int drive) {
  const auto one = end_of(solver, substeps, kind, false, drive), other = end_of(solver, substeps, kind, true, drive);
  Real most = 0;
  for (int i = 0; i < 2; ++i) most = std::max({most, (one[i].p - other[i].p).norm(), (one[i].q - other[i].q).norm()});
  return most;
}

/// Set up as a hinge, slider, weld or ball it is one: the same rows, to rounding. With a spring, a motor or a limit likewise
/// where it is answered directly; where it is swept, six-axis joints hold their locks before drives, too, and the two meet as
/// substeps get small (but when a limit is hit is not smooth in them).
static void axes_are_the_other_kinds(void**) {
  for (const int solver : kEverySolver)
    for (const JointKind kind : {JointKind::ball, JointKind::hinge, JointKind::slider, JointKind::weld})
      for (int drive = 0; drive < (kind == JointKind::weld ? 1 : 4); ++drive) {
        const Real off = unlike(solver, 4, kind, drive);
        const bool swept = drive && !is_direct(solver);
        if (!swept)
          assert_true(off < 1e-12);
        else
          assert_true(off < 2e-3 && (drive == 3 || unlike(solver, 32, kind, drive) < off / 4));
      }
}

/// What is locked may be moved by the host before each step: far, or by so little that RATTLE shuts it. A limit of no
/// width with soft stops is a spring: it gives m g / k.
static void locks_follow_and_give(void**) {
  for (const int solver : kEverySolver) {
    TestWorld t;
    choose(t, solver);
    const std::uint32_t body = add_body(t, Vec3::zero(), 2, Vec3(0.2, 0.3, 0.4));
    const std::uint32_t j = join_axes(t, body, kInvalid, Vec3::zero(), Quat::identity());  // the world is B
    set_all(t, j, kAxes, locked_at());
    for (int i = 1; i <= 60; ++i) {
      t.world.set_joint_axis(j, 0, locked_at(0.0005 * i));
      t.run(1, kStep);
    }
    assert_true(std::fabs(axis_of(t, j, 0) - 0.03) < 1e-12);
    for (int i = 4; i <= 60; ++i) {
      t.world.set_joint_axis(j, 0, locked_at(0.01 * i));
      t.run(1, kStep);
    }
    // By less than it was moved by in the last step, where it is soft.
    assert_true(std::fabs(axis_of(t, j, 0) - 0.6) < (is_direct(solver) ? 2e-9 : 0.01));
    assert_true(std::fabs(t.world.state.x[body].x() + axis_of(t, j, 0)) < 1e-12);
    JointAxis soft;
    soft.mode = AxisMode::limited, soft.stop = {Gains::force, 400, 50};
    t.world.set_joint_axis(j, 1, soft);
    t.run(300, kStep);
    // A hangs below B, 0.6 m aside: soft locks of turns let it tilt by what that moment turns in a substep.
    const Real h = kStep / 4, tilt = is_direct(solver) ? 1e-9 : 2 * kG * 0.6 / 0.2 * h * h;
    assert_true(std::fabs(axis_of(t, j, 1) - 2 * kG / 400) < 1e-12 + 0.6 * tilt * tilt);
  }
}

/// How the i-th joint of a chain holds and pulls its k-th axis.
static JointAxis axis_in_chain(int i, int k) {
  JointAxis a = locked_at(k < 3 || (i + k) % 3 ? 0 : 0.05);
  if ((i + k) % 4 == 0) {
    a.mode = AxisMode::limited, a.lower = -0.1, a.upper = 0.2;
    if (i % 2) a.stop = {Gains::force, 90, 1};
  }
  if ((i + k) % 4 == 1) a = JointAxis{}, a.spring = {Gains::frequency, 3, 0.2};
  if ((i + k) % 8 == 5)
    a.drive = k % 2 ? AxisDrive::velocity : AxisDrive::effort, a.speed = 0.5, a.effort = 1, a.max_force = 2;
  return a;
}

/// A chain of such joints of every sort gives the same bits from registers of every width.
static void every_width_gives_the_same_bits(void**) {
  for (const int solver : kEverySolver) {
    std::uint64_t first = 0;
    for (const ContactKernels* kernels : all_contact_kernels()) {
      TestWorld t;
      t.world.wide->kernels = kernels;
      choose(t, solver);
      std::uint32_t before = kInvalid;
      for (int i = 0; i < 40; ++i) {
        const std::uint32_t next = add_body(t, Vec3(i + 0.5, 0, 0), 1 + 0.1 * (i % 7), Vec3(0.1, 0.2, 0.25));
        const bool is_ball = i % 5 == 4;
        const std::uint32_t j =
            join(t, is_ball ? JointKind::ball : JointKind::six_axis, before, next, Vec3(i, 0, 0.1), kOblique);
        for (int k = 0; !is_ball && k < static_cast<int>(kAxes); ++k)
          t.world.set_joint_axis(j, static_cast<std::uint32_t>(k), axis_in_chain(i, k));
        TurnDrive d;
        d.mode = AxisDrive::position, d.gains = {Gains::acceleration, 80, 5}, d.target = kOblique;
        if (is_ball) t.world.set_joint_turn(j, d);
        before = next;
      }
      t.run(is_direct(solver) ? 20 : 60, kStep);
      assert_true(t.world.state.x[0].all_finite());
      if (kernels == all_contact_kernels().front()) first = t.world.hash();
      assert_true(t.world.hash() == first);
    }
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_ball_turns_back_by_the_shortest_way),
      cmocka_unit_test(two_bodies_turn_to_each_other),
      cmocka_unit_test(a_ball_is_driven_about_three_axes),
      cmocka_unit_test(axes_are_the_other_kinds),
      cmocka_unit_test(locks_follow_and_give),
      cmocka_unit_test(every_width_gives_the_same_bits),
  };
  return cmocka_run_group_tests_name("oracle/six_axis_turns", tests, nullptr, nullptr);
}
