// The tree of boxes: built by parting, changed leaf by leaf.
#include "collision/broad/box_tree.h"

#include <algorithm>
#include <bit>

namespace carom::collision {
namespace {

Aabb both(const Aabb& a, const Aabb& b) {
  Aabb u;
  u.lo = a.lo.min(b.lo), u.hi = a.hi.max(b.hi);
  return u;
}

/// What moves stays with its neighbours unless the surface of what they span grows by this factor: it has gone far off
/// then. At 1, all that falls is taken out and put back every few steps, at 1.2 times the cost of a step; without end,
/// one box thrown about would be in everybody's way until the tree is worn().
constexpr Real kStretch = 2;
/// To build costs n log2 n times as much as to compare this many boxes (150 ns a leaf at 1,024, 1.2 ns a box).
constexpr Real kBuilding = 12;

/// Half the surface. Infinite, or not a number, at the far end of doubles: a tree is as right then, and less good.
Real surface(const Aabb& box) {
  const Vec3 s = box.hi - box.lo;
  return s.x() * s.y() + s.y() * s.z() + s.z() * s.x();
}

}  // namespace

Aabb BoxTree::Node::box(std::uint32_t lane) const {
  Aabb b;
  b.lo = Vec3(lo[0][lane], lo[1][lane], lo[2][lane]), b.hi = Vec3(hi[0][lane], hi[1][lane], hi[2][lane]);
  return b;
}

Aabb BoxTree::Node::all() const {
  Aabb b = box(0);
  for (std::uint32_t lane = 1; lane < count; ++lane) b = both(b, box(lane));
  return b;
}

void BoxTree::Node::put(std::uint32_t lane, const Aabb& b, std::uint32_t of) {
  for (int k = 0; k < 3; ++k) lo[k][lane] = b.lo[k], hi[k][lane] = b.hi[k];
  child[lane] = of;
}

void BoxTree::Node::cut(std::uint32_t kept) {
  count = kept;
  constexpr Real none = std::numeric_limits<Real>::quiet_NaN();
  for (std::uint32_t lane = kept; lane < kWidth; ++lane) {
    for (int k = 0; k < 3; ++k) lo[k][lane] = hi[k][lane] = none;
    child[lane] = kInvalid;
  }
}

void BoxTree::clear() {
  nodes_.clear();
  std::fill(place_.begin(), place_.end(), kInvalid);
  root_ = free_ = kInvalid;
  size_ = 0;
  sampled_ = 0, sample_ = waste_ = 0;
}

std::uint32_t BoxTree::take_node(std::uint32_t height) {
  std::uint32_t node = free_;
  if (node == kInvalid) {
    node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
  } else {
    free_ = nodes_[node].parent;
  }
  nodes_[node].parent = kInvalid;
  nodes_[node].height = height;
  nodes_[node].cut(0);
  return node;
}

/// For queries: at most all nodes of a level are reached, and a child more is written than is taken.
void BoxTree::reserve() {
  if (reached_[1].size() >= size_ + kWidth) return;
  for (Array<std::uint32_t>& list : reached_) list.resize(2 * size_ + kWidth);
}

void BoxTree::free_node(std::uint32_t node) {
  nodes_[node].parent = free_;
  free_ = node;
}

/// Tell a child where it is.
void BoxTree::adopt(std::uint32_t node, std::uint32_t lane) {
  const Node& n = nodes_[node];
  (n.height == 0 ? place_[n.child[lane]] : nodes_[n.child[lane]].parent) = at(node, lane);
}

void BoxTree::build(const Array<std::uint32_t>& leaves, const Array<Aabb>& boxes) {
  clear();
  if (leaves.empty()) return;
  items_.clear();
  for (const std::uint32_t leaf : leaves) {
    const Vec3 c = 0.5 * boxes[leaf].lo + 0.5 * boxes[leaf].hi;
    items_.push_back({{c.x(), c.y(), c.z()}, leaf});
  }
  size_ = leaves.size();
  reserve();
  nodes_.reserve(size_ + 1);
  std::uint32_t height = 0;
  for (std::size_t capacity = kWidth; capacity < size_; capacity *= kWidth) ++height;
  root_ = take_node(height);
  fill(root_, items_.data(), items_.size(), boxes);
}

/// As few children as hold all, each with about as many leaves: lowest nodes are nearly full.
void BoxTree::fill(std::uint32_t node, Item* first, std::size_t count, const Array<Aabb>& boxes) {
  const std::size_t capacity = std::size_t(1) << 2 * nodes_[node].height;  // of a child
  part(node, first, count, (count + capacity - 1) / capacity, boxes);
}

/// Part by a quantile along the axis on which centres spread most: a box far from all others, or much larger, costs
/// little, and boxes all alike are parted by their numbers.
void BoxTree::part(std::uint32_t node, Item* first, std::size_t count, std::size_t parts, const Array<Aabb>& boxes) {
  if (parts > 1) {
    std::array<Real, 3> lo = first->center, hi = lo;
    for (const Item* i = first + 1; i < first + count; ++i)
      for (std::size_t k = 0; k < 3; ++k) lo[k] = std::min(lo[k], i->center[k]), hi[k] = std::max(hi[k], i->center[k]);
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (hi[k] - lo[k] > hi[axis] - lo[axis]) axis = k;
    const std::size_t left = count * (parts / 2) / parts;
    std::nth_element(first, first + left, first + count, [axis](const Item& a, const Item& b) {
      return a.center[axis] < b.center[axis] || (a.center[axis] == b.center[axis] && a.leaf < b.leaf);
    });
    part(node, first, left, parts / 2, boxes);
    part(node, first + left, count - left, parts - parts / 2, boxes);
    return;
  }
  const std::uint32_t height = nodes_[node].height, lane = nodes_[node].count++;
  if (height == 0) {
    nodes_[node].put(lane, boxes[first->leaf], first->leaf);
  } else {
    const std::uint32_t child = take_node(height - 1);
    fill(child, first, count, boxes);
    nodes_[node].put(lane, nodes_[child].all(), child);
  }
  adopt(node, lane);
}

std::size_t BoxTree::insert(std::uint32_t leaf, const Aabb& box) {
  ++size_;
  reserve();
  if (root_ == kInvalid) root_ = take_node(0);
  std::uint32_t node = root_;
  while (nodes_[node].height > 0) {
    Node& here = nodes_[node];
    std::uint32_t best = 0;
    Real least = kInfinity, smallest = kInfinity;
    for (std::uint32_t lane = 0; lane < here.count; ++lane) {
      const Aabb old = here.box(lane);
      const Real size = surface(old), growth = surface(both(old, box)) - size;
      if (growth < least || (growth == least && size < smallest)) best = lane, least = growth, smallest = size;
    }
    node = here.child[best];
    here.put(best, both(here.box(best), box), node);
  }
  add(node, box, leaf);
  return nodes_[root_].height;
}

/// Give a node another child, parting it if it is full; what spans it spans the child already.
void BoxTree::add(std::uint32_t node, const Aabb& box, std::uint32_t child) {
  Aabb its = box;
  while (nodes_[node].count == kWidth) {
    const std::uint32_t sibling = split(node, its, child), height = nodes_[node].height;
    std::uint32_t parent = nodes_[node].parent;
    its = nodes_[sibling].all();
    if (parent == kInvalid) {
      root_ = take_node(height + 1);
      parent = at(root_, nodes_[root_].count++);
    }
    nodes_[parent / kWidth].put(parent % kWidth, nodes_[node].all(), node);
    adopt(parent / kWidth, parent % kWidth);
    node = parent / kWidth, child = sibling;
  }
  const std::uint32_t lane = nodes_[node].count++;
  nodes_[node].put(lane, its, child);
  adopt(node, lane);
}

/// Share four children and a fifth between a node and a new one, two and three, by the least surface of both.
/// @return the new one
std::uint32_t BoxTree::split(std::uint32_t node, const Aabb& box, std::uint32_t child) {
  const std::uint32_t sibling = take_node(nodes_[node].height);
  std::array<Aabb, kWidth + 1> boxes;
  std::array<std::uint32_t, kWidth + 1> children;
  for (std::uint32_t lane = 0; lane < kWidth; ++lane)
    boxes[lane] = nodes_[node].box(lane), children[lane] = nodes_[node].child[lane];
  boxes[kWidth] = box, children[kWidth] = child;
  std::uint32_t one = 0, other = 1;  // who leave
  Real least = kInfinity;
  for (std::uint32_t i = 0; i < kWidth; ++i)
    for (std::uint32_t j = i + 1; j <= kWidth; ++j) {
      Aabb rest;
      for (std::uint32_t k = 0; k <= kWidth; ++k)
        if (k != i && k != j) rest = both(rest, boxes[k]);
      const Real cost = surface(both(boxes[i], boxes[j])) + surface(rest);
      if (cost < least) least = cost, one = i, other = j;
    }
  nodes_[node].cut(0);
  for (std::uint32_t k = 0; k <= kWidth; ++k) {
    const std::uint32_t to = k == one || k == other ? sibling : node, lane = nodes_[to].count++;
    nodes_[to].put(lane, boxes[k], children[k]);
    adopt(to, lane);
  }
  return sibling;
}

void BoxTree::remove(std::uint32_t leaf) {
  const std::uint32_t place = place_[leaf];
  place_[leaf] = kInvalid;
  --size_;
  drop(place);
}

/// Take a child out; nodes left empty go too.
void BoxTree::drop(std::uint32_t place) {
  std::uint32_t node = place / kWidth, lane = place % kWidth;
  while (nodes_[node].count == 1) {
    const std::uint32_t above = nodes_[node].parent;
    free_node(node);
    if (above == kInvalid) {
      root_ = kInvalid;
      return;
    }
    node = above / kWidth, lane = above % kWidth;
  }
  Node& n = nodes_[node];
  const std::uint32_t last = n.count - 1;
  if (lane != last) {
    n.put(lane, n.box(last), n.child[last]);
    adopt(node, lane);
  }
  n.cut(last);
  refit(node);
  while (nodes_[root_].count == 1 && nodes_[root_].height > 0) {
    const std::uint32_t only = nodes_[root_].child[0];
    free_node(root_);
    nodes_[only].parent = kInvalid;
    root_ = only;
  }
}

/// Bring what spans a node up to date, up to where nothing changes.
void BoxTree::refit(std::uint32_t node) {
  for (std::uint32_t up = nodes_[node].parent; up != kInvalid; up = nodes_[node].parent) {
    const Aabb all = nodes_[node].all(), old = nodes_[up / kWidth].box(up % kWidth);
    if (all.lo == old.lo && all.hi == old.hi) return;
    nodes_[up / kWidth].put(up % kWidth, all, node);
    node = up / kWidth;
  }
}

void BoxTree::shrink(std::uint32_t leaf, const Aabb& box) {
  nodes_[place_[leaf] / kWidth].put(place_[leaf] % kWidth, box, leaf);
  refit(place_[leaf] / kWidth);
}

/// Neighbours that move together stay together: to part them one by one would cost more and leave a worse tree.
std::size_t BoxTree::move(std::uint32_t leaf, const Aabb& box) {
  const std::uint32_t node = place_[leaf] / kWidth, lane = place_[leaf] % kWidth;
  const Real before = surface(nodes_[node].all());
  nodes_[node].put(lane, box, leaf);
  if (surface(nodes_[node].all()) <= kStretch * before) {
    refit(node);
    return nodes_[root_].height;
  }
  remove(leaf);
  return insert(leaf, box);
}

bool BoxTree::worn() const {
  return waste_ > kBuilding * static_cast<Real>(size_ * static_cast<std::size_t>(std::bit_width(size_)));
}

}  // namespace carom::collision
