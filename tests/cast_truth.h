// Where a line enters and leaves a shape, by textbook formulas in long double: the truth for tests and benchmarks of
// rays.
#pragma once

#include <cmath>
#include <optional>

#include "collision/hull.h"
#include "shapes.h"

namespace carom::test {

using Long = long double;
using Long3 = Vector3<Long>;

/// A stretch [in, out] of the line o + t d; none: the line misses.
struct Stretch {
  Long in, out;
};
using MaybeStretch = std::optional<Stretch>;

/// t with a t^2 + 2 b t + c <= 0, a > 0.
inline MaybeStretch quadratic(Long a, Long b, Long c) {
  const Long disc = b * b - a * c;
  if (disc < 0) return {};
  const Long q = b < 0 ? -b + std::sqrt(disc) : -b - std::sqrt(disc);
  const Long t1 = q / a, t2 = q != 0 ? c / q : t1;
  return Stretch{std::min(t1, t2), std::max(t1, t2)};
}

inline MaybeStretch both(const MaybeStretch& x, const MaybeStretch& y) {
  if (!x || !y) return {};
  const Stretch s{std::max(x->in, y->in), std::min(x->out, y->out)};
  if (s.in > s.out) return {};
  return s;
}

/// |coordinate i| <= half
inline MaybeStretch slab(const Long3& o, const Long3& d, int i, Long half) {
  if (d[i] == 0) {
    if (std::fabs(o[i]) > half) return {};
    return Stretch{-INFINITY, INFINITY};
  }
  const Long s = (-half - o[i]) / d[i], t = (half - o[i]) / d[i];
  return Stretch{std::min(s, t), std::max(s, t)};
}

inline MaybeStretch through_box(const Long3& o, const Long3& d, const Vec3& half) {
  return both(slab(o, d, 0, half.x()), both(slab(o, d, 1, half.y()), slab(o, d, 2, half.z())));
}

inline MaybeStretch through_ellipsoid(const Long3& o, const Long3& d, const Vec3& radii) {
  const Long3 r = radii.cast<Long>(), p = o.over(r), v = d.over(r);
  return quadratic(v.dot(v), p.dot(v), p.dot(p) - 1);
}

inline MaybeStretch through_tube(const Long3& o, const Long3& d, Long radius) {
  const Long a = d.x() * d.x() + d.z() * d.z(), c = o.x() * o.x() + o.z() * o.z() - radius * radius;
  if (a == 0) {
    if (c > 0) return {};
    return Stretch{-INFINITY, INFINITY};
  }
  return quadratic(a, o.x() * d.x() + o.z() * d.z(), c);
}

inline MaybeStretch through_cylinder(const Long3& o, const Long3& d, Long radius, Long half_height) {
  return both(through_tube(o, d, radius), slab(o, d, 1, half_height));
}

inline MaybeStretch hull_of(const MaybeStretch& x, const MaybeStretch& y) {
  if (!x) return y;
  if (!y) return x;
  return Stretch{std::min(x->in, y->in), std::max(x->out, y->out)};
}

/// The union of a cylinder and two balls, which a line meets in one piece.
inline MaybeStretch through_capsule(const Long3& o, const Long3& d, Real radius, Real half_height) {
  MaybeStretch s = through_cylinder(o, d, radius, half_height);
  for (const Real end : {-half_height, half_height})
    s = hull_of(s, through_ellipsoid(Long3(o - Long3(0, end, 0)), d, Vec3::constant(radius)));
  return s;
}

/// Between the faces of the hull of the points.
inline MaybeStretch through_hull(const Long3& o, const Long3& d, const Shape& s,
                                 const Array<std::uint32_t>& triangles) {
  MaybeStretch all = Stretch{-INFINITY, INFINITY};
  const auto vertex = [&](std::uint32_t v) {
    return Long3(s.vertices[3 * v], s.vertices[3 * v + 1], s.vertices[3 * v + 2]);
  };
  for (std::size_t t = 0; t + 3 <= triangles.size() && all; t += 3) {
    const Long3 a = vertex(triangles[t]), b = vertex(triangles[t + 1]), c = vertex(triangles[t + 2]);
    const Long3 n = (b - a).cross(c - a);
    const Long height = n.dot(o - a), rate = n.dot(d);
    if (rate == 0 && height > 0) return {};
    if (rate == 0) continue;
    const Long at = -height / rate;
    all = both(all, rate < 0 ? Stretch{at, INFINITY} : Stretch{-INFINITY, at});
  }
  return all;
}

/// Where the line enters and leaves a shape of a closed form, in its own frame.
/// @param triangles  of a polytope's hull
inline MaybeStretch through(const Shape& s, const Long3& o, const Long3& d,
                            const Array<std::uint32_t>* triangles = nullptr) {
  switch (s.form) {
    case Form::sphere:
      return through_ellipsoid(o, d, Vec3::constant(s.radius));
    case Form::box:
      return through_box(o, d, s.half);
    case Form::capsule:
      return through_capsule(o, d, s.radius, s.half_height);
    case Form::cylinder:
      return through_cylinder(o, d, s.radius, s.half_height);
    case Form::ellipsoid:
      return through_ellipsoid(o, d, s.half);
    default:
      return through_hull(o, d, s, *triangles);
  }
}

}  // namespace carom::test
