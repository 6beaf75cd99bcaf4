// A sparse matrix of n x n blocks, one row of blocks a joint, and its factors L U in place, without pivoting.
//
// It is J1 M^-1 J0^T, velocities along rows of one pose by impulses along those of another: symmetric where the two are
// the same pose, and near it else. A row that others imply has nothing left on the diagonal: it bears nothing, and
// neither row nor column of it count. Which rows these are is found where the matrix is symmetric.
#pragma once

#include "dynamics/joint/rattle/rattle.h"

namespace carom::dynamics::rattle {

/// Where the blocks of one island are.
struct BlockPlaces {
  std::uint32_t rows;  // of a block
  const Elimination* order;
  std::uint32_t first, last;       // places
  Real *diagonal, *below, *above;  // of places from the first; of rows of the order from the first's

  Real* at_diagonal(std::uint32_t place) const { return diagonal + rows * rows * (place - first); }
  Real* at_below(std::uint32_t row) const { return below + rows * rows * (row - order->column[first]); }
  Real* at_above(std::uint32_t row) const { return above + rows * rows * (row - order->column[first]); }
  /// Where the block (row, column) is, which is in the factor; places, row > column.
  std::uint32_t find(std::uint32_t row, std::uint32_t column) const {
    const std::uint32_t* const begin = order->rows.data() + order->column[column];
    const std::uint32_t* const end = order->rows.data() + order->column[column + 1];
    return static_cast<std::uint32_t>(std::lower_bound(begin, end, row) - order->rows.data());
  }
};

/// What goes over all numbers of blocks: compiled for each size.
template <int n>
struct BlocksOf : BlockPlaces {
  static constexpr int kSize = n * n;

  /// a -= b c.
  static void subtract(Real* a, const Real* b, const Real* c) {
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < n; ++k) {
        const Real s = b[n * i + k];
        for (int j = 0; j < n; ++j) a[n * i + j] -= s * c[n * k + j];
      }
  }
  /// y -= a x.
  static void subtract_from(Real* y, const Real* a, const Real* x) {
    for (int i = 0; i < n; ++i) {
      Real sum = 0;
      for (int j = 0; j < n; ++j) sum += a[n * i + j] * x[j];
      y[i] -= sum;
    }
  }

  /// a := its inverse, of the rows that are not implied; zero in those that are.
  /// @param own  by row, what it was before others were eliminated; 0: implied   @param find_implied  and which are
  static void invert(Real* a, Real* own, bool find_implied) {
    for (int k = 0; k < n; ++k) {
      const Real pivot = a[n * k + k];
      const bool is_implied = find_implied ? !(std::fabs(pivot) > kRattleRest * std::fabs(own[k])) : own[k] == 0;
      if (is_implied) own[k] = 0;
      if (is_implied || pivot == 0) {
        for (int j = 0; j < n; ++j) a[n * k + j] = a[n * j + k] = 0;
        continue;
      }
      const Real inverse = 1 / pivot;
      for (int j = 0; j < n; ++j) a[n * k + j] *= inverse;
      a[n * k + k] = inverse;
      for (int i = 0; i < n; ++i) {
        if (i == k) continue;
        const Real s = a[n * i + k];
        a[n * i + k] = 0;
        for (int j = 0; j < n; ++j) a[n * i + j] -= s * a[n * k + j];
      }
    }
  }

  /// @param own  [places][n]: @see invert()
  void factor(Real* own, bool find_implied) const {
    for (std::uint32_t k = first; k < last; ++k) {
      Real* const d = at_diagonal(k);
      invert(d, own + n * (k - first), find_implied);
      const std::uint32_t begin = order->column[k], end = order->column[k + 1];
      for (std::uint32_t i = begin; i < end; ++i) {
        Real* const b = at_below(i);
        Real l[kSize] = {};
        subtract(l, b, d);
        for (int j = 0; j < kSize; ++j) b[j] = -l[j];
      }
      for (std::uint32_t i = begin; i < end; ++i) {
        subtract(at_diagonal(order->rows[i]), at_below(i), at_above(i));
        for (std::uint32_t j = begin; j < i; ++j) {
          const std::uint32_t at = find(order->rows[i], order->rows[j]);
          subtract(at_below(at), at_below(i), at_above(j));
          subtract(at_above(at), at_below(j), at_above(i));
        }
      }
    }
  }

  /// In place.   @param x  [places][n]
  void solve(Real* x) const {
    for (std::uint32_t k = first; k < last; ++k)
      for (std::uint32_t i = order->column[k]; i < order->column[k + 1]; ++i)
        subtract_from(x + n * (order->rows[i] - first), at_below(i), x + n * (k - first));
    for (std::uint32_t k = last; k-- > first;) {
      Real* const own = x + n * (k - first);
      for (std::uint32_t i = order->column[k]; i < order->column[k + 1]; ++i)
        subtract_from(own, at_above(i), x + n * (order->rows[i] - first));
      const Real* const d = at_diagonal(k);
      Real y[n];
      for (int i = 0; i < n; ++i) {
        y[i] = 0;
        for (int j = 0; j < n; ++j) y[i] += d[n * i + j] * own[j];
      }
      for (int i = 0; i < n; ++i) own[i] = y[i];
    }
  }
};

/// The matrix of one island.
struct Blocks : BlockPlaces {
  void factor(Real* own, bool find_implied) const {
    with_size([&](const auto& blocks) { blocks.factor(own, find_implied); });
  }
  void solve(Real* x) const {
    with_size([&](const auto& blocks) { blocks.solve(x); });
  }

 private:
  template <class F>
  void with_size(F&& f) const {
    switch (rows) {
      case 1:
        return f(BlocksOf<1>{*this});
      case 2:
        return f(BlocksOf<2>{*this});
      case 3:
        return f(BlocksOf<3>{*this});
      case 4:
        return f(BlocksOf<4>{*this});
      case 5:
        return f(BlocksOf<5>{*this});
      default:
        return f(BlocksOf<6>{*this});
    }
  }
};

}  // namespace carom::dynamics::rattle
