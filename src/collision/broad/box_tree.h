// A binary tree of boxes: which of the boxes in it does this one overlap. Leaves are named by small numbers.
#pragma once

#include <array>

#include "collision/broad/bounds.h"

namespace carom {

/// Every node's box encloses those below it. Leaves come and go one by one, by surface area; build() makes the whole
/// tree afresh and balanced. Which leaves a query finds depends on the boxes alone, never on how the tree came to be.
class BoxTree {
 public:
  explicit BoxTree(Memory* m) : nodes_(m), leaf_(m), items_(m), stack_(m) {}

  /// Leaves may from here on be numbered below `leaves`.
  void grow(std::size_t leaves) {
    if (leaf_.size() < leaves) leaf_.resize(leaves, kNone);
  }
  void clear();
  std::size_t size() const { return size_; }

  /// Replace all leaves. Depth log2 n, nodes in the order in which a query visits them. O(n log n).
  /// @param boxes  by leaf; finite, not empty
  void build(const Array<std::uint32_t>& leaves, const Array<Aabb>& boxes);

  /// Put a leaf beside the node where the surfaces of all enclosing boxes grow least.
  /// @return the depth at which it ended
  std::size_t insert(std::uint32_t leaf, const Aabb& box);
  void remove(std::uint32_t leaf);

  /// Call found(leaf) for every leaf whose box overlaps (closed), in an order that means nothing.
  /// @param box  not empty; may be unbounded
  /// @return     boxes compared
  template <class Found>
  std::uint64_t query(const Aabb& box, Found&& found);

  /// Call found(one, other) once for every two leaves whose boxes overlap. Half of what a query for each would cost.
  /// @return boxes compared
  template <class Found>
  std::uint64_t each_pair(Found&& found);

 private:
  template <class Found>
  std::uint64_t descend(const HeldBox& box, std::uint32_t from, Found&& found);

  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  struct Node {
    Aabb box;
    std::uint32_t parent;    // kNone at the root; the next free node in a free one
    std::uint32_t child[2];  // kNone and the leaf's number in a leaf
    bool is_leaf() const { return child[0] == kNone; }
  };
  static_assert(sizeof(Node) == 64, "a cache line");

  /// A leaf while the tree is built: the comparisons are all about its centre.
  struct Item {
    std::array<Real, 3> center;  // m
    std::uint32_t leaf;
  };

  std::uint32_t take_node();
  void grow_stack();
  void free_node(std::uint32_t node);
  void replace_child(std::uint32_t parent, std::uint32_t from, std::uint32_t to);

  Array<Node> nodes_;
  Array<std::uint32_t> leaf_;   // by leaf: its node, or kNone
  Array<Item> items_;           // while building
  Array<std::uint32_t> stack_;  // [leaves + 1] of a query: no way down is longer
  std::uint32_t root_ = kNone, free_ = kNone;
  std::size_t size_ = 0;
};

template <class Found>
std::uint64_t BoxTree::descend(const HeldBox& box, std::uint32_t from, Found&& found) {
  std::uint64_t tests = 1;
  if (!box.overlaps(nodes_[from].box)) return tests;
  const Node* const nodes = nodes_.data();
  std::uint32_t* const stack = stack_.data();
  std::uint32_t* top = stack;
  *top++ = from;
  while (top > stack) {
    const Node& node = nodes[*--top];
    if (node.is_leaf()) {
      found(node.child[1]);
      continue;
    }
    tests += 2;
    *top = node.child[1];
    top += box.overlaps(nodes[node.child[1]].box);
    *top = node.child[0];
    top += box.overlaps(nodes[node.child[0]].box);
  }
  return tests;
}

template <class Found>
std::uint64_t BoxTree::query(const Aabb& box, Found&& found) {
  if (root_ == kNone) return 0;
  return descend(HeldBox(box), root_, found);
}

/// Of two leaves, one is below the first child of the node at which their ways to the root meet: it finds the other.
template <class Found>
std::uint64_t BoxTree::each_pair(Found&& found) {
  std::uint64_t tests = 0;
  for (std::uint32_t leaf = 0; leaf < leaf_.size(); ++leaf) {
    std::uint32_t node = leaf_[leaf];
    if (node == kNone) continue;
    const HeldBox box(nodes_[node].box);
    for (std::uint32_t above = nodes_[node].parent; above != kNone; node = above, above = nodes_[node].parent)
      if (nodes_[above].child[0] == node)
        tests += descend(box, nodes_[above].child[1], [&](std::uint32_t other) { found(leaf, other); });
  }
  return tests;
}

}  // namespace carom
