// Where the friction of a patch may lie: a force f in its plane and a twist w about its normal n, as one vector
// z = f + (w / reach) n, reach being how far from the middle the patch presses in the mean. With x = |f| / most and
// y = |w| / (reach most),
//
//     x^2 + y^2 + c x^2 y^2 <= 1
//
// is the bound that sweeps in lanes have (lane_friction.h) for what slides. What sticks has x <= 1 and y <= 1 apart, so that it
// does not matter where its loads lie.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/vec.h"
#include "dynamics/solver/sweep_constants.h"

namespace carom::dynamics {

/// The nearest point (X, Y) of the bound to (x, y), both at least 0.
struct NearestOfBound {
  Real x, y;
  Real X, Y;
  bool is_inside;

  NearestOfBound(Real to_x, Real to_y) : x(to_x), y(to_y) {
    constexpr Real kFar = 1e8;  // beyond, it is the direction that counts, and squares may be beyond all numbers
    if (const Real most = std::max(x, y); most > kFar) x = x / most * kFar, y = y / most * kFar;
    X = x, Y = y;
    const Real x2 = x * x, y2 = y * y, sum = x2 + y2;
    is_inside = sum + kBend * x2 * y2 <= 1;
    if (is_inside) return;
    if (y == 0)
      X = 1;
    else if (x == 0)
      Y = 1;
    else
      find();
  }

  /// z - p over half the gradient of the bound.
  Real multiplier() const {
    const Real g_x = X * (1 + kBend * Y * Y), g_y = Y * (1 + kBend * X * X);
    return ((x - X) * g_x + (y - Y) * g_y) / (g_x * g_x + g_y * g_y);
  }

  static constexpr Real kBend = kPatchBend.value;

 private:
  /// Newton's method along the bound for what is left across its normal, from where the line to the middle meets it.
  void find() {
    constexpr int kSteps = 8;
    constexpr Real kClose = 1e-8;  // its square is rounding
    bring_back(x, y);
    for (int i = 0; i < kSteps; ++i) {
      const Real h_xx = 1 + kBend * Y * Y, h_yy = 1 + kBend * X * X, h_xy = 2 * kBend * X * Y;
      const Real g_x = X * h_xx, g_y = Y * h_yy, dx = x - X, dy = y - Y;
      const Real left = dx * g_y - dy * g_x;
      const Real slope = g_x * g_x + g_y * g_y + dy * (h_xx * g_y - h_xy * g_x) - dx * (h_xy * g_y - h_yy * g_x);
      const Real way = left / slope;
      bring_back(std::max(X + way * g_y, Real(0)), std::max(Y - way * g_x, Real(0)));
      if (way * way * (g_x * g_x + g_y * g_y) <= kClose * kClose) break;
    }
  }
  void bring_back(Real to_x, Real to_y) {
    const Real x2 = to_x * to_x, y2 = to_y * to_y, sum = x2 + y2;
    const Real per = 1 / std::sqrt((sum + std::sqrt(sum * sum + 4 * kBend * x2 * y2)) / 2);
    X = per * to_x, Y = per * to_y;
  }
};

/// A bound for a load.
struct PatchBound {
  Vec3 n;       // unit
  Real most;    // N s, of a force without a twist; at least 0
  bool slides;  // else force and twist are bounded apart
};

/// By what something is multiplied to be no more than most.
inline Real shortened(Real size, Real most) { return size > most ? most / size : Real(1); }

/// The point of the bound nearest to z.
inline Vec3 project_on_bound(const Vec3& z, const PatchBound& bound) {
  const Vec3& n = bound.n;
  const Real most = bound.most, most2 = most * most;
  if (!(most2 > 0)) return Vec3::zero();
  const Real w = z.dot(n);
  const Vec3 f = z - w * n;
  if (!bound.slides) {
    const Real size = f.norm();
    if (size <= most && std::fabs(w) <= most) return z;
    return shortened(size, most) * f + (shortened(std::fabs(w), most) * w) * n;
  }
  const Real f2 = f.squared_norm(), x2 = f2 / most2, y2 = w * w / most2;
  if (x2 + y2 + NearestOfBound::kBend * x2 * y2 <= 1) return z;
  const Real size = std::sqrt(f2);
  const NearestOfBound at(size / most, std::fabs(w) / most);
  return (size > 0 ? most * at.X / size : Real(0)) * f + (w > 0 ? most * at.Y : -most * at.Y) * n;
}

/// d project_on_bound / dz: symmetric, eigenvalues within [0, 1]; identity within.
inline Mat3 slope_on_bound(const Vec3& z, const PatchBound& bound) {
  const Vec3& n = bound.n;
  const Real most = bound.most;
  if (!(most * most > 0)) return Mat3::zero();
  const Real w = z.dot(n);
  const Vec3 f = z - w * n;
  const Real size = f.norm();
  if (!bound.slides) {
    const Mat3 twist = std::fabs(w) <= most ? outer(n, n) : Mat3(Mat3::zero());
    if (size <= most) return twist + (Mat3::identity() - outer(n, n));
    const Vec3 aside = n.cross(f) / size;
    return twist + outer((most / size) * aside, aside);
  }
  const NearestOfBound at(size / most, std::fabs(w) / most);
  if (at.is_inside) return Mat3::identity();
  const Real lambda = at.multiplier();
  const Real h_xx = 1 + NearestOfBound::kBend * at.Y * at.Y, h_yy = 1 + NearestOfBound::kBend * at.X * at.X,
             h_xy = 2 * NearestOfBound::kBend * at.X * at.Y;
  const Real round = 1 / (1 + lambda * h_xx);  // of what goes across the force in the plane
  constexpr Real kRounding = 1e-12;            // a force that is but rounding has no direction
  if (!(size > kRounding * std::fabs(w))) return round * (Mat3::identity() - outer(n, n));
  const Real g_x = at.X * h_xx, g_y = at.Y * h_yy, g = std::sqrt(g_x * g_x + g_y * g_y);
  const Real t_x = g_y / g, t_y = -g_x / g;
  const Real bent = 1 + lambda * (t_x * (h_xx * t_x + h_xy * t_y) + t_y * (h_xy * t_x + h_yy * t_y));
  const Vec3 along = f / size, tangent = t_x * along + (w > 0 ? t_y : -t_y) * n, aside = n.cross(along);
  return outer((1 / bent) * tangent, tangent) + outer(round * aside, aside);
}

/// N s, the least bound that z lies within.
inline Real gauge_of_bound(const Vec3& z, const Vec3& n, bool slides) {
  const Real w = z.dot(n), w2 = w * w, f2 = std::max(Real(0), z.squared_norm() - w2), sum = w2 + f2;
  if (!slides) return std::sqrt(std::max(w2, f2));
  return std::sqrt((sum + std::sqrt(sum * sum + 4 * NearestOfBound::kBend * f2 * w2)) / 2);
}

/// A patch along a line of z, as search directions go.
struct BoundLine {
  Real w0, w1;           // N s, along the normal: w0 + length w1
  Real f00, f01, f11;    // (N s)^2, squares and product across it
  Real d_w, d_f0, d_f1;  // of the direction d, with the normal, and with both

  /// @param z1  change of z   @param d  along which the impulse counts
  BoundLine(const Vec3& z0, const Vec3& z1, const Vec3& d, const Vec3& n) {
    w0 = z0.dot(n), w1 = z1.dot(n), d_w = d.dot(n);
    const Vec3 f0 = z0 - w0 * n, f1 = z1 - w1 * n;
    f00 = f0.squared_norm(), f01 = f0.dot(f1), f11 = f1.squared_norm();
    d_f0 = d.dot(f0), d_f1 = d.dot(f1);
  }
  BoundLine() = default;
  /// J, d . P(z0 + length z1)
  Real gain(const PatchBound& bound, Real length) const {
    const Real most = bound.most;
    const Real w = w0 + length * w1, f2 = std::max(Real(0), f00 + length * (2 * f01 + length * f11));
    const Real d_f = d_f0 + length * d_f1;
    if (!bound.slides) return shortened(std::sqrt(f2), most) * d_f + d_w * (shortened(std::fabs(w), most) * w);
    const Real most2 = most * most, x2 = f2 / most2, y2 = w * w / most2;
    if (x2 + y2 + NearestOfBound::kBend * x2 * y2 <= 1) return d_f + d_w * w;
    const Real size = std::sqrt(f2);
    const NearestOfBound at(size / most, std::fabs(w) / most);
    return (size > 0 ? most * at.X / size : Real(0)) * d_f + d_w * (w > 0 ? most * at.Y : -most * at.Y);
  }
};

}  // namespace carom::dynamics
