// A tree of boxes, four to a node: which of the boxes in it does this one overlap. Leaves are named by small numbers.
#pragma once

#include <array>

#include "collision/broad/bounds.h"
#include "core/invalid.h"

namespace carom::collision {

/// An R-tree [Guttman1984]: every node holds the boxes of up to four children side by side, all leaves are equally
/// deep. So a query goes down level by level, four boxes at a time, and nothing in it has to be guessed by a processor
/// but the lengths of its loops. Leaves come, go and move one by one; build() makes the whole tree afresh. Which leaves
/// a query finds depends on the boxes alone, never on how the tree came to be.
class BoxTree {
 public:
  explicit BoxTree(Memory* m)
      : nodes_(m), place_(m), items_(m), reached_{Array<std::uint32_t>(m), Array<std::uint32_t>(m)} {}

  /// Leaves may from here on be numbered below `leaves`.
  void grow(std::size_t leaves) {
    if (place_.size() < leaves) place_.resize(leaves, kInvalid);
  }
  void clear();
  std::size_t size() const { return size_; }

  /// Replace all leaves. Depth log4 n or one more, neighbours side by side. O(n log n).
  /// @param boxes  by leaf; finite, not empty
  void build(const Array<std::uint32_t>& leaves, const Array<Aabb>& boxes);

  /// Put a leaf where the surfaces of enclosing boxes grow least.
  /// @return the depth at which it ended; what comes and goes for long may leave a tree deeper than log2 n
  std::size_t insert(std::uint32_t leaf, const Aabb& box);
  void remove(std::uint32_t leaf);
  /// A leaf's box becomes another one. Unless that is far off it stays where it is in the tree, which wears.
  /// @return as insert()
  std::size_t move(std::uint32_t leaf, const Aabb& box);

  /// A leaf's box becomes a smaller one within it.
  void shrink(std::uint32_t leaf, const Aabb& box);

  /// Call found(leaf) for every leaf whose box overlaps (closed), in an order that means nothing.
  /// @param box  not empty; may be unbounded
  /// @return     boxes compared
  template <class Found>
  std::uint64_t query(const Aabb& box, Found&& found);
  /// The same of any number of threads at a time; count() is to be told what each has compared, in an order that
  /// repeats.
  template <class Found>
  std::uint64_t search(const Aabb& box, Found&& found) const;
  void count(std::uint64_t tests) {
    if (root_ == kInvalid) return;
    if (sampled_ < kSample)
      ++sampled_, sample_ += static_cast<Real>(tests) / kSample;
    else
      waste_ = std::max(Real(0), waste_ + static_cast<Real>(tests) - sample_);
  }

  /// Whether queries have cost so much more than the first after build() did that to build afresh had been cheaper.
  bool worn() const;

  /// Call found(one, other) once for every two leaves whose boxes overlap. Less than half of what a query for each
  /// would cost.
  /// @return boxes compared
  template <class Found>
  std::uint64_t each_pair(Found&& found);

 private:
  static constexpr std::uint32_t kWidth = 4;
  static constexpr int kSample = 64;
  static constexpr std::uint32_t kMostHeight = 127;

  struct alignas(64) Node {
    Real lo[3][kWidth], hi[3][kWidth];  // m; NaN beyond `count`, which overlaps nothing, not even all of space
    std::uint32_t child[kWidth];        // nodes; leaves at height 0
    std::uint32_t parent;  // place in it, @see at(); kInvalid at the root; the next free one in a free node
    std::uint32_t count, height;

    Aabb box(std::uint32_t lane) const;
    Aabb all() const;  // what its children span
    void put(std::uint32_t lane, const Aabb& box, std::uint32_t child);
    void cut(std::uint32_t kept);
  };
  /// A place in the tree: a node and one of its lanes.
  static constexpr std::uint32_t at(std::uint32_t node, std::uint32_t lane) { return kWidth * node + lane; }

  /// A box held for comparisons with four at a time.
  class Held {
   public:
    explicit Held(const Aabb& box)
        : lo_{Two(box.lo.x(), box.lo.x()), Two(box.lo.y(), box.lo.y()), Two(box.lo.z(), box.lo.z())},
          hi_{Two(box.hi.x(), box.hi.x()), Two(box.hi.y(), box.hi.y()), Two(box.hi.z(), box.hi.z())} {}
    /// A bit for each child that overlaps.
    unsigned hits(const Node& n) const { return half(n, 0) | half(n, 2) << 2; }

   private:
    unsigned half(const Node& n, std::size_t i) const {
      return ((Two(n.lo[0] + i) <= hi_[0]) & (lo_[0] <= Two(n.hi[0] + i)) & (Two(n.lo[1] + i) <= hi_[1]) &
              (lo_[1] <= Two(n.hi[1] + i)) & (Two(n.lo[2] + i) <= hi_[2]) & (lo_[2] <= Two(n.hi[2] + i)))
          .bits();
    }
    Two lo_[3], hi_[3];
  };
  /// Children of hit lanes; a hit is a coin toss, so it moves a pointer instead of branching.
  static std::uint32_t* take(const Node& n, unsigned hits, std::uint32_t* out) {
    for (std::uint32_t lane = 0; lane < kWidth; ++lane) {
      *out = n.child[lane];
      out += hits >> lane & 1;
    }
    return out;
  }

  /// A leaf while the tree is built: the comparisons are all about its centre.
  struct Item {
    std::array<Real, 3> center;  // m
    std::uint32_t leaf;
  };

  std::uint32_t take_node(std::uint32_t height);
  void reserve();
  void free_node(std::uint32_t node);
  void adopt(std::uint32_t node, std::uint32_t lane);
  void add(std::uint32_t node, const Aabb& box, std::uint32_t child);
  std::uint32_t split(std::uint32_t node, const Aabb& box, std::uint32_t child);
  void drop(std::uint32_t place);
  void refit(std::uint32_t node);
  void fill(std::uint32_t node, Item* first, std::size_t count, const Array<Aabb>& boxes);
  void part(std::uint32_t node, Item* first, std::size_t count, std::size_t parts, const Array<Aabb>& boxes);

  Array<Node> nodes_;
  Array<std::uint32_t> place_;                   // by leaf: where it is, or kInvalid
  Array<Item> items_;                            // while building
  std::array<Array<std::uint32_t>, 2> reached_;  // [leaves + 4] of a query: nodes of one level, then of the next
  std::uint32_t root_ = kInvalid, free_ = kInvalid;
  std::size_t size_ = 0;
  int sampled_ = 0;  // queries, of the first kSample since build()
  Real sample_ = 0;  // boxes that they compared, in the mean
  Real waste_ = 0;   // boxes compared since, beyond as many a query
};

template <class Found>
std::uint64_t BoxTree::search(const Aabb& box, Found&& found) const {
  if (root_ == kInvalid) return 0;
  const Held held(box);
  const Node* const nodes = nodes_.data();
  std::array<std::uint32_t, kWidth*(kMostHeight + 1)> stack;  // of each height, what is left of one node's children
  std::uint32_t* top = stack.data();
  *top++ = root_;
  std::uint64_t tests = 0;
  while (top > stack.data()) {
    const Node& n = nodes[*--top];
    tests += kWidth;
    std::uint32_t* const end = take(n, held.hits(n), top);
    if (n.height > 0)
      top = end;
    else
      for (const std::uint32_t* leaf = top; leaf < end; ++leaf) found(*leaf);
  }
  return tests;
}

template <class Found>
std::uint64_t BoxTree::query(const Aabb& box, Found&& found) {
  const std::uint64_t tests = search(box, found);
  count(tests);
  return tests;
}

/// Of two leaves, one is in an earlier lane of the node at which their ways part: it finds the other. The leaves of a
/// lowest node look for others together, down to the lowest nodes that what they span overlaps.
template <class Found>
std::uint64_t BoxTree::each_pair(Found&& found) {
  if (root_ == kInvalid) return 0;
  const Node* const nodes = nodes_.data();
  std::uint64_t tests = 0;
  const auto later = [](std::uint32_t place) { return ~1u << place % kWidth; };
  for (std::uint32_t leaf = 0; leaf < place_.size(); ++leaf) {
    if (place_[leaf] == kInvalid || place_[leaf] % kWidth != 0) continue;  // once for each lowest node
    const std::uint32_t own = place_[leaf] / kWidth;
    std::array<std::uint32_t, kMostHeight + 1> way;  // by height: the place of what it is below
    for (std::uint32_t p = nodes[own].parent; p != kInvalid; p = nodes[p / kWidth].parent)
      way[nodes[p / kWidth].height] = p;
    const Held all(nodes[own].all());
    std::uint32_t *here = reached_[0].data(), *below = reached_[1].data();
    std::size_t n = 0;
    for (std::uint32_t height = nodes[root_].height; height > 0; --height) {
      tests += kWidth * (n + 1);
      std::uint32_t* out = below;
      for (std::size_t i = 0; i < n; ++i) out = take(nodes[here[i]], all.hits(nodes[here[i]]), out);
      const Node& above = nodes[way[height] / kWidth];
      out = take(above, all.hits(above) & later(way[height]), out);
      n = static_cast<std::size_t>(out - below);
      std::swap(here, below);
    }
    for (std::uint32_t lane = 0; lane < nodes[own].count; ++lane) {
      const Held held(nodes[own].box(lane));
      tests += kWidth * (n + 1);
      std::uint32_t* out = take(nodes[own], held.hits(nodes[own]) & later(lane), below);
      for (std::size_t i = 0; i < n; ++i) out = take(nodes[here[i]], held.hits(nodes[here[i]]), out);
      for (const std::uint32_t* o = below; o < out; ++o) found(nodes[own].child[lane], *o);
    }
  }
  return tests;
}

}  // namespace carom::collision
