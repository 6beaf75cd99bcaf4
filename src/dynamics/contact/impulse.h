// The solution of a single contact if nothing else acts.
#pragma once

#include "dynamics/contact/contact.h"

namespace carom::dynamics {

/// The accumulated impulse that fulfils a row's law if nothing else acts.
///   stick:  p' = p + K^-1 (target n - u), if inside the cone
///   slide:  p' = s (n + mu d), d the direction of the stick impulse in the plane, s from  n.(u + K (p' - p)) = target
/// @param target  m/s, wanted normal velocity
/// @return N s, world, on B
Vec3 resolved_impulse(const Row& row, const RowMass& m, Real target);

}  // namespace carom::dynamics
