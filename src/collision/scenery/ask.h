// Questions to shapes of any kind: convex ones by cast/ and narrow/, scenery by the results of its triangles, put
// together. No other module need know that there are triangles.
//
// Which sides count: a ray passes through a one-sided surface from behind; so does a shape that moves, if its centre
// starts behind a triangle, as it would in a step. Overlap and distance know no sides.
#pragma once

#include "collision/cast/overlap.h"
#include "collision/cast/ray.h"
#include "collision/cast/time_of_impact.h"
#include "collision/scenery/triangle_shape.h"

namespace carom::collision {

namespace any_shape {
// As the functions of the same names outside, of shapes of which one may be scenery, the second one where there
// is a difference. Of two sceneries only overlap() knows what to say: they do not.
void cast_ray(const Ray& ray, const Shape& shape, const Frame& frame, const CastSettings& settings, CastResult& result,
              SupportFault& fault);
void cast_shape(const Shape& a, const Frame& frame_a, const Vec3& motion, const Shape& b, const Frame& frame_b,
                const CastSettings& settings, CastResult& result, SupportFault& fault);
void time_of_impact(const Shape& a, const RigidMotion& motion_a, const Shape& b, const RigidMotion& motion_b,
                    Real duration, const CastSettings& settings, CastResult& result, SupportFault& fault);
OverlapResult overlap(const Shape& a, const Shape& b, const Frame& b_in_a, Real target, Real rounding, int cap,
                      SupportFault& fault);
void distance(const Shape& a, const Shape& b, const Frame& b_in_a, const QuerySettings& settings, QueryMemory* memory,
              QueryResult& result, SupportFault& fault);
}  // namespace any_shape

/// The triangle that is met first.
void cast_ray_at_triangles(const Ray& ray, const Shape& scenery, const Frame& frame, const CastSettings& settings,
                           CastResult& result, SupportFault& fault);
void cast_shape_at_triangles(const Shape& a, const Frame& frame_a, const Vec3& motion, const Shape& scenery,
                             const Frame& frame, const CastSettings& settings, CastResult& result, SupportFault& fault);
void time_of_impact_at_triangles(const Shape& a, const RigidMotion& motion_a, const Shape& scenery,
                                 const RigidMotion& motion, Real duration, const CastSettings& settings,
                                 CastResult& result, SupportFault& fault);
/// Whether any triangle overlaps. @param scenery_in_a  pose of the scenery in A's frame
OverlapResult overlap_with_triangles(const Shape& a, const Shape& scenery, const Frame& scenery_in_a, Real target,
                                     Real rounding, int cap, SupportFault& fault);
/// The nearest triangle, of several that overlap the one that is deepest in.
void distance_to_triangles(const Shape& a, const Shape& scenery, const Frame& scenery_in_a,
                           const QuerySettings& settings, QueryResult& result, SupportFault& fault);

}  // namespace carom::collision
