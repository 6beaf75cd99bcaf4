// Solvers: how the contacts of a step are answered, one room each over the same rows.
#pragma once

#include "dynamics/solver/table.h"

namespace carom::dynamics {

/// Stage functions of the page.
void begin_contacts(World& world, const StepTime& time);
void solve_velocities(World& world, const StepTime& time);
void solve_positions(World& world, const StepTime& time);
void end_contacts(World& world, const StepTime& time);

}  // namespace carom::dynamics
