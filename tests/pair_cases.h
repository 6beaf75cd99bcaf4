// Pairs for tests of the narrow phase: shapes of every form that a routine knows, in random and in hard poses.
#pragma once

#include <array>
#include <utility>

#include "collision/narrow/pair.h"
#include "core/pose.h"
#include "shapes.h"

namespace carom::test {

/// A shape of a form with extents around `scale`, aspect ratios up to 4.
inline Shape random_shape(Form form, Real scale, Random& random) {
  const auto length = [&] { return scale * random.uniform(0.25, 1); };
  const Real a = length(), b = length(), c = length();
  switch (form) {
    case Form::half_space:
      return half_space(random.direction(), scale * random.uniform(-1, 1));
    case Form::polytope: {
      std::vector<Vec3> points;
      for (int i = 0; i < 24; ++i) points.push_back(random.in_cube(scale));
      return hull(points);
    }
    case Form::none:
      return rounded_box(Vec3(a, b, c), 0.2 * scale);
    default:
      return shape_of(form, Vec3(a, b, c));
  }
}

/// A rotation: any, or one of those that put features in line (a quarter turn about an axis, with or without a
/// tilt far below, near, and above what routines call parallel).
inline Mat3 random_turn(Random& random) {
  const Vec3 any{random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
  const Real choice = random.uniform(0, 3);
  if (choice < 1) return exp_map(any).matrix();
  Mat3 r = Mat3::identity();
  const int turns = static_cast<int>(random.uniform(0, 4)), axis = static_cast<int>(random.uniform(0, 3));
  for (int i = 0; i < turns; ++i) {
    Mat3 quarter = Mat3::zero();
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    quarter(axis, axis) = 1, quarter(u, v) = -1, quarter(v, u) = 1;
    r = quarter * r;
  }
  if (choice < 1.5) return r;
  static constexpr Real kTilts[] = {1e-15, 1e-12, 1e-9, 1e-8, 1e-7, 1e-5, 1e-3};
  const Real tilt = kTilts[static_cast<int>(random.uniform(0, 7))];
  return exp_map(tilt * random.direction()).matrix() * r;
}

/// Largest n . x over the shape; infinite for a half-space unless n is its normal.
inline Real support_value(const Shape& s, const Vec3& n) {
  if (s.form == Form::half_space) return (n - s.normal).squared_norm() < 1e-24 ? s.offset : kInfinity;
  return n.dot(support_point(s, n));
}

/// What every direction bounds the signed distance from below by: min over B of n . b - max over A of n . a.
inline Real separation_along(const Shape& a, const Shape& b, const Frame& b_in_a, const Vec3& n) {
  const Vec3 n_b = -(b_in_a.r.transpose() * n);
  return n.dot(b_in_a.p) - support_value(b, n_b / n_b.norm()) - support_value(a, n);
}

/// Largest length that enters a distance: u times this is the unit of rounding.
inline Real pair_size(const Shape& a, const Shape& b, const Frame& b_in_a) {
  return b_in_a.p.norm() + a.bounding_radius + b.bounding_radius + std::fabs(a.offset) + std::fabs(b.offset);
}

/// The pairs that have a routine, in the order in which it is written.
inline constexpr std::array<std::pair<Form, Form>, 13> kRoutinePairs = {{
    {Form::sphere, Form::sphere},
    {Form::box, Form::sphere},
    {Form::capsule, Form::sphere},
    {Form::capsule, Form::capsule},
    {Form::box, Form::capsule},
    {Form::box, Form::box},
    {Form::half_space, Form::sphere},
    {Form::half_space, Form::capsule},
    {Form::half_space, Form::box},
    {Form::half_space, Form::cylinder},
    {Form::half_space, Form::cone},
    {Form::half_space, Form::ellipsoid},
    {Form::half_space, Form::polytope},
}};

/// B somewhere near A: apart, near touch, or deep; every fourth time with centres in line on an axis of A.
inline Frame random_pose(const Shape& a, const Shape& b, Random& random) {
  Frame f;
  f.r = random_turn(random);
  if (a.form == Form::half_space) {
    f.p = a.normal * (a.offset + random.uniform(-0.5, 1.5) * b.bounding_radius) +
          any_perpendicular(a.normal) * random.uniform(-1, 1);
    return f;
  }
  const Real reach = (a.bounding_radius + b.bounding_radius) * random.uniform(0, 1.2);
  const bool in_line = random.uniform(0, 4) < 1;
  f.p = reach * (in_line ? Vec3(Vec3::unit(static_cast<int>(random.uniform(0, 3)))) : random.direction());
  if (random.uniform(0, 10) < 1) f.p.set_zero();
  return f;
}

}  // namespace carom::test
