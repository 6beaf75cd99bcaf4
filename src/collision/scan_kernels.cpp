// Which kernels this machine can run.
#include "collision/scan_kernels.h"

#include <array>

namespace carom::collision {

extern const ScanKernel kBaselineScan;
#if defined(__x86_64__)
extern const ScanKernel kAvx2Scan;
#endif

namespace {

struct ScanKernelChoice {
  std::array<const ScanKernel*, 2> kernels{};
  std::size_t count = 0;

  ScanKernelChoice() {
    kernels[count++] = &kBaselineScan;
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2")) kernels[count++] = &kAvx2Scan;
#endif
  }
};

}  // namespace

std::span<const ScanKernel* const> all_scan_kernels() {
  static const ScanKernelChoice kChoice;
  return {kChoice.kernels.data(), kChoice.count};
}

const ScanKernel& scan_kernel() {
  static const ScanKernel& kWidest = *all_scan_kernels().back();
  return kWidest;
}

}  // namespace carom::collision
