// What of a shape stands over a triangle or under it, against the triangle's plane as against a half-space; and a shape
// whose middle is in the ground.
#include <algorithm>

#include "collision/narrow/pair.h"
#include "collision/scenery/meet.h"
#include "collision/support.h"

namespace carom::collision {

/// Which side of a height field the shape's centre is on.
/// @param under  the triangle that stands over or under it, if the result is not none
SceneryPairFinder::Ground SceneryPairFinder::look_down(const Terms& t, Triangle& under) const {
  if (!t.pair.scenery.scenery->triangle_over(t.centre, under)) return Ground::none;
  const Real height = under.normal.dot(t.centre - under.corner[0]);
  // No shape that is pushed out gets its middle deeper than it is large: what is there came from elsewhere.
  if (height < -t.pair.convex.bounding_radius) return Ground::none;
  return height < 0 ? Ground::below : Ground::above;
}

bool SceneryPairFinder::has_routine(const Terms& t) {
  return t.settings.query.routines && pair_entry(Form::half_space, t.pair.convex.form).routine;
}

/// Points of an undeclared shape that lie nearer than this to one of a patch are places on a round side beside it. They
/// would hold up what rolls; the other end of what leans is farther.   @param apart  m
void SceneryPairFinder::drop_round_sides(Real apart) {
  const auto is_beside = [&](const Found& f) {
    const auto near = [&](const Found& g) {
      return !g.is_asked_for && (f.point.on_b - g.point.on_b).squared_norm() < apart * apart;
    };
    return f.is_asked_for && std::any_of(found_.begin(), found_.end(), near);
  };
  std::size_t kept = 0;  // those of patches are all kept: in front of i or behind it
  for (std::size_t i = 0; i < found_.size(); ++i)
    if (!is_beside(found_[i])) found_[kept++] = found_[i];
  while (found_.size() > kept) found_.pop_back();
}

/// Find the points of the shape that matter beside the plane of a triangle, @see pair_half_space.cpp.
/// @return  false if the support function misbehaved
bool SceneryPairFinder::stand(const Terms& t, const Triangle& triangle) {
  const Shape& convex = t.pair.convex;
  plane_.normal = triangle.normal, plane_.offset = triangle.normal.dot(triangle.corner[0]);
  standing_.count = 0;
  if (has_routine(t))
    pair_entry(Form::half_space, convex.form).routine(plane_, convex, t.convex_in_scenery, t.reach, standing_);
  else if (!half_space_by_support(plane_, convex, t.convex_in_scenery, t.reach, true, leaning_tilt(convex, t.reach),
                                  standing_, t.report.support_calls, t.fault))
    return false;
  for (int i = 0; i < standing_.count; ++i) standing_.point[i].normal = t.pair.frame.rotate(triangle.normal);
  return true;
}

/// A shape whose middle is in the ground is pushed out of it along the normal of the triangle above.
/// @param triangle  that stands over its centre
bool SceneryPairFinder::lift(const Terms& t, const Triangle& triangle) {
  ++t.report.support_calls;
  PatchPoints one;
  ContactPoint& p = one.point[0];
  p = {};
  if (!full_support(t.pair.convex, -t.convex_in_scenery.rotate_inverse(triangle.normal), p.on_b, t.fault)) return false;
  const Vec3 foot = t.convex_in_scenery.apply(p.on_b);
  p.separation = triangle.normal.dot(foot - triangle.corner[0]);
  p.on_a = foot - p.separation * triangle.normal;
  p.normal = t.pair.frame.rotate(triangle.normal);
  one.count = 1;
  add(one, Vec3::zero(), false, t.reach);
  return true;
}

}  // namespace carom::collision
