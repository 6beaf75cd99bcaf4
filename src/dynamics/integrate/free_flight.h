// Free flight: bodies on which in this step nothing acts but what is constant (gravity, the host's force).
//
// Substeps serve what is not: contacts, joints, forces that depend on where a body is or how fast. Whose acceleration
// is constant, and whose rotation keeps its omega, ends a step where it ends after any number of substeps. So the
// substeps are left to the others (who is `bound`: by a row of the solver, or as a participant of another effect that
// moves it), and those in flight take the step in one go, after them. One joint among 10,000 bodies that fly then costs
// what it costs alone, and what hangs on it does not change the bits of those that do not.
//
// What acts on a body itself decides, not what else there is: one with a spring takes the world's substeps though
// nothing in that world can touch. Where no body is bound (Plan::idle) substeps are left out, and kinematic bodies go
// through theirs at once. An integrator to which h is an approximation even in flight takes substeps with everybody.
//
// Where somebody is swept (ccd/continuous.h), who has a collider takes substeps, too: a sweep asks where others are within
// the step, and what it hits may go on and meet any body. What nothing hit is then put back and takes the step in
// one go: a bullet that meets it not changes no bit of it.
//
// @oracle  tests/unit/dynamics/test_free_flight, tests/effects/test_instructions
#pragma once

#include "dynamics/effects.h"
#include "dynamics/quarantine.h"

namespace carom::dynamics {

struct FreeFlight {
  explicit FreeFlight(Memory* m);

  /// Lists of a plan, of part of the bodies; and while the plan has that part in them, of all.
  struct Part {
    explicit Part(Memory* m);
    Participants linear, rotating;
    Array<Participants> of_row;  // by row of the table, of those that move bodies
  };
  Part bound, flying, again;
  Participants kinematic, springs;  // of those in flight: none
  Participants tied, more;          // scratch: who is bound
  Participants watched;             // bound for the sweeps of others alone
  struct Begun {
    Vec3 x, v, omega;
    Quat q;
  };
  Array<Begun> begun;  // as the step began, of the watched
  bool any = false;    // somebody flies in this step
  RowBits movers = 0;  // rows of the table that move bodies in this step: four loops go through them
};

/// Stage functions of the page. Between them the plan lists the bound bodies alone. The first one allocates.
void defer_free_bodies(const World& world, const StepTime& time);
void integrate_free_bodies(const World& world, Poses& poses, Quarantining to, const StepTime& time);

}  // namespace carom::dynamics
