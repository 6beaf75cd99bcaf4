// Which contact is the most severe? Two searches with one interface and the same results: the paper's scan and a heap.
//
// A search looks after the rows of one group whose key lies above a threshold. top() is the row with the largest key;
// among equals, the lowest row. So both searches make a solver do the same things in the same order, bit for bit.
#pragma once

#include <span>

#include "core/memory.h"
#include "core/vec.h"

namespace carom::dynamics {

inline constexpr std::uint32_t kNoRow = 0xFFFFFFFFu;

/// A row in the heap, with the key that it is sorted by: at least the row's own.
struct Ranked {
  Real key;
  std::uint32_t row;
};

/// Keys by row, scanned from end to end: O(rows) per top().
class LinearSearch {
 public:
  LinearSearch(Array<Real>& keys, Array<Ranked>&, Array<std::uint32_t>&) : keys_(keys) {}

  void start(std::span<const std::uint32_t> rows, Real threshold) { rows_ = rows, threshold_ = threshold; }
  void set(std::uint32_t row, Real key) { keys_[row] = key; }
  std::uint32_t top() const {
    std::uint32_t best = kNoRow;
    Real most = threshold_;
    for (const std::uint32_t row : rows_)
      if (keys_[row] > most) most = keys_[row], best = row;
    return best;
  }

 private:
  Array<Real>& keys_;
  std::span<const std::uint32_t> rows_;
  Real threshold_ = 0;
};

/// Binary heap of the rows above the threshold, with each row's place in it. A key that falls only leaves its row
/// ranked too high; top() puts right what has come to the top, so that a row which many neighbours disturb is sunk
/// once, when its turn comes, not at every disturbance. A key that rises is moved at once (a few places, as a rule). In
/// a pile at rest almost all rows are and stay below the threshold and cost one compare.
class HeapSearch {
 public:
  /// @param heap  scratch with capacity for all rows   @param place  [rows], scratch
  HeapSearch(Array<Real>& keys, Array<Ranked>& heap, Array<std::uint32_t>& place)
      : keys_(keys), heap_(heap), place_(place) {}

  void start(std::span<const std::uint32_t> rows, Real threshold) {
    threshold_ = threshold;
    heap_.clear();
    for (const std::uint32_t row : rows) {
      place_[row] = kNoRow;
      if (keys_[row] > threshold) put_last({keys_[row], row});
    }
    for (std::size_t i = heap_.size() / 2; i-- > 0;) sink(i, heap_[i]);
  }

  void set(std::uint32_t row, Real key) {
    keys_[row] = key;
    const std::uint32_t at = place_[row];
    if (at != kNoRow) {
      if (key > heap_[at].key) rise(at, {key, row});
    } else if (key > threshold_) {
      put_last({key, row});
      rise(heap_.size() - 1, {key, row});
    }
  }

  std::uint32_t top() {
    while (!heap_.empty()) {
      const Ranked first = heap_[0];
      const Real key = keys_[first.row];
      if (key == first.key) return first.row;
      if (key > threshold_)
        sink(0, {key, first.row});
      else
        remove_first();
    }
    return kNoRow;
  }

 private:
  static bool before(Ranked a, Ranked b) { return a.key > b.key || (a.key == b.key && a.row < b.row); }
  void put(std::size_t at, Ranked r) {
    heap_[at] = r;
    place_[r.row] = static_cast<std::uint32_t>(at);
  }
  void put_last(Ranked r) {
    place_[r.row] = static_cast<std::uint32_t>(heap_.size());
    heap_.push_back(r);
  }
  void rise(std::size_t at, Ranked r) {
    for (; at > 0 && before(r, heap_[(at - 1) / 2]); at = (at - 1) / 2) put(at, heap_[(at - 1) / 2]);
    put(at, r);
  }
  void sink(std::size_t at, Ranked r) {
    const std::size_t n = heap_.size();
    for (std::size_t child; (child = 2 * at + 1) < n; at = child) {
      child += child + 1 < n && before(heap_[child + 1], heap_[child]);
      if (!before(heap_[child], r)) break;
      put(at, heap_[child]);
    }
    put(at, r);
  }
  void remove_first() {
    place_[heap_[0].row] = kNoRow;
    const Ranked last = heap_.back();
    heap_.pop_back();
    if (!heap_.empty()) sink(0, last);
  }

  Array<Real>& keys_;
  Array<Ranked>& heap_;
  Array<std::uint32_t>& place_;
  Real threshold_ = 0;
};

}  // namespace carom::dynamics
