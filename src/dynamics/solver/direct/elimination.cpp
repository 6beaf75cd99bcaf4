// Minimum degree on a quotient graph: an eliminated node stands for the clique of those that were its neighbours.
#include "dynamics/solver/direct/elimination.h"

#include <algorithm>

#include "core/invalid.h"

namespace carom::dynamics {
namespace {

constexpr std::uint32_t kNoParent = 0xFFFFFFFFu;

/// Nodes counted from 0; an element carries the number of the node whose elimination made it.
class QuotientGraph {
 public:
  QuotientGraph(std::uint32_t first, std::uint32_t count, std::span<const TreeJoint> forest, Elimination::Scratch& s)
      : first_(first), count_(count), forest_(forest), s_(s) {}

  void start(std::span<const Edge> edges) {
    const std::uint32_t first = first_;
    s_.joints.assign(count_, 0), s_.joint.assign(count_, 0);
    for (std::uint32_t k = 0; k < forest_.size(); ++k)
      for (const std::uint32_t node : {forest_[k].a, forest_[k].b})
        if (node != kInvalid) ++s_.joints[node - first], s_.joint[node - first] ^= k;
    s_.neighbour_begin.assign(count_ + 1, 0);
    for (const Edge& e : edges) ++s_.neighbour_begin[e.a - first + 1], ++s_.neighbour_begin[e.b - first + 1];
    for (std::uint32_t i = 0; i < count_; ++i) s_.neighbour_begin[i + 1] += s_.neighbour_begin[i];
    s_.neighbour.resize(s_.neighbour_begin[count_]);
    s_.mark.assign(s_.neighbour_begin.begin(), s_.neighbour_begin.end());  // next free place
    for (const Edge& e : edges) {
      s_.neighbour[s_.mark[e.a - first]++] = e.b - first;
      s_.neighbour[s_.mark[e.b - first]++] = e.a - first;
    }
    s_.mark.assign(count_, kNoParent);
    s_.first.assign(count_, kNoParent);
    s_.link.clear(), s_.member.clear();
    s_.begin.assign(4 * count_, kNoParent);  // of an element's members, and their end; then the tournament
    s_.degree.resize(count_);
    for (std::uint32_t i = 0; i < count_; ++i) s_.degree[i] = rank_of(i);
    for (std::uint32_t i = 0; i < count_; ++i) best(count_ + i) = i;
    for (std::uint32_t i = count_; i-- > 1;) best(i) = better(best(2 * i), best(2 * i + 1));
  }

  std::uint32_t least_degree() const { return best(1); }

  /// The joint of the forest that holds a node to what is left; kInvalid where none does.
  std::uint32_t joint_of(std::uint32_t node) const { return s_.joints[node] > 0 ? s_.joint[node] : kInvalid; }

  /// Eliminate a node. @return nodes that it was coupled to, directly or through nodes eliminated before
  std::span<const std::uint32_t> remove(std::uint32_t node) {
    const auto begin = static_cast<std::uint32_t>(s_.member.size());
    const std::uint32_t parent = parent_of(node);
    each_left(node, [&](std::uint32_t i) { s_.member.push_back(i); });
    const auto end = static_cast<std::uint32_t>(s_.member.size());
    for (std::uint32_t k = s_.first[node]; k != kNoParent; k = s_.link[2 * k])
      s_.begin[2 * s_.link[2 * k + 1]] = kNoParent;  // absorbed
    s_.begin[2 * node] = begin, s_.begin[2 * node + 1] = end;
    set_degree(node, kNoParent);
    if (parent != kNoParent) --s_.joints[parent], s_.joint[parent] ^= s_.joint[node];
    for (std::uint32_t k = begin; k < end; ++k) {
      const std::uint32_t i = s_.member[k];
      s_.link.push_back(s_.first[i]);
      s_.link.push_back(node);
      s_.first[i] = static_cast<std::uint32_t>(s_.link.size() / 2 - 1);
    }
    for (std::uint32_t k = begin; k < end; ++k) set_degree(s_.member[k], rank_of(s_.member[k]));
    if (parent != kNoParent && begin == end) set_degree(parent, rank_of(parent));
    return {s_.member.data() + begin, end - begin};
  }

 private:
  /// Of two nodes the one to go first: ties to the lower.
  std::uint32_t better(std::uint32_t i, std::uint32_t j) const {
    return s_.degree[i] != s_.degree[j] ? (s_.degree[i] < s_.degree[j] ? i : j) : std::min(i, j);
  }
  std::uint32_t& best(std::uint32_t i) const { return s_.begin[2 * count_ + i]; }
  /// best() is a tournament: a match at i is between those of 2i and 2i + 1, nodes stand from `count` on.
  void set_degree(std::uint32_t node, std::uint32_t degree) {
    s_.degree[node] = degree;
    for (std::uint32_t i = (count_ + node) / 2; i >= 1; i /= 2) best(i) = better(best(2 * i), best(2 * i + 1));
  }

  /// Once one joint of the forest is left.
  std::uint32_t parent_of(std::uint32_t node) const {
    if (s_.joints[node] != 1) return kNoParent;
    const std::uint32_t k = s_.joint[node];
    const std::uint32_t other = forest_[k].a - first_ == node ? forest_[k].b : forest_[k].a;
    return other == kInvalid ? kNoParent : other - first_;
  }

  bool gone(std::uint32_t i) const { return s_.begin[2 * i + 1] != kNoParent; }

  template <class F>
  void each_neighbour(std::uint32_t node, F&& f) {
    const std::uint32_t stamp = stamp_++;
    s_.mark[node] = stamp;
    const auto visit = [&](std::uint32_t i) {
      if (gone(i) || s_.mark[i] == stamp) return;
      s_.mark[i] = stamp;
      f(i);
    };
    for (std::uint32_t k = s_.neighbour_begin[node]; k < s_.neighbour_begin[node + 1]; ++k) visit(s_.neighbour[k]);
    for (std::uint32_t k = s_.first[node]; k != kNoParent; k = s_.link[2 * k]) {
      const std::uint32_t e = s_.link[2 * k + 1];
      if (s_.begin[2 * e] == kNoParent) continue;
      for (std::uint32_t j = s_.begin[2 * e], last = s_.begin[2 * e + 1]; j < last; ++j) visit(s_.member[j]);
    }
  }

  /// Nodes that it is coupled to as it goes, one by one.
  template <class F>
  void each_left(std::uint32_t node, F&& f) {
    const std::uint32_t parent = parent_of(node);
    bool any = false, with_parent = parent == kNoParent;
    each_neighbour(node, [&](std::uint32_t i) { f(i), any = true, with_parent |= i == parent; });
    if (any && !with_parent) f(parent);
  }

  std::uint32_t degree_of(std::uint32_t node) {
    std::uint32_t n = 0;
    each_left(node, [&](std::uint32_t) { ++n; });
    return n;
  }

  /// Its degree; what joints of the forest hold to more than one other comes after all others.
  std::uint32_t rank_of(std::uint32_t node) { return degree_of(node) | (s_.joints[node] > 1 ? kLater : 0); }

  static constexpr std::uint32_t kLater = 0x40000000u;
  std::uint32_t first_, count_, stamp_ = 0;
  std::span<const TreeJoint> forest_;
  Elimination::Scratch& s_;
};

}  // namespace

/// Places in the order of nodes, and nothing beside the diagonal.
static void give_up(std::uint32_t first, std::uint32_t count, std::size_t rows, Elimination& out) {
  out.rows.resize(rows);
  out.column.resize(first + 1);
  for (std::uint32_t i = first; i < first + count; ++i) {
    out.place[i] = i, out.scratch().node_at[i] = i, out.scratch().joint_at[i] = kInvalid;
    out.column.push_back(static_cast<std::uint32_t>(rows));
  }
}

std::uint64_t eliminate(std::uint32_t first, std::uint32_t count, std::span<const Edge> edges,
                        std::span<const TreeJoint> forest, std::uint64_t most, Elimination& out) {
  QuotientGraph graph(first, count, forest, out.scratch());
  graph.start(edges);
  Elimination::Scratch& scratch = out.scratch();
  out.place.resize(first + count), scratch.node_at.resize(first + count), scratch.joint_at.resize(first + count);
  std::uint64_t products = 0;
  const std::size_t begin = out.rows.size();
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t node = graph.least_degree();
    out.place[first + node] = first + k, scratch.node_at[first + k] = first + node,
                      scratch.joint_at[first + k] = graph.joint_of(node);
    const std::span<const std::uint32_t> below = graph.remove(node);
    for (const std::uint32_t i : below) out.rows.push_back(first + i);
    out.column.push_back(static_cast<std::uint32_t>(out.rows.size()));
    products += 1 + below.size() + below.size() * (below.size() + 1) / 2;
    if (products > most) return give_up(first, count, begin, out), products;
  }
  for (std::size_t k = begin; k < out.rows.size(); ++k) out.rows[k] = out.place[out.rows[k]];
  for (std::uint32_t k = first; k < first + count; ++k)
    std::sort(out.rows.begin() + out.column[k], out.rows.begin() + out.column[k + 1]);
  return products;
}

}  // namespace carom::dynamics
