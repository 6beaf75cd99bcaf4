// Which kernels this machine can run.
#include "dynamics/particles/flight_kernels.h"

#include <array>

namespace carom::dynamics {

extern const FlightKernels kBaselineFlight;
#if defined(__x86_64__)
extern const FlightKernels kAvx2Flight;
#endif

namespace {

struct FlightKernelChoice {
  std::array<const FlightKernels*, 2> kernels{};
  std::size_t count = 0;

  FlightKernelChoice() {
    kernels[count++] = &kBaselineFlight;
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2")) kernels[count++] = &kAvx2Flight;
#endif
  }
};

}  // namespace

std::span<const FlightKernels* const> all_flight_kernels() {
  static const FlightKernelChoice kChoice;
  return {kChoice.kernels.data(), kChoice.count};
}

const FlightKernels& flight_kernels() { return *all_flight_kernels().back(); }

}  // namespace carom::dynamics
