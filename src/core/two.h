// Two real numbers at once, for comparisons whose outcome is a coin toss and must not become a branch.
#pragma once

#include "core/vec.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace carom::core {

/// A pair of numbers and what comes of comparing two such pairs, in the words of the processor where it has some.
#if defined(__SSE2__)
class Two {
 public:
  explicit Two(const Real* from) : pair_(_mm_loadu_pd(from)) {}
  Two(Real first, Real second) : pair_(_mm_setr_pd(first, second)) {}
  Two operator<=(const Two& o) const { return Two(_mm_cmple_pd(pair_, o.pair_)); }
  Two operator&(const Two& o) const { return Two(_mm_and_pd(pair_, o.pair_)); }
  /// Of what comparisons gave: were they both true?
  bool both() const { return bits() == 3; }
  /// A bit for each that was true, the lowest for the first.
  unsigned bits() const { return static_cast<unsigned>(_mm_movemask_pd(pair_)); }

 private:
  explicit Two(__m128d pair) : pair_(pair) {}
  __m128d pair_;
};
#else
class Two {
 public:
  explicit Two(const Real* from) : first_(from[0]), second_(from[1]) {}
  Two(Real first, Real second) : first_(first), second_(second) {}
  struct Outcome {
    bool first, second;
    Outcome operator&(const Outcome& o) const { return {bool(first & o.first), bool(second & o.second)}; }
    bool both() const { return first & second; }
    unsigned bits() const { return static_cast<unsigned>(first) | static_cast<unsigned>(second) << 1; }
  };
  Outcome operator<=(const Two& o) const { return {first_ <= o.first_, second_ <= o.second_}; }

 private:
  Real first_, second_;
};
#endif

}  // namespace carom::core
