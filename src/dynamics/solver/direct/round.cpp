// Newton's method with an exact line search.
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
  bool whole = false;  // the last step was
  for (; steps < most_steps && problem_.may_go_on(); ++steps) {
    const Real now = find_gradient();
    off = std::min(now, tolerance), is_reached = now <= tolerance;
    if (is_reached) break;
    const NextFactor factor = find_factor(steps == 0 ? tolerance : 0);
    if (factor == NextFactor::none) break;
    if (factor == NextFactor::same && !(now < kFalls * left) && (whole || now <= rounding())) break;
    left = now;
    ++problem_.taken.steps, problem_.taken.products += work_of_contacts();
    find_step();
    const Real length = search();
    whole = length == 1;
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
    Vec3 next = c.p;
    if (c.curvature == ConeCurvature::alike) next -= c.du / resistance(c);
    if (c.curvature == ConeCurvature::slope) next -= c.slope * c.du;
    c.traced_p += length * (next - c.traced_p);
  }
  for (ConeLink& c : problem_.links) {
    const Real next = c.p - (c.is_held ? c.du / (resistance(c) + c.give) : 0);
    c.traced_p += length * (next - c.traced_p);
  }
}

Mat3 Round::slope(const ConeContact& c) const {
  const Vec3 z = pull(c, c.u);
  const Mat3 slope =
      is_known_ ? slope_of_projection_on_cylinder(z, c.n, c.most_friction) : slope_of_projection(z, c.n, c.friction);
  return slope / resistance(c);
}

Real Round::find_gradient() {
  bool any = has_moved_;
  for (ConeBody& b : bodies_of(problem_)) b.gradient = momentum_of(b, b.change);
  for (ConeContact& c : problem_.contacts) {
    c.p = project(c, pull(c, c.u));
    if (c.p != c.p0) any = true, add_impulse<&ConeBody::gradient>(problem_, c, c.p0 - c.p);
  }
  for (ConeLink& c : problem_.links) {
    c.p = c.k > 0 ? c.pulled(c.u, resistance(c), c.p0) : 0;
    if (c.p != c.p0) any = true, add_impulse<&ConeBody::gradient>(problem_, c, c.p0 - c.p);
  }
  if (!any) return 0;
  has_moved_ = true;
  respond(problem_);
  Real most = 0;
  for (const ConeContact& c : problem_.contacts)
    if (c.p != c.p0) most = std::max(most, relative<&ConeBody::step>(problem_.bodies, c).squared_norm());
  for (const ConeLink& c : problem_.links) {
    const Real u = relative<&ConeBody::step>(problem_.bodies, c);
    most = std::max(most, u * u);
  }
  return std::sqrt(most);
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
  const Vec3 pulled = pull(c, c.u);
  if (c.p0 == Vec3::zero() && resistance(c) * pulled.norm() <= still) return ConeCurvature::alike;  // at the tip
  if (c.p == Vec3::zero()) return ConeCurvature::none;
  return c.p == pulled ? ConeCurvature::alike : ConeCurvature::slope;
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
    const bool is_held = c.k > 0 && c.follows(c.u, resistance(c), c.p0);
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
  for (ConeLink& c : problem_.links) c.du = relative<&ConeBody::step>(problem_.bodies, c);
}

namespace {

/// Where nothing has friction: most of what bears nothing.
void find_frictionless_line(ConeContact& c, const Vec3& z0, Real r) {
  c.line.n0 = z0.dot(c.n), c.line.u_n = c.du.dot(c.n), c.line.n1 = -c.line.u_n / r;
  c.line.start = c.du.dot(c.p0);
}

/// @param z1  change of z with the step
ConeLine line_of(const ConeContact& c, const Vec3& z0, const Vec3& z1) {
  ConeLine line;
  line.n0 = z0.dot(c.n), line.n1 = z1.dot(c.n), line.u_n = c.du.dot(c.n);
  const Vec3 t0 = z0 - line.n0 * c.n, t1 = z1 - line.n1 * c.n;
  line.t00 = t0.squared_norm(), line.t01 = t0.dot(t1), line.t11 = t1.squared_norm();
  line.ut0 = c.du.dot(t0), line.ut1 = c.du.dot(t1);
  line.start = c.du.dot(c.p0);
  return line;
}

/// J, du . (P_K(z) - p0): as project_on_cone() has it, in numbers.
Real gain_in_cone(const ConeLine& line, Real mu, Real length) {
  const Real n = line.n0 + length * line.n1, u_t = line.ut0 + length * line.ut1;
  const Real t = std::sqrt(std::max(Real(0), line.t00 + length * (2 * line.t01 + length * line.t11)));
  if (n <= -mu * t) return -line.start;
  if (t <= mu * n) return line.u_n * n + u_t - line.start;
  const Real along = (n + mu * t) / (1 + mu * mu);
  return along * (mu > 0 ? line.u_n + mu / t * u_t : line.u_n) - line.start;
}

/// As project_on_cylinder() has it.
Real gain_in_cylinder(const ConeLine& line, Real most, Real length) {
  const Real n = line.n0 + length * line.n1;
  if (most == 0) return line.u_n * std::max(n, Real(0)) - line.start;
  const Real u_t = line.ut0 + length * line.ut1;
  const Real t = std::sqrt(std::max(Real(0), line.t00 + length * (2 * line.t01 + length * line.t11)));
  return line.u_n * std::max(n, Real(0)) + (t <= most ? u_t : most / t * u_t) - line.start;
}

}  // namespace

Real Round::gain_along(const ConeContact& c, Real length) const {
  return is_known_ ? gain_in_cylinder(c.line, c.most_friction, length) : gain_in_cone(c.line, c.friction, length);
}

Round::Slope Round::find_slope() {
  Slope slope = {0, 0, 0};
  for (const ConeBody& b : bodies_of(problem_)) {
    const Vec6 m = momentum_of(b, b.step);
    slope.start += b.change.dot(m);
    slope.grows += b.step.dot(m);
  }
  slope.rounding = std::fabs(slope.start);
  for (ConeContact& c : problem_.contacts) {
    const Real r = resistance(c);
    if (is_known_ && c.most_friction == 0) {
      find_frictionless_line(c, pull(c, c.u), r);
      if (std::max(c.line.n0, c.line.n0 + c.line.n1) <= 0 && c.p0 == Vec3::zero()) continue;  // it bears nothing
    } else {
      c.line = line_of(c, pull(c, c.u), c.du / -r);
    }
    const Real asked = c.want - c.slip;
    slope.rounding += std::sqrt(c.du.squared_norm() * (c.p.squared_norm() + c.p0.squared_norm() +
                                                       (c.u.squared_norm() + asked * asked) / (r * r)));
  }
  for (const ConeLink& c : problem_.links) {
    if (!(c.k > 0)) continue;
    const Real r = resistance(c) + c.give;
    slope.rounding += std::fabs(c.du) * (std::fabs(c.p) + std::fabs(c.p0) + std::fabs(c.u) / r);
    if (c.is_lock()) slope.start -= c.du * (c.p - c.p0), slope.grows += c.du * c.du / r;
  }
  constexpr Real kOfAll = 0.1;  // of all roundings if each went the same way; with all, a drive's speed was off by some
  slope.rounding *= kOfAll * kEpsilon;
  return slope;
}

Real Round::derivative(const Slope& slope, Real length) const {
  Real d = slope.start + length * slope.grows;
  for (const ConeContact& c : problem_.contacts) d -= gain_along(c, length);
  for (const ConeLink& c : problem_.links)
    if (c.k > 0 && !c.is_lock()) d -= c.du * (c.pulled(c.u + length * c.du, resistance(c), c.p0) - c.p0);
  return d;
}

Real Round::search() {
  constexpr Real kClose = 0.1;
  constexpr int kTries = 30;
  const Slope slope = find_slope();
  Real low = 0, high = 1, d_low = 0;
  for (const ConeBody& b : bodies_of(problem_)) d_low += b.gradient.dot(b.step);
  if (std::fabs(d_low) <= slope.rounding) return 0;
  Real d_high = derivative(slope, 1);
  const Real enough = kClose * std::fabs(d_low);
  for (int i = 0; i < kTries && d_high < -enough; ++i)
    low = high, d_low = d_high, high *= 2, d_high = derivative(slope, high);
  if (std::fabs(d_high) <= enough) return high;
  Real length = high;
  for (int i = 0; i < kTries; ++i) {
    // Halves now and then: false position alone may creep.
    length = i % 3 == 2 || !(d_high > d_low) ? (low + high) / 2 : low - d_low * (high - low) / (d_high - d_low);
    const Real d = derivative(slope, length);
    if (std::fabs(d) <= enough) break;
    (d < 0 ? low : high) = length;
    (d < 0 ? d_low : d_high) = d;
  }
  return length;
}

void Round::accept() {
  if (!has_moved_) return;  // no row asks for anything
  for (ConeBody& b : bodies_of(problem_)) b.gradient.set_zero();
  for (ConeContact& c : problem_.contacts) add_impulse<&ConeBody::gradient>(problem_, c, c.p - c.p0);
  for (ConeLink& c : problem_.links) add_impulse<&ConeBody::gradient>(problem_, c, c.p - c.p0);
  respond(problem_);
  for (ConeBody& b : bodies_of(problem_)) b.change = b.step, b.v += b.change;
  for (ConeContact& c : problem_.contacts) c.u = c.u0 + relative<&ConeBody::change>(problem_.bodies, c);
  for (ConeLink& c : problem_.links) c.u = c.u0 + relative<&ConeBody::change>(problem_.bodies, c);
}

}  // namespace carom::dynamics
