// The paper's resolver: the most severe contact of a group is resolved first, and what that changed is told only to
// contacts that share a body with it.   @source [Millington2007]
//
// Velocity. A contact's law: its normal impulse is never negative; it closes no faster than its target allows; the
// friction impulse stays in the disc of radius mu times the normal impulse, and where it is inside, the point does not
// slide. The severity of a contact is the change of relative velocity (m/s) that its law still asks for. Impulses
// accumulate over the substep, so that a push that later proves too strong is taken back.
//
// Position. The severity of a contact is its penetration (m). Both bodies are moved and turned by their share of the
// inverse mass, as if hit by an impulse, but their velocities are left alone.
//
// A contact that was just resolved rests until a neighbour disturbs it, so none can hold the floor for itself. Both
// passes end when nothing exceeds the tolerance, or after `iterations` corrections per contact point of the group.
#pragma once

#include "dynamics/contact/contact.h"
#include "dynamics/solver/solver.h"

namespace carom::dynamics {

/// Severity of a row's velocity, squared (m/s)^2.
Real velocity_severity_squared(const Row& row);

}  // namespace carom::dynamics
