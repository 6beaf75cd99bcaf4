// The simplex sub-algorithm by Voronoi regions: all features, or only those that touch the newest point.
#include "collision/narrow/simplex_geometry.h"

namespace carom::collision {

namespace {

/// A volume that is rounding (three products of edge lengths, u each, a few times over) has no inside: the origin may
/// then be outside every face.
bool is_flat(Real volume, Real da2, Real db2, Real dc2) {
  constexpr Real kFlat = 16 * kUnitRoundoff;
  return !(volume * volume > kFlat * kFlat * (da2 * db2 * dc2));
}

/// An edge from the newest point.
struct Spoke {
  Vec3 edge;    // to its other end
  Vec3 moment;  // newest x edge: its dot product with a face's normal tells on which side of the edge the origin is
  Real length2;

  Spoke(const Vec3& newest, const Vec3& end)
      : edge(end - newest), moment(newest.cross(edge)), length2(edge.squared_norm()) {}
};

/// The face of newest point k and two spokes, without the edge that faces k: its interior, or word that the origin is
/// beyond a spoke.
/// @param cross   to_i.edge x to_j.edge
/// @param beyond  in and out: bit i, the edge to i is to be looked at
void offer_wedge(const Vec3* w, int i, int j, int k, const Spoke& to_i, const Spoke& to_j, const Vec3& cross,
                 unsigned& beyond, Nearest& nearest) {
  const bool wide = cross.squared_norm() > kWideAngle2 * (to_i.length2 * to_j.length2);
  const Vec3 normal = wide ? cross : triangle_normal(w[i], w[j], w[k]);
  const Real area_i = -normal.dot(to_j.moment), area_j = normal.dot(to_i.moment);
  const bool beyond_j = !(area_i > 0), beyond_i = !(area_j > 0);
  if (!(beyond_i | beyond_j))
    return offer_inner_face(w, i, j, k, normal, {area_i, area_j, projected_area(w[i], w[j], normal)}, nearest);
  beyond |= unsigned{beyond_i} << i | unsigned{beyond_j} << j;
}

void offer_spokes(const Vec3* w, int newest, unsigned beyond, Nearest& nearest) {
  for (int i = 0; i < newest; ++i)
    if (beyond >> i & 1) offer_edge(w, i, newest, nearest);
}

}  // namespace

void nearest_voronoi(const Vec3* w, int count, Nearest& nearest) {
  nearest.clear();
  switch (count) {
    case 1:
      return offer_vertex(w, 0, nearest);
    case 2:
      return offer_edge(w, 0, 1, nearest);
    case 3:
      return offer_face(w, 0, 1, 2, nearest);
    default:
      break;
  }
  const Vec3 &a = w[0], &b = w[1], &c = w[2], &d = w[3];
  const Vec3 da = a - d, db = b - d, dc = c - d;
  const Real bcd = db.cross(dc).dot(d), cad = dc.cross(da).dot(d), abd = da.cross(db).dot(d),
             abc = (b - a).cross(c - a).dot(a), volume = da.cross(db).dot(dc);
  // For a positive volume the first three normals point inwards: the origin is outside where the plane's offset is
  // positive.
  const bool flat = is_flat(volume, da.squared_norm(), db.squared_norm(), dc.squared_norm());
  const Real sign = volume > 0 ? 1 : -1;
  const bool out_bcd = flat || sign * bcd > 0, out_cad = flat || sign * cad > 0, out_abd = flat || sign * abd > 0,
             out_abc = flat || sign * abc < 0;
  if (!(out_bcd | out_cad | out_abd | out_abc))
    return set_inside(-sign * bcd, -sign * cad, -sign * abd, sign * abc, nearest);
  if (out_bcd) offer_face(w, 1, 2, 3, nearest);
  if (out_cad) offer_face(w, 2, 0, 3, nearest);
  if (out_abd) offer_face(w, 0, 1, 3, nearest);
  if (out_abc) offer_face(w, 0, 1, 2, nearest);
}

void nearest_voronoi_last(const Vec3* w, int count, Nearest& nearest) {
  nearest.clear();
  unsigned beyond = 0;
  switch (count) {
    case 1:
      return offer_vertex(w, 0, nearest);
    case 2:
      return offer_edge(w, 0, 1, nearest);
    case 3: {
      const Spoke to_a(w[2], w[0]), to_b(w[2], w[1]);
      offer_wedge(w, 0, 1, 2, to_a, to_b, to_a.edge.cross(to_b.edge), beyond, nearest);
      return offer_spokes(w, 2, beyond, nearest);
    }
    default:
      break;
  }
  const Vec3 &a = w[0], &b = w[1], &c = w[2], &d = w[3];
  const Spoke to_a(d, a), to_b(d, b), to_c(d, c);
  const Vec3 dab = to_a.edge.cross(to_b.edge), dbc = to_b.edge.cross(to_c.edge), dca = to_c.edge.cross(to_a.edge);
  const Real volume = dab.dot(to_c.edge);
  const bool flat = is_flat(volume, to_a.length2, to_b.length2, to_c.length2);
  const Real sign = volume > 0 ? 1 : -1, bcd = sign * dbc.dot(d), cad = sign * dca.dot(d), abd = sign * dab.dot(d);
  const bool out_bcd = flat || bcd > 0, out_cad = flat || cad > 0, out_abd = flat || abd > 0;
  if (!(out_bcd | out_cad | out_abd)) return set_inside(-bcd, -cad, -abd, sign * (b - a).cross(c - a).dot(a), nearest);
  if (out_bcd) offer_wedge(w, 1, 2, 3, to_b, to_c, dbc, beyond, nearest);
  if (out_cad) offer_wedge(w, 2, 0, 3, to_c, to_a, dca, beyond, nearest);
  if (out_abd) offer_wedge(w, 0, 1, 3, to_a, to_b, dab, beyond, nearest);
  offer_spokes(w, 3, beyond, nearest);
}

SimplexSolver simplex_solver(Simplex which) {
  switch (which) {
    case Simplex::johnson:
      return nearest_johnson;
    case Simplex::voronoi:
      return nearest_voronoi;
    default:
      return nearest_voronoi_last;
  }
}

}  // namespace carom::collision
