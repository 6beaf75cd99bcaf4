// What rolls: cylinders, spheroids and coins against closed forms, on planes and on boxes, by every solver that may be
// chosen for them. @see src/dynamics/contact/rolling.h
#include <algorithm>
#include <cmath>
#include <numbers>

#include "carom_test.h"
#include "dynamics/contact/rolling.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kG = 9.81;

/// What rolls about its y axis, which lies along z: radius there, and the moment about the axis over m r^2.
struct Roller {
  Shape shape;
  Real radius, moment;
};

Roller cylinder_of(Real r, Real half) { return {cylinder(r, half), r, 0.5}; }
Roller spheroid_of(Real r, Real half) { return {ellipsoid(Vec3(r, half, r)), r, 0.4}; }

/// Share of its way by which it is off at worst, in two seconds down a slope from rest: g sin(a) t^2 / 2 / (1 +
/// moment).
Real off_its_way(const Roller& of, Real slope, Real hz, int solver, bool on_box) {
  TestWorld t(Vec3(kG * std::sin(slope), -kG * std::cos(slope), 0));
  t.world.set_dial(Dial::solver, solver);
  const std::uint32_t rough = t.material(1, 0);
  if (on_box)
    t.add(t.keep(box(Vec3(60, 1, 5))), Vec3(50, -1, 0), BodyType::fixed, Quat::identity(), rough);
  else
    t.ground(rough);
  const Quat along_z = exp_map(Vec3(std::numbers::pi / 2, 0, 0));
  const std::uint32_t body = t.add(t.keep(of.shape), Vec3(0, of.radius, 0), BodyType::dynamic, along_z, rough);
  const int steps = static_cast<int>(2 * hz);
  Real worst = 0, way = 0;
  for (int i = 1; i <= steps; ++i) {
    t.world.step(1 / hz);
    way = kG * std::sin(slope) * (i / hz) * (i / hz) / 2 / (1 + of.moment);
    worst = std::max(worst, std::fabs(t.world.state.x[body].x() - way));
  }
  assert_true(std::fabs(t.world.state.x[body].z()) < 1e-4 * way);  // straight on
  return worst / way;
}

}  // namespace

/// The point under the axis stays there whatever the body turns by: what is left is what solvers leave. Soft contacts
/// let bodies sink as they begin, which auto does not ask of so few.
static void cylinders_go_down_slopes_as_they_must(void**) {
  for (const Real slope : {0.2, 0.35})
    for (const bool on_box : {false, true}) {
      const Real at = off_its_way(cylinder_of(0.3, 0.5), slope, 60, kAutoChoice, on_box);
      print_message("slope %g: %.1e by auto\n", double(slope), double(at));
      assert_true(at < 1e-5);
      assert_true(off_its_way(cylinder_of(0.3, 0.5), slope, 60, kDirectChoice, on_box) < 1e-6);
    }
}

// Other sizes, slopes, steps and shapes than it was made on.
static void so_do_others(void**) {
  for (const int solver : {kAutoChoice, kDirectChoice})
    for (const Roller& of : {cylinder_of(0.05, 0.2), cylinder_of(1.1, 0.07), cylinder_of(0.02, 0.02),
                             spheroid_of(0.2, 0.5), spheroid_of(0.1, 0.13)})
      for (const auto& [slope, hz] : {std::pair<Real, Real>(0.12, 50), {0.5, 90}}) {
        const Real plane = off_its_way(of, slope, hz, solver, false), on_box = off_its_way(of, slope, hz, solver, true);
        print_message("radius %g, slope %g, solver %d: %.1e, %.1e on a box\n", double(of.radius), double(slope), solver,
                      double(plane), double(on_box));
        assert_true(plane < 1e-4 && on_box < 1e-4);
      }
}

/// The ball that a point goes round on: of what leans, the normal's way from the axis; of what stands or tips, none.
static void a_point_goes_round_where_its_axis_stays(void**) {
  const Shape wheel = cylinder(0.3, 0.05);
  for (const Real lean : {0.1, 0.7, 1.2}) {  // rad, of the normal from the axis
    const Vec3 n(std::sin(lean), std::cos(lean), 0), rim(0.3, 0.05, 0), e(0, 1, 0), level = e.cross(n);
    const Real radius = rolling_radius(wheel, rim, n, Vec3(0, 0.1, 0));
    assert_true(std::fabs(radius - 0.3 / std::sin(lean)) < 1e-15);
    const Vec3 middle = rim - radius * n;  // on the axis
    assert_true(std::fabs(middle.x()) < 1e-15 && middle.z() == 0);
    assert_true(rolling_radius(wheel, rim, n, level) == 0);  // it tips
    assert_true(rolling_radius(wheel, rim, n, Vec3(0, 0.1, 0) + 0.01 * level) > 0);
    assert_true(rolling_radius(wheel, rim, -1 * n, Vec3(0, 0.1, 0)) == 0);  // no normal of that point
    assert_true(rolling_radius(wheel, Vec3(0, 0.05, 0.3), n, Vec3(0, 0.1, 0)) == 0);
  }
  assert_true(rolling_radius(wheel, Vec3(0.3, 0.05, 0), Vec3(0, 1, 0), Vec3(0, 0.1, 0)) == 0);  // it stands on its end
  assert_true(rolling_radius(box(Vec3(1, 1, 1)), Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(0, 0.1, 0)) == 0);
  assert_true(rolling_radius(ellipsoid(Vec3(1, 2, 3)), Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(0, 0.1, 0)) == 0);
}

namespace {

/// Euler's disk without resistance: it goes round on its rim and leans by `lean`, its middle all but at rest.
/// @return where its axis points after half a second
Vec3 axis_of_coin(Real lean, Real radius, Real hz, int solver) {
  TestWorld t(Vec3(0, -kG, 0));
  t.world.set_dial(Dial::solver, solver);
  const std::uint32_t rough = t.material(1, 0);
  t.ground(rough);
  const Real half = 1e-3 * radius, s = std::sin(lean), c = std::cos(lean);
  const std::uint32_t coin = t.add(t.keep(cylinder(radius, half)), Vec3(0, radius * s + half * c, 0), BodyType::dynamic,
                                   exp_map(Vec3(0, 0, -lean)), rough);
  // omega is along the line through its middle and where it touches, which goes round at sqrt(4 g / r sin(lean)).
  const Real round = std::sqrt(4 * kG / (radius * s));
  t.world.set_velocity(coin, Vec3::zero(), round * s * Vec3(-c, s, 0));
  for (int i = 0; i < hz / 2; ++i) t.world.step(1 / hz);
  return t.world.state.q[coin] * Vec3::unit_y();
}

}  // namespace

/// Beside steps of a sixteenth. A point that stayed on the body would lie 0.13 m from where the coin touches after one
/// step of 1/60 s: the coin lost half of its energy within a twentieth of the time that it has. It rolls by its
/// equation of motion (lone_rollers.h), in steps of 0.1 rad of the point's way: (0.1)^4 / 120 of that is what is left.
static void a_coin_goes_round(void**) {
  for (const auto& [lean, radius] : {std::pair<Real, Real>(0.4, 0.5), {0.6, 0.2}, {0.5, 1}}) {
    const Vec3 end = axis_of_coin(lean, radius, 1920, kAutoChoice);
    const Real coarse = (axis_of_coin(lean, radius, 120, kAutoChoice) - end).norm(),
               fine = (axis_of_coin(lean, radius, 240, kAutoChoice) - end).norm();
    print_message("lean %g, radius %g: %.1e, with half the step %.1e\n", double(lean), double(radius), double(coarse),
                  double(fine));
    assert_true(coarse < 1e-5 && fine < 1e-5);  // 7 rad of the way, at most
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(cylinders_go_down_slopes_as_they_must),
      cmocka_unit_test(so_do_others),
      cmocka_unit_test(a_point_goes_round_where_its_axis_stays),
      cmocka_unit_test(a_coin_goes_round),
  };
  return cmocka_run_group_tests_name("oracle/rolling", tests, nullptr, nullptr);
}
