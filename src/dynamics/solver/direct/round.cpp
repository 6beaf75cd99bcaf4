// Newton's method.
#include "dynamics/solver/direct/round.h"
#include "dynamics/solver/direct/forest.h"

#include <algorithm>

namespace carom::dynamics {

Round::Round(ConeProblem& problem, Real softness) : problem_(problem), softness_(softness) {
  for (ConeContact& c : problem_.contacts) c.p0 = c.p, c.u0 = c.u;
  for (ConeLink& c : problem_.links) c.p0 = c.p, c.u0 = c.u;
  for (ConeBody& b : bodies_of(problem_)) b.change.set_zero();
}

Round::Round(ConeProblem& problem, Real softness, Friction friction) : Round(problem, softness) {
  is_known_ = friction == Friction::known;
  if (is_known_) save_impulses<&ConeContact::traced_p, &ConeLink::traced_p>(problem_);
}

void Round::take_back() {
  for (ConeBody& b : bodies_of(problem_)) b.v -= b.change;
  for (ConeContact& c : problem_.contacts) c.p = c.p0, c.u = c.u0;
  for (ConeLink& c : problem_.links) c.p = c.p0, c.u = c.u0;
}

std::uint32_t Round::minimise(Real tolerance, std::uint32_t most_steps) {
  constexpr Real kFalls = 0.5;  // where it is quadratic a step leaves nothing, or rounding
  std::uint32_t steps = 0;
  bool is_reached = false;
  Real left = kInfinity, off = tolerance;
  bool whole = false;   // the last step was
  bool goes_on = true;  // rows that their whole k holds do in the next step
  while (steps < most_steps && problem_.may_go_on()) {
    const Real now = find_gradient();
    off = std::min(now, tolerance), is_reached = now <= tolerance;
    if (is_reached) break;
    goes_on = goes_on && go_on();
    const NextFactor factor = find_factor(steps == 0 ? tolerance : 0);
    if (factor == NextFactor::none) break;
    if (factor == NextFactor::same && !(now < kFalls * left) && (whole || now <= rounding())) break;
    left = goes_on ? kInfinity : now;  // that of another function
    ++problem_.taken.steps, problem_.taken.products += work_of_contacts();
    find_step();
    const Real length = search();
    if (length == 0 && goes_on) {
      goes_on = false;
      continue;
    }
    whole = length == 1, goes_on = false, ++steps;
    if (length == 0) {
      is_stuck_ = true;
      break;
    }
    if (is_known_) trace(length);
    for (ConeBody& b : bodies_of(problem_)) b.change += length * b.step;
    for (ConeContact& c : problem_.contacts) c.u += length * c.du;
    for (ConeLink& c : problem_.links) c.u += length * c.du;
  }
  if (is_known_ && !is_reached) {
    for (ConeContact& c : problem_.contacts) c.p = c.traced_p;
    for (ConeLink& c : problem_.links) c.p = c.traced_p;
  }
  accept();
  if (is_known_) problem_.may_give = may_give(off), problem_.is_proven = is_reached;
  return steps;
}

// A row's impulse is the point nearest to q = (1 - g) p0 - (u - want) / R of a convex set that holds 0, so p.(q - p) >= 0, and
// p.u <= p.want + R p.((1 - g) p0 - p) <= R ((1 - g) p0)^2 / 4. Velocities come out off by a little: accept() follows impulses.
Real Round::may_give(Real off) const {
  Real sum = 0;
  const auto add = [&](Real r, Real keeps, Real p0, Real p) { sum += keeps * keeps * p0 * p0 / (4 * r) + p * off; };
  for (const ConeContact& c : problem_.contacts) {
    const Real r = resistance(c);
    add(r, r - c.give, c.p0.norm(), c.p.norm());
  }
  for (const ConeLink& c : problem_.links) {
    if (c.k > 0) add(resistance(c) + c.give, resistance(c), std::fabs(c.p0), std::fabs(c.p));
  }
  return sum;
}

Real Round::rounding() const {
  constexpr Real kSome = 10;  // roundings: the velocity of a row is a sum of twelve products
  Real most2 = 0;
  for (const ConeBody& b : bodies_of(problem_)) most2 = std::max(most2, speed2(b, b.v));
  return kSome * kEpsilon * std::sqrt(most2) / softness_of_locks();
}

// M change = J^T (q - p0) holds before and after a step L: its M step = J^T (p - q - W du), W the slope of p by -u.
void Round::trace(Real length) {
  for (ConeContact& c : problem_.contacts) {
    Vec3 next = c.goes_on ? c.z : c.p;
    if (c.curvature == ConeCurvature::alike) next -= c.du / resistance(c);
    if (c.curvature == ConeCurvature::slope) next -= c.slope * c.du;
    c.traced_p += length * (next - c.traced_p);
  }
  for (ConeLink& c : problem_.links) {
    const Real next = c.linear - (c.is_held ? c.du / (resistance(c) + c.give) : 0);
    c.traced_p += length * (next - c.traced_p);
  }
}

Mat3 Round::slope(const ConeContact& c) const {
  const Mat3 slope = is_known_ ? slope_of_projection_on_cylinder(c.z, c.n, c.most_friction)
                               : slope_of_projection(c.z, c.n, c.friction);
  return slope / resistance(c);
}

Real Round::find_gradient() {
  bool any = has_moved_;
  for (ConeBody& b : bodies_of(problem_)) b.gradient = momentum_of(b, b.change);
  for (ConeContact& c : problem_.contacts) {
    c.z = pull(c, c.u, resistance(c)), c.p = project(c, c.z), c.goes_on = false;
    if (c.p != c.p0) any = true, add_impulse<&ConeBody::gradient>(problem_, c, c.p0 - c.p);
  }
  for (TreeNode& node : problem_.tree) node.pushed.set_zero();
  for (ConeLink& c : problem_.links) {
    c.p = c.linear = c.k > 0 ? c.pulled(c.u, resistance(c), c.p0) : 0, c.goes_on = false;
    if (c.p != c.p0) any = true, push_row(problem_, c, c.p0 - c.p);
  }
  if (!any) return 0;
  has_moved_ = true;
  respond(problem_);
  Real most = 0;
  for (const ConeContact& c : problem_.contacts)
    if (c.p != c.p0) most = std::max(most, relative<&ConeBody::step>(problem_.bodies, c).squared_norm());
  for (const ConeLink& c : problem_.links) {
    const Real u = step_of(problem_, c);
    most = std::max(most, u * u);
  }
  return std::sqrt(most);
}

bool Round::go_on() {
  bool any = false;
  for (ConeContact& c : problem_.contacts) {
    const Vec3 whole = pull(c, c.u, c.k);
    if (c.p == c.z || project(c, whole) != whole) continue;
    any = c.goes_on = true;
    add_impulse<&ConeBody::gradient>(problem_, c, c.p - c.z);
  }
  for (ConeLink& c : problem_.links) {
    const Real r = resistance(c);
    if (!(c.k > 0) || c.follows(c.u, r, c.p0) || !c.follows(c.u, c.k, c.p0)) continue;
    any = c.goes_on = true, c.linear = c.at(c.at(c.low, c.u, c.k, c.p0) > 0 ? c.low : c.high, c.u, r, c.p0);
    push_row(problem_, c, c.p - c.linear);
  }
  return any;
}

Round::NextFactor Round::find_factor(Real still) {
  const bool is_same = find_curvatures(still), is_as_soft = problem_.factored == factored_as();
  if (is_same && is_as_soft) return NextFactor::same;
  spread_stale(!is_as_soft);
  problem_.factored = 0;
  assemble();
  const std::uint64_t products =
      factor(*problem_.elimination, problem_.first, problem_.last, problem_.tree, *problem_.factor);
  problem_.taken.products += products;
  if (products == 0) return NextFactor::none;
  problem_.factored = factored_as();
  return NextFactor::another;
}

std::uint64_t Round::work_of_contacts() const {
  const auto acts = [](const ConeContact& c) { return c.curvature != ConeCurvature::none; };
  const auto act = static_cast<std::uint64_t>(std::ranges::count_if(problem_.contacts, acts));
  return problem_.contacts.size() + (kWorkOfContact - 1) * act;
}

ConeCurvature Round::curvature_of(const ConeContact& c, Real still) const {
  if (c.goes_on) return ConeCurvature::alike;
  if (c.p0 == Vec3::zero() && resistance(c) * c.z.norm() <= still) return ConeCurvature::alike;  // at the tip
  if (c.p == Vec3::zero()) return ConeCurvature::none;
  return c.p == c.z ? ConeCurvature::alike : ConeCurvature::slope;
}

bool Round::find_curvatures(Real still) {
  bool is_same = true;
  for (TreeNode& node : problem_.tree) node.is_stale = false;
  const auto change = [&](const auto& c) {
    is_same = false;
    if (!problem_.tree.empty()) mark_stale(c.a), mark_stale(c.b);
  };
  for (ConeContact& c : problem_.contacts) {
    const ConeCurvature now = curvature_of(c, still);
    if (now != c.curvature || now == ConeCurvature::slope) change(c);
    c.curvature = now;
  }
  for (ConeLink& c : problem_.links) {
    const bool is_held = c.goes_on || (c.k > 0 && c.follows(c.u, resistance(c), c.p0));
    if (is_held != c.is_held) {
      change(c);
      if (!problem_.tree.empty()) c.each_more([&](std::uint32_t body, const Vec3&, const Vec3&) { mark_stale(body); });
    }
    c.is_held = is_held;
  }
  return is_same;
}

// What a node leaves is taken from those after it: they are stale with it. What they are left by others is to be found again:
// of what goes along with its parent alone it is known, others are factored once more.
void Round::spread_stale(bool changed) {
  const Elimination& e = *problem_.elimination;
  const auto nodes = static_cast<std::uint32_t>(problem_.tree.size());
  const auto of = [&](std::uint32_t place) -> bool& { return problem_.tree[place - problem_.first].is_stale; };
  for (TreeNode& node : problem_.tree) node.is_stale |= changed;
  for (std::uint32_t j = 0; j < nodes; ++j) {
    const TreeNode& node = problem_.tree[j];
    if (!node.is_stale) continue;
    if (node.is_held() && node.parent != kInvalid) of(node.parent) = true;
    for (std::uint32_t k = e.column[problem_.first + j]; k < e.column[problem_.first + j + 1]; ++k)
      of(e.rows[k]) = true;
  }
  for (std::uint32_t j = nodes; j-- > 0;) {
    TreeNode& node = problem_.tree[j];
    if (node.is_stale || (node.is_held() && node.is_bare)) continue;
    for (std::uint32_t k = e.column[problem_.first + j]; k < e.column[problem_.first + j + 1]; ++k)
      node.is_stale |= of(e.rows[k]);
  }
}

void Round::find_step() {
  solve_for_steps(problem_, -1);
  for (ConeContact& c : problem_.contacts) c.du = relative<&ConeBody::step>(problem_.bodies, c);
  for (ConeLink& c : problem_.links) c.du = step_of(problem_, c);
}

void Round::accept() {
  if (!has_moved_) return;  // no row asks for anything
  for (ConeBody& b : bodies_of(problem_)) b.gradient.set_zero();
  for (ConeContact& c : problem_.contacts) add_impulse<&ConeBody::gradient>(problem_, c, c.p - c.p0);
  for (TreeNode& node : problem_.tree) node.pushed.set_zero();
  for (ConeLink& c : problem_.links) push_row(problem_, c, c.p - c.p0);
  respond(problem_);
  for (TreeNode& node : problem_.tree) node.pushed.set_zero();
  for (ConeBody& b : bodies_of(problem_)) b.change = b.step, b.v += b.change;
  for (ConeContact& c : problem_.contacts) c.u = c.u0 + relative<&ConeBody::change>(problem_.bodies, c);
  for (ConeLink& c : problem_.links) c.u = c.u0 + step_of(problem_, c);
}

}  // namespace carom::dynamics
