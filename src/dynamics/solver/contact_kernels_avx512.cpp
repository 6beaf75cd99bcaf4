// Sweeps for machines with AVX-512VL: still registers of 256 bits, but twice as many, and masks (compiled so:
// src/CMakeLists.txt).
#include "dynamics/solver/contact_sweeps.h"

#if defined(__AVX512VL__)
namespace carom::dynamics {

extern const ContactKernels kAvx512Kernels;
constexpr ContactKernels kAvx512Kernels = kernels_named("avx512");

}  // namespace carom::dynamics
#endif
