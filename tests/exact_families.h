// Families of hard pairs with known answers: what to put next to what, how near, how large, how thin.
#pragma once

#include <functional>

#include "exact_pairs.h"

namespace carom::test {

using Take = std::function<void(ExactPair&&)>;

inline int any_of(Random& random, int n) { return static_cast<int>(random.uniform(0, n)); }

/// Where one direction is best in overlap, and by what: half of what lies before the next best, if that is far enough,
/// and no more than what the same axis loses the other way.
/// @param beyond  how far beyond its half extent a point is on each axis, and `at` where it is
inline void best_of_axes(const Long* beyond, const Long* at, ExactPair& pair) {
  int best = 0;
  for (int i = 1; i < 3; ++i)
    if (beyond[i] > beyond[best]) best = i;
  Long next = -INFINITY;
  for (int i = 0; i < 3; ++i)
    if (i != best) next = std::max(next, beyond[i]);
  if (beyond[best] > 0 || !(next < 2 * beyond[best])) return;
  pair.normal = Vec3(Vec3::unit(best) * (at[best] < 0 ? -1 : 1));
  pair.smallest = static_cast<Real>(std::min(-next / 2, std::fabs(at[best])));
}

/// The corners of a box, each also a rounding or nothing away, and points within.
inline Shape box_as_hull(Random& random, const Vec3& half) {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) points.push_back(half.times(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
  for (int i = 0; i < 8; ++i) points.push_back(random.uniform(0, 2) < 1 ? points[i] : Vec3(0.5 * points[i]));
  for (int i = 0; i < 4; ++i) points.push_back(0.5 * (points[2 * i] + points[2 * i + 1]));
  return hull(points);
}

/// Boxes with parallel axes, as boxes or as hulls that may be plates, lines and points: faces, edges and corners that
/// touch or miss by a gap; concentric; one inside the other; of unlike sizes.
inline void parallel_boxes(Random& random, int count, const Take& take) {
  for (int i = 0; i < count; ++i) {
    const Real size = pick(random, kSizes), other = any_of(random, 3) ? size : pick(random, kSizes);
    const auto length = [&](Real s) { return s * pick(random, kAspects); };
    Vec3 a(length(size), length(size), length(size)), b(length(other), length(other), length(other));
    const bool hull_a = any_of(random, 2), hull_b = any_of(random, 2);
    if (hull_a && any_of(random, 3) == 0) a[any_of(random, 3)] = 0;
    if (hull_b && any_of(random, 3) == 0) b[any_of(random, 3)] = 0;
    if (hull_b && any_of(random, 5) == 0) b[any_of(random, 3)] = 0;
    Frame f;
    f.r = quarter_turns(random);
    const Vec3 turned = f.r.abs() * b;  // one term a row: exact
    for (int k = 0; k < 3; ++k) {
      const Real reach = a[k] + turned[k];
      const int where = any_of(random, 4);
      f.p[k] = where == 0   ? 0
               : where == 1 ? reach * random.uniform(-0.9, 0.9)
                            : (any_of(random, 2) ? 1 : -1) * reach * (1 + pick(random, kGaps));
    }
    Long beyond[3];
    for (int k = 0; k < 3; ++k) beyond[k] = std::fabs(Long(f.p[k])) - (Long(a[k]) + turned[k]);
    ExactPair pair("parallel boxes", hull_a ? box_as_hull(random, a) : box(a), hull_b ? box_as_hull(random, b) : box(b),
                   f, box_distance(beyond[0], beyond[1], beyond[2]));
    const Long at[3] = {f.p.x(), f.p.y(), f.p.z()};
    best_of_axes(beyond, at, pair);
    take(std::move(pair));
  }
}

/// Signed distance of a point from a shape about the origin, closed form; ellipsoids on their axes only.
inline Long point_distance(const Shape& s, const Vec3& at) {
  const Long x = std::fabs(at.x()), y = std::fabs(at.y()), z = std::fabs(at.z()), rho = length_of(at.x(), at.z());
  switch (s.form) {
    case Form::sphere:
      return length_of(rho, y) - s.radius;
    case Form::capsule:
      return length_of(rho, std::max<Long>(0, y - s.half_height)) - s.radius;
    case Form::cylinder:
      return product_distance(rho - s.radius, y - s.half_height);
    case Form::cone:
      return cone_distance(s.radius, s.half_height, rho, at.y());
    case Form::ellipsoid:
      return std::max({x - Long(s.half.x()), y - Long(s.half.y()), z - Long(s.half.z())});
    default:
      return box_distance(x - s.params[0], y - s.params[1], z - s.params[2]) - s.core_radius;
  }
}

/// A sphere at, on, in and around everything.
inline void sphere_and_any(Random& random, int count, const Take& take) {
  for (int i = 0; i < count; ++i) {
    const Real size = pick(random, kSizes),
               radius = any_of(random, 3) ? size * pick(random, kAspects) : pick(random, kSizes);
    Shape a = extreme_shape(random, i % 7, size);
    Frame f;
    if (any_of(random, 2)) f.r = random_rotation(random).matrix();
    const int where = any_of(random, 4);
    if (where == 1) f.p = random.in_cube(1).times(a.bounds.hi);
    if (where > 1) {
      Vec3 n = where == 2 ? random.direction() : Vec3(Vec3::unit(any_of(random, 3)) * (any_of(random, 2) ? 1 : -1));
      if (where == 2 && any_of(random, 3) == 0) n = Vec3(n.x(), 0, n.z()).normalized();
      f.p = support_point(a, n) + radius * (1 + pick(random, kGaps)) * n;
    }
    bool ring = a.form != Form::sphere && f.p.x() == 0 && f.p.z() == 0;
    if (a.form == Form::ellipsoid) {
      // On an axis: outside any, inside the shortest (the ball through the pole stays inside).
      const int axis = a.half.min_axis();
      const Real at = a.half[axis] * (any_of(random, 2) ? 1 + pick(random, kGaps) : random.uniform(-1, 1));
      f.p = Vec3::unit(axis) * at;
      ring = ring || a.half.min_entry() == a.half.max_entry() || at == 0;
    }
    ExactPair pair("sphere and any", std::move(a), sphere(radius), f, 0);
    pair.low = pair.high = point_distance(pair.a, f.p) - Long(radius);
    pair.ring = ring;
    take(std::move(pair));
  }
}

/// Capsules, cylinders and boxes with parallel axes, ellipsoids with common ones: side by side, end to end, rim to rim,
/// coaxial, one inside the other.
inline void parallel_axes(Random& random, int count, const Take& take) {
  for (int i = 0; i < count; ++i) {
    const Real size = pick(random, kSizes), other = any_of(random, 3) ? size : pick(random, kSizes);
    const auto length = [&](Real s) { return s * pick(random, kAspects); };
    const Real r1 = length(size), h1 = length(size), r2 = length(other), h2 = length(other);
    Frame f;
    const auto near = [&](Real reach) {
      const int where = any_of(random, 4);
      return where == 0   ? 0
             : where == 1 ? reach * random.uniform(-1, 1)
                          : (any_of(random, 2) ? 1 : -1) * reach * (1 + pick(random, kGaps));
    };
    f.p.y() = near(h1 + h2);
    const Real across = near(r1 + r2);
    const int way = any_of(random, 3);
    f.p.x() = way == 0 ? across : way == 1 ? 0 : 0.6 * across;
    f.p.z() = way == 0 ? 0 : way == 1 ? across : 0.8 * across;
    if (any_of(random, 2)) f.r = Mat3::diagonal(Vec3(1, -1, -1));
    const Long rho = length_of(f.p.x(), f.p.z()), y = std::fabs(Long(f.p.y())) - (Long(h1) + h2);
    const bool coaxial = rho < 1e-3 * (r1 + r2);
    switch (i % 6) {
      case 0:
        take(ExactPair("parallel capsules", capsule(r1, h1), capsule(r2, h2), f,
                       length_of(rho, std::max<Long>(0, y)) - (Long(r1) + r2)));
        break;
      case 1: {
        ExactPair pair("parallel cylinders", cylinder(r1, h1), cylinder(r2, h2), f,
                       product_distance(rho - (Long(r1) + r2), y));
        pair.ring = coaxial;
        take(std::move(pair));
        break;
      }
      case 2: {
        ExactPair pair("cylinder along capsule", cylinder(r1, h1), capsule(r2, h2), f,
                       product_distance(rho - Long(r1), y) - Long(r2));
        pair.ring = coaxial;
        take(std::move(pair));
        break;
      }
      case 3: {
        const Real depth = length(size);
        const Long x = std::fabs(Long(f.p.x())) - r1, z = std::fabs(Long(f.p.z())) - depth;
        take(ExactPair("box along capsule", box(Vec3(r1, h1, depth)), capsule(r2, h2), f,
                       box_distance(x, y, z) - Long(r2)));
        break;
      }
      case 4: {
        const Real depth = length(size);
        const Long x = std::fabs(Long(f.p.x())) - r1, z = std::fabs(Long(f.p.z())) - depth;
        ExactPair pair("box along cylinder", box(Vec3(r1, h1, depth)), cylinder(r2, h2), f,
                       product_distance(box_distance(x, z, -INFINITY) - Long(r2), y));
        pair.ring = std::max(r1, depth) + rho < 1e-2 * r2;  // a needle in the middle of a cylinder
        take(std::move(pair));
        break;
      }
      default: {  // both shortest along x: also in overlap, no direction is better than x
        const auto stretch = [&](Real s) { return s * random.uniform(1, 4); };
        const Vec3 a(r1, stretch(r1), stretch(r1)), b(r2, stretch(r2), stretch(r2));
        f.p = Vec3(near(r1 + r2), 0, 0);
        ExactPair pair("ellipsoids in line", ellipsoid(a), ellipsoid(b), f, std::fabs(Long(f.p.x())) - (Long(r1) + r2));
        pair.ring = f.p.x() == 0;
        take(std::move(pair));
      }
    }
  }
}

/// Any shape, any way up, over a face of a box: tips, rims, corners, edges and faces on a plane, above or below it.
inline void over_a_face(Random& random, int count, const Take& take) {
  for (int i = 0; i < count; ++i) {
    const Real size = pick(random, kSizes), other = any_of(random, 3) ? size : pick(random, kSizes);
    const Vec3 half(size * pick(random, kAspects), size * pick(random, kAspects), size * pick(random, kAspects));
    Shape b = extreme_shape(random, i % kExtremeKinds, other);
    Frame f;
    const int turn = any_of(random, 3);
    f.r = turn == 0 ? Mat3(random_rotation(random).matrix()) : quarter_turns(random);
    if (turn == 2) f.r = exp_map(std::pow(10.0, random.uniform(-15, -2)) * random.direction()).matrix() * f.r;
    Vec3 down = -f.rotate_inverse(Vec3(Vec3::unit_y()));
    const Vec3 lowest = support_point(b, down / down.norm()), turned = f.r * lowest;
    const Real gap = pick(random, kGaps) * (any_of(random, 2) ? size : half.y());
    f.p = Vec3{half.x() * random.uniform(-0.9, 0.9), half.y() + gap, half.z() * random.uniform(-0.9, 0.9)} - turned;
    Long at[3], beyond[3];
    for (int r = 0; r < 3; ++r) {
      at[r] = f.p[r];
      for (int c = 0; c < 3; ++c) at[r] += Long(f.r(r, c)) * lowest[c];
      beyond[r] = std::fabs(at[r]) - half[r];
    }
    ExactPair pair("over a face", any_of(random, 2) ? box(half) : box_as_hull(random, half), std::move(b), f, 0);
    pair.low = exact_bound(pair.a, pair.b, f, Vec3::unit_y());
    pair.high =
        box_distance(beyond[0], beyond[1], beyond[2]) + kSupportRounding * kUnitRoundoff * pair.b.bounding_radius;
    best_of_axes(beyond, at, pair);
    // The rounding of where it was put may let another face be the nearest: no answer known then.
    const Long slack = 64 * kUnitRoundoff * (size + pair.b.bounding_radius + f.p.abs().sum());
    if (pair.high - pair.low <= slack) take(std::move(pair));
  }
}

/// The farthest points of any two shapes along a direction, opposite each other with a gap: corner to corner, tip to
/// rim, edge to face.
inline void opposite_points(Random& random, int count, const Take& take) {
  for (int i = 0; i < count; ++i) {
    const Real size = pick(random, kSizes), other = any_of(random, 3) ? size : pick(random, kSizes);
    Shape a = extreme_shape(random, i % kExtremeKinds, size),
          b = extreme_shape(random, any_of(random, kExtremeKinds), other);
    Frame f;
    f.r = any_of(random, 2) ? Mat3(random_rotation(random).matrix()) : quarter_turns(random);
    const int which = any_of(random, 3);
    Vec3 n = which == 0   ? random.direction()
             : which == 1 ? Vec3(Vec3::unit(any_of(random, 3)) * (any_of(random, 2) ? 1 : -1))
                          : Vec3(f.r.col(any_of(random, 3)).normalized());
    const Vec3 back = -f.rotate_inverse(n);
    const Vec3 on_a = support_point(a, n), on_b = support_point(b, back / back.norm());
    const Real gap = std::fabs(pick(random, kGaps)) * std::min(size, other);
    f.p = on_a + gap * n - f.r * on_b;
    Long square = 0;
    for (int r = 0; r < 3; ++r) {
      Long v = Long(f.p[r]) - on_a[r];
      for (int c = 0; c < 3; ++c) v += Long(f.r(r, c)) * on_b[c];
      square += v * v;
    }
    ExactPair pair("opposite points", std::move(a), std::move(b), f, 0);
    pair.low = exact_bound(pair.a, pair.b, f, n);
    pair.high =
        std::sqrt(square) + kSupportRounding * kUnitRoundoff * (pair.a.bounding_radius + pair.b.bounding_radius);
    if (pair.low > 0) {
      pair.normal = n;
      pair.smallest = static_cast<Real>(pair.low);
    }
    take(std::move(pair));
  }
}

/// Boxes in overlap at any attitude, edges across edges and corners on edges among them: the best of the normals of
/// their faces and of the fans of their edges.
inline void crossed_boxes(Random& random, int count, const Take& take) {
  for (int i = 0; i < count; ++i) {
    const Real size = pick(random, kSizes), other = any_of(random, 3) ? size : size * pick(random, kAspects);
    const auto length = [&](Real s) { return s * pick(random, {1.0, 0.3, 1e-2, 1e-4}); };
    const Vec3 half_a(length(size), length(size), length(size)), half_b(length(other), length(other), length(other));
    Frame f;
    f.r = random_rotation(random).matrix();
    std::vector<Vec3> axes;
    bool parallel = false;
    for (int j = 0; j < 3; ++j) {
      axes.push_back(Vec3::unit(j));
      axes.push_back(f.r.col((j + 1) % 3).cross(f.r.col((j + 2) % 3)));
      for (int k = 0; k < 3; ++k) {
        axes.push_back(Vec3(Vec3::unit(j).cross(f.r.col(k))));
        parallel = parallel || axes.back().norm() < 1e-3;
      }
    }
    if (parallel) continue;
    ExactPair pair("crossed boxes", box(half_a), box(half_b), f, 0);
    const int where = any_of(random, 3);
    if (where == 1) pair.b_in_a.p = random.in_cube(1).times(half_a);
    if (where == 2) {
      const Vec3 n = axes[static_cast<std::size_t>(any_of(random, 15))].normalized();
      const Real gap = -std::fabs(pick(random, kGaps)) * std::min(size, other);
      pair.b_in_a.p = (gap - static_cast<Real>(exact_bound(pair.a, pair.b, f, n))) * n;
    }
    Long best = -INFINITY;
    for (const Vec3& n : axes)
      for (const Real sign : {1.0, -1.0}) best = std::max(best, exact_bound(pair.a, pair.b, pair.b_in_a, sign * n));
    pair.low = pair.high = best;
    // The axes are rounded, each off by 2 u / sin of the edges' angle from the best there is.
    pair.high += 2e3 * kUnitRoundoff * (pair.a.bounding_radius + pair.b.bounding_radius + pair.b_in_a.p.norm());
    if (pair.low < 0) take(std::move(pair));
  }
}

}  // namespace carom::test
