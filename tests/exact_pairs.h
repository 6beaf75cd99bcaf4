// Pairs of convex shapes that are hard for GJK and EPA, and whose signed distance is known from geometry alone.
//
// Three ways to know it, all in long double (11 bits more than the queries have) from the very doubles that the query
// gets, so that no rounding of a pose is mistaken for an error:
//   - closed forms: the Minkowski difference of boxes, cylinders, capsules along common axes, or of a sphere with
//     anything, is a shape whose signed distance from a point is elementary;
//   - a point off a plane: where B's lowest point lies over a face of a box, the distance is its height; and below that
//     face by less than to any other, the depth is, for the ball of that depth fits in;
//   - two points and a plane: if the farthest points of A and B along n lie opposite each other, the plane bounds the
//     distance from below and the points from above. The two differ by what rounding did to the placing.
#pragma once

#include <optional>
#include <string>

#include "collision/narrow/rounding.h"
#include "random_pairs.h"

namespace carom::test {

using Long = long double;

struct Known {
  std::string name;
  Long low = 0, high = 0;      // m: the signed distance lies between
  std::optional<Vec3> normal;  // A's frame, where one direction alone is best
  Real smallest = 0;           // m: turning the normal by x loses (1 - cos x) of this at least
  bool ring = false;           // a ring of equally near points: the slowest there is, may run into the cap
};

struct ExactPair : Known {
  ExactPair(std::string family, Shape first, Shape second, const Frame& second_in_first, Long value)
      : a(std::move(first)), b(std::move(second)), b_in_a(second_in_first) {
    name = std::move(family);
    low = high = value;
  }
  Shape a, b;
  Frame b_in_a;
};

/// Largest l . x over the shape (core radius included) for any direction, from the closed form.
inline Long exact_support(const Shape& s, const Long* d) {
  const Long side = std::sqrt(d[0] * d[0] + d[2] * d[2]), length = std::sqrt(side * side + d[1] * d[1]);
  const double* p = s.params.data();
  const Long swollen = s.core_radius * length;
  switch (s.form) {
    case Form::sphere:
      return swollen;
    case Form::capsule:
      return s.half_height * std::fabs(d[1]) + swollen;
    case Form::cylinder:
      return s.half_height * std::fabs(d[1]) + s.radius * side;
    case Form::cone:
      return std::max(s.half_height * d[1], s.radius * side - s.half_height * d[1]);
    case Form::ellipsoid:
      return std::sqrt(p[0] * p[0] * d[0] * d[0] + Long(p[1]) * p[1] * d[1] * d[1] + Long(p[2]) * p[2] * d[2] * d[2]);
    case Form::polytope: {
      Long most = -INFINITY;
      for (std::size_t i = 0; i < s.params.size(); i += 3)
        most = std::max(most, d[0] * p[i] + d[1] * p[i + 1] + d[2] * p[i + 2]);
      return most;
    }
    default:  // box, rounded box
      return p[0] * std::fabs(d[0]) + p[1] * std::fabs(d[1]) + p[2] * std::fabs(d[2]) + swollen;
  }
}

/// What a direction proves: the lowest n . b less the highest n . a, over |n|, in long double.
inline Long exact_bound(const Shape& a, const Shape& b, const Frame& f, const Vec3& n) {
  Long along[3], back[3], offset = 0, length = 0;
  for (int i = 0; i < 3; ++i) {
    along[i] = n[i];
    back[i] = 0;
    for (int k = 0; k < 3; ++k) back[i] -= Long(f.r(k, i)) * n[k];
    offset += Long(f.p[i]) * n[i];
    length += Long(n[i]) * n[i];
  }
  // The core radius of B is added in A's frame, where its ball is a ball: |R' n| is 1 but for rounding.
  const Long back_length = std::sqrt(back[0] * back[0] + back[1] * back[1] + back[2] * back[2]);
  length = std::sqrt(length);
  return (offset - exact_support(b, back) + b.core_radius * (back_length - length) - exact_support(a, along)) / length;
}

/// Signed distance of a point from a box, from below zero inside. x: how far beyond the half extent on each axis.
inline Long box_distance(Long x, Long y, Long z) {
  const Long inside = std::min<Long>(std::max({x, y, z}), 0);
  const auto out = [](Long v) { return std::max<Long>(v, 0); };
  return inside + std::sqrt(out(x) * out(x) + out(y) * out(y) + out(z) * out(z));
}

/// The same where the set is a product of a body in the plane (signed distance r) and an interval (y).
inline Long product_distance(Long r, Long y) { return box_distance(r, y, -INFINITY); }

inline Long length_of(Long x, Long z) { return std::sqrt(x * x + z * z); }

/// A cone's signed distance from a point, in the half-plane (distance from the axis, height).
inline Long cone_distance(Long radius, Long half_height, Long r, Long y) {
  // Outwards of the slanted side, and along it from the rim to the apex.
  const Long slant = std::sqrt(radius * radius + 4 * half_height * half_height);
  const Long nr = 2 * half_height / slant, ny = radius / slant;
  const Long off = (r - radius) * nr + (y + half_height) * ny;
  const Long along = -(r - radius) * ny + (y + half_height) * nr;
  const Long below = -half_height - y;
  if (off <= 0 && below <= 0) return std::max(off, below);
  const auto from_point = [&](Long pr, Long py) { return length_of(r - pr, y - py); };
  if (off > 0 && along >= 0 && along <= slant) return off;
  if (off > 0 && along > slant) return from_point(0, half_height);
  if (below > 0 && r <= radius) return below;
  return from_point(radius, -half_height);
}

/// Gaps as shares of a size, down to less than the spacing of numbers there.
inline constexpr Real kGaps[] = {0,      1e-4,  -1e-4,  1e-6,  -1e-6,  1e-8,  -1e-8,  1e-10,
                                 -1e-10, 1e-12, -1e-12, 1e-14, -1e-14, 1e-15, -1e-15, 0.3};
/// Lengths, as multiples of a size: bodies to needles and discs.
inline constexpr Real kAspects[] = {1, 0.3, 1e-2, 1e-4, 1e-6, 1e-8};
/// Sizes in metres.
inline constexpr Real kSizes[] = {1e-6, 1e-3, 1, 1e3, 1e6};

inline Real pick(Random& random, std::initializer_list<Real> from) {
  return from.begin()[static_cast<std::size_t>(random.uniform(0, static_cast<Real>(from.size())))];
}
template <std::size_t N>
Real pick(Random& random, const Real (&from)[N]) {
  return from[static_cast<std::size_t>(random.uniform(0, N))];
}

/// A body that a random draw of the lists above makes: any plugin's kind.
inline Shape extreme_shape(Random& random, int kind, Real size) {
  const auto length = [&] { return size * pick(random, kAspects); };
  const Real x = length(), y = length(), z = length();
  if (kind == 0) return sphere(size);
  if (kind < kFormCount) return shape_of(kForms[kind], Vec3(x, y, z));
  switch (kind) {
    case 6:
      return rounded_box(Vec3(x, y, z), length());
    case 7: {  // a cloud, one point twice, one in the middle of two others
      std::vector<Vec3> points;
      for (int i = 0; i < 12; ++i) points.push_back(random.direction().times(Vec3(x, y, z)));
      points.push_back(points[3]);
      points.push_back(0.5 * (points[0] + points[1]));
      return hull(points);
    }
    default: {  // a flat cloud, a line, a point, all of them coplanar to the last bit or but for rounding
      const Vec3 half(x, pick(random, {0.0, 0.0, x}), pick(random, {0.0, z, z}));
      const Mat3 tilt = random_rotation(random).matrix();
      const bool tilted = random.uniform(0, 2) < 1;
      std::vector<Vec3> points;
      for (int i = static_cast<int>(random.uniform(1, 9)); i > 0; --i) {
        Vec3 v = random.in_cube(1).times(half);
        if (half.y() > 0) v.y() = v.x();
        points.push_back(tilted ? Vec3(tilt * v) : v);
      }
      points.push_back(points[0]);
      return hull(points);
    }
  }
}
inline constexpr int kExtremeKinds = 9;

/// One of the 24 turns that take axes to axes: no digit is lost.
inline Mat3 quarter_turns(Random& random) {
  const auto any = [&](int n) { return static_cast<int>(random.uniform(0, n)); };
  Mat3 r = Mat3::zero();
  const int i = any(3), j = (i + 1 + any(2)) % 3, k = 3 - i - j;
  r(0, i) = any(2) ? 1 : -1;
  r(1, j) = any(2) ? 1 : -1;
  r(2, k) = r.row(0).cross(r.row(1))[k];
  return r;
}

}  // namespace carom::test
