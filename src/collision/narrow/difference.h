// The Minkowski difference B - A of two cores in A's frame, scaled to about unit size, and the bracket that every look
// at it narrows.
#pragma once

#include "collision/core.h"
#include "collision/narrow/query.h"

namespace carom::collision {

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

  /// The point of B - A with the smallest n . w, and that value; the lower bound rises if it is larger. Inlined by
  /// order: gcc finds it too long, though the loops around it are all that GJK and EPA do.
  /// @param n  unit to kUnitLength (rounding.h), A's frame
  /// @return   false if a support function misbehaved: `fault` says how
  [[gnu::always_inline]] bool support(const Vec3& n, DifferencePoint& out, Real& value) {
    return support(n, n, out, value);
  }
  /// The same for those who know which way n points before they know n: the cores can be asked while its length is
  /// still being worked out.
  /// @param way  parallel to n but for one rounding a component, of about unit length (Core::support)
  [[gnu::always_inline]] bool support(const Vec3& way, const Vec3& n, DifferencePoint& out, Real& value) {
    const Vec3 n_b = -(rotation_.transpose() * way);
    ++calls;
    if (!core_a_.support(way, out.a)) return core_a_.blame(way, out.a, fault);
    if (!core_b_.support(n_b, out.b)) return core_b_.blame(n_b, out.b, fault);
    out.w = scale_ * (rotation_ * out.b + offset_ - out.a);
    value = n.dot(out.w);
    // Written down beside the best look, which is then the one or the other: which is unpredictable.
    looks_[1 - best_] = n;
    best_ ^= value > lower;
    lower = value > lower ? value : lower;
    return true;
  }
  /// The direction that attains the lower bound, unit.
  const Vec3& normal() const { return looks_[best_]; }
  /// Back to a bound that was proved before, by that direction.
  void set_lower(Real bound, const Vec3& by) {
    lower = bound;
    looks_[best_] = by;
  }

  /// A support point that lies farther along n than a point seen before: one of the two functions is no support
  /// function. Finds out which.
  void blame_worse(const Vec3& n, const DifferencePoint& claimed, const DifferencePoint& seen);

  /// Centre of B seen from the centre of A (middles of their bounds): a first guess of the normal, any length.
  Vec3 centre_offset() const;

  Real to_scaled(Real metres) const { return metres * scale_; }
  Real to_metres(Real scaled) const { return scaled * metre_; }
  Real rounding() const { return rounding_; }
  Real radii() const { return radii_; }
  Real slack() const { return slack_; }

  Real lower = -kInfinity, upper = kInfinity;  // of the cores, scaled, rounding not yet added
  int calls = 0;                               // support evaluations of the difference
  SupportFault fault;

 private:
  Core core_a_, core_b_;
  Vec3 looks_[2] = {Vec3::unit_x(), Vec3::unit_x()};
  int best_ = 0;  // of the two looks
  Mat3 rotation_;
  Vec3 offset_;  // m
  Real scale_ = 1, metre_ = 1, rounding_ = 0, radii_ = 0, slack_ = 0;
  bool usable_ = false;
};

}  // namespace carom::collision
