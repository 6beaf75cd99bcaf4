// Colours of rows: those of one colour, joints and contacts, share no body that an impulse moves, so that a sweep can
// do them side by side and on several threads. Joints and contacts have them of one numbering. Joints take the lowest
// that are free and keep them from step to step; contacts come and go, and take the highest. So contacts have the last
// word in a sweep, unless a body has so many of both that they meet.
#pragma once

#include <bit>

#include "core/memory.h"

namespace carom::dynamics {

/// Rows beyond this many colours are solved one at a time: a body with so many movable neighbours is rare.
inline constexpr std::uint32_t kColours = 64;

/// Which colours the two bodies of a row have between them; a body that is not moved has none.
class BothColours {
 public:
  /// @param taken  by solver body, bit c: it has colour c
  BothColours(std::uint64_t* taken, bool moves_a, std::uint32_t a, bool moves_b, std::uint32_t b)
      : a_(moves_a ? &taken[a] : nullptr), b_(moves_b ? &taken[b] : nullptr) {}

  /// A free colour, which both have from now on; kColours: none is left.
  std::uint32_t take_lowest() { return take(static_cast<std::uint32_t>(std::countr_one(both()))); }
  std::uint32_t take_highest() {
    const auto nth = static_cast<std::uint32_t>(std::countl_one(both()));
    return take(nth < kColours ? kColours - 1 - nth : kColours);
  }
  std::uint32_t take(std::uint32_t colour) {
    if (colour == kColours) return colour;
    const std::uint64_t bit = std::uint64_t{1} << colour;
    if (a_) *a_ |= bit;
    if (b_) *b_ |= bit;
    return colour;
  }

 private:
  std::uint64_t both() const { return (a_ ? *a_ : 0) | (b_ ? *b_ : 0); }

  std::uint64_t *a_, *b_;
};

}  // namespace carom::dynamics
