/* Template: a double cone (a spinning top), worked out in full. Copy this folder, rename it, change what is marked.
 *
 * A shape is a bounded convex set, and all its code is one function that answers "which of your points lies farthest
 * along this direction?". From that alone the engine finds bounds, volume, centre of mass, inertia and contacts.
 */
#include <carom/plugin.h>
#include <math.h>

/* What stands in these parentheses is compiled here, and is text as well, for devices: no macros in it, no lines that begin
 * with #, and of the C library sqrt() and fabs() alone. */
/* clang-format off */
CAROM_SUPPORT_TEXT(
static double larger(double a, double b) { return a > b ? a : b; }

/* CHANGE: what params[0], params[1] ... mean, in the order of `parameters` below. */
enum { RADIUS, HALF_HEIGHT };

/* CHANGE: the support function. This set is the hull of a disc of radius r in the plane y = 0 and of the two points
 * (0, +h, 0) and (0, -h, 0). The farthest point of a hull is the farthest of its parts, so compare
 *     disc:  dir . point = r |(dx, dz)|      tip:  dir . point = h |dy|
 *
 * What to watch:
 *   - dir may have ANY length (1e-300 as well as 1e300): divide by the largest component before squaring;
 *   - components may be zero, of either sign: every branch below has an answer for them;
 *   - equal candidates: pick either, but always the same;
 *   - no global, no static variable, no allocation: it runs on several threads at once. */
static int32_t support(void* user, carom_params params, uint64_t param_len, const double dir[3], double out[3]) {
  const double r = params[RADIUS], h = params[HALF_HEIGHT];
  const double side = larger(fabs(dir[0]), fabs(dir[2]));
  const double largest = larger(side, fabs(dir[1])); /* > 0: dir is never zero */
  double x = 0.0, z = 0.0, length = 0.0;
  (void)user, (void)param_len; /* always 2: this shape has no repeating tail of parameters */
  if (side > 0.0) {
    x = dir[0] / side;
    z = dir[2] / side;
    length = sqrt(x * x + z * z); /* 1 to sqrt 2 */
    x /= length;
    z /= length;
  }
  if (h * (fabs(dir[1]) / largest) > r * (length * (side / largest))) {
    out[0] = 0.0;
    out[1] = dir[1] >= 0.0 ? h : -h;
    out[2] = 0.0;
  } else {
    out[0] = r * x;
    out[1] = 0.0;
    out[2] = r * z;
  }
  return 0; /* anything else reports a fault and puts the shape in quarantine */
}
)
/* clang-format on */

/* CHANGE: name, unit, smallest and largest legal value of each parameter. The engine refuses values outside, so the
 * support function needs no check of its own. */
static const carom_param parameters[] = {{"radius", "m", 1e-9, 1e8}, {"half_height", "m", 1e-9, 1e8}};

/* Declarations are optional, and this shape makes none: it is measured from its support function. A shape that IS one
 * of the closed forms of plugin.h, or has the mass of one, or is a simpler core swollen by a radius, may say so and
 * gain speed and exact mass; the engine verifies each word of it. A cylinder would write
 *
 *     static const carom_geometry geometry = {
 *         sizeof(carom_geometry),
 *         CAROM_FORM_CYLINDER, {RADIUS, HALF_HEIGHT, CAROM_NO_PARAM, CAROM_NO_PARAM},   the set, and which parameters
 *         CAROM_NO_PARAM,                                                               core radius: none
 *         CAROM_FORM_CYLINDER, {RADIUS, HALF_HEIGHT, CAROM_NO_PARAM, CAROM_NO_PARAM},   its mass
 *     };
 *
 * and add .geometry = &geometry below. */

/* The one exported symbol. CHANGE: the id (yours: "org.example.top"); raise the version when the same parameters come
 * to mean another set. What is not named is 0: no declarations,
 * no parameters that repeat (see plugins/hull), no rules between parameters (carom_param_rule). */
CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    .struct_size = sizeof(carom_shape_plugin),
    .abi_major = CAROM_PLUGIN_ABI_MAJOR,
    .abi_minor = CAROM_PLUGIN_ABI_MINOR,
    .id = "carom.template",
    .version = 1,
    .param_count = 2,
    .params = parameters,
    .support = support,
    .text = support_text,
};
