// Particles in registers that every machine of the target has (x86-64: SSE2).
#include "dynamics/particles/flight_sweeps.h"

namespace carom::dynamics {

extern const FlightKernels kBaselineFlight;
constexpr FlightKernels kBaselineFlight = kernels_named("baseline");

}  // namespace carom::dynamics
