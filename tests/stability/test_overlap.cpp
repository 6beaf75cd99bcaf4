// Bodies that a host has put into one another part without being thrown about: a pyramid whose boxes overlap by half.
#include <vector>

#include "carom_test.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kStep = 1.0 / 60;

/// Boxes of 1 m, rows half a metre apart, each resting on two of the row below, in which they stand `pitch` apart.
std::vector<std::uint32_t> sunken_pyramid(TestWorld& t, int base, Real pitch) {
  const Shape* cube = t.keep(box(Vec3::constant(0.5)));
  std::vector<std::uint32_t> bodies;
  for (int row = 0; row < base; ++row)
    for (int i = 0; i < base - row; ++i)
      bodies.push_back(t.add(cube, Vec3((i + row / Real(2)) * pitch, 0.25 + row / Real(2), 0)));
  return bodies;
}

/// m/s, of bodies the fastest, less what they have by falling from where they were highest.
class Throws {
 public:
  Throws(const TestWorld& t, const std::vector<std::uint32_t>& bodies) : t_(t), bodies_(bodies) {
    for (const std::uint32_t b : bodies) highest_.push_back(t.world.state.x[b].y());
  }
  Real fastest() {
    const Real g = t_.world.scene.gravity.norm();
    Real most2 = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const Real y = t_.world.state.x[bodies_[i]].y();
      highest_[i] = std::max(highest_[i], y);
      most2 = std::max(most2, t_.world.state.v[bodies_[i]].squared_norm() - 2 * g * (highest_[i] - y));
    }
    return std::sqrt(most2);
  }

 private:
  const TestWorld& t_;
  const std::vector<std::uint32_t>& bodies_;
  std::vector<Real> highest_;  // m
};

}  // namespace

static void a_pyramid_that_overlaps_by_half_is_not_thrown_apart(void**) {
  // Each pair parts at push_speed: of four in a row the outermost moves at 1.5 times that from their middle, and the
  // top of four rows rises at three times. What was lifted so falls where it lost its support, faster in the end.
  for (const Real pitch : {0.95, 1.0, 1.05, 1.15})
    for (const Real solver : {kSoftChoice, kDirectChoice, kAutoChoice}) {
      TestWorld t;
      t.world.set_dial(Dial::solver, solver);
      t.ground();
      const std::vector<std::uint32_t> bodies = sunken_pyramid(t, 4, pitch);
      Throws throws(t, bodies);
      const Real most = t.world.scene.dials[Dial::push_speed] * std::sqrt(1.5 * 1.5 + 3 * 3);
      for (int i = 0; i < 150; ++i) {
        t.world.step(kStep);
        assert_true(throws.fastest() < most);
        if (i == 120) assert_true(t.world.report.max_penetration < 0.02);
      }
      for (const std::uint32_t b : bodies) assert_true(finite(t.world.state.x[b]) && t.world.state.x[b].y() > 0.49);
    }
}

static void what_is_wedged_is_not_shot_out(void**) {
  // Walls that lean by a milliradian hold a ball 5 mm too large. To part it by the half of a millimetre it would have
  // to go up by half a metre; it goes at most 30 times as far as it is to be parted, which is push_speed times the
  // substep.
  const Real lean = 1e-3, push_speed = 0.5;
  for (const Real solver : {kDirectChoice, kAutoChoice}) {
    TestWorld t;
    t.world.set_dial(Dial::solver, solver);
    t.world.scene.gravity = Vec3::zero();
    for (const Real side : {-1, 1}) {
      const Vec3 n = Vec3(side, lean, 0).normalized();
      t.add(t.keep(half_space(n, -0.495)), Vec3::zero(), BodyType::fixed);
    }
    const std::uint32_t ball = t.add(t.keep(sphere(0.5)), Vec3::zero());
    Real last = 0;
    for (int i = 0; i < 60; ++i) {
      t.world.step(kStep);
      const Vec3 x = t.world.state.x[ball];
      assert_true(finite(x) && (x - Vec3(0, last, 0)).norm() <= 30 * push_speed * kStep * 1.001);
      last = x.y();
    }
    assert_true(last > 0);
  }
}

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(a_pyramid_that_overlaps_by_half_is_not_thrown_apart),
                              cmocka_unit_test(what_is_wedged_is_not_shot_out)};
  return cmocka_run_group_tests_name("stability/overlap", tests, nullptr, nullptr);
}
