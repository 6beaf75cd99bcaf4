// One proximal round of the direct solver: a smooth convex problem in the velocities, by Newton's method.
#pragma once

#include <algorithm>

#include "dynamics/solver/direct/cone_problem.h"

namespace carom::dynamics {

/// Minimises over velocities v
///     |v - v0|^2_M / 2 - sum p0.(u - u0) + sum (r + give) |P(z)|^2 / 2,   z = (r p0 - (u - asked)) / (r + give),
/// r = softness * k, whose gradient is nought where momentum and the impulses P(z) agree. P is the nearest impulse that a
/// row or a patch may bear.
class Round {
 public:
  Round(ConeProblem& problem, Real softness);

  /// @param tolerance  m/s, of velocities of rows   @return Newton steps taken
  std::uint32_t minimise(Real tolerance, std::uint32_t most_steps);
  /// Where it is cut short rows bear what has given the bodies the velocities of the steps taken.
  void keep_steps() { keeps_steps_ = true; }
  /// As it was before.
  void take_back();
  /// It ended where rounding decides which way to go: a softer round is better conditioned.
  bool is_stuck() const { return is_stuck_; }

 private:
  Real resistance(const ConePatch& c) const { return softness_ * c.k + c.give; }
  Real resistance(const ConeRow& c) const { return (c.is_lock() ? softness_of_locks() : softness_) * c.k; }
  Real softness_of_locks() const { return std::min(kSoftnessOfLocks, softness_); }
  /// m/s, of the gradient: velocities of bodies are rounded, and what locks resist them by is that over their softness.
  Real rounding() const;
  Mat3 slope(const ConePatch& c) const;
  /// The contacts and the friction of a patch that is coupled, at velocities moved by a step of a length.
  CoupledPatch project_coupled(const ConePatch& c, Real length) const;
  std::span<ConeRow> contacts_of(const ConePatch& c) const { return problem_.contacts.subspan(c.first, c.count); }
  void find_coupled_curvatures(ConePatch& c, Real still);
  void add_coupling(const ConePatch& c);
  /// Impulses that have given the bodies the velocities of the steps taken, along with one more.
  void trace(Real length);
  /// Impulse of a patch before it is bounded, at velocity u.
  Vec3 pull(const ConePatch& c, const Vec3& u) const { return (softness_ * c.k * c.p0 - u) / resistance(c); }
  /// Impulses at the present velocities, and what is lacking in the bodies' momentum.
  /// @return m/s, the most that a row's velocity would change if bodies had the momentum that impulses give
  Real find_gradient();
  enum class NextFactor { none, same, another };  // same as of the last step: the function is quadratic between
  /// The factor for the next step.
  /// @param still  m/s, @see find_curvatures()
  NextFactor find_factor(Real still);
  /// What a host has just built touches and bears nothing yet. Taken as parting its contacts would be found one layer a
  /// step.
  /// @param still  m/s: contacts that bear nothing and move no faster are taken to bear
  /// @return whether the factor is that of these curvatures
  bool find_curvatures(Real still);
  /// M + sum J^T (dP/dz / (r + give)) J. Locks are always in it, and hardly a round resists them otherwise than the last:
  /// with the masses they are assembled once a solve.
  void assemble();
  void assemble_locked();
  void find_step();
  /// Where along the step the function is least, closely enough: a root of its derivative, which grows.
  /// @return 0 where the derivative at the start is but rounding
  Real search();
  /// What of the derivative is linear: of bodies and locks, and of patches that stick all along.
  struct Slope {
    Real start, grows;  // J: start + length grows
    Real rounding;      // J, of all
  };
  Slope find_slope();
  /// J, along the step.
  Real derivative(const Slope& slope, Real length) const;
  /// Bodies get the momentum of the impulses, to the bit.
  void accept();

  /// Locks are linear: for them a hard round is as easy as a soft one, and one is enough.
  static constexpr Real kSoftnessOfLocks = 1e-7;

  ConeProblem& problem_;
  Real softness_;
  bool keeps_steps_ = false;
  bool is_stuck_ = false;
};

// ---- Newton's matrix, for others that solve with it ----

/// M, without what couples bodies, in f.
void assemble_masses(const ConeProblem& problem, const Blocks& f);
/// J^T w J of a row.
void add_row(const Elimination& e, const Blocks& f, const ConeRow& c, Real w);
/// J^T w J of a patch.
void add_patch(const Elimination& e, const Blocks& f, const ConePatch& c, const Mat3& w);
/// Rows and columns of what is locked: as if nothing touched there.
void hold_locked(ConeProblem& problem);
/// ConeBody::step from the gradient and the factor.
void solve_for_steps(ConeProblem& problem, Real sign);

}  // namespace carom::dynamics
