// Broad phase: which bounds overlap. One interface, one strategy per file.
#pragma once

#include "collision/broad/bounds.h"
#include "collision/colliders.h"
#include "core/jobs.h"

namespace carom::collision {

struct BroadSettings {
  Real grid_cell = 0;    // m; 0: chosen from the scene
  Jobs* jobs = nullptr;  // share loops, of strategies that have some to share (tree)
};

/// What the last call of a strategy did, in its own units of work: for benchmarks, and for tests that hold it to its
/// order.
struct BroadWork {
  std::uint64_t tests = 0;     // pairs of bounds compared
  std::uint64_t swaps = 0;     // neighbours exchanged on an axis (sweep-and-prune)
  std::uint64_t rebuilds = 0;  // times that all was sorted or built afresh instead of updated (sweep-and-prune, tree)
  std::uint64_t entries = 0;   // cells entered by boxes (grid)
  std::uint64_t large = 0;     // boxes compared with all others (grid)
  std::uint64_t asked = 0;     // boxes whose partners were looked for (tree)
};

/// A strategy keeps what it likes from step to step; its result depends on the table alone.
class BroadPhase {
 public:
  virtual ~BroadPhase() = default;

  /// Every pair (a < b) of active colliders whose bounds overlap (closed intervals) and that may_touch(), each once,
  /// ascending by key. Colliders may have come, gone or changed slots' meaning since the last call: table.active tells
  /// which are there, `generation` is a number that differs whenever the set of slots in use or what they stand for
  /// changed. Bounds may be infinite (half-space) but are never NaN; a slot with lo > hi overlaps nothing. Allocates
  /// nothing once its arrays have grown to the scene's size.
  virtual void find_pairs(const Colliders& table, std::uint64_t generation, const BroadSettings& settings,
                          Array<Pair>& pairs) = 0;

  /// Append the colliders whose bounds, as of the last find_pairs(), overlap a box (closed), each once, in an order that
  /// means nothing. Goes through all that are active unless a strategy knows better.
  virtual void find_near(const Colliders& table, const Aabb& box, Array<std::uint32_t>& found) {
    for (const std::uint32_t slot : table.active)
      if (!is_empty(table.bounds[slot]) && table.bounds[slot].overlaps(box)) found.push_back(slot);
  }

  const BroadWork& work() const { return work_; }

 protected:
  BroadWork work_;
};

Owned<BroadPhase> make_brute_force(Memory* memory);
Owned<BroadPhase> make_sweep_and_prune(Memory* memory);
Owned<BroadPhase> make_uniform_grid(Memory* memory);
Owned<BroadPhase> make_tree(Memory* memory);

}  // namespace carom::collision
