// Capsule against capsule: the distance of two segments, and a second point where they lie side by side.
#include <algorithm>

#include "collision/narrow/pair.h"

namespace carom::collision {
namespace {

// Two axes that enclose less than this (squared sine; 3 degrees) rest on each other along a line rather than at a
// point.
constexpr Real kSideBySide2 = 2.5e-3;

/// Where the two axes come nearest: A's at height s, B's at height v.
struct NearestOfSegments {
  Real s, v;
};

/// NearestOfSegments points of two segments, A's along y through the origin, B's along unit e through t.
///   minimise |t + v e - s y|^2:  s = (t . w) / |w|^2 with w = y - (y . e) e, then v, then s again, each clamped.
/// w is written without the difference 1 - (y . e)^2, so its length keeps its digits however small the angle is, and an
/// error of s moves the distance only in second order.
/// @source [Ericson2005 §5.1.9]
NearestOfSegments nearest_on_axes(const Vec3& t, const Vec3& e, Real half_a, Real half_b, Real sine2) {
  const Real b = e.y(), t_e = t.dot(e);
  Real s;
  if (sine2 > 0) {
    s = std::clamp((-b * (t.x() * e.x() + t.z() * e.z()) + sine2 * t.y()) / sine2, -half_a, half_a);
  } else {
    s = std::clamp(t.y() - half_b, -half_a, half_a);  // parallel: where B's range begins
  }
  const Real v = std::clamp(s * b - t_e, -half_b, half_b);
  return {std::clamp(t.y() + v * b, -half_a, half_a), v};
}

}  // namespace

void contact_capsule_capsule(const Shape& a, const Shape& b, const Frame& b_in_a, Real reach, Candidates& found) {
  const Vec3 e = b_in_a.r.col(1);
  const Vec3& t = b_in_a.p;
  const Real radii = a.radius + b.radius;
  const Real sine2 = e.x() * e.x() + e.z() * e.z();
  const NearestOfSegments n = nearest_on_axes(t, e, a.half_height, b.half_height, sine2);
  const Vec3 out = t + n.v * e - n.s * Vec3::unit_y();
  const Real gap = out.norm();

  // Axes that cross: the difference of the cores is flat there, and its normal is the way out. A small gap has lost its
  // direction to rounding (by u size / gap, which moves the separation along it by that share of the size), and taking
  // it for zero costs the gap: both stay below 2e-8 of the size when 1e-8 parts them.
  const Real size = radii + a.half_height + b.half_height;
  Vec3 normal;
  if (gap > 1e-8 * size) {
    normal = out / gap;
  } else {
    normal = sine2 > 1e-20 ? Vec3(Vec3(e.z(), 0, -e.x()) / std::sqrt(sine2)) : Vec3(Vec3::unit_x());
    if (normal.dot(out) < 0) normal = -normal;
  }
  const Vec3 normal_b = b_in_a.rotate_inverse(normal);
  const auto add = [&](Real s, Real v, std::uint32_t feature) {
    const Vec3 between = t + v * e - s * Vec3::unit_y();
    add_contact(found, reach, s * Vec3::unit_y() + a.radius * normal, v * Vec3::unit_y() - b.radius * normal_b, normal,
                normal.dot(between) - radii, feature);
  };
  found.whole = true;
  add(n.s, n.v, 1);
  if (sine2 > kSideBySide2) return;

  // The ends of the stretch where the axes run side by side, unless the nearest point is that end already.
  const Real reach_b = b.half_height * std::fabs(e.y());
  const Real lo = std::max(-a.half_height, t.y() - reach_b), hi = std::min(a.half_height, t.y() + reach_b);
  const Real apart = 1e-3 * size;
  for (const Real s : {lo, hi})
    if (hi - lo > apart && std::fabs(s - n.s) > apart)
      add(s, std::clamp(s * e.y() - t.dot(e), -b.half_height, b.half_height), s == lo ? 2 : 3);
}

}  // namespace carom::collision
