// A string of bytes read as choices and numbers.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace carom::fuzz {

class Bytes {
 public:
  Bytes(const std::uint8_t* at, std::size_t size) : at_(at), end_(at + size) {}

  unsigned byte() { return at_ < end_ ? *at_++ : 0; }
  int below(int n) { return static_cast<int>(byte()) % n; }
  bool one_in(int n) { return below(n) == n - 1; }
  /// Uniform in [0, 1), 24 bits.
  double unit() {
    const unsigned high = byte(), middle = byte(), low = byte();
    return (high << 16 | middle << 8 | low) * 0x1p-24;
  }
  /// Uniform in [-1, 1), 16 bits.
  double both_signs() {
    const unsigned high = byte(), low = byte();
    return static_cast<int>((high << 8 | low) - 32768) * 0x1p-15;
  }
  /// A power of two times [1, 2), exponents from lo to hi - 1.
  double any_order(int lo, int hi) {
    const int exponent = lo + below(hi - lo);
    return std::ldexp(1 + byte() * 0x1p-8, exponent);
  }

 private:
  const std::uint8_t *at_, *end_;
};

}  // namespace carom::fuzz
