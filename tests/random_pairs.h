// Random pairs of shapes, sorted into separated and overlapping ones by the sweep of their own answer: for benchmarks
// and oracles.
#pragma once

#include "collision/narrow/query.h"
#include "shapes.h"

namespace carom::test {

struct ShapePair {
  Shape a, b;
  Frame b_in_a;
};

/// Shifted, not turned.
inline Frame at(Real x, Real y, Real z) { return Frame(Mat3::identity(), Vec3(x, y, z)); }

inline Quat random_rotation(Random& random) {
  // Uniform on the 3-sphere: a point of the 4-ball, scaled.
  for (;;) {
    const Real w = random.uniform(-1, 1), x = random.uniform(-1, 1), y = random.uniform(-1, 1),
               z = random.uniform(-1, 1);
    const Real n2 = w * w + x * x + y * y + z * z;
    if (n2 > 1e-3 && n2 <= 1) return normalized(Quat(w, x, y, z));
  }
}

/// A hull of `count` points on a random ellipsoid of about unit size.
inline Shape random_hull(Random& random, int count) {
  const Vec3 radii{random.uniform(0.4, 1), random.uniform(0.4, 1), random.uniform(0.4, 1)};
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(random.direction().times(radii));
  return hull(points);
}

inline constexpr const char* kFamilies[] = {"sphere",   "box",  "capsule",   "hull32",     "hull1000",
                                            "cylinder", "cone", "ellipsoid", "rounded_box"};
inline constexpr int kFamilyCount = 9;

/// A shape of about 1 m.
inline Shape random_shape(Random& random, int family) {
  const Real x = random.uniform(0.3, 1), y = random.uniform(0.3, 1), z = random.uniform(0.3, 1);
  switch (family) {
    case 0:
      return sphere(x);
    case 1:
      return box(Vec3(x, y, z));
    case 2:
      return capsule(0.5 * x, y);
    case 3:
      return random_hull(random, 32);
    case 4:
      return random_hull(random, 1000);
    case 5:
      return cylinder(x, y);
    case 6:
      return cone(x, y);
    case 7:
      return ellipsoid(Vec3(x, y, z));
    default:
      return rounded_box(Vec3(x, y, z), 0.2 * z);
  }
}

/// A pair at a random attitude whose signed distance is about `gap` metres: moved along a random line, by bisection.
inline ShapePair random_pair(Random& random, int family_a, int family_b, Real gap) {
  Shape a = random_shape(random, family_a), b = random_shape(random, family_b);
  const Mat3 r = random_rotation(random).matrix();
  const Vec3 line = random.direction();
  Real lo = 0, hi = 10;
  for (int i = 0; i < 20; ++i) {
    const Real middle = 0.5 * (lo + hi);
    QueryResult result;
    SupportFault fault;
    generic_distance(a, b, Frame(r, middle * line), QuerySettings(), nullptr, result, fault);
    (result.separation < gap ? lo : hi) = middle;
  }
  return {std::move(a), std::move(b), Frame(r, hi * line)};
}

}  // namespace carom::test
