/* Honest, but its loader sets flush-to-zero on the loading thread, as a plugin linked with -Ofast does. */
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

#include "liar.h"

__attribute__((constructor)) static void set_flush_to_zero(void) {
#if defined(__x86_64__)
  _mm_setcsr(_mm_getcsr() | 0x8040); /* FTZ and DAZ, what crtfastmath.o does */
#endif
}

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    sizeof(carom_shape_plugin), CAROM_PLUGIN_ABI_MAJOR, CAROM_PLUGIN_ABI_MINOR, 0, "liar.flush_to_zero", 1, 1, liar_params,
    0, liar_ball, 0, 0};
