// A scan for machines with AVX2 (compiled so: src/CMakeLists.txt).
#include "collision/scan_sweep.h"

#if defined(__AVX2__)
namespace carom::collision {

extern const ScanKernel kAvx2Scan;
constexpr ScanKernel kAvx2Scan = scan_kernel_named("avx2");

}  // namespace carom::collision
#endif
