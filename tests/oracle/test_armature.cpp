// Rotors and friction of joints' axes against closed forms, under every solver that knows joints.
#include "carom_test.h"
#include "dynamics/joint/tree/joint_tree.h"
#include "six_axes.h"

using namespace carom;
using namespace carom::test;

namespace {

Vec3 along(std::uint32_t axis) {
  return kOblique * (axis % 3 == 0 ? Vec3(1, 0, 0) : axis % 3 == 1 ? Vec3(0, 1, 0) : Vec3(0, 0, 1));
}

/// A body on the world, free along one axis.
struct OnAxis {
  OnAxis(int solver, std::uint32_t k, Real mass, const JointAxis& what, int substeps = 4) : t(Vec3::zero()), axis(k) {
    choose(t, solver, substeps);
    body = add_body(t, Vec3::zero(), mass, Vec3::constant(mass));
    j = join_axes(t, kInvalid, body, Vec3::zero());
    set_all(t, j, axis, locked_at());
    t.world.set_joint_axis(j, axis, what);
  }
  void go(Real speed) {
    const Vec3 v = speed * along(axis);
    if (axis < kPlaces)
      t.world.set_velocity(body, v, Vec3::zero());
    else
      t.world.set_velocity(body, Vec3::zero(), v);
  }
  Real speed() const {
    const State& s = t.world.state;
    return (axis < kPlaces ? s.v[body] : s.omega[body]).dot(along(axis));
  }
  TestWorld t;
  std::uint32_t axis, body, j;
};

JointAxis pushed(Real effort, Real armature) {
  JointAxis a;
  a.drive = AxisDrive::effort, a.effort = effort, a.armature = armature;
  return a;
}

}  // namespace

/// x = F t^2 / 2 (m + armature), but for a substep's worth of first order.
static void a_rotor_is_inertia_along_its_axis(void**) {
  const Real m = 3, effort = 20;
  for (const int solver : kEverySolver)
    for (const Real armature : {1e-12, 0.3, 3.0, 300.0})
      for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
        OnAxis s(solver, axis, m, pushed(effort, armature));
        const Real a = effort / (m + armature);
        for (int i = 1; i <= 30; ++i) {
          s.t.world.step(kStep);
          const Real time = i * kStep;
          assert_true(std::fabs(axis_of(s.t, s.j, axis) - a * time * time / 2) < 1.01 * a * time * kStep / 4 + 1e-12);
        }
      }
}

/// Of a spring k: sqrt(k / (m + armature)), half a substep off as without a rotor.
static void a_rotor_swings_on_a_spring_more_slowly(void**) {
  const Real m = 2, k = 300, x0 = 0.3;
  for (const int solver : kEverySolver)
    for (const std::uint32_t axis : {1u, 3u})
      for (const Real armature : {0.5, 8.0}) {
        Real worst[2];
        for (const int fine : {0, 1}) {
          JointAxis sprung;
          sprung.spring = {Gains::force, k, 0}, sprung.armature = armature;
          OnAxis s(solver, axis, m, sprung, 4 << fine);
          const Vec3 off = x0 * along(axis);
          s.t.world.set_pose(s.body, axis < kPlaces ? Pose{Quat::identity(), off} : Pose{exp_map(off), Vec3::zero()});
          const Real w = std::sqrt(k / (m + armature));
          worst[fine] = 0;
          for (int i = 1; i <= 60; ++i) {
            s.t.world.step(kStep);
            worst[fine] = std::max(worst[fine], std::fabs(axis_of(s.t, s.j, axis) - x0 * std::cos(w * i * kStep)));
          }
          // A substep implicit in its spring fades by w^2 h / 2.
          assert_true(worst[fine] < 1.1 * x0 * (w * (1 + w) * kStep / (8 << fine)));
        }
        assert_true(worst[1] < worst[0] / 1.8);
      }
}

/// Between two bodies that nothing holds: q = effort t^2 / 2 (armature + I), I that of both against each other. The rotor has no
/// spin of its own, so theirs stay opposite.
static void a_rotor_between_two_bodies_takes_no_spin(void**) {
  for (const int solver : kEverySolver)
    for (const Real armature : {0.01, 2.0, 200.0}) {
      TestWorld t(Vec3::zero());
      choose(t, solver);
      const std::uint32_t a = add_body(t, Vec3::zero(), 1, Vec3::constant(2)),
                          b = add_body(t, Vec3::zero(), 1, Vec3::constant(3));
      const std::uint32_t j = join_axes(t, a, b, Vec3::zero());
      set_all(t, j, 3, locked_at());
      t.world.set_joint_axis(j, 3, pushed(5, armature));
      const Real q2 = 5 / (armature + 1.2), time = 0.5;
      for (int i = 0; i < 30; ++i) t.world.step(kStep);
      assert_true(std::fabs(axis_of(t, j, 3) - q2 * time * time / 2) < 1.01 * q2 * time * kStep / 4 + 1e-12);
      assert_true((2 * t.world.state.omega[a] + 3 * t.world.state.omega[b]).norm() < 1e-9);
    }
}

static void a_rotor_goes_as_its_host_says(void**) {
  for (const int solver : kEverySolver)
    for (const std::uint32_t axis : {0u, 4u}) {
      JointAxis heavy;
      heavy.armature = 50;
      OnAxis s(solver, axis, 1, heavy);
      for (int i = 0; i < 3; ++i) s.t.world.step(kStep);
      s.go(1.5);
      for (int i = 0; i < 20; ++i) {
        s.t.world.step(kStep);
        assert_true(std::fabs(s.speed() - 1.5) < 1e-9);
      }
    }
}

/// What slides stops after m v / f, having gone m v^2 / 2 f; what is pushed by less than f stays.
static void friction_of_an_axis_stops_and_holds(void**) {
  const Real m = 2, f = 4, v = 1;
  for (const int solver : kEverySolver)
    for (const std::uint32_t axis : {2u, 3u}) {
      JointAxis rubs;
      rubs.friction = f;
      OnAxis s(solver, axis, m, rubs);
      s.go(v);
      for (int i = 0; i < 60; ++i) s.t.world.step(kStep);
      assert_true(std::fabs(s.speed()) < 1e-9);
      assert_true(std::fabs(axis_of(s.t, s.j, axis) - m * v * v / (2 * f)) < 1.1 * v * kStep / 8);
      rubs.drive = AxisDrive::effort, rubs.effort = 0.9 * f;
      OnAxis held(solver, axis, m, rubs);
      for (int i = 0; i < 60; ++i) held.t.world.step(kStep);
      assert_true(std::fabs(axis_of(held.t, held.j, axis)) < 1e-9);
    }
}

/// Where the step and the tree's mass matrix agree: an arm of three links, each with a rotor, is moved by efforts from rest.
static void the_mass_matrix_counts_rotors(void**) {
  TestWorld t(Vec3::zero());
  choose(t, kDirectChoice, 1);
  const Real effort[] = {3, -1, 0.5};
  std::uint32_t before = kInvalid, last = 0;
  for (int i = 0; i < 3; ++i) {
    last = add_body(t, Vec3(i + 0.5, 0.1 * i, 0), 1 + i, Vec3(0.1, 0.2, 0.15));
    const std::uint32_t j = join_axes(t, before, last, Vec3(i, 0, 0.05 * i), exp_map(Vec3(0, 0.3 * i, -1)));
    set_all(t, j, 3, locked_at());
    t.world.set_joint_axis(j, 3, pushed(effort[i], 0.2 * (i + 1)));
    before = last;
  }
  JointTree tree(std::pmr::new_delete_resource());
  assert_true(tree.find(t.world, last) == TreeFault::none);
  Real rate[3], force[3], mass[9];
  const Real h = 1e-7, still[3] = {};
  tree.find_mass(t.world, mass);
  t.world.step(h);
  tree.read_speeds(t.world, rate);
  for (Real& r : rate) r /= h;
  tree.find_forces(t.world, still, rate, force);
  for (int i = 0; i < 3; ++i) {
    assert_true(std::fabs(force[i] - effort[i]) < 1e-5);
    assert_true(std::fabs(mass[3 * i] * rate[0] + mass[3 * i + 1] * rate[1] + mass[3 * i + 2] * rate[2] - effort[i]) <
                1e-5);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_rotor_is_inertia_along_its_axis),
      cmocka_unit_test(a_rotor_swings_on_a_spring_more_slowly),
      cmocka_unit_test(a_rotor_between_two_bodies_takes_no_spin),
      cmocka_unit_test(a_rotor_goes_as_its_host_says),
      cmocka_unit_test(friction_of_an_axis_stops_and_holds),
      cmocka_unit_test(the_mass_matrix_counts_rotors),
  };
  return cmocka_run_group_tests_name("oracle/armature", tests, nullptr, nullptr);
}
