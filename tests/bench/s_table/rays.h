// Rays into what a scene has come to: Carom lets it settle, then every engine casts the same rays at the same poses.
#pragma once

#include "measure.h"

namespace carom::bench {

/// What one engine did with the rays.
struct RayRecord {
  std::string engine;
  bool is_carom = false;  // as it comes
  bool is_own = false;    // Carom, one way or another
  double best = 0;        // s, least CPU time of all rays together over the repeats
  double first = 0;       // s, the first time, with what an engine puts off until it is asked
  std::size_t hits = 0;
  std::size_t unlike = 0;  // rays that hit here and not with Carom, or the reverse
  double farthest = 0;     // m, difference from where Carom's ray ends, over rays that both say hit
  std::size_t apart = 0;   // of them, those of more than a millimetre
};

/// @param rays  number of them   @return one record for each engine that casts rays, Carom first   @throws Error
std::vector<RayRecord> measure_rays(const Row& row, const Options& options, std::size_t rays);

}  // namespace carom::bench
