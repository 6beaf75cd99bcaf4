// Kernels of one kind that this machine can run: each was compiled for a width of registers, and gives the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace carom::core {

#if defined(__x86_64__)
inline bool has_avx2() {
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx2");
}
inline bool has_avx512vl() {
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx512vl");
}
#endif

/// In the order of their widths, the baseline first.
template <class Kernels>
class KernelChoice {
 public:
  explicit KernelChoice(const Kernels& baseline) { add(baseline); }
  void add(const Kernels& wider) { kernels_[count_++] = &wider; }
  std::span<const Kernels* const> all() const { return {kernels_.data(), count_}; }

 private:
  std::array<const Kernels*, 3> kernels_{};
  std::size_t count_ = 0;
};

}  // namespace carom::core
