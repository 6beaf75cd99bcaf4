// Overlap of boxes, as every strategy of the broad phase must judge it to give the same answer.
#pragma once

#include "collision/colliders.h"

namespace carom {

/// Whether a box holds no point. The formula of Aabb::overlaps() must not see one: [2, 1] would overlap [0, 3].
inline bool is_empty(const Aabb& box) {
  return !(box.lo.x() <= box.hi.x() && box.lo.y() <= box.hi.y() && box.lo.z() <= box.hi.z());
}

/// Aabb::overlaps() for boxes kept as six numbers in a row, lo x y z, hi x y z, without a branch: on the boxes that a
/// strategy compares the outcome of each comparison is close to a coin toss.
/// @return false if either holds a NaN
inline bool overlap(const Real* a, const Real* b) {
  return (a[0] <= b[3]) & (b[0] <= a[3]) & (a[1] <= b[4]) & (b[1] <= a[4]) & (a[2] <= b[5]) & (b[2] <= a[5]);
}

inline void put_six(const Aabb& box, Real* six) {
  six[0] = box.lo.x(), six[1] = box.lo.y(), six[2] = box.lo.z();
  six[3] = box.hi.x(), six[4] = box.hi.y(), six[5] = box.hi.z();
}

}  // namespace carom
