// Solids in poses whose gap needs no library to be known: one stands upside down beneath another of its kind.
#pragma once

#include <deque>

#include "solid.h"

namespace carom::bench {

/// The bottoms of two solids face each other: faces of boxes, hulls, cylinders and cones, poles of the others.
class Stack {
 public:
  /// @param aside  m: of the upper one from the line through the lower one's origin, in a face's plane
  Stack(Shape upper, Shape lower, const Vec3& aside, const Mat3& tilt);

  /// The poses in which `gap` is between them, and each has turned about the normal.
  /// @param gap  m, negative in overlap, smaller than any other way out is deep; @param spin  rad
  Placement upper_at(double gap, double spin, const Vec3& astray = Vec3::zero()) const;
  Placement lower_at(double spin) const;
  /// Where a ray straight down starts that meets the lower one after `height`, m.
  Vec3 above(double height, const Vec3& astray = Vec3::zero()) const;
  Vec3 down() const { return -tilt_.col(1); }  // from the upper one to the lower one

  OwnedSolid upper, lower;

 private:
  Vec3 aside_;
  Mat3 tilt_;
};

/// One of each kind of solid, each tilted in its own way.
std::deque<Stack> stacks();

}  // namespace carom::bench
