// Bodies that turn, for machines with AVX2 (compiled so: src/CMakeLists.txt).
#include "dynamics/integrate/turn_sweeps.h"

#if defined(__AVX2__)
namespace carom::dynamics {

extern const TurnKernels kAvx2Turns;
constexpr TurnKernels kAvx2Turns = turn_kernels_named("avx2");

}  // namespace carom::dynamics
#endif
