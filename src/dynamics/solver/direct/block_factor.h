// A symmetric positive definite matrix of 6x6 blocks, one row of blocks a body, from its diagonal on, and its Cholesky factor
// in place.
#pragma once

#include "dynamics/solver/direct/elimination.h"
#include "dynamics/solver/direct/tree_node.h"

namespace carom::dynamics {

/// Of a matrix that has its blocks where a factor has them.
struct Blocks {
  Block *diagonal, *beside;
  std::uint8_t* is_filled;  // of those beside the diagonal: others are zero, and no one reads them

  /// What is to be added to.
  Block& filled(std::size_t at) const {
    if (!is_filled[at]) is_filled[at] = 1, set_zero(beside[at]);
    return beside[at];
  }
};

struct BlockFactor {
  explicit BlockFactor(Memory* m) : diagonal(m), beside(m), is_filled(m) {}
  // Of all systems; then, where there are joints, as many of what their matrices have in common: @see common()
  Array<Block> diagonal;  // by place
  Array<Block> beside;    // [Elimination::rows]: rows are of the place eliminated first

  Array<std::uint8_t> is_filled;  // by block beside the diagonal

  Blocks all() { return {diagonal.data(), beside.data(), is_filled.data()}; }
  Blocks common(const Elimination& e) {
    return {diagonal.data() + e.place.size(), beside.data() + e.rows.size(), is_filled.data() + e.rows.size()};
  }

  /// Where the block of two places is, the later one first. It is in the factor.
  std::size_t at(const Elimination& e, std::uint32_t later, std::uint32_t earlier) const;
};

/// Factor the columns [first, last) of one system.
/// @param tree  by place, from `first` on, or none: a child is what its joint leaves free, and its parent takes it along.
///              What is not stale stays as it was factored last
/// @return block products that it took; 0: a pivot was not positive, the matrix was not definite within rounding; the factor is
///         of no use
std::uint64_t factor(const Elimination& e, std::uint32_t first, std::uint32_t last, std::span<TreeNode> tree,
                     BlockFactor& of);

/// Solve with a factor, in place.
/// @param x  by place
void solve(const Elimination& e, std::uint32_t first, std::uint32_t last, std::span<TreeNode> tree,
           const BlockFactor& f, Vec6* x);

}  // namespace carom::dynamics
