// Residuals against what is known: rest and slip obey the law under every solver, and an impulse that is made wrong by
// so much is found wrong by so much.
#include <cmath>

#include "carom_test.h"
#include "dynamics/contact/contact.h"
#include "dynamics/residuals.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kStep = 1.0 / 60, kGravity = 9.81;

/// A ball of 0.5 m, which an impulse at its foot along the normal does not turn: k = 1 / m.
struct Ball {
  explicit Ball(Real friction, const Vec3& velocity = Vec3::zero()) {
    const std::uint32_t m = t.material(friction, 0);
    t.ground(m);
    body = t.add(t.keep(sphere(0.5)), Vec3(0, 0.5, 0), BodyType::dynamic, Quat::identity(), m);
    t.world.set_velocity(body, velocity, Vec3::zero());
  }
  Row& row() { return t.world.contacts->rows[0]; }
  Real k() const { return t.world.scene.inv_mass[body]; }
  TestWorld t;
  std::uint32_t body;
};

}  // namespace

static void what_rests_obeys_the_law_and_has_its_energy(void**) {
  for (int solver = 0; solver < kSolverChoices; ++solver) {
    TestWorld t;
    t.world.set_dial(Dial::solver, solver);
    t.ground();
    const std::uint32_t cube = t.add(t.keep(box(Vec3::constant(0.5))), Vec3(0, 0.5, 0));
    t.run(240, kStep);
    const Residuals r = residuals_of(t.world);
    assert_int_equal(r.points, 4);
    assert_true(r.max_penetration == t.world.report.max_penetration);
    assert_true(r.mean_penetration == t.world.report.mean_penetration);
    // What solvers are asked for; at rest those that sweep are far below it.
    const Real left = t.world.scene.dials[Dial::velocity_tolerance];
    assert_true(r.complementarity < left && r.slip < left);
    assert_true(r.cone < 1e-12);
    const Real m = t.world.scene.mass[cube], height = t.world.state.x[cube].y();
    assert_true(std::fabs(r.energy - m * kGravity * height) < 1e-3 * m);
    assert_true(r.energy_drift == 0);
  }
}

static void what_slides_is_held_by_all_its_friction_against_its_way(void**) {
  for (int solver = 0; solver < kSolverChoices; ++solver) {
    TestWorld t;
    t.world.set_dial(Dial::solver, solver);
    const std::uint32_t m = t.material(0.3, 0);
    t.ground(m);
    const std::uint32_t cube =
        t.add(t.keep(box(Vec3(0.5, 0.1, 0.5))), Vec3(0, 0.1, 0), BodyType::dynamic, Quat::identity(), m);
    t.world.set_velocity(cube, Vec3(4, 0, 3), Vec3::zero());
    t.run(30, kStep);
    assert_true(t.world.state.v[cube].norm() > 3);
    const Residuals r = residuals_of(t.world);
    // Friction opposes the slip at another moment of the substep than that at which the velocity is read.
    assert_true(r.slip < 0.05 && r.cone < 1e-9);
  }
}

static void an_impulse_that_is_wrong_is_wrong_by_that_much(void**) {
  {  // friction beyond the cone
    Ball b(0.25, Vec3(5, 0, 0));
    b.t.run(3, kStep);
    Row& row = b.row();
    const Real p_n = row.p.dot(row.n), most = row.friction * p_n;
    assert_true(p_n > 0 && residuals_of(b.t.world).cone < 1e-12);
    Vec3 rub = row.p - p_n * row.n;
    assert_true(std::fabs(rub.norm() - most) < 1e-9 * most);  // it slips
    row.p = p_n * row.n + 3 * rub;
    assert_true(std::fabs(residuals_of(b.t.world).cone - b.k() * 2 * most) < 1e-9);
    row.p = p_n * row.n - rub;  // along the slip: 2 of it to be taken back, and that is all that the disc allows
    assert_true(std::fabs(residuals_of(b.t.world).slip - b.k() * 2 * most) < 1e-9);
    row.p = p_n * row.n;
    assert_true(std::fabs(residuals_of(b.t.world).slip - b.k() * most) < 1e-9);
  }
  {  // a push while it parts, and an approach that nothing stops
    Ball b(0);
    b.t.run(60, kStep);
    Row& row = b.row();
    RowGeometry& g = b.t.world.contacts->geometry[0];
    g.separation = 0;
    row.p = 0.2 / b.k() * row.n;  // worth 0.2 m/s
    row.u = 0.5 * row.n;
    assert_true(std::fabs(residuals_of(b.t.world).complementarity - 0.2) < 1e-12);
    row.u = 0.05 * row.n;
    assert_true(std::fabs(residuals_of(b.t.world).complementarity - 0.05) < 1e-12);
    row.u = -0.3 * row.n;
    assert_true(std::fabs(residuals_of(b.t.world).complementarity - 0.3) < 1e-12);
    row.p.set_zero();
    row.u = 0.3 * row.n;
    assert_true(residuals_of(b.t.world).complementarity == 0);
    // Still open by more than it closes in a substep.
    row.u = -0.3 * row.n;
    g.separation = 0.3 * b.t.world.impulses.old_h * 1.01;
    assert_true(residuals_of(b.t.world).complementarity == 0);
  }
}

static void joints_that_are_pulled_apart_gape_by_that(void**) {
  TestWorld t(Vec3::zero());
  const std::uint32_t a = t.add(t.keep(box(Vec3::constant(0.5))), Vec3::zero()),
                      b = t.add(t.keep(box(Vec3::constant(0.5))), Vec3(1.5, 0, 0));
  JointDef def;
  def.kind = JointKind::weld;
  def.body_a = a, def.body_b = b;
  def.frame_a.p = Vec3(0.75, 0, 0), def.frame_b.p = Vec3(-0.75, 0, 0);
  t.world.add_joint(def);
  t.run(1, kStep);
  Residuals r = residuals_of(t.world);
  assert_int_equal(r.joints, 1);
  assert_true(r.joint_gap < 1e-12 && r.joint_angle < 1e-7);
  t.world.set_pose(b, {exp_map(Vec3(0, 0.02, 0)), Vec3(1.5, 0, 0) + Vec3(0.003, 0.004, 0)});
  r = residuals_of(t.world);
  // The frame of B turned about B's centre, 0.75 m away.
  const Vec3 moved = Vec3(0.003, 0.004, 0) + Vec3(0.75, 0, 0) + exp_map(Vec3(0, 0.02, 0)) * Vec3(-0.75, 0, 0);
  assert_true(std::fabs(r.joint_gap - moved.norm()) < 1e-12);
  assert_true(std::fabs(r.joint_angle - 0.02) < 1e-7);
}

static void drift_is_what_the_ledger_can_not_account_for(void**) {
  // A brick that nothing acts on, turned by the explicit method: all that its energy changes by is the integrator's.
  TestWorld t(Vec3::zero());
  const std::uint32_t brick = t.add(t.keep(box(Vec3(0.5, 0.2, 0.9))), Vec3(2, 0, 0));
  t.world.set_dial(Dial::rotation, 1);
  t.world.set_dial(Dial::substeps, 1);  // so that the drift is far above rounding
  t.world.set_velocity(brick, Vec3(0, 1, 0), Vec3(3, 2, 1));
  t.world.keep_ledger(true);
  const Real before = residuals_of(t.world).energy;
  t.run(1, kStep);
  const Residuals r = residuals_of(t.world);
  assert_true(std::fabs(r.energy_drift) > 1e-6 * before);
  assert_true(std::fabs(r.energy_drift - (r.energy - before)) < 1e-13 * before);
}

static void without_contacts_and_joints_there_is_nothing_to_judge(void**) {
  TestWorld t;
  const std::uint32_t ball = t.add(t.keep(sphere(0.5)), Vec3(0, 3, 0));
  const Residuals before = residuals_of(t.world);
  assert_true(before.points == 0 && before.joints == 0 && before.complementarity == 0);
  t.run(10, kStep);
  const Residuals r = residuals_of(t.world);
  assert_true(r.points == 0 && r.max_penetration == 0 && r.cone == 0 && r.slip == 0);
  const Real m = t.world.scene.mass[ball];
  assert_true(std::fabs(r.energy - 3 * m * kGravity) < 1e-9 * m);  // Verlet is exact in free fall
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(what_rests_obeys_the_law_and_has_its_energy),
      cmocka_unit_test(what_slides_is_held_by_all_its_friction_against_its_way),
      cmocka_unit_test(an_impulse_that_is_wrong_is_wrong_by_that_much),
      cmocka_unit_test(joints_that_are_pulled_apart_gape_by_that),
      cmocka_unit_test(drift_is_what_the_ledger_can_not_account_for),
      cmocka_unit_test(without_contacts_and_joints_there_is_nothing_to_judge),
  };
  return cmocka_run_group_tests_name("oracle/residuals", tests, nullptr, nullptr);
}
