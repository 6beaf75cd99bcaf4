/* Snapshots and rollback: a guess about a player was wrong, so 30 steps are made again with what was really done. */
#include <carom/carom.h>
#include <math.h>
#include <stdio.h>
#define TRY(call) \
  if ((call) != CAROM_OK) return fprintf(stderr, "%s. %s\n", e.message, e.remedy), 1
#define CHECK(what) \
  if (!(what)) return fprintf(stderr, "wrong: %s\n", #what), 1

static const double still[3] = {0, 0, 0};

static int32_t play(carom_world* world, carom_body ball, const double push[3], int from, int to, carom_error* e) {
  int32_t result = CAROM_OK;
  for (int step = from; step < to && result == CAROM_OK; step++) {
    if (push && step == 70) result = carom_body_set_velocity(world, ball, push, still, e);
    if (result == CAROM_OK) result = carom_world_step(world, 1.0 / 60, e);
  }
  return result;
}

int main(void) {
  carom_error e = CAROM_ERROR_INIT;
  carom_engine* engine;
  carom_world* world;
  carom_world* truth; /* a world in which nothing is guessed */
  carom_body ground, ball, twin;
  static char saved[1 << 20];
  uint64_t size, hash, true_hash;
  const double up[4] = {0, 1, 0, 0}, origin[3] = {0, 0, 0}, radius = 0.5, at[3] = {0, 0.5, 0}, push[3] = {2, 0, 0};
  double guess[3], position[3];
  TRY(carom_engine_create(NULL, &engine, &e));
  TRY(carom_world_create(engine, NULL, &world, &e));
  TRY(carom_body_create_named(world, CAROM_BODY_STATIC, "half_space", up, 4, origin, &ground, &e));
  TRY(carom_body_create_named(world, CAROM_BODY_DYNAMIC, "sphere", &radius, 1, at, &ball, &e));
  TRY(play(world, ball, NULL, 0, 60, &e));
  TRY(carom_world_fork(world, &truth, &e));
  TRY(carom_world_translate_handles(truth, &ball, 1, &twin, &e)); /* the ball there */
  TRY(carom_world_save(world, CAROM_SNAPSHOT_STATE, saved, sizeof saved, &size, &e));
  TRY(play(world, ball, NULL, 60, 90, &e)); /* the guess: no push */
  TRY(carom_body_get_pose(world, ball, guess, NULL, &e));
  TRY(carom_world_restore(world, saved, size, &e));
  TRY(play(world, ball, push, 60, 90, &e));
  TRY(play(truth, twin, push, 60, 90, &e));
  TRY(carom_body_get_pose(world, ball, position, NULL, &e));
  TRY(carom_world_hash(world, &hash, &e));
  TRY(carom_world_hash(truth, &true_hash, &e));
  printf("guessed x = %.2f m, it was %.2f m; the same bits as without a guess: %s\n", guess[0], position[0],
         hash == true_hash ? "yes" : "no");
  CHECK(hash == true_hash && fabs(guess[0]) < 1e-6 && position[0] > 0.4);
  TRY(carom_world_destroy(truth, &e));
  TRY(carom_world_destroy(world, &e));
  TRY(carom_engine_destroy(engine, &e));
  return 0;
}
