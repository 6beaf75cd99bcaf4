// Sweeps for machines with AVX2 (compiled so: src/CMakeLists.txt).
#include "dynamics/solver/contact_sweeps.h"

#if defined(__AVX2__)
namespace carom::dynamics {

extern const ContactKernels kAvx2Kernels;
constexpr ContactKernels kAvx2Kernels = kernels_named("avx2");

}  // namespace carom::dynamics
#endif
