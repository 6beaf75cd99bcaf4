/* Convex hull of points: params are x, y, z of each. Points inside the hull, or given twice, do no harm but cost time.
 * The points of a body need not lie around the origin. */
#include <carom/plugin.h>
#include <math.h>

/* clang-format off */
CAROM_SUPPORT_TEXT(
static double larger(double a, double b) { return a > b ? a : b; }

/* The point farthest along dir; the first of equals. A scan: the engine knows the vertices from the declaration below
 * and has better ways where it matters. dir is divided by its largest component, so that no product overflows. */
static int32_t support(void* user, carom_params params, uint64_t param_len, const double dir[3], double out[3]) {
  const double d = larger(fabs(dir[0]), larger(fabs(dir[1]), fabs(dir[2])));
  const double x = dir[0] / d, y = dir[1] / d, z = dir[2] / d;
  carom_params best = params;
  double farthest = -INFINITY;
  uint64_t i;
  (void)user;
  for (i = 0; i + 3 <= param_len; i += 3) {
    const double along = x * params[i] + y * params[i + 1] + z * params[i + 2];
    if (along > farthest) {
      farthest = along;
      best = params + i;
    }
  }
  out[0] = best[0];
  out[1] = best[1];
  out[2] = best[2];
  return 0;
}
)
/* clang-format on */

static const carom_param parameters[] = {{"x", "m", -1e8, 1e8}, {"y", "m", -1e8, 1e8}, {"z", "m", -1e8, 1e8}};

static const carom_geometry geometry = {
    sizeof(carom_geometry), CAROM_FORM_POLYTOPE, {0, CAROM_NO_PARAM, CAROM_NO_PARAM, CAROM_NO_PARAM},
    CAROM_NO_PARAM,         CAROM_FORM_POLYTOPE, {0, CAROM_NO_PARAM, CAROM_NO_PARAM, CAROM_NO_PARAM},
};

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    .struct_size = sizeof(carom_shape_plugin),
    .abi_major = CAROM_PLUGIN_ABI_MAJOR,
    .abi_minor = CAROM_PLUGIN_ABI_MINOR,
    .id = "carom.hull",
    .version = 1,
    .param_count = 3,
    .params = parameters,
    .geometry = &geometry,
    .support = support,
    .param_tail_group = 3,
    .param_tail_min = 1,
    .text = support_text,
};
