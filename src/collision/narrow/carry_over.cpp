// How far a pair has moved since its last certificate, and what that leaves of it.
#include "collision/narrow/carry_over.h"

#include <algorithm>

#include "collision/narrow/difference.h"

namespace carom::collision {

void certify(const QueryResult& result, const Frame& b_in_a, Real shell, Certificate& certificate) {
  certificate.known = result.status != QueryStatus::fault && !result.farther && finite(result.upper);
  if (!certificate.known) return;
  certificate.shell = shell;
  certificate.lower = result.lower;
  certificate.upper = result.upper;
  certificate.normal = result.normal;
  certificate.point_a = result.point_a;
  certificate.point_b = result.point_b;
  certificate.b_in_a = b_in_a;
}

bool carry_over(const Shape& a, const Shape& b, const Frame& b_in_a, Real width, Real shell, const Certificate& c,
                QueryResult& result) {
  if (!c.known || c.shell != shell) return false;
  const Real smaller = std::min(a.bounding_radius, b.bounding_radius);
  const Real moved =
      motion_bound(c.b_in_a, b_in_a, a.bounding_radius, b.bounding_radius) + 16 * kUnitRoundoff * smaller;
  // The new bracket is seldom narrower than what moved, never than the old one: no look is worth it then.
  if (!(std::max(moved, c.upper - c.lower) <= width)) return false;
  Difference difference(a, b, b_in_a, shell);
  if (!difference.usable()) return false;
  const Real rounding = difference.to_metres(difference.rounding()), radii = difference.to_metres(difference.radii());
  result = QueryResult();
  Real upper = c.upper + moved + rounding;
  if (c.lower > 0) {
    const Vec3 between = b_in_a.apply(c.point_b) - c.point_a;
    upper = std::min(upper, between.norm() + 2 * rounding);
  }
  // A face of A keeps its normal in A's frame, a face of B in B's.
  const Vec3 with_b = b_in_a.rotate(c.b_in_a.rotate_inverse(c.normal));
  for (const Vec3& n : {c.normal, Vec3(with_b / with_b.norm())}) {
    DifferencePoint point;
    Real value = 0;
    if (!difference.support(n, point, value)) return false;
    result.separation = difference.to_metres(difference.lower) - radii;
    result.lower = std::min(result.separation, upper) - rounding;
    result.upper = std::max(result.separation, upper);
    if (result.upper - result.lower <= width) break;
  }
  if (!(result.upper - result.lower <= width)) return false;
  result.normal = difference.normal();
  result.point_a = c.point_a;
  result.point_b = c.point_b;
  result.support_calls = difference.calls;
  return true;
}

}  // namespace carom::collision
