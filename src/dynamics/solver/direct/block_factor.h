// A symmetric positive definite matrix of 6x6 blocks, one row of blocks a body, and its Cholesky factor in place.
#pragma once

#include "core/vec6.h"
#include "dynamics/solver/direct/elimination.h"

namespace carom::dynamics {

inline constexpr int kDof = 6;  // of a body: velocity, angular velocity

/// Row by row.
struct alignas(16) Block {
  Real x[kDof][kDof];
};

/// Of a matrix that has its blocks where a factor has them.
struct Blocks {
  Block *diagonal, *below;
};

struct BlockFactor {
  explicit BlockFactor(Memory* m) : diagonal(m), below(m) {}
  // Of all systems; then, where there are joints, as many of what their matrices have in common: @see common()
  Array<Block> diagonal;  // by place
  Array<Block> below;     // [Elimination::rows]

  Blocks all() { return {diagonal.data(), below.data()}; }
  Blocks common(const Elimination& e) { return {diagonal.data() + e.place.size(), below.data() + e.rows.size()}; }

  /// Where the block (row, column) below the diagonal is. Both are places, row > column, and the block is in the
  /// factor.
  std::size_t at(const Elimination& e, std::uint32_t row, std::uint32_t column) const;
};

/// Factor the columns [first, last) of one system.
/// @return false: a pivot was not positive, the matrix was not definite within rounding; the factor is of no use
bool factor(const Elimination& e, std::uint32_t first, std::uint32_t last, BlockFactor& f);

/// Solve with a factor, in place.
/// @param x  by place
void solve(const Elimination& e, std::uint32_t first, std::uint32_t last, const BlockFactor& f, Vec6* x);

}  // namespace carom::dynamics
