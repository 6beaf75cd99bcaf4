// Johnson's simplex sub-algorithm: cofactors of all subsets, from edge differences.
//
// For a subset Y of the points, the point of its affine hull nearest to the origin is sum(delta_i w_i) / sum(delta_i)
// with
//   delta_i({i}) = 1,    delta_j(Y + j) = sum over i in Y of  delta_i(Y) (w_i . (w_k - w_j)),   any k in Y.
// The textbook's w_i.w_k - w_i.w_j subtracts two large numbers; the difference of points is taken first here, and k is
// the vertex of Y nearest to j, so that the difference is as short as can be.
#include "collision/narrow/simplex_geometry.h"

namespace carom::collision {

namespace {

constexpr int kSubsets = 16;
constexpr int kBySize[15] = {1, 2, 4, 8, 3, 5, 9, 6, 10, 12, 7, 11, 13, 14, 15};

/// A cofactor that is no larger than its own rounding is zero: where points depend on each other its sign would be
/// noise, and noise that happens to be positive would let a subset win with shares that mean nothing.
struct Cofactors {
  Real delta[kSubsets][4];
  Real error[kSubsets][4];
};

void fill(const Vec3* w, int count, Cofactors& c) {
  Real edge[4][4], length[4];
  for (int i = 0; i < count; ++i) {
    length[i] = w[i].norm();
    for (int j = 0; j < i; ++j) edge[i][j] = edge[j][i] = (w[i] - w[j]).norm();
    c.delta[1 << i][i] = 1;
    c.error[1 << i][i] = 0;
  }
  const int all = (1 << count) - 1;
  for (const int y : kBySize) {
    if (y >= all) continue;
    for (int j = 0; j < count; ++j) {
      if (y >> j & 1) continue;
      int k = -1;
      for (int i = 0; i < count; ++i)
        if ((y >> i & 1) && (k < 0 || edge[i][j] < edge[k][j])) k = i;
      const Vec3 difference = w[k] - w[j];
      Real sum = 0, error = 0;
      for (int i = 0; i < count; ++i) {
        if (!(y >> i & 1)) continue;
        const Real product = w[i].dot(difference);
        sum += c.delta[y][i] * product;
        // Six roundings in the product, one in the multiplication, one in the sum.
        error +=
            c.error[y][i] * std::fabs(product) + 8 * kUnitRoundoff * std::fabs(c.delta[y][i]) * length[i] * edge[k][j];
      }
      c.delta[y | 1 << j][j] = std::fabs(sum) > error ? sum : 0;
      c.error[y | 1 << j][j] = error;
    }
  }
}

/// All points of the subset have a positive share: its nearest point lies inside it.
bool proper(const Cofactors& c, int y, int count) {
  for (int i = 0; i < count; ++i)
    if ((y >> i & 1) && !(c.delta[y][i] > 0)) return false;
  return true;
}

/// No point outside the subset would bring it nearer.
bool final_subset(const Cofactors& c, int y, int count) {
  for (int j = 0; j < count; ++j)
    if (!(y >> j & 1) && c.delta[y | 1 << j][j] > 0) return false;
  return true;
}

void put_nearest(const Vec3* w, int y, const Cofactors& c, Nearest& nearest) {
  int index[4], n = 0;
  for (int i = 0; i < 4; ++i)
    if (y >> i & 1) index[n++] = i;
  switch (n) {
    case 1:
      offer_vertex(w, index[0], nearest);
      break;
    case 2: {
      const Vec3 edge = w[index[1]] - w[index[0]];
      offer_inner_edge(w, index[0], index[1], edge, c.delta[y][index[1]], edge.squared_norm(), nearest);
      break;
    }
    case 3:
      offer_inner_face(w, index[0], index[1], index[2], triangle_normal(w[index[0]], w[index[1]], w[index[2]]),
                       {c.delta[y][index[0]], c.delta[y][index[1]], c.delta[y][index[2]]}, nearest);
      break;
    default:
      set_inside(c.delta[y][0], c.delta[y][1], c.delta[y][2], c.delta[y][3], nearest);
  }
}

}  // namespace

void nearest_johnson(const Vec3* w, int count, Nearest& nearest) {
  nearest.clear();
  Cofactors c;
  fill(w, count, c);
  const int all = (1 << count) - 1;
  for (const int y : kBySize) {
    if (y > all || (y & ~all)) continue;
    if (proper(c, y, count) && final_subset(c, y, count)) return put_nearest(w, y, c, nearest);
  }
  // Rounding left no subset that satisfies every sign (degenerate simplex): the nearest of the proper ones, as in
  // SOLID's backup procedure. A tetrahedron is never among them: it would have passed above.
  for (const int y : kBySize) {
    if (y > all || y == 15 || !proper(c, y, count)) continue;
    put_nearest(w, y, c, nearest);
  }
}

}  // namespace carom::collision
