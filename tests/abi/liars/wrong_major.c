/* Built against a plugin.h of another major version: nothing of it may be called. */
#include "liar.h"

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    sizeof(carom_shape_plugin), CAROM_PLUGIN_ABI_MAJOR + 1, 0, 0, "liar.wrong_major", 1, 1, liar_params, 0, liar_ball, 0,
    0};
