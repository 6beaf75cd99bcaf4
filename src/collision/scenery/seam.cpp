// One support call tells whether a ground's face stands out above its neighbour, a query whether the neighbour covers
// the place.
#include "collision/scenery/seam.h"

#include <algorithm>

#include "collision/narrow/rounding.h"
#include "collision/scenery/scenery.h"
#include "collision/support.h"

namespace carom::collision {
namespace {

constexpr Real kSameNormal2 = 1e-12;  // rad^2: directions are one
// A face that looks along the normal within this share of how far it leans to the neighbour's side is that of the
// contact.
constexpr Real kLean = 0.05;
// Cosine: a contact that pushes more sideways than this, against what stands out nowhere, bars the way along the
// ground.
constexpr Real kSideways = 0.7;
// Of a body's size: how far below a surface of triangles a place is still covered by it.
constexpr Real kBelow = 0.05;

/// Call f(triangle) for triangles that have a place, until it says yes.
template <class F>
bool any_triangle_at(const Scenery& scenery, const Vec3& place, Real above, Real below, F&& f) {
  Aabb box;
  const Vec3 all = Vec3::constant(std::max(above, below));
  box.lo = place - all, box.hi = place + all;
  bool found = false;
  scenery.each_near(box, [&](std::uint32_t index) {
    Triangle t;
    if (found || !scenery.triangle(index, t)) return;
    const Real height = t.normal.dot(place - t.corner[0]);
    if (scenery.two_sided ? std::fabs(height) > std::max(above, below) : height > above || height < -below) return;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 out = (t.corner[(i + 1) % 3] - t.corner[i]).normalized().cross(t.normal);
      if (out.dot(place - t.corner[i]) > above) return;
    }
    found = f(t);
  });
  return found;
}

/// m, world: the ground's farthest point along a direction; of scenery, of the triangles at the place.
/// @return  false: there is none
bool farthest(const Ground& ground, const Vec3& place, const Vec3& along, const SeamTerms& terms, Vec3& out) {
  const Vec3 d = ground.frame.rotate_inverse(along);
  if (!is_scenery(ground.shape)) {
    SupportFault fault;
    if (ground.shape.form == Form::half_space || !full_support(ground.shape, d, out, fault)) return false;
    out = ground.frame.apply(out);
    return true;
  }
  const Vec3 x = ground.frame.apply_inverse(place);
  Real most = -kInfinity;
  any_triangle_at(*ground.shape.scenery, x, terms.flush, terms.flush, [&](const Triangle& t) {
    for (const Vec3& corner : t.corner)
      if (d.dot(corner) > most) most = d.dot(corner), out = corner;
    return false;
  });
  if (!(most > -kInfinity)) return false;
  out = ground.frame.apply(out);
  return true;
}

/// Whether the face that a contact pushes from stands out above the neighbour, as far as it matters.
bool stands_out(const Ground& of, const GroundTouch& touch, const GroundTouch& plane, const SeamTerms& terms) {
  // What would push the body into the neighbour bars the way along it, as far as it bars any: a wall that stands on a
  // floor does so where an edge has sunk in to below its foot.
  const Real into = std::min(touch.normal.dot(plane.normal), Real(0));
  Vec3 far;
  if (!farthest(of, touch.point, touch.normal + (kLean - into) * plane.normal, terms, far)) return true;
  const Vec3 along = far - touch.point;
  const Real length = along.norm(), share = length > terms.size ? terms.size / length : 1;
  return plane.normal.dot(touch.point + share * along - plane.point) > terms.flush;
}

/// Whether a ground holds a place.
bool holds(const Ground& ground, const Vec3& place, const SeamTerms& terms) {
  const Vec3 x = ground.frame.apply_inverse(place);
  if (ground.shape.form == Form::half_space) return ground.shape.normal.dot(x) <= ground.shape.offset + terms.flush;
  if (is_scenery(ground.shape))
    return any_triangle_at(*ground.shape.scenery, x, terms.flush, kBelow * terms.size,
                           [](const Triangle&) { return true; });
  SupportFault fault;
  const OverlapResult result =
      overlap_with_point(ground.shape, x, terms.flush, kPoseRounding * kUnitRoundoff, terms.cap, fault);
  return result.outcome == Overlap::overlapping || result.outcome == Overlap::touching;
}

/// Whether a ground that holds a place goes on beyond a plane through it.
bool goes_beyond(const Ground& ground, const GroundTouch& plane, const SeamTerms& terms) {
  if (ground.shape.form == Form::half_space) return true;
  if (is_scenery(ground.shape)) {
    const Vec3 x = ground.frame.apply_inverse(plane.point), n = ground.frame.rotate_inverse(plane.normal);
    return any_triangle_at(*ground.shape.scenery, x, terms.flush, kBelow * terms.size, [&](const Triangle& t) {
      return std::any_of(t.corner.begin(), t.corner.end(), [&](const Vec3& c) { return n.dot(c - x) > terms.flush; });
    });
  }
  Vec3 far;
  return farthest(ground, plane.point, plane.normal, terms, far) && plane.normal.dot(far - plane.point) > terms.flush;
}

}  // namespace

Beside compare(const Ground& of, const GroundTouch& touch, const GroundTouch& plane, const SeamTerms& terms) {
  if ((touch.normal - plane.normal).squared_norm() <= kSameNormal2 || stands_out(of, touch, plane, terms))
    return Beside::real;
  const bool is_below = plane.normal.dot(touch.point - plane.point) <= terms.flush;
  return is_below && touch.normal.dot(plane.normal) < kSideways ? Beside::ghost : Beside::level;
}

bool covers(const Ground& neighbour, const GroundTouch& touch, const SeamTerms& terms) {
  return goes_beyond(neighbour, touch, terms) && holds(neighbour, touch.point, terms);
}

}  // namespace carom::collision
