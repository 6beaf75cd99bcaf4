// Overlap of boxes, as every strategy of the broad phase must judge it to give the same result.
#pragma once

#include "collision/colliders.h"
#include "core/two.h"

namespace carom::collision {

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

/// A box held for many comparisons with others: the same result, two coordinates at a time.
class HeldBox {
 public:
  explicit HeldBox(const Aabb& box)
      : lo_xy_(box.lo.data()), lo_yz_(box.lo.data() + 1), hi_xy_(box.hi.data()), hi_yz_(box.hi.data() + 1) {}

  bool overlaps(const Aabb& o) const {
    const Real *const lo = o.lo.data(), *const hi = o.hi.data();
    return ((Two(lo) <= hi_xy_) & (Two(lo + 1) <= hi_yz_) & (lo_xy_ <= Two(hi)) & (lo_yz_ <= Two(hi + 1))).both();
  }

 private:
  Two lo_xy_, lo_yz_, hi_xy_, hi_yz_;
};

/// Whether `outer` holds all of a box that is not empty.
inline bool holds(const Aabb& outer, const Aabb& box) {
  const Real *const lo = box.lo.data(), *const hi = box.hi.data();
  const Real *const least = outer.lo.data(), *const most = outer.hi.data();
  const Two lo_xy(lo), lo_yz(lo + 1), hi_xy(hi), hi_yz(hi + 1);
  return ((Two(least) <= lo_xy) & (Two(least + 1) <= lo_yz) & (lo_xy <= hi_xy) & (lo_yz <= hi_yz) &
          (hi_xy <= Two(most)) & (hi_yz <= Two(most + 1)))
      .both();
}

inline void put_six(const Aabb& box, Real* six) {
  six[0] = box.lo.x(), six[1] = box.lo.y(), six[2] = box.lo.z();
  six[3] = box.hi.x(), six[4] = box.hi.y(), six[5] = box.hi.z();
}

}  // namespace carom::collision
