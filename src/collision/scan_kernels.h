// The farthest of few vertices, all of them looked at four side by side. Compiled once for each width of registers.
#pragma once

#include <cstddef>
#include <span>

namespace carom::collision {

/// The same function for one width; same bits from each.
struct ScanKernel {
  const char* name;
  /// @param coordinates  [3][count] m: all x, all y, all z   @param count  a multiple of 4   @param n  [3]
  /// @return  the first that attains max n . x, of those that stand where it stands in its four; count: none does
  std::size_t (*farthest)(const double* coordinates, std::size_t count, const double* n);
};

/// The widest that this machine has.
const ScanKernel& scan_kernel();
/// All that this machine can run, the baseline first.
std::span<const ScanKernel* const> all_scan_kernels();

}  // namespace carom::collision
