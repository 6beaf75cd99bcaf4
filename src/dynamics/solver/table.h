// The solvers there are, as a table: how the contacts of a step are solved, one file each over the same rows.
#pragma once

#include "dynamics/effects.h"

namespace carom::dynamics {

/// What a solver does at each place of the page; null where it has nothing to do.
struct Solver {
  const char* name;
  bool in_lanes;          // solves rows in WideContacts, but for groups that it gives to the direct solver
  bool row_by_row;        // keeps the velocity of each row up to date, and goes to the most severe
  bool counts_positions;  // positions() does as many rounds as position_iterations says: none, if that is 0
  using Begins = Writes<SolverMemory, GroupViews, StepReport>;
  using Solves = Writes<Velocities, SolverMemory, StepReport>;
  using Relaxes = Writes<Poses, Velocities, StepReport>;
  // The rows are made, nothing has moved; may allocate.
  void (*begin)(const World& world, Begins to, const StepTime& time);
  void (*velocities)(const World& world, Solves to, const StepTime& time);  // before bodies move
  void (*positions)(const World& world, Relaxes to, const StepTime& time);  // after
  void (*end)(const World& world, Poses& to, const StepTime& time);         // after the last substep
};

extern const Solver kSeverity, kSoftStep, kDirect, kAuto;  // by CAROM_SOLVER_*

}  // namespace carom::dynamics
