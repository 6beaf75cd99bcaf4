/* No support function. */
#include "liar.h"

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    sizeof(carom_shape_plugin), CAROM_PLUGIN_ABI_MAJOR, CAROM_PLUGIN_ABI_MINOR, 0, "liar.null_support", 1, 1, liar_params,
    0, 0, 0, 0};

/* The honest ball is there, but not in the struct. */
CAROM_PLUGIN_EXPORT const carom_support_fn carom_liar_elsewhere = liar_ball;
