// Newton's method with an exact line search.
#include "dynamics/solver/direct/round.h"

#include <algorithm>

#include "dynamics/solver/direct/cone.h"

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

/// J^T w J of a row.
void add_link(ConeProblem& problem, const ConeLink& c, Real w) {
  const Elimination& e = *problem.elimination;
  BlockFactor& f = *problem.factor;
  const LinkArms a = {c.d_a, c.w_a}, b = {c.d_b, c.w_b};
  if (c.a != kNobody) add_outer(f.diagonal[e.place[c.a]], w, a, a);
  if (c.b != kNobody) add_outer(f.diagonal[e.place[c.b]], w, b, b);
  if (c.below == kNobody) return;
  add_outer(f.below[c.below], -w, c.a_later ? a : b, c.a_later ? b : a);
}

}  // namespace

void assemble_masses(ConeProblem& problem) {
  const Elimination& e = *problem.elimination;
  BlockFactor& f = *problem.factor;
  for (std::uint32_t i = problem.first; i < problem.last; ++i) {
    const ConeBody& b = problem.bodies[i];
    Block& d = f.diagonal[e.place[i]];
    d = {};
    for (int k = 0; k < 3; ++k) d.x[k][k] = b.mass;
    add(d, 3, 3, b.inertia);
  }
  std::fill(f.below.begin() + e.column[problem.first], f.below.begin() + e.column[problem.last], Block{});
}

void add_sticking(ConeProblem& problem, const ConeContact& c, Real w) {
  const Elimination& e = *problem.elimination;
  BlockFactor& f = *problem.factor;
  const auto add = [&](Block& d, Real by, const ContactArms& a, const ContactArms& b) {
    add_isotropic(d, by, a.r, b.r);
    if (c.is_spread) add_moments(d, by, c.n, a, b);
  };
  const ContactArms a = {c.r_a, c.n_a}, b = {c.r_b, c.n_b};
  if (c.a != kNobody) add(f.diagonal[e.place[c.a]], w, a, a);
  if (c.b != kNobody) add(f.diagonal[e.place[c.b]], w, b, b);
  if (c.below == kNobody) return;
  add(f.below[c.below], -w, c.a_later ? a : b, c.a_later ? b : a);
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
    if (c.below == kNobody) return;
    const std::uint32_t later = c.a_later ? c.a : c.b, other = c.a_later ? c.b : c.a;
    strike_out(f.below[c.below], problem.bodies[later].locks, problem.bodies[other].locks);
  };
  std::ranges::for_each(problem.contacts, hold_below);
  std::ranges::for_each(problem.links, hold_below);
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

// With momentum g = J^T p given, p' = J y / R and (M + J^T J / R) y = g: J^T p' = g - M y, and y is as small as R.
void shed_self_stress(ConeProblem& problem) {
  // kSoftness: what yields less counts as self-stress; at 1e-7 four-bar windows that pass the line in which all bars
  // lie are stopped there. kMuch: of the impulses; less is left as it is.
  constexpr Real kSoftness = 1e-5, kMuch = 1e-3;
  problem.factored = 0;
  for (ConeBody& b : bodies_of(problem)) b.gradient.set_zero();
  assemble_masses(problem);
  for (const ConeLink& c : problem.links) {
    if (!c.is_lock()) continue;
    add_impulse<&ConeBody::gradient>(problem, c, c.p);
    add_link(problem, c, 1 / (kSoftness * c.k));
  }
  hold_locked(problem);
  if (!factor(*problem.elimination, problem.first, problem.last, *problem.factor)) return;
  solve_for_steps(problem, 1);
  const auto needed = [&](const ConeLink& c) {
    return relative<&ConeBody::step>(problem.bodies, c) / (kSoftness * c.k);
  };
  Real shed2 = 0, borne2 = 0;
  for (const ConeLink& c : problem.links) {
    if (!c.is_lock()) continue;
    const Real shed = c.p - needed(c);
    shed2 += c.k * shed * shed, borne2 += c.k * c.p * c.p;
  }
  if (!(shed2 > kMuch * kMuch * borne2)) return;
  for (ConeLink& c : problem.links)
    if (c.is_lock()) c.p = needed(c);
}

Round::Round(ConeProblem& problem, Real softness) : problem_(problem), softness_(softness) {
  for (ConeContact& c : problem_.contacts) c.p0 = c.p, c.u0 = c.u;
  for (ConeLink& c : problem_.links) c.p0 = c.p, c.u0 = c.u;
  for (ConeBody& b : bodies_of(problem_)) b.change.set_zero();
}

void Round::take_back() {
  for (ConeBody& b : bodies_of(problem_)) b.v -= b.change;
  for (ConeContact& c : problem_.contacts) c.p = c.p0, c.u = c.u0;
  for (ConeLink& c : problem_.links) c.p = c.p0, c.u = c.u0;
}

std::uint32_t Round::minimise(Real tolerance, std::uint32_t most_steps) {
  constexpr Real kFalls = 0.5;  // where it is quadratic a step leaves nothing, or rounding
  std::uint32_t steps = 0;
  Real left = kInfinity;
  bool whole = false;  // the last step was
  for (; steps < most_steps; ++steps) {
    const Real now = find_gradient();
    if (now <= tolerance) break;
    const NextFactor factor = find_factor(steps == 0 ? tolerance : 0);
    if (factor == NextFactor::none) break;
    if (factor == NextFactor::same && whole && !(now < kFalls * left)) break;
    left = now;
    find_step();
    const Real length = search();
    whole = length == 1;
    if (length == 0) {
      is_stuck_ = true;
      break;
    }
    for (ConeBody& b : bodies_of(problem_)) b.change += length * b.step;
    for (ConeContact& c : problem_.contacts) c.u += length * c.du;
    for (ConeLink& c : problem_.links) c.u += length * c.du;
  }
  accept();
  return steps;
}

Real Round::find_gradient() {
  for (ConeBody& b : bodies_of(problem_)) b.gradient = momentum_of(b, b.change);
  for (ConeContact& c : problem_.contacts) {
    c.p = project_on_cone(pull(c, c.u), c.n, c.friction);
    add_impulse<&ConeBody::gradient>(problem_, c, c.p0 - c.p);
  }
  for (ConeLink& c : problem_.links) {
    c.p = c.k > 0 ? c.pulled(c.u, resistance(c), c.p0) : 0;
    add_impulse<&ConeBody::gradient>(problem_, c, c.p0 - c.p);
  }
  for (ConeBody& b : bodies_of(problem_)) b.step = velocity_of(b, b.gradient);
  Real most = 0;
  for (const ConeContact& c : problem_.contacts)
    most = std::max(most, relative<&ConeBody::step>(problem_.bodies, c).squared_norm());
  for (const ConeLink& c : problem_.links) {
    const Real u = relative<&ConeBody::step>(problem_.bodies, c);
    most = std::max(most, u * u);
  }
  return std::sqrt(most);
}

Round::NextFactor Round::find_factor(Real still) {
  const bool is_same = find_curvatures(still);
  if (is_same && problem_.factored == softness_) return NextFactor::same;
  problem_.factored = 0;
  assemble();
  if (!factor(*problem_.elimination, problem_.first, problem_.last, *problem_.factor)) return NextFactor::none;
  problem_.factored = softness_;
  return NextFactor::another;
}

ConeCurvature Round::curvature_of(const ConeContact& c, Real still) const {
  const Vec3 pulled = pull(c, c.u);
  if (c.p0 == Vec3::zero() && resistance(c) * pulled.norm() <= still) return ConeCurvature::alike;  // at the tip
  if (c.p == Vec3::zero()) return ConeCurvature::none;
  return c.p == pulled ? ConeCurvature::alike : ConeCurvature::slope;
}

bool Round::find_curvatures(Real still) {
  bool is_same = true;
  for (ConeContact& c : problem_.contacts) {
    const ConeCurvature now = curvature_of(c, still);
    is_same &= now == c.curvature && now != ConeCurvature::slope;
    c.curvature = now;
  }
  for (ConeLink& c : problem_.links) {
    const bool is_held = c.k > 0 && c.follows(c.u, resistance(c), c.p0);
    is_same &= is_held == c.is_held;
    c.is_held = is_held;
  }
  return is_same;
}

void Round::assemble() {
  const Elimination& e = *problem_.elimination;
  BlockFactor& f = *problem_.factor;
  assemble_masses(problem_);
  for (const ConeContact& c : problem_.contacts) {
    if (c.curvature == ConeCurvature::none) continue;
    if (c.curvature == ConeCurvature::alike) {
      add_sticking(problem_, c, 1 / resistance(c));
      continue;
    }
    const Mat3 w = slope_of_projection(pull(c, c.u), c.n, c.friction) / resistance(c);
    const Turning on_a(c, c.r_a, c.n_a), on_b(c, c.r_b, c.n_b);
    const Mat3 w_a = w * on_a.x, w_b = w * on_b.x;
    if (c.a != kNobody) add_own(f.diagonal[e.place[c.a]], w, on_a, w_a);
    if (c.b != kNobody) add_own(f.diagonal[e.place[c.b]], w, on_b, w_b);
    if (c.below == kNobody) continue;
    Block& d = f.below[c.below];
    const Mat3 &back = c.a_later ? on_a.back : on_b.back, &other = c.a_later ? w_b : w_a;
    add(d, 0, 0, -w);
    add(d, 0, 3, other);
    add(d, 3, 0, -(back * w));
    add(d, 3, 3, back * other);
  }
  for (const ConeLink& c : problem_.links)
    if (c.is_held) add_link(problem_, c, 1 / (resistance(c) + c.give));
  hold_locked(problem_);
}

void Round::find_step() {
  solve_for_steps(problem_, -1);
  for (ConeContact& c : problem_.contacts) c.du = relative<&ConeBody::step>(problem_.bodies, c);
  for (ConeLink& c : problem_.links) c.du = relative<&ConeBody::step>(problem_.bodies, c);
}

namespace {

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
Real gain_along(const ConeLine& line, Real mu, Real length) {
  const Real n = line.n0 + length * line.n1, u_t = line.ut0 + length * line.ut1;
  const Real t = std::sqrt(std::max(Real(0), line.t00 + length * (2 * line.t01 + length * line.t11)));
  if (n <= -mu * t) return -line.start;
  if (t <= mu * n) return line.u_n * n + u_t - line.start;
  const Real along = (n + mu * t) / (1 + mu * mu);
  return along * (mu > 0 ? line.u_n + mu / t * u_t : line.u_n) - line.start;
}

}  // namespace

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
    c.line = line_of(c, pull(c, c.u), c.du / -r);
    slope.rounding += c.du.norm() * (c.p.norm() + c.p0.norm() + (c.u.norm() + std::fabs(c.want - c.slip)) / r);
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
  for (const ConeContact& c : problem_.contacts) d -= gain_along(c.line, c.friction, length);
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
  for (ConeBody& b : bodies_of(problem_)) b.gradient.set_zero();
  for (ConeContact& c : problem_.contacts) add_impulse<&ConeBody::gradient>(problem_, c, c.p - c.p0);
  for (ConeLink& c : problem_.links) add_impulse<&ConeBody::gradient>(problem_, c, c.p - c.p0);
  for (ConeBody& b : bodies_of(problem_)) b.change = velocity_of(b, b.gradient), b.v += b.change;
  for (ConeContact& c : problem_.contacts) c.u = c.u0 + relative<&ConeBody::change>(problem_.bodies, c);
  for (ConeLink& c : problem_.links) c.u = c.u0 + relative<&ConeBody::change>(problem_.bodies, c);
}

}  // namespace carom::dynamics
