/* What the invalid plugins share: a valid ball to be invalid about. */
#ifndef CAROM_TESTS_INVALID_H
#define CAROM_TESTS_INVALID_H

#include <carom/plugin.h>
#include <math.h>

static const carom_param invalid_params[] = {{"radius", "m", 0.1, 10}};

static inline int32_t invalid_ball(void* user, const double* params, uint64_t count, const double dir[3],
                                   double out[3]) {
  (void)user;
  const double largest = fmax(fabs(dir[0]), fmax(fabs(dir[1]), fabs(dir[2])));
  const double x = dir[0] / largest, y = dir[1] / largest, z = dir[2] / largest;
  const double scale = params[0] / sqrt(x * x + y * y + z * z);
  (void)count;
  out[0] = scale * x;
  out[1] = scale * y;
  out[2] = scale * z;
  return 0;
}

#endif
