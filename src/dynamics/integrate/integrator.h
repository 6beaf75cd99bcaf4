// Integrators: from forces to velocities, and from velocities to poses.
//
// velocity(h) changes v and omega by the forces that have participants, and may leave a predicted pose: the pose in
// which a body ends if no contact acts. position(h) takes the predicted pose for bodies no solver touched in this
// substep and moves all others by their (solved) velocity:
//
//                     velocity                     untouched body's pose          order of the pose in flight
//   explicit Euler    v1 = v0 + h a(x0, v0)        x1 = x0 + h v0                 1
//   semi-implicit     v1 = v0 + h a(x0, v0)        x1 = x0 + h v1 (no predicted pose)   1, symplectic
//   RK4               classical, 4 evaluations     x1 = x0 + h (RK4 mean of v)    4
//   velocity Verlet   v1 = v0 + h/2 (a0 + a1)      x1 = x0 + h (v0 + h/2 a0)      2, symplectic, exact if a is constant
//
// A touched body cannot keep its predicted pose: it was made before the impulses and would carry the body through the
// floor. It moves by the velocity at the end of the substep, which is what the solver made admissible: semi-implicit
// Euler. What slides or rolls while its contacts stay as they are moves by the mean of both ends
// (contact/mean_motion.h).
//
// Where a rotation method carries a body (rotation/rotation.h), that method proposes the orientation under any
// integrator but RK4. A touched body is then turned on from the predicted pose by what the contacts made of its omega
// since:
//
//   q1 = exp(h (omega_solved - omega_proposed)) q_proposed
//
// exp(h omega_solved) q0 would agree to the same order, but gain energy like the explicit torque: omega changes with
// the orientation even if nothing pushes, and the two belong together. A body at rest has no such change; how far the
// predicted pose of one that tumbles departs from its tangent, h^2/2 times its acceleration, is what a contact's
// linearised motion leaves out anyway. Who hangs on joints alone gets the omega that belongs to q1 (joint/README.md,
// "What spins").
#pragma once

#include "dynamics/effects.h"
#include "dynamics/quarantine.h"

namespace carom::dynamics {

struct Motions;  // turn_kernels.h

struct Integrator {
  const char* name;
  bool proposes;         // fills plan.predicted for every dynamic body
  bool forces_only;      // evaluates at intermediate states, so effects must be forces rather than flows
  bool exact_in_flight;  // where accelerations are constant, h is no approximation
  Real lag;              // substeps from the start of a substep to the moment whose velocity is stored after it
  std::size_t vectors;   // scratch it wants: Vec3 arrays and Quat arrays of one element per body slot
  std::size_t rotations;
  void (*velocity)(const World& world, Velocities& to, Real h);
};

/// What lanes take of the state, and where they put it.
Motions motions_of(const World& world, Array<Vec3>& to_x, Array<Quat>& to_q);

extern const Integrator kExplicitEuler, kSemiImplicitEuler, kRungeKutta4, kVelocityVerlet;

/// Stage functions of the page.
void integrate_velocity(const World& world, Quarantining to, const StepTime& time);
void integrate_position(const World& world, Poses& poses, Quarantining to, const StepTime& time);
/// Kinematic bodies through all substeps of a step at once, where nothing else needs these: to the same bits.
void drive_kinematics(const World& world, Poses& poses, Quarantining to, const StepTime& time);
/// Bodies whose velocity or spin left the finite world into quarantine: part of integrate_velocity(), and once more
/// after a step's last impulses, so that no host reads what the next substep would have seen.
void quarantine_outliers(const World& world, Quarantining to, const StepTime& time);

}  // namespace carom::dynamics
