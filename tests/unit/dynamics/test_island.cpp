// Contact groups by union-find against a breadth-first search, on random contact graphs.
#include <deque>
#include <vector>

#include "carom_test.h"
#include "dynamics/island.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

struct Draw {
  std::uint64_t state = 7;
  std::uint32_t below(std::uint32_t n) {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<std::uint32_t>((state >> 33) % n);
  }
};

/// Label of each row: the lowest row that can be reached through bodies that move.
std::vector<std::uint32_t> labels_by_search(const Array<Row>& rows) {
  const std::uint32_t none = 0xFFFFFFFFu;
  std::vector<std::uint32_t> label(rows.size(), none);
  for (std::uint32_t first = 0; first < rows.size(); ++first) {
    if (label[first] != none) continue;
    std::deque<std::uint32_t> queue{first};
    label[first] = first;
    while (!queue.empty()) {
      const Row& row = rows[queue.front()];
      queue.pop_front();
      for (std::uint32_t i = 0; i < rows.size(); ++i) {
        const auto meets = [&](std::uint32_t body) {
          return (rows[i].moves_a && rows[i].a == body) || (rows[i].moves_b && rows[i].b == body);
        };
        if (label[i] == none && ((row.moves_a && meets(row.a)) || (row.moves_b && meets(row.b))))
          label[i] = first, queue.push_back(i);
      }
    }
  }
  return label;
}

}  // namespace

static void union_find_agrees_with_breadth_first_search(void**) {
  Draw random;
  for (int trial = 0; trial < 200; ++trial) {
    const std::uint32_t bodies = 2 + random.below(40), rows = random.below(60);
    std::vector<bool> moves(bodies);
    for (std::uint32_t i = 0; i < bodies; ++i) moves[i] = random.below(4) != 0;
    Contacts c(std::pmr::new_delete_resource());
    for (std::uint32_t k = 0; k < rows; ++k) {
      Row row{};
      row.u = row.n = row.p = row.friction_p = Vec3::zero();
      row.a = random.below(bodies), row.b = random.below(bodies);
      row.moves_a = moves[row.a], row.moves_b = moves[row.b];
      if (row.a == row.b || !(row.moves_a || row.moves_b)) continue;
      const std::uint32_t count = 1 + random.below(4), first = static_cast<std::uint32_t>(c.rows.size());
      for (std::uint32_t i = 0; i < count; ++i) c.rows.push_back(row);
      c.contact_pairs.push_back({first, count, row.a, row.b, row.moves_a, row.moves_b, true});
    }
    partition_rows(c, bodies, true);
    const std::vector<std::uint32_t> want = labels_by_search(c.rows);
    assert_int_equal(c.group_rows.size(), c.rows.size());
    std::uint32_t lowest_before = 0;
    for (std::size_t g = 0; g < c.groups(); ++g) {
      const std::uint32_t begin = c.group_begin[g], end = c.group_begin[g + 1];
      assert_true(begin < end);
      const std::uint32_t lowest = c.group_rows[begin];
      assert_true(g == 0 || lowest > lowest_before);  // groups in order of their lowest row
      lowest_before = lowest;
      for (std::uint32_t k = begin; k < end; ++k) {
        assert_int_equal(want[c.group_rows[k]], lowest);
        assert_true(k == begin || c.group_rows[k] > c.group_rows[k - 1]);
      }
    }
    partition_rows(c, bodies, false);
    assert_int_equal(c.groups(), c.rows.empty() ? 0 : 1);
  }
}

static void static_and_kinematic_bodies_cut_the_chain(void**) {
  for (const BodyType type : {BodyType::fixed, BodyType::kinematic}) {
    TestWorld t;
    const Shape* plate = t.keep(box(Vec3(5, 0.5, 5)));
    const Shape* ball = t.keep(sphere(0.5));
    t.add(plate, Vec3(0, -0.5, 0), type);
    t.add(ball, Vec3(-2, 0.5, 0));
    t.add(ball, Vec3(2, 0.5, 0));
    t.world.step(1.0 / 60);
    assert_int_equal(t.world.report.groups, 2);
    t.world.set_dial(Dial::groups, 0);
    t.world.step(1.0 / 60);
    assert_int_equal(t.world.report.groups, 1);
    assert_int_equal(t.world.report.largest_group, 2);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(union_find_agrees_with_breadth_first_search),
      cmocka_unit_test(static_and_kinematic_bodies_cut_the_chain),
  };
  return cmocka_run_group_tests_name("dynamics/island", tests, nullptr, nullptr);
}
