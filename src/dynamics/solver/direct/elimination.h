// In which order bodies are eliminated from a system of equations that couples those which touch, and what fills in.
#pragma once

#include <span>

#include "core/memory.h"

namespace carom::dynamics {

/// Two nodes whose block is not zero, but for what a joint of the forest makes of it.
struct Edge {
  std::uint32_t a, b;
  friend bool operator==(const Edge&, const Edge&) = default;
};

/// A joint of a forest, and the nodes that it holds.
struct TreeJoint {
  std::uint32_t a, b;  // nodes, or kInvalid: what is no node
  std::uint32_t first_row, rows, first_drive, drives;
  friend bool operator==(const TreeJoint&, const TreeJoint&) = default;
};

/// Orders of elimination and columns of the Cholesky factors of several systems, one after the other. A system owns a
/// run of nodes; its places are the same run.
struct Elimination {
  explicit Elimination(Memory* m) : place(m), column(m), rows(m), memory_(m) {}

  Array<std::uint32_t> place;   // by node: when it is eliminated
  Array<std::uint32_t> column;  // [places + 1] by place: where its column begins in rows
  Array<std::uint32_t> rows;    // places of the blocks below the diagonal, ascending within a column

  struct Scratch {
    explicit Scratch(Memory* m)
        : neighbour_begin(m),
          neighbour(m),
          degree(m),
          mark(m),
          first(m),
          link(m),
          begin(m),
          member(m),
          joints(m),
          joint(m),
          node_at(m),
          joint_at(m),
          ordered_edges(m),
          ordered_begin(m),
          edges(m),
          products(m) {}
    Array<std::uint32_t> neighbour_begin, neighbour, degree, mark, first, link, begin, member;
    Array<std::uint32_t> joints,
        joint;  // by node: joints of the forest that are left, and all of their numbers by exclusive or
    // Of the order that was found last, by place: the node; and the joint of its system's forest that holds it to one
    // eliminated later, or kInvalid.
    Array<std::uint32_t> node_at, joint_at;
    Array<Edge> ordered_edges;           // of all systems, as they were ordered last
    Array<std::uint32_t> ordered_begin;  // where those of a system begin
    Array<Edge> edges;                   // of all systems, as they are now
    Array<std::uint64_t> products;       // of blocks, of a factorisation, by system
  };
  /// Made when first asked for: most worlds eliminate nothing.
  Scratch& scratch() {
    if (!scratch_) scratch_ = make_owned<Scratch>(memory_, memory_);
    return *scratch_;
  }

  void forget_edges() {
    if (scratch_) scratch_->edges.clear();
  }
  const Scratch& scratch() const { return *scratch_; }  // of one that has ordered a system

  /// Whether nothing is below the diagonal of a place: of a joint's child that none but its parent takes along.
  bool is_bare(std::uint32_t at) const { return column[at] == column[at + 1]; }

  void clear() { place.clear(), column.assign(1, 0), rows.clear(); }

 private:
  Memory* memory_;
  Owned<Scratch> scratch_;
};

/// Add a system: minimum degree on the quotient graph, ties to the lowest node.
/// @param first, count  nodes of the system; nodes of earlier systems are below first
/// @param edges  within the system; repeats are harmless
/// @param forest  joints, without loops: a node goes only once all its neighbours there but one are gone. That one is coupled
///                to whatever it is coupled to; if that is nothing else, it takes the node along and there is no block
/// @param most  block products: what takes more is not completed, and its columns are empty
/// @return block products that a factorisation takes; more than `most` where it was not completed
/// @source [George1989]
std::uint64_t eliminate(std::uint32_t first, std::uint32_t count, std::span<const Edge> edges,
                        std::span<const TreeJoint> forest, std::uint64_t most, Elimination& out);

}  // namespace carom::dynamics
