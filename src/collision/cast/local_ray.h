// A ray as the shape sees it: what the generic walk and the routines for closed forms start from.
#pragma once

#include "collision/cast/ray.h"
#include "collision/cast/rounding.h"

namespace carom::collision {

struct LocalRay {
  Vec3 o, u;             // m; unit
  Real speed;            // m per unit of t
  Real start, stop;      // m along u from the foot of the shape's origin
  Real size, rounding, reach;  // m

  LocalRay(const Ray& ray, const Shape& shape, const Frame& frame, Real target) {
    o = frame.apply_inverse(ray.origin);
    const Vec3 d = frame.rotate_inverse(ray.direction);
    const Real largest = d.abs().max_entry();
    const Vec3 scaled = largest > 0 ? Vec3(d / largest) : Vec3(Vec3::unit_x());
    const Real length = scaled.norm();
    u = scaled / length;
    speed = largest * length;
    start = u.dot(o);
    stop = speed > 0 ? start + speed * ray.max : start;
    size = o.norm() + shape.bounding_radius + target;
    rounding = kUnitRoundoff * (kCastRounding * size + kPlaceRounding * (frame.p.norm() + ray.origin.norm()));
    reach = (1 + 1e-6) * (shape.bounding_radius + target) + rounding;
  }
};

/// Nothing is met within the ray.
inline void miss(const Ray& ray, CastResult& result) {
  result.outcome = CastOutcome::miss;
  result.time = result.lower = ray.max;
  result.upper = kInfinity;
}

/// Cast a ray against a sphere, capsule, box, cylinder, cone or ellipsoid in closed form: the same result as by support
/// functions, within both brackets.
/// @param r       speed, reach finite
/// @return        false where there is no routine (other forms, what a target swells to no form, what is as thin as
///                rounding, no motion, a line nearly along a surface): result is untouched then
/// @accuracy      the bracket is of the shape swollen and shrunk by r.rounding: as wide as rounding leaves it
/// @oracle        tests/unit/collision/cast/test_ray_forms
bool cast_at_form(const Ray& ray, const Shape& shape, const Frame& frame, const LocalRay& r,
                  const CastSettings& settings, CastResult& result);

}  // namespace carom::collision
