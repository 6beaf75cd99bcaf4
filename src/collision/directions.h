// The directions in which a shape is questioned.
#pragma once

#include <array>

#include "core/trig.h"
#include "core/vec.h"

namespace carom::collision {

inline constexpr int kDirections = 256;

/// 26 directions of a cube's faces, edges and corners (zero components, ties), then 230 on a spiral from pole to pole
/// (nothing special about them). Unit, the same bits everywhere.
/// @accuracy  no direction is farther than 0.17 rad from one of them
inline std::array<Vec3, kDirections> asking_directions() {
  std::array<Vec3, kDirections> d;
  int n = 0;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k)
        if (i != 0 || j != 0 || k != 0) d[n++] = Vec3(i, j, k) / std::sqrt(Real(i * i + j * j + k * k));
  const int spiral = kDirections - n;
  for (int i = 0; i < spiral; ++i) {
    const Real z = 1 - (2 * i + 1) / Real(spiral), r = std::sqrt(1 - z * z);
    const SinCos turn = sin_cos(Real(2.39996322972865332) * i);  // the golden angle, rad
    d[n++] = Vec3(r * turn.cos, r * turn.sin, z);
  }
  return d;
}

}  // namespace carom::collision
