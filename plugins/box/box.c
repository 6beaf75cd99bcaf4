/* Box: centred at the origin, edges along the axes. */
#include <carom/plugin.h>

/* clang-format off */
CAROM_SUPPORT_TEXT(
/* The corner on dir's side; a zero component (of either sign) counts as positive, so that ties are repeatable. */
static int32_t support(void* user, carom_params params, uint64_t param_len, const double dir[3], double out[3]) {
  int i;
  (void)user, (void)param_len;
  for (i = 0; i < 3; ++i) out[i] = dir[i] >= 0.0 ? params[i] : -params[i];
  return 0;
}
)
/* clang-format on */

static const carom_param parameters[] = {
    {"half_extent_x", "m", 1e-9, 1e8}, {"half_extent_y", "m", 1e-9, 1e8}, {"half_extent_z", "m", 1e-9, 1e8}};

static const carom_geometry geometry = {
    sizeof(carom_geometry), CAROM_FORM_BOX, {0, 1, 2, CAROM_NO_PARAM},
    CAROM_NO_PARAM,         CAROM_FORM_BOX, {0, 1, 2, CAROM_NO_PARAM},
};

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    .struct_size = sizeof(carom_shape_plugin),
    .abi_major = CAROM_PLUGIN_ABI_MAJOR,
    .abi_minor = CAROM_PLUGIN_ABI_MINOR,
    .id = "carom.box",
    .version = 1,
    .param_count = 3,
    .params = parameters,
    .geometry = &geometry,
    .support = support,
    .text = support_text,
};
