// A product and a sum rounded once, of our own: some C libraries round std::fma() twice, and a step must not depend on
// whose it is.
#pragma once

#include <bit>
#include <cfloat>
#include <cstdint>

#include "core/vec.h"

namespace carom::core {

static_assert(FLT_EVAL_METHOD == 0,
              "a double is rounded after each operation: errors of rounding are computed from that");

/// A sum or a product as two numbers: rounded, and what rounding took.
struct Exact {
  Real value, lost;
};

/// @source [Knuth1997 §4.2.2]
inline Exact exact_sum(Real a, Real b) {
  const Real sum = a + b, of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// @param a, b  |a|, |b| < 2^995, |a b| in [2^-915, 2^1000], so that no part overflows or is lost
/// @source      each factor in two halves, whose products need no rounding [Dekker1971]
inline Exact exact_product(Real a, Real b) {
  constexpr Real kSplit = 0x1p27 + 1;
  const Real big_a = kSplit * a, high_a = big_a - (big_a - a), low_a = a - high_a;
  const Real big_b = kSplit * b, high_b = big_b - (big_b - b), low_b = b - high_b;
  const Real product = a * b;
  return {product, ((high_a * high_b - product) + high_a * low_b + low_a * high_b) + low_a * low_b};
}

/// a + b, but where that is no double, of its two neighbours the one whose last bit is 1: what is added to it later is
/// rounded as if nothing had been rounded here.
inline Real odd_sum(Real a, Real b) {
  const Exact sum = exact_sum(a, b);
  const auto bits = std::bit_cast<std::uint64_t>(sum.value);
  if (sum.lost == 0 || bits & 1) return sum.value;
  return std::bit_cast<Real>((sum.lost > 0) == (sum.value > 0) ? bits + 1 : bits - 1);
}

/// Whether exact_product() holds, and what is added does not overflow either.
inline bool splits(Real a, Real b, Real c) {
  constexpr Real kLeast = 0x1p-915, kMost = 0x1p995;
  const Real product = std::fabs(a * b);
  return product >= kLeast && product < kMost && std::fabs(a) < kMost && std::fabs(b) < kMost && std::fabs(c) < kMost;
}

/// a b + c.
/// @accuracy  rounded once where |a b| is in [2^-915, 2^995) and |a|, |b|, |c| < 2^995; beyond, the product is rounded, too
/// @source    [Boldo2008]
/// @oracle    tests/unit/core/test_multiply_add
inline Real multiply_add(Real a, Real b, Real c) {
  if (!splits(a, b, c)) return a * b + c;
  const Exact product = exact_product(a, b);
  const Exact low = exact_sum(c, product.lost);
  const Exact high = exact_sum(product.value, low.value);
  return high.value + odd_sum(low.lost, high.lost);
}

}  // namespace carom::core
