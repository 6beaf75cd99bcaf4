// A counted set of pairs beside a map, through many random edits.
#include <map>
#include <memory_resource>
#include <utility>

#include "carom_test.h"
#include "core/pair_counts.h"
#include "shapes.h"

using namespace carom;
using namespace carom::test;

static void it_holds_what_a_map_holds(void**) {
  PairCounts set(std::pmr::new_delete_resource());
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> truth;
  Random random(5);
  for (int i = 0; i < 20000; ++i) {
    const auto a = static_cast<std::uint32_t>(random.uniform(0, 30)),
               b = static_cast<std::uint32_t>(random.uniform(0, 30));
    if (a == b) continue;
    const auto key = std::minmax(a, b);
    const Real what = random.uniform(0, 1);
    if (what < 0.5) {
      set.reserve();
      set.add(a, b);
      ++truth[key];
    } else if (what < 0.99) {
      set.remove(b, a);
      if (auto at = truth.find(key); at != truth.end() && --at->second == 0) truth.erase(at);
    } else {
      set.remove(a);
      std::erase_if(truth, [&](const auto& e) { return e.first.first == a || e.first.second == a; });
    }
    assert_int_equal(set.size(), truth.size());
    if (i % 50 == 0)
      for (std::uint32_t x = 0; x < 30; ++x)
        for (std::uint32_t y = 0; y < 30; ++y) assert_true(set.has(x, y) == (truth.count(std::minmax(x, y)) > 0));
  }
}

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(it_holds_what_a_map_holds)};
  return cmocka_run_group_tests_name("unit/core/pair_counts", tests, nullptr, nullptr);
}
