// Putting pairs in ascending order in linear time.
#pragma once

#include <algorithm>

#include "collision/colliders.h"

namespace carom::collision {

/// Counting sort by the second slot, then, stably, by the first: two passes over the pairs and two over the slots.
/// A comparison sort of the ~5 pairs a body of a pile costs as much as finding them.
class PairOrder {
 public:
  explicit PairOrder(Memory* memory) : spare_(memory), first_(memory) {}

  /// For so many pairs.
  void reserve(std::size_t pairs) { spare_.reserve(pairs); }

  /// @param pairs  in any order, each once; slots below `slots`
  void sort(Array<Pair>& pairs, std::size_t slots) {
    // Few pairs among many slots: the passes over the slots would dominate.
    if (pairs.size() < slots / 16) return std::sort(pairs.begin(), pairs.end());
    spare_.resize(pairs.size());
    pass(pairs, spare_, slots, [](const Pair& p) { return p.b; });
    pass(spare_, pairs, slots, [](const Pair& p) { return p.a; });
  }

 private:
  template <class Slot>
  void pass(const Array<Pair>& from, Array<Pair>& to, std::size_t slots, Slot slot) {
    first_.assign(slots + 1, 0);
    for (const Pair& p : from) ++first_[slot(p) + 1];
    for (std::size_t i = 0; i < slots; ++i) first_[i + 1] += first_[i];
    for (const Pair& p : from) to[first_[slot(p)]++] = p;
  }

  Array<Pair> spare_;
  Array<std::size_t> first_;  // where the next pair of a slot goes
};

}  // namespace carom::collision
