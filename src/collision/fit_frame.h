// An affine frame in which a convex set is about equally wide in every direction, found from its support function.
//
// Volume ratios, "worst facet" and "which point is outside which plane" do not change under affine maps; rounding does.
// A needle of aspect 1e8 has end faces of 1e-16 of its length squared, no more than noise; in its own frame it is as
// plump as a cube.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/vec.h"

namespace carom::collision {

struct FitFrame {
  Vec3 origin;       // m, a point of the set
  Mat3 to, from;     // y = to (x - origin), x = from y + origin; det(from) > 0
  Real determinant;  // of from, m^3
  Real extent;       // m, the largest width along an axis
  Real slack;        // bound of the rounding error of a mapped point, in y
  Vec3 start[4];     // x of four points of the set; in y their tetrahedron has the volume 1/6
  bool flat;         // thinner than rounding can tell: no frame; volume below
  Real flat_volume;  // m^3: upper bound of the volume of a flat set

  Vec3 map(const Vec3& x) const { return to * (x - origin); }
  /// Direction in x whose support point is the one for direction n in y.
  Vec3 pull_back(const Vec3& n) const { return to.transpose() * n; }
};

/// Fit a frame to a bounded convex set.
/// @param far    far(d, x): x becomes the point of the set farthest along d (shape frame, any length); false: failed
/// @return       false as soon as far fails
/// @accuracy     12 calls. In y the set lies within |y_1| <= sqrt 3, |y_2| <= sqrt 2, |y_3| <= 1. slack = 16 u
///               sum_j |to_ij| max|x_j|, worst i: the point is good to u |x_j|, the map adds three products and their
///               sums
template <class Far>
bool fit_frame(const Far& far, FitFrame& f) {
  Vec3 found[12];  // six along the axes, four across the longest pair, two across the plane of three
  for (int i = 0; i < 3; ++i)
    if (!far(Vec3(-Vec3::unit(i)), found[2 * i]) || !far(Vec3(Vec3::unit(i)), found[2 * i + 1])) return false;
  Vec3 width, reach, scale;
  for (int i = 0; i < 3; ++i) {
    const Real lo = found[2 * i][i], hi = found[2 * i + 1][i];
    width[i] = hi - lo;
    reach[i] = std::max(std::fabs(lo), std::fabs(hi));
  }
  f.origin = found[0];
  f.extent = width.max_entry();
  f.flat = true;
  f.flat_volume = width.max(Vec3::zero()).product();
  for (int i = 0; i < 3; ++i) {
    if (!(width[i] > 8 * kUnitRoundoff * reach[i])) return true;
    scale[i] = std::ldexp(Real(1), std::ilogb(width[i]) - 1);  // a power of two: scaling by it is exact
  }
  const auto z = [&](const Vec3& x) { return Vec3((x - f.origin).over(scale)); };  // widths in [2, 4)
  const auto far_z = [&](const Vec3& d, Vec3& x) { return far(Vec3(d.over(scale)), x); };
  const Real noise = 32 * kUnitRoundoff * (1 + reach.over(scale).max_entry());

  int a = 0, b = 1;
  for (int i = 0; i < 6; ++i)
    for (int j = i + 1; j < 6; ++j)
      if ((z(found[j]) - z(found[i])).squared_norm() > (z(found[b]) - z(found[a])).squared_norm()) a = i, b = j;
  f.origin = found[a];
  const Vec3 e1 = z(found[b]);
  const Vec3 axis = e1 / e1.norm(), across = any_perpendicular(axis), other = axis.cross(across);
  if (!far_z(across, found[6]) || !far_z(-across, found[7]) || !far_z(other, found[8]) || !far_z(-other, found[9]))
    return false;
  int c = 0;
  Real away = -1;
  for (int i = 0; i < 10; ++i) {
    const Real distance = axis.cross(z(found[i])).norm();
    if (distance > away) c = i, away = distance;
  }
  if (!(away > noise)) {  // a rod no longer than 7 and, across the two directions asked, no thicker than 2 noise
    f.flat_volume = std::min(f.flat_volume, 64 * noise * noise * scale.product());
    return true;
  }
  const Vec3 aside = z(found[c]) - axis.dot(z(found[c])) * axis, normal = axis.cross(aside / away);
  if (!far_z(normal, found[10]) || !far_z(-normal, found[11])) return false;
  int d = 0;
  Real off = -1;
  for (int i = 0; i < 12; ++i) {
    const Real distance = std::fabs(normal.dot(z(found[i])));
    if (distance > off) d = i, off = distance;
  }
  // No section of a 4 x 4 x 4 box is larger than 24.
  f.flat_volume = std::min(f.flat_volume, 2 * (off + noise) * 24 * scale.product());
  if (!(off > noise)) return true;

  f.flat = false;
  const Mat3 axes = Mat3::columns(e1, aside, off * normal);  // at right angles in z, as long as the set is wide
  f.from = scale_rows(scale, axes);
  const Vec3 squares(axes.col(0).squared_norm(), axes.col(1).squared_norm(), axes.col(2).squared_norm());
  f.to = scale_columns(scale_rows(squares.reciprocal(), axes.transpose()), scale.reciprocal());
  f.determinant = e1.norm() * away * off * scale.product();
  f.slack = 16 * kUnitRoundoff * (f.to.abs() * reach).max_entry();
  for (int i = 0; i < 4; ++i) f.start[i] = found[i == 0 ? a : i == 1 ? b : i == 2 ? c : d];
  return true;
}

}  // namespace carom::collision
