/* No invalid plugin: the control. If this one is refused, the refusals of the others prove nothing. */
#include "invalid_plugin.h"

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    .struct_size = sizeof(carom_shape_plugin),
    .abi_major = CAROM_PLUGIN_ABI_MAJOR,
    .abi_minor = CAROM_PLUGIN_ABI_MINOR,
    .id = "invalid_plugin.valid",
    .version = 1,
    .param_count = 1,
    .params = invalid_params,
    .support = invalid_ball,
};
