/* Dials: a pendulum of a preset for crowds, and the same with one dial turned. */
#include <carom/carom.h>
#include <math.h>
#include <stdio.h>
#define TRY(call) \
  if ((call) != CAROM_OK) return fprintf(stderr, "%s. %s\n", e.message, e.remedy), 1
#define CHECK(what) \
  if (!(what)) return fprintf(stderr, "wrong: %s\n", #what), 1

/* m, after 2 s; where the ball should be follows from the equation of motion. */
static int error_of(int substeps, int order, double* error) {
  carom_error e = CAROM_ERROR_INIT;
  carom_engine* engine;
  carom_world* world;
  carom_body ball;
  carom_joint rod;
  carom_joint_desc desc;
  const double radius = 0.1, at[3] = {1, 0, 0};
  double position[3];
  TRY(carom_engine_create(NULL, &engine, &e));
  TRY(carom_world_create(engine, NULL, &world, &e));
  TRY(carom_world_set_preset(world, CAROM_PRESET_FAST, &e));
  if (substeps) TRY(carom_world_set_dial(world, CAROM_DIAL_SUBSTEPS, substeps, &e));
  if (order) TRY(carom_world_set_dial(world, CAROM_DIAL_JOINT_ORDER, order, &e));
  TRY(carom_body_create_named(world, CAROM_BODY_DYNAMIC, "sphere", &radius, 1, at, &ball, &e));
  TRY(carom_joint_desc_init(&desc, sizeof desc));
  desc.kind = CAROM_JOINT_BALL, desc.fields = CAROM_JOINT_WORLD_FRAME, desc.body_b = ball; /* at the origin */
  TRY(carom_joint_create(world, &desc, &rod, &e));
  for (int i = 0; i < 120; i++) TRY(carom_world_step(world, 1.0 / 60, &e));
  TRY(carom_body_get_pose(world, ball, position, NULL, &e));
  *error = fabs(position[0] - 0.7850683);
  TRY(carom_world_destroy(world, &e));
  TRY(carom_engine_destroy(engine, &e));
  return 0;
}

int main(void) {
  double fast, finer, exact;
  if (error_of(0, 0, &fast) || error_of(8, 0, &finer) || error_of(8, 4, &exact)) return 1;
  printf("off by %.2f mm; with 8 substeps by %.3f mm; of order 4 by less than 1 um: %s\n", 1e3 * fast, 1e3 * finer,
         exact < 1e-6 ? "yes" : "no");
  CHECK(fast > 1e-3 && 1e-3 > 10 * finer && exact < 1e-6);
  return 0;
}
