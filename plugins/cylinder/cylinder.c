/* Cylinder: axis y, centred at the origin. */
#include <carom/plugin.h>
#include <math.h>

/* clang-format off */
CAROM_SUPPORT_TEXT(
static double larger(double a, double b) { return a > b ? a : b; }

enum { RADIUS, HALF_HEIGHT };

/* A point of the rim, or the centre of a cap if dir is along the axis. x and z are divided by the larger of the two
 * before they are squared, so that no length of dir overflows or vanishes. */
static int32_t support(void* user, carom_params params, uint64_t param_len, const double dir[3], double out[3]) {
  const double largest = larger(fabs(dir[0]), fabs(dir[2]));
  (void)user, (void)param_len;
  out[0] = out[2] = 0.0;
  if (largest > 0.0) {
    const double x = dir[0] / largest, z = dir[2] / largest;
    const double length = sqrt(x * x + z * z);
    out[0] = params[RADIUS] * (x / length);
    out[2] = params[RADIUS] * (z / length);
  }
  out[1] = dir[1] >= 0.0 ? params[HALF_HEIGHT] : -params[HALF_HEIGHT];
  return 0;
}
)
/* clang-format on */

static const carom_param parameters[] = {{"radius", "m", 1e-9, 1e8}, {"half_height", "m", 1e-9, 1e8}};

static const carom_geometry geometry = {
    sizeof(carom_geometry), CAROM_FORM_CYLINDER, {RADIUS, HALF_HEIGHT, CAROM_NO_PARAM, CAROM_NO_PARAM},
    CAROM_NO_PARAM,         CAROM_FORM_CYLINDER, {RADIUS, HALF_HEIGHT, CAROM_NO_PARAM, CAROM_NO_PARAM},
};

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    .struct_size = sizeof(carom_shape_plugin),
    .abi_major = CAROM_PLUGIN_ABI_MAJOR,
    .abi_minor = CAROM_PLUGIN_ABI_MINOR,
    .id = "carom.cylinder",
    .version = 1,
    .param_count = 2,
    .params = parameters,
    .geometry = &geometry,
    .support = support,
    .text = support_text,
};
