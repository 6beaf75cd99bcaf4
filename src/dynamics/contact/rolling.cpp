#include "dynamics/contact/rolling.h"

namespace carom::dynamics {
namespace {

using collision::Form;
using collision::Shape;

/// Which of its axes a shape may turn about without being changed by it. @return 3: none, or any, or it is slender
int axis_of_revolution(const Shape& shape) {
  if (shape.form == Form::cylinder || shape.form == Form::cone)
    return shape.half_height <= kMostSlender * shape.radius ? 1 : 3;
  if (shape.form != Form::ellipsoid) return 3;
  const Vec3& r = shape.half;
  for (int k = 0; k < 3; ++k)
    if (r[(k + 1) % 3] == r[(k + 2) % 3] && r[k] != r[(k + 1) % 3])
      return r[k] <= kMostSlender * r[(k + 1) % 3] ? k : 3;
  return 3;
}

}  // namespace

Real rolling_radius(const Shape& shape, const Vec3& point, const Vec3& n, const Vec3& turn) {
  const int axis = axis_of_revolution(shape);
  if (axis == 3) return 0;
  Vec3 from_axis = point, lean = n, e = Vec3::zero();
  from_axis[axis] = lean[axis] = 0, e[axis] = 1;
  const Real sine = lean.norm(), off = from_axis.norm();
  // Normals of pairs are found to some digits; a point on a blunt end has another one than its rim.
  constexpr Real kAligned = 0.01;
  if (!(sine > kLeastLean) || !(from_axis.dot(lean) > 0)) return 0;
  if (!(from_axis.cross(lean).norm() < kAligned * off * sine)) return 0;
  if (turn.cross(e).squared_norm() > kMostSway * kMostSway) return 0;
  // About that level line a rim's point turns with its body; about the other the body rolls.
  const Vec3 level = e.cross(lean);
  return std::fabs(turn.dot(level)) <= std::fabs(turn.dot(n.cross(level))) ? off / sine : 0;
}

}  // namespace carom::dynamics
