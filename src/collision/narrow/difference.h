// The Minkowski difference B - A of two cores in A's frame, scaled to about unit size, and the bracket that every look
// at it narrows.
#pragma once

#include "collision/narrow/query.h"

namespace carom {

/// A support point of the difference and the points it came from.
struct DifferencePoint {
  Vec3 w;  // b - a, A's frame, scaled
  Vec3 a;  // m, A's frame
  Vec3 b;  // m, B's frame
};

/// Signed distance of the cores: s* = max over unit n of min over w in B - A of n . w. Every direction looked along
/// gives a lower bound, every point of the difference (apart) or every ball inside it (overlap) an upper one; the best
/// are kept. All lengths scaled by a power of two, so that scaling costs no bit.
class Difference {
 public:
  /// Needs finite poses and radii; `usable()` says whether they were.
  Difference(const Shape& a, const Shape& b, const Frame& b_in_a, Real shell);

  bool usable() const { return usable_; }

  /// The point of B - A with the smallest n . w, and that value; the lower bound rises if it is larger.
  /// @param n  unit to kUnitLength (rounding.h), A's frame
  /// @return   false if a support function misbehaved: `fault` says how
  bool support(const Vec3& n, DifferencePoint& out, Real& value) {
    const Vec3 n_b = -(rotation_.transpose() * n);
    ++calls;
    const int bad_a = fn_a_(params_a_, count_a_, n.data(), out.a.data());
    const int bad_b = fn_b_(params_b_, count_b_, n_b.data(), out.b.data());
    // Comparisons that a NaN fails.
    const bool good = !bad_a && !bad_b && out.a.squaredNorm() <= limit2_a_ && out.b.squaredNorm() <= limit2_b_;
    if (!good) return blame(n, n_b, bad_a, bad_b, out);
    out.w = scaled_rotation_ * out.b + scaled_offset_ - scale_ * out.a;
    value = n.dot(out.w);
    if (value > lower) {
      lower = value;
      normal = n;
    }
    return true;
  }

  /// A support point that lies farther along n than a point seen before: one of the two functions is no support
  /// function. Finds out which.
  void blame_worse(const Vec3& n, const DifferencePoint& claimed, const DifferencePoint& seen);

  /// Centre of B seen from the centre of A (middles of their bounds): a first guess of the normal, any length.
  Vec3 centre_offset() const;

  Real to_scaled(Real metres) const { return metres * scale_; }
  Real to_metres(Real scaled) const { return scaled / scale_; }
  Real rounding() const { return rounding_; }
  Real radii() const { return radii_; }
  Real slack() const { return slack_; }

  Real lower = -kInfinity, upper = kInfinity;  // of the cores, scaled, rounding not yet added
  Vec3 normal = Vec3::UnitX();                 // unit: attains `lower`
  int calls = 0;                               // support evaluations of the difference
  SupportFault fault;

 private:
  bool blame(const Vec3& n, const Vec3& n_b, int bad_a, int bad_b, const DifferencePoint& out);

  SupportFn fn_a_, fn_b_;
  const double *params_a_, *params_b_;
  std::uint64_t count_a_, count_b_;
  Real limit2_a_, limit2_b_;  // m^2: no support point of a core is farther from its shape's origin
  Mat3 rotation_, scaled_rotation_;
  Vec3 scaled_offset_;
  Real scale_ = 1, rounding_ = 0, radii_ = 0, slack_ = 0;
  const Shape *a_, *b_;
  bool usable_ = false;
};

}  // namespace carom
