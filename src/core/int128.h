// Whole numbers of 128 bits: the compiler's, or our own where a machine of 32 bits has none.
#pragma once

#include <cstdint>

#include "core/layers.h"

namespace carom::core {

/// Two's complement: sums and products modulo 2^128.
/// @oracle  tests/unit/core/test_int128
class OwnInt128 {
 public:
  constexpr OwnInt128(std::int64_t n) : low_(static_cast<std::uint64_t>(n)), high_(n < 0 ? ~std::uint64_t(0) : 0) {}
  constexpr OwnInt128(std::uint64_t n) : low_(n), high_(0) {}
  constexpr OwnInt128(int n) : OwnInt128(static_cast<std::int64_t>(n)) {}
  constexpr explicit operator std::uint64_t() const { return low_; }

  friend constexpr OwnInt128 operator+(OwnInt128 a, OwnInt128 b) {
    const std::uint64_t low = a.low_ + b.low_;
    return {a.high_ + b.high_ + (low < a.low_), low};
  }
  friend constexpr OwnInt128 operator-(OwnInt128 a, OwnInt128 b) {
    return {a.high_ - b.high_ - (a.low_ < b.low_), a.low_ - b.low_};
  }
  friend constexpr OwnInt128 operator*(OwnInt128 a, OwnInt128 b) {
    constexpr std::uint64_t kHalf = 0xFFFFFFFFu;
    const std::uint64_t a0 = a.low_ & kHalf, a1 = a.low_ >> 32, b0 = b.low_ & kHalf, b1 = b.low_ >> 32;
    const std::uint64_t lowest = a0 * b0, one = a1 * b0 + (lowest >> 32), other = a0 * b1 + (one & kHalf);
    return {a.high_ * b.low_ + a.low_ * b.high_ + a1 * b1 + (one >> 32) + (other >> 32),
            other << 32 | (lowest & kHalf)};
  }
  /// @param bits  64
  friend constexpr OwnInt128 operator>>(OwnInt128 a, int) { return static_cast<std::int64_t>(a.high_); }
  constexpr OwnInt128& operator+=(OwnInt128 b) { return *this = *this + b; }
  friend constexpr bool operator==(OwnInt128 a, OwnInt128 b) { return a.high_ == b.high_ && a.low_ == b.low_; }
  friend constexpr bool operator<(OwnInt128 a, OwnInt128 b) {
    return a.high_ != b.high_ ? static_cast<std::int64_t>(a.high_) < static_cast<std::int64_t>(b.high_)
                              : a.low_ < b.low_;
  }
  friend constexpr bool operator>(OwnInt128 a, OwnInt128 b) { return b < a; }

 private:
  constexpr OwnInt128(std::uint64_t high, std::uint64_t low) : low_(low), high_(high) {}
  std::uint64_t low_, high_;
};

#if defined(__SIZEOF_INT128__)
__extension__ typedef __int128 Int128;
#else
using Int128 = OwnInt128;
#endif

}  // namespace carom::core
