// Which kernels this machine can run.
#include "dynamics/solver/contact_kernels.h"

#include <array>

namespace carom::dynamics {

extern const ContactKernels kBaselineKernels;
#if defined(__x86_64__)
extern const ContactKernels kAvx2Kernels, kAvx512Kernels;
#endif

namespace {

struct ContactKernelChoice {
  std::array<const ContactKernels*, 3> kernels{};
  std::size_t count = 0;

  ContactKernelChoice() {
    kernels[count++] = &kBaselineKernels;
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2")) kernels[count++] = &kAvx2Kernels;
    if (__builtin_cpu_supports("avx512vl")) kernels[count++] = &kAvx512Kernels;
#endif
  }
};

}  // namespace

std::span<const ContactKernels* const> all_contact_kernels() {
  static const ContactKernelChoice kChoice;
  return {kChoice.kernels.data(), kChoice.count};
}

const ContactKernels& contact_kernels() { return *all_contact_kernels().back(); }

}  // namespace carom::dynamics
