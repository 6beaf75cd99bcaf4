// Where along a step of Newton's method the function is least: what most rows give is linear over a step, and summed up once.
#include <algorithm>

#include "dynamics/solver/direct/round.h"

namespace carom::dynamics {
namespace {

/// @param z1  change of z with the step
ConeLine line_of(const ConeContact& c, const Vec3& z1) {
  ConeLine line{};
  line.n0 = c.z.dot(c.n), line.n1 = z1.dot(c.n), line.u_n = c.du.dot(c.n);
  line.start = c.du.dot(c.p0);
  return line;
}
void add_across(const ConeContact& c, const Vec3& z1, ConeLine& line) {
  const Vec3 t0 = c.z - line.n0 * c.n, t1 = z1 - line.n1 * c.n;
  line.t00 = t0.squared_norm(), line.t01 = t0.dot(t1), line.t11 = t1.squared_norm();
  line.ut0 = c.du.dot(t0), line.ut1 = c.du.dot(t1);
}

/// N s, of z across n, at a length.
Real across(const ConeLine& line, Real length) {
  return std::sqrt(std::max(Real(0), line.t00 + length * (2 * line.t01 + length * line.t11)));
}

/// J, du . (P_K(z) - p0): as project_on_cone() has it, in numbers.
Real gain_in_cone(const ConeLine& line, Real mu, Real length) {
  const Real n = line.n0 + length * line.n1;
  if (mu == 0) return line.u_n * std::max(n, Real(0)) - line.start;
  const Real u_t = line.ut0 + length * line.ut1, t = across(line, length);
  if (n <= -mu * t) return -line.start;
  if (t <= mu * n) return line.u_n * n + u_t - line.start;
  return (n + mu * t) / (1 + mu * mu) * (line.u_n + mu / t * u_t) - line.start;
}

/// As project_on_cylinder() has it.
Real gain_in_cylinder(const ConeLine& line, Real most, Real length) {
  const Real n = line.n0 + length * line.n1;
  if (most == 0) return line.u_n * std::max(n, Real(0)) - line.start;
  const Real u_t = line.ut0 + length * line.ut1, t = across(line, length);
  return line.u_n * std::max(n, Real(0)) + (t <= most ? u_t : most / t * u_t) - line.start;
}

/// Which of its impulse follows z at both ends of a step, and so, as such parts of space are convex, between.
struct Following {
  bool is_straight, n, t;  // t: across n
};
Following following_in_cylinder(const ConeLine& line, Real most) {
  const Real n1 = line.n0 + line.n1;
  const bool follows = line.n0 >= 0 && n1 >= 0, is_off = line.n0 <= 0 && n1 <= 0;
  if (most == 0) return {follows || is_off, follows, false};
  return {(follows || is_off) && across(line, 0) <= most && across(line, 1) <= most, follows, true};
}
Following following_in_cone(const ConeLine& line, Real mu) {
  const Real n0 = line.n0, n1 = line.n0 + line.n1;
  if (mu == 0) return following_in_cylinder(line, 0);
  const Real t0 = across(line, 0), t1 = across(line, 1);
  const bool follows = t0 <= mu * n0 && t1 <= mu * n1, is_off = n0 <= -mu * t0 && n1 <= -mu * t1;
  return {follows || is_off, follows, follows};
}

}  // namespace

Real Round::gain_along(const ConeContact& c, Real length) const {
  return is_known_ ? gain_in_cylinder(c.line, c.most_friction, length) : gain_in_cone(c.line, c.friction, length);
}

void Round::add_line(ConeContact& c, Slope& slope) const {
  const Real r = resistance(c);
  const Vec3 z1 = c.du / -r;
  const bool slides = (is_known_ ? c.most_friction : c.friction) > 0;
  c.line = line_of(c, z1);
  if (slides) add_across(c, z1, c.line);
  const Following f =
      is_known_ ? following_in_cylinder(c.line, c.most_friction) : following_in_cone(c.line, c.friction);
  c.line.is_straight = f.is_straight;
  if (f.is_straight) {
    slope.straight_start += c.line.start;
    if (f.n) slope.straight_start -= c.line.u_n * c.line.n0, slope.straight_grows -= c.line.u_n * c.line.n1;
    if (f.t) slope.straight_start -= c.line.ut0, slope.straight_grows -= c.line.ut1;
    if (!f.n && !f.t && c.p0 == Vec3::zero()) return;  // it bears nothing
  }
  const Real asked = c.want - c.slip;
  slope.rounding += std::sqrt(c.du.squared_norm() * (c.p.squared_norm() + c.p0.squared_norm() +
                                                     (c.u.squared_norm() + asked * asked) / (r * r)));
}

void Round::add_line(ConeLink& c, Slope& slope) const {
  const Real r = resistance(c), g = 1 / (r + c.give);
  c.line = {false, c.at(c.low, c.u, r, c.p0), c.at(c.high, c.u, r, c.p0), c.du * g};
  slope.rounding += std::fabs(c.du) * (std::fabs(c.p) + std::fabs(c.p0) + std::fabs(c.u) * g);
  const bool is_one = c.low == c.high;
  // Where its impulse is: at its bound, following either velocity, or none.
  const auto part = [&](Real at_low, Real at_high) {
    if (at_low >= c.most) return 2;
    if (at_high <= -c.most) return -2;
    return is_one || at_low > 0 ? 1 : (at_high < 0 ? -1 : 0);
  };
  const int begins = part(c.line.at_low, c.line.at_high);
  c.line.is_straight = begins == part(c.line.at_low - c.line.falls, c.line.at_high - c.line.falls);
  if (!c.line.is_straight) return;
  slope.straight_start -= c.du * (c.p - c.p0);
  if (begins == 1 || begins == -1) slope.straight_grows += c.du * c.line.falls;
}

Round::Slope Round::find_slope() {
  Slope slope = {};
  for (const ConeBody& b : bodies_of(problem_)) {
    const Vec6 m = momentum_of(b, b.step);
    slope.start += b.change.dot(m);
    slope.grows += b.step.dot(m);
  }
  slope.rounding = std::fabs(slope.start);
  for (ConeContact& c : problem_.contacts) add_line(c, slope);
  for (ConeLink& c : problem_.links)
    if (c.k > 0) add_line(c, slope);
  constexpr Real kOfAll = 0.1;  // of all roundings if each went the same way; with all, a drive's speed was off by some
  slope.rounding *= kOfAll * kEpsilon;
  return slope;
}

Real Round::derivative(const Slope& slope, Real length) const {
  Real d = slope.start + length * slope.grows;
  const bool is_beyond = length > 1;
  if (!is_beyond) d += slope.straight_start + length * slope.straight_grows;
  for (const ConeContact& c : problem_.contacts)
    if (is_beyond || !c.line.is_straight) d -= gain_along(c, length);
  for (const ConeLink& c : problem_.links) {
    if (!(c.k > 0) || (!is_beyond && c.line.is_straight)) continue;
    const Real fallen = length * c.line.falls;
    d -= c.du * (c.bounded(c.line.at_low - fallen, c.line.at_high - fallen) - c.p0);
  }
  return d;
}

// From the gradient, whose terms have cancelled each other already.
Real Round::falls_at_start() const {
  Real d = 0;
  for (const ConeBody& b : bodies_of(problem_)) d += b.gradient.dot(b.step);
  for (const TreeNode& node : problem_.tree)
    for (int k = 0; node.drives > 0 && k < node.freedom; ++k) d += node.pushed[k] * node.q[k];
  for (const ConeContact& c : problem_.contacts)
    if (c.goes_on) d -= (c.p - c.z).dot(c.du);
  for (const ConeLink& c : problem_.links)
    if (c.goes_on) d -= (c.p - c.linear) * c.du;
  return d;
}

Real Round::search() {
  constexpr Real kClose = 0.1;
  constexpr int kTries = 30;
  const Slope slope = find_slope();
  Real low = 0, high = 1, d_low = falls_at_start();
  if (d_low >= -slope.rounding) return 0;
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

}  // namespace carom::dynamics
