// Where a shape of revolution touches what it rolls on, within a step.
//
// Contacts are found once a step. A point on a rim would turn away with its body, and leave the ground: a wheel of 0.3
// m that rolls at 6 m/s turns by a third of a radian in a sixtieth of a second. But how the body turns about its axis
// does not say where it touches. The normal through the point meets the axis, and what touches is as far beyond that
// place as it was, along the normal: that holds to the last digit while the axis leans by as much as it did, in a
// straight run, in a turn, and for a coin that goes round. So the point is told as that of a ball about that place of
// the axis, as a capsule's is about its core. @see RowGeometry::radius_a
#pragma once

#include "collision/shape.h"
#include "core/constant.h"

namespace carom::dynamics {

inline constexpr Constant<Real> kLeastLean{
    "rolling_least_lean", 0.05, "1",
    "sine of the angle between a rolling body's axis and the normal below which it stands on its end: the ball that it "
    "rolls on has its radius over that",
    "larger: coins that spin to rest lose their contact within a step; smaller: what stands up is moved aside as it "
    "tips"};

inline constexpr Constant<Real> kMostSway{
    "rolling_most_sway", 0.25, "rad",
    "by which the axis of a body that rolls may turn in a step: the place on it about which a point goes round swings "
    "as far",
    "larger: thin discs that tumble are thrown; smaller: coins that spin fast lose their contact within a step"};

inline constexpr Constant<Real> kMostSlender{
    "rolling_most_slender", 5, "1",
    "half height of a body that rolls over its radius: what is more slender is turned by each impact too far for "
    "masses that solvers keep in a substep, and its points stay on it",
    "larger: rods that bounce are thrown; smaller: short rods lose their way as they roll"};

inline constexpr ConstantRow kRollingConstants[] = {kLeastLean, kMostSway, kMostSlender};

/// Whether a shape has an axis of revolution that rolling_radius() knows.
inline bool may_roll(const collision::Shape& shape) {
  using collision::Form;
  return shape.form == Form::cylinder || shape.form == Form::cone || shape.form == Form::ellipsoid;
}

/// m: radius of the ball on whose surface a point of a shape goes round, by the axis of the shape. 0 where there is
/// none, or the body tips faster than it rolls.
/// @param point  shape frame, on its surface   @param n  shape frame, unit, outwards
/// @param turn   rad, shape frame, of the body against the one that it touches, in a step
Real rolling_radius(const collision::Shape& shape, const Vec3& point, const Vec3& n, const Vec3& turn);

}  // namespace carom::dynamics
