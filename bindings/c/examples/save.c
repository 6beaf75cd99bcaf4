/* Saving and loading: a world as bytes, for a file, goes on in another engine with the same bits. */
#include <carom/carom.h>
#include <math.h>
#include <stdio.h>
#define TRY(call) \
  if ((call) != CAROM_OK) return fprintf(stderr, "%s. %s\n", e.message, e.remedy), 1
#define CHECK(what) \
  if (!(what)) return fprintf(stderr, "wrong: %s\n", #what), 1

static char saved[1 << 20];

int main(void) {
  carom_error e = CAROM_ERROR_INIT;
  carom_engine *engine, *other;
  carom_world *world, *copy;
  carom_shape box;
  carom_body ground, body[6];
  uint64_t size, count, hash, copied;
  const double up[4] = {0, 1, 0, 0}, origin[3] = {0, 0, 0}, half[3] = {0.5, 0.5, 0.5};
  double top[3];
  TRY(carom_engine_create(NULL, &engine, &e));
  TRY(carom_world_create(engine, NULL, &world, &e));
  TRY(carom_body_create_named(world, CAROM_BODY_STATIC, "half_space", up, 4, origin, &ground, &e));
  for (int i = 0; i < 5; i++) {
    const double at[3] = {0.1 * i, 0.5 + 1.1 * i, 0};
    TRY(carom_body_create_named(world, CAROM_BODY_DYNAMIC, "box", half, 3, at, &body[i], &e));
  }
  for (int i = 0; i < 60; i++) TRY(carom_world_step(world, 1.0 / 60, &e));
  /* With bodies and shapes: write these `size` bytes to a file. */
  TRY(carom_world_save(world, CAROM_SNAPSHOT_WHOLE, saved, sizeof saved, &size, &e));
  TRY(carom_engine_create(NULL, &other, &e));
  TRY(carom_world_create(other, NULL, &copy, &e));
  TRY(carom_shape_create_named(other, "box", half, 3, &box, &e)); /* finds the plugin of what is loaded */
  TRY(carom_world_restore(copy, saved, size, &e));                /* into a world in which nothing was made yet */
  for (int i = 0; i < 60; i++) {
    TRY(carom_world_step(world, 1.0 / 60, &e));
    TRY(carom_world_step(copy, 1.0 / 60, &e));
  }
  TRY(carom_world_hash(world, &hash, &e));
  TRY(carom_world_hash(copy, &copied, &e));
  TRY(carom_world_get_bodies(copy, body, 6, &count, &e));
  TRY(carom_body_get_pose(copy, body[5], top, NULL, &e));
  printf("%d bodies went on, the last one is at y = %.2f m; the same bits: %s\n", (int)count, top[1],
         hash == copied ? "yes" : "no");
  CHECK(hash == copied && fabs(top[1] - 4.5) < 0.01);
  TRY(carom_world_destroy(copy, &e));
  TRY(carom_engine_destroy(other, &e));
  TRY(carom_world_destroy(world, &e));
  TRY(carom_engine_destroy(engine, &e));
  return 0;
}
