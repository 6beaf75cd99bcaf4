// The arithmetic behind ScanKernel. Included by one file for each width of registers, compiled for it; all that stands
// here is local to that file.
#pragma once

#include "collision/scan_kernels.h"
#include "core/wide.h"

namespace carom::collision {
namespace {

/// Each lane keeps its best height: the same comparisons at any width. Nothing branches on data that no branch predictor
/// could know. Whose height that is is looked up afterwards, in its lane alone.
std::size_t farthest(const double* coordinates, std::size_t count, const double* n) {
  using core::Lanes;
  const double *x = coordinates, *y = x + count, *z = y + count;
  const double dx = n[0], dy = n[1], dz = n[2];
  const Lanes all_dx = core::all(dx), all_dy = core::all(dy), all_dz = core::all(dz);
  Lanes best = core::all(-__builtin_inf());
  for (std::size_t i = 0; i < count; i += core::kLanes) {
    Lanes px, py, pz;
    __builtin_memcpy(&px, x + i, sizeof px);
    __builtin_memcpy(&py, y + i, sizeof py);
    __builtin_memcpy(&pz, z + i, sizeof pz);
    best = core::larger(px * all_dx + py * all_dy + pz * all_dz, best);
  }
  const double first = best[2] > best[0] ? best[2] : best[0], second = best[3] > best[1] ? best[3] : best[1];
  const std::size_t odd = second > first;
  const double most = odd ? second : first;
  std::size_t i = odd + ((odd ? best[1] : best[0]) < most ? 2 : 0);
  while (i < count && x[i] * dx + y[i] * dy + z[i] * dz != most) i += core::kLanes;
  return i < count ? i : count;
}

constexpr ScanKernel scan_kernel_named(const char* name) { return {name, farthest}; }

}  // namespace
}  // namespace carom::collision
