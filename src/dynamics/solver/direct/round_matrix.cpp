// Newton's matrix: masses, and what joints and contacts add to them.
#include <algorithm>

#include "dynamics/solver/direct/round.h"

namespace carom::dynamics {
namespace {

void add(Block& d, int row, int column, const Mat3& m) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) d.x[row + i][column + j] += m(i, j);
}

/// A block without the rows and columns of what is locked.
void strike_out(Block& d, std::uint8_t row_locks, std::uint8_t column_locks) {
  for (int i = 0; i < kDof; ++i)
    for (int j = 0; j < kDof; ++j)
      if ((row_locks >> i | column_locks >> j) & 1) d.x[i][j] = 0;
}

/// w (d, w_row) (d, w_column)^T.
struct RowArms {
  const Vec3 &d, &w;
};
void add_outer(Block& b, Real w, const RowArms& r, const RowArms& c) {
  const Real row[kDof] = {w * r.d.x(), w * r.d.y(), w * r.d.z(), w * r.w.x(), w * r.w.y(), w * r.w.z()};
  const Real column[kDof] = {c.d.x(), c.d.y(), c.d.z(), c.w.x(), c.w.y(), c.w.z()};
  for (int i = 0; i < kDof; ++i)
    for (int j = 0; j < kDof; ++j) b.x[i][j] += row[i] * column[j];
}

/// What a body does at a patch: J = [1 - n n^T, -(1 - n n^T) x + n w^T].
Mat3 turning(const ConePatch& c, const Vec3& r, const Vec3& w) {
  const Mat3 x = cross_matrix(r);
  return outer(c.n, Vec3(w + x.transpose() * c.n)) - x;
}

}  // namespace

void assemble_masses(const ConeProblem& problem, const Blocks& f) {
  const Elimination& e = *problem.elimination;
  for (std::uint32_t i = problem.first; i < problem.last; ++i) {
    const ConeBody& b = problem.bodies[i];
    Block& d = f.diagonal[e.place[i]];
    d = {};
    for (int k = 0; k < 3; ++k) d.x[k][k] = b.mass;
    add(d, 3, 3, b.inertia);
  }
  std::fill(f.below + e.column[problem.first], f.below + e.column[problem.last], Block{});
}

void add_row(const Elimination& e, const Blocks& f, const ConeRow& c, Real w) {
  const RowArms a = {c.d_a, c.w_a}, b = {c.d_b, c.w_b};
  if (c.a != kInvalid) add_outer(f.diagonal[e.place[c.a]], w, a, a);
  if (c.b != kInvalid) add_outer(f.diagonal[e.place[c.b]], w, b, b);
  if (c.below == kInvalid) return;
  add_outer(f.below[c.below], -w, c.a_later ? a : b, c.a_later ? b : a);
}

void add_patch(const Elimination& e, const Blocks& f, const ConePatch& c, const Mat3& w) {
  const Mat3 across = Mat3::identity() - outer(c.n, c.n);
  const Mat3 x_a = turning(c, c.r_a, c.w_a), x_b = turning(c, c.r_b, c.w_b);
  const Mat3 w_t = w * across, w_a = w * x_a, w_b = w * x_b, t_w_t = across * w_t;
  const auto add_own = [&](std::uint32_t body, const Mat3& x, const Mat3& w_x) {
    if (body == kInvalid) return;
    Block& d = f.diagonal[e.place[body]];
    const Mat3 t_w_x = across * w_x;
    add(d, 0, 0, t_w_t);
    add(d, 0, 3, t_w_x);
    add(d, 3, 0, t_w_x.transpose());
    add(d, 3, 3, x.transpose() * w_x);
  };
  add_own(c.a, x_a, w_a), add_own(c.b, x_b, w_b);
  if (c.below == kInvalid) return;
  Block& d = f.below[c.below];
  const Mat3 &x_later = c.a_later ? x_a : x_b, &w_other = c.a_later ? w_b : w_a;
  add(d, 0, 0, -t_w_t);
  add(d, 0, 3, -(across * w_other));
  add(d, 3, 0, -(x_later.transpose() * w_t));
  add(d, 3, 3, -(x_later.transpose() * w_other));
}

void hold_locked(ConeProblem& problem) {
  const auto locked = [](const ConeBody& b) { return b.locks != 0; };
  if (std::ranges::none_of(bodies_of(problem), locked)) return;
  const Elimination& e = *problem.elimination;
  BlockFactor& f = *problem.factor;
  for (std::uint32_t i = problem.first; i < problem.last; ++i) {
    const ConeBody& b = problem.bodies[i];
    Block& d = f.diagonal[e.place[i]];
    strike_out(d, b.locks, b.locks);
    for (int k = 0; k < kDof; ++k)
      if (b.locks >> k & 1) d.x[k][k] = k < 3 ? b.mass : b.inertia(k - 3, k - 3);
  }
  const auto hold_below = [&](const auto& c) {
    if (c.below == kInvalid) return;
    const std::uint32_t later = c.a_later ? c.a : c.b, other = c.a_later ? c.b : c.a;
    strike_out(f.below[c.below], problem.bodies[later].locks, problem.bodies[other].locks);
  };
  each_part(problem, hold_below);
}

void solve_for_steps(ConeProblem& problem, Real sign) {
  const Elimination& e = *problem.elimination;
  for (std::uint32_t i = problem.first; i < problem.last; ++i) {
    Vec6& x = problem.scratch[e.place[i]];
    x = sign * problem.bodies[i].gradient;
    hold(problem.bodies[i], x);
  }
  solve(e, problem.first, problem.last, *problem.factor, problem.scratch);
  for (std::uint32_t i = problem.first; i < problem.last; ++i) problem.bodies[i].step = problem.scratch[e.place[i]];
}

void Round::assemble_locked() {
  if (problem_.locked_softness == softness_of_locks()) return;
  const Elimination& e = *problem_.elimination;
  const Blocks common = problem_.factor->common(e);
  assemble_masses(problem_, common);
  for (const ConeRow& c : problem_.links)
    if (c.k > 0 && c.is_lock()) add_row(e, common, c, 1 / resistance(c));
  problem_.locked_softness = softness_of_locks();
}

void Round::add_coupling(const ConePatch& c) {
  const Elimination& e = *problem_.elimination;
  const Blocks f = problem_.factor->all();
  ConeRow sum = problem_.contacts[c.first];
  sum.d_a = sum.d_b = sum.w_a = sum.w_b = Vec3::zero();
  for (const ConeRow& row : contacts_of(c)) {
    if (!(row.p > 0)) continue;
    const Real per = 1 / resistance(row);
    sum.d_a += per * row.d_a, sum.d_b += per * row.d_b, sum.w_a += per * row.w_a, sum.w_b += per * row.w_b;
  }
  add_row(e, f, sum, -1 / c.coupling.between);
  const Real per = 1 / resistance(c), along = c.coupling.q.dot(c.n), share = c.coupling.share;
  const Vec3 force = c.coupling.q - along * c.n;
  ConeRow both = sum;
  both.d_a = per * force + share * sum.d_a, both.d_b = per * force + share * sum.d_b;
  both.w_a = c.a == kInvalid ? Vec3::zero() : Vec3(per * (c.r_a.cross(force) + along * c.w_a) + share * sum.w_a);
  both.w_b = c.b == kInvalid ? Vec3::zero() : Vec3(per * (c.r_b.cross(force) + along * c.w_b) + share * sum.w_b);
  add_row(e, f, both, c.coupling.weight);
}

void Round::assemble() {
  const Elimination& e = *problem_.elimination;
  const Blocks f = problem_.factor->all();
  if (problem_.links.empty()) {
    assemble_masses(problem_, f);
  } else {
    assemble_locked();
    const Blocks common = problem_.factor->common(e);
    const auto copy = [](const Block* from, std::size_t begin, std::size_t end, Block* to) {
      std::copy(from + begin, from + end, to + begin);
    };
    copy(common.diagonal, problem_.first, problem_.last, f.diagonal);
    copy(common.below, e.column[problem_.first], e.column[problem_.last], f.below);
  }
  for (const ConePatch& c : problem_.patches) {
    if (c.curvature == PatchCurvature::none) continue;
    add_patch(e, f, c, c.curvature == PatchCurvature::sticks ? (1 / resistance(c)) * Mat3::identity() : slope(c));
  }
  for (const ConePatch& c : problem_.patches)
    if (c.is_coupled && c.curvature == PatchCurvature::slides) add_coupling(c);
  for (const ConeRow& c : problem_.rows)
    if (c.is_held && !c.is_lock()) add_row(e, f, c, 1 / (resistance(c) + c.give));
  hold_locked(problem_);
}

}  // namespace carom::dynamics
