// Ray cast: where a half-line or segment first meets a shape.
#pragma once

#include <span>

#include "collision/cast/cast.h"

namespace carom::collision {

/// The points origin + t direction, 0 <= t <= max. A direction of zero asks whether the origin is in the shape.
struct Ray {
  Vec3 origin = Vec3::zero();     // m
  Vec3 direction = Vec3::zero();  // m per unit of t, any length
  Real max = 1;                   // >= 0, may be infinite
};

/// Cast a ray against a shape. settings.target makes it a ball of that radius.
/// @param frame   shape -> the frame of the ray
/// @param result  times as fractions of direction; normal points into the shape, opposed to the surface's own. A start
///                inside is an overlap at time 0, its normal along the ray. @see CastOutcome: grazes, starts in touch
/// @param fault   filled when the support function misbehaves; result.status is then fault
/// @accuracy      brackets hold, rounding included (kCastRounding)
/// @oracle        tests/unit/collision/cast/test_ray
void cast_ray(const Ray& ray, const Shape& shape, const Frame& frame, const CastSettings& settings, CastResult& result,
              SupportFault& fault);

/// A shape where it stands.
struct Placed {
  const Shape* shape = nullptr;
  Frame frame;  // shape -> the frame of the rays
};

/// The first of several shapes that a ray meets, each asked as if it were alone.
/// @param result  of the shape met first (by the estimate `time`; ties: the first in the list); a miss if none is met
/// @return        its index in the list, or -1
/// @param fault   of the first support function that misbehaved: result.status is then fault, the index says whose
int cast_ray(const Ray& ray, std::span<const Placed> shapes, const CastSettings& settings, CastResult& result,
             SupportFault& fault);

}  // namespace carom::collision
