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

/// Unknowns of a child, in a matrix a: S^T a S = L L^T.
struct FreedColumn {
  Block factor;    // L, freedom x freedom, @see factor_in_place()
  Block coupling;  // L^-1 S^T a, freedom x 6
};

/// A body, by its place in the order of elimination.
struct TreeNode {
  std::uint32_t parent;               // place: kInvalid where it is free, or held by what impulses do not move
  std::uint32_t first_row, rows;      // of its joint's locks, in ConeProblem::locks; 0: it is free
  std::uint32_t first_drive, drives;  // likewise its limits and drives, in ConeProblem::links
  bool child_is_a;                    // of the joint
  bool has_children;
  bool responds;  // it carries a limit or a drive: `response` is asked for

  // of where the bodies are
  int freedom;  // columns of S
  Block basis;  // S^T, `freedom` rows
  LockedRows locks{1};
  Vec3 arm;  // m, from the parent's centre of mass to its own: X
  // with the masses there
  Block inertia;        // 6x6, its own and of what it carries
  Block response;       // 6x6, velocities by momentum on it, with all of the forest, @see responds
  FreedColumn by_mass;  // of it; of what is free the factor alone
  // of a round
  Vec6 pushed;         // N s or N m s, of limits and drives along S; 0 outside a round
  Vec6 q;              // m/s or rad/s, along S, of what the last solve gave
  Block driven;        // freedom x freedom: what limits and drives add to S^T M S
  FreedColumn by_all;  // of Newton's matrix
  bool is_bare;        // nothing but its joint couples it to what is eliminated later
  bool is_stale;       // to be factored anew: what acts on it has changed, or on what it carries

  bool is_held() const { return rows > 0; }
  bool is_alone() const { return !is_held() && !has_children; }
};

/// f(n), n a constant where it is that of most joints.
template <class F>
auto with_freedom(int n, const F& f) {
  switch (n) {
    case 1:
      return f(Size<1>());
    case 2:
      return f(Size<2>());
    case 3:
      return f(Size<3>());
    default:
      return f(n);
  }
}

/// X v: of the child, as if it were one body with its parent.
inline RowOfTwos with_parent(const TreeNode& node, const RowOfTwos& v) {
  return {v.linear() + v.angular().cross(node.arm), v.angular()};
}
/// X^T m: of the parent, from momentum of the child.
inline RowOfTwos handed_over(const TreeNode& node, const RowOfTwos& m) {
  return {m.linear(), m.angular() + node.arm.cross(m.linear())};
}
/// S^T v
template <class N>
Vec6 freely(const TreeNode& node, const RowOfTwos& v, N n) {
  Vec6 y;
  for (int k = 0; k < n; ++k) y[k] = row_of(node.basis, k).dot(v);
  return y;
}
/// to += S q
template <class N>
void add_free(const TreeNode& node, const Vec6& q, RowOfTwos& to, N n) {
  for (int k = 0; k < n; ++k) to.add(q[k], row_of(node.basis, k));
}
/// Likewise of momentum on a child, with what pushes it along S.
template <class N>
Vec6 freely_pushed(const TreeNode& node, const RowOfTwos& momentum, N n) {
  Vec6 y = freely(node, momentum, n);
  for (int k = 0; k < n; ++k) y[k] += node.pushed[k];
  return y;
}
/// Of momentum on a child: y of its unknowns; what they leave is its parent's.
template <class N>
Vec6 take_freely(const TreeNode& node, const FreedColumn& column, RowOfTwos& momentum, N n) {
  Vec6 y = freely_pushed(node, momentum, n);
  solve_lower(column.factor, y, n);
  for (int k = 0; k < n; ++k) momentum.subtract(y[k], row_of(column.coupling, k));
  return y;
}
/// q of its unknowns, from y and the velocity at which its parent takes it along.
template <class N>
Vec6 go_freely(const FreedColumn& column, Vec6 y, const RowOfTwos& along, N n) {
  for (int k = 0; k < n; ++k) y[k] -= row_of(column.coupling, k).dot(along);
  solve_upper(column.factor, y, n);
  return y;
}
/// Row by row: a X, @see with_parent().
inline RowOfTwos taken_along(const RowOfTwos& row, const Vec3& arm) {
  return {row.linear(), row.angular() - row.linear().cross(arm)};
}
/// Of X^T a the last three rows, @see handed_over(); the first three are those of a: x, y, z.
/// @param row  (index) -> of a   @param f  (index from 0, row)
template <class Row, class F>
void each_moment(const Row& row, const RowOfTwos& x, const RowOfTwos& y, const RowOfTwos& z, const Vec3& arm,
                 const F& f) {
  const auto moment = [&](int i, const RowOfTwos& next, Real by_next, const RowOfTwos& last, Real by_last) {
    RowOfTwos sum = row(3 + i);
    sum.add(by_next, last), sum.subtract(by_last, next);
    f(i, sum);
  };
  moment(0, y, arm.y(), z, arm.z()), moment(1, z, arm.z(), x, arm.x()), moment(2, x, arm.x(), y, arm.y());
}
/// to += X^T a   @param row  (index) -> of a
template <class Row>
void add_handed_over(const Row& row, const Vec3& arm, Block& to) {
  const RowOfTwos x = row(0), y = row(1), z = row(2);
  add_to_row(to, 0, x), add_to_row(to, 1, y), add_to_row(to, 2, z);
  each_moment(row, x, y, z, arm, [&](int i, const RowOfTwos& moment) { add_to_row(to, 3 + i, moment); });
}

/// S^T a, in the first rows.
template <class N>
void free_rows(const Block& a, const Block& basis, Block& to, N n) {
  for (int k = 0; k < n; ++k) {
    RowOfTwos row = row_of(a, 0);
    row.multiply(basis.x[k][0]);
    for (int i = 1; i < kDof; ++i) row.add(basis.x[k][i], row_of(a, i));
    row.store(to.x[k]);
  }
}

/// Unknowns of a child in a symmetric matrix.
/// @param more  freedom x freedom, that S^T a S has beside   @return whether it was definite: of masses it is
template <class N>
bool free_column(const Block& a, const Block& basis, const Block* more, FreedColumn& to, N n) {
  free_rows(a, basis, to.coupling, n);
  for (int k = 0; k < n; ++k)
    for (int l = 0; l <= k; ++l)
      to.factor.x[k][l] = row_of(to.coupling, k).dot(row_of(basis, l)) + (more ? more->x[k][l] : 0);
  if (!factor_in_place(to.factor, n)) return false;
  solve_rows(to.factor, to.coupling, n);
  return true;
}

/// What a child leaves of a symmetric matrix to its parent: to += X^T (a - coupling^T coupling) X.
template <class N>
void add_left(const Block& a, const FreedColumn& column, const Vec3& arm, Block& to, N n) {
  const auto left = [&](int i) {
    RowOfTwos row = row_of(a, i);
    for (int k = 0; k < n; ++k) row.subtract(column.coupling.x[k][i], row_of(column.coupling, k));
    return row;
  };
  const RowOfTwos x = left(0), y = left(1), z = left(2);
  Vec3 moment[3];  // of linear velocities; across the diagonal forces of angular ones
  each_moment(left, x, y, z, arm, [&](int i, const RowOfTwos& row) {
    moment[i] = row.linear();
    add_to_row(to, 3 + i, taken_along(row, arm));
  });
  const auto forces = [&](int i) { return Vec3(moment[0][i], moment[1][i], moment[2][i]); };
  add_to_row(to, 0, {x.linear(), forces(0)});
  add_to_row(to, 1, {y.linear(), forces(1)});
  add_to_row(to, 2, {z.linear(), forces(2)});
}

}  // namespace carom::dynamics
