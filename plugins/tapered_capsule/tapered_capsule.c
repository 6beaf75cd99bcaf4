/* Tapered capsule: the hull of two spheres on the axis y, one at -half height, one at +half height. */
#include <carom/plugin.h>
#include <math.h>

/* clang-format off */
CAROM_SUPPORT_TEXT(
static double larger(double a, double b) { return a > b ? a : b; }

enum { RADIUS_BOTTOM, RADIUS_TOP, HALF_HEIGHT };

/* Of two spheres the one that reaches farther:  dir . point = h dy + r_top |dir|  against  -h dy + r_bottom |dir|.
 * dir is divided by its largest component first, so that no length of it overflows or vanishes. */
static int32_t support(void* user, carom_params params, uint64_t param_len, const double dir[3], double out[3]) {
  const double largest = larger(fabs(dir[0]), larger(fabs(dir[1]), fabs(dir[2])));
  const double x = dir[0] / largest, y = dir[1] / largest, z = dir[2] / largest;
  const double length = sqrt(x * x + y * y + z * z), h = params[HALF_HEIGHT];
  const int top = 2.0 * h * y >= (params[RADIUS_BOTTOM] - params[RADIUS_TOP]) * length;
  const double r = params[top ? RADIUS_TOP : RADIUS_BOTTOM] / length;
  (void)user, (void)param_len;
  out[0] = r * x;
  out[1] = (top ? h : -h) + r * y;
  out[2] = r * z;
  return 0;
}
)
/* clang-format on */

/* One radius may be 0, a tip, not both. half_height is from the middle to the centre of a sphere: the caps come on top. */
static const carom_param parameters[] = {
    {"radius_bottom", "m", 0.0, 1e8}, {"radius_top", "m", 0.0, 1e8}, {"half_height", "m", 1e-9, 1e8}};
static const carom_param_rule rules[] = {
    {"radius_bottom + radius_top >= 1e-9", 2, {RADIUS_BOTTOM, RADIUS_TOP}, {-1.0, -1.0}, -1e-9}};

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    .struct_size = sizeof(carom_shape_plugin),
    .abi_major = CAROM_PLUGIN_ABI_MAJOR,
    .abi_minor = CAROM_PLUGIN_ABI_MINOR,
    .id = "carom.tapered_capsule",
    .version = 1,
    .param_count = 3,
    .params = parameters,
    .support = support,
    .rules = rules,
    .rule_count = 1,
    .text = support_text,
};
