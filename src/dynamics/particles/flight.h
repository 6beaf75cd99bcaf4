// A step of all particles.
#pragma once

#include "dynamics/effects.h"

namespace carom::dynamics {

/// Their part of stage integrate: all substeps of each particle at once, since none waits for another. What leaves the
/// world is held.
void integrate_particles(const World& world, Particles& particles, FaultViews& faults, const StepTime& time);

}  // namespace carom::dynamics
