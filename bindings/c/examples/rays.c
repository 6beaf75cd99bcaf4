/* Rays: what is below a point, how far, and that beside it lies the ground. */
#include <carom/carom.h>
#include <math.h>
#include <stdio.h>
#define TRY(call) \
  if ((call) != CAROM_OK) return fprintf(stderr, "%s. %s\n", e.message, e.remedy), 1
#define CHECK(what) \
  if (!(what)) return fprintf(stderr, "wrong: %s\n", #what), 1

int main(void) {
  carom_error e = CAROM_ERROR_INIT;
  carom_engine* engine;
  carom_world* world;
  carom_body ground, ball;
  carom_world_hit hit, beside, above;
  const double up[4] = {0, 1, 0, 0}, down[3] = {0, -1, 0}, origin[3] = {0, 0, 0}, radius = 0.5;
  const double at[3] = {0, 2, 0}, over[3] = {0, 5, 0}, aside[3] = {3, 5, 0};
  TRY(carom_engine_create(NULL, &engine, &e));
  TRY(carom_world_create(engine, NULL, &world, &e));
  TRY(carom_body_create_named(world, CAROM_BODY_STATIC, "half_space", up, 4, origin, &ground, &e));
  TRY(carom_body_create_named(world, CAROM_BODY_DYNAMIC, "sphere", &radius, 1, at, &ball, &e));
  for (int i = 0; i < 120; i++) TRY(carom_world_step(world, 1.0 / 60, &e));
  /* From, direction, farthest; time counts in lengths of the direction. */
  TRY(carom_world_cast_ray(world, over, down, INFINITY, NULL, &hit, sizeof hit, &e));
  TRY(carom_world_cast_ray(world, aside, down, INFINITY, NULL, &beside, sizeof beside, &e));
  TRY(carom_world_cast_ray(world, over, up, INFINITY, NULL, &above, sizeof above, &e));
  printf("%.2f m down lies the ball, beside it %.2f m down the ground, above it nothing\n", hit.time, beside.time);
  CHECK(hit.body == ball && fabs(hit.time - 4) < 0.01);
  CHECK(beside.body == ground && fabs(beside.time - 5) < 1e-6 && above.outcome == CAROM_CAST_MISS);
  TRY(carom_world_destroy(world, &e));
  TRY(carom_engine_destroy(engine, &e));
  return 0;
}
