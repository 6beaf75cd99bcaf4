// Which kernels this machine can run.
#include "dynamics/integrate/turn_kernels.h"

#include <array>

namespace carom::dynamics {

extern const TurnKernels kBaselineTurns;
#if defined(__x86_64__)
extern const TurnKernels kAvx2Turns;
#endif

namespace {

struct TurnKernelChoice {
  std::array<const TurnKernels*, 2> kernels{};
  std::size_t count = 0;

  TurnKernelChoice() {
    kernels[count++] = &kBaselineTurns;
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2")) kernels[count++] = &kAvx2Turns;
#endif
  }
};

}  // namespace

std::span<const TurnKernels* const> all_turn_kernels() {
  static const TurnKernelChoice kChoice;
  return {kChoice.kernels.data(), kChoice.count};
}

const TurnKernels& turn_kernels() { return *all_turn_kernels().back(); }

}  // namespace carom::dynamics
