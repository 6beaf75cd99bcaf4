// GJK: walks a simplex towards the origin until the bracket of the distance is narrow enough.
#pragma once

#include "collision/narrow/difference.h"
#include "collision/narrow/secant.h"
#include "collision/narrow/simplex.h"

namespace carom::collision {

/// Up to four points of the difference; a walk leaves it for the witness points and for EPA.
struct DifferenceSimplex {
  int count = 0;
  DifferencePoint point[4];
  Real weight[4] = {1, 0, 0, 0};  // of the point that attains the upper bound
};

enum class GjkEnd { narrow, farther, overlap, stuck, capped, fault };

struct GjkRequest {
  SimplexSolver solver;
  Real gap;      // scaled: upper - lower at which to stop
  Real farther;  // scaled: stop as soon as the lower bound is above this
  int cap;       // iterations
  GuessPolicy guess = {-1, true};
};

/// Narrow the bracket of a difference from a first direction.
/// @param first    any length, zero is allowed; A's frame
/// @param simplex  out: the last simplex; the origin is inside if overlap
/// @param spare    out: an earlier simplex of this walk, where that one and not the last proves the upper bound; else empty
/// @return narrow: upper - lower <= gap; farther: lower > request.farther; overlap: the simplex holds the origin, or
/// lies within
///         rounding of it; stuck: rounding allows no further descent (the bracket says how good it is); capped
GjkEnd gjk(Difference& difference, const GjkRequest& request, const Vec3& first, DifferenceSimplex& simplex,
           DifferenceSimplex& spare, int& iterations);

}  // namespace carom::collision
