/* Valid, and needs the C library: its text is altered by tests/platform, so that it asks for another one. */
#include <stdlib.h>

#include "invalid_plugin.h"

static int32_t ball_by_the_environment(void* user, const double* p, uint64_t n, const double d[3], double out[3]) {
  return getenv("CAROM_NO_SUCH_VARIABLE") ? 1 : invalid_ball(user, p, n, d, out);
}

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    .struct_size = sizeof(carom_shape_plugin),
    .abi_major = CAROM_PLUGIN_ABI_MAJOR,
    .abi_minor = CAROM_PLUGIN_ABI_MINOR,
    .id = "invalid_plugin.calls_c",
    .version = 1,
    .param_count = 1,
    .params = invalid_params,
    .support = ball_by_the_environment,
};
