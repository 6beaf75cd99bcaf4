// Bodies that turn, in registers that every machine of the target has (x86-64: SSE2).
#include "dynamics/integrate/turn_sweeps.h"

namespace carom::dynamics {

extern const TurnKernels kBaselineTurns;
constexpr TurnKernels kBaselineTurns = turn_kernels_named("baseline");

}  // namespace carom::dynamics
