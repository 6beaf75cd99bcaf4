// Tall stacks under soft contacts alone: they sink as their springs say, and do not buckle.
#include <numbers>
#include <vector>

#include "carom_test.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kStep = 1.0 / 60, kGravity = 9.81;

/// Cubes of 1 m, each on the middle of the last; soft contacts.
std::vector<std::uint32_t> column(TestWorld& t, int n) {
  t.world.set_dial(Dial::solver, kSoftChoice);
  t.ground();
  const Shape* cube = t.keep(box(Vec3::constant(0.5)));
  std::vector<std::uint32_t> bodies;
  for (int i = 0; i < n; ++i) bodies.push_back(t.add(cube, Vec3(0, i + 0.5, 0)));
  return bodies;
}

/// m, how far from where it stood the farthest is, sideways
Real strayed(const TestWorld& t, const std::vector<std::uint32_t>& bodies, const std::vector<Vec3>& home) {
  Real most = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Vec3 d = t.world.state.x[bodies[i]] - home[i];
    most = std::max(most, std::hypot(d.x(), d.z()));
  }
  return most;
}

std::vector<Vec3> places(const TestWorld& t, const std::vector<std::uint32_t>& bodies) {
  std::vector<Vec3> places;
  for (const std::uint32_t b : bodies) places.push_back(t.world.state.x[b]);
  return places;
}

}  // namespace

// A point between two cubes of mass m, at a corner, has the effective mass m / 8, on what does not move m / 4 and twice the
// frequency: four of them sink 2 P / (m w^2) under a load P, and P / (4 m w^2).
static void a_column_of_forty_sinks_by_its_springs_and_stands_for_a_minute(void**) {
  constexpr int n = 40;
  TestWorld t;
  const std::vector<std::uint32_t> bodies = column(t, n);
  const std::vector<Vec3> home = places(t, bodies);
  t.run(3600, kStep);
  const Real w = 2 * std::numbers::pi * t.world.scene.dials[Dial::contact_frequency], unit = kGravity / (w * w);
  const Real sag = (2 * (n - 1) * n / Real(2) + n / Real(4)) * unit;
  assert_true(std::abs(home.back().y() - t.world.state.x[bodies.back()].y() - sag) < 0.01 * sag);
  // Sheared while it fell onto its springs (18 mm), it swings by as much again; a cube's half is where it would fall.
  assert_true(strayed(t, bodies, home) < 0.1);
}

static void without_held_arms_a_column_of_twenty_buckles(void**) {
  TestWorld t;
  const std::vector<std::uint32_t> bodies = column(t, 20);
  t.world.set_dial(Dial::hold_angle, 0);
  const std::vector<Vec3> home = places(t, bodies);
  t.run(1800, kStep);
  assert_true(strayed(t, bodies, home) > 0.5);
}

static void a_pyramid_comes_to_rest_and_stands_for_a_minute(void**) {
  TestWorld t;
  t.world.set_dial(Dial::solver, kSoftChoice);
  t.ground();
  const Shape* cube = t.keep(box(Vec3::constant(0.5)));
  std::vector<std::uint32_t> bodies;
  constexpr int base = 20;
  for (int row = 0; row < base; ++row)
    for (int i = 0; i < base - row; ++i) bodies.push_back(t.add(cube, Vec3(i + row / Real(2), row + 0.5, 0)));
  const std::vector<Vec3> home = places(t, bodies);
  const auto energy = [&] {
    Real sum = 0;
    for (const std::uint32_t b : bodies) sum += t.world.scene.mass[b] * t.world.state.v[b].squared_norm() / 2;
    return sum;
  };
  t.run(600, kStep);
  assert_true(energy() < 0.1);  // of 210 blocks of a tonne: none but creeps (0.02 mm/s)
  t.run(3000, kStep);
  assert_true(energy() < 0.1);
  assert_true(strayed(t, bodies, home) < 0.02);  // they spread as they sink 30 mm
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_column_of_forty_sinks_by_its_springs_and_stands_for_a_minute),
      cmocka_unit_test(without_held_arms_a_column_of_twenty_buckles),
      cmocka_unit_test(a_pyramid_comes_to_rest_and_stands_for_a_minute),
  };
  return cmocka_run_group_tests_name("stability/soft_stacks", tests, nullptr, nullptr);
}
