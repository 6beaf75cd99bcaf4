/* Says it is larger than the symbol is: what lies beyond must not be read. */
#include "liar.h"

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    4096, CAROM_PLUGIN_ABI_MAJOR, CAROM_PLUGIN_ABI_MINOR, 0, "liar.long_struct", 1, 1, liar_params, 0, liar_ball, 0, 0};
