/* No support function. */
#include "invalid_plugin.h"

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    .struct_size = sizeof(carom_shape_plugin),
    .abi_major = CAROM_PLUGIN_ABI_MAJOR,
    .abi_minor = CAROM_PLUGIN_ABI_MINOR,
    .id = "invalid_plugin.null_support",
    .version = 1,
    .param_count = 1,
    .params = invalid_params,
    .support = 0,
};

/* The valid ball is there, but not in the struct. */
CAROM_PLUGIN_EXPORT const carom_support_fn carom_invalid_elsewhere = invalid_ball;
