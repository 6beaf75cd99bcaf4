// Newton's method with an exact line search.
#include "dynamics/solver/direct/round.h"

#include <algorithm>

#include "dynamics/solver/direct/patch_bound.h"

namespace carom::dynamics {

Round::Round(ConeProblem& problem, Real softness) : problem_(problem), softness_(softness) {
  each_part(problem_, [](auto& c) { c.p0 = c.p, c.u0 = c.u; });
  for (ConeBody& b : bodies_of(problem_)) b.change.set_zero();
}

void Round::take_back() {
  for (ConeBody& b : bodies_of(problem_)) b.v -= b.change;
  each_part(problem_, [](auto& c) { c.p = c.p0, c.u = c.u0; });
}

std::uint32_t Round::minimise(Real tolerance, std::uint32_t most_steps) {
  constexpr Real kFalls = 0.5;  // where it is quadratic a step leaves nothing, or rounding
  std::uint32_t steps = 0;
  bool is_reached = false;
  Real left = kInfinity;
  bool whole = false;  // the last step was
  if (keeps_steps_) save_impulses<&ConeRow::yielding_p, &ConePatch::yielding_p>(problem_);
  for (; steps < most_steps; ++steps) {
    const Real now = find_gradient();
    is_reached = now <= tolerance;
    if (is_reached) break;
    const NextFactor factor = find_factor(steps == 0 ? tolerance : 0);
    if (factor == NextFactor::none) break;
    if (factor == NextFactor::same && !(now < kFalls * left) && (whole || now <= rounding())) break;
    left = now;
    find_step();
    const Real length = search();
    whole = length == 1;
    if (length == 0) {
      is_stuck_ = true;
      break;
    }
    if (keeps_steps_) trace(length);
    for (ConeBody& b : bodies_of(problem_)) b.change += length * b.step;
    each_part(problem_, [&](auto& c) { c.u += length * c.du; });
  }
  if (keeps_steps_ && !is_reached) each_part(problem_, [](auto& c) { c.p = c.yielding_p; });
  accept();
  return steps;
}

Real Round::rounding() const {
  constexpr Real kSome = 10;  // roundings: the velocity of a row is a sum of twelve products
  Real most2 = 0;
  for (const ConeBody& b : bodies_of(problem_)) most2 = std::max(most2, speed2(b, b.v));
  return kSome * kEpsilon * std::sqrt(most2) / softness_of_locks();
}

// M change = J^T (q - p0) holds before and after a step L: its M step = J^T (p - q - W du), W the slope of p by -u.
void Round::trace(Real length) {
  for (ConePatch& c : problem_.patches) {
    Vec3 next = c.p;
    if (c.curvature == PatchCurvature::sticks) next -= c.du / resistance(c);
    if (c.curvature == PatchCurvature::slides) next -= slope(c) * c.du;
    c.yielding_p += length * (next - c.yielding_p);
  }
  for (ConeRow& c : problem_.rows) {
    const Real next = c.p - (c.is_held ? c.du / (resistance(c) + c.give) : 0);
    c.yielding_p += length * (next - c.yielding_p);
  }
}

Mat3 Round::slope(const ConePatch& c) const { return slope_on_bound(pull(c, c.u), c.bound()) / resistance(c); }

Real Round::find_gradient() {
  for (ConeBody& b : bodies_of(problem_)) b.gradient = momentum_of(b, b.change);
  for (ConeRow& c : problem_.rows) c.p = c.k > 0 ? c.pulled(c.u, resistance(c), c.p0) : 0;
  for (ConePatch& c : problem_.patches) {
    if (!c.is_coupled) {
      c.p = c.most > 0 ? project_on_bound(pull(c, c.u), c.bound()) : Vec3::zero();
      continue;
    }
    const CoupledPatch both = project_coupled(c, 0);
    c.p = both.friction, c.most = both.most;
    for (std::uint32_t k = 0; k < c.count; ++k) problem_.contacts[c.first + k].p = both.normal[k];
  }
  each_part(problem_, [&](const auto& c) { add_impulse<&ConeBody::gradient>(problem_, c, c.p0 - c.p); });
  for (ConeBody& b : bodies_of(problem_)) b.step = velocity_of(b, b.gradient);
  Real most2 = 0;
  for (const ConeRow& c : problem_.rows) {
    const Real u = relative<&ConeBody::step>(problem_.bodies, c);
    most2 = std::max(most2, u * u);
  }
  for (const ConePatch& c : problem_.patches)
    most2 = std::max(most2, relative<&ConeBody::step>(problem_.bodies, c).squared_norm());
  return std::sqrt(most2);
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

CoupledPatch Round::project_coupled(const ConePatch& c, Real length) const {
  std::array<Real, kPairPoints> z{}, r{};
  for (std::uint32_t k = 0; k < c.count; ++k) {
    const ConeRow& row = problem_.contacts[c.first + k];
    r[k] = resistance(row), z[k] = row.p0 - (row.u + length * row.du - row.low) / r[k];
  }
  return {std::span(z.data(), c.count),
          std::span(r.data(), c.count),
          pull(c, c.u + length * c.du),
          resistance(c),
          c.friction,
          c.bound()};
}

/// Contacts that bear follow their velocities, and what the bound couples is noted.
void Round::find_coupled_curvatures(ConePatch& c, Real still) {
  const Vec3 z = pull(c, c.u);
  const bool is_new = c.p0 == Vec3::zero() && resistance(c) * z.norm() <= still;
  c.curvature = c.p == z || is_new ? PatchCurvature::sticks
                : c.most > 0       ? PatchCurvature::slides
                                   : PatchCurvature::none;
  if (c.curvature != PatchCurvature::slides) return;
  std::array<Real, kPairPoints> r{};
  for (std::uint32_t k = 0; k < c.count; ++k) r[k] = resistance(problem_.contacts[c.first + k]);
  CoupledPatch at = project_coupled(c, 0);
  c.coupling = PatchCoupling(at, std::span(r.data(), c.count), z, resistance(c), c.friction, c.bound());
}

bool Round::find_curvatures(Real still) {
  bool is_same = true;
  for (ConePatch& c : problem_.patches) {
    const PatchCurvature was = c.curvature;
    if (c.is_coupled)
      find_coupled_curvatures(c, still);
    else
      c.curvature = !(c.most > 0)         ? PatchCurvature::none
                    : c.p == pull(c, c.u) ? PatchCurvature::sticks
                                          : PatchCurvature::slides;
    is_same &= was == c.curvature && was != PatchCurvature::slides;
  }
  for (ConeRow& c : problem_.rows) {
    const bool is_contact = c.high == kInfinity;
    bool is_held = c.k > 0 && (is_contact ? c.p > 0 : c.follows(c.u, resistance(c), c.p0));
    if (is_contact && c.p0 == 0 && c.u - c.low <= still) is_held = c.k > 0;
    is_same &= is_held == c.is_held;
    c.is_held = is_held;
  }
  return is_same;
}

void Round::find_step() {
  solve_for_steps(problem_, -1);
  each_part(problem_, [&](auto& c) { c.du = relative<&ConeBody::step>(problem_.bodies, c); });
}

Round::Slope Round::find_slope() {
  Slope slope = {0, 0, 0};
  for (const ConeBody& b : bodies_of(problem_)) {
    const Vec6 m = momentum_of(b, b.step);
    slope.start += b.change.dot(m);
    slope.grows += b.step.dot(m);
  }
  slope.rounding = std::fabs(slope.start);
  for (ConePatch& c : problem_.patches) {
    slope.start += c.du.dot(c.p0);
    if (!(c.most > 0) && !c.is_coupled) continue;
    c.line = BoundLine(pull(c, c.u), (-1 / resistance(c)) * c.du, c.du, c.n);
    slope.rounding += c.du.norm() * (c.p.norm() + c.p0.norm() + c.u.norm() / resistance(c));
  }
  for (const ConeRow& c : problem_.rows) {
    if (!(c.k > 0)) continue;
    const Real r = resistance(c) + c.give, asked = c.high == kInfinity ? std::fabs(c.low) : 0;
    slope.rounding += std::fabs(c.du) * (std::fabs(c.p) + std::fabs(c.p0) + (std::fabs(c.u) + asked) / r);
    if (c.is_lock()) slope.start -= c.du * (c.p - c.p0), slope.grows += c.du * c.du / r;
  }
  constexpr Real kOfAll = 0.1;  // of all roundings if each went the same way; with all, a drive's speed was off by some
  slope.rounding *= kOfAll * kEpsilon;
  return slope;
}

Real Round::derivative(const Slope& slope, Real length) const {
  Real d = slope.start + length * slope.grows;
  for (const ConePatch& c : problem_.patches) {
    if (!c.is_coupled) {
      if (c.most > 0) d -= c.line.gain(c.bound(), length);
      continue;
    }
    const CoupledPatch both = project_coupled(c, length);
    d -= c.du.dot(both.friction);
    for (std::uint32_t k = 0; k < c.count; ++k) {
      const ConeRow& row = problem_.contacts[c.first + k];
      d -= row.du * (both.normal[k] - row.p0);
    }
  }
  const bool is_coupled = !problem_.patches.empty() && problem_.patches.front().is_coupled;
  for (const ConeRow& c : is_coupled ? problem_.links : problem_.rows)
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
  each_part(problem_, [&](const auto& c) { add_impulse<&ConeBody::gradient>(problem_, c, c.p - c.p0); });
  for (ConeBody& b : bodies_of(problem_)) b.change = velocity_of(b, b.gradient), b.v += b.change;
  each_part(problem_, [&](auto& c) { c.u = c.u0 + relative<&ConeBody::change>(problem_.bodies, c); });
}

}  // namespace carom::dynamics
