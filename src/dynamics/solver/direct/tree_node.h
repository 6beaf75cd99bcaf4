// Joints in their true freedom: of two bodies that a joint holds, the one that is eliminated first goes as the other
// takes it along, and as the joint lets it go.
//
//     v_child = X v_parent + S q + t
//
// X takes the child along as if both were one body, t obeys what the joint's locks ask, S spans what they leave free. In
// Newton's matrix such a child is as many unknowns as its joint has degrees of freedom. Locks are no rows of the problem:
// they hold to rounding, whatever the masses. Joints of a group form a forest. A joint that closes a loop has rows still,
// as has one of fewer than kLeastLocks.
//
// Limits and drives of such a joint say how fast it goes along S: in Newton's matrix they add to the child's own unknowns.
// Nothing here knows kinds of joints: S comes from the locked rows as they stand.
// @source [Featherstone2008], articulated inertias; @oracle tests/unit/dynamics/test_forest
#pragma once

#include <cstdint>

#include "core/invalid.h"
#include "dynamics/solver/direct/locked_rows.h"

namespace carom::dynamics {

/// A body, by its place in the order of elimination.
struct TreeNode {
  std::uint32_t parent;               // place: kInvalid where it is free, or held by what impulses do not move
  std::uint32_t first_row, rows;      // of its joint's locks, in ConeProblem::locks; 0: it is free
  std::uint32_t first_drive, drives;  // likewise its limits and drives, in ConeProblem::links
  bool child_is_a;                    // of the joint
  bool has_children;

  // of where the bodies are
  int freedom;  // columns of S
  Block basis;  // S^T, `freedom` rows
  LockedRows locks{1};
  Vec3 arm;  // m, from the parent's centre of mass to its own: X
  // with the masses there
  Block inertia;   // 6x6, its own and of what it carries
  Block factor;    // freedom x freedom: Cholesky's, of S^T inertia S
  Block coupling;  // 6 x freedom: inertia S factor^-T
  // of a round
  Block driven;  // freedom x freedom: what limits and drives add to S^T M S

  bool is_held() const { return rows > 0; }
  bool is_alone() const { return !is_held() && !has_children; }
};

/// f(n), n a constant where it is that of most joints.
template <class F>
auto with_freedom(int n, const F& f) {
  switch (n) {
    case 1:
      return f(std::integral_constant<int, 1>());
    case 2:
      return f(std::integral_constant<int, 2>());
    case 3:
      return f(std::integral_constant<int, 3>());
    default:
      return f(n);
  }
}

/// X v: of the child, as if it were one body with its parent.
inline Vec6 with_parent(const TreeNode& node, const Vec6& v) {
  return {v.linear() + v.angular().cross(node.arm), v.angular()};
}
/// X^T m: of the parent, from momentum of the child.
inline Vec6 handed_over(const TreeNode& node, const Vec6& m) {
  return {m.linear(), m.angular() + node.arm.cross(m.linear())};
}
/// S^T v
template <class N>
Vec6 freely(const TreeNode& node, const Vec6& v, N n) {
  Vec6 y;
  for (int k = 0; k < n; ++k) {
    Real s = 0;
    for (int c = 0; c < kDof; ++c) s += node.basis.x[k][c] * v[c];
    y[k] = s;
  }
  return y;
}
/// to += S q
template <class N>
void add_free(const TreeNode& node, const Vec6& q, Vec6& to, N n) {
  for (int k = 0; k < n; ++k)
    for (int c = 0; c < kDof; ++c) to[c] += q[k] * node.basis.x[k][c];
}
/// a := a X, @see with_parent().
inline void take_along(Block& a, const Vec3& arm) {
  for (Real* const row : a.x) {
    const Vec3 turns = Vec3::from(row).cross(arm);
    row[3] -= turns.x(), row[4] -= turns.y(), row[5] -= turns.z();
  }
}

/// a := X^T a, @see handed_over().
inline void hand_over(Block& a, const Vec3& arm) {
  for (int j = 0; j < kDof; ++j) {
    const Vec3 moment = arm.cross(Vec3(a.x[0][j], a.x[1][j], a.x[2][j]));
    a.x[3][j] += moment.x(), a.x[4][j] += moment.y(), a.x[5][j] += moment.z();
  }
}

/// a S factor^-T, in the first columns.
template <class N>
void free_columns(const Block& a, const Block& basis, const Block& factor, Block& to, N n) {
  for (int i = 0; i < kDof; ++i)
    for (int k = 0; k < n; ++k) {
      Real s = 0;
      for (int c = 0; c < kDof; ++c) s += a.x[i][c] * basis.x[k][c];
      for (int l = 0; l < k; ++l) s -= factor.x[k][l] * to.x[i][l];
      to.x[i][k] = s / factor.x[k][k];
    }
}

/// S^T m S + more, factored.   @return whether it was definite
template <class N>
bool factor_freed(const Block& m, const Block& basis, const Block* more, Block& to, N n) {
  for (int k = 0; k < n; ++k) {
    Real row[kDof] = {};
    for (int r = 0; r < kDof; ++r)
      for (int c = 0; c < kDof; ++c) row[c] += basis.x[k][r] * m.x[r][c];
    for (int l = 0; l <= k; ++l) {
      Real s = more ? more->x[k][l] : 0;
      for (int c = 0; c < kDof; ++c) s += row[c] * basis.x[l][c];
      to.x[k][l] = s;
    }
  }
  return factor_in_place(to, n);
}

/// Of a child: the factor of S^T inertia S, and inertia S factor^-T. Of masses it can't fail.
inline void couple(TreeNode& node) {
  with_freedom(node.freedom, [&](auto n) {
    factor_freed(node.inertia, node.basis, nullptr, node.factor, n);
    free_columns(node.inertia, node.basis, node.factor, node.coupling, n);
  });
}

/// What a child leaves to its parent: to += X^T (inertia - coupling coupling^T) X.
inline void add_left(const TreeNode& node, Block& to) {
  Block left = node.inertia;
  with_freedom(node.freedom, [&](auto n) { subtract_product(left, node.coupling, transposed(node.coupling, n), n); });
  take_along(left, node.arm), hand_over(left, node.arm);
  add(to, left);
}

}  // namespace carom::dynamics
