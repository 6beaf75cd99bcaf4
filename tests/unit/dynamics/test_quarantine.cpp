// Bad states and bad support functions stay with the body and the shape that have them.
#include "carom_test.h"
#include "dynamics/quarantine.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

static bool all_finite(const World& w) {
  for (std::uint32_t i = 0; i < w.scene.bodies.slots(); ++i)
    if (!finite(w.state.x[i]) || !finite(w.state.v[i]) || !finite(w.state.omega[i]) || !w.state.q[i].all_finite())
      return false;
  return true;
}

static void a_body_that_is_not_finite_is_held_and_its_neighbours_live_on(void**) {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  for (const Real bad : {nan, kInfinity, -kInfinity, 1e300}) {
    for (int field = 0; field < 4; ++field) {
      TestWorld t;
      t.ground();
      const Shape* cube = t.keep(box(Vec3::constant(0.5)));
      const std::uint32_t below = t.add(cube, Vec3(0, 0.5, 0)), sick = t.add(cube, Vec3(0, 1.5, 0));
      t.run(5, 1.0 / 60);
      const Vec3 v(0, bad, 0);
      if (field == 0) t.world.set_pose(sick, {Quat::identity(), v});
      if (field == 1) t.world.set_velocity(sick, v, Vec3::zero());
      if (field == 2) t.world.set_velocity(sick, Vec3::zero(), v);
      if (field == 3) t.world.set_force(sick, v, v);
      t.world.step(1.0 / 60);
      assert_int_equal(t.world.fault_views.size(), 1);
      assert_int_equal(t.world.fault_views[0].body, sick);
      assert_true(t.world.fault_views[0].support.kind == SupportFault::none);
      assert_int_equal(t.world.report.quarantined_bodies, 1);
      const Vec3 held = t.world.state.x[sick];
      t.run(30, 1.0 / 60);
      assert_true(all_finite(t.world));
      assert_int_equal(t.world.report.faults, 0);
      if (field < 3) assert_true(t.world.state.x[sick] == held);
      assert_true(std::fabs(t.world.state.x[below].y() - 0.5) < 0.01);
      // Given a pose, it is back in the world.
      t.world.set_pose(sick, {Quat::identity(), Vec3(3, 5, 0)});
      t.run(10, 1.0 / 60);
      assert_int_equal(t.world.report.quarantined_bodies, 0);
      assert_true(t.world.state.x[sick].y() < 5);
    }
  }
}

static std::int32_t failing = 0;

static std::int32_t moody_support(void*, const double* p, std::uint64_t n, const double* d, double* out) {
  const std::int32_t r = box_support(nullptr, p, n, d, out);
  if (failing == 2) out[1] = std::numeric_limits<double>::quiet_NaN();
  return failing == 1 ? 1 : r;
}

static void a_shape_that_misbehaves_is_disabled_in_its_world(void**) {
  for (const std::int32_t how : {1, 2}) {
    failing = 0;
    TestWorld t;
    t.ground();
    Shape shape = box(Vec3::constant(0.5));
    shape.support = moody_support;
    const Shape* moody = t.keep(std::move(shape));
    const_cast<Shape*>(moody)->form = Form::none;  // the generic path asks its support
    const Shape* good = t.keep(box(Vec3::constant(0.5)));
    const std::uint32_t a = t.add(moody, Vec3(0, 0.5, 0)), b = t.add(moody, Vec3(5, 0.5, 0)),
                        c = t.add(good, Vec3(9, 0.5, 0));
    t.run(5, 1.0 / 60);
    assert_int_equal(t.world.report.faults, 0);
    failing = how;
    t.world.step(1.0 / 60);
    assert_int_equal(t.world.report.faults, 1);  // once, though two colliders wear it
    assert_ptr_equal(t.world.fault_views[0].support.shape, moody);
    assert_int_equal(t.world.fault_views[0].body, a);
    failing = 0;
    t.run(60, 1.0 / 60);
    assert_int_equal(t.world.report.faults, 0);
    assert_true(all_finite(t.world));
    assert_true(t.world.state.x[a].y() < 0 && t.world.state.x[b].y() < 0);  // fell through: it touches nothing
    assert_true(std::fabs(t.world.state.x[c].y() - 0.5) < 0.01);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_body_that_is_not_finite_is_held_and_its_neighbours_live_on),
      cmocka_unit_test(a_shape_that_misbehaves_is_disabled_in_its_world),
  };
  return cmocka_run_group_tests_name("dynamics/quarantine", tests, nullptr, nullptr);
}
