// Setting up the Minkowski difference of a pair, and the evidence when a support function misbehaves.
#include "collision/narrow/difference.h"

#include <algorithm>
#include <bit>

#include "collision/narrow/rounding.h"

namespace carom::collision {

namespace {

/// The power of two that brings a size into [1/2, 1), between 2^-1000 and 2^1000.
Real scale_of(Real size) {
  constexpr std::uint64_t kFraction = 52, kBias = 1023;  // bits of a double's fraction; the exponent field of 1
  const std::uint64_t field = std::bit_cast<std::uint64_t>(size) >> kFraction;
  return std::bit_cast<Real>((2 * kBias - 1 - std::clamp(field, kBias - 1001, kBias + 999)) << kFraction);
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
    : core_a_(a), core_b_(b), rotation_(b_in_a.r), offset_(b_in_a.p) {
  const Real size = b_in_a.p.abs().sum() + a.bounding_radius + b.bounding_radius + shell;
  usable_ = a.support && b.support && finite(size) && carom::usable(b_in_a);
  if (!usable_) return;
  scale_ = scale_of(size);
  metre_ = 1 / scale_;
  rounding_ = kBracketRounding * kUnitRoundoff * (scale_ * size);
  radii_ = scale_ * (a.core_radius + b.core_radius + shell);
  // Support functions that work in single precision inside pass the check at load; the same leniency here.
  slack_ = 1e-6 * (scale_ * size);
}

Vec3 Difference::centre_offset() const {
  const Shape &a = core_a_.shape(), &b = core_b_.shape();
  const Vec3 to = 0.5 * (b.bounds.lo + b.bounds.hi), from = 0.5 * (a.bounds.lo + a.bounds.hi);
  const Vec3 offset = scale_ * (rotation_ * to + offset_ - from);
  return finite(offset) ? offset : Vec3(scale_ * offset_);
}

void Difference::blame_worse(const Vec3& n, const DifferencePoint& claimed, const DifferencePoint& seen) {
  const Vec3 n_b = -(rotation_.transpose() * n);
  const Real worse_a = n.dot(seen.a - claimed.a), worse_b = n_b.dot(seen.b - claimed.b);
  if (worse_a >= worse_b)
    record(fault, SupportFault::not_support, &core_a_.shape(), n, claimed.a);
  else
    record(fault, SupportFault::not_support, &core_b_.shape(), n_b, claimed.b);
}

}  // namespace carom::collision
