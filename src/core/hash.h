// A 64-bit hash of bits, for comparing states: order matters, every bit counts, -0 and 0 differ.
#pragma once

#include <cstdint>
#include <cstring>

#include "core/layers.h"

namespace carom::core {

class Hash {
 public:
  void add(std::uint64_t word) {
    state_ ^= word;
    state_ *= 0x9E3779B97F4A7C15ull;
    state_ ^= state_ >> 29;
    state_ *= 0xBF58476D1CE4E5B9ull;
    state_ ^= state_ >> 32;
  }
  void add(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    add(bits);
  }
  template <class V>
  void add_coefficients(const V& v) {
    for (const auto x : v.at) add(static_cast<double>(x));
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xCA40CA40CA40CA40ull;
};

}  // namespace carom::core
