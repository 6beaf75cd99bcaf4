// Edges and faces seen from the origin: the arithmetic that the simplex sub-algorithms and EPA share.
#pragma once

#include "collision/narrow/simplex.h"
#include "core/multiply_add.h"

namespace carom::collision {

/// a b - c d with an error of 2 ulp of the result, whatever cancels, unless products over- or underflow.
/// @source Kahan's difference of products, see [Jeannerod2013]
inline Real difference_of_products(Real a, Real b, Real c, Real d) {
  const Exact cd = splits(c, d, 0) ? exact_product(c, d) : Exact{c * d, 0};
  return multiply_add(a, b, -cd.value) - cd.lost;
}

inline Vec3 accurate_cross(const Vec3& a, const Vec3& b) {
  return Vec3(difference_of_products(a.y(), b.z(), a.z(), b.y()), difference_of_products(a.z(), b.x(), a.x(), b.z()),
              difference_of_products(a.x(), b.y(), a.y(), b.x()));
}

/// Plain products err by u |a| |b|, which tilts a cross product by u / sin(a, b): below sin = 1e-3 the slow form is
/// worth it.
inline constexpr Real kNearlyParallel2 = 1e-6;

/// Square of the sine, 1/32, of a wide angle: plain products tilt the normal between such edges by 32 u at most.
inline constexpr Real kWideAngle2 = 0x1p-10;

/// Cross product that keeps its direction when a and b are nearly parallel.
inline Vec3 careful_cross(const Vec3& a, const Vec3& b) {
  const Vec3 n = a.cross(b);
  if (n.squared_norm() > kNearlyParallel2 * (a.squared_norm() * b.squared_norm())) return n;
  return accurate_cross(a, b);
}

/// Normal of a triangle, (b - a) x (c - a) in length and sense, from its two shorter edges.
/// @param longest2  out: squared length of the third
inline Vec3 triangle_normal(const Vec3& a, const Vec3& b, const Vec3& c, Real& longest2) {
  const Vec3 ab = b - a, bc = c - b, ca = a - c;
  const Real lab = ab.squared_norm(), lbc = bc.squared_norm(), lca = ca.squared_norm();
  // The edges before and after the corner that faces the longest edge.
  const bool at_a = lbc >= lab && lbc >= lca, at_b = !at_a && lca >= lab;
  const Vec3 &in = at_a ? ca : (at_b ? ab : bc), &out = at_a ? ab : (at_b ? bc : ca);
  const Real shorter2 = at_a ? lca * lab : (at_b ? lab * lbc : lbc * lca);
  longest2 = at_a ? lbc : (at_b ? lca : lab);
  const Vec3 n = in.cross(out);
  if (n.squared_norm() > kNearlyParallel2 * shorter2) return n;
  return accurate_cross(in, out);
}

inline Vec3 triangle_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  Real longest2;
  return triangle_normal(a, b, c, longest2);
}

/// Vertex i, if it is nearer than what stands in `nearest`; so with the edge and the face below.
inline void offer_vertex(const Vec3* w, int i, Nearest& nearest) {
  const Real distance2 = w[i].squared_norm();
  if (!(distance2 < nearest.distance2)) return;
  nearest.count = 1;
  nearest.index[0] = i;
  nearest.weight[0] = 1;
  nearest.direction = w[i];
  nearest.distance2 = distance2;
}

/// The interior of edge ij; the caller knows that the origin projects there.
/// @param along  -w_i . (w_j - w_i), in (0, length2)
inline void offer_inner_edge(const Vec3* w, int i, int j, const Vec3& edge, Real along, Real length2,
                             Nearest& nearest) {
  // Measured from the nearer end: a x ab then has the smaller error.
  const Vec3 offset = careful_cross(along + along < length2 ? w[i] : w[j], edge);
  const Real distance2 = offset.squared_norm() / length2;
  if (!(distance2 < nearest.distance2)) return;
  nearest.count = 2;
  nearest.index[0] = i;
  nearest.index[1] = j;
  const Real t = along / length2;
  nearest.weight[0] = 1 - t;
  nearest.weight[1] = t;
  nearest.direction = edge.cross(offset);
  nearest.distance2 = distance2;
}

/// Edge ij with its ends: keeps the result if it is nearer than what stands in `nearest`.
inline void offer_edge(const Vec3* w, int i, int j, Nearest& nearest) {
  const Vec3 edge = w[j] - w[i];
  const Real from_i = -w[i].dot(edge), from_j = w[j].dot(edge);
  if (from_i <= 0) {
    offer_vertex(w, i, nearest);
  } else if (from_j <= 0) {
    offer_vertex(w, j, nearest);
  } else {
    offer_inner_edge(w, i, j, edge, from_i, edge.squared_norm(), nearest);
  }
}

/// Weights of the origin's projection onto the plane of a triangle, up to the common factor |normal|^2.
struct Areas {
  Real i, j, k;
};
/// The weight of the vertex that faces edge pq.
inline Real projected_area(const Vec3& p, const Vec3& q, const Vec3& normal) { return normal.dot(p.cross(q - p)); }

/// The interior of face ijk; the caller knows that the origin projects there, so negative areas are rounding.
inline void offer_inner_face(const Vec3* w, int i, int j, int k, const Vec3& normal, Areas area, Nearest& nearest) {
  // Through the vertex nearest to the origin, where the product has the smallest error.
  const Real li = w[i].squared_norm(), lj = w[j].squared_norm(), lk = w[k].squared_norm();
  const Vec3& p = li <= lj ? (li <= lk ? w[i] : w[k]) : (lj <= lk ? w[j] : w[k]);
  const Real offset = normal.dot(p), distance2 = offset * offset / normal.squared_norm();
  if (!(distance2 < nearest.distance2)) return;
  area.i = area.i > 0 ? area.i : 0;
  area.j = area.j > 0 ? area.j : 0;
  area.k = area.k > 0 ? area.k : 0;
  const Real scale = 1 / (area.i + area.j + area.k);
  nearest.count = 3;
  nearest.index[0] = i;
  nearest.index[1] = j;
  nearest.index[2] = k;
  nearest.weight[0] = area.i * scale;
  nearest.weight[1] = area.j * scale;
  nearest.weight[2] = area.k * scale;
  nearest.direction = offset < 0 ? Vec3(-normal) : normal;
  nearest.distance2 = distance2;
}

/// Face ijk with its edges and vertices: keeps the result if nearer.
inline void offer_face(const Vec3* w, int i, int j, int k, Nearest& nearest) {
  const Vec3 normal = triangle_normal(w[i], w[j], w[k]);
  const Areas area = {projected_area(w[j], w[k], normal), projected_area(w[k], w[i], normal),
                      projected_area(w[i], w[j], normal)};
  const bool out_jk = !(area.i > 0), out_ki = !(area.j > 0), out_ij = !(area.k > 0);
  if (!(out_jk | out_ki | out_ij)) return offer_inner_face(w, i, j, k, normal, area, nearest);
  if (out_jk) offer_edge(w, j, k, nearest);
  if (out_ki) offer_edge(w, k, i, nearest);
  if (out_ij) offer_edge(w, i, j, nearest);
}

/// The tetrahedron itself. The volumes of the origin with each opposite face are its weights: that they give a v of
/// about zero is what proves the claim.
inline void set_inside(Real of_a, Real of_b, Real of_c, Real of_d, Nearest& nearest) {
  const Real volume[4] = {of_a, of_b, of_c, of_d > 0 ? of_d : 0};
  const Real scale = 1 / (volume[0] + volume[1] + volume[2] + volume[3]);
  nearest.inside = true;
  nearest.count = 4;
  for (int i = 0; i < 4; ++i) {
    nearest.index[i] = i;
    nearest.weight[i] = volume[i] * scale;
  }
  nearest.direction.set_zero();
  nearest.distance2 = 0;
}

}  // namespace carom::collision
