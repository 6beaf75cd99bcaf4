// Bodies on meshes and height fields: no ghost collisions on sides between triangles, nothing falls through, stacks
// stand.
#include <random>

#include "carom_test.h"
#include "dynamics/contact_views.h"
#include "dynamics/sleep/sleep.h"
#include "scenery_builder.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kStep = 1.0 / 60;
enum class Ground { plane, mesh, field };

double level(double, double) { return 0; }

void lay(TestWorld& t, Ground ground, std::uint32_t material, const Quat& tilt = Quat::identity()) {
  if (ground == Ground::plane) {
    t.add(t.keep(half_space(Vec3::unit_y(), 0)), Vec3::zero(), BodyType::fixed, tilt, material);
  } else if (ground == Ground::mesh) {
    t.add(t.keep(mesh(grid(100, 50, 0.2, -4, -5, level))), Vec3::zero(), BodyType::fixed, tilt, material);
  } else {
    const Shape* const field =
        t.keep(height_field(101, 51, 0.2, 0.2, [](std::uint32_t, std::uint32_t) { return 0.0; }));
    t.add(field, tilt * Vec3(-4, 0, -5), BodyType::fixed, tilt, material);
  }
}

struct Ride {
  Real bump = 0;  // m/s, the most across the surface
  Real slow = 0;  // m/s, the most that the way along it was lost or gained
  Real last_y = 0, last_x = 0;
};

/// 10,000 triangles in one plane; a body that has come to rest on them is pushed and slides without friction.
Ride slide(std::uint32_t solver, const Shape& shape, Real height, const Quat& q, Ground ground) {
  TestWorld t;
  t.world.set_dial(Dial::solver, solver);
  const std::uint32_t smooth = t.material(0, 0);
  lay(t, ground, smooth);
  const std::uint32_t body = t.add(&shape, Vec3(-3.087, height, 0.021), BodyType::dynamic, q, smooth);
  t.run(300, kStep);
  const Vec3 push(3, 0, 0.37);
  t.world.set_velocity(body, push, Vec3::zero());
  Ride ride;
  t.run(30, kStep);  // the push is one, on a plane as well
  for (int i = 0; i < 210; ++i) {
    t.world.step(kStep);
    const Vec3 v = t.world.state.v[body];
    ride.bump = std::max(ride.bump, std::fabs(v.y()));
    ride.slow = std::max(ride.slow, std::hypot(v.x() - push.x(), v.z() - push.z()));
  }
  ride.last_x = t.world.state.x[body].x(), ride.last_y = t.world.state.x[body].y();
  return ride;
}

}  // namespace

static void bodies_slide_over_ten_thousand_triangles_as_over_a_plane(void**) {
  Shape shapes[] = {box(Vec3(0.5, 0.25, 0.35)), sphere(0.3), capsule(0.4, 0.2)};
  const Real heights[] = {0.25, 0.3, 0.4};
  const Quat lying(std::sqrt(0.5), 0, 0, std::sqrt(0.5));
  for (Shape& s : shapes) s.mass = mass_from_form(s.form, s.radius, s.half_height, s.half, s.vertices);
  for (std::uint32_t solver = 0; solver < kSolverChoices; ++solver)
    for (std::size_t k = 0; k < 3; ++k) {
      const Quat q = k == 2 ? lying : Quat(Quat::identity());
      const Ride plane = slide(solver, shapes[k], heights[k], q, Ground::plane);
      for (const Ground ground : {Ground::mesh, Ground::field}) {
        const Ride ride = slide(solver, shapes[k], heights[k], q, ground);
        // What `severity` still does after 5 s of rest is its own, on a plane as well, and never quite the same.
        assert_true(ride.bump <= (solver == kSeverityChoice ? 2 : 1) * plane.bump + 1e-6);
        assert_true(ride.slow <= 1e-6);
        assert_true(std::fabs(ride.last_y - plane.last_y) <= 1e-4);
      }
    }
}

/// With friction on a slope: down it goes as on a plane, whichever way sides run.
static void a_slope_of_triangles_is_a_slope(void**) {
  const Quat tilt = exp_map(Vec3(0, 0, -0.3));
  Vec3 end[3];
  for (const Ground ground : {Ground::plane, Ground::mesh, Ground::field}) {
    TestWorld t;
    const std::uint32_t rough = t.material(0.2, 0);
    lay(t, ground, rough, tilt);
    const std::uint32_t body =
        t.add(t.keep(box(Vec3(0.5, 0.25, 0.35))), tilt * Vec3(-2, 0.25, 0.1), BodyType::dynamic, tilt, rough);
    t.run(180, kStep);
    end[static_cast<int>(ground)] = t.world.state.x[body];
  }
  // a = g (sin - mu cos), first-order friction: all alike to 1e-4 of the way, and the way is as long as that says.
  const Real way = 0.5 * 9.81 * (std::sin(0.3) - 0.2 * std::cos(0.3)) * 9;
  assert_true(std::fabs((end[0] - tilt * Vec3(-2, 0.25, 0.1)).norm() - way) < 0.02 * way);
  assert_true((end[1] - end[0]).norm() < 1e-4 * way && (end[2] - end[0]).norm() < 1e-4 * way);
}

static void a_ball_rolls_through_a_valley_and_up_again(void**) {
  // A trough y = x^2 / 8 of fine strips: a ball let go rolls to and fro; what it loses is what a chain of strips 0.05 m
  // wide takes from it at each crease: nothing at a rolling contact of no restitution but the speed into the next
  // strip.
  TestWorld t;
  const std::uint32_t rough = t.material(1, 0);
  t.add(t.keep(mesh(grid(160, 4, 0.05, -4, -0.1, [](double x, double) { return x * x / 8; }))), Vec3::zero(),
        BodyType::fixed, Quat::identity(), rough);
  const std::uint32_t ball =
      t.add(t.keep(sphere(0.2)), Vec3(-2, 0.5 + 0.2, 0), BodyType::dynamic, Quat::identity(), rough);
  Real farthest = -2, sideways = 0;
  for (int i = 0; i < 240; ++i) {
    t.world.step(kStep);
    farthest = std::max(farthest, t.world.state.x[ball].x());
    sideways = std::max(sideways, std::fabs(t.world.state.x[ball].z()));
  }
  assert_true(farthest > 1.8);  // of 2
  assert_true(sideways < 1e-9);
}

static void a_wall_of_a_stack_stands_on_a_mesh_as_on_a_plane(void**) {
  for (const Ground ground : {Ground::plane, Ground::mesh, Ground::field}) {
    TestWorld t;
    lay(t, ground, t.material(0.5, 0));
    const Shape* cube = t.keep(box(Vec3::constant(0.25)));
    std::vector<std::uint32_t> bodies;
    for (int i = 0; i < 8; ++i) bodies.push_back(t.add(cube, Vec3(0.03, 0.25 + 0.5 * i, -0.02)));
    t.run(1200, kStep);
    for (int i = 0; i < 8; ++i)
      assert_true((t.world.state.x[bodies[static_cast<std::size_t>(i)]] - Vec3(0.03, 0.25 + 0.5 * i, -0.02)).norm() <
                  2e-3);
  }
}

/// A closed room, seen from within: its triangles face inward.
static void nothing_leaves_a_room_of_triangles(void**) {
  Triangles room = box_surface(Vec3(2, 2, 2));
  for (std::size_t i = 0; i < room.index.size(); i += 3) std::swap(room.index[i + 1], room.index[i + 2]);
  for (const std::uint32_t solver : {kSoftChoice, kAutoChoice}) {
    TestWorld t;
    t.world.set_dial(Dial::solver, solver);
    t.add(t.keep(mesh(room)), Vec3::zero(), BodyType::fixed);
    const Shape* shapes[] = {t.keep(box(Vec3(0.3, 0.2, 0.25))), t.keep(sphere(0.25)), t.keep(capsule(0.2, 0.15)),
                             t.keep(cylinder(0.2, 0.2)), t.keep(cone(0.25, 0.3))};
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> speed(-3, 3);
    std::vector<std::uint32_t> bodies;
    for (int i = 0; i < 60; ++i) {
      bodies.push_back(
          t.add(shapes[i % 5], Vec3(-1.4 + 0.7 * (i % 5), -1.4 + 0.9 * (i / 20), -1.2 + 0.8 * (i / 5 % 4))));
      t.world.set_velocity(bodies.back(), Vec3(speed(random), speed(random), speed(random)), Vec3::zero());
    }
    t.run(600, kStep);
    for (const std::uint32_t b : bodies) assert_true(t.world.state.x[b].abs().max_entry() < 2);
    assert_true(t.world.report.linear_energy < 5);
    assert_true(t.world.report.max_penetration < 0.01);
  }
}

static void bodies_pile_up_on_a_two_sided_sheet_and_hang_below_it_in_upward_gravity(void**) {
  for (const Real side : {1.0, -1.0}) {
    TestWorld t(Vec3(0, -9.81 * side, 0));
    t.add(t.keep(mesh(grid(10, 10, 0.4, -2, -2, level), true)), Vec3::zero(), BodyType::fixed);
    const std::uint32_t body = t.add(t.keep(box(Vec3::constant(0.3))), Vec3(0, 0.5 * side, 0));
    t.run(300, kStep);
    assert_true(std::fabs(t.world.state.x[body].y() - 0.3 * side) < 1e-3);
  }
}

/// A body over a ridge, an edge that is really there: held by it, with the ridge's own normal.
static void a_plate_lies_on_a_ridge(void**) {
  TestWorld t;
  const std::uint32_t rough = t.material(0.8, 0);
  t.add(t.keep(mesh(grid(8, 8, 0.5, -2, -2, [](double x, double) { return -std::fabs(x); }))), Vec3::zero(),
        BodyType::fixed, Quat::identity(), rough);
  const std::uint32_t plate =
      t.add(t.keep(box(Vec3(0.6, 0.05, 0.4))), Vec3(0, 0.05, 0), BodyType::dynamic, Quat::identity(), rough);
  t.run(60, kStep);
  assert_true(std::fabs(t.world.state.x[plate].y() - 0.05) < 1e-3);
  for (const ContactView& v : t.world.contact_views()) assert_true(std::fabs(std::fabs(v.normal.y()) - 1) < 1e-9);
  assert_true(t.world.contact_views().size() >= 2);
}

/// A kinematic mesh carries what stands on it.
static void a_lift_of_triangles_lifts(void**) {
  TestWorld t;
  const std::uint32_t lift = t.add(t.keep(mesh(grid(10, 10, 0.2, -1, -1, level))), Vec3::zero(), BodyType::kinematic);
  const std::uint32_t body = t.add(t.keep(box(Vec3::constant(0.25))), Vec3(0, 0.25, 0));
  t.run(60, kStep);
  t.world.set_velocity(lift, Vec3(0.2, 0.5, 0), Vec3::zero());
  t.run(120, kStep);
  const Vec3 up = t.world.state.x[body] - t.world.state.x[lift];
  assert_true((up - Vec3(0, 0.25, 0)).norm() < 0.01);
}

static void what_sleeps_on_a_mesh_wakes_where_it_lay(void**) {
  TestWorld t;
  t.world.set_dial(Dial::sleep, 1);
  lay(t, Ground::mesh, t.material(0.5, 0));
  std::vector<std::uint32_t> bodies;
  const Shape* cube = t.keep(box(Vec3::constant(0.25)));
  for (int i = 0; i < 3; ++i) bodies.push_back(t.add(cube, Vec3(0.1, 0.25 + 0.5 * i, 0)));
  t.run(300, kStep);
  assert_int_equal(t.world.report.asleep_bodies, 3);
  const Vec3 lay_at = t.world.state.x[bodies[2]];
  t.world.wake_body(bodies[0]);
  Real most = 0;
  for (int i = 0; i < 20; ++i) {
    t.world.step(kStep);
    most = std::max(most, t.world.state.v[bodies[2]].norm());
  }
  assert_true((t.world.state.x[bodies[2]] - lay_at).norm() < 1e-4);
  assert_true(most < 1e-2);
}

/// Balls and plates at 200 m/s against a sheet of triangles: none passes, from either side; at restitution 1 balls come
/// back as fast.
static void nothing_shoots_through_a_sheet(void**) {
  for (const bool two_sided : {false, true})
    for (int phase = 0; phase < 8; ++phase)
      for (const Real side : {1.0, -1.0}) {
        if (side < 0 && !two_sided) continue;
        TestWorld t(Vec3::zero());
        const std::uint32_t bouncy = t.material(0, 1);
        t.add(t.keep(mesh(grid(20, 20, 0.3, -3, -3, level), two_sided)), Vec3::zero(), BodyType::fixed,
              Quat::identity(), bouncy);
        const Real start = side * (5 + 0.4 * phase);
        const std::uint32_t ball =
            t.add(t.keep(sphere(0.1)), Vec3(0.11, start, 0.07), BodyType::dynamic, Quat::identity(), bouncy);
        const std::uint32_t plate = t.add(t.keep(box(Vec3(0.4, 0.02, 0.3))), Vec3(1.4, start, 1.1));
        t.world.set_velocity(ball, Vec3(0, -side * 200, 0), Vec3::zero());
        t.world.set_velocity(plate, Vec3(0, -side * 200, 0), Vec3(3, 0, 2));
        t.run(30, kStep);
        // 0.1 m above the sheet it turns: the way after it is what is left of 200 m/s times 0.5 s.
        const Real way = 100 - (std::fabs(start) - 0.1);
        assert_true(std::fabs(side * t.world.state.x[ball].y() - (0.1 + way)) < 1e-6 * way);
        assert_true(side * t.world.state.x[plate].y() > -0.01);
      }
}

static void a_world_without_scenery_makes_nothing_for_it(void**) {
  TestWorld t;
  t.ground();
  t.add(t.keep(box(Vec3::constant(0.25))), Vec3(0, 0.25, 0));
  t.run(10, kStep);
  assert_null(t.world.plan->scenery.get());
  assert_int_equal(t.world.plan->find("scenery")->participants.count, 0);
}

int main() {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(bodies_slide_over_ten_thousand_triangles_as_over_a_plane),
      cmocka_unit_test(a_slope_of_triangles_is_a_slope),
      cmocka_unit_test(a_ball_rolls_through_a_valley_and_up_again),
      cmocka_unit_test(a_wall_of_a_stack_stands_on_a_mesh_as_on_a_plane),
      cmocka_unit_test(nothing_leaves_a_room_of_triangles),
      cmocka_unit_test(bodies_pile_up_on_a_two_sided_sheet_and_hang_below_it_in_upward_gravity),
      cmocka_unit_test(a_plate_lies_on_a_ridge),
      cmocka_unit_test(a_lift_of_triangles_lifts),
      cmocka_unit_test(what_sleeps_on_a_mesh_wakes_where_it_lay),
      cmocka_unit_test(nothing_shoots_through_a_sheet),
      cmocka_unit_test(a_world_without_scenery_makes_nothing_for_it),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
