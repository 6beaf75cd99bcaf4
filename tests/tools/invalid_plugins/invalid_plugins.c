/* Plugins that lie, one per build: -DLIE_<NAME> chooses. `carom check` has to catch each. */
#include <carom/plugin.h>
#include <math.h>

#if defined(LIE_CRASH)
static volatile int* nowhere = 0;
#elif defined(LIE_ABORT) || defined(LIE_EXIT)
#include <stdlib.h>
#elif defined(LIE_JUMP)
#include <setjmp.h>
static jmp_buf nowhere; /* never set: no frame waits there any more */
#endif

/* A unit ball, unless told otherwise. */
static int32_t support(void* user, const double* params, uint64_t param_len, const double dir[3], double out[3]) {
  (void)user;
  const double big = fmax(fabs(dir[0]), fmax(fabs(dir[1]), fabs(dir[2])));
  const double x = dir[0] / big, y = dir[1] / big, z = dir[2] / big, length = sqrt(x * x + y * y + z * z);
  (void)params;
  (void)param_len;
  out[0] = x / length;
  out[1] = y / length;
  out[2] = z / length;
#if defined(LIE_HANG)
  while (x > 0.9 * length && y > 0) /* only in a cap of directions */
    out[0] += 1;
#elif defined(LIE_CRASH)
  if (y < -0.95 * length) *nowhere = 1;
#elif defined(LIE_ABORT)
  if (y < -0.95 * length) abort();
#elif defined(LIE_EXIT)
  if (y < -0.95 * length) exit(0);
#elif defined(LIE_JUMP)
  if (y < -0.95 * length) longjmp(nowhere, 1);
#elif defined(LIE_NAN)
  if (z > 0.99 * length) out[1] = NAN;
#elif defined(LIE_DENT)
  if (x > 0.8 * length) out[0] *= 0.9; /* a dent: not convex */
#elif defined(LIE_LENGTH)
  out[0] = dir[0] / sqrt(dir[0] * dir[0] + dir[1] * dir[1] + dir[2] * dir[2]); /* overflows and underflows */
#elif defined(LIE_MEMORY)
  {
    static double last;
    out[0] += 1e-3 * (last > 0 ? 1 : 0);
    last = last > 0 ? 0 : 1;
  }
#endif
  return 0;
}

#if defined(LIE_DECLARATION) /* says it is a box of half extents 1 */
static const carom_param parameters[] = {{"half", "m", 1, 1}};
static const carom_geometry geometry = {
    sizeof(carom_geometry), CAROM_FORM_BOX,  {0, 0, 0, CAROM_NO_PARAM},
    CAROM_NO_PARAM,         CAROM_FORM_NONE, {CAROM_NO_PARAM, CAROM_NO_PARAM, CAROM_NO_PARAM, CAROM_NO_PARAM}};
#define PARAMETERS .param_count = 1, .params = parameters, .geometry = &geometry
#elif defined(LIE_RULES) /* asks for what its own bounds forbid */
static const carom_param parameters[] = {{"radius", "m", 1, 2}};
static const carom_param_rule rules[] = {{"radius <= 0.5", 1, {0}, {1}, 0.5}};
#define PARAMETERS .param_count = 1, .params = parameters, .rules = rules, .rule_count = 1
#else
#define PARAMETERS .param_count = 0
#endif

CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1 = {
    .struct_size = sizeof(carom_shape_plugin),
    .abi_major = CAROM_PLUGIN_ABI_MAJOR,
    .abi_minor = CAROM_PLUGIN_ABI_MINOR,
    .id = "test.invalid_plugin",
    .version = 1,
    PARAMETERS,
    .support = support,
};
