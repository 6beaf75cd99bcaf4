/* Casts and overlaps: how far a crate can be moved before it touches, and what a blast of 2 m reaches. */
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
  carom_body ground, wall, ball[3];
  carom_shape crate, blast;
  carom_query_shapes ask = {.struct_size = sizeof ask};
  carom_world_hit hit, found[8];
  uint64_t count;
  const double up[4] = {0, 1, 0, 0}, origin[3] = {0, 0, 0}, thick[3] = {0.5, 2, 2}, there[3] = {5, 2, 0}, radius = 0.5;
  const double half[3] = {0.5, 0.5, 0.5}, from[3] = {0, 1, 0}, way[3] = {8, 0, 0}, reach = 2, middle[3] = {0, 0.5, 0};
  int reached = 0;
  TRY(carom_engine_create(NULL, &engine, &e));
  TRY(carom_world_create(engine, NULL, &world, &e));
  TRY(carom_body_create_named(world, CAROM_BODY_STATIC, "half_space", up, 4, origin, &ground, &e));
  TRY(carom_body_create_named(world, CAROM_BODY_STATIC, "box", thick, 3, there, &wall, &e));
  for (int i = 0; i < 3; i++) {
    const double at[3] = {0, 6, i == 0 ? 1 : i == 1 ? -2 : 4};
    TRY(carom_body_create_named(world, CAROM_BODY_DYNAMIC, "sphere", &radius, 1, at, &ball[i], &e));
  }
  for (int i = 0; i < 120; i++) TRY(carom_world_step(world, 1.0 / 60, &e)); /* they fall to the ground */
  TRY(carom_shape_create_named(engine, "box", half, 3, &crate, &e));        /* of no body: it only asks */
  TRY(carom_shape_create_named(engine, "sphere", &reach, 1, &blast, &e));
  ask.scalar = CAROM_SCALAR_F64, ask.count = 1, ask.shapes = &crate, ask.positions = from, ask.motions = way;
  TRY(carom_world_cast_shapes(world, &ask, CAROM_WANT_FIRST, NULL, &hit, sizeof hit, &e));
  ask.shapes = &blast, ask.positions = middle, ask.motions = NULL;
  TRY(carom_world_overlap_shapes(world, &ask, NULL, found, sizeof hit, 8, &count, &e));
  for (uint64_t k = 0; k < count && k < 8; k++)
    for (int i = 0; i < 3; i++) reached += found[k].body == ball[i];
  /* Time is a fraction of the way. */
  printf("%.2f m to the wall, and %d of 3 balls lie within 2 m\n", 8 * hit.time, reached);
  CHECK(hit.body == wall && fabs(8 * hit.time - 4) < 1e-4 && reached == 2);
  TRY(carom_world_destroy(world, &e));
  TRY(carom_engine_destroy(engine, &e));
  return 0;
}
