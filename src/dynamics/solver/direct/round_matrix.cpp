// Newton's matrix: masses, and what joints and contacts add to them.
#include <algorithm>
#include <array>

#include "dynamics/solver/direct/cone.h"
#include "dynamics/solver/direct/round.h"

namespace carom::dynamics {
namespace {

void add(Block& d, int row, int column, const Mat3& m) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) d.x[row + i][column + j] += m(i, j);
}

/// What a spin does at a contact: J = [1, -x] of one body.
struct Turning {
  Mat3 x, back;  // m; back is -x^T

  Turning(const ConeContact& c, const Vec3& r, const Vec3& moment) : x(cross_matrix(r)), back(x) {
    if (!c.is_spread) return;
    x -= outer(c.n, moment);
    back += outer(moment, c.n);
  }
};

/// J^T w J of one body.
void add_own(Block& d, const Mat3& w, const Turning& of, const Mat3& wx) {
  add(d, 0, 0, w);
  add(d, 0, 3, -wx);
  add(d, 3, 0, of.back * w);
  add(d, 3, 3, -(of.back * wx));
}

/// J_a^T w J_b = w [1, -x_b; x_a, -x_a x_b] with a number for w, x_a x_b = r_b r_a^T - r_a.r_b.
void add_isotropic(Block& d, Real w, const Vec3& r_a, const Vec3& r_b) {
  const Real along = w * r_a.dot(r_b);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    d.x[i][i] += w;
    d.x[i][3 + j] += w * r_b[k], d.x[j][3 + i] -= w * r_b[k];
    d.x[3 + i][j] -= w * r_a[k], d.x[3 + j][i] += w * r_a[k];
    for (int l = 0; l < 3; ++l) d.x[3 + i][3 + l] -= w * (r_b[i] * r_a[l]);
    d.x[3 + i][3 + i] += along;
  }
}

/// Where a contact's impulses act on a body, @see ConeContact.
struct ContactArms {
  const Vec3 &r, &moment;
};
/// What add_isotropic() leaves out where a contact is spread.
void add_moments(Block& d, Real w, const Vec3& n, const ContactArms& a, const ContactArms& b) {
  const Vec3 turn = w * (a.r.cross(n) + a.moment), other = w * b.r.cross(n);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      d.x[i][3 + j] += w * n[i] * b.moment[j];
      d.x[3 + i][j] += w * a.moment[i] * n[j];
      d.x[3 + i][3 + j] += turn[i] * b.moment[j] + a.moment[i] * other[j];
    }
}

/// A block without the rows and columns of what is locked.
void strike_out(Block& d, std::uint8_t row_locks, std::uint8_t column_locks) {
  for (int i = 0; i < kDof; ++i)
    for (int j = 0; j < kDof; ++j)
      if ((row_locks >> i | column_locks >> j) & 1) d.x[i][j] = 0;
}

/// w (d, w_row) (d, w_column)^T.
struct LinkArms {
  const Vec3 &d, &w;
};
void add_outer(Block& b, Real w, const LinkArms& r, const LinkArms& c) {
  const Real row[kDof] = {w * r.d.x(), w * r.d.y(), w * r.d.z(), w * r.w.x(), w * r.w.y(), w * r.w.z()};
  const Real column[kDof] = {c.d.x(), c.d.y(), c.d.z(), c.w.x(), c.w.y(), c.w.z()};
  for (int i = 0; i < kDof; ++i)
    for (int j = 0; j < kDof; ++j) b.x[i][j] += row[i] * column[j];
}

/// Where what couples two bodies is added to: the block is of the one eliminated first.
template <class C>
bool is_stale_beside(const ConeProblem& problem, const C& c) {
  return c.beside != kInvalid && problem.is_stale(problem.elimination->place[c.a_later ? c.b : c.a]);
}

/// A body of a row, and how that acts there: u = d.v + w.omega.
struct LinkEnd {
  std::uint32_t body;
  Vec3 d, w;
};
/// f(one, other, block) for each block beside the diagonal that a row has beyond that of A and B; one is eliminated first.
template <class F>
void each_more_beside(const ConeProblem& problem, const ConeLink& c, F&& f) {
  if (!c.more) [[likely]]
    return;
  std::array<LinkEnd, 2 + LinkMore::kMost> ends;
  std::size_t count = 0;
  if (c.a != kInvalid) ends[count++] = {c.a, -c.d_a, -c.w_a};
  if (c.b != kInvalid) ends[count++] = {c.b, c.d_b, c.w_b};
  const std::size_t own = count;
  c.each_more([&](std::uint32_t body, const Vec3& d, const Vec3& w) { ends[count++] = {body, d, w}; });
  const Array<std::uint32_t>& place = problem.elimination->place;
  for (std::size_t k = own; k < count; ++k)
    for (std::size_t i = 0; i < k; ++i) {
      const bool is_first = place[ends[i].body] < place[ends[k].body];
      const LinkEnd &one = ends[is_first ? i : k], &other = ends[is_first ? k : i];
      if (problem.is_stale(place[one.body]))
        f(one, other, problem.factor->at(*problem.elimination, place[other.body], place[one.body]));
    }
}

/// J^T w J of a row.
void add_link(const ConeProblem& problem, const Blocks& f, const ConeLink& c, Real w) {
  const Array<std::uint32_t>& place = problem.elimination->place;
  const LinkArms a = {c.d_a, c.w_a}, b = {c.d_b, c.w_b};
  if (c.a != kInvalid && problem.is_stale(place[c.a])) add_outer(f.diagonal[place[c.a]], w, a, a);
  if (c.b != kInvalid && problem.is_stale(place[c.b])) add_outer(f.diagonal[place[c.b]], w, b, b);
  if (is_stale_beside(problem, c)) add_outer(f.filled(c.beside), -w, c.a_later ? b : a, c.a_later ? a : b);
  c.each_more([&](std::uint32_t body, const Vec3& d, const Vec3& turn) {
    if (problem.is_stale(place[body])) add_outer(f.diagonal[place[body]], w, {d, turn}, {d, turn});
  });
  each_more_beside(problem, c, [&](const LinkEnd& one, const LinkEnd& other, std::size_t at) {
    add_outer(f.filled(at), w, {one.d, one.w}, {other.d, other.w});
  });
}

}  // namespace

void assemble_masses(const ConeProblem& problem, const Blocks& f) {
  const Elimination& e = *problem.elimination;
  for (std::uint32_t i = problem.first; i < problem.last; ++i) {
    const std::uint32_t j = e.place[i];
    if (!problem.is_stale(j)) continue;
    put_masses(problem.bodies[i], f.diagonal[j]);
    std::fill(f.is_filled + e.column[j], f.is_filled + e.column[j + 1], 0);
  }
}

void add_sticking(ConeProblem& problem, const ConeContact& c, Real w) {
  const Elimination& e = *problem.elimination;
  const Blocks f = problem.factor->all();
  const auto add = [&](Block& d, Real by, const ContactArms& a, const ContactArms& b) {
    add_isotropic(d, by, a.r, b.r);
    if (c.is_spread) add_moments(d, by, c.n, a, b);
  };
  const ContactArms a = {c.r_a, c.n_a}, b = {c.r_b, c.n_b};
  if (c.a != kInvalid && problem.is_stale(e.place[c.a])) add(f.diagonal[e.place[c.a]], w, a, a);
  if (c.b != kInvalid && problem.is_stale(e.place[c.b])) add(f.diagonal[e.place[c.b]], w, b, b);
  if (is_stale_beside(problem, c)) add(f.filled(c.beside), -w, c.a_later ? b : a, c.a_later ? a : b);
}

void hold_locked(ConeProblem& problem) {
  const auto locked = [](const ConeBody& b) { return b.locks != 0; };
  if (std::ranges::none_of(bodies_of(problem), locked)) return;
  const Elimination& e = *problem.elimination;
  const Blocks f = problem.factor->all();
  for (std::uint32_t i = problem.first; i < problem.last; ++i) {
    if (!problem.is_stale(e.place[i])) continue;
    const ConeBody& b = problem.bodies[i];
    Block& d = f.diagonal[e.place[i]];
    strike_out(d, b.locks, b.locks);
    for (int k = 0; k < kDof; ++k)
      if (b.locks >> k & 1) d.x[k][k] = k < 3 ? b.mass : b.inertia(k - 3, k - 3);
  }
  const auto hold_beside = [&](const auto& c) {
    if (!is_stale_beside(problem, c) || !f.is_filled[c.beside]) return;
    const std::uint32_t later = c.a_later ? c.a : c.b, other = c.a_later ? c.b : c.a;
    strike_out(f.beside[c.beside], problem.bodies[other].locks, problem.bodies[later].locks);
  };
  std::ranges::for_each(problem.contacts, hold_beside);
  std::ranges::for_each(problem.links, hold_beside);
  for (const ConeLink& c : problem.links)
    each_more_beside(problem, c, [&](const LinkEnd& one, const LinkEnd& other, std::size_t at) {
      if (f.is_filled[at]) strike_out(f.beside[at], problem.bodies[one.body].locks, problem.bodies[other.body].locks);
    });
}

void solve_for_steps(ConeProblem& problem, Real sign) {
  const Elimination& e = *problem.elimination;
  for (std::uint32_t i = problem.first; i < problem.last; ++i) {
    Vec6& x = problem.scratch[e.place[i]];
    x = problem.bodies[i].gradient;
    hold(problem.bodies[i], x);
  }
  solve(e, problem.first, problem.last, problem.tree, *problem.factor, problem.scratch);
  for (std::uint32_t i = problem.first; i < problem.last; ++i)
    problem.bodies[i].step = sign * problem.scratch[e.place[i]];
  for (TreeNode& node : problem.tree) node.q = sign * node.q;
}

void Round::assemble_locked() {
  if (problem_.locked_softness == softness_of_locks()) return;
  const Elimination& e = *problem_.elimination;
  const Blocks common = problem_.factor->common(e);
  assemble_masses(problem_, common);
  for (const ConeLink& c : problem_.links)
    if (c.k > 0 && c.is_lock() && !c.is_of_child) add_link(problem_, common, c, 1 / resistance(c));
  problem_.locked_softness = softness_of_locks();
}

void Round::add_driven(TreeNode& node) const {
  if (node.drives == 0 || !node.is_stale) return;
  set_zero(node.driven);
  for (const ConeLink& c : problem_.links.subspan(node.first_drive, node.drives)) {
    if (!c.is_held) continue;
    const Real w = 1 / (resistance(c) + c.give);
    for (int i = 0; i < node.freedom; ++i)
      for (int j = 0; j < node.freedom; ++j) node.driven.x[i][j] += w * c.of_child[i] * c.of_child[j];
  }
}

void Round::assemble() {
  const Elimination& e = *problem_.elimination;
  const Blocks f = problem_.factor->all();
  if (problem_.links.empty()) {
    assemble_masses(problem_, f);
  } else {
    assemble_locked();
    const Blocks common = problem_.factor->common(e);
    for (std::uint32_t j = problem_.first; j < problem_.last; ++j) {
      if (!problem_.is_stale(j)) continue;
      copy(common.diagonal[j], f.diagonal[j]);
      for (std::uint32_t k = e.column[j]; k < e.column[j + 1]; ++k)
        if ((f.is_filled[k] = common.is_filled[k])) copy(common.beside[k], f.beside[k]);
    }
  }
  for (ConeContact& c : problem_.contacts) {
    if (c.curvature == ConeCurvature::none) continue;
    if (c.curvature == ConeCurvature::alike) {
      add_sticking(problem_, c, 1 / resistance(c));
      continue;
    }
    const Mat3 w = c.slope = slope(c);
    const Turning on_a(c, c.r_a, c.n_a), on_b(c, c.r_b, c.n_b);
    const Mat3 w_a = w * on_a.x, w_b = w * on_b.x;
    if (c.a != kInvalid) add_own(f.diagonal[e.place[c.a]], w, on_a, w_a);  // where it slides it is stale
    if (c.b != kInvalid) add_own(f.diagonal[e.place[c.b]], w, on_b, w_b);
    if (c.beside == kInvalid) continue;
    Block& d = f.filled(c.beside);
    const Mat3 &back = c.a_later ? on_b.back : on_a.back, &later = c.a_later ? w_a : w_b;
    add(d, 0, 0, -w);
    add(d, 0, 3, later);
    add(d, 3, 0, -(back * w));
    add(d, 3, 3, back * later);
  }
  for (const ConeLink& c : problem_.links)
    if (c.is_held && !c.is_lock() && !c.is_of_child) add_link(problem_, f, c, 1 / (resistance(c) + c.give));
  for (TreeNode& node : problem_.tree) add_driven(node);
  hold_locked(problem_);
}

}  // namespace carom::dynamics
