/* A stranger's first program: load the installed sphere, drop it for a second, see that it fell g t^2 / 2. */
#include <carom/carom.h>
#include <math.h>
#include <stdio.h>

int main(void) {
  carom_error error = CAROM_ERROR_INIT;
  carom_engine* engine = NULL;
  carom_world* world = NULL;
  carom_plugin sphere = 0;
  carom_shape shape = 0;
  carom_body body = 0;
  carom_collider collider = 0;
  carom_body_desc body_desc;
  carom_collider_desc collider_desc;
  const double radius = 0.5;
  double y[3] = {0, 0, 0};
  int i, ok;

  ok = carom_engine_create(NULL, &engine, &error) == CAROM_OK &&
       carom_plugin_load(engine, CAROM_PLUGIN_DIR "/sphere.so", &sphere, &error) == CAROM_OK &&
       carom_shape_create(engine, sphere, &radius, 1, &shape, &error) == CAROM_OK &&
       carom_world_create(engine, NULL, &world, &error) == CAROM_OK;
  carom_body_desc_init(&body_desc, sizeof body_desc);
  ok = ok && carom_body_create(world, &body_desc, &body, &error) == CAROM_OK;
  carom_collider_desc_init(&collider_desc, sizeof collider_desc);
  collider_desc.shape = shape;
  ok = ok && carom_collider_create(world, body, &collider_desc, &collider, &error) == CAROM_OK;
  for (i = 0; ok && i < 100; ++i) ok = carom_world_step(world, 0.01, &error) == CAROM_OK;
  ok = ok && carom_world_read(world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, &body, 1, y, 0, &error) == CAROM_OK;
  if (!ok) {
    printf("%s: %s; %s\n", carom_result_name(error.code), error.message, error.remedy);
    return 1;
  }
  carom_world_destroy(world, NULL);
  carom_engine_destroy(engine, NULL);
  /* Euler's error after 1 s is g t dt / 2 = 0.049 m, on either side. */
  return fabs(y[1] + 9.81 / 2) <= 0.0491 ? 0 : 2;
}
