// Every broad phase gives the answer of the obvious one, on everything that a world may do between two steps.
#include <algorithm>
#include <cstdio>

#include "carom_test.h"
#include "unit/collision/broad_scene.h"

using namespace carom;
using namespace carom::test;

namespace {

/// All strategies on one scene, step after step.
struct Quartet {
  Owned<BroadPhase> brute = make_brute_force(std::pmr::get_default_resource());
  Owned<BroadPhase> others[3] = {make_sweep_and_prune(std::pmr::get_default_resource()),
                                 make_uniform_grid(std::pmr::get_default_resource()),
                                 make_tree(std::pmr::get_default_resource())};
  Array<Pair> expected, got;

  void agree(const BroadScene& s) {
    brute->find_pairs(s.table, s.generation, s.settings, expected);
    for (auto& other : others) {
      other->find_pairs(s.table, s.generation, s.settings, got);
      assert_int_equal(got.size(), expected.size());
      assert_true(std::equal(got.begin(), got.end(), expected.begin()));
    }
  }
};

/// Brute force itself, against the words of the contract and nothing of ours.
void brute_force_is_the_contract_word_for_word(void**) {
  Numbers random(1);
  BroadScene s;
  // Half of the boxes are empty on some axis.
  for (std::uint32_t i = 0; i < 40; ++i)
    s.put(i, box_at(random.in_cube(2), random.in_cube(0.6) + Vec3::constant(0.4)), i % 3 != 0);
  for (std::uint32_t i = 0; i < 40; i += 5) s.table.disabled[i] = 1;
  for (std::uint32_t i = 0; i < 40; i += 7) s.table.body[i] = 0;
  for (std::uint32_t i = 20; i < 30; ++i) s.put(i, box_at(random.in_cube(2), Vec3::constant(1)));
  s.drop(13);
  std::vector<Pair> expected;
  for (std::uint32_t a = 0; a < 40; ++a)
    for (std::uint32_t b = a + 1; b < 40; ++b) {
      bool both =
          a != 13 && b != 13 && s.table.body[a] != s.table.body[b] && !s.table.disabled[a] && !s.table.disabled[b];
      both = both && (s.table.movable[a] || s.table.movable[b]);
      for (int k = 0; k < 3; ++k) {
        const Real alo = s.table.bounds[a].lo[k], ahi = s.table.bounds[a].hi[k];
        const Real blo = s.table.bounds[b].lo[k], bhi = s.table.bounds[b].hi[k];
        both = both && alo <= ahi && blo <= bhi && std::max(alo, blo) <= std::min(ahi, bhi);
      }
      if (both) expected.push_back({a, b});
    }
  assert_true(expected.size() > 20);
  Array<Pair> got;
  make_brute_force(std::pmr::get_default_resource())->find_pairs(s.table, 1, s.settings, got);
  assert_true(std::equal(got.begin(), got.end(), expected.begin(), expected.end()));
}

void they_agree_over_a_long_random_life_of_a_scene(void**) {
  std::size_t most = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Numbers random(seed);
    BroadScene s;
    Quartet quartet;
    const std::uint32_t slots = 120;
    std::vector<Vec3> velocity(slots);
    for (int step = 0; step < 400; ++step) {
      for (const std::uint32_t slot : s.table.active) {
        s.shift(slot, velocity[slot]);
        for (int k = 0; k < 3; ++k)  // walls keep them together
          if (std::fabs(s.table.bounds[slot].lo[k]) > 2) velocity[slot][k] *= -1;
        if (random.below(300) == 0) s.shift(slot, random.in_cube(3));  // teleport
        if (random.below(300) == 0) s.table.disabled[slot] ^= 1;       // without a new generation
        if (random.below(300) == 0) s.table.movable[slot] ^= 1;
        if (random.below(300) == 0) s.table.body[slot] = static_cast<std::uint32_t>(random.below(slots));
        if (random.below(300) == 0) std::swap(s.table.bounds[slot].lo.x(), s.table.bounds[slot].hi.x());  // empty, back
      }
      // Now and then a crowd, mostly one or two.
      const std::size_t changes = step % 97 == 0 ? 60 : random.below(3);
      for (std::size_t i = 0; i < changes; ++i) {
        const auto slot = static_cast<std::uint32_t>(random.below(slots));
        const bool there = std::binary_search(s.table.active.begin(), s.table.active.end(), slot);
        if (there && random.below(2)) {
          s.drop(slot);
        } else {  // also: another object in a slot that was in use
          s.put(slot, box_at(random.in_cube(2), Vec3::constant(random.between(0.05, 1.2))), random.below(5) != 0);
          velocity[slot] = random.in_cube(0.05);
        }
      }
      quartet.agree(s);
      most = std::max(most, quartet.expected.size());
    }
  }
  assert_true(most > 100);  // the boxes did meet
}

/// Corners on a lattice: nearly every end has a twin of the same value, and -0 meets 0.
void touching_boxes_with_equal_coordinates_are_pairs_in_all(void**) {
  Numbers random(7);
  BroadScene s;
  Quartet quartet;
  for (std::uint32_t i = 0; i < 90; ++i) s.put(i, box_at(Vec3::zero(), Vec3::constant(0.5)));
  std::size_t touching = 0;
  for (int step = 0; step < 200; ++step) {
    for (const std::uint32_t slot : s.table.active) {
      if (step && random.below(4)) continue;
      Vec3 c, half;
      for (int k = 0; k < 3; ++k) {
        c[k] = static_cast<Real>(random.below(5)) * (random.below(2) ? 1.0 : -1.0);
        half[k] = 0.5 * static_cast<Real>(random.below(3));
      }
      s.table.bounds[slot] = box_at(c, half);
    }
    quartet.agree(s);
    for (const Pair& p : quartet.expected)
      for (int axis = 0; axis < 3; ++axis) touching += s.table.bounds[p.a].lo[axis] == s.table.bounds[p.b].hi[axis];
  }
  assert_true(touching > 1000);
}

void a_touch_is_a_pair_and_a_gap_of_one_bit_is_none(void**) {
  BroadScene s;
  Quartet quartet;
  s.put(0, box_at(Vec3(0, 0, 0), Vec3::constant(1)));
  s.put(1, box_at(Vec3(2, 0, 0), Vec3::constant(1)));
  for (int step = 0; step < 3; ++step) {
    s.table.bounds[1].lo.x() = 1;
    quartet.agree(s);
    assert_int_equal(quartet.expected.size(), 1);
    s.table.bounds[1].lo.x() = std::nextafter(1.0, 2.0);
    quartet.agree(s);
    assert_int_equal(quartet.expected.size(), 0);
  }
}

void unbounded_boxes_pair_with_all_that_they_reach(void**) {
  Numbers random(3);
  BroadScene s;
  Quartet quartet;
  Aabb all, below, column;
  all.lo = Vec3::constant(-kInfinity), all.hi = Vec3::constant(kInfinity);
  below = all, below.hi.y() = 0;
  column = all, column.lo.x() = column.lo.z() = -0.5, column.hi.x() = column.hi.z() = 0.5;
  s.put(0, all, false), s.put(1, below, false), s.put(9, column, false), s.put(50, all);
  for (std::uint32_t i = 10; i < 50; ++i) s.put(i, box_at(random.in_cube(3), Vec3::constant(0.4)));
  for (int step = 0; step < 60; ++step) {
    for (std::uint32_t i = 10; i < 50; ++i) s.shift(i, random.in_cube(0.2));
    if (step == 20) s.drop(0);
    if (step == 30) s.put(0, all, false);
    quartet.agree(s);
    if (step == 30) assert_true(quartet.expected.size() >= 40);
  }
}

void nothing_one_box_and_many_identical_boxes_are_no_special_case(void**) {
  BroadScene s;
  Quartet quartet;
  quartet.agree(s);
  assert_int_equal(quartet.expected.size(), 0);
  s.put(5, box_at(Vec3::zero(), Vec3::constant(1)));
  quartet.agree(s);
  assert_int_equal(quartet.expected.size(), 0);
  for (std::uint32_t i = 0; i < 80; ++i) s.put(i, box_at(Vec3(1, 2, 3), Vec3::constant(1)));
  quartet.agree(s);
  assert_int_equal(quartet.expected.size(), 80 * 79 / 2);
  for (std::uint32_t i = 0; i < 80; ++i) s.table.bounds[i] = box_at(Vec3(1, 2, 3), Vec3::zero());  // points
  quartet.agree(s);
  assert_int_equal(quartet.expected.size(), 80 * 79 / 2);
  for (std::uint32_t i = 0; i < 80; ++i) s.drop(i);
  quartet.agree(s);
  assert_int_equal(quartet.expected.size(), 0);
}

/// Sizes and distances over 600 orders of magnitude, where cell numbers would overflow any integer.
void scales_from_atoms_to_the_end_of_doubles_are_all_right(void**) {
  Numbers random(11);
  for (const Real scale : {1e-300, 1e-9, 1e6, 1e18, 1e100, 1e300}) {
    BroadScene s;
    Quartet quartet;
    for (std::uint32_t i = 0; i < 60; ++i) s.put(i, box_at(scale * random.in_cube(3), Vec3::constant(0.5 * scale)));
    for (int step = 0; step < 20; ++step) {
      for (std::uint32_t i = 0; i < 60; ++i) s.shift(i, scale * random.in_cube(0.3));
      quartet.agree(s);
      assert_true(quartet.expected.size() > 5);
    }
  }
  BroadScene mixed;  // a metre here, a metre 1e6 m away, a planet, a crumb and an escaped body, all in one scene
  Quartet quartet;
  for (std::uint32_t i = 0; i < 100; ++i) {
    const Vec3 home = i % 2 ? Vec3(1e6, -1e6, 1e6) : Vec3(-3e6, 2e6, 1);
    mixed.put(i, box_at(home + random.in_cube(2), Vec3::constant(random.between(0.1, 0.6))));
  }
  mixed.put(100, box_at(Vec3(0, -6.4e6, 0), Vec3::constant(6.4e6)));
  mixed.put(101, box_at(Vec3(1e6, -1e6, 1e6), Vec3::constant(1e-12)));
  mixed.put(102, box_at(Vec3(1e308, 1e308, -1e308), Vec3::constant(1)));
  for (int step = 0; step < 20; ++step) {
    for (std::uint32_t i = 0; i < 100; ++i) mixed.shift(i, random.in_cube(0.2));
    quartet.agree(mixed);
    assert_true(quartet.expected.size() > 50);
  }
}

void the_cell_size_never_changes_the_answer(void**) {
  Numbers random(5);
  BroadScene s;
  Quartet quartet;
  for (std::uint32_t i = 0; i < 100; ++i) s.put(i, box_at(random.in_cube(4), Vec3::constant(random.between(0.01, 1))));
  for (const Real cell : {1e-300, 1e-6, 0.01, 0.3, 1.0, 7.0, 1e6, 1e300, kInfinity}) {
    s.settings.grid_cell = cell;
    for (std::uint32_t i = 0; i < 100; ++i) s.shift(i, random.in_cube(0.1));
    quartet.agree(s);
    assert_true(quartet.expected.size() > 50);
  }
}

/// Clusters that fall, bounce off the floor, calm down and are kicked apart again, for thousands of steps: all that makes
/// fat boxes grow, reach ahead, shrink and be left.
void clusters_that_fly_land_and_rest_are_right_for_thousands_of_steps(void**) {
  Numbers random(17);
  BroadScene s;
  Quartet quartet;
  const std::uint32_t n = 64;
  std::vector<Vec3> velocity(n, Vec3::zero());
  Aabb floor;
  floor.lo = Vec3::constant(-kInfinity), floor.hi = Vec3(kInfinity, 0, kInfinity);
  s.put(n, floor, false);
  for (std::uint32_t i = 0; i < n; ++i)
    s.put(i, box_at(3 * Vec3(i % 4, 1, i / 16), Vec3(random.between(0.02, 0.5), random.between(0.02, 0.5), 0.3)));
  std::size_t most = 0;
  for (int step = 0; step < 4000; ++step) {
    for (std::uint32_t i = 0; i < n; ++i) {
      velocity[i].y() -= 0.003;
      s.shift(i, velocity[i]);
      if (s.table.bounds[i].lo.y() < 0) {
        s.shift(i, Vec3(0, -s.table.bounds[i].lo.y(), 0));
        velocity[i] *= 0.5, velocity[i].y() *= -1;
      }
      if (random.below(2000) == 0) {
        const bool there = std::binary_search(s.table.active.begin(), s.table.active.end(), i);
        if (there)
          s.drop(i), s.table.bounds[i] = box_at(3 * random.in_cube(1) + Vec3(0, 5, 0), Vec3::constant(0.3));
        else
          s.put(i, s.table.bounds[i], random.below(4) != 0);
      }
      if (random.below(3000) == 0) velocity[i] = random.in_cube(0.9);  // farther than its size, too
    }
    if (step % 500 == 250)
      for (Vec3& v : velocity) v = random.in_cube(0.1) + Vec3(0, 0.1, 0);
    quartet.agree(s);
    most = std::max(most, quartet.expected.size());
  }
  assert_true(most > n);
}

/// A crowd that jumps anywhere in every step: what order was kept is worth nothing.
void teleports_of_all_boxes_are_right(void**) {
  Numbers random(13);
  BroadScene s;
  Quartet quartet;
  for (std::uint32_t i = 0; i < 150; ++i) s.put(i, box_at(random.in_cube(5), Vec3::constant(0.5)));
  for (int step = 0; step < 60; ++step) {
    for (std::uint32_t i = 0; i < 150; ++i)
      if (step % 3) s.table.bounds[i] = box_at(random.in_cube(5), Vec3::constant(0.5));
    quartet.agree(s);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(brute_force_is_the_contract_word_for_word),
      cmocka_unit_test(they_agree_over_a_long_random_life_of_a_scene),
      cmocka_unit_test(touching_boxes_with_equal_coordinates_are_pairs_in_all),
      cmocka_unit_test(a_touch_is_a_pair_and_a_gap_of_one_bit_is_none),
      cmocka_unit_test(unbounded_boxes_pair_with_all_that_they_reach),
      cmocka_unit_test(nothing_one_box_and_many_identical_boxes_are_no_special_case),
      cmocka_unit_test(scales_from_atoms_to_the_end_of_doubles_are_all_right),
      cmocka_unit_test(the_cell_size_never_changes_the_answer),
      cmocka_unit_test(clusters_that_fly_land_and_rest_are_right_for_thousands_of_steps),
      cmocka_unit_test(teleports_of_all_boxes_are_right),
  };
  return cmocka_run_group_tests_name("collision/broad agreement", tests, nullptr, nullptr);
}
