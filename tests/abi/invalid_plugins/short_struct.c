/* A struct that ends before the support function. */
#include "invalid_plugin.h"

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    .struct_size = 16,
    .abi_major = CAROM_PLUGIN_ABI_MAJOR,
    .abi_minor = CAROM_PLUGIN_ABI_MINOR,
    .id = "invalid_plugin.short_struct",
    .version = 1,
    .param_count = 1,
    .params = invalid_params,
    .support = invalid_ball,
};
