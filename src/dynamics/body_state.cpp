#include "dynamics/body_state.h"

#include <bit>

namespace carom::dynamics {

Mat3 inverse_of_free(const Mat3& inertia, Locks locks) {
  Mat3 inverse = Mat3::zero();
  const Vec3 free = free_turns(locks);
  switch (std::popcount(static_cast<unsigned>(locks & kAngularLocks))) {
    case 0:
      return inertia.inverse();
    case 1: {
      const int held = free[0] == 0 ? 0 : free[1] == 0 ? 1 : 2, i = (held + 1) % 3, j = (held + 2) % 3;
      const Real cross = (inertia(i, j) + inertia(j, i)) / 2, det = inertia(i, i) * inertia(j, j) - cross * cross;
      inverse(i, i) = inertia(j, j) / det, inverse(j, j) = inertia(i, i) / det;
      inverse(i, j) = inverse(j, i) = -cross / det;
      return inverse;
    }
    case 2:
      for (int i = 0; i < 3; ++i)
        if (free[i] != 0) inverse(i, i) = 1 / inertia(i, i);
      return inverse;
    default:
      return inverse;
  }
}

}  // namespace carom::dynamics
