// Planes of the triangles around a new point of EPA's polytope, a few at a time.
#pragma once

#include <algorithm>

#include "core/vec.h"

namespace carom::collision {

/// Vertices around a hole, side by side.
/// @tparam kMost  how many there may be; a few more places are for the lanes that have nothing to do
template <int kMost>
struct Horizon {
  static constexpr int kSlots = kMost + 6;
  Real x[kSlots], y[kSlots], z[kSlots];  // scaled lengths

  void set(int i, const Vec3& w) {
    x[i] = w.x();
    y[i] = w.y();
    z[i] = w.z();
  }
};

/// Six triangles (horizon[i], horizon[i + 1], apex), side by side so that a compiler takes them lanes at a time: each
/// number comes from the same operations in the same order, whatever the width.
struct Fan {
  static constexpr int kFaces = 6;

  Real nx[kFaces], ny[kFaces], nz[kFaces];  // [6] (horizon[i] - apex) x (horizon[i + 1] - apex), shortened to 1
  Real offset[kFaces];                      // [6] smallest of normal . vertex
  Real clear[kFaces];                       // [6] > 0: the angle at the apex is wide, the triangle no line

  /// @param x, y, z   [7] the horizon, scaled lengths
  /// @param wide2     square of the sine of a wide angle
  /// @param rounding  scaled length: below this, a height is none
  /// @accuracy        normals of clear triangles err by u / sine; offsets are proofs whatever the normal (Polytope)
  void unfold(const Real* x, const Real* y, const Real* z, const Vec3& apex, Real wide2, Real rounding) {
    const Real ax = apex.x(), ay = apex.y(), az = apex.z(), least2 = rounding * rounding;
    Real ex[kFaces + 1], ey[kFaces + 1], ez[kFaces + 1], length2[kFaces + 1];
    for (int i = 0; i <= kFaces; ++i) {
      ex[i] = x[i] - ax;
      ey[i] = y[i] - ay;
      ez[i] = z[i] - az;
      length2[i] = ex[i] * ex[i] + ey[i] * ey[i] + ez[i] * ez[i];
    }
    for (int i = 0; i < kFaces; ++i) {
      nx[i] = ey[i] * ez[i + 1] - ez[i] * ey[i + 1];
      ny[i] = ez[i] * ex[i + 1] - ex[i] * ez[i + 1];
      nz[i] = ex[i] * ey[i + 1] - ey[i] * ex[i + 1];
      const Real n2 = nx[i] * nx[i] + ny[i] * ny[i] + nz[i] * nz[i];
      // Twice the area over the longest edge, which is below sqrt(2 (a2 + b2)), is the height.
      const Real a2 = length2[i], b2 = length2[i + 1];
      clear[i] = n2 - std::max(wide2 * (a2 * b2), least2 * (a2 + b2));
      const Real scale = 1 / std::sqrt(n2);
      nx[i] *= scale;
      ny[i] *= scale;
      nz[i] *= scale;
      const Real at_apex = nx[i] * ax + ny[i] * ay + nz[i] * az, at_a = nx[i] * x[i] + ny[i] * y[i] + nz[i] * z[i],
                 at_b = nx[i] * x[i + 1] + ny[i] * y[i + 1] + nz[i] * z[i + 1];
      offset[i] = std::min(std::min(at_a, at_b), at_apex);
    }
  }
};

}  // namespace carom::collision
