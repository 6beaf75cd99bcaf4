// EPA: grows a polytope inside the difference of two overlapping cores until its nearest face is on the surface.
#pragma once

#include "collision/narrow/gjk.h"

namespace carom::collision {

/// Iterations for which the arenas on the stack have capacity; what the dial epa_iterations may ask at most.
inline constexpr int kMaxEpaIterations = 512;

/// narrow: upper - lower <= gap. apart: the cores do not overlap after all (lower > 0, direction in difference.normal).
/// flat: the difference has no volume beyond rounding, the bracket is as narrow as it gets. stuck: rounding allows no
/// progress.
enum class EpaEnd { narrow, apart, flat, stuck, capped, fault };

/// Narrow the bracket of a difference that holds the origin, or nearly.
/// @param gap      scaled
/// @param cap      iterations, at most kMaxEpaIterations
/// @param simplex  in: what GJK left, 1 to 4 points; out: the face where the shortest way out ends, with the weights of
///                 that point
EpaEnd epa(Difference& difference, Real gap, int cap, DifferenceSimplex& simplex, int& iterations);

}  // namespace carom::collision
