// A logarithm of our own: the C library's differ in the last bit between versions.
#pragma once

#include <limits>

#include "core/vec.h"

namespace carom::core {

/// ln x with the same bits on every platform.
/// @param x   > 0; infinity gives infinity
/// @accuracy  |error| < 2 ulp
/// @source    x = 2^k m with m in [sqrt(1/2), sqrt 2); ln m = 2 artanh f, f = (m - 1) / (m + 1), by 11 terms of its
///            series: |f| < 0.172, so the remainder is below 1e-18 of it
/// @oracle    tests/unit/core/test_logarithm
inline Real logarithm(Real x) {
  constexpr Real kRootHalf = 0.70710678118654752440;
  constexpr Real kLnTwoHigh = 0x1.62e42fefa38p-1;   // 41 bits of ln 2: times k is exact
  constexpr Real kLnTwoLow = 0x1.ef35793c7673p-45;  // the rest
  if (!(x <= std::numeric_limits<Real>::max())) return x;
  int k = 0;
  Real m = std::frexp(x, &k);
  if (m < kRootHalf) m *= 2, --k;
  const Real over = m - 1, f = over / (m + 1), z = f * f;
  Real series = 0;
  for (int n = 21; n >= 3; n -= 2) series = z * (Real(1) / n + series);
  // 2 f = over - f over, where over is exact: so little of it is lost near 1.
  return k * kLnTwoHigh + (over - (f * (over - 2 * series) - k * kLnTwoLow));
}

}  // namespace carom::core
