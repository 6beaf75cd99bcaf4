// Which contact is the most severe? Two searches with one interface and the same answers: the paper's scan and a heap.
//
// A search looks after the rows of one group whose key lies above a threshold. top() is the row with the largest key;
// among equals, the lowest row. So both searches make a solver do the same things in the same order, bit for bit.
#pragma once

#include <span>

#include "core/memory.h"
#include "core/vec.h"

namespace carom {

inline constexpr std::uint32_t kNoRow = 0xFFFFFFFFu;

/// Keys by row, scanned from end to end: O(rows) per top().
class LinearSearch {
 public:
  LinearSearch(Array<Real>& keys, Array<std::uint32_t>&, Array<std::uint32_t>&) : keys_(keys) {}

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

/// Binary heap of the rows above the threshold, with each row's place in it: O(log rows) per set(), nothing for rows
/// that are and stay below. In a pile at rest almost all are.
class HeapSearch {
 public:
  /// @param heap      scratch with capacity for all rows   @param position [rows]
  HeapSearch(Array<Real>& keys, Array<std::uint32_t>& heap, Array<std::uint32_t>& position)
      : keys_(keys), heap_(heap), position_(position) {}

  void start(std::span<const std::uint32_t> rows, Real threshold) {
    threshold_ = threshold;
    heap_.clear();
    for (const std::uint32_t row : rows) position_[row] = kNoRow;
    for (const std::uint32_t row : rows) {
      if (!(keys_[row] > threshold)) continue;
      position_[row] = static_cast<std::uint32_t>(heap_.size());
      heap_.push_back(row);
    }
    for (std::size_t i = heap_.size() / 2; i-- > 0;) sink(i, heap_[i]);
  }

  void set(std::uint32_t row, Real key) {
    keys_[row] = key;
    const std::uint32_t at = position_[row];
    if (key > threshold_) {
      if (at == kNoRow) {
        heap_.push_back(row);
        rise(heap_.size() - 1, row);
      } else if (at > 0 && before(row, heap_[(at - 1) / 2])) {
        rise(at, row);
      } else {
        sink(at, row);
      }
    } else if (at != kNoRow) {
      remove(at);
      position_[row] = kNoRow;
    }
  }

  std::uint32_t top() const { return heap_.empty() ? kNoRow : heap_[0]; }

 private:
  bool before(std::uint32_t a, std::uint32_t b) const { return keys_[a] > keys_[b] || (keys_[a] == keys_[b] && a < b); }
  void put(std::size_t at, std::uint32_t row) {
    heap_[at] = row;
    position_[row] = static_cast<std::uint32_t>(at);
  }
  void rise(std::size_t at, std::uint32_t row) {
    for (; at > 0 && before(row, heap_[(at - 1) / 2]); at = (at - 1) / 2) put(at, heap_[(at - 1) / 2]);
    put(at, row);
  }
  void sink(std::size_t at, std::uint32_t row) {
    const std::size_t n = heap_.size();
    for (std::size_t child; (child = 2 * at + 1) < n; at = child) {
      if (child + 1 < n && before(heap_[child + 1], heap_[child])) ++child;
      if (!before(heap_[child], row)) break;
      put(at, heap_[child]);
    }
    put(at, row);
  }
  void remove(std::size_t at) {
    const std::uint32_t last = heap_.back();
    heap_.pop_back();
    if (at == heap_.size()) return;
    if (at > 0 && before(last, heap_[(at - 1) / 2]))
      rise(at, last);
    else
      sink(at, last);
  }

  Array<Real>& keys_;
  Array<std::uint32_t>& heap_;
  Array<std::uint32_t>& position_;
  Real threshold_ = 0;
};

}  // namespace carom
