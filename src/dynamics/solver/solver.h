// Solvers: how the contacts of a step are solved, one file each over the same rows.
#pragma once

#include "dynamics/joint/wide_joints.h"
#include "dynamics/solver/table.h"

namespace carom::dynamics {

/// Stage functions of the page.
void begin_contacts(const World& world, Solver::Begins to, Owned<MeanMotion>& means, const StepTime& time);
void solve_velocities(const World& world, Solver::Solves to, const StepTime& time);
void solve_positions(const World& world, Solver::Relaxes to, const StepTime& time);
void end_contacts(const World& world, Poses& poses, Breaking joints, Events& events, const StepTime& time);

}  // namespace carom::dynamics
