// Linear shape cast: when a shape that moves along a straight line, without turning, first touches another.
#pragma once

#include "collision/cast/cast.h"

namespace carom::collision {

/// Cast shape A along a translation against B at rest. At most one of them may be a half-space.
/// @param motion    [3] m, of A relative to B; times are fractions of it, in [0, 1]
/// @param settings  target: contact is a separation of this
/// @param result    overlap: time 0, with depth, normal and points of the signed distance. @see CastOutcome: grazes,
///                  starts in touch
/// @accuracy        brackets hold, rounding included (kCastRounding)
/// @oracle          tests/unit/collision/cast/test_shape_cast
void cast_shape(const Shape& a, const Frame& frame_a, const Vec3& motion, const Shape& b, const Frame& frame_b,
                const CastSettings& settings, CastResult& result, SupportFault& fault);

}  // namespace carom::collision
