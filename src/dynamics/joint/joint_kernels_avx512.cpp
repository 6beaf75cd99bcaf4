// Sweeps over joints for machines with AVX-512VL (compiled so: src/CMakeLists.txt).
#include "dynamics/joint/joint_sweeps.h"

#if defined(__AVX512VL__)
namespace carom::dynamics {

extern const JointKernels kAvx512Joints;
constexpr JointKernels kAvx512Joints = joint_kernels_named("avx512");

}  // namespace carom::dynamics
#endif
