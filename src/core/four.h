// Four short numbers (float) at once: for bounds that only have to be right on the safe side, half the memory of
// doubles and one register of any x86-64.
#pragma once

#include <cstdint>

#include "core/layers.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace carom::core {

/// min and max as the processor has them: the second operand where either is not a number.
#if defined(__SSE2__)
class Four {
 public:
  explicit Four(const float* from) : v_(_mm_load_ps(from)) {}  // aligned to 16 bytes
  explicit Four(float all) : v_(_mm_set1_ps(all)) {}
  Four operator+(const Four& o) const { return Four(_mm_add_ps(v_, o.v_)); }
  Four operator-(const Four& o) const { return Four(_mm_sub_ps(v_, o.v_)); }
  Four operator*(const Four& o) const { return Four(_mm_mul_ps(v_, o.v_)); }
  Four min(const Four& o) const { return Four(_mm_min_ps(v_, o.v_)); }
  Four max(const Four& o) const { return Four(_mm_max_ps(v_, o.v_)); }
  /// A bit for each that is not larger, the lowest for the first.
  unsigned not_above(const Four& o) const { return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(v_, o.v_))); }
  void store(float* to) const { _mm_store_ps(to, v_); }

 private:
  explicit Four(__m128 v) : v_(v) {}
  __m128 v_;
};
#else
class Four {
 public:
  explicit Four(const float* from) : v_{from[0], from[1], from[2], from[3]} {}
  explicit Four(float all) : v_{all, all, all, all} {}
  Four operator+(const Four& o) const {
    return each(o, [](float a, float b) { return a + b; });
  }
  Four operator-(const Four& o) const {
    return each(o, [](float a, float b) { return a - b; });
  }
  Four operator*(const Four& o) const {
    return each(o, [](float a, float b) { return a * b; });
  }
  Four min(const Four& o) const {
    return each(o, [](float a, float b) { return a < b ? a : b; });
  }
  Four max(const Four& o) const {
    return each(o, [](float a, float b) { return a > b ? a : b; });
  }
  unsigned not_above(const Four& o) const {
    unsigned bits = 0;
    for (unsigned i = 0; i < 4; ++i) bits |= unsigned(v_[i] <= o.v_[i]) << i;
    return bits;
  }
  void store(float* to) const {
    for (int i = 0; i < 4; ++i) to[i] = v_[i];
  }

 private:
  template <class Op>
  Four each(const Four& o, Op op) const {
    Four r(0.0f);
    for (int i = 0; i < 4; ++i) r.v_[i] = op(v_[i], o.v_[i]);
    return r;
  }
  float v_[4];
};
#endif

}  // namespace carom::core
