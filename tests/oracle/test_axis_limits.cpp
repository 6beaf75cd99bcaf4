// Axes of hinges and sliders, and what axes are bounded by: efforts of their drives, their speed. Against closed forms and
// six-axis joints, under every solver that knows joints.
#include "carom_test.h"
#include "six_axes.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr std::uint32_t kWorld = kInvalid;
const JointKind kBoth[] = {JointKind::hinge, JointKind::slider};

std::uint32_t axis_of_kind(JointKind kind) { return own_axis(kind); }
Coordinate motion_of(JointKind kind) { return kind == JointKind::hinge ? Coordinate::twist : Coordinate::slide; }

/// A body of 2 kg and 2 kg m^2 on the world, that a hinge or a slider holds.
struct OnJoint {
  OnJoint(int solver, JointKind which, const JointAxis& what, int substeps = 4, const Vec3& gravity = Vec3::zero(),
          Real mass = 2)
      : t(gravity), kind(which) {
    choose(t, solver, substeps);
    body = add_body(t, Vec3::zero(), mass, Vec3::constant(mass));
    j = join(t, kind, kWorld, body, Vec3::zero(), kOblique);
    t.world.set_joint_axis(j, axis_of_kind(kind), what);
  }
  Vec3 along() const { return kOblique * Vec3(1, 0, 0); }
  void go(Real speed) {
    const Vec3 v = speed * along(), none = Vec3::zero();
    kind == JointKind::slider ? t.world.set_velocity(body, v, none) : t.world.set_velocity(body, none, v);
  }
  Real at() const { return coordinate(t, j, motion_of(kind)); }
  Real speed() const {
    const State& s = t.world.state;
    return (kind == JointKind::slider ? s.v[body] : s.omega[body]).dot(along());
  }
  TestWorld t;
  JointKind kind;
  std::uint32_t body = 0, j = 0;
};

JointAxis with(Real friction, Real armature, Real damping) {
  JointAxis a;
  a.friction = friction, a.armature = armature;
  a.spring = {Gains::force, 0, damping};
  return a;
}

}  // namespace

/// An arm of hinges and a slider whose axes have all properties steps the bits of one of six-axis joints.
static void a_hinge_with_an_axis_is_a_six_axis_joint(void**) {
  for (const int solver : kEverySolver)
    for (const bool six : {false, true}) {
      static std::uint64_t kept = 0;
      TestWorld t;
      choose(t, solver);
      std::uint32_t before = kWorld;
      for (int i = 0; i < 4; ++i) {
        const std::uint32_t body = add_body(t, Vec3(i + 0.5, 0.1 * i, 0), 1 + 0.3 * i, Vec3(0.05, 0.1, 0.12));
        const JointKind kind = i == 2 ? JointKind::slider : JointKind::hinge;
        const std::uint32_t j = join(t, six ? JointKind::six_axis : kind, before, body, Vec3(i, 0, 0),
                                     exp_map(Vec3(0, -1.5 + 0.2 * i, 0.1)));
        JointAxis a = with(0.1 * i, 0.05 * (i + 1), 0.2);
        a.drive = AxisDrive::position, a.target = 0.3, a.gains = {Gains::force, 40, 2}, a.effort_limit = 6,
        a.speed_limit = 2;
        a.mode = AxisMode::limited, a.lower = -0.5, a.upper = 0.6;
        if (six) set_all(t, j, axis_of_kind(kind), locked_at());
        t.world.set_joint_axis(j, axis_of_kind(kind), a);
        before = body;
      }
      for (int i = 0; i < 90; ++i) t.world.step(kStep);
      Real sum = 0;
      for (std::uint32_t i = 0; i < 4; ++i) sum += t.world.state.x[i].x() + t.world.state.omega[i].z();
      const auto bits = std::bit_cast<std::uint64_t>(sum);
      if (six)
        assert_true(bits == kept);
      else
        kept = bits;
    }
}

/// effort t^2 / 2 (m + armature) by the hinge's own motor; m v / friction; v exp(-damping t / m).
static void hinges_and_sliders_have_rotors_friction_and_damping(void**) {
  for (const int solver : kEverySolver)
    for (const JointKind kind : kBoth) {
      for (const Real armature : {1e-12, 0.5, 200.0}) {
        OnJoint s(solver, kind, with(0, armature, 0));
        set_motor(s.t, s.j, motion_of(kind), 1e6, 20);
        const Real a = 20 / (2 + armature);
        for (int i = 1; i <= 30; ++i) {
          s.t.world.step(kStep);
          const Real time = i * kStep;
          assert_true(std::fabs(s.at() - a * time * time / 2) < 1.01 * a * time * kStep / 4 + 1e-6);
        }
      }
      OnJoint rubs(solver, kind, with(4, 0, 0));
      rubs.go(1);
      for (int i = 0; i < 60; ++i) rubs.t.world.step(kStep);
      assert_true(std::fabs(rubs.speed()) < 1e-9 && std::fabs(rubs.at() - 2.0 / 8) < 1.1 * kStep / 8);
      Real worst[2] = {0, 0};
      for (const int fine : {0, 1}) {
        OnJoint slows(solver, kind, with(0, 0, 3), 4 << fine);
        slows.go(1);
        for (int i = 1; i <= 60; ++i) {
          slows.t.world.step(kStep);
          worst[fine] = std::max(worst[fine], std::fabs(slows.speed() - std::exp(-1.5 * i * kStep)));
        }
        assert_true(worst[fine] < 0.5 * 1.5 * kStep / (4 << fine));  // 1 / (1 + x) beyond exp(-x), x = 1.5 h, over time
      }
      assert_true(worst[1] < worst[0] / 1.9);
    }
}

/// Together with what a hinge or a slider has by itself: a limit stops it, a spring holds it.
static void its_own_limit_motor_and_spring_go_on(void**) {
  for (const int solver : kEverySolver)
    for (const JointKind kind : kBoth) {
      OnJoint s(solver, kind, with(0, 1, 0));
      set_limit(s.t, s.j, motion_of(kind), -0.2, 0.3);
      s.go(1);
      for (int i = 0; i < 60; ++i) {
        s.t.world.step(kStep);
        assert_true(s.at() < 0.3 + 1e-3 && s.at() > -0.2 - 1e-3);
      }
      OnJoint held(solver, kind, with(0.01, 0.1, 0));
      set_spring(held.t, held.j, motion_of(kind), 0.4, 3, 1);
      for (int i = 0; i < 120; ++i) held.t.world.step(kStep);
      assert_true(std::fabs(held.at() - 0.4) < 1e-3);
    }
}

/// A hair of each property changes the motion by no more; none is the joint as it was, to the bit.
static void next_to_nothing_is_nothing(void**) {
  for (const int solver : kEverySolver)
    for (const JointKind kind : kBoth) {
      Real at[3];
      std::uint64_t hash[3];
      for (const int k : {0, 1, 2}) {
        OnJoint s(solver, kind,
                  k == 1   ? with(1e-15, 1e-15, 1e-15)
                  : k == 2 ? with(1, 2, 3)
                           : JointAxis(),
                  4, Vec3(0.3, -9.81, 0.2));
        leave_joints_to_solver(s.t);
        if (k == 2) s.t.world.set_joint_axis(s.j, axis_of_kind(kind), JointAxis());
        assert_true((joint(s.t, s.j).axes != 0) == (k == 1));
        set_spring(s.t, s.j, motion_of(kind), 0.4, 1, 0.1);
        for (int i = 0; i < 60; ++i) s.t.world.step(kStep);
        at[k] = s.at(), hash[k] = s.t.world.hash();
      }
      assert_true(hash[2] == hash[0]);
      assert_true(std::fabs(at[1] - at[0]) < 1e-7);  // the direct solver takes no rotor below 1e-9 of a mass
    }
}

// ---- limits of efforts and of speeds ----

/// limit / m, of each kind of drive that asks for more; what a drive may do by itself counts, too.
static void drives_push_within_the_limit_of_efforts(void**) {
  for (const int solver : kEverySolver)
    for (const JointKind kind : kBoth)
      for (const AxisDrive drive : {AxisDrive::position, AxisDrive::velocity, AxisDrive::effort})
        for (const Real limit : {0.0, 0.5, 7.0}) {
          JointAxis a;
          a.drive = drive, a.target = 1e3, a.speed = 1e3, a.effort = 1e3, a.gains = {Gains::force, 1e3, 10};
          a.effort_limit = limit, a.max_force = 5;
          OnJoint s(solver, kind, a);
          const Real most = std::min(limit, Real(5));
          for (int i = 1; i <= 20; ++i) {
            s.t.world.step(kStep);
            assert_true(std::fabs(s.speed() - most / 2 * i * kStep) < 1e-6 * (1 + most));
          }
        }
}

/// Two drives of an axis together: the motor and the spring of a hinge, and the drive of its axis.
static void several_drives_share_the_limit(void**) {
  for (const int solver : kEverySolver)
    for (const JointKind kind : kBoth)
      for (const int drives : {1, 2, 3}) {
        JointAxis a;
        a.effort_limit = 6;
        if (drives > 2) a.drive = AxisDrive::velocity, a.speed = 1e3;
        OnJoint s(solver, kind, a);
        set_motor(s.t, s.j, motion_of(kind), 1e3, 100);
        if (drives > 1) set_spring(s.t, s.j, motion_of(kind), 900, 5, 0.1);
        for (int i = 1; i <= 20; ++i) {
          s.t.world.step(kStep);
          assert_true(std::fabs(s.speed() - 3 * i * kStep) < 1e-6);
        }
      }
}

/// Springs of axes, friction and stops are no drives.
static void springs_are_not_bound_by_it(void**) {
  for (const int solver : kEverySolver) {
    JointAxis a;
    a.spring = {Gains::force, 50, 0}, a.rest = 1, a.effort_limit = 0;
    OnJoint s(solver, JointKind::slider, a);
    for (int i = 0; i < 10; ++i) s.t.world.step(kStep);
    assert_true(s.speed() > 2);
  }
}

/// What falls along an upright rail falls as fast as it may, and no faster: g t, then the limit.
static void an_axis_goes_no_faster_than_its_limit(void**) {
  for (const int solver : kEverySolver)
    for (const Real limit : {0.3, 2.0})
      for (const Real dt : {1.0 / 30, kStep, 1.0 / 240})
        for (const int substeps : {4, 8}) {
          TestWorld t;
          choose(t, solver, substeps);
          const std::uint32_t body = add_body(t, Vec3::zero(), 3, Vec3::constant(1));
          const std::uint32_t j = join(t, JointKind::slider, kWorld, body, Vec3::zero(), x_along(Vec3(0, 1, 0)));
          JointAxis a;
          a.speed_limit = limit;
          t.world.set_joint_axis(j, 0, a);
          Real worst = 0, off = 0;
          for (int i = 1; i * dt < 0.6; ++i) {
            t.world.step(dt);
            const Real time = i * dt, reached = limit / kG;
            worst = std::max(worst, std::fabs(t.world.state.v[body].y()) - limit);
            const Real fallen = time < reached ? kG * time * time / 2 : limit * (time - reached / 2);
            off = std::max(off, std::fabs(t.world.state.x[body].y() + fallen));
          }
          assert_true(worst < 1e-9);
          assert_true(off < 1.01 * kG * dt * dt / 2);
        }
}

/// A wheel that a host spins too fast, either way; one with a rotor; one between two bodies, which keep their spin together.
static void what_is_too_fast_is_braked(void**) {
  for (const int solver : kEverySolver)
    for (const Real way : {1.0, -1.0})
      for (const Real armature : {0.0, 0.5}) {
        JointAxis a;
        a.speed_limit = 4, a.armature = armature;
        OnJoint s(solver, JointKind::hinge, a);
        s.go(way * 30);
        for (int i = 0; i < 20; ++i) {
          s.t.world.step(kStep);
          if (i > 2) assert_true(std::fabs(std::fabs(s.speed()) - 4) < 1e-6);
        }
      }
  for (const int solver : kEverySolver) {
    TestWorld t(Vec3::zero());
    choose(t, solver);
    const std::uint32_t a = add_body(t, Vec3::zero(), 1, Vec3::constant(2)),
                        b = add_body(t, Vec3::zero(), 1, Vec3::constant(3));
    const std::uint32_t j = join(t, JointKind::hinge, a, b, Vec3::zero());
    JointAxis slow;
    slow.speed_limit = 1;
    t.world.set_joint_axis(j, 3, slow);
    t.world.set_velocity(a, Vec3::zero(), Vec3(-2, 0, 0)), t.world.set_velocity(b, Vec3::zero(), Vec3(5, 0, 0));
    for (int i = 0; i < 20; ++i) t.world.step(kStep);
    assert_true(std::fabs(t.world.state.omega[b].x() - t.world.state.omega[a].x() - 1) < 1e-9);
    assert_true(std::fabs(2 * t.world.state.omega[a].x() + 3 * t.world.state.omega[b].x() - 11) < 1e-9);
  }
}

/// Where it is slow enough nothing is felt of it, and a hair above is as if there were none.
static void a_limit_that_is_not_reached_does_nothing(void**) {
  for (const int solver : kEverySolver) {
    Real at[2];
    for (const bool limited : {false, true}) {
      JointAxis a;
      a.armature = 1e-9;  // so both are alike but for the limit
      if (limited) a.speed_limit = 1 + 1e-15;
      OnJoint s(solver, JointKind::hinge, a);
      s.go(1);
      for (int i = 0; i < 60; ++i) s.t.world.step(kStep);
      at[limited] = s.at();
    }
    assert_true(std::fabs(at[1] - at[0]) < 1e-12);
  }
}

/// A double pendulum of limited speeds falls: energy never grows, and no joint is faster.
static void limited_pendulums_lose_energy_alone(void**) {
  for (const int solver : kEverySolver)
    for (const Real limit : {0.5, 2.0, 6.0}) {
      TestWorld t;
      choose(t, solver, 8);
      std::uint32_t before = kWorld;
      std::vector<std::uint32_t> joints;
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t body = add_body(t, Vec3(i + 0.5, 0, 0), 1, Vec3(0.01, 0.085, 0.085));
        joints.push_back(join(t, JointKind::hinge, before, body, Vec3(i, 0, 0), x_along(Vec3(0, 0, 1))));
        JointAxis a;
        a.speed_limit = limit;
        t.world.set_joint_axis(joints.back(), 3, a);
        before = body;
      }
      Real energy = energy_of(t);
      for (int i = 0; i < 300; ++i) {
        t.world.step(kStep);
        const Real now = energy_of(t);
        assert_true(now < energy + 0.02);
        energy = std::min(energy, now);
        for (const std::uint32_t j : joints) {
          const JointDef& def = joint(t, j).def;
          const auto spin = [&](std::uint32_t b) { return b == kWorld ? 0 : t.world.state.omega[b].z(); };
          assert_true(std::fabs(spin(def.body_b) - spin(def.body_a)) < limit + (is_direct(solver) ? 1e-9 : 0.3));
        }
      }
    }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_hinge_with_an_axis_is_a_six_axis_joint),
      cmocka_unit_test(hinges_and_sliders_have_rotors_friction_and_damping),
      cmocka_unit_test(its_own_limit_motor_and_spring_go_on),
      cmocka_unit_test(next_to_nothing_is_nothing),
      cmocka_unit_test(drives_push_within_the_limit_of_efforts),
      cmocka_unit_test(several_drives_share_the_limit),
      cmocka_unit_test(springs_are_not_bound_by_it),
      cmocka_unit_test(an_axis_goes_no_faster_than_its_limit),
      cmocka_unit_test(what_is_too_fast_is_braked),
      cmocka_unit_test(a_limit_that_is_not_reached_does_nothing),
      cmocka_unit_test(limited_pendulums_lose_energy_alone),
  };
  return cmocka_run_group_tests_name("oracle/axis_limits", tests, nullptr, nullptr);
}
