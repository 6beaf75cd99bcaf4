/* What a call costs from C: reading the position of a body, and of 10,000 in one call. Every calls.* measures the same, and host.py
 * --calls compares them. Prints "NS NS": the fastest of 7 rounds, for one call and for one call of 10,000. */
#include <carom/carom.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define TRY(call)                                       \
  do {                                                  \
    if ((call) != CAROM_OK) {                           \
      fprintf(stderr, "%s. %s\n", e.message, e.remedy); \
      return 1;                                         \
    }                                                   \
  } while (0)
enum { BODIES = 10000, ROUNDS = 7, SINGLE = 200000, BULK = 100 };

static double now(void) {
  struct timespec t;
  timespec_get(&t, TIME_UTC);
  return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

int main(void) {
  static carom_body bodies[BODIES];
  static double positions[3 * BODIES];
  carom_error e = CAROM_ERROR_INIT;
  carom_engine* engine;
  carom_world* world;
  const double radius = 0.5;
  double single = 1e99, bulk = 1e99, sum = 0;
  TRY(carom_engine_create(NULL, &engine, &e));
  TRY(carom_world_create(engine, NULL, &world, &e));
  for (int i = 0; i < BODIES; i++) {
    const double at[3] = {2.0 * i, 0, 0};
    TRY(carom_body_create_named(world, CAROM_BODY_DYNAMIC, "sphere", &radius, 1, at, &bodies[i], &e));
  }
  for (int round = 0; round < ROUNDS; round++) {
    double start = now(), took;
    for (int i = 0; i < SINGLE; i++) {
      double position[3];
      TRY(carom_body_get_pose(world, bodies[i % BODIES], position, NULL, &e));
      sum += position[0];
    }
    if ((took = (now() - start) / SINGLE) < single) single = took;
    start = now();
    for (int i = 0; i < BULK; i++)
      TRY(carom_world_read(world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, NULL, BODIES, positions, 0, &e));
    if ((took = (now() - start) / BULK) < bulk) bulk = took;
  }
  printf("%.1f %.0f\n", single, bulk);
  TRY(carom_world_destroy(world, &e));
  TRY(carom_engine_destroy(engine, &e));
  return sum > 0 && positions[3] == 2 ? 0 : 1;
}
