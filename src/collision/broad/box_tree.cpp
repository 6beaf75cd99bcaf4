// The tree of boxes: built by halves, changed leaf by leaf.
#include "collision/broad/box_tree.h"

#include <algorithm>

namespace carom {
namespace {

Aabb both(const Aabb& a, const Aabb& b) {
  Aabb u;
  u.lo = a.lo.cwiseMin(b.lo), u.hi = a.hi.cwiseMax(b.hi);
  return u;
}

/// Half the surface. Infinite, or not a number, at the far end of doubles: a tree is as right then, and less good.
Real surface(const Aabb& box) {
  const Vec3 s = box.hi - box.lo;
  return s.x() * s.y() + s.y() * s.z() + s.z() * s.x();
}

}  // namespace

void BoxTree::clear() {
  nodes_.clear();
  std::fill(leaf_.begin(), leaf_.end(), kNone);
  root_ = free_ = kNone;
  size_ = 0;
}

std::uint32_t BoxTree::take_node() {
  if (free_ == kNone) {
    nodes_.emplace_back();
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  const std::uint32_t node = free_;
  free_ = nodes_[node].parent;
  return node;
}

void BoxTree::grow_stack() {
  if (stack_.size() < size_ + 1) stack_.resize(2 * size_ + 1);
}

void BoxTree::free_node(std::uint32_t node) {
  nodes_[node].parent = free_;
  free_ = node;
}

/// A parent of none: the root changes.
void BoxTree::replace_child(std::uint32_t parent, std::uint32_t from, std::uint32_t to) {
  if (parent == kNone) {
    root_ = to;
  } else {
    Node& p = nodes_[parent];
    p.child[p.child[1] == from] = to;
  }
}

/// Split by the median along the axis on which centres spread most: a box far from all others, or much larger, costs
/// one level, and boxes all alike are halved by their numbers. Nodes are laid out in preorder, a subtree of k leaves
/// taking 2 k - 1 of them, so that no list of finished nodes is needed.
void BoxTree::build(const Array<std::uint32_t>& leaves, const Array<Aabb>& boxes) {
  clear();
  if (leaves.empty()) return;
  items_.clear();
  for (const std::uint32_t leaf : leaves) {
    const Vec3 c = 0.5 * boxes[leaf].lo + 0.5 * boxes[leaf].hi;
    items_.push_back({{c.x(), c.y(), c.z()}, leaf});
  }
  nodes_.resize(2 * leaves.size() - 1);
  struct Range {
    std::uint32_t begin, count, node, parent;
  };
  std::array<Range, 40> todo;  // one per level: counts are halved
  std::size_t waiting = 0;
  todo[waiting++] = {0, static_cast<std::uint32_t>(leaves.size()), 0, kNone};
  while (waiting > 0) {
    const Range r = todo[--waiting];
    Node& node = nodes_[r.node];
    node.parent = r.parent;
    Item* const first = items_.data() + r.begin;
    if (r.count == 1) {
      node.box = boxes[first->leaf];
      node.child[0] = kNone, node.child[1] = first->leaf;
      leaf_[first->leaf] = r.node;
      continue;
    }
    std::array<Real, 3> lo = first->center, hi = lo;
    for (const Item* i = first + 1; i < first + r.count; ++i)
      for (std::size_t k = 0; k < 3; ++k) lo[k] = std::min(lo[k], i->center[k]), hi[k] = std::max(hi[k], i->center[k]);
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (hi[k] - lo[k] > hi[axis] - lo[axis]) axis = k;
    const std::uint32_t left = r.count / 2;
    std::nth_element(first, first + left, first + r.count, [axis](const Item& a, const Item& b) {
      return a.center[axis] < b.center[axis] || (a.center[axis] == b.center[axis] && a.leaf < b.leaf);
    });
    node.child[0] = r.node + 1, node.child[1] = r.node + 2 * left;
    todo[waiting++] = {r.begin + left, r.count - left, node.child[1], r.node};
    todo[waiting++] = {r.begin, left, node.child[0], r.node};
  }
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    Node& node = nodes_[i];
    if (!node.is_leaf()) node.box = both(nodes_[node.child[0]].box, nodes_[node.child[1]].box);
  }
  root_ = 0;
  size_ = leaves.size();
  grow_stack();
}

std::size_t BoxTree::insert(std::uint32_t leaf, const Aabb& box) {
  const std::uint32_t node = take_node(), joint = root_ == kNone ? kNone : take_node();
  nodes_[node].box = box;
  nodes_[node].child[0] = kNone, nodes_[node].child[1] = leaf;
  leaf_[leaf] = node;
  ++size_;
  grow_stack();
  if (joint == kNone) {
    nodes_[node].parent = kNone;
    root_ = node;
    return 0;
  }
  std::size_t depth = 1;
  std::uint32_t beside = root_;
  Real grown = surface(both(nodes_[root_].box, box));  // of the node `beside`, with the leaf in it
  while (!nodes_[beside].is_leaf()) {
    Node& here = nodes_[beside];
    // A pair here is a new box of `grown`; further down, this node grows to it and a child pays for the rest.
    const Real inherited = grown - surface(here.box);
    Real with[2], cost[2];
    for (int k = 0; k < 2; ++k) {
      const Node& child = nodes_[here.child[k]];
      with[k] = surface(both(child.box, box));
      cost[k] = inherited + with[k] - (child.is_leaf() ? 0 : surface(child.box));
    }
    const int k = cost[1] < cost[0];
    if (!(cost[k] < grown)) break;
    here.box = both(here.box, box);
    beside = here.child[k];
    grown = with[k];
    ++depth;
  }
  const std::uint32_t parent = nodes_[beside].parent;
  Node& pair = nodes_[joint];
  pair.box = both(nodes_[beside].box, box);
  pair.parent = parent;
  pair.child[0] = beside, pair.child[1] = node;
  replace_child(parent, beside, joint);
  nodes_[beside].parent = nodes_[node].parent = joint;
  return depth;
}

void BoxTree::remove(std::uint32_t leaf) {
  const std::uint32_t node = leaf_[leaf], parent = nodes_[node].parent;
  leaf_[leaf] = kNone;
  --size_;
  free_node(node);
  if (parent == kNone) {
    root_ = kNone;
    return;
  }
  const std::uint32_t sibling = nodes_[parent].child[nodes_[parent].child[0] == node];
  std::uint32_t above = nodes_[parent].parent;
  replace_child(above, parent, sibling);
  nodes_[sibling].parent = above;
  free_node(parent);
  while (above != kNone) {  // until a box has not shrunk
    Node& a = nodes_[above];
    const Aabb shrunk = both(nodes_[a.child[0]].box, nodes_[a.child[1]].box);
    if (shrunk.lo == a.box.lo && shrunk.hi == a.box.hi) return;
    a.box = shrunk;
    above = a.parent;
  }
}

}  // namespace carom
