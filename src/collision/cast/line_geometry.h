// A line against up to four points swollen by a radius: the geometry under line.h.
//
// Coordinates: the line is the third axis, (0, 0, s). Two numbers of a point say where it stands seen along the line,
// the third how far along.
#pragma once

#include "collision/narrow/simplex_geometry.h"

namespace carom::collision::line {

inline Real cross2(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The feature of up to three points nearest to the line, seen along it.
struct Shadow {
  bool inside = false;  // the line goes through the triangle
  int count = 0;        // 1 or 2; 3 if inside
  int index[3] = {0, 1, 2};
  Vec2 direction = Vec2::zero();  // the way of the feature from the line, any length; square to an edge, no difference
                                  // of nearly equal numbers
  Real distance2 = kInfinity;
};

inline void offer_shadow(const Vec3* y, int i, int j, Shadow& shadow) {
  const Vec2 p = y[i].xy(), q = y[j].xy(), e = q - p;
  const Real along = -p.dot(e), length2 = e.squared_norm();
  Shadow found;
  if (along <= 0 || along >= length2) {
    const int k = along <= 0 ? i : j;
    found.count = 1;
    found.index[0] = k;
    found.direction = y[k].xy();
    found.distance2 = found.direction.squared_norm();
  } else {
    const Real side = cross2(p, e);
    found.count = 2;
    found.index[0] = i;
    found.index[1] = j;
    found.direction = side < 0 ? Vec2(-e.y(), e.x()) : Vec2(e.y(), -e.x());
    found.distance2 = side * side / length2;
  }
  if (found.distance2 < shadow.distance2) shadow = found;
}

inline Shadow nearest_shadow(const Vec3* y, int count) {
  Shadow shadow;
  if (count == 1) {
    shadow.count = 1;
    shadow.direction = y[0].xy();
    shadow.distance2 = shadow.direction.squared_norm();
  } else if (count == 2) {
    offer_shadow(y, 0, 1, shadow);
  } else {
    Real side[3];
    for (int i = 0; i < 3; ++i) {
      const int j = i == 2 ? 0 : i + 1;
      // From the point itself along the edge: an error of u |p| across the edge, however short the edge is.
      side[i] = cross2(y[i].xy(), Vec2(y[j].xy() - y[i].xy()));
    }
    const bool left = side[0] >= 0 && side[1] >= 0 && side[2] >= 0,
               right = side[0] <= 0 && side[1] <= 0 && side[2] <= 0;
    if (left != right) {  // both: no area at all
      shadow.inside = true;
      shadow.count = 3;
      shadow.distance2 = 0;
      return shadow;
    }
    for (int i = 0; i < 3; ++i) offer_shadow(y, i, i == 2 ? 0 : i + 1, shadow);
  }
  return shadow;
}

/// Where the line first comes within the radius of a feature.
struct Crossing {
  Real s = kInfinity;
  Vec3 normal = Vec3::unit_z();  // unit, from the line's point to the feature's; third component >= 0
  int count = 0;
  int index[3] = {0, 0, 0};
  Real weight[3] = {1, 0, 0};  // of the feature's point
};

inline void offer_vertex(const Vec3* y, int i, Real radius, Crossing& best) {
  const Real off = y[i].xy().norm();
  if (!(off <= radius)) return;
  const Real depth = std::sqrt((radius - off) * (radius + off));
  const Real s = y[i].z() - depth;
  if (!(s < best.s)) return;
  best.s = s;
  best.normal = Vec3(y[i].x(), y[i].y(), depth) / radius;
  best.count = 1;
  best.index[0] = i;
  best.weight[0] = 1;
}

/// The cylinder around edge ij. Its axis passes the line at a distance of `off`, seen along the line; a step back along
/// the line by `back` brings the distance to the radius.
inline void offer_edge(const Vec3* y, int i, int j, Real radius, Crossing& best) {
  const Vec3 e = y[j] - y[i];
  const Real flat2 = e.xy().squared_norm(), length2 = flat2 + e.z() * e.z();
  const Real side = cross2(y[i].xy(), e.xy());
  if (!(side * side <= radius * radius * flat2) || !(flat2 > 1e-30 * length2)) return;  // parallel: its ends will do
  const Real flat = std::sqrt(flat2), off = side / flat;
  const Real share = flat2 / length2;  // sin^2 of the angle between edge and line
  const Real back = std::sqrt((radius - off) * (radius + off) / share);
  const Real passing = -y[i].xy().dot(e.xy()) / flat2;  // weight of j where they pass
  const Real s = y[i].z() + passing * e.z() - back;
  const Real weight = passing - back * e.z() / length2;
  if (!(s < best.s) || !(weight >= 0 && weight <= 1)) return;
  best.s = s;
  const Vec3 across(e.y() / flat, -e.x() / flat, 0);
  const Vec3 up(-e.z() * e.x() / length2, -e.z() * e.y() / length2, share);
  const Vec3 n = off * across + back * up;  // both square to the edge
  best.normal = n / n.norm();
  best.count = 2;
  best.index[0] = i;
  best.index[1] = j;
  best.weight[0] = 1 - weight;
  best.weight[1] = weight;
}

/// Whether the line passes a triangle, seen along it, by more than the radius: its foot on the face, no farther from
/// the line than that, is then outside.
inline bool passes_by(const Vec2& a, const Vec2& b, const Vec2& c, Real radius) {
  const Vec2 ab = b - a, bc = c - b, ca = a - c;
  const Real side[3] = {cross2(a, ab), cross2(b, bc), cross2(c, ca)};
  const Real sign = side[0] + side[1] + side[2] < 0 ? -1 : 1, r2 = radius * radius;
  return (sign * side[0] < 0 && side[0] * side[0] > r2 * ab.squared_norm()) ||
         (sign * side[1] < 0 && side[1] * side[1] > r2 * bc.squared_norm()) ||
         (sign * side[2] < 0 && side[2] * side[2] > r2 * ca.squared_norm());
}

/// The face ijk, pushed towards the line's start by the radius.
inline void offer_face(const Vec3* y, int i, int j, int k, Real radius, Crossing& best) {
  // The radius is more than all rounding together: what is wrongly passed by is entered elsewhere as early.
  if (passes_by(y[i].xy(), y[j].xy(), y[k].xy(), radius)) return;
  const Vec3 raw = triangle_normal(y[i], y[j], y[k]);
  const Real length = raw.norm();
  if (!(std::fabs(raw.z()) > 1e-15 * length)) return;
  const Vec3 n = raw * ((raw.z() < 0 ? -1 : 1) / length);
  // Through the vertex nearest to the line, where the product has the smallest error.
  const Real li = y[i].xy().squared_norm(), lj = y[j].xy().squared_norm(), lk = y[k].xy().squared_norm();
  const Vec3& p = li <= lj ? (li <= lk ? y[i] : y[k]) : (lj <= lk ? y[j] : y[k]);
  const Real s = p.z() + (n.xy().dot(p.xy()) - radius) / n.z();
  if (!(s < best.s)) return;
  const Vec2 foot = radius * n.xy();
  const Vec2 a = y[i].xy() - foot, b = y[j].xy() - foot, c = y[k].xy() - foot;
  const Real sign = raw.z() < 0 ? -1 : 1;
  const Real wi = sign * cross2(b, Vec2(c - b)), wj = sign * cross2(c, Vec2(a - c)), wk = sign * cross2(a, Vec2(b - a));
  if (!(wi >= 0 && wj >= 0 && wk >= 0)) return;
  const Real sum = wi + wj + wk;
  if (!(sum > 0)) return;
  best.s = s;
  best.normal = n;
  best.count = 3;
  best.index[0] = i;
  best.index[1] = j;
  best.index[2] = k;
  best.weight[0] = wi / sum;
  best.weight[1] = wj / sum;
  best.weight[2] = wk / sum;
}

/// First crossing of the hull of up to four points, swollen: a swollen simplex is the union of what surrounds its
/// vertices, edges and faces.
/// @param newest  only features of the last point
inline Crossing first_crossing(const Vec3* y, int count, Real radius, bool newest) {
  Crossing best;
  const int last = count - 1;
  for (int i = newest ? last : 0; i < count; ++i) offer_vertex(y, i, radius, best);
  for (int j = newest ? last : 1; j < count; ++j)
    for (int i = 0; i < j; ++i) offer_edge(y, i, j, radius, best);
  for (int k = newest ? last : 2; k < count; ++k)
    for (int j = 1; j < k; ++j)
      for (int i = 0; i < j; ++i) offer_face(y, i, j, k, radius, best);
  return best;
}

}  // namespace carom::collision::line
