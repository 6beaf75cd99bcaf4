// Sweeps over joints for machines with AVX2 (compiled so: src/CMakeLists.txt).
#include "dynamics/joint/joint_sweeps.h"

#if defined(__AVX2__)
namespace carom::dynamics {

extern const JointKernels kAvx2Joints;
constexpr JointKernels kAvx2Joints = joint_kernels_named("avx2");

}  // namespace carom::dynamics
#endif
