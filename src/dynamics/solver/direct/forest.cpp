// A forest of bodies on joints: from the leaves to the roots and back.
#include "dynamics/solver/direct/forest.h"

#include <algorithm>

namespace carom::dynamics {
namespace {

/// m, about how far its mass is from its middle: turns by it count as places do.
Real size_of(const ConeBody& b) { return std::sqrt(b.inertia.trace() * b.inv_mass / 2); }

/// The rows of a joint as they act on its child, angles times its size; made a basis of what they lock and leave free.
class LockedRows {
 public:
  LockedRows(std::span<const ConeLink> locks, bool child_is_a, Real size) : size_(size) {
    for (const ConeLink& c : locks) {
      const Vec3 &d = child_is_a ? c.d_a : c.d_b, turn = child_is_a ? c.w_a : c.w_b;
      add({d, turn / size});
    }
  }

  void write_basis(TreeNode& to) const {
    Real q[kDof][kDof] = {};
    for (std::uint32_t i = 0; i < kDof; ++i) {
      q[i][i] = 1;
      for (std::uint32_t k = rank_; k-- > 0;) reflect(k, q[i]);
    }
    to.freedom = kDof - static_cast<int>(rank_);
    std::copy(place_, place_ + kDof, to.place);
    for (int k = 0; k < to.freedom; ++k) write(q[static_cast<int>(rank_) + k], to.basis.x[k]);
    // Columns of q^T lower^-1.
    for (std::uint32_t i = 0; i < rank_; ++i) {
      Real inverse[kDof], along[kDof] = {};
      for (std::uint32_t k = i; k < rank_; ++k) {
        Real s = k == i ? 1 : 0;
        for (std::uint32_t l = i; l < k; ++l) s -= lower_[k][l] * inverse[l];
        inverse[k] = s / lower_[k][k];
        for (int c = 0; c < kDof; ++c) along[c] += inverse[k] * q[k][c];
      }
      write(along, to.basis.x[to.freedom + static_cast<int>(i)]);
    }
  }

 private:
  // Of a row, what others do not imply.
  static constexpr Real kImplied = 1e-9;

  void add(const Vec6& row) {
    Real a[kDof];
    for (int c = 0; c < kDof; ++c) a[c] = row[c];
    for (std::uint32_t k = 0; k < rank_; ++k) reflect(k, a);
    Real tail2 = 0;
    for (std::uint32_t c = rank_; c < kDof; ++c) tail2 += a[c] * a[c];
    if (rank_ == kDof || !(tail2 > kImplied * kImplied * row.squared_norm())) {
      place_[rows_++] = kDof;
      return;
    }
    const Real tail = a[rank_] > 0 ? -std::sqrt(tail2) : std::sqrt(tail2);
    for (std::uint32_t c = 0; c < rank_; ++c) lower_[rank_][c] = a[c];
    lower_[rank_][rank_] = tail;
    for (std::uint32_t c = 0; c < kDof; ++c) mirror_[rank_][c] = c < rank_ ? 0 : a[c];
    mirror_[rank_][rank_] -= tail;
    twice_[rank_] = 1 / (tail * (tail - a[rank_]));
    place_[rows_++] = static_cast<std::uint8_t>(rank_++);
  }
  void reflect(std::uint32_t k, Real* a) const {
    Real s = 0;
    for (std::uint32_t c = k; c < kDof; ++c) s += mirror_[k][c] * a[c];
    s *= twice_[k];
    for (std::uint32_t c = k; c < kDof; ++c) a[c] -= s * mirror_[k][c];
  }
  void write(const Real* from, Real* to) const {
    for (int c = 0; c < 3; ++c) to[c] = from[c], to[3 + c] = from[3 + c] / size_;
  }

  Real size_;
  std::uint32_t rows_ = 0, rank_ = 0;
  std::uint8_t place_[kDof] = {};  // @see TreeNode::place
  Real lower_[kDof][kDof], mirror_[kDof][kDof], twice_[kDof];
};

std::span<ConeLink> locks_of(ConeProblem& problem, const TreeNode& node) {
  return problem.locks.subspan(node.first_row, node.rows);
}

Vec6 operator*(const Block& m, const Vec6& v) {
  Vec6 y;
  for (int r = 0; r < kDof; ++r) {
    Real s = 0;
    for (int c = 0; c < kDof; ++c) s += m.x[r][c] * v[c];
    y[r] = s;
  }
  return y;
}

void subtract_coupled(const TreeNode& node, const Vec6& y, Vec6& from) {
  for (int r = 0; r < kDof; ++r)
    for (int k = 0; k < node.freedom; ++k) from[r] -= node.coupling.x[r][k] * y[k];
}

/// Backwards over a forest: momentum of each node in scratch, what is left of it for the parent. ConeBody::step: y.
/// @param shift  (node index) -> velocity that the child has beyond X v_parent + S q, or null
template <class Shift>
void gather_momentum(ConeProblem& problem, const Shift& shift) {
  for (std::uint32_t j = 0; j < problem.tree.size(); ++j) {
    const TreeNode& node = problem.tree[j];
    if (node.is_alone()) continue;
    Vec6& momentum = problem.scratch[problem.first + j];
    Vec6& y = problem.bodies[problem.body_at(j)].step;
    if (!node.is_held()) {
      y = momentum;
      solve_lower(node.factor, y);
      continue;
    }
    if (const Vec6* const t = shift(j)) momentum -= node.inertia * *t;
    y = freely(node, momentum);
    solve_lower(node.factor, y, node.freedom);
    if (node.parent == kInvalid) continue;
    subtract_coupled(node, y, momentum);
    problem.scratch[node.parent] += handed_over(node, momentum);
  }
}

/// Forwards: ConeBody::step, from y to velocities.
template <class Shift>
void spread_velocities(ConeProblem& problem, const Shift& shift) {
  for (std::uint32_t j = static_cast<std::uint32_t>(problem.tree.size()); j-- > 0;) {
    const TreeNode& node = problem.tree[j];
    if (node.is_alone()) continue;
    Vec6& v = problem.bodies[problem.body_at(j)].step;
    if (!node.is_held()) {
      solve_upper(node.factor, v);
      continue;
    }
    Vec6 y = v, along = Vec6::zero();
    if (node.parent != kInvalid) {
      along = with_parent(node, problem.bodies[problem.body_at(node.parent - problem.first)].step);
      for (int r = 0; r < kDof; ++r)
        for (int k = 0; k < node.freedom; ++k) y[k] -= node.coupling.x[r][k] * along[r];
    }
    solve_upper(node.factor, y, node.freedom);
    if (const Vec6* const t = shift(j)) along += *t;
    add_free(node, y, along);
    v = along;
  }
}

constexpr auto kNoShift = [](std::uint32_t) -> const Vec6* { return nullptr; };

}  // namespace

void plant(std::span<TreeNode> nodes, std::span<const TreeJoint> joints, Elimination& order, std::uint32_t first) {
  for (TreeNode& node : nodes) node.parent = kInvalid, node.rows = 0, node.freedom = kDof, node.has_children = false;
  const Elimination::Scratch& of = order.scratch();
  for (std::uint32_t j = 0; j < nodes.size(); ++j) {
    const std::uint32_t k = of.joint_at[first + j];
    if (k == kInvalid) continue;
    TreeNode& node = nodes[j];
    node.first_row = joints[k].first_row, node.rows = joints[k].rows;
    node.child_is_a = joints[k].a == of.node_at[first + j];
    const std::uint32_t parent = node.child_is_a ? joints[k].b : joints[k].a;
    if (parent == kInvalid) continue;
    node.parent = order.place[parent];
    nodes[node.parent - first].has_children = true;
  }
}

void articulate(ConeProblem& problem) {
  const std::span<TreeNode> tree = problem.tree;
  for (std::uint32_t j = 0; j < tree.size(); ++j)
    if (!tree[j].is_alone()) tree[j].inertia = mass_block(problem.bodies[problem.body_at(j)]);
  for (std::uint32_t j = 0; j < tree.size(); ++j) {
    TreeNode& node = tree[j];
    if (node.is_alone()) continue;
    if (!node.is_held()) {
      node.factor = node.inertia;
      factor_in_place(node.factor);  // of masses alone it can't fail
      continue;
    }
    const ConeBody& body = problem.bodies[problem.body_at(j)];
    LockedRows(locks_of(problem, node), node.child_is_a, size_of(body)).write_basis(node);
    couple(node);
    if (node.parent == kInvalid) continue;
    node.arm = body.place - problem.bodies[problem.body_at(node.parent - problem.first)].place;
    add_left(node, tree[node.parent - problem.first].inertia);
  }
}

void respond(ConeProblem& problem) {
  if (problem.tree.empty()) {
    for (ConeBody& b : bodies_of(problem)) b.step = velocity_of(b, b.gradient);
    return;
  }
  for (std::uint32_t j = 0; j < problem.tree.size(); ++j) {
    ConeBody& b = problem.bodies[problem.body_at(j)];
    if (problem.tree[j].is_alone())
      b.step = velocity_of(b, b.gradient);
    else
      problem.scratch[problem.first + j] = b.gradient;
  }
  gather_momentum(problem, kNoShift);
  spread_velocities(problem, kNoShift);
}

void obey_locks(ConeProblem& problem) {
  if (problem.tree.empty()) return;
  for (std::uint32_t j = 0; j < problem.tree.size(); ++j) {
    const TreeNode& node = problem.tree[j];
    problem.scratch[problem.first + j].set_zero();
    Vec6& shift = problem.bodies[problem.body_at(j)].change;
    shift.set_zero();
    const std::span<const ConeLink> locks = locks_of(problem, node);
    for (std::uint32_t i = 0; i < locks.size(); ++i) {
      if (node.is_implied(i)) continue;
      const Real u = locks[i].surface + relative<&ConeBody::v>(problem.bodies, locks[i]);
      const Real lacks = node.child_is_a ? u - locks[i].low : locks[i].low - u;
      for (int c = 0; c < kDof; ++c) shift[c] += lacks * node.along(i)[c];
    }
  }
  const auto shift = [&](std::uint32_t j) { return &problem.bodies[problem.body_at(j)].change; };
  gather_momentum(problem, shift);
  spread_velocities(problem, shift);
  for (std::uint32_t j = 0; j < problem.tree.size(); ++j)
    if (ConeBody& b = problem.bodies[problem.body_at(j)]; !problem.tree[j].is_alone()) b.v += b.step;
}

void find_lock_impulses(ConeProblem& problem) {
  if (problem.tree.empty()) return;
  find_momentum(problem);
  for (std::uint32_t j = 0; j < problem.tree.size(); ++j) {
    const ConeBody& b = problem.bodies[problem.body_at(j)];
    problem.scratch[problem.first + j] = momentum_of(b, b.v - b.unheld) - b.gradient;
  }
  for (std::uint32_t j = 0; j < problem.tree.size(); ++j) {
    const TreeNode& node = problem.tree[j];
    if (!node.is_held()) continue;
    const Vec6& wrench = problem.scratch[problem.first + j];
    const std::span<ConeLink> locks = locks_of(problem, node);
    for (std::uint32_t i = 0; i < locks.size(); ++i) {
      Real p = 0;
      for (int c = 0; !node.is_implied(i) && c < kDof; ++c) p += node.along(i)[c] * wrench[c];
      locks[i].p = node.child_is_a ? -p : p;
      locks[i].u = locks[i].low;
    }
    if (node.parent != kInvalid) problem.scratch[node.parent] += handed_over(node, wrench);
  }
}

}  // namespace carom::dynamics
