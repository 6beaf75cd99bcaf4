// A box in the place of a half-space, for engines without half-spaces.
#pragma once

#include <algorithm>
#include <cmath>

#include "peer.h"

namespace carom::bench {

inline constexpr double kGroundHalfDepth = 10;  // m

/// Half the width of a box that reaches as far as bodies are likely to get: wider costs floats their digits.   @return m
inline double ground_half_width(const WorldPlan& plan) {
  double farthest = 0;
  for (std::size_t i = 0; i < plan.count; ++i) {
    const double* p = plan.bodies[i].start.position;
    if (!plan.bodies[i].is_static) farthest = std::max({farthest, std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2])});
  }
  return farthest + 30;
}

}  // namespace carom::bench
