// One proximal round of the direct solver: a smooth convex problem in the velocities, by Newton's method.
#pragma once

#include <algorithm>

#include "dynamics/solver/direct/cone.h"
#include "dynamics/solver/direct/cone_problem.h"

namespace carom::dynamics {

/// Minimises over velocities v
///     |v - v0|^2_M / 2 - sum p0.(u - u0) + sum R |P_K(z)|^2 / 2,   z = p0 - (y + give p0) / R,   R = softness * k,
/// whose gradient is nought where momentum and the impulses P_K(z) agree.
/// Where friction is known K is the half of a cylinder; and contacts yield (yielding.h) by a share `give` of R from where they
/// bear nothing. What gives way by itself, as a spring, has R beside that only as far as it gives less.
class Round {
 public:
  Round(ConeProblem& problem, Real softness);
  enum class Friction { coulomb, known };
  Round(ConeProblem& problem, Real softness, Friction friction);

  /// As far as the work goes.   @param tolerance  m/s, of contact velocities   @return Newton steps taken
  std::uint32_t minimise(Real tolerance, std::uint32_t most_steps = kMostSteps);
  /// As it was before.
  void take_back();
  /// It ended where rounding decides which way to go: a softer round is better conditioned.
  bool is_stuck() const { return is_stuck_; }

 private:
  Real resistance(const ConeContact& c) const { return softness_ * c.k; }
  /// Beyond what it gives by itself: no more is needed.
  Real resistance(const ConeLink& c) const {
    return c.is_lock() ? softness_of_locks() * c.k : std::max(Real(0), softness_ * c.k - c.give);
  }
  Real softness_of_locks() const { return is_known_ ? kSoftnessOfLocks : std::min(kSoftnessOfLocks, softness_); }
  /// What tells the factor of this round from others: softness; where friction is known less than 0.
  Real factored_as() const { return is_known_ ? -softness_ : softness_; }
  Vec3 project(const ConeContact& c, const Vec3& z) const {
    return is_known_ ? project_on_cylinder(z, c.n, c.most_friction) : project_on_cone(z, c.n, c.friction);
  }
  /// m/s, of the gradient: velocities of bodies are rounded, and what locks resist them by is that over their softness.
  Real rounding() const;
  Mat3 slope(const ConeContact& c) const;
  Real gain_along(const ConeContact& c, Real length) const;
  /// Impulses that have given the bodies the velocities of the steps taken, along with one more.
  void trace(Real length);
  /// Impulse before it is projected, at velocity u.
  Vec3 pull(const ConeContact& c, const Vec3& u, Real r) const {
    return c.p0 - (u - (c.want - c.slip) * c.n + c.give * c.p0) / r;
  }
  /// Impulses at the present velocities, and what is lacking in the bodies' momentum.
  /// @return m/s, the most that a contact's velocity would change if bodies had the momentum that impulses give
  Real find_gradient();
  /// For the first step: rows hold that would by their whole k, though by R they don't. The velocities that a round begins with
  /// are off by a share of what loads do, which over R is far beyond any bound; Newton's method then finds row by row what holds.
  /// @return whether any does
  bool go_on();
  enum class NextFactor { none, same, another };  // same as of the last step: the function is quadratic between
  /// The factor for the next step.
  /// @param still  m/s, @see find_curvatures()
  NextFactor find_factor(Real still);
  /// What a host has just built touches and bears nothing yet: all its contacts are at the tips of their cones, where
  /// dP/dz jumps. Taken as off the cones they would be found one layer a step.
  /// @param still  m/s: contacts that bear nothing and move no faster are taken to stick
  /// @return whether the factor is that of these curvatures; what is not has stale nodes
  bool find_curvatures(Real still);
  /// Nodes of the forest that are to be factored anew.   @param changed  the softness, so all
  void spread_stale(bool changed);
  void mark_stale(std::uint32_t body) {
    if (body != kInvalid) problem_.tree[problem_.elimination->place[body] - problem_.first].is_stale = true;
  }
  /// Block products that contacts take as long as, in a step. What does not act is not in the matrix.
  std::uint64_t work_of_contacts() const;
  ConeCurvature curvature_of(const ConeContact& c, Real still) const;
  /// M + sum J^T (dP/dz / R) J. Locks are always in it, and hardly a round resists them otherwise than the last: with
  /// the masses they are assembled once a solve.
  void assemble();
  void assemble_locked();
  /// Limits and drives of its joint, in its own unknowns.
  void add_driven(TreeNode& node) const;
  void find_step();
  /// Where along the step the function is least, closely enough: a root of its derivative, which grows.
  /// @return 0 where it does not fall at the start, but for rounding
  Real search();
  /// Of the derivative along the step. What gives alike over its length is summed up once, @see ConeLine, LinkLine.
  struct Slope {
    Real start, grows;                    // J, of bodies: start + length grows
    Real straight_start, straight_grows;  // J, likewise of rows that are straight
    Real rounding;                        // J, of all
  };
  Slope find_slope();
  void add_line(ConeContact& c, Slope& slope) const;
  void add_line(ConeLink& c, Slope& slope) const;
  /// J, the derivative where the step begins.
  Real falls_at_start() const;
  /// J, along the step.
  Real derivative(const Slope& slope, Real length) const;
  /// Bodies get the momentum of the impulses, to the bit.
  void accept();
  /// J, the most that rows which ask for nothing give by what they keep to, and by velocities that are off.
  /// @param off  m/s
  Real may_give(Real off) const;

  /// Locks are linear: for them a hard round is as easy as a soft one, and one is enough.
  static constexpr Real kSoftnessOfLocks = 1e-7;

  ConeProblem& problem_;
  Real softness_;
  bool is_known_ = false;   // friction
  bool has_moved_ = false;  // some impulse is another than at the beginning, or some velocity
  bool is_stuck_ = false;
};

// ---- Newton's matrix, for others that solve with it ----

/// M, without what couples bodies, in f.
void assemble_masses(const ConeProblem& problem, const Blocks& f);
/// J^T w J of a contact that resists in all directions alike.
void add_sticking(ConeProblem& problem, const ConeContact& c, Real w);
/// Rows and columns of what is locked: as if nothing touched there.
void hold_locked(ConeProblem& problem);
/// ConeBody::step from the gradient and the factor.
void solve_for_steps(ConeProblem& problem, Real sign);

}  // namespace carom::dynamics
