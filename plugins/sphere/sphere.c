/* Sphere: a point with a radius. The core is the origin, so the engine swells it exactly and contacts stay cheap. */
#include <carom/plugin.h>

/* clang-format off */
CAROM_SUPPORT_TEXT(
static int32_t support(void* user, carom_params params, uint64_t param_len, const double dir[3], double out[3]) {
  (void)params;
  (void)user, (void)param_len;
  (void)dir;
  out[0] = out[1] = out[2] = 0.0;
  return 0;
}
)
/* clang-format on */

static const carom_param parameters[] = {{"radius", "m", 1e-9, 1e8}};

static const carom_geometry geometry = {
    sizeof(carom_geometry),
    CAROM_FORM_SPHERE,
    {0, CAROM_NO_PARAM, CAROM_NO_PARAM, CAROM_NO_PARAM},
    0, /* core radius: the radius */
    CAROM_FORM_SPHERE,
    {0, CAROM_NO_PARAM, CAROM_NO_PARAM, CAROM_NO_PARAM},
};

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    .struct_size = sizeof(carom_shape_plugin),
    .abi_major = CAROM_PLUGIN_ABI_MAJOR,
    .abi_minor = CAROM_PLUGIN_ABI_MINOR,
    .id = "carom.sphere",
    .version = 1,
    .param_count = 1,
    .params = parameters,
    .geometry = &geometry,
    .support = support,
    .text = support_text,
};
