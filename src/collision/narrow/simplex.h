// The point of a simplex nearest to the origin: one question, three sub-algorithms, the same results.
#pragma once

#include "collision/narrow/query.h"

namespace carom::collision {

/// The feature of a simplex that holds its point v nearest to the origin.
///
/// `direction` points the way of v but is never computed from v: near contact v = sum(weight w) loses all its digits.
/// An edge gives ab x (a x ab), a face its normal with the sign of its offset; both keep right angles to the feature.
struct Nearest {
  bool inside = false;            // the origin is in the tetrahedron: v = 0, direction means nothing
  int count = 0;                  // vertices of the feature, 1..3 (4 if inside)
  int index[4] = {0, 0, 0, 0};    // [count] which of the points
  Real weight[4] = {1, 0, 0, 0};  // [count] >= 0, sum 1: v = sum(weight w)
  Vec3 direction = Vec3::zero();  // any length, zero if v = 0 and the feature is a vertex or an edge
  Real distance2 = kInfinity;     // |v|^2 as the feature's geometry gives it

  /// Nothing found yet; the rest stays as it is.
  void clear() {
    inside = false;
    count = 0;
    distance2 = kInfinity;
  }
};

/// @param w      [count][3] points, about unit size (|w| in 1e-60 .. 1e60); the last one is the newest
/// @param count  1..4
/// @return       the nearest feature; of a degenerate simplex its best lower feature
/// @oracle       tests/unit/collision/test_simplex
using SimplexSolver = void (*)(const Vec3* w, int count, Nearest& nearest);

/// Johnson's sub-algorithm, determinants from edge differences (products of points lose half the digits).
/// @source [vdBergen2003 §4.3]
void nearest_johnson(const Vec3* w, int count, Nearest& nearest);
/// Regions of all features, by geometry.
/// @source [Ericson2005 §5.1]
void nearest_voronoi(const Vec3* w, int count, Nearest& nearest);
/// Regions of the features that touch the newest point alone. In GJK the nearest point must lie there, up to rounding:
/// a caller that sees |v| fail to drop asks nearest_voronoi once before it gives up.
/// @source [Muratori2006]
void nearest_voronoi_last(const Vec3* w, int count, Nearest& nearest);

SimplexSolver simplex_solver(Simplex which);

}  // namespace carom::collision
