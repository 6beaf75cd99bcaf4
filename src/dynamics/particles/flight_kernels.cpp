// Which kernels this machine can run.
#include "dynamics/particles/flight_kernels.h"

#include "core/kernel_choice.h"

namespace carom::dynamics {

extern const FlightKernels kBaselineFlight;
#if defined(__x86_64__)
extern const FlightKernels kAvx2Flight;
#endif

namespace {

core::KernelChoice<FlightKernels> flight_choice() {
  core::KernelChoice<FlightKernels> choice(kBaselineFlight);
#if defined(__x86_64__)
  if (core::has_avx2()) choice.add(kAvx2Flight);
#endif
  return choice;
}

}  // namespace

std::span<const FlightKernels* const> all_flight_kernels() {
  static const core::KernelChoice<FlightKernels> kChoice = flight_choice();
  return kChoice.all();
}

const FlightKernels& flight_kernels() { return *all_flight_kernels().back(); }

}  // namespace carom::dynamics
