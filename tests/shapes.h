// Shapes for tests of the inside: support functions written out in C++, and the same declarations that plugins make.
//
// The numbers that the shape floor derives (bounds, bounding radius) are given in closed form here, so that a test of
// the narrow phase does not lean on the room that derives them. Mass properties are left empty: a test that needs them
// asks mass_from_form(). A Shape moves freely, but does not copy where it is a hull (its vertices point into its own
// params).
#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <memory_resource>
#include <vector>

#include "collision/shape.h"

namespace carom::test {

/// sqrt(x^2 + z^2) for a direction of any length: the plain formula where it neither overflows nor underflows.
inline double length_xz(double x, double z) {
  const double s = x * x + z * z;
  return s > 1e-280 && s < 1e280 ? std::sqrt(s) : std::hypot(x, z);
}

inline std::int32_t point_support(void*, const double*, std::uint64_t, const double*, double* out) {
  out[0] = out[1] = out[2] = 0;
  return 0;
}

/// params: radius, half height of the core segment (y)
inline std::int32_t segment_support(void*, const double* p, std::uint64_t, const double* d, double* out) {
  out[0] = out[2] = 0;
  out[1] = d[1] < 0 ? -p[1] : p[1];
  return 0;
}

/// params: half extents x, y, z (what follows is ignored: a rounded box carries its radius there)
inline std::int32_t box_support(void*, const double* p, std::uint64_t, const double* d, double* out) {
  for (int i = 0; i < 3; ++i) out[i] = std::copysign(p[i], d[i]);
  return 0;
}

/// params: radius, half height (y)
inline std::int32_t cylinder_support(void*, const double* p, std::uint64_t, const double* d, double* out) {
  const double length = length_xz(d[0], d[2]);
  out[0] = length > 0 ? p[0] * (d[0] / length) : 0;
  out[2] = length > 0 ? p[0] * (d[2] / length) : 0;
  out[1] = std::copysign(p[1], d[1]);
  return 0;
}

/// params: base radius, half height; apex at +y, base disc at -y
inline std::int32_t cone_support(void*, const double* p, std::uint64_t, const double* d, double* out) {
  const double length = length_xz(d[0], d[2]);
  if (2 * p[1] * d[1] > p[0] * length) {
    out[0] = out[2] = 0;
    out[1] = p[1];
    return 0;
  }
  out[0] = length > 0 ? p[0] * (d[0] / length) : 0;
  out[2] = length > 0 ? p[0] * (d[2] / length) : 0;
  out[1] = -p[1];
  return 0;
}

/// params: radii x, y, z
inline std::int32_t ellipsoid_support(void*, const double* p, std::uint64_t, const double* d, double* out) {
  const double largest = std::max({std::fabs(d[0]), std::fabs(d[1]), std::fabs(d[2])});
  double w[3];
  for (int i = 0; i < 3; ++i) w[i] = p[i] * (d[i] / largest);
  const double length = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
  for (int i = 0; i < 3; ++i) out[i] = length > 0 ? p[i] * (w[i] / length) : 0;
  return 0;
}

/// params: x, y, z of every vertex
inline std::int32_t hull_support(void*, const double* p, std::uint64_t count, const double* d, double* out) {
  const double *best = p, *const end = p + count;
  double most = d[0] * p[0] + d[1] * p[1] + d[2] * p[2];
  for (const double* v = p + 3; v < end; v += 3) {
    const double h = d[0] * v[0] + d[1] * v[1] + d[2] * v[2];
    if (h > most) most = h, best = v;
  }
  for (int i = 0; i < 3; ++i) out[i] = best[i];
  return 0;
}

/// Says that it failed, with a number of its own.
inline std::int32_t failing_support(void*, const double*, std::uint64_t, const double*, double* out) {
  out[0] = out[1] = out[2] = 0;
  return 7;
}

inline Shape make_shape(Form form, SupportFn support, std::initializer_list<double> params, const Vec3& half,
                        Real bounding_radius) {
  Shape s(std::pmr::get_default_resource());
  s.form = form;
  s.support = support;
  s.params.assign(params.begin(), params.end());
  s.bounds.lo = -half;
  s.bounds.hi = half;
  s.bounding_radius = bounding_radius;
  return s;
}

/// A point swollen by a radius.
inline Shape sphere(Real radius) {
  Shape s = make_shape(Form::sphere, point_support, {radius}, Vec3::constant(radius), radius);
  s.core_radius = s.radius = radius;
  return s;
}

/// A segment along y swollen by a radius.
inline Shape capsule(Real radius, Real half_height) {
  Shape s = make_shape(Form::capsule, segment_support, {radius, half_height},
                       Vec3(radius, radius + half_height, radius), radius + half_height);
  s.core_radius = s.radius = radius;
  s.half_height = half_height;
  return s;
}

inline Shape box(const Vec3& half) {
  Shape s = make_shape(Form::box, box_support, {half.x(), half.y(), half.z()}, half, half.norm());
  s.half = half;
  return s;
}

/// A box swollen by a radius: no closed form is declared for it, only the core radius.
inline Shape rounded_box(const Vec3& half, Real radius) {
  Shape s = make_shape(Form::none, box_support, {half.x(), half.y(), half.z(), radius}, half + Vec3::constant(radius),
                       half.norm() + radius);
  s.core_radius = radius;
  return s;
}

inline Shape cylinder(Real radius, Real half_height) {
  Shape s = make_shape(Form::cylinder, cylinder_support, {radius, half_height}, Vec3(radius, half_height, radius),
                       std::hypot(radius, half_height));
  s.radius = radius;
  s.half_height = half_height;
  return s;
}

inline Shape cone(Real radius, Real half_height) {
  Shape s = make_shape(Form::cone, cone_support, {radius, half_height}, Vec3(radius, half_height, radius),
                       std::hypot(radius, half_height));
  s.radius = radius;
  s.half_height = half_height;
  return s;
}

inline Shape ellipsoid(const Vec3& radii) {
  Shape s = make_shape(Form::ellipsoid, ellipsoid_support, {radii.x(), radii.y(), radii.z()}, radii, radii.max_entry());
  s.half = radii;
  return s;
}

/// @param points [k] at least one; any k points, flat and repeated ones too
inline Shape hull(const std::vector<Vec3>& points) {
  Shape s(std::pmr::get_default_resource());
  s.form = Form::polytope;
  s.support = hull_support;
  for (const Vec3& p : points) {
    s.params.insert(s.params.end(), {p.x(), p.y(), p.z()});
    s.bounds.lo = s.bounds.lo.min(p);
    s.bounds.hi = s.bounds.hi.max(p);
    s.bounding_radius = std::max(s.bounding_radius, p.norm());
  }
  s.vertices = s.params;
  s.farthest.build(s.vertices);
  return s;
}

/// Closed forms in the order in which tests draw them.
inline constexpr Form kForms[] = {Form::sphere, Form::box, Form::capsule, Form::cylinder, Form::cone, Form::ellipsoid};
inline constexpr int kFormCount = 6;

/// One of kForms.
/// @param size  m: half extents of a box, radii of an ellipsoid; of the others x is the radius, y the half height
inline Shape shape_of(Form form, const Vec3& size) {
  switch (form) {
    case Form::sphere:
      return sphere(size.x());
    case Form::box:
      return box(size);
    case Form::capsule:
      return capsule(size.x(), size.y());
    case Form::cylinder:
      return cylinder(size.x(), size.y());
    case Form::cone:
      return cone(size.x(), size.y());
    default:
      return ellipsoid(size);
  }
}

/// All x with normal . x <= offset; normal unit.
inline Shape half_space(const Vec3& normal, Real offset) {
  Shape s(std::pmr::get_default_resource());
  s.form = Form::half_space;
  s.normal = normal;
  s.offset = offset;
  s.bounds.lo = Vec3::constant(-kInfinity);
  s.bounds.hi = Vec3::constant(kInfinity);
  return s;
}

/// A small generator of repeatable numbers for tests (a 64-bit linear congruence with its high bits mixed down).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 2 + 1) {}
  /// Uniform in [lo, hi).
  Real uniform(Real lo, Real hi) {
    state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
    const std::uint64_t mixed = (state_ ^ (state_ >> 29)) * 0xBF58476D1CE4E5B9ull;
    return lo + (hi - lo) * static_cast<Real>(mixed >> 11) * 0x1p-53;
  }
  Vec3 in_cube(Real half) {
    const Real x = uniform(-half, half), y = uniform(-half, half), z = uniform(-half, half);
    return Vec3(x, y, z);
  }
  /// Uniform on the unit sphere: a point of the ball, scaled.
  Vec3 direction() {
    for (;;) {
      const Vec3 v = in_cube(1);
      const Real n2 = v.squared_norm();
      if (n2 > 1e-4 && n2 <= 1) return v / std::sqrt(n2);
    }
  }

 private:
  std::uint64_t state_;
};

/// Support point of the whole shape, core radius included, for a unit direction in the shape's frame.
inline Vec3 support_point(const Shape& s, const Vec3& unit_dir) {
  Vec3 out;
  s.support(s.user, s.params.data(), s.params.size(), unit_dir.data(), out.data());
  return out + s.core_radius * unit_dir;
}

}  // namespace carom::test
