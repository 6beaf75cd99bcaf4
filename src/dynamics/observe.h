// What a host may know of a step. Observing never changes physics.
#pragma once

#include "dynamics/effects.h"

namespace carom::dynamics {

/// Clear the report for a new step.
void begin_report(const World& world, StepReport& report, GroupViews& groups, Events& events);

/// Stage observe: residuals, energies, contact views; closes the accounts of the step (clock, pending forces, impulses
/// for the next step's start).
void observe(const World& world, StepReport& report, HostForces& host, Impulses& impulses, Sleep& sleep,
             const StepTime& time);

}  // namespace carom::dynamics
