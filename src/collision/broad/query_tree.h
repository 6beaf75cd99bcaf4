// A tree of boxes for questions from outside, asked by many threads at once: four short boxes to a node, visited from
// near to far.
#pragma once

#include <array>
#include <limits>

#include "collision/broad/bounds.h"
#include "core/four.h"
#include "core/invalid.h"

namespace carom::collision {

/// Every node holds the boxes of up to four children side by side, as float about an origin of the tree's own, each
/// rounded outwards by more than a search, or a cast after it, loses to rounding. So a search may visit a leaf in vain
/// and never misses one: what is found depends on the boxes given, not on how the tree came to be.
///
/// Built by surface area; leaves that move are put right where they are, up to the root. That wears: worn() tells when
/// to build afresh. Searches change nothing; edits want the tree for themselves.
class QueryTree {
 public:
  explicit QueryTree(Memory* m) : nodes_(m), place_(m), items_(m), dirty_(m) {}

  void clear();
  /// Replace all leaves.
  /// @param boxes  by leaf; finite, not empty
  void build(const Array<std::uint32_t>& leaves, const Array<Aabb>& boxes);
  bool has(std::uint32_t leaf) const { return leaf < place_.size() && place_[leaf] != kInvalid; }
  /// A leaf's box becomes another one. Its ancestors follow with refit().
  void set(std::uint32_t leaf, const Aabb& box);
  void remove(std::uint32_t leaf);
  /// Ancestors of what was set.
  void refit();
  std::size_t size() const { return size_; }
  /// It is not going to be built again: give back what building took.
  void close() { items_ = Array<Item>(items_.get_allocator()); }
  std::size_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + place_.capacity() * sizeof(std::uint32_t) +
           items_.capacity() * sizeof(Item);
  }
  /// Whether so much has come apart or gone that to build afresh is the better bargain.
  bool worn() const;

  /// m: farther off short numbers do not reach. Who asks from there asks all leaves.
  static constexpr Real kReach = 1e17;
  /// No for what is no number, too.
  static bool reaches(const Vec3& x) { return x.abs().all_below(Vec3::constant(kReach)); }
  static bool reaches(const Aabb& box) { return reaches(box.lo) && reaches(box.hi); }

  /// Asked along a line: the way at which it enters a box.
  class Line {
   public:
    /// @param from, extent  in reach; extent: what is swept, a box about the point that goes along the line
    /// @param unit          direction
    Line(const QueryTree& tree, const Vec3& from, const Vec3& unit, const Aabb& extent);
    unsigned hits(const float* planes, float limit, float key[4]) const;

   private:
    float near_[3], far_[3], inverse_[3];
    std::uint8_t near_at_[3], far_at_[3];  // of the planes of a node
  };

  /// Asked about a box: the square of the distance from it, from below; 0 of boxes that overlap it.
  class Box {
   public:
    /// @param box  in reach
    Box(const QueryTree& tree, const Aabb& box);
    unsigned hits(const float* planes, float limit, float key[4]) const;

   private:
    float lo_[3], hi_[3];
  };

  /// Call leaf(slot) for every leaf whose key is not above the limit, near ones first; leaf() may lower the limit.
  template <class Keys, class Leaf>
  void search(const Keys& keys, float& limit, Leaf&& leaf) const;

  /// Not below x, as float.
  static float above(Real x) {
    if (!(x < std::numeric_limits<float>::max() / 2)) return std::numeric_limits<float>::max();
    const auto f = static_cast<float>(x);
    return f + (f < 0 ? -f : f) * std::numeric_limits<float>::epsilon() + std::numeric_limits<float>::min();
  }

 private:
  static constexpr std::uint32_t kLeaf = 0x80000000u;
  static constexpr std::uint32_t kWidth = 4;
  /// Of a coordinate and an offset, in units of them. A plane as seen from a line's start is off by 1 u for each of the
  /// two as they are rounded, and the way to it by 3 u of their difference: 4 u (|plane| + |start|), u = 2^-24.
  static constexpr float kPad = 8 * std::numeric_limits<float>::epsilon() / 2;
  /// What rounding in double may do to a cast (three times kCastRounding u of lengths, not of coordinates).
  static constexpr Real kBlur = 0x1p-42;
  /// Halving by surface may split off one leaf at a time; from this depth on counts are halved.
  static constexpr int kDeepest = 24;
  static constexpr std::size_t kStack = 3 * (kDeepest + 13) + 4;  // 2^24 leaves take 12 levels more

  struct alignas(64) Node {
    float planes[24];  // lo x y z of four, hi x y z of four; +inf and -inf in an empty lane
    std::uint32_t child[kWidth];
    std::uint32_t parent;  // place: node * kWidth + lane; kInvalid at the root
    std::uint32_t dirty;
    std::uint32_t spare[2];
  };
  struct Item {
    Aabb box;
    std::uint32_t leaf;
  };
  std::uint32_t fill(std::uint32_t parent, Item* first, std::size_t count, int depth);
  std::size_t halve(Item* first, std::size_t count, int depth) const;
  void put(Node& node, std::uint32_t lane, const Aabb& box) const;
  void put_all(Node& node, std::uint32_t lane, const Node& child) const;
  void mark(std::uint32_t node);
  void climb();
  void sweep();
  static void vacate(Node& node, std::uint32_t lane);
  static float surface(const Node& node);

  Array<Node> nodes_;           // parents before children
  Array<std::uint32_t> place_;  // by leaf, or kInvalid
  Array<Item> items_;           // while building
  Array<std::uint32_t> dirty_;  // nodes of which a leaf changed
  Vec3 origin_ = Vec3::zero();  // m
  std::size_t size_ = 0, built_size_ = 0;
  Real cost_ = 0, built_cost_ = 0;  // m^2, surfaces of all nodes
};

inline unsigned QueryTree::Line::hits(const float* planes, float limit, float key[4]) const {
  Four enter(0.0f), leave(limit);
  for (int k = 0; k < 3; ++k) {
    enter = ((Four(planes + near_at_[k]) - Four(near_[k])) * Four(inverse_[k])).max(enter);
    leave = ((Four(planes + far_at_[k]) - Four(far_[k])) * Four(inverse_[k])).min(leave);
  }
  enter.store(key);
  return enter.not_above(leave);
}

inline unsigned QueryTree::Box::hits(const float* planes, float limit, float key[4]) const {
  Four sum(0.0f);
  for (int k = 0; k < 3; ++k) {
    const Four off =
        (Four(planes + 4 * k) - Four(hi_[k])).max(Four(lo_[k]) - Four(planes + 12 + 4 * k)).max(Four(0.0f));
    sum = sum + off * off;
  }
  sum = sum * Four(1 - 4 * std::numeric_limits<float>::epsilon());
  sum.store(key);
  return sum.not_above(Four(limit));
}

template <class Keys, class Leaf>
void QueryTree::search(const Keys& keys, float& limit, Leaf&& leaf) const {
  if (nodes_.empty()) return;
  struct Entry {
    std::uint32_t node;
    float key;
  };
  std::array<Entry, kStack> stack;
  std::size_t waiting = 0;
  Entry now{0, 0};
  for (;;) {
    const Node& node = nodes_[now.node];
    alignas(16) float key[kWidth];
    unsigned hits = keys.hits(node.planes, limit, key);
    Entry found[kWidth];
    std::size_t n = 0;
    for (; hits; hits &= hits - 1) {
      const auto lane = static_cast<std::uint32_t>(__builtin_ctz(hits));
      const Entry e{node.child[lane], key[lane]};
      std::size_t at = n++;
      for (; at > 0 && found[at - 1].key > e.key; --at) found[at] = found[at - 1];
      found[at] = e;
    }
    const std::size_t before = waiting;
    for (std::size_t i = 0; i < n; ++i) {
      if (found[i].key > limit) break;
      if (found[i].node & kLeaf)
        leaf(found[i].node & ~kLeaf);
      else
        stack[waiting++] = found[i];
    }
    // The nearest is to come off first.
    for (std::size_t i = before, j = waiting; i + 1 < j; ++i, --j) std::swap(stack[i], stack[j - 1]);
    do {
      if (waiting == 0) return;
      now = stack[--waiting];
    } while (now.key > limit);
  }
}

}  // namespace carom::collision
