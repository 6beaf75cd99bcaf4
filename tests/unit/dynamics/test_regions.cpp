// Regions: bodies halved by place, so that threads can sweep regions of one level at once.
#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "carom_test.h"
#include "dynamics/solver/wide_contacts.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

Memory* heap() { return std::pmr::new_delete_resource(); }

struct Halved {
  Regions regions{heap()};
  const Array<std::uint32_t>& bodies = regions.order;

  Halved(const Array<Vec3>& x, Real cell) { again(x, cell); }
  bool again(const Array<Vec3>& x, Real cell) {
    Array<std::uint32_t> all(heap());
    for (std::uint32_t i = 0; i < x.size(); ++i) all.push_back(i);
    return halve(x, cell, nullptr, all, regions);
  }
};

Array<Vec3> grid(int n, Real spacing) {
  Array<Vec3> x{heap()};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) x.push_back(spacing * Vec3(i, j, k));
  return x;
}

void check_leaves(const Halved& h) {
  std::map<std::uint32_t, std::size_t> size;
  std::set<std::uint32_t> seen(h.bodies.begin(), h.bodies.end());
  assert_int_equal(seen.size(), h.bodies.size());
  for (std::size_t i = 0; i < h.bodies.size(); ++i) {
    ++size[h.regions.leaf[i]];
    assert_int_equal(Regions::level_of(h.regions.leaf[i]), h.regions.levels - 1);
    if (i == 0) continue;
    assert_true(h.regions.leaf[i - 1] <= h.regions.leaf[i]);
    if (h.regions.leaf[i - 1] == h.regions.leaf[i]) assert_true(h.bodies[i - 1] < h.bodies[i]);
  }
  for (const auto& [leaf, count] : size)
    assert_in_range(count, h.bodies.size() >> (h.regions.levels - 1), kBodiesARegion);
}

void leaves_are_small_and_of_one_size(void**) {
  for (const int n : {1, 5, 8, 9, 12, 16}) check_leaves(Halved(grid(n, 1), 1));
}

// The smallest region that has two leaves: by walking up from both.
void a_row_belongs_to_the_smallest_that_has_both(void**) {
  for (std::uint32_t a = 16; a < 32; ++a)
    for (std::uint32_t b = 16; b < 32; ++b) {
      std::uint32_t i = a, j = b;
      while (i != j) i /= 2, j /= 2;
      assert_int_equal(Regions::of(a, b), i);
    }
}

// A cube of bodies is cut where few are neighbours: no more than a layer of them.
void cuts_are_small(void**) {
  constexpr int n = 10;
  const Array<Vec3> x = grid(n, 1);
  const Halved h(x, 1);
  std::vector<std::uint32_t> leaf(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) leaf[h.bodies[i]] = h.regions.leaf[i];
  int across = 0, all = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = i + 1; j < x.size(); ++j) {
      if ((x[i] - x[j]).norm() > 1.01) continue;
      ++all;
      across += leaf[i] != leaf[j];
    }
  assert_int_equal(h.regions.levels, 2);  // one cut of 10 x 10
  assert_int_equal(all, 3 * n * n * (n - 1));
  assert_int_equal(across, n * n);
}

// What rests keeps its region though it trembles: neither rounding nor a micrometre moves anyone over.
void trembling_moves_nobody_over(void**) {
  std::mt19937 random(1);
  std::uniform_real_distribution<Real> small(-1e-6, 1e-6);
  Array<Vec3> x = grid(12, 0.5);
  Halved before(x, 0.5);
  assert_true(before.again(x, 0.5));
  for (Vec3& at : x) at += Vec3(small(random), small(random), small(random));
  const Halved after(x, 0.5);
  assert_true(std::ranges::equal(before.bodies, after.bodies));
  assert_true(std::ranges::equal(before.regions.leaf, after.regions.leaf));
  assert_true(before.again(x, 0.5));
  x[100] += Vec3(0.5, 0, 0);
  assert_false(before.again(x, 0.5));
  assert_true(before.again(x, 0.5));
}

void any_place_will_do(void**) {
  Array<Vec3> x = grid(11, 0);  // all at one place
  check_leaves(Halved(x, 1));
  x[3] = Vec3::constant(1e300), x[4] = Vec3(-1e300, 0, 1e-300);
  check_leaves(Halved(x, 1e-300));
  check_leaves(Halved(x, 1e300));
}

/// A heap large enough for several regions, on the ground, with joints through it.
struct Heap : TestWorld {
  Heap() {
    constexpr int n = 11;
    world.set_dial(Dial::solver, kSoftChoice);
    world.set_dial(Dial::precision, static_cast<Real>(Precision::in_double));
    ground();
    const Shape* cube = keep(box(Vec3::constant(0.25)));
    const Shape* ball = keep(sphere(0.25));
    std::mt19937 random(7);
    std::uniform_real_distribution<Real> off(-0.05, 0.05);
    for (int k = 0; k < n; ++k)
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          add((i + j + k) % 3 ? cube : ball, Vec3(0.52 * i + off(random), 0.26 + 0.5 * k, 0.52 * j + off(random)));
    for (std::uint32_t i = 1; i + 250 < world.scene.bodies.slots(); i += 250) {
      JointDef def;
      def.body_a = i, def.body_b = i + 250;
      def.frame_b = {Quat::identity(), world.state.x[i] - world.state.x[i + 250]};
      world.add_joint(def);
    }
  }
};

// Of regions of one level no two move a body; of lanes side by side no two; every row has one place, after those of
// larger regions, and in each region contacts with the ground come last.
void rows_of_regions_share_nobody(void**) {
  Heap t;
  t.run(20, 1.0 / 60);
  const WideContacts& w = *t.world.wide;
  const std::uint32_t levels = w.placing->regions.levels;
  assert_true(levels >= 3);
  assert_int_equal(w.regions_end(), 1u << levels);
  assert_false(w.is_float);
  std::vector<std::uint32_t> region_of(w.slot.size() * levels, 0);
  std::size_t seen = 0, small = 0;
  for (std::uint32_t r = 1; r < w.regions_end(); ++r) {
    const std::uint32_t level = Regions::level_of(r);
    assert_true(w.parts[r].pair <= w.parts[r + 1].pair);
    bool ground = false;
    for (std::uint32_t k = w.parts[r].pair; k < w.parts[r + 1].pair; ++k) {
      const auto& pair = w.in_double.pairs[k];
      std::set<std::uint32_t> moved;
      assert_int_equal(pair.first, w.first_point[k]);
      for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
        const std::uint32_t i = w.occupant[k * kLanes + lane];
        if (i == kEmptyLane) continue;
        ++seen;
        small += level + 1 == levels;
        assert_int_equal(w.manifolds[i].pair, k);
        assert_int_equal(w.manifolds[i].lane, lane);
        assert_int_equal(w.manifolds[i].points, pair.points);
        const bool both = pair.a[lane] >= w.first_moved && pair.b[lane] >= w.first_moved;
        if (r > 1) {
          assert_false(both && ground);
          ground |= !both;
        }
        for (const std::uint32_t body : {pair.a[lane], pair.b[lane]}) {
          if (body < w.first_moved) continue;
          assert_true(moved.insert(body).second);
          std::uint32_t& of = region_of[level * w.slot.size() + body];
          assert_true(of == 0 || of == r);
          of = r;
        }
      }
    }
  }
  assert_int_equal(seen, w.manifolds.size());
  assert_true(small > seen * 3 / 4);
}

/// Columns that stand, on the ground and on a block, and what is done to them now and then.
struct Columns : TestWorld {
  Columns() {
    world.set_dial(Dial::solver, kSoftChoice);
    ground();
    block = add(slab, Vec3(2, -0.25, -2), BodyType::fixed);
    for (int i = 0; i < 64; ++i)
      for (int k = 0; k < 9; ++k)
        columns.push_back(add(cube, Vec3(0.75 * (i % 8), 0.25 + 0.5 * k + (i < 24 ? 0.25 : 0), 0.75 * (i / 8) - 3.0)));
  }
  void disturb(int step) {
    if (step == 20) world.remove_body(columns[150]);
    if (step == 21) columns[150] = add(cube, Vec3(2, 4, 2));  // in the slot of the other
    if (step == 40) world.set_velocity(columns[77], Vec3(0.5, 0, 0), Vec3::zero());
    if (step == 50) {
      const Pose at = world.pose(block);
      world.remove_body(block);
      block = add(slab, at.p, BodyType::kinematic);
    }
    if (step == 55) world.set_velocity(block, Vec3(0.25, 0, 0), Vec3::zero());
  }

  const Shape *cube = keep(box(Vec3::constant(0.25))), *slab = keep(box(Vec3(5, 0.5, 1)));
  std::uint32_t block = 0;
  std::vector<std::uint32_t> columns;
};

// Pairs keep their places while nobody comes or goes; to the bit as if they were placed anew in every step.
void places_that_are_kept_are_those_made_anew(void**) {
  Columns kept, anew;
  int times = 0;
  for (int step = 0; step < 80; ++step) {
    kept.disturb(step), anew.disturb(step);
    if (anew.world.wide->placing) anew.world.wide->placing->stands = false;
    constexpr std::uint32_t kUntouched = 12345;
    Placing* const placing = kept.world.wide->placing.get();
    if (placing && !placing->in_region.empty()) placing->in_region[0] = kUntouched;
    kept.run(1, 1.0 / 60), anew.run(1, 1.0 / 60);
    times += placing && !placing->in_region.empty() && placing->in_region[0] == kUntouched;
    assert_true(kept.world.hash() == anew.world.hash());
  }
  assert_true(kept.world.wide->placing->regions.levels > 1);
  assert_in_range(times, 40, 75);
}

struct Colour {
  std::uint32_t region, colour;
  bool operator==(const Colour&) const = default;
};
using Colours = std::map<std::pair<std::uint32_t, std::uint32_t>, Colour>;  // by bodies that meet

Colours colours_of(const World& world) {
  Colours colours;
  const WideContacts& w = *world.wide;
  for (std::uint32_t region = 1; region < w.regions_end(); ++region)
    for (std::uint32_t k = w.parts[region].member; k < w.parts[region + 1].member; ++k) {
      const Placing::Member& m = w.placing->members[k];
      const ContactPair& met = w.placing->met[m.manifold];
      colours[{met.a, met.b}] = {region, m.bucket / kPairKinds};
    }
  return colours;
}

// Colours follow from who touches whom, pair by pair in a fixed order: one changes only where a neighbour's does, and
// so on back to who came or went.
void pairs_keep_their_colours_though_others_come_and_go(void**) {
  Heap t;
  t.run(40, 1.0 / 60);
  Colours before = colours_of(t.world);
  std::size_t stayed = 0, kept = 0, came = 0;
  for (int step = 0; step < 30; ++step) {
    t.run(1, 1.0 / 60);
    Colours now = colours_of(t.world);
    // How many pairs of a body changed: one that changes alone has no neighbour to blame.
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> changed;
    const auto count = [&](const Colours& these, const Colours& those) {
      for (const auto& [pair, colour] : these)
        if (const auto other = those.find(pair); other == those.end() || !(other->second == colour))
          ++changed[{colour.region, pair.first}], ++changed[{colour.region, pair.second}];
    };
    count(before, now), count(now, before);
    for (const auto& [pair, colour] : now) {
      const auto old = before.find(pair);
      if (old == before.end()) {
        ++came;
        continue;
      }
      ++stayed;
      if (old->second == colour) {
        ++kept;
        continue;
      }
      if (old->second.region != colour.region) continue;
      const int neighbours = std::max(changed[{colour.region, pair.first}], changed[{colour.region, pair.second}]);
      assert_true(neighbours > 2);  // it is counted twice itself
    }
    before.swap(now);
  }
  print_message("%zu pairs came; of %zu that stayed %.1f %% kept region and colour\n", came, stayed,
                100.0 * static_cast<double>(kept) / static_cast<double>(stayed));
  assert_true(came > 100 && kept > stayed / 2);
}

void the_outcome_does_not_depend_on_threads(void**) {
  const std::uint64_t alone = hash_of_run<Heap>(kSoftChoice, 1, 20);
  for (const std::uint32_t threads : {2u, 3u}) assert_true(hash_of_run<Heap>(kSoftChoice, threads, 20) == alone);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(leaves_are_small_and_of_one_size),
      cmocka_unit_test(a_row_belongs_to_the_smallest_that_has_both),
      cmocka_unit_test(cuts_are_small),
      cmocka_unit_test(trembling_moves_nobody_over),
      cmocka_unit_test(any_place_will_do),
      cmocka_unit_test(rows_of_regions_share_nobody),
      cmocka_unit_test(places_that_are_kept_are_those_made_anew),
      cmocka_unit_test(pairs_keep_their_colours_though_others_come_and_go),
      cmocka_unit_test(the_outcome_does_not_depend_on_threads),
  };
  return cmocka_run_group_tests_name("unit/dynamics/regions", tests, nullptr, nullptr);
}
