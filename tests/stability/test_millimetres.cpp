// Things of millimetres lie on each other as those of metres do: no length of a solver is larger than a share of their
// thickness. Gravity is not scaled here, so that a substep is long for them: in 4 ms a thing falls by 0.17 mm.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "carom_test.h"
#include "scenery_builder.h"
#include "sliced.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

// Of the thickness: a hundredth is what is left where overlap is undone, and springs give as much again under some bodies.
constexpr Real kDeep = 0.02;

struct Case {
  Real solver, hz;
};
constexpr Case kCases[] = {
    {kSoftChoice, 60}, {kSoftChoice, 240}, {kDirectChoice, 60}, {kAutoChoice, 60}, {kAutoChoice, 240}};

/// What is made, and the size by which depth is judged.
struct Made {
  std::vector<std::uint32_t> bodies;
  Real thickness;  // m
};

Real height(const TestWorld& t, std::uint32_t body) { return t.world.state.x[body].y(); }

/// Bricks in a stack, each a little above the last and turned by a little.
Made bricks(TestWorld& t, Real s) {
  const Shape* const brick = t.keep(box(s * Vec3(1, 0.4, 0.7)));
  Made made{{}, 0.8 * s};
  for (int i = 0; i < 5; ++i)
    made.bodies.push_back(
        t.add(brick, s * Vec3(0.1 * (i % 2), 0.45 + 0.9 * i, 0), BodyType::dynamic, exp_map(Vec3(0, 0.07 * i, 0))));
  return made;
}

/// A pile of rods side by side, in two layers across each other.
Made rods(TestWorld& t, Real s) {
  const Shape* const rod = t.keep(cylinder(0.25 * s, 2 * s));
  Made made{{}, 0.5 * s};
  for (int i = 0; i < 8; ++i) {
    const Real aside = (i % 4 - 1.5) * 0.9 * s;
    const Vec3 axis = i < 4 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
    const Quat lies = i < 4 ? exp_map(Vec3(std::numbers::pi / 2, 0, 0)) : exp_map(Vec3(0, 0, std::numbers::pi / 2));
    made.bodies.push_back(t.add(rod, (i < 4 ? Vec3(aside, 0.27 * s, 0) : Vec3(0, 0.8 * s, aside)) + 0.01 * s * axis,
                                BodyType::dynamic, lies));
  }
  return made;
}

/// Tiles on a tall block of a metre, one on another.
Made on_a_block(TestWorld& t, Real s) {
  const Shape* const block = t.keep(box(Vec3(0.5, 0.3, 0.5)));
  const Shape* const tile = t.keep(box(s * Vec3(1.5, 0.5, 1.5)));
  t.add(block, Vec3(0, 0.3, 0), BodyType::fixed);
  Made made{{}, s};
  for (int i = 0; i < 4; ++i) made.bodies.push_back(t.add(tile, Vec3(0.05 * s * i, 0.6 + s * (0.55 + 1.1 * i), 0)));
  return made;
}

/// The deepest of the last tenth of some seconds, of the thickness.
Real settles(TestWorld& t, const Made& made, const Case& of, Real seconds) {
  Real deep = 0;
  const int steps = static_cast<int>(seconds * of.hz);
  for (int i = 0; i < steps; ++i) {
    t.world.step(1 / of.hz);
    if (10 * i >= 9 * steps) deep = std::max<Real>(deep, t.world.report.max_penetration);
  }
  return deep / made.thickness;
}

template <class Make>
void lie(const Make& make, const char* what) {
  for (const Case& of : kCases)
    for (const Real size : {0.0007, 0.003, 0.014}) {
      static OneOf turn(1, 5);
      if (!turn.next()) continue;
      TestWorld t;
      t.world.set_dial(Dial::solver, of.solver);
      t.ground();
      const Made made = make(t, size);
      const std::vector<Real> y = [&] {
        std::vector<Real> all;
        for (const std::uint32_t b : made.bodies) all.push_back(height(t, b));
        return all;
      }();
      const Real deep = settles(t, made, of, 2);
      print_message("%s of %g mm, solver %g at %g Hz: %g of the thickness deep\n", what, 1e3 * size, double(of.solver),
                    double(of.hz), double(deep));
      assert_true(deep < kDeep);
      for (std::size_t i = 0; i < y.size(); ++i)
        assert_true(std::fabs(height(t, made.bodies[i]) - y[i]) < made.thickness);
    }
}

}  // namespace

static void bricks_lie_on_each_other(void**) { lie(bricks, "bricks"); }
static void rods_lie_across_each_other(void**) { lie(rods, "rods"); }
static void tiles_lie_on_a_large_block(void**) { lie(on_a_block, "tiles"); }

/// Dice that are poured onto a mesh tumble by half a turn within a step, and land: none passes it.
static void dice_stay_above_a_mesh(void**) {
  for (const Real size : {0.0004, 0.0006, 0.0011})
    for (int pour = 0; pour < sliced(24, 8, 2); ++pour) {
      TestWorld t;
      t.add(t.keep(mesh(grid(2, 2, 0.5, -0.5, -0.5, [](double, double) { return 0.0; }))), Vec3::zero(),
            BodyType::fixed);
      const Shape* const die = t.keep(box(size / 2 * Vec3(1, 0.9, 1.1)));
      Random random(static_cast<std::uint64_t>(pour + 1));
      std::vector<std::uint32_t> dice;
      for (int k = 0; k < 18; ++k) {
        // One after the other: compilers evaluate arguments in orders of their own.
        const Real turn = random.uniform(0.05, 0.3), z = random.uniform(-0.1, 0.1), x = random.uniform(-0.1, 0.1);
        dice.push_back(t.add(die, size * Vec3(1.4 * (k % 3) + x, 1.2 + 1.5 * (k / 6), 1.4 * (k / 3 % 2) + z),
                             BodyType::dynamic, exp_map(turn * Vec3(0.3, 0.2, 0.9))));
      }
      t.run(90, 1.0 / 60);
      for (const std::uint32_t b : dice) {
        if (!(height(t, b) > 0.4 * size)) print_error("%g mm, pour %d: %g\n", 1e3 * size, pour, height(t, b) / size);
        assert_true(height(t, b) > 0.4 * size);
      }
    }
}

/// Heaps of a quarter of a millimetre: a substep's fall is their size. What a step leaves where it was has no speed to
/// go anywhere with.
static void what_stands_still_says_so(void**) {
  for (const Real size : {0.0002, 0.00025, 0.0003})
    for (int heap = 0; heap < sliced(12, 6, 1); ++heap) {
      TestWorld t;
      t.ground();
      Random random(static_cast<std::uint64_t>(heap + 40));
      const Vec3 half = size / 2 * Vec3(1, random.uniform(0.7, 1), random.uniform(0.8, 1.2));
      const Shape* const die = t.keep(heap % 3 == 2 ? cylinder(size / 2, size) : box(half));
      const Real gap = random.uniform(1.1, 1.5), lean = random.uniform(0, 0.2);
      std::vector<std::uint32_t> dice;
      for (int k = 0; k < 16; ++k)
        dice.push_back(t.add(die, size * Vec3(gap * (k % 4), 1 + gap * (k / 4), 0.1 * (k % 3)), BodyType::dynamic,
                             exp_map(2 * Vec3(lean * (k % 2), 0.05, 0))));
      t.run(120, 1.0 / 60);
      std::vector<Vec3> before;
      for (const std::uint32_t b : dice) before.push_back(t.world.state.x[b]);
      t.run(1, 1.0 / 60);
      for (std::size_t k = 0; k < dice.size(); ++k) {
        const Real way = (t.world.state.x[dice[k]] - before[k]).norm();
        const Real led = t.world.state.v[dice[k]].norm() / 60;
        if (!(led < size || way > 0.1 * led)) print_error("%g mm, heap %d: %g and %g\n", 1e3 * size, heap, way, led);
        assert_true(led < size || way > 0.1 * led);
      }
    }
}

/// Bricks at three scales, with gravity as much scaled, move alike: in units of their size all depths are the same to 1 %
/// of the thickness, however large or small that is.
static void depth_scales(void**) {
  for (const Real solver : {kSoftChoice, kDirectChoice, kAutoChoice}) {
    std::vector<Real> deep;
    for (const Real scale : {1.0, 1e-3, 100.0}) {
      TestWorld t(Vec3(0, -9.81 * scale, 0));
      t.world.set_dial(Dial::solver, solver);
      t.ground();
      const Made made = bricks(t, scale);
      deep.push_back(settles(t, made, {solver, 60}, 2));
      for (std::size_t i = 0; i < made.bodies.size(); ++i)
        assert_true(std::fabs(height(t, made.bodies[i]) / scale - (0.4 + 0.8 * i)) < kDeep * 0.8 * (i + 1));
    }
    for (const Real d : deep) {
      if (!(std::fabs(d - deep[0]) < 0.01)) print_message("solver %g: %g and %g deep\n", solver, deep[0], d);
      assert_true(std::fabs(d - deep[0]) < 0.01);
    }
  }
}

/// What is thin is swept more often, and its springs are stiffer; cubes of a metre elsewhere in the world, which are solved
/// beside it, keep every bit. A brick that hangs a hair lower changes nothing either.
static void what_is_thick_has_the_same_bits_beside_it(void**) {
  const auto cubes = [](bool beside, Real hair) {
    TestWorld t;
    t.world.set_dial(Dial::solver, kSoftChoice);
    t.ground();
    const Shape* const cube = t.keep(box(Vec3::constant(0.5)));
    std::vector<std::uint32_t> bodies;
    for (int i = 0; i < 6; ++i)
      bodies.push_back(
          t.add(cube, Vec3(3 * (i / 3), 0.6 + 1.05 * (i % 3), 0), BodyType::dynamic, exp_map(Vec3(0, 0.1 * i, 0))));
    if (beside) {
      const Shape* const die = t.keep(box(Vec3::constant(5e-4)));
      for (int i = 0; i < 9; ++i)
        t.add(die, Vec3(50 + 0.1 * (i / 3), 6e-4 + 1.05e-3 * (i % 3) + hair, 0), BodyType::dynamic,
              exp_map(Vec3(0, 0.1 * i, 0)));
    }
    std::vector<Real> places;
    for (int i = 0; i < 90; ++i) {
      t.world.step(1 / 60.0);
      for (const std::uint32_t b : bodies)
        for (int k = 0; k < 3; ++k) places.push_back(t.world.state.x[b][k]);
    }
    return places;
  };
  const std::vector<Real> alone = cubes(false, 0);
  assert_true(alone == cubes(true, 0));
  assert_true(alone == cubes(true, 1e-15));
}

/// Blocks of a hundred metres at 30 m/s, 0.5 m a step: the least that a dial leaves deep is nothing to them.
static void blocks_of_a_hundred_metres_land(void**) {
  for (const Real solver : {kSoftChoice, kDirectChoice, kAutoChoice}) {
    TestWorld t;
    t.world.set_dial(Dial::solver, solver);
    t.ground();
    const Shape* const block = t.keep(box(Vec3(50, 30, 50)));
    Made made{{}, 60};
    for (int i = 0; i < 3; ++i) {
      made.bodies.push_back(t.add(block, Vec3(5 * i, 75 + 61 * i, 0)));
      t.world.set_velocity(made.bodies.back(), Vec3(0, -30, 0), Vec3::zero());
    }
    assert_true(settles(t, made, {solver, 60}, 6) < 1e-3);
    for (std::size_t i = 0; i < made.bodies.size(); ++i)
      assert_true(std::fabs(height(t, made.bodies[i]) - (30 + 60 * i)) < 0.1 * (i + 1));
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(bricks_lie_on_each_other),
      cmocka_unit_test(rods_lie_across_each_other),
      cmocka_unit_test(tiles_lie_on_a_large_block),
      cmocka_unit_test(dice_stay_above_a_mesh),
      cmocka_unit_test(what_stands_still_says_so),
      cmocka_unit_test(depth_scales),
      cmocka_unit_test(what_is_thick_has_the_same_bits_beside_it),
      cmocka_unit_test(blocks_of_a_hundred_metres_land),
  };
  return cmocka_run_group_tests_name("stability/millimetres", tests, nullptr, nullptr);
}
