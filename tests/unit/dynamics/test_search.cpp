// The heap finds what the scan finds: on random keys, and bit for bit in a whole simulation.
#include <vector>

#include "carom_test.h"
#include "dynamics/solver/search.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

static void the_heap_answers_as_the_scan_does_whatever_happens_to_the_keys(void**) {
  std::uint64_t seed = 3;
  const auto random = [&](std::uint32_t n) {
    seed = seed * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<std::uint32_t>((seed >> 33) % n);
  };
  Memory* m = std::pmr::new_delete_resource();
  for (int trial = 0; trial < 100; ++trial) {
    const std::uint32_t n = 1 + random(50);
    Array<Real> scan_keys(n, 0, m), heap_keys(n, 0, m);
    Array<Ranked> heap(m);
    Array<std::uint32_t> place(n, 0, m), rows(m);
    for (std::uint32_t i = 0; i < n; ++i) {
      scan_keys[i] = heap_keys[i] = random(8);  // few values: many ties
      rows.push_back(i);
    }
    LinearSearch scan(scan_keys, heap, place);
    HeapSearch fast(heap_keys, heap, place);
    scan.start(rows, 2);
    fast.start(rows, 2);
    for (int k = 0; k < 400; ++k) {
      assert_int_equal(scan.top(), fast.top());
      const std::uint32_t row = random(4) && scan.top() != kNoRow ? scan.top() : random(n);
      const Real key = random(8);
      scan.set(row, key);
      fast.set(row, key);
    }
  }
}

static std::uint64_t hash_of_a_pile(Real search, Real groups) {
  TestWorld t;
  t.world.set_dial(Dial::severity_search, search);
  t.world.set_dial(Dial::groups, groups);
  t.ground();
  const Shape* cube = t.keep(box(Vec3::constant(0.25)));
  const Shape* ball = t.keep(sphere(0.25));
  for (int i = 0; i < 48; ++i)
    t.add(i % 2 ? cube : ball, Vec3(0.31 * (i % 4), 0.3 + 0.5 * (i / 8), 0.37 * (i / 4 % 2)), BodyType::dynamic,
          exp_map(Vec3(0.1 * i, 0.2, 0.05 * i)));
  t.run(90, 1.0 / 60);
  assert_true(t.world.report.velocity_impulses > 0);
  return t.world.hash();
}

static void heap_and_scan_leave_the_same_bits(void**) {
  assert_true(hash_of_a_pile(0, 1) == hash_of_a_pile(1, 1));
  assert_true(hash_of_a_pile(0, 0) == hash_of_a_pile(1, 0));
}

static void a_run_repeats_bit_for_bit(void**) { assert_true(hash_of_a_pile(1, 1) == hash_of_a_pile(1, 1)); }

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(the_heap_answers_as_the_scan_does_whatever_happens_to_the_keys),
      cmocka_unit_test(heap_and_scan_leave_the_same_bits),
      cmocka_unit_test(a_run_repeats_bit_for_bit),
  };
  return cmocka_run_group_tests_name("dynamics/search", tests, nullptr, nullptr);
}
