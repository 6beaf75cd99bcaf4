/* No liar: the control. If this one is refused, the refusals of the others prove nothing. */
#include "liar.h"

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    sizeof(carom_shape_plugin), CAROM_PLUGIN_ABI_MAJOR, CAROM_PLUGIN_ABI_MINOR, 0, "liar.honest", 1, 1, liar_params, 0,
    liar_ball, 0, 0};
