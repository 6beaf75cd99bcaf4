// The rows that a joint locks of its child, made orthogonal once: what they leave free, the least velocity at which each
// has what it asks, and the impulses that give a momentum.
#pragma once

#include <algorithm>
#include <cstdint>

#include "dynamics/solver/direct/block.h"

namespace carom::dynamics {

/// Rows = lower (mirror_0 mirror_1 ...)^T, by Householder's mirrors. Angles count times the size of the child, so that
/// least is by its masses, about.
class LockedRows {
 public:
  /// @param size  m, about how far the child's mass is from its middle
  explicit LockedRows(Real size) : scale_{1, 1, 1, 1 / size, 1 / size, 1 / size} {}

  /// What others do not imply of it is a lock of its own. Of one joint: six at most.
  void add(const RowOfTwos& row) {
    constexpr Real kImplied = 1e-9;
    if (rows_ == kDof) return;
    RowOfTwos a = scaled(row);
    const Real whole2 = a.dot(a);
    for (int k = 0; k < rank_; ++k) reflect(k, a);
    RowOfTwos tail = a;
    if (rank_ < kDof) tail.multiply(RowOfTwos(kFrom[rank_]));
    const Real tail2 = tail.dot(tail);
    if (rank_ == kDof || !(tail2 > kImplied * kImplied * whole2)) {
      place_[rows_++] = kDof;
      return;
    }
    a.store(lower_[rank_]);
    const Real first = lower_[rank_][rank_];
    const Real length = first > 0 ? -std::sqrt(tail2) : std::sqrt(tail2), inverse = 1 / length;
    tail.subtract(length, RowOfTwos(kUnit[rank_]));
    tail.store(mirror_[rank_]);
    inverse_[rank_] = inverse, twice_[rank_] = inverse / (first - length);
    place_[rows_++] = static_cast<std::uint8_t>(rank_++);
  }

  int freedom() const { return kDof - rank_; }
  bool is_implied(std::uint32_t row) const { return place_[row] == kDof; }
  /// A velocity that none of them locks.   @param k  below freedom()   @param to  row of a block
  void free(int k, Real* to) const {
    RowOfTwos a(kUnit[rank_ + k]);
    for (int i = rank_; i-- > 0;) reflect(i, a);
    scaled(a).store(to);
  }
  /// The least velocity that has so much along each row.   @param along  (row) -> m/s; not asked of implied ones
  template <class F>
  RowOfTwos velocity(const F& along) const {
    Real v[kDof];
    RowOfTwos a = RowOfTwos::zero();
    for (std::uint32_t row = 0; row < rows_; ++row) {
      const int i = place_[row];
      if (i == kDof) continue;
      Real s = along(row);
      for (int k = 0; k < i; ++k) s -= lower_[i][k] * v[k];
      v[i] = s * inverse_[i];
      a.add(v[i], RowOfTwos(kUnit[i]));
    }
    for (int i = rank_; i-- > 0;) reflect(i, a);
    return scaled(a);
  }
  /// Impulses of the rows that give so much momentum, of what they resist.   @param to  (row, impulse); of implied ones 0
  template <class F>
  void find_impulses(const RowOfTwos& momentum, const F& to) const {
    RowOfTwos mirrored = scaled(momentum);
    for (int k = 0; k < rank_; ++k) reflect(k, mirrored);
    Vec6 a;
    mirrored.store(a.at);
    for (int i = rank_; i-- > 0;) {
      for (int k = i + 1; k < rank_; ++k) a[i] -= lower_[k][i] * a[k];
      a[i] *= inverse_[i];
    }
    for (std::uint32_t row = 0; row < rows_; ++row) to(row, is_implied(row) ? Real(0) : a[place_[row]]);
  }

 private:
  RowOfTwos scaled(RowOfTwos a) const {
    a.multiply(RowOfTwos(scale_));
    return a;
  }
  void reflect(int k, RowOfTwos& a) const {
    const RowOfTwos mirror(mirror_[k]);
    a.add(twice_[k] * mirror.dot(a), mirror);
  }

  static constexpr Real kFrom[kDof][kDof] = {{1, 1, 1, 1, 1, 1}, {0, 1, 1, 1, 1, 1}, {0, 0, 1, 1, 1, 1},
                                             {0, 0, 0, 1, 1, 1}, {0, 0, 0, 0, 1, 1}, {0, 0, 0, 0, 0, 1}};
  static constexpr Real kUnit[kDof][kDof] = {{1, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0},
                                             {0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 0, 1}};
  Real scale_[kDof];
  std::uint32_t rows_ = 0;
  int rank_ = 0;
  std::uint8_t place_[kDof];  // of each row among those that others do not imply; kDof: they do
  Real lower_[kDof][kDof], inverse_[kDof], mirror_[kDof][kDof], twice_[kDof];
};

}  // namespace carom::dynamics
