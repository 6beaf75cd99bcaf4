/* Ellipsoid: centred at the origin, axes along the frame's. */
#include <carom/plugin.h>
#include <math.h>

/* clang-format off */
CAROM_SUPPORT_TEXT(
static double larger(double a, double b) { return a > b ? a : b; }

/* The unit sphere's support of the direction seen from it, w = (rx dx, ry dy, rz dz), stretched back:
 *   out_i = r_i w_i / |w|
 * dir is divided by its largest component, then w by its own, so that nothing overflows or vanishes on the way. */
static int32_t support(void* user, carom_params params, uint64_t param_len, const double dir[3], double out[3]) {
  const double d = larger(fabs(dir[0]), larger(fabs(dir[1]), fabs(dir[2])));
  double w[3], largest = 0.0, length;
  int i;
  (void)user, (void)param_len;
  for (i = 0; i < 3; ++i) {
    w[i] = params[i] * (dir[i] / d);
    largest = larger(largest, fabs(w[i]));
  }
  for (i = 0; i < 3; ++i) w[i] /= largest;
  length = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
  for (i = 0; i < 3; ++i) out[i] = params[i] * (w[i] / length);
  return 0;
}
)
/* clang-format on */

static const carom_param parameters[] = {
    {"radius_x", "m", 1e-9, 1e8}, {"radius_y", "m", 1e-9, 1e8}, {"radius_z", "m", 1e-9, 1e8}};

static const carom_geometry geometry = {
    sizeof(carom_geometry), CAROM_FORM_ELLIPSOID, {0, 1, 2, CAROM_NO_PARAM},
    CAROM_NO_PARAM,         CAROM_FORM_ELLIPSOID, {0, 1, 2, CAROM_NO_PARAM},
};

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    .struct_size = sizeof(carom_shape_plugin),
    .abi_major = CAROM_PLUGIN_ABI_MAJOR,
    .abi_minor = CAROM_PLUGIN_ABI_MINOR,
    .id = "carom.ellipsoid",
    .version = 1,
    .param_count = 3,
    .params = parameters,
    .geometry = &geometry,
    .support = support,
    .text = support_text,
};
