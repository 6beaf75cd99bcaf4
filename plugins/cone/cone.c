/* Cone: axis y, apex at +half height, base disc at -half height (the centre of mass is a quarter of the way up). */
#include <carom/plugin.h>
#include <math.h>

/* clang-format off */
CAROM_SUPPORT_TEXT(
static double larger(double a, double b) { return a > b ? a : b; }

enum { RADIUS, HALF_HEIGHT };

/* Either the apex or a point of the base's rim, whichever lies farther along dir:
 *   dir . apex = h dy   against   dir . rim = -h dy + r |(dx, dz)|
 * All components are divided by the largest first, so that no length of dir overflows or vanishes. */
static int32_t support(void* user, carom_params params, uint64_t param_len, const double dir[3], double out[3]) {
  const double r = params[RADIUS], h = params[HALF_HEIGHT];
  const double side = larger(fabs(dir[0]), fabs(dir[2]));
  const double largest = larger(side, fabs(dir[1]));
  double x = 0.0, z = 0.0, length = 0.0;
  (void)user, (void)param_len;
  if (side > 0.0) { /* scaled by side, not largest: a nearly axial dir keeps all digits of its azimuth */
    x = dir[0] / side;
    z = dir[2] / side;
    length = sqrt(x * x + z * z);
    x /= length;
    z /= length;
  }
  if (2.0 * h * (dir[1] / largest) > r * (length * (side / largest))) {
    out[0] = out[2] = 0.0;
    out[1] = h;
  } else {
    out[0] = r * x;
    out[1] = -h;
    out[2] = r * z;
  }
  return 0;
}
)
/* clang-format on */

static const carom_param parameters[] = {{"radius", "m", 1e-9, 1e8}, {"half_height", "m", 1e-9, 1e8}};

static const carom_geometry geometry = {
    sizeof(carom_geometry), CAROM_FORM_CONE, {RADIUS, HALF_HEIGHT, CAROM_NO_PARAM, CAROM_NO_PARAM},
    CAROM_NO_PARAM,         CAROM_FORM_CONE, {RADIUS, HALF_HEIGHT, CAROM_NO_PARAM, CAROM_NO_PARAM},
};

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    .struct_size = sizeof(carom_shape_plugin),
    .abi_major = CAROM_PLUGIN_ABI_MAJOR,
    .abi_minor = CAROM_PLUGIN_ABI_MINOR,
    .id = "carom.cone",
    .version = 1,
    .param_count = 2,
    .params = parameters,
    .geometry = &geometry,
    .support = support,
    .text = support_text,
};
