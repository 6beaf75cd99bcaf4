// What rounding can do to a cast, on top of what it does to a distance.
#pragma once

#include "collision/narrow/rounding.h"

namespace carom::collision {

/// Error of a support value in the line's coordinates, in units of u M, M = length of the offset of the shapes (of a
/// ray: its origin seen from the shape) + radii. In units of u:
///
///     what a distance pays, poses included                              kBracketRounding + kPoseRounding
///     the line's direction: turned, normalised; it errs by 8, the line by that times the offset          8 M
///     its two perpendiculars: 8 off from unit length and right angles, in points                         8 M
///     directions through that basis: 8 + 5, which moves the best point by at most a diameter            26 M
///     points through it: products and sums                                                               5 M
///     the foot on the line, and lengths along it from there to the start                                 6 M
inline constexpr Real kCastRounding = kBracketRounding + kPoseRounding + 53;

/// What the last digits of a place leave open, in units of u and of its distance from the origin. Rounding it takes 1,
/// a body's pose times a collider's own 3 more. Far out flush shapes have gaps of that much, which are none.
inline constexpr Real kPlaceRounding = 4;

}  // namespace carom::collision
