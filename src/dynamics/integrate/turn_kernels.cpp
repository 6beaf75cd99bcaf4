// Which kernels this machine can run.
#include "dynamics/integrate/turn_kernels.h"

#include "core/kernel_choice.h"

namespace carom::dynamics {

extern const TurnKernels kBaselineTurns;
#if defined(__x86_64__)
extern const TurnKernels kAvx2Turns;
#endif

namespace {

core::KernelChoice<TurnKernels> turn_choice() {
  core::KernelChoice<TurnKernels> choice(kBaselineTurns);
#if defined(__x86_64__)
  if (core::has_avx2()) choice.add(kAvx2Turns);
#endif
  return choice;
}

}  // namespace

std::span<const TurnKernels* const> all_turn_kernels() {
  static const core::KernelChoice<TurnKernels> kChoice = turn_choice();
  return kChoice.all();
}

const TurnKernels& turn_kernels() { return *all_turn_kernels().back(); }

}  // namespace carom::dynamics
