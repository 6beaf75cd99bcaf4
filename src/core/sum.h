// Sums of many terms that keep all their digits: thousands of equal terms round the same way, and plain sums drift by n
// u.
#pragma once

#include "core/layers.h"

namespace carom::core {

/// Compensated sum of numbers, vectors or matrices.
/// @accuracy  2 u of the result + n^2 u^2 of the sum of magnitudes
/// @source    the rounding error of an addition is itself a double, and is kept [Knuth1997 §4.2.2]
template <class T>
class Sum {
 public:
  explicit Sum(const T& zero) : sum_(zero), lost_(zero) {}
  void add(const T& x) {
    const T next = sum_ + x;
    const T added = next - sum_;
    lost_ += (sum_ - (next - added)) + (x - added);
    sum_ = next;
  }
  T value() const { return sum_ + lost_; }

 private:
  T sum_, lost_;
};

}  // namespace carom::core
