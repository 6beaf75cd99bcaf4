// A ray through a surface: one line in the scenery's frame, and the triangles that it crosses.
//
// No gap between triangles lets it through. All of them are asked about the same numbers of the same line, and each
// takes in what passes it by no more than rounding. So a line that crosses the surface crosses one of them.
#pragma once

#include "collision/cast/line.h"
#include "collision/cast/local_ray.h"
#include "collision/scenery/scenery.h"

namespace carom::collision {

/// A ray as the scenery sees it.
struct SceneryRay {
  Vec3 o, u;    // m; unit
  Mat3 axes;    // two perpendiculars of u, and u
  Real length;  // m
  Real speed;   // m per unit of t
  Real blur;    // m, of the line: rounding of where it starts and of where the scenery stands

  /// @param frame  scenery -> the frame of the ray
  SceneryRay(const Ray& ray, const Frame& frame) : o(frame.apply_inverse(ray.origin)) {
    const Vec3 d = frame.rotate_inverse(ray.direction);
    const Real largest = d.abs().max_entry();
    const Vec3 scaled = largest > 0 ? Vec3(d / largest) : Vec3(Vec3::unit_x());
    u = scaled / scaled.norm();
    axes = line::axes_along(u);
    speed = largest * scaled.norm();
    length = speed > 0 ? speed * ray.max : 0;
    blur = kUnitRoundoff * (16 * o.norm() + kPlaceRounding * (frame.p.norm() + ray.origin.norm()));
  }
  /// Whether it moves at all, and squares of its lengths do not overflow.
  bool usable() const { return length > 0 && o.abs().max_entry() < 1e80 && speed < 1e100; }
};

/// Where a ray crosses a triangle.
struct TriangleCrossing {
  Real s = 0;             // m along the ray, in [0, length]
  Real blur = 0;          // m, of s, either way
  Real slack = 0;         // m, by which it may have passed the triangle
  bool at_start = false;  // it starts on the triangle
};

/// @return  false: it does not cross the triangle. So it is if it runs within the triangle's plane, which has no
///          thickness; and if it starts on the triangle and leaves it to the side that the normal points to
/// @accuracy  what passes the triangle by no more than `slack` counts as crossing it: 16 u of the lengths that enter,
///            seen from the ray's origin
/// @oracle    tests/unit/collision/scenery/test_ask, tests/fuzz/rays_campaign
inline bool cross_triangle(const SceneryRay& ray, const Triangle& triangle, TriangleCrossing& out) {
  Vec3 y[3];
  Real reach = 0;
  for (int k = 0; k < 3; ++k) {
    const Vec3& c = triangle.corner[static_cast<std::size_t>(k)];
    const Vec3 v = c - ray.o;
    y[k] = ray.axes.transpose() * v;
    reach = std::max(reach, v.abs().sum() + c.abs().sum());
  }
  const Real slack = ray.blur + 16 * kUnitRoundoff * reach;
  for (int i = 0; i < 2; ++i)
    if (std::min({y[0][i], y[1][i], y[2][i]}) > slack || std::max({y[0][i], y[1][i], y[2][i]}) < -slack) return false;
  const Real near = std::min({y[0].z(), y[1].z(), y[2].z()}), far = std::max({y[0].z(), y[1].z(), y[2].z()});
  if (far < -slack || near > ray.length + slack) return false;
  const Vec3 n = ray.axes.transpose() * triangle.normal;
  const Real longest2 = std::max({(y[1] - y[0]).squared_norm(), (y[2] - y[1]).squared_norm(),
                                  (y[0] - y[2]).squared_norm()});
  constexpr Real kAlong2 = 1e-16;  // a slope that the square root of rounding hides: from far off slack is no measure
  if (n.z() * n.z() <= std::min(slack * slack / longest2, kAlong2)) return false;  // within its plane
  if (!(line::nearest_shadow(y, 3).distance2 <= slack * slack)) return false;
  // Through the corner nearest to the line, where the product has the smallest error.
  int p = 0;
  for (int k = 1; k < 3; ++k)
    if (y[k].xy().squared_norm() < y[p].xy().squared_norm()) p = k;
  const Real s = std::clamp(y[p].z() + n.xy().dot(y[p].xy()) / n.z(), near, far);
  const Real blur = std::min(slack / std::fabs(n.z()), far - near + slack);
  if (s < -blur || s > ray.length + blur) return false;
  out.at_start = std::fabs(n.dot(y[p])) <= slack || s <= 0;
  if (out.at_start && n.z() >= 0) return false;
  out.s = std::clamp(s, Real(0), ray.length);
  out.blur = blur, out.slack = slack;
  return true;
}

}  // namespace carom::collision
