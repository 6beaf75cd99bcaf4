// The simplex sub-algorithm by Voronoi regions: all features, or only those that touch the newest point.
#include "collision/narrow/simplex_geometry.h"

namespace carom {

namespace {

/// @tparam kAll  false: only features that touch the newest point
template <bool kAll>
void nearest_by_regions(const Vec3* w, int count, Nearest& nearest) {
  nearest.clear();
  switch (count) {
    case 1:
      return offer_vertex(w, 0, nearest);
    case 2:
      return offer_edge(w, 0, 1, nearest);
    case 3:
      return offer_face<kAll>(w, 0, 1, 2, nearest);
    default:
      break;
  }
  const Vec3 &a = w[0], &b = w[1], &c = w[2], &d = w[3];
  const Vec3 da = a - d, db = b - d, dc = c - d;
  const Vec3 dab = da.cross(db), dbc = db.cross(dc), dca = dc.cross(da);
  const Real volume = dab.dot(dc);
  // A volume that is rounding (three products of edge lengths, u each, a few times over) has no inside: the origin may
  // then be outside every face.
  constexpr Real kFlat = 16 * kUnitRoundoff;
  const Real size2 = da.squaredNorm() * db.squaredNorm() * dc.squaredNorm();
  const bool flat = !(volume * volume > kFlat * kFlat * size2);
  // For a positive volume these three normals point inwards: the origin is outside where the plane's offset is
  // positive.
  const Real sign = volume > 0 ? 1 : -1;
  const bool out_bcd = flat || sign * dbc.dot(d) > 0, out_cad = flat || sign * dca.dot(d) > 0,
             out_abd = flat || sign * dab.dot(d) > 0;
  const bool out_abc = kAll && (flat || sign * (b - a).cross(c - a).dot(a) < 0);
  if (!(out_bcd | out_cad | out_abd | out_abc)) {
    return answer_inside(-sign * dbc.dot(d), -sign * dca.dot(d), -sign * dab.dot(d), sign * (b - a).cross(c - a).dot(a),
                         nearest);
  }
  if (out_bcd) offer_face<kAll>(w, 1, 2, 3, nearest);
  if (out_cad) offer_face<kAll>(w, 2, 0, 3, nearest);
  if (out_abd) offer_face<kAll>(w, 0, 1, 3, nearest);
  if (out_abc) offer_face<kAll>(w, 0, 1, 2, nearest);
}

}  // namespace

void nearest_voronoi(const Vec3* w, int count, Nearest& nearest) { nearest_by_regions<true>(w, count, nearest); }

void nearest_voronoi_last(const Vec3* w, int count, Nearest& nearest) { nearest_by_regions<false>(w, count, nearest); }

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

}  // namespace carom
