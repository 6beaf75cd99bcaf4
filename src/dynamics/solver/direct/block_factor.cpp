// Right-looking Cholesky over blocks.
#include "dynamics/solver/direct/block_factor.h"

#include <algorithm>
#include <cstring>

namespace carom::dynamics {
namespace {

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

/// a := its lower Cholesky factor; what is above the diagonal is left.
bool factor(Block& a) {
  for (int j = 0; j < kDof; ++j) {
    Real d = a.x[j][j];
    for (int k = 0; k < j; ++k) d -= a.x[j][k] * a.x[j][k];
    // Rounding leaves d wrong by some units of the entry that it is what remains of.
    if (!(d > 4 * kEpsilon * a.x[j][j])) return false;
    d = std::sqrt(d);
    a.x[j][j] = d;
    for (int i = j + 1; i < kDof; ++i) {
      Real s = a.x[i][j];
      for (int k = 0; k < j; ++k) s -= a.x[i][k] * a.x[j][k];
      a.x[i][j] = s / d;
    }
  }
  return true;
}

Block transposed(const Block& a) {
  Block t;
  for (int i = 0; i < kDof; ++i)
    for (int j = 0; j < kDof; ++j) t.x[j][i] = a.x[i][j];
  return t;
}

/// a := a l^-T, for l lower triangular: column by column, each as a row of what is transposed.
void divide(Block& a, const Block& l) {
  Block t = transposed(a);
  for (int j = 0; j < kDof; ++j) {
    RowOfTwos column(t.x[j]);
    for (int k = 0; k < j; ++k) column.subtract(l.x[j][k], RowOfTwos(t.x[k]));
    column.divide(l.x[j][j]);
    column.store(t.x[j]);
  }
  a = transposed(t);
}

/// c -= a b, b given as it stands.
void subtract_product(Block& c, const Block& a, const Block& b) {
  for (int i = 0; i < kDof; ++i) {
    RowOfTwos row(c.x[i]);
    for (int k = 0; k < kDof; ++k) row.subtract(a.x[i][k], RowOfTwos(b.x[k]));
    row.store(c.x[i]);
  }
}

}  // namespace

std::size_t BlockFactor::at(const Elimination& e, std::uint32_t row, std::uint32_t column) const {
  const auto begin = e.rows.begin() + e.column[column], end = e.rows.begin() + e.column[column + 1];
  return static_cast<std::size_t>(std::lower_bound(begin, end, row) - e.rows.begin());
}

bool factor(const Elimination& e, std::uint32_t first, std::uint32_t last, BlockFactor& f) {
  for (std::uint32_t j = first; j < last; ++j) {
    if (!factor(f.diagonal[j])) return false;
    const std::uint32_t begin = e.column[j], end = e.column[j + 1];
    for (std::uint32_t k = begin; k < end; ++k) divide(f.below[k], f.diagonal[j]);
    for (std::uint32_t l = begin; l < end; ++l) {
      const std::uint32_t column = e.rows[l];
      const Block t = transposed(f.below[l]);
      subtract_product(f.diagonal[column], f.below[l], t);
      // Every later row of this column is a row of that one too: walk both.
      std::uint32_t at = e.column[column];
      for (std::uint32_t k = l + 1; k < end; ++k) {
        while (e.rows[at] != e.rows[k]) ++at;
        subtract_product(f.below[at], f.below[k], t);
      }
    }
  }
  return true;
}

void solve(const Elimination& e, std::uint32_t first, std::uint32_t last, const BlockFactor& f, Vec6* x) {
  for (std::uint32_t j = first; j < last; ++j) {
    const Block& l = f.diagonal[j];
    for (int i = 0; i < kDof; ++i) {
      Real s = x[j][i];
      for (int k = 0; k < i; ++k) s -= l.x[i][k] * x[j][k];
      x[j][i] = s / l.x[i][i];
    }
    for (std::uint32_t k = e.column[j]; k < e.column[j + 1]; ++k)
      for (int i = 0; i < kDof; ++i)
        for (int c = 0; c < kDof; ++c) x[e.rows[k]][i] -= f.below[k].x[i][c] * x[j][c];
  }
  for (std::uint32_t j = last; j-- > first;) {
    for (std::uint32_t k = e.column[j]; k < e.column[j + 1]; ++k)
      for (int i = 0; i < kDof; ++i)
        for (int c = 0; c < kDof; ++c) x[j][c] -= f.below[k].x[i][c] * x[e.rows[k]][i];
    const Block& l = f.diagonal[j];
    for (int i = kDof; i-- > 0;) {
      Real s = x[j][i];
      for (int k = i + 1; k < kDof; ++k) s -= l.x[k][i] * x[j][k];
      x[j][i] = s / l.x[i][i];
    }
  }
}

}  // namespace carom::dynamics
