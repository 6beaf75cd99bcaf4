// A symmetric positive definite matrix of 6x6 blocks, one row of blocks a body, and its Cholesky factor in place.
#pragma once

#include "dynamics/solver/direct/elimination.h"
#include "dynamics/solver/direct/tree_node.h"

namespace carom::dynamics {

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
/// @param tree  by place, from `first` on, or none: a child is what its joint leaves free, and its parent takes it along
/// @return false: a pivot was not positive, the matrix was not definite within rounding; the factor is of no use
bool factor(const Elimination& e, std::uint32_t first, std::uint32_t last, std::span<const TreeNode> tree,
            BlockFactor& f);

/// Solve with a factor, in place.
/// @param x  by place
void solve(const Elimination& e, std::uint32_t first, std::uint32_t last, std::span<const TreeNode> tree,
           const BlockFactor& f, Vec6* x);

}  // namespace carom::dynamics
