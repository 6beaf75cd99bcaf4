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
  explicit LockedRows(Real size) : inv_size_(1 / size) {}

  /// What others do not imply of it is a lock of its own.
  void add(const Vec6& row) {
    constexpr Real kImplied = 1e-9;
    Vec6 a = scaled(row);
    const Real whole2 = a.squared_norm();
    for (int k = 0; k < rank_; ++k) reflect(k, a);
    Real tail2 = 0;
    for (int c = rank_; c < kDof; ++c) tail2 += a[c] * a[c];
    if (rank_ == kDof || !(tail2 > kImplied * kImplied * whole2)) {
      place_[rows_++] = kDof;
      return;
    }
    const Real tail = a[rank_] > 0 ? -std::sqrt(tail2) : std::sqrt(tail2), inverse = 1 / tail;
    for (int c = 0; c < rank_; ++c) lower_[rank_][c] = a[c];
    inverse_[rank_] = inverse;
    for (int c = 0; c < kDof; ++c) mirror_[rank_][c] = c < rank_ ? 0 : a[c];
    mirror_[rank_][rank_] -= tail;
    twice_[rank_] = inverse / mirror_[rank_][rank_];
    place_[rows_++] = static_cast<std::uint8_t>(rank_++);
  }

  int freedom() const { return kDof - rank_; }
  bool is_implied(std::uint32_t row) const { return place_[row] == kDof; }
  /// A velocity that none of them locks.   @param k  below freedom()
  Vec6 free(int k) const {
    Vec6 a = Vec6::zero();
    a[rank_ + k] = 1;
    for (int i = rank_; i-- > 0;) reflect(i, a);
    return scaled(a);
  }
  /// The least velocity that has so much along each row.   @param along  (row) -> m/s; not asked of implied ones
  template <class F>
  Vec6 velocity(const F& along) const {
    Vec6 a = Vec6::zero();
    for (std::uint32_t row = 0; row < rows_; ++row) {
      const int i = place_[row];
      if (i == kDof) continue;
      Real s = along(row);
      for (int k = 0; k < i; ++k) s -= lower_[i][k] * a[k];
      a[i] = s * inverse_[i];
    }
    for (int i = rank_; i-- > 0;) reflect(i, a);
    return scaled(a);
  }
  /// Impulses of the rows that give so much momentum, of what they resist.   @param to  (row, impulse); of implied ones 0
  template <class F>
  void find_impulses(const Vec6& momentum, const F& to) const {
    Vec6 a = scaled(momentum);
    for (int k = 0; k < rank_; ++k) reflect(k, a);
    for (int i = rank_; i-- > 0;) {
      for (int k = i + 1; k < rank_; ++k) a[i] -= lower_[k][i] * a[k];
      a[i] *= inverse_[i];
    }
    for (std::uint32_t row = 0; row < rows_; ++row) to(row, is_implied(row) ? Real(0) : a[place_[row]]);
  }

 private:
  Vec6 scaled(const Vec6& a) const { return {a.linear(), inv_size_ * a.angular()}; }
  void reflect(int k, Vec6& a) const {
    Real s = 0;
    for (int c = k; c < kDof; ++c) s += mirror_[k][c] * a[c];
    s *= twice_[k];
    for (int c = k; c < kDof; ++c) a[c] += s * mirror_[k][c];
  }

  Real inv_size_;
  std::uint32_t rows_ = 0;
  int rank_ = 0;
  std::uint8_t place_[kDof];  // of each row among those that others do not imply; kDof: they do
  Real lower_[kDof][kDof], inverse_[kDof], mirror_[kDof][kDof], twice_[kDof];
};

}  // namespace carom::dynamics
