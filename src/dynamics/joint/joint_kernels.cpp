// Which kernels of joints this machine can run: those of the name that contacts go by.
#include "dynamics/joint/joint_kernels.h"

#include <cstring>
#include <initializer_list>

namespace carom::dynamics {

extern const JointKernels kBaselineJoints;
#if defined(__x86_64__)
extern const JointKernels kAvx2Joints, kAvx512Joints;
#endif

const JointKernels& joint_kernels(const char* name) {
#if defined(__x86_64__)
  for (const JointKernels* kernels : {&kAvx2Joints, &kAvx512Joints})
    if (std::strcmp(kernels->name, name) == 0) return *kernels;
#else
  static_cast<void>(name);
#endif
  return kBaselineJoints;
}

}  // namespace carom::dynamics
