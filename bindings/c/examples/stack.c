/* Bodies and stacks: ten boxes stand on each other, to a millimetre a box. */
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
  carom_body ground, box[10];
  const double up[4] = {0, 1, 0, 0}, origin[3] = {0, 0, 0};
  const double half[3] = {0.5, 0.5, 0.5}; /* extents, m; of 1000 kg/m^3, where nothing else is said */
  double mass, top[3];
  TRY(carom_engine_create(NULL, &engine, &e));
  TRY(carom_world_create(engine, NULL, &world, &e));
  TRY(carom_body_create_named(world, CAROM_BODY_STATIC, "half_space", up, 4, origin, &ground, &e));
  for (int i = 0; i < 10; i++) {
    const double at[3] = {0, 0.52 + 1.02 * i, 0};
    TRY(carom_body_create_named(world, CAROM_BODY_DYNAMIC, "box", half, 3, at, &box[i], &e));
  }
  for (int i = 0; i < 180; i++) TRY(carom_world_step(world, 1.0 / 60, &e));
  TRY(carom_body_get_pose(world, box[9], top, NULL, &e));
  TRY(carom_body_get_mass(world, box[0], &mass, NULL, NULL, &e));
  printf("10 boxes of %.0f kg stand for 3 s, the top one at y = %.2f m\n", mass, top[1]);
  CHECK(fabs(top[1] - 9.5) < 0.01 && fabs(top[0]) < 0.01 && fabs(top[2]) < 0.01);
  TRY(carom_world_destroy(world, &e));
  TRY(carom_engine_destroy(engine, &e));
  return 0;
}
