// How far the last step is from the laws it should obey, worked out when a host asks.
#pragma once

#include "dynamics/world.h"

namespace carom::dynamics {

/// @see carom_residuals for units and what is of when.
struct Residuals {
  std::uint64_t points = 0, joints = 0;
  Real max_penetration = 0, mean_penetration = 0;  // m
  Real joint_gap = 0, joint_angle = 0;             // m, rad
  Real complementarity = 0, cone = 0, slip = 0;    // m/s
  Real energy = 0, energy_drift = 0;               // J
};

/// Impulses p and velocities u of a pair's points obey Coulomb's law where each p is the projection of p - u / k on
/// what p may be, k the velocity that an impulse makes; an offence is k times how far p is from there. Normal impulses
/// point by point (what they may be: >= 0), friction as the one force of a pair by which solvers apply it (a disc of
/// radius mu times the load), at the mean of its points' slips.
/// @oracle tests/oracle/test_residuals
Residuals residuals_of(const World& world);

}  // namespace carom::dynamics
