// Two bodies that are hit at one moment: the impulses of all points that touch then, after which each point moves as
// its materials want.
//
// Who asks says how fast two bodies move at a point at that moment, and what one impulse there does to them; both
// depend on what the velocities are those of: a whole substep (contact/impact.h), or a moment on a path
// (ccd/continuous.h).
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "core/constant.h"
#include "dynamics/contact/impulse.h"

namespace carom::dynamics {

inline constexpr Constant<int> kImpactSweeps{"impact_sweeps", 50, "sweeps",
                                             "at most, over the points of an impact, which depend on each other: a "
                                             "bound, so that what does not settle costs no more than that",
                                             "fewer: what lands flat on several points is left turning; more: time, "
                                             "where many points with friction and restitution do not settle"};
inline constexpr Constant<Real> kImpactSettled{
    "impact_settled", 1e-13, "1",
    "share of the speed of an impact that the last sweep may still change: well above rounding, well below what a "
    "bouncing body shows after a thousand impacts",
    "larger: what is hit on both sides alike drifts to one of them; as small as rounding: every impact takes all "
    "sweeps"};
inline constexpr Constant<Real> kGiveWay{"impact_give_way", 1e-9, "1",
                                         "share of the bodies' response without their locks, by which they give "
                                         "way where they are locked: an impulse without response stays finite",
                                         "larger: sweeps take longer to undo it; as small as rounding: what is hit "
                                         "along its locks gets an infinite impulse, and ends in quarantine"};
inline constexpr Constant<std::uint32_t> kMostImpacts{
    "impact_most", 100, "1",
    "impacts of one contact in a substep, after which the solver has it: what is hit more often lies between bodies that press, and "
    "its impacts have no end",
    "fewer: a ball that bounces low stops early; more: time, in heaps that bounce"};
inline constexpr Constant<Real> kSweepSamePatch{
    "sweep_same_patch", 0.99, "1",
    "cosine of the angle (0.14 rad) up to which the surface beside the place of a swept hit is of that hit",
    "larger: what lands flat on a mesh is hit at one point and left turning; smaller: a neighbouring slope turns it aside"};
inline constexpr ConstantRow kImpactConstants[] = {kImpactSweeps, kImpactSettled, kGiveWay, kMostImpacts,
                                                   kSweepSamePatch};

/// Points that are hit at one moment: of a pair, or of one body with several of the same ground.
inline constexpr std::size_t kMostHitPoints = 16 * Manifold::kMaxPoints;

/// One of two bodies that are hit.
struct ImpactBody {
  Vec3 v, omega;      // m/s, rad/s, world; impulses change them
  Vec3 inv_mass;      // 1/kg, along the world's axes; 0 along what is locked
  Mat3 inv_inertia;   // 1/(kg m^2), world; of what turns
  bool moves, turns;  // by impulses

  Vec3 at(const Vec3& arm) const { return v + omega.cross(arm); }
  /// @param p  N s   @param arm  m, world axes, from the centre of mass
  void push(const Vec3& p, const Vec3& arm) {
    if (!moves) return;
    v += inv_mass.times(p);
    if (turns) omega += inv_inertia * arm.cross(p);
  }
};

struct ImpactPair {
  ImpactBody a, b;
};

/// A point at which they touch.
struct ImpactPoint {
  Row row;       // its impulse is that of the impact alone
  RowMass mass;  // arms and K are the caller's, @see be_ready()
  Real want;     // m/s, normal velocity after the impact

  /// With arms, K, normal and friction known, and no impulse given yet.
  /// @param unlocked  1/kg, of both bodies if one of them has locks: that without them; else 0
  void be_ready(Real unlocked) {
    // Where nothing gives way no impulse helps; a little more than nothing keeps it finite, and sweeps undo what that
    // is off.
    if (unlocked > 0) mass.k.add_to_diagonal(Vec3::constant(kGiveWay * unlocked));
    mass.k_inv = mass.k.inverse();
    row.k_n = row.n.dot(mass.k * row.n);
    row.set_impulse(Vec3::zero());
  }
};

/// m/s, normal velocity after an impact.
/// @param speed      m/s, at which the point closes; negative: it parts, and what pushes elsewhere may turn that round
/// @param threshold  m/s, the slowest that bounces
inline Real wanted_speed(Real speed, Real restitution, Real threshold) {
  return speed > 0 && !(speed > threshold) ? 0 : restitution * speed;
}

/// The impulses after which all points move as they want, with Coulomb's friction.
///
/// The first sweep gives all points what each alone would need, times the share after which they part as wanted on the
/// whole. What is hit alike everywhere is done with that: it keeps its symmetry. Later sweeps go from point to point.
/// Where points lie close together for their bodies' size, a sweep undoes little of a turn. So the changes of a sweep
/// are prolonged to where they serve best, as long as no impulse leaves its cone.
/// @param points    std::span of ImpactPoint or of what is made of it, kMostHitPoints at most
/// @param speed     m/s, of the impact
/// @param velocity  of B's surface relative to A's at a point, m/s, as the bodies move by now: velocity(point)
template <class Point, class Velocity>
void resolve_impact(ImpactPair& pair, std::span<Point> points, Real speed, const Velocity& velocity) {
  std::array<Vec3, kMostHitPoints> before, u;  // N s, m/s, as a sweep begins
  const auto give = [&](Point& p, const Vec3& next) {
    const Vec3 change = next - p.row.p;
    p.row.set_impulse(next);
    pair.a.push(-change, p.mass.r_a);
    pair.b.push(change, p.mass.r_b);
  };
  const auto prolong = [&](bool together) {
    Real done = 0, left = 0;  // J: by the normal parts of the changes, of them
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Vec3 &n = points[k].row.n, now = velocity(points[k]);
      const Real change = (points[k].row.p - before[k]).dot(n);
      done += change * (now - u[k]).dot(n), left += change * (points[k].want - now.dot(n));
    }
    const Real share = 1 + left / done;
    if (!(done > 0) || !(share > (together ? 0 : 1))) return;
    const auto at_share = [&](std::size_t k) { return Vec3(before[k] + share * (points[k].row.p - before[k])); };
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Vec3 p = at_share(k);
      const Real p_n = p.dot(points[k].row.n), bound = points[k].row.friction * p_n;
      if (!together && (!(p_n >= 0) || (p - p_n * points[k].row.n).squared_norm() > bound * bound)) return;
    }
    for (std::size_t k = 0; k < points.size(); ++k) give(points[k], at_share(k));
  };
  for (int sweep = 0; sweep < kImpactSweeps; ++sweep) {
    const bool together = sweep == 0 && points.size() > 1;
    for (std::size_t k = 0; k < points.size(); ++k) before[k] = points[k].row.p, u[k] = velocity(points[k]);
    Real most = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      Point& p = points[k];
      p.row.u = together ? u[k] : velocity(p);
      const Vec3 next = resolved_impulse(p.row, p.mass, p.want);
      most = std::max(most, (next - p.row.p).norm() * p.row.k_n);
      give(p, next);
    }
    if (!together && !(most > kImpactSettled * speed)) break;
    if (points.size() > 1) prolong(together);
  }
}

}  // namespace carom::dynamics
