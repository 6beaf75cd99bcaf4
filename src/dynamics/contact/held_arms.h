// Arms that hold while a body leans by little, so that springs stand in for what is rigid; @see ../README.md, "Soft
// stacks".
#pragma once

#include "dynamics/effects.h"

namespace carom::dynamics {

/// Once a step, before arms are asked for: a body that has turned by hold_angle since, or turns at some speed, is held
/// as it is now. Writes State::held_q of that body alone.
void hold_orientation(const World& world, SolverMemory& to, std::uint32_t body);

/// What an arm has to be corrected by, to be turned as the body is held: `held_back() * l`, l in body axes. By
/// plan.rotation; zero where nothing is held.
Mat3 held_back(const World& world, std::uint32_t body);

}  // namespace carom::dynamics
