// Sweeps over joints for registers that every machine of the target has (x86-64: SSE2).
#include "dynamics/joint/joint_sweeps.h"

namespace carom::dynamics {

extern const JointKernels kBaselineJoints;
constexpr JointKernels kBaselineJoints = joint_kernels_named("baseline");

}  // namespace carom::dynamics
