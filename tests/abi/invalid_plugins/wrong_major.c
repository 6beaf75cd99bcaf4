/* Built against a plugin.h of another major version: nothing of it may be called. */
#include "invalid_plugin.h"

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    .struct_size = sizeof(carom_shape_plugin),
    .abi_major = CAROM_PLUGIN_ABI_MAJOR + 1,
    .abi_minor = 0,
    .id = "invalid_plugin.wrong_major",
    .version = 1,
    .param_count = 1,
    .params = invalid_params,
    .support = invalid_ball,
};
