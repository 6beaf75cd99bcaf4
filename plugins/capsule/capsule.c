/* Capsule: a segment along y, centred, with a radius. The core is the segment. */
#include <carom/plugin.h>

/* clang-format off */
CAROM_SUPPORT_TEXT(
enum { RADIUS, HALF_HEIGHT };

static int32_t support(void* user, carom_params params, uint64_t param_len, const double dir[3], double out[3]) {
  (void)user, (void)param_len;
  out[0] = out[2] = 0.0;
  out[1] = dir[1] >= 0.0 ? params[HALF_HEIGHT] : -params[HALF_HEIGHT];
  return 0;
}
)
/* clang-format on */

static const carom_param parameters[] = {{"radius", "m", 1e-9, 1e8},
                                         {"half_height", "m", 0.0, 1e8} /* of the segment: the caps come on top */};

static const carom_geometry geometry = {
    sizeof(carom_geometry),
    CAROM_FORM_CAPSULE,
    {RADIUS, HALF_HEIGHT, CAROM_NO_PARAM, CAROM_NO_PARAM},
    RADIUS,
    CAROM_FORM_CAPSULE,
    {RADIUS, HALF_HEIGHT, CAROM_NO_PARAM, CAROM_NO_PARAM},
};

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    .struct_size = sizeof(carom_shape_plugin),
    .abi_major = CAROM_PLUGIN_ABI_MAJOR,
    .abi_minor = CAROM_PLUGIN_ABI_MINOR,
    .id = "carom.capsule",
    .version = 1,
    .param_count = 2,
    .params = parameters,
    .geometry = &geometry,
    .support = support,
    .text = support_text,
};
