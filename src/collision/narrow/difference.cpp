// Setting up the Minkowski difference of a pair, and the evidence when a support function misbehaves.
#include "collision/narrow/difference.h"

#include <algorithm>

#include "collision/narrow/rounding.h"

namespace carom {

namespace {

/// Bounding radii are derived from support calls, so a point just outside is no lie: 1e-6 of the radius is let pass.
/// A point farther out would break the estimate of rounding, which is taken from the same radius.
Real limit2(const Shape& s) {
  const Real r = std::max(s.bounding_radius - s.core_radius, Real(0)) + 1e-6 * s.bounding_radius;
  return std::min(r * r, std::numeric_limits<Real>::max());
}

void record(SupportFault& fault, SupportFault::Kind kind, const Shape* shape, const Vec3& dir, const Vec3& out) {
  fault.kind = kind;
  fault.shape = shape;
  for (int i = 0; i < 3; ++i) {
    fault.dir[i] = dir[i];
    fault.out[i] = out[i];
  }
}

}  // namespace

Difference::Difference(const Shape& a, const Shape& b, const Frame& b_in_a, Real shell)
    : fn_a_(a.support),
      fn_b_(b.support),
      params_a_(a.params.data()),
      params_b_(b.params.data()),
      count_a_(a.params.size()),
      count_b_(b.params.size()),
      limit2_a_(limit2(a)),
      limit2_b_(limit2(b)),
      rotation_(b_in_a.r),
      a_(&a),
      b_(&b) {
  const Real size = std::fabs(b_in_a.p.x()) + std::fabs(b_in_a.p.y()) + std::fabs(b_in_a.p.z()) + a.bounding_radius +
                    b.bounding_radius + shell;
  usable_ = fn_a_ && fn_b_ && finite(size) && b_in_a.r.allFinite();
  if (!usable_) return;
  // 2^-exponent brings the pair to about 1; the clamp keeps the scale itself finite and normal.
  int exponent = 0;
  std::frexp(size, &exponent);
  scale_ = std::ldexp(Real(1), -std::clamp(exponent, -1000, 1000));
  scaled_rotation_ = scale_ * rotation_;
  scaled_offset_ = scale_ * b_in_a.p;
  rounding_ = kBracketRounding * kUnitRoundoff * (scale_ * size);
  radii_ = scale_ * (a.core_radius + b.core_radius + shell);
  // Support functions that work in single precision inside pass the check at load; the same leniency here.
  slack_ = 1e-6 * (scale_ * size);
}

Vec3 Difference::centre_offset() const {
  const Vec3 from = 0.5 * (a_->bounds.lo + a_->bounds.hi), to = 0.5 * (b_->bounds.lo + b_->bounds.hi);
  const Vec3 offset = scaled_rotation_ * to + scaled_offset_ - scale_ * from;
  return finite(offset) ? offset : scaled_offset_;
}

bool Difference::blame(const Vec3& n, const Vec3& n_b, int bad_a, int bad_b, const DifferencePoint& out) {
  const auto kind_of = [](int bad, const Vec3& x, Real limit2) {
    if (bad) return SupportFault::returned;
    if (!finite(x)) return SupportFault::not_finite;
    return x.squaredNorm() <= limit2 ? SupportFault::none : SupportFault::outside;
  };
  const SupportFault::Kind of_a = kind_of(bad_a, out.a, limit2_a_);
  if (of_a != SupportFault::none)
    record(fault, of_a, a_, n, out.a);
  else
    record(fault, kind_of(bad_b, out.b, limit2_b_), b_, n_b, out.b);
  return false;
}

void Difference::blame_worse(const Vec3& n, const DifferencePoint& claimed, const DifferencePoint& seen) {
  const Vec3 n_b = -(rotation_.transpose() * n);
  const Real worse_a = n.dot(seen.a - claimed.a), worse_b = n_b.dot(seen.b - claimed.b);
  if (worse_a >= worse_b)
    record(fault, SupportFault::not_support, a_, n, claimed.a);
  else
    record(fault, SupportFault::not_support, b_, n_b, claimed.b);
}

}  // namespace carom
