// Particles for machines with AVX2 (compiled so: src/CMakeLists.txt).
#include "dynamics/particles/flight_sweeps.h"

#if defined(__AVX2__)
namespace carom::dynamics {

extern const FlightKernels kAvx2Flight;
constexpr FlightKernels kAvx2Flight = kernels_named("avx2");

}  // namespace carom::dynamics
#endif
