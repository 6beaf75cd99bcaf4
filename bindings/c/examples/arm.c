/* A robot's arm by inverse dynamics: two links of 2 kg move to a pose and stay there, against gravity. */
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
  carom_body link[2];
  carom_joint joint[2];
  const double half[3] = {0.5, 0.05, 0.05}, center[3] = {0, 0, 0}, inertia[9] = {0.01, 0, 0, 0, 0.17, 0, 0, 0, 0.17};
  const double still[2] = {0, 0}, goal[2] = {0.5, -0.5}; /* rad */
  double level[2], angle[2], speed[2], wanted[2], torque[2];
  TRY(carom_engine_create(NULL, &engine, &e));
  TRY(carom_world_create(engine, NULL, &world, &e));
  for (int i = 0; i < 2; i++) { /* links along x, hinges about z */
    const double at[3] = {i + 0.5, 0, 0};
    carom_joint_desc desc;
    TRY(carom_body_create_named(world, CAROM_BODY_DYNAMIC, "box", half, 3, at, &link[i], &e));
    TRY(carom_body_set_mass(world, link[i], 2, center, inertia, &e));
    TRY(carom_joint_desc_init(&desc, sizeof desc));
    desc.kind = CAROM_JOINT_HINGE, desc.fields = CAROM_JOINT_WORLD_FRAME, desc.position_a[0] = i;
    desc.orientation_a[1] = -sqrt(0.5), desc.orientation_a[3] = sqrt(0.5);
    desc.body_a = i ? link[0] : CAROM_NULL_HANDLE, desc.body_b = link[i];
    TRY(carom_joint_create(world, &desc, &joint[i], &e));
  }
  TRY(carom_tree_get_forces(world, link[1], still, NULL, level, 2, &e)); /* what bears the weight in the first pose */
  for (int step = 0; step < 120; step++) {
    TRY(carom_world_read_joints(world, CAROM_JOINT_BULK_POSITION, CAROM_SCALAR_F64, joint, 2, angle, 0, &e));
    TRY(carom_world_read_joints(world, CAROM_JOINT_BULK_VELOCITY, CAROM_SCALAR_F64, joint, 2, speed, 0, &e));
    for (int i = 0; i < 2; i++) wanted[i] = 400 * (goal[i] - angle[i]) - 40 * speed[i]; /* rad/s^2 */
    TRY(carom_tree_get_forces(world, link[1], NULL, wanted, torque, 2, &e));
    TRY(carom_world_write_joints(world, CAROM_JOINT_BULK_TARGET_EFFORT, CAROM_SCALAR_F64, joint, 2, torque, 0, &e));
    TRY(carom_world_step(world, 1.0 / 60, &e));
  }
  printf("%.2f and %.2f N m hold it level; after 2 s it is at %.2f and %.2f rad\n", level[0], level[1], angle[0],
         angle[1]);
  CHECK(fabs(level[0] - 4 * 9.81) < 1e-9 && fabs(level[1] - 9.81) < 1e-9);
  CHECK(fabs(angle[0] - 0.5) < 0.005 && fabs(angle[1] + 0.5) < 0.005);
  TRY(carom_world_destroy(world, &e));
  TRY(carom_engine_destroy(engine, &e));
  return 0;
}
