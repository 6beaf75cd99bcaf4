// Angles from sides, of our own: the C library's differ in the last bit between versions, and a step must not. For one
// number or for lanes of them.
#pragma once

#include "core/wide.h"

namespace carom::core {

CAROM_LANES_INLINE double square_root(double a) { return __builtin_sqrt(a); }

/// The angle of the point (x, y) from the x axis, in (-pi, pi].
/// @param y, x   finite, |x| and |y| within [1e-150, 1e150] or 0; both 0: the angle is 0
/// @accuracy     |error| < 1e-15 rad
/// @source       three halvings, tan(a/2) = tan a / (1 + sqrt(1 + tan^2 a)), then Taylor on [0, 0.199]: remainder
///               below 1e-18
/// @oracle       tests/unit/core/test_wide_angle
template <class Number>
CAROM_LANES_INLINE Number angle_of(Number y, Number x) {
  const Number none{}, abs_x = x < 0 ? -x : x, abs_y = y < 0 ? -y : y;
  const Number side = square_root(x * x + y * y) + abs_x;
  const auto there = side > 0;
  const Number t1 = abs_y / (there ? side : none + 1);  // of half the angle from the nearer end of the x axis
  const Number t2 = t1 / (1 + square_root(1 + t1 * t1)), t3 = t2 / (1 + square_root(1 + t2 * t2));
  const Number z = t3 * t3;
  Number s = none + 1.0 / 23;
  for (int n = 21; n >= 1; n -= 2) s = 1.0 / n - z * s;
  const Number a = 8 * (t3 * s), all_of_it = x < 0 ? 3.14159265358979323846 - a : a;
  return y < 0 ? -all_of_it : all_of_it;
}

}  // namespace carom::core
