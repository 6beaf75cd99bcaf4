// Which kernels this machine can run.
#include "dynamics/solver/contact_kernels.h"

#include "core/kernel_choice.h"

namespace carom::dynamics {

extern const ContactKernels kBaselineKernels;
#if defined(__x86_64__)
extern const ContactKernels kAvx2Kernels, kAvx512Kernels;
#endif

namespace {

core::KernelChoice<ContactKernels> contact_choice() {
  core::KernelChoice<ContactKernels> choice(kBaselineKernels);
#if defined(__x86_64__)
  if (core::has_avx2()) choice.add(kAvx2Kernels);
  if (core::has_avx512vl()) choice.add(kAvx512Kernels);
#endif
  return choice;
}

}  // namespace

std::span<const ContactKernels* const> all_contact_kernels() {
  static const core::KernelChoice<ContactKernels> kChoice = contact_choice();
  return kChoice.all();
}

const ContactKernels& contact_kernels() { return *all_contact_kernels().back(); }

}  // namespace carom::dynamics
