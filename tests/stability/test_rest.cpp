// What should stand still stands still: a box, a stack, a pile, also far from the origin.
//
// A contact may keep a velocity error up to the dial velocity_tolerance, tol. It changes sign as it is corrected, so a
// body wanders rather than runs; the bounds here are what running at tol all the time would do, tol * T, plus the depth
// to which a contact sinks before it is pushed back, position_tolerance.
#include <vector>

#include "carom_test.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kStep = 1.0 / 60;

Real tolerance(const World& w) { return w.scene.dials[Dial::velocity_tolerance]; }
Real depth(const World& w) { return w.scene.dials[Dial::position_tolerance]; }

bool all_finite(const World& w) {
  for (std::uint32_t i = 0; i < w.scene.bodies.slots(); ++i)
    if (!finite(w.state.x[i]) || !finite(w.state.v[i]) || !finite(w.state.omega[i]) || !w.state.q[i].all_finite())
      return false;
  return true;
}

}  // namespace

static void a_box_at_rest_stays_at_rest(void**) {
  for (const Real integrator : {0.0, 1.0, 2.0}) {
    TestWorld t;
    t.world.set_dial(Dial::integrator, integrator);
    t.ground();
    const std::uint32_t b = t.add(t.keep(box(Vec3(0.5, 0.25, 0.5))), Vec3(0, 0.25, 0));
    t.run(3600, kStep);
    const Vec3 moved = t.world.state.x[b] - Vec3(0, 0.25, 0);
    assert_true(std::hypot(moved.x(), moved.z()) < tolerance(t.world) * 60);
    assert_true(moved.y() <= depth(t.world) && moved.y() >= -2 * depth(t.world));
    assert_true(t.world.state.v[b].norm() < 4 * tolerance(t.world));
  }
}

static void a_stack_of_five_boxes_stands_for_a_minute(void**) {
  for (const Real side : {0.2, 1.0}) {
    TestWorld t;
    t.ground();
    const Shape* cube = t.keep(box(Vec3::constant(side / 2)));
    std::vector<std::uint32_t> stack;
    for (int i = 0; i < 5; ++i) stack.push_back(t.add(cube, Vec3(0, side * (i + 0.5), 0)));
    t.run(3600, kStep);
    for (int i = 0; i < 5; ++i) {
      const Vec3 moved = t.world.state.x[stack[i]] - Vec3(0, side * (i + 0.5), 0);
      // Each level may run over the one below.
      assert_true(std::hypot(moved.x(), moved.z()) < (i + 1) * tolerance(t.world) * 60);
      assert_true(moved.y() > -(i + 1) * 2 * depth(t.world) && moved.y() < (i + 1) * depth(t.world));
      assert_true(t.world.state.v[stack[i]].norm() < 0.02);
    }
  }
}

static void a_stack_stands_a_thousand_kilometres_out(void**) {
  // Positions of 1e6 m resolve 1.2e-10 m: no different from the origin, to the width of the tolerances.
  const Vec3 far(1e6, 0, -1e6);
  TestWorld t;
  t.ground();
  const Shape* cube = t.keep(box(Vec3::constant(0.5)));
  std::vector<std::uint32_t> stack;
  for (int i = 0; i < 3; ++i) stack.push_back(t.add(cube, far + Vec3(0, i + 0.5, 0)));
  t.run(600, kStep);
  for (int i = 0; i < 3; ++i) {
    const Vec3 moved = t.world.state.x[stack[i]] - far - Vec3(0, i + 0.5, 0);
    assert_true(std::hypot(moved.x(), moved.z()) < (i + 1) * tolerance(t.world) * 10 + depth(t.world));
    assert_true(std::fabs(moved.y()) < (i + 1) * 2 * depth(t.world));
  }
}

static void a_ball_on_a_plane_does_not_start_to_roll(void**) {
  TestWorld t;
  t.ground();
  const std::uint32_t b = t.add(t.keep(sphere(0.5)), Vec3(0, 0.5, 0));
  t.run(600, kStep);
  assert_true(t.world.state.x[b].x() == 0 && t.world.state.x[b].z() == 0);  // nothing breaks the symmetry
}

static void sixty_four_bodies_fall_into_a_box_and_come_to_rest(void**) {
  TestWorld t;
  t.ground();
  const Shape* wall_x = t.keep(box(Vec3(0.5, 5, 2)));
  const Shape* wall_z = t.keep(box(Vec3(2, 5, 0.5)));
  for (const Real side : {-1.0, 1.0}) {
    t.add(wall_x, Vec3(side * 1.5, 5, 0), BodyType::fixed);
    t.add(wall_z, Vec3(0, 5, side * 1.5), BodyType::fixed);
  }
  const Shape* shapes[] = {t.keep(box(Vec3::constant(0.15))), t.keep(sphere(0.15)), t.keep(capsule(0.1, 0.1)),
                           t.keep(cylinder(0.15, 0.15))};
  std::vector<std::uint32_t> bodies;
  for (int i = 0; i < 64; ++i)
    bodies.push_back(t.add(shapes[i % 4], Vec3(-0.6 + 0.4 * (i % 4), 0.5 + 0.45 * (i / 16), -0.6 + 0.4 * (i / 4 % 4)),
                           BodyType::dynamic, exp_map(Vec3(0.1 * i, 0.2, -0.05 * i))));
  Real peak = 0;
  for (int i = 0; i < 600; ++i) {
    t.world.step(kStep);
    peak = std::max<Real>(peak, t.world.report.max_penetration);
  }
  assert_true(all_finite(t.world));
  for (const std::uint32_t b : bodies) {
    const Vec3& x = t.world.state.x[b];
    // The centre of a body lies at least its smallest half-width (0.1) inside.
    assert_true(x.y() > 0.09 && std::fabs(x.x()) < 0.91 && std::fabs(x.z()) < 0.91);
  }
  assert_true(peak < 0.15);  // never as deep as half a body
  assert_true(t.world.report.max_penetration < 0.012 && t.world.report.mean_penetration < 0.002);
  assert_int_equal(t.world.report.quarantined_bodies, 0);
}

static void deep_overlap_is_undone_without_an_explosion(void**) {
  TestWorld t;
  t.ground();
  const Shape* cube = t.keep(box(Vec3::constant(0.5)));
  std::vector<std::uint32_t> pile;
  for (int i = 0; i < 4; ++i)
    pile.push_back(t.add(cube, Vec3(0.1 * i, 0.5 + 0.5 * i, 0.05 * i)));  // half sunk into each other
  // Pushing apart adds no velocity. (Later the crooked tower topples, as it should.)
  for (int i = 0; i < 60; ++i) {
    t.world.step(kStep);
    for (const std::uint32_t b : pile) assert_true(t.world.state.v[b].norm() < 2);
  }
  assert_true(t.world.report.max_penetration < 0.012);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_box_at_rest_stays_at_rest),
      cmocka_unit_test(a_stack_of_five_boxes_stands_for_a_minute),
      cmocka_unit_test(a_stack_stands_a_thousand_kilometres_out),
      cmocka_unit_test(a_ball_on_a_plane_does_not_start_to_roll),
      cmocka_unit_test(sixty_four_bodies_fall_into_a_box_and_come_to_rest),
      cmocka_unit_test(deep_overlap_is_undone_without_an_explosion),
  };
  return cmocka_run_group_tests_name("stability/rest", tests, nullptr, nullptr);
}
