// Broad phase by comparing every box with every other: the oracle of the other strategies, and the paper's baseline.
#include "collision/broad/bounds.h"
#include "collision/broad/broad_phase.h"

namespace carom::collision {
namespace {

class BruteForce final : public BroadPhase {
 public:
  void find_pairs(const Colliders& table, std::uint64_t, const BroadSettings&, Array<Pair>& pairs) override {
    pairs.clear();
    work_ = {};
    for (std::size_t i = 0; i < table.active.size(); ++i) {
      const std::uint32_t a = table.active[i];
      if (is_empty(table.bounds[a])) continue;
      work_.tests += table.active.size() - i - 1;
      for (std::size_t j = i + 1; j < table.active.size(); ++j) {
        const std::uint32_t b = table.active[j];
        if (table.bounds[a].overlaps(table.bounds[b]) && !is_empty(table.bounds[b]) && may_touch(table, a, b))
          pairs.push_back({a, b});
      }
    }
  }
};

}  // namespace

Owned<BroadPhase> make_brute_force(Memory* memory) { return make_owned<BroadPhase, BruteForce>(memory); }

}  // namespace carom::collision
