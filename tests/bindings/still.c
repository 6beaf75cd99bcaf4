/* Put before the library: a world that does not step. An example must notice. */
#include <carom/world.h>

CAROM_API int32_t carom_world_step(carom_world* world, double dt, carom_error* error) {
  (void)world, (void)dt, (void)error;
  return CAROM_OK;
}
