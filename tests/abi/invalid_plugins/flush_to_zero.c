/* Valid, but its loader sets flush-to-zero on the loading thread, as a plugin linked with -Ofast does. */
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

#include "invalid_plugin.h"

__attribute__((constructor)) static void set_flush_to_zero(void) {
#if defined(__x86_64__)
  _mm_setcsr(_mm_getcsr() | 0x8040); /* FTZ and DAZ, what crtfastmath.o does */
#endif
}

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    .struct_size = sizeof(carom_shape_plugin),
    .abi_major = CAROM_PLUGIN_ABI_MAJOR,
    .abi_minor = CAROM_PLUGIN_ABI_MINOR,
    .id = "invalid_plugin.flush_to_zero",
    .version = 1,
    .param_count = 1,
    .params = invalid_params,
    .support = invalid_ball,
};
