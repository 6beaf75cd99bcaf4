// What stands and is asked the same again is not solved again: to the bit as if it were, whatever changes and whenever.
#include <algorithm>
#include <functional>
#include <span>

#include "carom_test.h"
#include "dynamics/solver/direct.h"
#include "dynamics/stages.h"
#include "sliced.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kStep = 1.0 / 60;

struct Standing : TestWorld {
  std::uint32_t floor, stone;
  std::vector<std::uint32_t> bodies;

  Standing() : stone(material(0.6, 0.1)) { floor = ground(stone); }
  void put(const Shape* shape, const Vec3& at) {
    bodies.push_back(add(shape, at, BodyType::dynamic, Quat::identity(), stone));
  }
};

/// How many groups the last step found to be as they were.
std::size_t unchanged(const World& world) {
  return static_cast<std::size_t>(std::ranges::count_if(world.direct->rest, &GroupRest::is_unchanged));
}

void stack(Standing& t, int blocks, const Vec3& half, Real askew, Real along) {
  const Shape* const block = t.keep(box(half));
  for (int i = 0; i < blocks; ++i) t.put(block, Vec3(i % 2 ? askew : 0, half.y() * (2 * i + 1), along));
}

void pyramid(Standing& t, int base, Real half, Real along) {
  const Shape* const cube = t.keep(box(Vec3(half, half, half)));
  for (int row = 0; row < base; ++row)
    for (int i = 0; i < base - row; ++i) t.put(cube, half * Vec3(2 * i + row, 2 * row + 1, 0) + Vec3(0, 0, along));
}

/// Something that bears something else than boxes do: a plank on two balls held by their weight in a trough.
void trough(Standing& t, Real along) {
  const Shape* const side = t.keep(box(Vec3(0.1, 0.2, 0.4)));
  const Shape* const ball = t.keep(sphere(0.25));
  for (const Real x : {-0.36, 0.36}) t.put(side, Vec3(x, 0.2, along));
  t.put(ball, Vec3(0, 0.25, along));
}

/// A ball flies off on a cord that grows taut within a step, in a substep that lengths decide: then alone something else
/// is asked of what stands.
void tether(Standing& t, Real length) {
  const Shape* const ball = t.keep(sphere(0.05));
  const std::uint32_t flies = t.add(ball, Vec3(0, 6, 2), BodyType::dynamic);
  t.world.set_velocity(flies, Vec3(0, 1, 7), Vec3::zero());
  SpringDef cord;
  cord.body_a = t.bodies.back(), cord.body_b = flies;
  cord.rest = length, cord.stiffness = 20, cord.only_pulls = true;
  t.world.add_spring(cord);
}

using Change = std::function<void(Standing&)>;

/// The same scene twice: one forgets what it knows before each step. Every change comes in a step of its own.
/// @return steps in which the other knew something
std::size_t same_bits(const std::function<void(Standing&)>& build, const std::vector<Change>& changes, int between) {
  Standing knows, forgets;
  build(knows), build(forgets);
  std::size_t known = 0;
  int step = 0;
  const auto go = [&](int steps) {
    for (int i = 0; i < steps; ++i, ++step) {
      if (forgets.world.direct) forgets.world.direct->stood.clear();
      knows.world.step(kStep), forgets.world.step(kStep);
      known += unchanged(knows.world) > 0;
      assert_int_equal(unchanged(forgets.world), 0);
      const auto one = dynamics::prints_of(knows.world), other = dynamics::prints_of(forgets.world);
      if (one != other) print_message("step %d\n", step);
      assert_true(one == other);
      const StepReport &a = knows.world.report, &b = forgets.world.report;
      assert_true(a.solver_residual == b.solver_residual && a.velocity_impulses == b.velocity_impulses);
      assert_true(a.max_penetration == b.max_penetration && a.direct_groups == b.direct_groups);
    }
  };
  go(between);
  for (const Change& change : changes) {
    change(knows), change(forgets);
    go(between);
  }
  return known;
}

const std::vector<Change>& all_changes() {
  static const std::vector<Change> kChanges = {
      [](Standing& t) { t.world.add_force(t.bodies[0], Vec3(1e-12, 0, 0), Vec3::zero()); },
      [](Standing& t) { t.world.set_velocity(t.bodies.back(), Vec3(0, 0, 1e-9), Vec3::zero()); },
      [](Standing& t) { t.world.set_velocity(t.bodies.back(), Vec3(0.3, 0, 0), Vec3::zero()); },
      [](Standing& t) { t.world.set_gravity(Vec3(0, -9.82, 0)); },
      [](Standing& t) { t.world.set_dial(Dial::velocity_tolerance, 2e-3); },
      [](Standing& t) { t.world.set_dial(Dial::substeps, 3); },
      [](Standing& t) { t.put(t.keep(box(Vec3(0.1, 0.1, 0.1))), Vec3(0.05, 4, 0)); },
      [](Standing& t) { t.put(t.keep(sphere(0.2)), Vec3(5, 0.2, 5)); },
      [](Standing& t) { t.world.set_velocity(t.bodies.back(), Vec3(-4, 0, -4), Vec3::zero()); },
  };
  return kChanges;
}

}  // namespace

/// Towers, walls and a ball between sides: bits, reports and energies are those of solving anew.
static void bits_are_those_of_solving_anew(void**) {
  const std::vector<std::function<void(Standing&)>> scenes = {
      [](Standing& t) { stack(t, 1, Vec3(0.2, 0.2, 0.2), 0, 0); },
      [](Standing& t) { stack(t, 9, Vec3(0.3, 0.1, 0.2), 0.02, 0); },
      [](Standing& t) { pyramid(t, 5, 0.25, 0), stack(t, 4, Vec3(0.2, 0.4, 0.2), 0.01, 3); },
      [](Standing& t) { pyramid(t, 16, 0.5, 0); },
      [](Standing& t) { trough(t, 0), pyramid(t, 3, 0.02, 2); },
  };
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const std::size_t known = same_bits(scenes[i], all_changes(), sliced(90, 30, 8));
    print_message("scene %zu: %zu steps knew something\n", i, known);
    assert_true(known > 0);
  }
}

/// Within a step, too: before a cord grows taut substeps are known, then they are not.
static void what_changes_within_a_step_is_noticed(void**) {
  std::size_t first_known = 0;
  for (const Real length : {6.0, 6.03, 6.06, 6.09, 6.5, 6.53, 6.56, 6.59})
    for (const bool is_tall : {false, true}) {
      Standing knows, forgets;
      for (Standing* const t : {&knows, &forgets}) {
        if (is_tall) pyramid(*t, 8, 0.2, 0);
        stack(*t, 3, Vec3(0.3, 0.2, 0.3), 0.02, -2);
        t->run(30, kStep), tether(*t, length);
      }
      for (int i = 0; i < 90; ++i) {
        forgets.world.direct->stood.clear();
        knows.world.step(kStep), forgets.world.step(kStep);
        // It was begun as known, and solved in the end.
        for (const GroupRest& rest : knows.world.direct->rest) first_known += rest.caught_up;
        assert_true(dynamics::prints_of(knows.world) == dynamics::prints_of(forgets.world));
      }
    }
  print_message("%zu groups were caught up with\n", first_known);
  assert_true(first_known >= 4);
}

/// What stands stays where it is to the bit, at any size, and takes a fraction of the work.
static void what_stands_does_not_creep(void**) {
  for (const int base : {1, 4, 10, 15}) {
    Standing t;
    pyramid(t, base, 0.25, 0), stack(t, 6, Vec3(0.2, 0.1, 0.2), 0.03, 2);
    t.run(60, kStep);
    const auto places = t.world.state.x;
    t.run(sliced(6000, 600, 60), kStep);
    for (const std::uint32_t b : t.bodies) {
      assert_true(t.world.state.x[b] == places[b]);
      assert_true(t.world.state.v[b] == Vec3::zero() && t.world.state.omega[b] == Vec3::zero());
    }
    assert_int_equal(unchanged(t.world), 2);
  }
}

/// Not what only moves slowly: a puck on ice keeps its speed down to what a solution may be off by.
static void what_creeps_goes_on(void**) {
  for (const Real speed : {1e-3, 1e-5, 1e-7}) {
    TestWorld t;
    const std::uint32_t ice = t.material(0, 0);
    t.ground(ice);
    const std::uint32_t puck =
        t.add(t.keep(box(Vec3(0.2, 0.05, 0.2))), Vec3(0, 0.05, 0), BodyType::dynamic, Quat::identity(), ice);
    t.run(30, kStep);
    t.world.set_velocity(puck, Vec3(speed, 0, 0), Vec3::zero());
    const Real from = t.world.state.x[puck].x();
    t.run(120, kStep);
    const Real way = t.world.state.x[puck].x() - from;
    print_message("%g m/s: %g of its way\n", double(speed), double(way / (2 * speed)));
    assert_true(std::fabs(way - 2 * speed) < 0.01 * 2 * speed);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(bits_are_those_of_solving_anew),
      cmocka_unit_test(what_changes_within_a_step_is_noticed),
      cmocka_unit_test(what_stands_does_not_creep),
      cmocka_unit_test(what_creeps_goes_on),
  };
  return cmocka_run_group_tests_name("stability/unchanged", tests, nullptr, nullptr);
}
