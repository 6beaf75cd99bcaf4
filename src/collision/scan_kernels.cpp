// Which kernels this machine can run.
#include "collision/scan_kernels.h"

#include "core/kernel_choice.h"

namespace carom::collision {

extern const ScanKernel kBaselineScan;
#if defined(__x86_64__)
extern const ScanKernel kAvx2Scan;
#endif

namespace {

core::KernelChoice<ScanKernel> scan_choice() {
  core::KernelChoice<ScanKernel> choice(kBaselineScan);
#if defined(__x86_64__)
  if (core::has_avx2()) choice.add(kAvx2Scan);
#endif
  return choice;
}

}  // namespace

std::span<const ScanKernel* const> all_scan_kernels() {
  static const core::KernelChoice<ScanKernel> kChoice = scan_choice();
  return kChoice.all();
}

const ScanKernel& scan_kernel() {
  static const ScanKernel& kWidest = *all_scan_kernels().back();
  return kWidest;
}

}  // namespace carom::collision
