// A scan in registers that every machine of the target has (x86-64: SSE2).
#include "collision/scan_sweep.h"

namespace carom::collision {

extern const ScanKernel kBaselineScan;
constexpr ScanKernel kBaselineScan = scan_kernel_named("baseline");

}  // namespace carom::collision
