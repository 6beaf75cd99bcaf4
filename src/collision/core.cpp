// Asking a plugin's function for a support point, and telling what is wrong with its result.
#include "collision/core.h"

#include <algorithm>

namespace carom::collision {

/// Bounding radii are derived from support calls, so a point just outside is no lie: 1e-6 of the radius is let pass.
/// A point farther out would break the estimate of rounding, which is taken from the same radius.
Real Core::limit2(const Shape& s) {
  const Real r = std::max(s.bounding_radius - s.core_radius, Real(0)) + 1e-6 * s.bounding_radius;
  return std::min(r * r, std::numeric_limits<Real>::max());
}

bool Core::ask(const Vec3& n, Vec3& out) {
  returned_ = shape_->support(shape_->user, shape_->params.data(), shape_->params.size(), n.data(), out.data());
  return returned_ == 0 && out.squared_norm() <= limit2(*shape_);  // a comparison that a NaN fails
}

bool Core::blame(const Vec3& n, const Vec3& out, SupportFault& fault) const {
  fault.kind = returned_ != 0 ? SupportFault::returned : finite(out) ? SupportFault::outside : SupportFault::not_finite;
  fault.shape = shape_;
  std::copy_n(n.data(), 3, fault.dir);
  std::copy_n(out.data(), 3, fault.out);
  return false;
}

}  // namespace carom::collision
