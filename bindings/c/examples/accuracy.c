/* An accuracy that is asked for: a pendulum is off by no more than a micrometre per second of motion. */
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
  carom_body ball;
  carom_joint rod;
  carom_joint_desc desc;
  carom_accuracy asked;
  carom_island worst;
  uint64_t islands;
  const double radius = 0.1, at[3] = {1, 0, 0};
  double position[3];
  TRY(carom_engine_create(NULL, &engine, &e));
  TRY(carom_world_create(engine, NULL, &world, &e));
  TRY(carom_body_create_named(world, CAROM_BODY_DYNAMIC, "sphere", &radius, 1, at, &ball, &e));
  TRY(carom_joint_desc_init(&desc, sizeof desc));
  desc.kind = CAROM_JOINT_BALL, desc.fields = CAROM_JOINT_WORLD_FRAME, desc.body_b = ball; /* at the origin */
  TRY(carom_joint_create(world, &desc, &rod, &e));
  TRY(carom_accuracy_init(&asked, sizeof asked));
  asked.place = asked.turn = 1e-6; /* m and rad per second */
  TRY(carom_world_set_accuracy(world, &asked, &e));
  for (int i = 0; i < 120; i++) TRY(carom_world_step(world, 1.0 / 60, &e));
  TRY(carom_world_get_islands(world, &worst, sizeof worst, 1, &islands, &e));
  TRY(carom_body_get_pose(world, ball, position, NULL, &e));
  printf("after 2 s at x = %.5f m; the error is within what was asked: %s\n", position[0],
         worst.share <= 1 ? "yes" : "no");
  CHECK(islands == 1 && worst.share <= 1 && fabs(position[0] - 0.785070) < 5e-6); /* by its equation of motion */
  TRY(carom_world_destroy(world, &e));
  TRY(carom_engine_destroy(engine, &e));
  return 0;
}
