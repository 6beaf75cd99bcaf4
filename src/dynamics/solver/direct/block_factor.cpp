// Right-looking Cholesky over blocks.
#include "dynamics/solver/direct/block_factor.h"

#include <algorithm>

namespace carom::dynamics {
namespace {

/// The column of a child, moved over to its parent; what is left is what its joint leaves free.
void hand_over_column(const Elimination& e, std::uint32_t child, const TreeNode& node, BlockFactor& f) {
  const std::uint32_t parent = node.parent;
  std::uint32_t at_parent = 0;
  for (std::uint32_t k = e.column[child]; k < e.column[child + 1]; ++k) {
    if (e.rows[k] == parent) at_parent = k;
    if (is_zero(f.below[k])) continue;
    Block taken = f.below[k];
    take_along(taken, node.arm);
    if (e.rows[k] == parent) {
      add(f.diagonal[parent], taken), add(f.diagonal[parent], transposed(taken));
    } else if (e.rows[k] > parent) {
      add(f.below[f.at(e, e.rows[k], parent)], taken);
    } else {
      add(f.below[f.at(e, parent, e.rows[k])], transposed(taken));
    }
  }
  Block own = f.diagonal[child];
  hand_over(own, node.arm);
  add(f.below[at_parent], own);
  take_along(own, node.arm);
  add(f.diagonal[parent], own);
}

}  // namespace

std::size_t BlockFactor::at(const Elimination& e, std::uint32_t row, std::uint32_t column) const {
  const auto begin = e.rows.begin() + e.column[column], end = e.rows.begin() + e.column[column + 1];
  return static_cast<std::size_t>(std::lower_bound(begin, end, row) - e.rows.begin());
}

namespace {

/// The column of a child: what its joint leaves free of it, @see TreeNode.
template <class N>
bool factor_child(const Elimination& e, std::uint32_t j, const TreeNode& node, BlockFactor& f, N n) {
  Block diagonal;
  if (!factor_freed(f.diagonal[j], node.basis, &node.driven, diagonal, n)) return false;
  f.diagonal[j] = diagonal;
  for (std::uint32_t k = e.column[j]; k < e.column[j + 1]; ++k) {
    const Block whole = f.below[k];
    free_columns(whole, node.basis, diagonal, f.below[k], n);
  }
  return true;
}

/// What a column of n unknowns leaves of those after it. Apart from its caller, where compilers run out of registers.
template <class N>
[[gnu::noinline]] void subtract_column(const Elimination& e, std::uint32_t j, BlockFactor& f, N n) {
  const std::uint32_t begin = e.column[j], end = e.column[j + 1];
  for (std::uint32_t l = begin; l < end; ++l) {
    const std::uint32_t column = e.rows[l];
    const Block t = transposed(f.below[l], n);
    subtract_product(f.diagonal[column], f.below[l], t, n);
    // Every later row of this column is a row of that one too: walk both.
    std::uint32_t at = e.column[column];
    for (std::uint32_t k = l + 1; k < end; ++k) {
      while (e.rows[at] != e.rows[k]) ++at;
      subtract_product(f.below[at], f.below[k], t, n);
    }
  }
}

}  // namespace

bool factor(const Elimination& e, std::uint32_t first, std::uint32_t last, std::span<const TreeNode> tree,
            BlockFactor& f) {
  for (std::uint32_t j = first; j < last; ++j) {
    if (!tree.empty() && tree[j - first].is_held()) {
      const TreeNode& node = tree[j - first];
      if (node.parent != kInvalid) hand_over_column(e, j, node, f);
      const bool is_definite = with_freedom(node.freedom, [&](auto n) {
        if (!factor_child(e, j, node, f, n)) return false;
        subtract_column(e, j, f, n);
        return true;
      });
      if (!is_definite) return false;
      continue;
    }
    if (!factor_in_place(f.diagonal[j])) return false;
    for (std::uint32_t k = e.column[j]; k < e.column[j + 1]; ++k) divide(f.below[k], f.diagonal[j]);
    subtract_column(e, j, f, WholeBlock());
  }
  return true;
}

namespace {

/// Forwards and backwards through the column of a node with n unknowns.
template <class N>
void take_from_later(const Elimination& e, std::uint32_t j, const BlockFactor& f, Vec6* x, N n) {
  for (std::uint32_t k = e.column[j]; k < e.column[j + 1]; ++k)
    for (int i = 0; i < kDof; ++i)
      for (int c = 0; c < n; ++c) x[e.rows[k]][i] -= f.below[k].x[i][c] * x[j][c];
}
template <class N>
void take_from_this(const Elimination& e, std::uint32_t j, const BlockFactor& f, Vec6* x, N n) {
  for (std::uint32_t k = e.column[j]; k < e.column[j + 1]; ++k)
    for (int i = 0; i < kDof; ++i)
      for (int c = 0; c < n; ++c) x[j][c] -= f.below[k].x[i][c] * x[e.rows[k]][i];
}

}  // namespace

void solve(const Elimination& e, std::uint32_t first, std::uint32_t last, std::span<const TreeNode> tree,
           const BlockFactor& f, Vec6* x) {
  const auto child = [&](std::uint32_t j) {
    return !tree.empty() && tree[j - first].is_held() ? &tree[j - first] : nullptr;
  };
  for (std::uint32_t j = first; j < last; ++j) {
    const TreeNode* const node = child(j);
    if (!node) {
      solve_lower(f.diagonal[j], x[j]);
      take_from_later(e, j, f, x, WholeBlock());
      continue;
    }
    if (node->parent != kInvalid) x[node->parent] += handed_over(*node, x[j]);
    with_freedom(node->freedom, [&](auto n) {
      x[j] = freely(*node, x[j], n);
      solve_lower(f.diagonal[j], x[j], n);
      take_from_later(e, j, f, x, n);
    });
  }
  for (std::uint32_t j = last; j-- > first;) {
    const TreeNode* const node = child(j);
    if (!node) {
      take_from_this(e, j, f, x, WholeBlock());
      solve_upper(f.diagonal[j], x[j]);
      continue;
    }
    with_freedom(node->freedom, [&](auto n) {
      take_from_this(e, j, f, x, n);
      solve_upper(f.diagonal[j], x[j], n);
      const Vec6 q = x[j];
      x[j] = node->parent != kInvalid ? with_parent(*node, x[node->parent]) : Vec6::zero();
      add_free(*node, q, x[j], n);
    });
  }
}

}  // namespace carom::dynamics
