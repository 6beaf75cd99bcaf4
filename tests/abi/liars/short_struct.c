/* A struct that ends before the support function. */
#include "liar.h"

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    16, CAROM_PLUGIN_ABI_MAJOR, CAROM_PLUGIN_ABI_MINOR, 0, "liar.short_struct", 1, 1, liar_params, 0, liar_ball, 0, 0};
