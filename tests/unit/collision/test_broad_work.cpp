// What a broad phase may cost: exchanges in proportion to the motion, no memory in the steady state, no blow-up on a
// teleport.
#include <algorithm>
#include <bit>
#include <new>

#include "carom_test.h"
#include "unit/collision/broad_scene.h"

using namespace carom;
using namespace carom::test;

namespace {

/// Memory that counts, and that can fail on demand.
class Meter final : public std::pmr::memory_resource {
 public:
  std::size_t allocations = 0;
  std::size_t fail_at = SIZE_MAX;

 private:
  void* do_allocate(std::size_t size, std::size_t alignment) override {
    if (allocations++ >= fail_at) throw std::bad_alloc();
    return std::pmr::new_delete_resource()->allocate(size, alignment);
  }
  void do_deallocate(void* p, std::size_t size, std::size_t alignment) override {
    std::pmr::new_delete_resource()->deallocate(p, size, alignment);
  }
  bool do_is_equal(const std::pmr::memory_resource& o) const noexcept override { return this == &o; }
};

using Maker = Owned<BroadPhase> (*)(Memory*);
constexpr Maker kMakers[] = {make_brute_force, make_sweep_and_prune, make_uniform_grid, make_tree};

/// n boxes on a cubic lattice of pitch 1, each jittered, so that lengths and neighbours are known.
void lattice(BroadScene& s, Numbers& random, std::uint32_t side) {
  for (std::uint32_t i = 0; i < side * side * side; ++i) {
    const Vec3 at(i % side, i / side % side, i / side / side);
    s.put(i, box_at(at + random.in_cube(0.2), Vec3::constant(0.4)));
  }
}

std::uint64_t swaps_of_a_coherent_step(std::uint32_t side) {
  Numbers random(side);
  BroadScene s;
  lattice(s, random, side);
  auto sap = make_sweep_and_prune(std::pmr::get_default_resource());
  Array<Pair> pairs;
  sap->find_pairs(s.table, s.generation, s.settings, pairs);
  assert_int_equal(sap->work().rebuilds, 1);
  const std::uint32_t n = side * side * side;
  // Ends of one lattice plane lie 0.4 m wide, side^2 of each kind: a motion of at most 0.1 / side^2 m either way brings
  // an end past those within 0.2 / side^2 m of it at most: 0.2 / 0.4 = half of one neighbour of its own kind on
  // average, and as many of the other kind where the planes of lower and upper ends lie over each other.
  std::uint64_t swaps = 0;
  for (int step = 0; step < 10; ++step) {
    for (std::uint32_t i = 0; i < n; ++i) s.shift(i, random.in_cube(0.1 / (side * side)));
    sap->find_pairs(s.table, s.generation, s.settings, pairs);
    assert_int_equal(sap->work().rebuilds, 0);
    swaps = std::max(swaps, sap->work().swaps);
  }
  return swaps;
}

void a_coherent_step_costs_exchanges_in_proportion_to_the_boxes(void**) {
  for (const std::uint32_t side : {4u, 8u, 16u}) {
    const std::uint64_t n = side * side * side, swaps = swaps_of_a_coherent_step(side);
    assert_true(swaps > 0);
    assert_true(swaps <= 3 * 2 * n);  // one per end and axis: the bound derived above, while n grows 64-fold
  }
}

void a_scene_at_rest_costs_no_exchange_and_a_step_of_one_box_few(void**) {
  Numbers random(1);
  BroadScene s;
  lattice(s, random, 8);
  auto sap = make_sweep_and_prune(std::pmr::get_default_resource());
  Array<Pair> pairs;
  for (int step = 0; step < 3; ++step) sap->find_pairs(s.table, s.generation, s.settings, pairs);
  assert_int_equal(sap->work().swaps + sap->work().rebuilds + sap->work().tests, 0);
  s.put(600, box_at(Vec3(3, 3, 3), Vec3::constant(0.4)));  // a newcomer passes each of the others' ends at most once
  sap->find_pairs(s.table, s.generation, s.settings, pairs);
  assert_int_equal(sap->work().rebuilds, 0);
  assert_true(sap->work().swaps <= 3 * 2 * 2 * 512);
  s.drop(17);
  sap->find_pairs(s.table, s.generation, s.settings, pairs);
  assert_int_equal(sap->work().rebuilds + sap->work().swaps, 0);
}

void a_teleport_of_everything_is_sorted_afresh_within_a_budget(void**) {
  Numbers random(2);
  BroadScene s;
  lattice(s, random, 12);
  const std::uint64_t n = 12 * 12 * 12;
  auto sap = make_sweep_and_prune(std::pmr::get_default_resource());
  Array<Pair> pairs;
  for (int step = 0; step < 3; ++step) {
    for (std::uint32_t i = 0; i < n; ++i) s.table.bounds[i] = box_at(random.in_cube(6), Vec3::constant(0.4));
    sap->find_pairs(s.table, s.generation, s.settings, pairs);
    assert_int_equal(sap->work().rebuilds, 1);
    // 6 n ends, log2 n exchanges for each, and the one insertion that overran it; quadratic would be 6 n^2 = 18
    // million.
    assert_true(sap->work().swaps <= 6 * n * (std::bit_width(n) + 1) + 2 * n);
  }
  // The step after, they have only drifted: the new order is kept again.
  for (std::uint32_t i = 0; i < n; ++i) s.shift(i, random.in_cube(1e-3));
  sap->find_pairs(s.table, s.generation, s.settings, pairs);
  assert_int_equal(sap->work().rebuilds, 0);
}

void the_grid_looks_at_neighbours_only(void**) {
  Numbers random(3);
  BroadScene s;
  lattice(s, random, 16);
  const std::uint64_t n = 16 * 16 * 16;
  auto grid = make_uniform_grid(std::pmr::get_default_resource());
  Array<Pair> pairs;
  grid->find_pairs(s.table, s.generation, s.settings, pairs);
  // Cells are 1.6 m, boxes 0.8: (1 + 1/2)^3 cells a box on average, each shared with the boxes that start within 2.4 m
  // of its lower corner, 2.4^3 on average.
  assert_true(grid->work().entries < 1.5 * 1.5 * 1.5 * 1.05 * static_cast<Real>(n));
  assert_true(grid->work().tests < 0.5 * 1.6 * 1.6 * 1.6 * 3.375 * 3.375 * 1.1 * static_cast<Real>(n));
  assert_int_equal(grid->work().large, 0);
  Aabb floor;
  floor.lo = Vec3::constant(-kInfinity), floor.hi = Vec3(kInfinity, 0, kInfinity);
  s.put(5000, floor, false);
  s.put(5001, box_at(Vec3::zero(), Vec3(1000, 1, 1000)), false);  // does not change the cells' size
  const std::uint64_t entries = grid->work().entries;
  grid->find_pairs(s.table, s.generation, s.settings, pairs);
  assert_int_equal(grid->work().large, 2);
  assert_int_equal(grid->work().entries, entries);
}

/// Boxes tested by a tree in one call, candidates filtered among them.
std::uint64_t tests_of(BroadPhase& tree, const BroadScene& s, Array<Pair>& pairs) {
  tree.find_pairs(s.table, s.generation, s.settings, pairs);
  return tree.work().tests;
}

void a_tree_asks_for_nobody_who_stays_about_where_it_was(void**) {
  Numbers random(6);
  BroadScene s;
  lattice(s, random, 8);
  const BroadScene home = s;
  auto tree = make_tree(std::pmr::get_default_resource());
  Array<Pair> pairs;
  assert_true(tests_of(*tree, s, pairs) > 0);
  assert_int_equal(tree->work().asked, 512);
  assert_int_equal(tree->work().rebuilds, 1);
  std::uint64_t asked = 0;
  for (int step = 0; step < 400; ++step) {
    // 3 mm to and fro: within a hundredth of 0.8 m, the thinnest that a fat box ever gets.
    for (std::uint32_t i = 0; i < 512; ++i) {
      s.table.bounds[i] = home.table.bounds[i];
      s.shift(i, random.in_cube(0.003));
    }
    tree->find_pairs(s.table, s.generation, s.settings, pairs);
    asked += tree->work().asked;
    assert_int_equal(tree->work().rebuilds, 0);
  }
  // Each shrinks from a first share of 0.06 to 0.01 of its extent in two steps, for neither of which it is asked for.
  assert_int_equal(asked, 0);
  assert_true(tree->work().tests <= pairs.size() * 3 / 2);  // hardly a candidate that is no pair
  s.shift(17, Vec3(3, 0, 0));  // one that leaves is looked for alone, down 16 ways of 4 boxes on each of log4 n levels
  assert_true(tests_of(*tree, s, pairs) < pairs.size() * 3 / 2 + 16 * 4 * 5);
  assert_int_equal(tree->work().asked, 1);
}

/// Steady flight of 8 % of a box a step reaches ahead: it is asked for less than once in 4 steps.
void a_tree_reaches_ahead_of_what_flies(void**) {
  Numbers random(7);
  BroadScene s;
  lattice(s, random, 6);
  auto tree = make_tree(std::pmr::get_default_resource());
  Array<Pair> pairs;
  std::uint64_t asked = 0;
  for (int step = 0; step < 200; ++step) {
    for (std::uint32_t i = 0; i < 216; ++i) s.shift(i, Vec3(0, -0.064, 0));
    tree->find_pairs(s.table, s.generation, s.settings, pairs);
    asked += tree->work().asked;
  }
  assert_true(asked < 200 * 216 / 4);
}

/// Boxes that mix: neighbours part, but what they once shared does not make looking for others dearer for long.
void a_tree_that_wears_is_built_afresh(void**) {
  Numbers random(9);
  BroadScene s;
  lattice(s, random, 8);
  std::vector<Vec3> velocity(512);
  for (Vec3& v : velocity) v = random.in_cube(0.1);
  auto tree = make_tree(std::pmr::get_default_resource());
  Array<Pair> pairs;
  std::uint64_t tests = 0, asked = 0, found = 0, rebuilds = 0;
  for (int step = 0; step < 2000; ++step) {
    for (std::uint32_t i = 0; i < 512; ++i) {
      s.shift(i, velocity[i]);
      for (int k = 0; k < 3; ++k) {
        const Real off = s.table.bounds[i].lo[k] - 3.1;
        if (std::fabs(off) > 4) velocity[i][k] = -std::copysign(velocity[i][k], off);
      }
    }
    tree->find_pairs(s.table, s.generation, s.settings, pairs);
    if (step < 1000) continue;
    tests += tree->work().tests, asked += tree->work().asked, found += pairs.size(), rebuilds += tree->work().rebuilds;
    assert_true(tree->work().asked < 512 / 2);
  }
  print_message("%.0f boxes tested a query, %.0f a step; %.0f asked, %.0f pairs a step; built %.0f times\n",
                static_cast<double>(tests) / static_cast<double>(asked), tests / 1000.0, asked / 1000.0, found / 1000.0,
                static_cast<double>(rebuilds));
  // A fat box is up to 1.7 m long, the span of 4, 16 and 64 neighbours up to 2.5 x 2.5 x 1.7, 4 x 4 x 2 and 5.5^3 m, so
  // it meets (1.7 + 2.5)^2 (1.7 + 1.7) / 4 = 15, 8 and 8 such nodes and 3 above, of four boxes each; as much again for
  // wear; and candidates are less than 4 a pair. A tree that is only ever moved about compares 554 boxes a query.
  assert_true(tests < asked * 2 * 34 * 4 + found * 4);
  assert_true(rebuilds > 1);
}

/// What would make a careless tree a list: boxes that come one by one in order, ever larger, or all in one place.
void a_tree_stays_shallow_whatever_comes_in_whatever_order(void**) {
  for (int way = 0; way < 3; ++way) {
    BroadScene s;
    auto tree = make_tree(std::pmr::get_default_resource());
    Array<Pair> pairs;
    std::uint64_t tests = 0, found = 0;
    const std::uint32_t n = way == 2 ? 300 : 2000;
    for (std::uint32_t i = 0; i < n; ++i) {
      const Real x = way == 1 ? 10 * std::pow(1.3, i) : i;
      const Aabb here = box_at(Vec3(1, 2, 3), Vec3::constant(i % 2 ? 0 : 1e-3));
      s.put(i, way == 2 ? here : box_at(Vec3(x, 0, 0), Vec3::constant(0.3)));
      tests += tests_of(*tree, s, pairs);
      found += pairs.size();
    }
    // In one place, all are pairs of all: a newcomer looks at each of the fewer than 2 i boxes of the tree, and each
    // pair is filtered in every call. Elsewhere nobody has a pair: each is asked for when it comes, down at most two
    // nodes of four on each of log2 n levels, as nodes are at least half full. A list would take n^2 / 2.
    print_message("way %d: %.0f boxes tested a newcomer\n", way, static_cast<double>(tests) / n);
    assert_true(tests <= (way == 2 ? 3 * n * n + found : n * 2 * 4 * 11));
    assert_int_equal(pairs.size(), way == 2 ? n * (n - 1) / 2 : 0);
  }
}

void something_huge_among_crumbs_costs_a_tree_its_own_partners_only(void**) {
  Numbers random(8);
  BroadScene s;
  const std::uint32_t n = 4000;
  for (std::uint32_t i = 0; i < n; ++i) s.put(i, box_at(Vec3(i % 64, 0, i / 64), Vec3::constant(0.1)));
  s.put(n, box_at(Vec3(32, -501, 32), Vec3(1000, 500, 1000)));  // a metre below them
  Aabb floor;
  floor.lo = Vec3::constant(-kInfinity), floor.hi = Vec3(kInfinity, -0.5, kInfinity);
  s.put(n + 1, floor, false);
  auto tree = make_tree(std::pmr::get_default_resource());
  Array<Pair> pairs;
  tests_of(*tree, s, pairs);
  assert_int_equal(pairs.size(), 1);  // the huge one reaches the floor
  for (int step = 0; step < 20; ++step) {
    s.shift(n, Vec3(0, 1e-3, 0));
    // All crumbs hang at a distance that is a thousandth of its size: were its fat box a share of that, they would all
    // be candidates. Its own query goes down no more ways than there are boxes beside it.
    assert_true(tests_of(*tree, s, pairs) < 200);
  }
}

/// The same round walked again and again, from the second on also from the same start: what arrays grew to is enough.
void the_steady_state_allocates_nothing(void**) {
  for (const Maker make : kMakers) {
    Meter meter;
    BroadScene s;
    auto phase = make(&meter);
    Array<Pair> pairs(&meter);
    std::size_t grown = 0;
    for (int round = 0; round < 3; ++round) {
      Numbers random(4);
      lattice(s, random, 6);
      for (int step = 0; step < 100; ++step) {
        for (std::uint32_t i = 0; i < 216; ++i) s.shift(i, random.in_cube(0.05));
        if (step % 30 == 7)
          s.put(static_cast<std::uint32_t>(random.below(216)), box_at(random.in_cube(3), Vec3::constant(0.4)));
        if (step % 30 == 9) s.drop(static_cast<std::uint32_t>(random.below(216)));
        phase->find_pairs(s.table, s.generation, s.settings, pairs);
      }
      if (round == 1) grown = meter.allocations;
    }
    assert_true(grown > 0);
    assert_int_equal(meter.allocations, grown);
  }
}

void a_failed_allocation_is_thrown_and_the_next_answer_is_right(void**) {
  for (const Maker make : kMakers) {
    for (std::size_t fail = 0; fail < 40; ++fail) {
      Numbers random(5);
      Meter meter;
      BroadScene s;
      lattice(s, random, 3);
      auto phase = make(&meter);
      Array<Pair> pairs, expected;
      const std::size_t made = meter.allocations;  // the phase itself
      meter.fail_at = made + fail;
      bool threw = false;
      for (int step = 0; step < 6; ++step) {
        for (std::uint32_t i = 0; i < 27; ++i) s.shift(i, random.in_cube(0.2));
        if (step == 3)
          for (std::uint32_t i = 27; i < 30; ++i) s.put(i, box_at(random.in_cube(2), Vec3::constant(1)));
        try {
          phase->find_pairs(s.table, s.generation, s.settings, pairs);
        } catch (const std::bad_alloc&) {
          threw = true;
          meter.fail_at = SIZE_MAX;
          phase->find_pairs(s.table, s.generation, s.settings, pairs);
        }
        make_brute_force(std::pmr::get_default_resource())->find_pairs(s.table, s.generation, s.settings, expected);
        assert_true(std::equal(pairs.begin(), pairs.end(), expected.begin(), expected.end()));
      }
      assert_true(threw == (meter.allocations > made + fail));
    }
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_coherent_step_costs_exchanges_in_proportion_to_the_boxes),
      cmocka_unit_test(a_scene_at_rest_costs_no_exchange_and_a_step_of_one_box_few),
      cmocka_unit_test(a_teleport_of_everything_is_sorted_afresh_within_a_budget),
      cmocka_unit_test(the_grid_looks_at_neighbours_only),
      cmocka_unit_test(a_tree_asks_for_nobody_who_stays_about_where_it_was),
      cmocka_unit_test(a_tree_reaches_ahead_of_what_flies),
      cmocka_unit_test(a_tree_that_wears_is_built_afresh),
      cmocka_unit_test(a_tree_stays_shallow_whatever_comes_in_whatever_order),
      cmocka_unit_test(something_huge_among_crumbs_costs_a_tree_its_own_partners_only),
      cmocka_unit_test(the_steady_state_allocates_nothing),
      cmocka_unit_test(a_failed_allocation_is_thrown_and_the_next_answer_is_right),
  };
  return cmocka_run_group_tests_name("collision/broad work", tests, nullptr, nullptr);
}
