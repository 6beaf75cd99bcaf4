// Right-looking Cholesky over blocks.
#include "dynamics/solver/direct/block_factor.h"

#include <algorithm>
#include <functional>

namespace carom::dynamics {
namespace {

/// The row of a child, moved over to its parent; what is left is what its joint leaves free.
void hand_over_row(const Elimination& e, std::uint32_t child, const TreeNode& node, const BlockFactor& of,
                   const Blocks& f) {
  const std::uint32_t parent = node.parent;
  std::uint32_t at_parent = 0;
  for (std::uint32_t k = e.column[child]; k < e.column[child + 1]; ++k) {
    if (e.rows[k] == parent) at_parent = k;
    if (!f.is_filled[k]) continue;
    const auto row = [&](int i) { return row_of(f.beside[k], i); };
    if (e.rows[k] > parent) {
      add_handed_over(row, node.arm, f.filled(of.at(e, e.rows[k], parent)));
      continue;
    }
    Block taken;
    set_zero(taken);
    add_handed_over(row, node.arm, taken);
    if (e.rows[k] < parent) {
      add_transposed(f.filled(of.at(e, parent, e.rows[k])), taken);
    } else {
      each_row([&](int i) { add_to_row(f.diagonal[parent], i, row_of(taken, i)); });
      add_transposed(f.diagonal[parent], taken);
    }
  }
  const auto along = [&](int i) { return taken_along(row_of(f.diagonal[child], i), node.arm); };
  Block& beside_parent = f.filled(at_parent);
  each_row([&](int i) { add_to_row(beside_parent, i, along(i)); });
  add_handed_over(along, node.arm, f.diagonal[parent]);
}

}  // namespace

std::size_t BlockFactor::at(const Elimination& e, std::uint32_t later, std::uint32_t earlier) const {
  const auto begin = e.rows.begin() + e.column[earlier], end = e.rows.begin() + e.column[earlier + 1];
  return static_cast<std::size_t>(std::lower_bound(begin, end, later) - e.rows.begin());
}

namespace {

/// Block products of a row with so many blocks beside the diagonal.
std::uint64_t products_of(std::uint64_t filled) { return 1 + filled + filled * (filled + 1) / 2; }

/// The row of a child: what its joint leaves free of it, @see TreeNode. Most have nothing beside the diagonal.
template <class N>
bool factor_child(const Elimination& e, std::uint32_t j, TreeNode& node, const Blocks& f, N n) {
  if (!free_column(f.diagonal[j], node.basis, &node.driven, node.by_all, n)) return false;
  for (std::uint32_t k = e.column[j]; k < e.column[j + 1]; ++k) {
    if (!f.is_filled[k]) continue;
    Block freed;
    free_rows(f.beside[k], node.basis, freed, n);
    solve_rows(node.by_all.factor, freed, n);
    for (int i = 0; i < n; ++i) row_of(freed, i).store(f.beside[k].x[i]);
  }
  return true;
}

/// What a row of n unknowns leaves of those after it. Apart from its caller, where compilers run out of registers.
template <class N>
[[gnu::noinline]] void subtract_row(const Elimination& e, std::uint32_t j, const Blocks& f, N n) {
  const std::uint32_t begin = e.column[j], end = e.column[j + 1];
  for (std::uint32_t l = begin; l < end; ++l) {
    if (!f.is_filled[l]) continue;
    const std::uint32_t row = e.rows[l];
    const Block& a = f.beside[l];
    subtract_product(f.diagonal[row], a, a, n);
    // Each later one of this row is one of that row too: walk both.
    std::uint32_t at = e.column[row];
    for (std::uint32_t k = l + 1; k < end; ++k) {
      if (!f.is_filled[k]) continue;
      while (e.rows[at] != e.rows[k]) ++at;
      subtract_product(f.filled(at), a, f.beside[k], n);
    }
  }
}

}  // namespace

std::uint64_t factor(const Elimination& e, std::uint32_t first, std::uint32_t last, std::span<TreeNode> tree,
                     BlockFactor& of) {
  const Blocks f = of.all();
  std::uint64_t products = 0;
  for (std::uint32_t j = first; j < last; ++j) {
    TreeNode* const node = tree.empty() ? nullptr : &tree[j - first];
    if (!node || !node->is_held()) {
      if (node && !node->is_stale) continue;
      if (!factor_in_place(f.diagonal[j])) return 0;
      std::uint64_t filled = 0;
      for (std::uint32_t k = e.column[j]; k < e.column[j + 1]; ++k)
        if (f.is_filled[k]) solve_rows(f.diagonal[j], f.beside[k], WholeBlock()), ++filled;
      products += products_of(filled);
      subtract_row(e, j, f, WholeBlock());
      continue;
    }
    if (node->is_stale) {
      node->is_bare = std::none_of(f.is_filled + e.column[j], f.is_filled + e.column[j + 1], std::identity());
      if (node->parent != kInvalid && !node->is_bare) hand_over_row(e, j, *node, of, f);
    }
    const bool is_definite = with_freedom(node->freedom, [&](auto n) {
      if (node->is_stale && !factor_child(e, j, *node, f, n)) return false;
      if (!node->is_bare && node->is_stale) subtract_row(e, j, f, n);
      if (node->is_bare && node->parent != kInvalid && tree[node->parent - first].is_stale)
        add_left(f.diagonal[j], node->by_all, node->arm, f.diagonal[node->parent], n);
      return true;
    });
    if (!is_definite) return 0;
    if (node->is_stale) {
      const auto *const begin = f.is_filled + e.column[j], *const end = f.is_filled + e.column[j + 1];
      products += products_of(node->is_bare ? 0 : static_cast<std::uint64_t>(std::count(begin, end, 1)));
    }
  }
  return std::max<std::uint64_t>(products, 1);
}

namespace {

/// Forwards and backwards through the row of a node with n unknowns.
template <class N>
void take_from_later(const Elimination& e, std::uint32_t j, const BlockFactor& f, Vec6* x, N n) {
  for (std::uint32_t k = e.column[j]; k < e.column[j + 1]; ++k) {
    if (!f.is_filled[k]) continue;
    RowOfTwos later = row_of(x[e.rows[k]]);
    for (int c = 0; c < n; ++c) later.subtract(x[j][c], row_of(f.beside[k], c));
    later.store(x[e.rows[k]].at);
  }
}
template <class N>
void take_from_this(const Elimination& e, std::uint32_t j, const BlockFactor& f, Vec6* x, N n) {
  for (std::uint32_t k = e.column[j]; k < e.column[j + 1]; ++k) {
    if (!f.is_filled[k]) continue;
    const RowOfTwos later = row_of(x[e.rows[k]]);
    for (int c = 0; c < n; ++c) x[j][c] -= row_of(f.beside[k], c).dot(later);
  }
}

}  // namespace

void solve(const Elimination& e, std::uint32_t first, std::uint32_t last, std::span<TreeNode> tree,
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
    with_freedom(node->freedom, [&](auto n) {
      RowOfTwos momentum = row_of(x[j]);
      if (node->is_bare) {
        x[j] = take_freely(*node, node->by_all, momentum, n);
        if (node->parent != kInvalid) add_to(x[node->parent], handed_over(*node, momentum));
        return;
      }
      if (node->parent != kInvalid) add_to(x[node->parent], handed_over(*node, momentum));
      x[j] = freely_pushed(*node, momentum, n);
      solve_lower(node->by_all.factor, x[j], n);
      take_from_later(e, j, f, x, n);
    });
  }
  for (std::uint32_t j = last; j-- > first;) {
    TreeNode* const node = child(j);
    if (!node) {
      take_from_this(e, j, f, x, WholeBlock());
      solve_upper(f.diagonal[j], x[j]);
      continue;
    }
    with_freedom(node->freedom, [&](auto n) {
      RowOfTwos along = RowOfTwos::zero();
      if (node->parent != kInvalid) along = with_parent(*node, row_of(x[node->parent]));
      if (node->is_bare) {
        x[j] = go_freely(node->by_all, x[j], along, n);
      } else {
        take_from_this(e, j, f, x, n);
        solve_upper(node->by_all.factor, x[j], n);
      }
      node->q = x[j];
      add_free(*node, node->q, along, n);
      along.store(x[j].at);
    });
  }
}

}  // namespace carom::dynamics
