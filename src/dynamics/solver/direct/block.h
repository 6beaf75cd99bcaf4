// Six by six numbers, and what is done with them.
#pragma once

#include <cstring>
#include <type_traits>

#include "core/vec6.h"

namespace carom::dynamics {

inline constexpr int kDof = 6;  // of a body: velocity, angular velocity

/// Row by row.
struct alignas(16) Block {
  Real x[kDof][kDof];
};

/// Two numbers side by side. Each goes through the operations that it would go through alone, so bits are the same.
using TwoReals = double __attribute__((vector_size(2 * sizeof(double))));
constexpr int kTwos = kDof / 2;

/// A row of a block.
struct RowOfTwos {
  TwoReals at[kTwos];
  explicit RowOfTwos(const Real* row) { std::memcpy(at, row, sizeof at); }
  void store(Real* row) const { std::memcpy(row, at, sizeof at); }
  void subtract(Real s, const RowOfTwos& o) {
    const TwoReals both = {s, s};
    for (int j = 0; j < kTwos; ++j) at[j] -= both * o.at[j];
  }
  void divide(Real by) {
    const TwoReals both = {by, by};
    for (int j = 0; j < kTwos; ++j) at[j] /= both;
  }
};

inline bool is_zero(const Block& a) {
  bool any = false;
  for (int i = 0; i < kDof; ++i)
    for (int j = 0; j < kDof; ++j) any |= a.x[i][j] != 0;
  return !any;
}

inline void add(Block& c, const Block& a) {
  for (int i = 0; i < kDof; ++i)
    for (int j = 0; j < kDof; ++j) c.x[i][j] += a.x[i][j];
}

// Sizes below are numbers or, where a compiler is to unroll loops, constants.
using WholeBlock = std::integral_constant<int, kDof>;

/// The first n columns as rows.
template <class N>
Block transposed(const Block& a, N n) {
  Block t;
  for (int k = 0; k < n; ++k)
    for (int i = 0; i < kDof; ++i) t.x[k][i] = a.x[i][k];
  return t;
}
inline Block transposed(const Block& a) { return transposed(a, WholeBlock()); }

/// c -= a b, of n columns of a and rows of b.
template <class N>
void subtract_product(Block& c, const Block& a, const Block& b, N n) {
  for (int i = 0; i < kDof; ++i) {
    RowOfTwos row(c.x[i]);
    for (int k = 0; k < n; ++k) row.subtract(a.x[i][k], RowOfTwos(b.x[k]));
    row.store(c.x[i]);
  }
}

/// a := its lower Cholesky factor, of the first n rows and columns; what is above the diagonal is left.
/// @return whether it was definite
template <class N = WholeBlock>
bool factor_in_place(Block& a, N n = {}) {
  for (int j = 0; j < n; ++j) {
    Real d = a.x[j][j];
    for (int k = 0; k < j; ++k) d -= a.x[j][k] * a.x[j][k];
    // Rounding leaves d wrong by some units of the entry that it is what remains of.
    if (!(d > 4 * kEpsilon * a.x[j][j])) return false;
    d = std::sqrt(d);
    a.x[j][j] = d;
    for (int i = j + 1; i < n; ++i) {
      Real s = a.x[i][j];
      for (int k = 0; k < j; ++k) s -= a.x[i][k] * a.x[j][k];
      a.x[i][j] = s / d;
    }
  }
  return true;
}

/// a := a l^-T, for l lower triangular: column by column, each as a row of what is transposed.
inline void divide(Block& a, const Block& l) {
  Block t = transposed(a);
  for (int j = 0; j < kDof; ++j) {
    RowOfTwos column(t.x[j]);
    for (int k = 0; k < j; ++k) column.subtract(l.x[j][k], RowOfTwos(t.x[k]));
    column.divide(l.x[j][j]);
    column.store(t.x[j]);
  }
  a = transposed(t);
}

/// The first n equations of a lower triangular matrix, or of its transpose.
template <class N = WholeBlock>
void solve_lower(const Block& l, Vec6& y, N n = {}) {
  for (int i = 0; i < n; ++i) {
    Real s = y[i];
    for (int k = 0; k < i; ++k) s -= l.x[i][k] * y[k];
    y[i] = s / l.x[i][i];
  }
}
template <class N = WholeBlock>
void solve_upper(const Block& l, Vec6& y, N n = {}) {
  for (int i = n; i-- > 0;) {
    Real s = y[i];
    for (int k = i + 1; k < n; ++k) s -= l.x[k][i] * y[k];
    y[i] = s / l.x[i][i];
  }
}

}  // namespace carom::dynamics
