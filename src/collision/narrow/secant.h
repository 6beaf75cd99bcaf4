// Guesses of the direction that attains the distance of a curved difference, from the last three looks at it.
#pragma once

#include "collision/shape.h"

namespace carom::collision {

/// When to guess. Facets have nothing to extrapolate, a smooth difference nearly always has; between the two the walk
/// is watched. @see Secant
struct GuessPolicy {
  int patience;  // plain steps before the first guess and after each that failed; negative: never guess
  bool watch;    // guess only where the last looks converge

  /// From the declared forms alone. A core without volume counts by its own shape: a sphere's is a point.
  static bool faceted(Form f) {
    return f == Form::sphere || f == Form::capsule || f == Form::box || f == Form::polytope;
  }
  static bool smooth(Form f) { return f == Form::ellipsoid || f == Form::sphere; }
  static GuessPolicy of(const Shape& a, const Shape& b) {
    if (faceted(a.form) && faceted(b.form)) return {-1, true};
    if (smooth(a.form) && smooth(b.form)) return {2, false};
    // Pairs with facets or edges, declared or not, are mostly done after five steps: fewer cost hulls a step in ten,
    // more leave curved pairs on the slow walk (steps of hull32 / ellipsoid, undeclared: 3: 6.1 / 7.7, 4: 5.9 / 7.8,
    // 5: 5.8 / 8.1, never: 5.6 / 13.6).
    return {4, true};
  }
};

/// Where a surface is smooth, its support point w moves smoothly with the direction n, and at the direction sought w is
/// parallel to n: the residual r(n) = w - (n . w) n vanishes there. Three looks give a linear model of r on the plane
/// of directions, and the model's root is the guess. Its error falls superlinearly where plain GJK's falls by a
/// constant factor. A guess proves nothing and risks nothing: who follows it gets a plane that supports and a point
/// that exists.
/// @source  the secant method in two unknowns, as the affine mix of looks with the least residual [Anderson1965]
/// @oracle  tests/unit/collision/test_gjk
class Secant {
 public:
  /// @param n      unit, looked along
  /// @param value  n . w
  void remember(const Vec3& n, const Vec3& w, Real value) {
    newest_ = newest_ == 2 ? 0 : newest_ + 1;
    n_[newest_] = n;
    r_[newest_] = w - value * n;
    if (known_ < 3) ++known_;
  }

  /// @param watch  refuse unless the last look halved the residual and the guess stays within the last stride
  /// @param n      out: unit
  /// @return       false if the looks say nothing about a root nearby
  bool guess(bool watch, Vec3& n) const {
    if (known_ < 3) return false;
    const int before = newest_ == 0 ? 2 : newest_ - 1, oldest = 3 - newest_ - before;
    const Vec3 &n0 = n_[newest_], &r0 = r_[newest_];
    if (watch && !(r0.squared_norm() < 0.25 * r_[before].squared_norm())) return false;
    const Vec3 u = r_[before] - r0, v = r_[oldest] - r0;
    const Real uu = u.squared_norm(), uv = u.dot(v), vv = v.squared_norm(), ur = u.dot(r0), vr = v.dot(r0);
    const Real det = uu * vv - uv * uv;
    Real s, t = 0;
    if (det > kFlat * uu * vv) {
      s = (vr * uv - ur * vv) / det;
      t = (ur * uv - vr * uu) / det;
    } else if (uu > 0) {
      s = -ur / uu;  // the looks lie on a line: so does the guess
    } else {
      return false;
    }
    const Vec3 stride = n_[before] - n0, step = s * stride + t * (n_[oldest] - n0);
    const Real step2 = step.squared_norm();
    if (!(step2 > 0 && step2 < (watch ? stride.squared_norm() : kFarthest2))) return false;
    n = n0 + step;
    n *= 1 / n.norm();
    return true;
  }

 private:
  static constexpr Real kFlat = 1e-6;       // sin^2 of the angle of u and v below which v adds nothing but noise
  static constexpr Real kFarthest2 = 0.25;  // rad^2: no linear model reaches farther on a sphere of directions

  int known_ = 0, newest_ = 2;
  Vec3 n_[3] = {Vec3::zero(), Vec3::zero(), Vec3::zero()};  // unit
  Vec3 r_[3] = {Vec3::zero(), Vec3::zero(), Vec3::zero()};  // scaled lengths
};

}  // namespace carom::collision
