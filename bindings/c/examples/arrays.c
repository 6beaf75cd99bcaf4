/* Bulk arrays: velocities of 1000 balls are set in one call, their positions read in one. */
#include <carom/carom.h>
#include <math.h>
#include <stdio.h>
#define TRY(call) \
  if ((call) != CAROM_OK) return fprintf(stderr, "%s. %s\n", e.message, e.remedy), 1
#define CHECK(what) \
  if (!(what)) return fprintf(stderr, "wrong: %s\n", #what), 1

enum { N = 1000 };
static carom_body balls[N];
static double velocities[N][3], positions[N][3];

static double mean_height(void) {
  double sum = 0;
  for (int i = 0; i < N; i++) sum += positions[i][1];
  return sum / N;
}

int main(void) {
  carom_error e = CAROM_ERROR_INIT;
  carom_engine* engine;
  carom_world* world;
  const double radius = 0.5;
  double height[3];
  TRY(carom_engine_create(NULL, &engine, &e));
  TRY(carom_world_create(engine, NULL, &world, &e));
  for (int i = 0; i < N; i++) {
    positions[i][0] = 2 * (i / 100), positions[i][1] = 5 + 2 * (i / 10 % 10), positions[i][2] = 2 * (i % 10);
    velocities[i][1] = 9.81 / 2;
    TRY(carom_body_create_named(world, CAROM_BODY_DYNAMIC, "sphere", &radius, 1, positions[i], &balls[i], &e));
  }
  TRY(carom_world_write(world, CAROM_FIELD_LINEAR_VELOCITY, CAROM_SCALAR_F64, balls, N, velocities, 0, &e));
  height[0] = mean_height();
  for (int i = 1; i < 3; i++) {
    for (int step = 0; step < 30; step++) TRY(carom_world_step(world, 1.0 / 60, &e));
    TRY(carom_world_read(world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, balls, N, positions, 0, &e));
    height[i] = mean_height();
  }
  printf("%d balls rise by %.3f m and are back after 1 s, %.3f m off\n", N, height[1] - height[0],
         fabs(height[2] - height[0]));
  CHECK(fabs(height[1] - height[0] - 9.81 / 8) < 1e-9 && fabs(height[2] - height[0]) < 1e-9);
  TRY(carom_world_destroy(world, &e));
  TRY(carom_engine_destroy(engine, &e));
  return 0;
}
