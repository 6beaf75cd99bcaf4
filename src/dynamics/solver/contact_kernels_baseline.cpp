// Sweeps for registers that every machine of the target has (x86-64: SSE2).
#include "dynamics/solver/contact_sweeps.h"

namespace carom::dynamics {

extern const ContactKernels kBaselineKernels;
constexpr ContactKernels kBaselineKernels = kernels_named("baseline");

}  // namespace carom::dynamics
