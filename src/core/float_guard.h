// Arithmetic that a plugin's code must not change for those who come after it.
#pragma once

#include "core/layers.h"

#if defined(__SSE2__)
#include <xmmintrin.h>

#include <cstdint>
#else
#include <cfenv>
#endif

namespace carom::core {

/// Puts rounding, flush-to-zero and the masks back as they were at its start, at the end of its scope, if somebody has
/// changed them: a support function that was valid about it when it was loaded and no longer is. One read of a
/// register if not.
class FloatGuard {
 public:
#if defined(__SSE2__)  // a step has no x87 arithmetic
  FloatGuard() : mode_(_mm_getcsr()) {}
  ~FloatGuard() { put_back(); }
  void put_back() const {
    constexpr std::uint32_t kFlags = 0x3F;  // what happened, not what is to be done: nothing reads them
    if ((_mm_getcsr() ^ mode_) & ~kFlags) _mm_setcsr(mode_);
  }

 private:
  std::uint32_t mode_;
#else
  FloatGuard() : mode_(std::fegetround()) {}
  ~FloatGuard() { put_back(); }
  void put_back() const {
    if (std::fegetround() != mode_) std::fesetround(mode_);
  }

 private:
  int mode_;
#endif
 public:
  FloatGuard(const FloatGuard&) = delete;
  FloatGuard& operator=(const FloatGuard&) = delete;
};

}  // namespace carom::core
