// Ground that turns: discs, lorries in a bend, arms that swing, belts that bend.
//
// What sticks has no slip over the whole substep h: friction's target is not the velocity of the ground where the
// substep begins, but how far the ground's point goes in it, over h. By the tangent alone a body on a disc would leave
// its circle by (omega h)^2 r / 2 in each. Of two bodies that turn alike, by omega, centres x apart, every point of
// contact parts by the same:
//   to = (exp(h omega) - 1) x / h,
// and what rows have instead is omega x (r_a - r_b), by arms that may be older. The difference is the lead, which is
// added to slip velocities as the velocity of a belt is. It is exact for what stands on ground that a host moves, at
// any h. Ground that impulses move counts by the other's share of the inverse masses, so that a heavy disc and a driven
// one are alike. Ground that does not turn has no lead. Surfaces with a velocity of their own go along in the ground's
// frame: exp(h omega) (the way of a point of the belt in it). Friction that holds something on its circle turns as well,
// so what solvers start from is turned from one substep to the next.
//
// @oracle tests/oracle/test_turning_ground
#pragma once

#include "core/constant.h"
#include "dynamics/contact/contact.h"

namespace carom::dynamics {

inline constexpr Constant<Real> kTurnsAlong{
    "turns_along", 1e-5, "rad",
    "in a step, by which both of two bodies that impulses move are to turn for one to be taken round by the other",
    "larger: what stands on a slow disc of its own bearings drifts; smaller: time, in heaps that settle"};
inline constexpr ConstantRow kTurningGroundConstants[] = {kTurnsAlong};

/// Of A and B as each other's ground: what of the pair's turn is its own.
struct OwnShares {
  Real a, b;
  OwnShares(const Scene& scene, const Row& row);
};

/// How far two surfaces go in a substep, over its length, and by which spin.
struct Lead {
  Vec3 to;    // m/s, world: of A's surface at B's centre, relative to B's at A's centre
  Vec3 spin;  // rad/s, world, of the ground
  Vec3 turn;  // rad/s, world, of what goes along: belts take it round beside the ground
  /// m/s, what is added to a slip velocity.   @param apart  m, A's arm less B's, as the row has them
  Vec3 at(const Vec3& apart) const { return spin.cross(apart) - to; }
  /// Likewise, in the plane of a contact.
  Vec3 along(const Vec3& apart, const Vec3& n) const {
    const Vec3 all = at(apart);
    return all - all.dot(n) * n;
  }
  /// Of an impulse of the substep before: its friction goes round with the ground.   @param h  s
  Vec3 taken_on(const Vec3& p, const Vec3& n, Real h) const {
    const Vec3 normal = p.dot(n) * n;
    return normal + exp_map(h * turn.dot(n) * n) * Vec3(p - normal);
  }
};

/// Stage group, after find_surfaces(): pairs whose ground turns, and which of them slide.
void find_turning_pairs(const World& world, const StepTime& time);
/// From poses and velocities of the present.   @param h  s, substep; less than 0: of the one before
Lead lead_of(const World& world, const TurningPair& pair, Real h);
/// The record of a row's pair; null: its ground does not turn.
inline const TurningPair* turning_pair_at(const Contacts& c, std::uint32_t row) {
  const std::uint32_t i = c.turning_pairs.empty() ? 0 : c.geometry[row].turning_pairs;
  return i > 0 ? &c.turning_pairs[i - 1] : nullptr;
}
/// Let rows of a pair know where its record is.
void number_turning_pairs(Contacts& c);

}  // namespace carom::dynamics
