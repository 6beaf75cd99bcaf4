/* Joints and a motor: a motor turns a hinge at 1 rad/s, and a limit stops it at 1 rad. */
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
  carom_body rod;
  carom_joint hinge;
  carom_joint_desc desc;
  carom_joint_motor motor;
  carom_joint_limit limit;
  carom_joint_state state = {.struct_size = sizeof state};
  const double half[3] = {0.5, 0.05, 0.05}, at[3] = {0.5, 0, 0};
  double angle[2];
  TRY(carom_engine_create(NULL, &engine, &e));
  TRY(carom_world_create(engine, NULL, &world, &e));
  TRY(carom_body_create_named(world, CAROM_BODY_DYNAMIC, "box", half, 3, at, &rod, &e));
  TRY(carom_joint_desc_init(&desc, sizeof desc));
  desc.kind = CAROM_JOINT_HINGE, desc.fields = CAROM_JOINT_WORLD_FRAME, desc.body_b = rod; /* at the origin */
  desc.orientation_a[1] = -sqrt(0.5), desc.orientation_a[3] = sqrt(0.5); /* its x axis is the world's z axis */
  TRY(carom_joint_create(world, &desc, &hinge, &e));
  TRY(carom_joint_motor_init(&motor, sizeof motor));
  motor.enabled = 1, motor.speed = 1, motor.max_force = 200; /* rad/s, N m */
  TRY(carom_joint_set_motor(world, hinge, CAROM_COORDINATE_TWIST, &motor, &e));
  TRY(carom_joint_limit_init(&limit, sizeof limit));
  limit.enabled = 1, limit.lower = -1, limit.upper = 1; /* rad */
  TRY(carom_joint_set_limit(world, hinge, CAROM_COORDINATE_TWIST, &limit, &e));
  for (int i = 0; i < 2; i++) {
    for (int step = 0; step < 30 + 90 * i; step++) TRY(carom_world_step(world, 1.0 / 60, &e));
    TRY(carom_joint_get_state(world, hinge, &state, &e));
    angle[i] = state.coordinate[CAROM_COORDINATE_TWIST];
  }
  printf("%.2f rad after 0.5 s, %.2f rad after 2.5 s, at the limit\n", angle[0], angle[1]);
  CHECK(fabs(angle[0] - 0.5) < 0.02 && fabs(angle[1] - 1) < 0.01);
  TRY(carom_world_destroy(world, &e));
  TRY(carom_engine_destroy(engine, &e));
  return 0;
}
