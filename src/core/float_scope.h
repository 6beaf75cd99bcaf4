// The floating-point environment: results must not depend on what the host or a plugin's loader left in it.
#pragma once

#include <cfenv>
#include <cstdint>
#include <limits>

#include "core/layers.h"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace carom::core {

/// Round to nearest, denormals kept (a plugin built with -Ofast sets flush-to-zero on the thread that loads it), no
/// traps: from here to the end of the scope. The host's environment, sticky flags included, comes back after.
class FloatScope {
 public:
#if defined(__SSE2__)  // nothing here has x87 arithmetic, whose whole environment takes as long as a small call
  FloatScope() : saved_(_mm_getcsr()), saved_x87_(x87()) {
    _mm_setcsr(kDefault);
    set_x87(kDefaultX87);
  }
  ~FloatScope() {
    _mm_setcsr(saved_);
    set_x87(saved_x87_);
  }

 private:
  static constexpr std::uint32_t kDefault = 0x1F80;
  static constexpr std::uint16_t kDefaultX87 = 0x37F;  // fesetround() writes, and fegetround() reads, this one
  static std::uint16_t x87() {
    std::uint16_t word;
    asm volatile("fnstcw %0" : "=m"(word));
    return word;
  }
  static void set_x87(std::uint16_t word) {
    if (x87() != word) asm volatile("fldcw %0" : : "m"(word));
  }
  std::uint32_t saved_;
  std::uint16_t saved_x87_;
#else
  FloatScope() {
    std::fegetenv(&saved_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~FloatScope() { std::fesetenv(&saved_); }

 private:
  std::fenv_t saved_;
#endif
 public:
  FloatScope(const FloatScope&) = delete;
  FloatScope& operator=(const FloatScope&) = delete;
};

/// Whether arithmetic is still that of a FloatScope: rounds to nearest and keeps denormals. Asked after code of a
/// plugin ran.
inline bool float_environment_is_default() {
  volatile double smallest_normal = std::numeric_limits<double>::min();
  volatile double denormal = smallest_normal / 2;  // 0 if results are flushed
  volatile double back = denormal * 2;             // 0 if inputs are taken for zero
  return std::fegetround() == FE_TONEAREST && denormal != 0 && back == smallest_normal;
}

}  // namespace carom::core
