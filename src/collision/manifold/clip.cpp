// Clipping a convex polygon to a rectangle, one side after the other.
#include "collision/manifold/clip.h"

namespace carom::collision {
namespace {

/// Keep what lies at sign * (corner.*axis) <= half; a new corner's side along the cut is labelled `label`.
void cut(const Polygon& from, Polygon& to, Real Corner::*axis, Real sign, Real half, std::uint32_t label) {
  to.count = 0;
  for (int i = 0; i < from.count; ++i) {
    const Corner& p = from.corner[i];
    const Corner& q = from.corner[i + 1 < from.count ? i + 1 : 0];
    const Real over_p = sign * p.*axis - half, over_q = sign * q.*axis - half;
    const bool in_p = over_p <= 0, in_q = over_q <= 0;
    if (in_p && to.count < Polygon::kMax) to.corner[to.count++] = p;
    if (in_p == in_q || to.count == Polygon::kMax) continue;
    const Real f = over_p / (over_p - over_q);
    Corner& c = to.corner[to.count++];
    c = {p.x + f * (q.x - p.x), p.y + f * (q.y - p.y), p.z + f * (q.z - p.z), in_p ? label : p.side};
    c.*axis = sign * half;
  }
}

bool all_within(const Polygon& p, Real half_x, Real half_y) {
  bool within = true;
  for (int i = 0; i < p.count; ++i) within &= std::fabs(p.corner[i].x) <= half_x && std::fabs(p.corner[i].y) <= half_y;
  return within;
}

}  // namespace

void clip_to_rectangle(Polygon& polygon, Real half_x, Real half_y) {
  if (all_within(polygon, half_x, half_y)) return;
  Polygon other;
  cut(polygon, other, &Corner::x, 1, half_x, 4);
  cut(other, polygon, &Corner::x, -1, half_x, 5);
  cut(polygon, other, &Corner::y, 1, half_y, 6);
  cut(other, polygon, &Corner::y, -1, half_y, 7);
}

}  // namespace carom::collision
