// The floating-point environment: results must not depend on what the host or a plugin's loader left in it.
#pragma once

#include <cfenv>
#include <limits>

#include "core/layers.h"

namespace carom::core {

/// Round to nearest, denormals kept (a plugin built with -Ofast sets flush-to-zero on the thread that loads it), no
/// traps: from here to the end of the scope. The host's environment, sticky flags included, comes back after.
class FloatScope {
 public:
  FloatScope() {
    std::fegetenv(&saved_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~FloatScope() { std::fesetenv(&saved_); }
  FloatScope(const FloatScope&) = delete;
  FloatScope& operator=(const FloatScope&) = delete;

 private:
  std::fenv_t saved_;
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
