// A forest of bodies on joints: from the leaves to the roots and back.
#include "dynamics/solver/direct/forest.h"

#include <algorithm>

namespace carom::dynamics {
namespace {

/// m, about how far its mass is from its middle: turns by it count as places do.
Real size_of(const ConeBody& b) { return std::sqrt(b.inertia.trace() * b.inv_mass / 2); }

/// How fast the child makes a row go.
RowOfTwos row_of_child(const ConeLink& c, bool child_is_a) {
  return child_is_a ? RowOfTwos(-c.d_a, -c.w_a) : RowOfTwos(c.d_b, c.w_b);
}

std::span<ConeLink> locks_of(ConeProblem& problem, const TreeNode& node) {
  return problem.locks.subspan(node.first_row, node.rows);
}

/// Backwards over a forest: momentum of each node in scratch, what is left of it for the parent. ConeBody::step: y.
/// @param shift  (node index) -> velocity that the child has beyond X v_parent + S q, or null
template <class Shift>
void gather_momentum(ConeProblem& problem, const Shift& shift) {
  for (std::uint32_t j = 0; j < problem.tree.size(); ++j) {
    const TreeNode& node = problem.tree[j];
    if (node.is_alone()) continue;
    const Vec6& gathered = problem.scratch[problem.first + j];
    Vec6& y = problem.bodies[problem.body_at(j)].step;
    if (!node.is_held()) {
      y = gathered;
      solve_lower(node.by_mass.factor, y);
      continue;
    }
    RowOfTwos momentum = row_of(gathered);
    if (const Vec6* const t = shift(j)) momentum.subtract(product(node.inertia, *t));
    with_freedom(node.freedom, [&](auto n) { y = take_freely(node, node.by_mass, momentum, n); });
    if (node.parent != kInvalid) add_to(problem.scratch[node.parent], handed_over(node, momentum));
  }
}

/// Forwards: ConeBody::step, from y to velocities.
template <class Shift>
void spread_velocities(ConeProblem& problem, const Shift& shift) {
  for (std::uint32_t j = static_cast<std::uint32_t>(problem.tree.size()); j-- > 0;) {
    TreeNode& node = problem.tree[j];
    if (node.is_alone()) continue;
    Vec6& v = problem.bodies[problem.body_at(j)].step;
    if (!node.is_held()) {
      solve_upper(node.by_mass.factor, v);
      continue;
    }
    with_freedom(node.freedom, [&](auto n) {
      RowOfTwos along = RowOfTwos::zero();
      if (node.parent != kInvalid)
        along = with_parent(node, row_of(problem.bodies[problem.body_at(node.parent - problem.first)].step));
      node.q = go_freely(node.by_mass, v, along, n);
      if (const Vec6* const t = shift(j)) along.add(row_of(*t));
      add_free(node, node.q, along, n);
      along.store(v.at);
    });
  }
}

constexpr auto kNoShift = [](std::uint32_t) -> const Vec6* { return nullptr; };

}  // namespace

void plant(std::span<TreeNode> nodes, std::span<const TreeJoint> joints, Elimination& order, std::uint32_t first) {
  for (TreeNode& node : nodes)
    node.pushed.set_zero(), node.parent = kInvalid, node.rows = node.drives = 0, node.freedom = kDof,
                            node.has_children = false, node.is_stale = true;
  const Elimination::Scratch& of = order.scratch();
  for (std::uint32_t j = 0; j < nodes.size(); ++j) {
    const std::uint32_t k = of.joint_at[first + j];
    if (k == kInvalid) continue;
    TreeNode& node = nodes[j];
    node.first_row = joints[k].first_row, node.rows = joints[k].rows;
    node.first_drive = joints[k].first_drive, node.drives = joints[k].drives;
    node.child_is_a = joints[k].a == of.node_at[first + j];
    const std::uint32_t parent = node.child_is_a ? joints[k].b : joints[k].a;
    if (parent == kInvalid) continue;
    node.parent = order.place[parent];
    nodes[node.parent - first].has_children = true;
  }
}

namespace {

/// A limit or drive of a joint that gapes acts on the parent where it acts on the child: it asks nothing of both as one
/// body, and gives them no spin.
void act_at_child(ConeLink& c, const TreeNode& node) {
  if (node.child_is_a)
    c.d_b = c.d_a, c.w_b = c.w_a + node.arm.cross(c.d_a);
  else
    c.d_a = c.d_b, c.w_a = c.w_b + node.arm.cross(c.d_b);
}

/// How fast limits and drives go along S.
void free_drives(ConeProblem& problem, TreeNode& node) {
  for (ConeLink& c : problem.links.subspan(node.first_drive, node.drives)) {
    c.is_of_child = true, c.child = static_cast<std::uint32_t>(&node - problem.tree.data());
    if (node.parent != kInvalid) act_at_child(c, node);
    c.of_child = freely(node, row_of_child(c, node.child_is_a), node.freedom);
  }
  set_zero(node.driven);
}

/// X a X^T of a symmetric matrix: velocities of a child that is taken along, by momentum handed over. What rounding makes of it is
/// symmetric: the rest would grow from link to link.
Block of_parent(const Block& a, const TreeNode& child) {
  Block half, whole;
  each_row([&](int i) { with_parent(child, row_of(a, i)).store(half.x[i]); });
  set_zero(whole);
  add_transposed(whole, half);
  each_row([&](int i) { with_parent(child, row_of(whole, i)).store(half.x[i]); });
  copy(half, whole);
  add_transposed(whole, half);
  each_row([&](int i) {
    RowOfTwos row = row_of(whole, i);
    row.multiply(0.5);
    row.store(whole.x[i]);
  });
  return whole;
}

/// (I - t c^T) a (I - c t^T) + t t^T, of a symmetric a: a - w t^T - t w^T, to the bit.
void let_go(Block& a, const RowOfTwos& c, const RowOfTwos& t) {
  Vec6 to, free;
  c.store(to.at), t.store(free.at);
  RowOfTwos w = product(a, to);
  w.subtract((w.dot(c) + 1) / 2, t);
  Vec6 by;
  w.store(by.at);
  each_row([&](int i) {
    RowOfTwos change = w;
    change.multiply(free[i]), change.add(by[i], t);
    RowOfTwos row = row_of(a, i);
    row.subtract(change);
    row.store(a.x[i]);
  });
}

/// What an impulse of a limit or drive makes of its own velocity: its child goes along S, and its parent as what hangs on it
/// lets it. The bodies' own inertia is no measure of that: joints of one body's several axes have next to none between them. Rotors
/// go along, of joints of one freedom.
/// @param by_parent  as the parent goes, by momentum handed over; null: it does not
void find_responses_of_drives(ConeProblem& problem, const TreeNode& node, const Block* by_parent) {
  const std::span<ConeLink> drives = problem.links.subspan(node.first_drive, node.drives);
  Real resist = 0;  // kg or kg m^2 along S, of what gives way by itself
  for (ConeLink& c : drives) {
    if (!(c.k > 0)) continue;
    if (node.freedom == 1 && c.low == c.high && c.give > 0 && c.most == kInfinity)
      resist += c.of_child[0] * c.of_child[0] / c.give;
    Vec6 z = c.of_child;
    solve_lower(node.by_mass.factor, z, node.freedom);
    RowOfTwos handed = RowOfTwos::zero();
    c.k = 0;
    for (int k = 0; k < node.freedom; ++k) c.k += z[k] * z[k], handed.add(z[k], row_of(node.by_mass.coupling, k));
    if (!by_parent) continue;
    Vec6 m;
    handed.store(m.at);
    c.k += product(*by_parent, m).dot(handed);
  }
  if (!(resist > 0)) return;
  for (ConeLink& c : drives)
    if (const Real along = c.of_child[0] * c.of_child[0]; c.k > 0) c.k *= along / (along + c.k * resist);
}

/// From the roots to the leaves, as far as there are drives.
/// @param known  TreeNode::response is
void find_responses(ConeProblem& problem, bool known) {
  for (TreeNode& node : problem.tree) node.responds = false;
  for (TreeNode& node : problem.tree)
    if (node.parent != kInvalid && (node.responds || node.drives > 0))
      problem.tree[node.parent - problem.first].responds = true;
  for (std::uint32_t j = static_cast<std::uint32_t>(problem.tree.size()); j-- > 0;) {
    TreeNode& node = problem.tree[j];
    if (!(node.responds || node.drives > 0)) continue;
    if (!node.is_held()) {
      for (int i = 0; !known && i < kDof; ++i) {
        Vec6 v;
        v.set_zero(), v[i] = 1;
        solve_lower(node.by_mass.factor, v), solve_upper(node.by_mass.factor, v);
        row_of(v).store(node.response.x[i]);
      }
      continue;
    }
    Block by_parent;
    set_zero(by_parent);
    if (node.parent != kInvalid) by_parent = of_parent(problem.tree[node.parent - problem.first].response, node);
    find_responses_of_drives(problem, node, node.parent != kInvalid ? &by_parent : nullptr);
    if (known || !node.responds) continue;
    Block freed = node.basis;
    solve_rows(node.by_mass.factor, freed, node.freedom);
    for (int k = 0; k < node.freedom; ++k) let_go(by_parent, row_of(node.by_mass.coupling, k), row_of(freed, k));
    copy(by_parent, node.response);
  }
}

/// S, from what is locked.
void free_child(ConeProblem& problem, TreeNode& node) {
  node.freedom = node.locks.freedom();
  for (int k = 0; k < node.freedom; ++k) node.locks.free(k, node.basis.x[k]);
  free_drives(problem, node);
}

}  // namespace

void articulate(ConeProblem& problem) {
  const std::span<TreeNode> tree = problem.tree;
  for (std::uint32_t j = 0; j < tree.size(); ++j)
    if (!tree[j].is_alone()) put_masses(problem.bodies[problem.body_at(j)], tree[j].inertia);
  for (std::uint32_t j = 0; j < tree.size(); ++j) {
    TreeNode& node = tree[j];
    if (node.is_alone()) continue;
    if (!node.is_held()) {
      copy(node.inertia, node.by_mass.factor);
      factor_in_place(node.by_mass.factor);  // of masses alone it can't fail
      continue;
    }
    const ConeBody& body = problem.bodies[problem.body_at(j)];
    node.locks = LockedRows(size_of(body));
    for (const ConeLink& c : locks_of(problem, node)) node.locks.add(row_of_child(c, node.child_is_a));
    if (node.parent != kInvalid)
      node.arm = body.place - problem.bodies[problem.body_at(node.parent - problem.first)].place;
    free_child(problem, node);
    with_freedom(node.freedom, [&](auto n) {
      free_column(node.inertia, node.basis, nullptr, node.by_mass, n);
      if (node.parent != kInvalid)
        add_left(node.inertia, node.by_mass, node.arm, tree[node.parent - problem.first].inertia, n);
    });
  }
  find_responses(problem, false);
}

void free_drives(ConeProblem& problem) {
  for (TreeNode& node : problem.tree)
    if (node.is_held()) free_drives(problem, node);
  find_responses(problem, true);
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

namespace {

/// ConeBody::step: the least velocities, by the bodies' masses, at which locks have what is asked.
/// @param asked  (lock) -> m/s or rad/s
template <class Asked>
void lead_to(ConeProblem& problem, const Asked& asked) {
  for (std::uint32_t j = 0; j < problem.tree.size(); ++j) {
    const TreeNode& node = problem.tree[j];
    problem.scratch[problem.first + j].set_zero();
    Vec6& shift = problem.bodies[problem.body_at(j)].change;
    shift.set_zero();
    if (!node.is_held()) continue;
    const std::span<const ConeLink> locks = locks_of(problem, node);
    node.locks.velocity([&](std::uint32_t i) { return asked(locks[i]); }).store(shift.at);
  }
  const auto shift = [&](std::uint32_t j) { return &problem.bodies[problem.body_at(j)].change; };
  gather_momentum(problem, shift);
  spread_velocities(problem, shift);
}

}  // namespace

// With a the acceleration and w the spin, way = h^2 a / 2 + h^3 w x a / 6 + h^4 w x (w x a) / 24 + ...: what locks ask of
// the first term is known, and of the others it is that of bodies that go round as the first term says.
void find_bends(ConeProblem& problem, Real h) {
  for (ConeBody& b : bodies_of(problem)) b.step.set_zero();
  lead_to(problem, [](const ConeLink& lock) { return -lock.curve; });
  for (ConeBody& b : bodies_of(problem)) {
    const Vec3 turn = h * b.v.angular(), next = turn.cross(b.step.linear());
    b.start = {next / 3 + turn.cross(next) / 12, Vec3::zero()};
  }
  lead_to(problem, [&](const ConeLink& lock) { return relative<&ConeBody::start>(problem.bodies, lock) - lock.curve; });
}

void obey_locks(ConeProblem& problem) {
  if (problem.tree.empty()) return;
  lead_to(problem,
          [&](const ConeLink& lock) { return lock.low - lock.surface - relative<&ConeBody::v>(problem.bodies, lock); });
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
    const RowOfTwos wrench = row_of(problem.scratch[problem.first + j]);
    node.locks.find_impulses(wrench, [&](std::uint32_t i, Real p) {
      ConeLink& lock = problem.locks[node.first_row + i];
      lock.p = p, lock.u = lock.low;
    });
    if (node.parent != kInvalid) add_to(problem.scratch[node.parent], handed_over(node, wrench));
  }
}

}  // namespace carom::dynamics
