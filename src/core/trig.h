// Sine and cosine of our own: the C library's differ in the last bit between versions, and a step must not.
#pragma once

#include "core/vec.h"

namespace carom::core {

struct SinCos {
  Real sin, cos;
};

/// sin x and cos x with the same bits on every platform.
/// @param x   rad, finite
/// @accuracy  |error| < 2e-16 for |x| <= 1e5; argument reduction (two-term Cody-Waite) loses ~u|x| beyond.
///            |x| > 1e9 is reduced by fmod first, where a phase has no meaning left in double anyway.
/// @source    Taylor kernels on [-pi/4, pi/4], 8 and 9 terms; remainder below 1e-17
/// @oracle    tests/unit/core/test_trig
inline SinCos sin_cos(Real x) {
  constexpr Real kTwoOverPi = 0.63661977236758134308;
  constexpr Real kHalfPiHigh = 1.57079632673412561417e+00;  // first 33 bits of pi/2: k * high is exact for |k| < 2^20
  constexpr Real kHalfPiMid = 6.07710050630396597660e-11;   // next 33 bits
  constexpr Real kHalfPiLow = 2.02226624879595063154e-21;   // the rest
  if (!(std::fabs(x) <= 1e9)) x = std::fmod(x, 6.28318530717958647693);
  const Real k = std::floor(x * kTwoOverPi + Real(0.5));
  const Real r = ((x - k * kHalfPiHigh) - k * kHalfPiMid) - k * kHalfPiLow;
  const Real z = r * r;
  const Real s =
      r + r * z *
              (-1.0 / 6 +
               z * (1.0 / 120 + z * (-1.0 / 5040 +
                                     z * (1.0 / 362880 + z * (-1.0 / 39916800 + z * (1.0 / 6227020800.0 +
                                                                                     z * (-1.0 / 1307674368000.0 +
                                                                                          z / 355687428096000.0)))))));
  const Real c =
      1 -
      z * (0.5 - z * (1.0 / 24 - z * (1.0 / 720 - z * (1.0 / 40320 - z * (1.0 / 3628800 -
                                                                          z * (1.0 / 479001600.0 -
                                                                               z * (1.0 / 87178291200.0 -
                                                                                    z * (1.0 / 20922789888000.0 -
                                                                                         z / 6402373705728000.0))))))));
  // What is no number stays none; as an integer it would be anything.
  switch (std::fabs(k) < 0x1p62 ? static_cast<std::int64_t>(k) & 3 : 0) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

}  // namespace carom::core
