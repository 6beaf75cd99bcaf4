// One proximal round of the direct solver: a smooth convex problem in the velocities, by Newton's method.
#pragma once

#include "dynamics/solver/direct/cone_problem.h"

namespace carom::dynamics {

/// Minimises over velocities v
///     |v - v0|^2_M / 2 - sum p0.(u - u0) + sum R |P_K(z)|^2 / 2,   z = p0 - (y + give p0) / R,   R = softness * k + give,
/// whose gradient is nought where momentum and the impulses P_K(z) agree.
class Round {
 public:
  Round(ConeProblem& problem, Real softness);

  /// @param tolerance  m/s, of contact velocities   @return Newton steps taken
  std::uint32_t minimise(Real tolerance, std::uint32_t most_steps);
  /// As it was before.
  void take_back();

 private:
  Real resistance(const ConeContact& c) const { return softness_ * c.k + c.give; }
  /// Impulse before it is projected, at velocity u.
  Vec3 pull(const ConeContact& c, const Vec3& u) const {
    return c.p0 - (u - (c.want - c.slip) * c.n + c.give * c.p0) / resistance(c);
  }
  /// Impulses at the present velocities, and what is lacking in the bodies' momentum.
  /// @return m/s, the most that a contact's velocity would change if bodies had the momentum that impulses give
  Real find_gradient();
  /// The factor for the next step, or false: there is none.
  /// @param still  m/s, @see assemble()
  bool find_factor(Real still);
  /// Curvature: M + sum J^T (dP/dz / R) J. What a host has just built touches and bears nothing yet: all its contacts
  /// are at the tips of their cones, where dP/dz jumps. Taken as off the cones they would be found one layer a step.
  /// @param still  m/s: contacts that bear nothing and move no faster are taken to stick
  void assemble(Real still);
  void find_step();
  /// Where along the step the function is least, closely enough: a root of its derivative, which grows.
  Real search() const;
  /// Bodies get the momentum of the impulses, to the bit.
  void accept();

  ConeProblem& problem_;
  Real softness_;
  bool all_stick_ = false;
};

// ---- Newton's matrix, for others that solve with it ----

/// M, without what couples bodies.
void assemble_masses(ConeProblem& problem);
/// J^T w J of a contact that resists in all directions alike.
void add_sticking(ConeProblem& problem, const ConeContact& c, Real w);
/// Rows and columns of what is locked: as if nothing touched there.
void hold_locked(ConeProblem& problem);
/// ConeBody::step from the gradient and the factor.
void solve_for_steps(ConeProblem& problem, Real sign);

/// Impulses of locks that do what they do and are no larger than that takes. A ring of joints may hold itself more than
/// once; what its joints then bear against each other moves nobody, is whatever rounds have left of it, and grows from
/// substep to substep. Those that bear little of that keep theirs.
/// @accuracy  impulses: 1e-5, relative; velocities of bodies stay as they are
void shed_self_stress(ConeProblem& problem);

}  // namespace carom::dynamics
