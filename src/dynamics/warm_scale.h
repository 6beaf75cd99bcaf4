// How the impulses of one substep are reused in the next.
#pragma once

#include <algorithm>

#include "core/vec.h"

namespace carom::dynamics {

/// Impulses are reused as forces, so by the ratio of the substeps. But what a substep leaves is not force alone:
/// rounding, and what undid a gap, do not shrink with it. After one of 1e-20 s the ratio made 1e5 m/s of them, and
/// quarantine of whom they moved. Substeps that differ by more than this are reused in part; the solver finds the
/// rest, as it does from nothing.
inline constexpr Real kMostSurfaceSpeed = 1e3;

/// @param h, old_h  s, > 0: this substep, and the one that left the impulses
inline Real warm_scale(Real h, Real old_h) { return std::min(h / old_h, kMostSurfaceSpeed); }

}  // namespace carom::dynamics
