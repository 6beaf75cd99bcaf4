// The tree of short boxes: built by surface area, put right from below.
#include "collision/broad/query_tree.h"

#include <algorithm>

namespace carom::collision {
namespace {

constexpr int kBins = 16;
/// Surfaces of all nodes may grow by this factor before the tree counts as worn.
constexpr Real kWear = 1.6;
/// To climb from a node costs as much as to sweep over so many.
constexpr std::size_t kClimb = 16;

Aabb box_around(const Aabb& a, const Aabb& b) {
  Aabb u;
  u.lo = a.lo.min(b.lo), u.hi = a.hi.max(b.hi);
  return u;
}
/// Half of it, m^2.
Real surface_of(const Aabb& box) {
  const Vec3 s = box.hi - box.lo;
  return s.x() * s.y() + s.y() * s.z() + s.z() * s.x();
}
Real twice_centre(const Aabb& box, int axis) { return box.lo[axis] + box.hi[axis]; }

}  // namespace

void QueryTree::clear() {
  nodes_.clear();
  std::fill(place_.begin(), place_.end(), kInvalid);
  dirty_.clear();
  size_ = built_size_ = 0;
  cost_ = built_cost_ = 0;
}

/// Outwards by kPad of the coordinate, and kBlur of all.
void QueryTree::put(Node& node, std::uint32_t lane, const Aabb& box) const {
  const Vec3 far = (box.lo - origin_).abs().max((box.hi - origin_).abs());
  const auto blur = static_cast<float>(kBlur * far.max_entry()) + std::numeric_limits<float>::min();
  for (std::uint32_t k = 0; k < 3; ++k) {
    const auto lo = static_cast<float>(box.lo[k] - origin_[k]), hi = static_cast<float>(box.hi[k] - origin_[k]);
    node.planes[4 * k + lane] = lo - kPad * std::fabs(lo) - blur;
    node.planes[12 + 4 * k + lane] = hi + kPad * std::fabs(hi) + blur;
  }
}

void QueryTree::put_all(Node& node, std::uint32_t lane, const Node& child) const {
  for (std::uint32_t k = 0; k < 6; ++k) {
    const float* p = child.planes + 4 * k;
    node.planes[4 * k + lane] = k < 3 ? std::min(std::min(p[0], p[1]), std::min(p[2], p[3]))
                                      : std::max(std::max(p[0], p[1]), std::max(p[2], p[3]));
  }
}

void QueryTree::vacate(Node& node, std::uint32_t lane) {
  for (std::uint32_t k = 0; k < 6; ++k)
    node.planes[4 * k + lane] =
        k < 3 ? std::numeric_limits<float>::infinity() : -std::numeric_limits<float>::infinity();
  node.child[lane] = kInvalid;
}

/// Of what its children span; 0 of none.
float QueryTree::surface(const Node& node) {
  float s[3];
  for (int k = 0; k < 3; ++k) {
    const float *lo = node.planes + 4 * k, *hi = lo + 12;
    s[k] = std::max(std::max(hi[0], hi[1]), std::max(hi[2], hi[3])) -
           std::min(std::min(lo[0], lo[1]), std::min(lo[2], lo[3]));
  }
  return s[0] >= 0 ? s[0] * s[1] + s[1] * s[2] + s[2] * s[0] : 0;
}

void QueryTree::build(const Array<std::uint32_t>& leaves, const Array<Aabb>& boxes) {
  clear();
  if (place_.size() < boxes.size()) place_.resize(boxes.size(), kInvalid);
  if (leaves.empty()) return;
  items_.clear();
  items_.reserve(leaves.size());
  for (const std::uint32_t leaf : leaves) items_.push_back({boxes[leaf], leaf});
  // Amidst most of them: digits of float are spent on where things are, not on one that is far off.
  std::array<Real, 63> sample;
  for (int k = 0; k < 3; ++k) {
    const std::size_t n = std::min(sample.size(), items_.size());
    for (std::size_t i = 0; i < n; ++i) sample[i] = 0.5 * twice_centre(items_[i * items_.size() / n].box, k);
    const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(n / 2);
    std::nth_element(sample.begin(), middle, sample.begin() + static_cast<std::ptrdiff_t>(n));
    origin_[k] = *middle;
  }
  nodes_.reserve(leaves.size() / 2 + 1);
  fill(kInvalid, items_.data(), items_.size(), 0);
  size_ = built_size_ = leaves.size();
  dirty_.reserve(nodes_.size());
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    const Node& node = nodes_[i];
    cost_ += static_cast<Real>(surface(node));
    if (node.parent != kInvalid) put_all(nodes_[node.parent / kWidth], node.parent % kWidth, node);
  }
  built_cost_ = cost_;
}

/// A node for these, which split in two, two and two until there are four, or no more than one in each.
std::uint32_t QueryTree::fill(std::uint32_t parent, Item* first, std::size_t count, int depth) {
  struct Part {
    Item* first;
    std::size_t count;
    Real surface;
  };
  const auto part = [](Item* from, std::size_t n) {
    Aabb all = from->box;
    for (const Item* i = from + 1; i < from + n; ++i) all = box_around(all, i->box);
    return Part{from, n, surface_of(all)};
  };
  std::array<Part, kWidth> parts{part(first, count)};
  std::uint32_t n = 1;
  while (n < kWidth) {
    Part* largest = nullptr;
    for (Part* p = parts.data(); p < parts.data() + n; ++p)
      if (p->count > 1 && (!largest || p->surface > largest->surface)) largest = p;
    if (!largest) break;
    const Part whole = *largest;
    const std::size_t left = halve(whole.first, whole.count, depth);
    *largest = part(whole.first, left);
    parts[n++] = part(whole.first + left, whole.count - left);
  }
  const auto own = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  nodes_[own].parent = parent;
  nodes_[own].dirty = 0;
  for (std::uint32_t lane = 0; lane < kWidth; ++lane) {
    if (lane >= n) {
      vacate(nodes_[own], lane);
    } else if (parts[lane].count == 1) {
      const Item& item = *parts[lane].first;
      put(nodes_[own], lane, item.box);
      nodes_[own].child[lane] = kLeaf | item.leaf;
      place_[item.leaf] = own * kWidth + lane;
    } else {
      const std::uint32_t child = fill(own * kWidth + lane, parts[lane].first, parts[lane].count, depth + 1);
      nodes_[own].child[lane] = child;
    }
  }
  return own;
}

/// Where to part: along the axis on which centres spread most, at the one of sixteen places where surfaces times counts
/// are least (all three axes: a tree no better, for three times the work); in the middle where that says nothing (all
/// centres in one place), or where it has led too deep.
std::size_t QueryTree::halve(Item* first, std::size_t count, int depth) const {
  struct Bin {
    Aabb box;
    std::size_t count = 0;
  };
  Vec3 lo = Vec3::constant(kInfinity), hi = -lo;
  for (const Item* i = first; i < first + count; ++i)
    for (int k = 0; k < 3; ++k) {
      const Real c = twice_centre(i->box, k);
      lo[k] = std::min(lo[k], c), hi[k] = std::max(hi[k], c);
    }
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (hi[k] - lo[k] > hi[axis] - lo[axis]) axis = k;
  const Real spread = hi[axis] - lo[axis];
  if (depth < kDeepest && spread > 0 && count > 2) {
    const Real from = lo[axis], by = kBins * (1 - 1e-9) / spread;
    const auto bin_of = [&](const Item& i) {
      return static_cast<std::size_t>(by * (twice_centre(i.box, axis) - from));
    };
    std::array<Bin, kBins> bins;
    for (const Item* i = first; i < first + count; ++i) {
      Bin& bin = bins[bin_of(*i)];
      bin.box = box_around(bin.box, i->box);
      ++bin.count;
    }
    std::array<Real, kBins> right{};  // of all bins from here on
    Aabb all;
    std::size_t n = 0;
    for (std::size_t b = kBins; b-- > 1;) {
      all = box_around(all, bins[b].box), n += bins[b].count;
      right[b] = n ? static_cast<Real>(n) * surface_of(all) : 0;
    }
    Real best = kInfinity;
    std::size_t last = kBins;  // bin on the left
    all = Aabb(), n = 0;
    for (std::size_t b = 0; b + 1 < kBins; ++b) {
      all = box_around(all, bins[b].box), n += bins[b].count;
      if (n == 0 || n == count) continue;
      const Real cost = static_cast<Real>(n) * surface_of(all) + right[b + 1];
      if (cost < best) best = cost, last = b;
    }
    if (last < kBins) {
      const Item* middle = std::partition(first, first + count, [&](const Item& i) { return bin_of(i) <= last; });
      return static_cast<std::size_t>(middle - first);
    }
  }
  std::nth_element(first, first + count / 2, first + count, [axis](const Item& a, const Item& b) {
    return twice_centre(a.box, axis) < twice_centre(b.box, axis);
  });
  return count / 2;
}

void QueryTree::set(std::uint32_t leaf, const Aabb& box) {
  Node& node = nodes_[place_[leaf] / kWidth];
  put(node, place_[leaf] % kWidth, box);
  mark(place_[leaf] / kWidth);
}

void QueryTree::remove(std::uint32_t leaf) {
  vacate(nodes_[place_[leaf] / kWidth], place_[leaf] % kWidth);
  mark(place_[leaf] / kWidth);
  place_[leaf] = kInvalid;
  --size_;
}

void QueryTree::mark(std::uint32_t node) {
  if (nodes_[node].dirty) return;
  nodes_[node].dirty = 1;
  dirty_.push_back(node);  // reserved for all nodes
}

void QueryTree::refit() {
  if (dirty_.empty()) return;
  if (kClimb * dirty_.size() < nodes_.size())
    climb();
  else
    sweep();
  dirty_.clear();
}

/// From each node to the root, or to where nothing changes.
void QueryTree::climb() {
  for (std::uint32_t at : dirty_) {
    nodes_[at].dirty = 0;
    for (std::uint32_t place = nodes_[at].parent; place != kInvalid; at = place / kWidth, place = nodes_[at].parent) {
      Node& above = nodes_[place / kWidth];
      const Node before = above;
      put_all(above, place % kWidth, nodes_[at]);
      if (std::equal(before.planes, before.planes + 24, above.planes)) break;
      cost_ += static_cast<Real>(surface(above)) - static_cast<Real>(surface(before));
    }
  }
}

/// From the last node to the first: children stand behind their parents.
void QueryTree::sweep() {
  cost_ = 0;
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    Node& node = nodes_[i];
    if (node.dirty && node.parent != kInvalid) {
      Node& above = nodes_[node.parent / kWidth];
      put_all(above, node.parent % kWidth, node);
      above.dirty = 1;
    }
    node.dirty = 0;
    cost_ += static_cast<Real>(surface(node));
  }
}

bool QueryTree::worn() const { return cost_ > kWear * built_cost_ || 2 * size_ < built_size_; }

QueryTree::Line::Line(const QueryTree& tree, const Vec3& from, const Vec3& unit, const Aabb& extent) {
  constexpr Real kLeast = kBlur / 4;  // of a direction: less strays by less than the padding
  const Vec3 reach = extent.lo.abs().max(extent.hi.abs());
  const Real blur = kBlur * ((from - tree.origin_).abs().max_entry() + reach.max_entry());
  for (int k = 0; k < 3; ++k) {
    const Real o = from[k] - tree.origin_[k], d = std::copysign(std::max(std::fabs(unit[k]), kLeast), unit[k]);
    const Real more = blur + static_cast<Real>(kPad) * (std::fabs(o) + reach[k]);
    // A box [lo, hi] met by what reaches from a to b about the point: the point meets [lo - b, hi - a].
    const Real low = o + extent.hi[k] + more, high = o + extent.lo[k] - more;
    const bool back = d < 0;
    near_[k] = static_cast<float>(back ? high : low);
    far_[k] = static_cast<float>(back ? low : high);
    inverse_[k] = static_cast<float>(1 / d);
    near_at_[k] = static_cast<std::uint8_t>((back ? 12 : 0) + 4 * k);
    far_at_[k] = static_cast<std::uint8_t>((back ? 0 : 12) + 4 * k);
  }
}

QueryTree::Box::Box(const QueryTree& tree, const Aabb& box) {
  for (int k = 0; k < 3; ++k) {
    const Real lo = box.lo[k] - tree.origin_[k], hi = box.hi[k] - tree.origin_[k];
    const Real more = static_cast<Real>(kPad) * (std::fabs(lo) + std::fabs(hi));
    lo_[k] = static_cast<float>(lo - more), hi_[k] = static_cast<float>(hi + more);
  }
}

}  // namespace carom::collision
