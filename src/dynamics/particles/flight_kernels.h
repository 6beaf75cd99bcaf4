// Arithmetic of particles in lanes, compiled once for each width of registers.
#pragma once

#include <cstddef>
#include <span>

namespace carom::dynamics {

/// A substep of particles along one axis: gravity and drag leave the axes to themselves.
struct Flight {
  double h;        // s
  double gravity;  // m/s^2, times the set's factor
  double drag;     // 1/s, drag as a force: of RK4, where it is slow
  double keep;     // e^-c h, drag as a flow (velocity_verlet: of h/2, twice); 1 where it is a force, or none
};

/// Neighbours in the arrays of a set, none of them held.
struct FlightRun {
  double *x, *v;       // m, m/s
  const double* mass;  // kg, for the kernels that weigh
  std::size_t count;
};

/// Sums over what a block is after the step.
struct FlightSums {
  double vis_viva = 0;  // of m v^2, or of v^2 where all of the set weigh the same
  double x2 = 0;        // m^2, of x^2
  double v2 = 0;        // m^2/s^2, of v^2
};

/// Take each particle of a run through all substeps, and add what it then is to the sums.
using FlyRun = void (*)(const FlightRun& run, const Flight& flight, int substeps, FlightSums& sums);

/// The same functions for one width; same bits from each. By CAROM_INTEGRATOR_*.
struct FlightKernels {
  const char* name;
  FlyRun alike[4];    // all of the set weigh the same
  FlyRun weighed[4];  // by their masses
};

/// The widest that this machine has: what a world starts with. A test gives Particles::kernels another.
const FlightKernels& flight_kernels();
/// All that this machine can run, the baseline first.
std::span<const FlightKernels* const> all_flight_kernels();

}  // namespace carom::dynamics
