// A shape's support function behind the checks that every caller needs: what comes back is finite, bounded, or a fault.
#pragma once

#include <algorithm>

#include "collision/shape.h"

namespace carom::collision {

/// Farthest from its origin that a shape may reach. A hundred million metres keep every cube of a length, and the fifth
/// powers in an inertia, far from overflow; ten times that, and a support function is called unbounded.
inline constexpr Real kMaxReach = 1e9;  // m

/// By how much of the shape's extent a support point may fall short along its direction. A valid function in double
/// loses some ten u (our own plugins are held to that); one that iterates, or was written in a hurry, may lose another
/// six digits and still be a thousand times better than what the narrow phase is asked for (1e-6 of the size).
inline constexpr Real kSloppiness = 1e-9;

/// Support point of a shape's core.
/// @param d      [3] shape frame, nonzero, any length
/// @param out    [3] m, shape frame
/// @return       false if the function misbehaved; fault then holds what it did, bit for bit
inline bool core_support(const Shape& shape, const Vec3& d, Vec3& out, SupportFault& fault) {
  double got[3] = {0, 0, 0};
  const double asked[3] = {d.x(), d.y(), d.z()};
  const std::int32_t status = shape.support(shape.user, shape.params.data(), shape.params.size(), asked, got);
  out = Vec3(got[0], got[1], got[2]);
  if (status == 0 && std::fabs(got[0]) <= kMaxReach && std::fabs(got[1]) <= kMaxReach && std::fabs(got[2]) <= kMaxReach)
    return true;
  fault.kind = status != 0 ? SupportFault::returned : !finite(out) ? SupportFault::not_finite : SupportFault::outside;
  fault.shape = &shape;
  std::copy(asked, asked + 3, fault.dir);
  std::copy(got, got + 3, fault.out);
  return false;
}

/// Unit vector along d, whatever d's length: divided by its largest component before it is squared.
inline Vec3 direction_of(const Vec3& d) {
  const Vec3 scaled = d / d.abs().max_entry();
  return scaled / scaled.norm();
}

/// Support point of the whole shape: the core's, pushed out by the core radius.
inline bool full_support(const Shape& shape, const Vec3& d, Vec3& out, SupportFault& fault) {
  if (!core_support(shape, d, out, fault)) return false;
  if (shape.core_radius > 0) out += shape.core_radius * direction_of(d);
  return true;
}

}  // namespace carom::collision
