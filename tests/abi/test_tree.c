/* Trees of joints: their order, what they refuse, and forces that hold a robot still. */
#include <stdio.h>

#include "bench.h"
#include "carom_test.h"

#define ARMS 3

static carom_joint hinge(const Bench* b, carom_body a, carom_body body, double x) {
  carom_joint_desc d;
  carom_joint joint;
  carom_joint_desc_init(&d, sizeof d);
  d.kind = CAROM_JOINT_HINGE, d.fields = CAROM_JOINT_WORLD_FRAME, d.body_a = a, d.body_b = body;
  d.position_a[0] = x, d.position_a[1] = 20;
  d.orientation_a[1] = -0.7071067811865476, d.orientation_a[3] = 0.7071067811865476; /* x along the world's z */
  assert_int_equal(carom_joint_create(b->world, &d, &joint, NULL), CAROM_OK);
  return joint;
}

/* A level arm of three links, each 1 m long, that hangs on nothing yet. Its joints are made the last first. */
static void make_arm(const Bench* b, carom_joint joint[ARMS], int is_held) {
  const double upright[4] = {0, 0, 0, 1}, none[3] = {0, 0, 0}, inertia[9] = {0.1, 0, 0, 0, 0.2, 0, 0, 0, 0.2};
  int i;
  for (i = 0; i < ARMS; ++i) {
    double at[3] = {0.5, 20, 0};
    at[0] += i;
    assert_int_equal(carom_body_set_pose(b->world, b->bodies[i], at, upright, NULL), CAROM_OK);
    assert_int_equal(carom_body_set_mass(b->world, b->bodies[i], 2, none, inertia, NULL), CAROM_OK);
  }
  for (i = ARMS; i-- > (is_held ? 0 : 1);)
    joint[i] = hinge(b, i ? b->bodies[i - 1] : CAROM_NULL_HANDLE, b->bodies[i], i);
}

static void coordinates_are_listed(void** state) {
  Bench bench, *b = &bench;
  carom_joint joint[ARMS];
  struct {
    carom_tree_coordinate c;
    uint64_t beside;
  } wide[8];
  carom_tree_coordinate c[10];
  uint64_t count = 0;
  int i;
  (void)state;
  assert_int_equal(bench_make(b, NULL, NULL), CAROM_OK);
  make_arm(b, joint, 0);
  memset(wide, 0x11, sizeof wide);
  assert_int_equal(carom_tree_get_coordinates(b->world, b->bodies[1], &wide[0].c, sizeof wide[0], 8, &count, NULL),
                   CAROM_OK);
  assert_int_equal(count, 8);
  for (i = 0; i < 6; ++i)
    assert_true(wide[i].c.joint == CAROM_NULL_HANDLE && wide[i].c.body == b->bodies[1] &&
                wide[i].c.axis == (uint32_t)i);
  /* The joint that was made first holds body 2, whichever end is named. */
  assert_true(wide[6].c.joint == joint[2] && wide[6].c.body == b->bodies[2] && wide[6].c.axis == CAROM_AXIS_TURN_X);
  assert_true(wide[7].c.joint == joint[1] && wide[7].c.body == b->bodies[0]);
  assert_true(wide[7].beside == 0x1111111111111111u);
  joint[0] = hinge(b, CAROM_NULL_HANDLE, b->bodies[0], 0);
  memset(c, 0x11, sizeof c);
  assert_int_equal(carom_tree_get_coordinates(b->world, b->bodies[2], c, sizeof c[0], 2, &count, NULL), CAROM_OK);
  assert_true(count == 3 && c[0].body == b->bodies[2] && c[1].body == b->bodies[1] && c[1].reserved == 0);
  assert_int_equal(c[2].axis, 0x11111111); /* capacity are written */
  assert_int_equal(bench_free(b), CAROM_OK);
}

/* A level arm for a second on motors whose efforts are found anew before each step.
   @return its fastest joint, rad/s, or what has turned farthest, rad */
static double motion_of_held_arm(int steps) {
  Bench bench, *b = &bench;
  carom_joint joint[ARMS];
  double force[ARMS], speed[ARMS], list[ARMS], most = 0;
  int i;
  assert_int_equal(bench_make(b, NULL, NULL), CAROM_OK);
  make_arm(b, joint, 1);
  for (i = 0; i < steps; ++i) {
    assert_int_equal(carom_tree_get_forces(b->world, b->bodies[0], NULL, NULL, force, ARMS, NULL), CAROM_OK);
    assert_int_equal(carom_world_write_joints(b->world, CAROM_JOINT_BULK_TARGET_EFFORT, CAROM_SCALAR_F64, NULL, ARMS,
                                              force, 0, NULL),
                     CAROM_OK);
    assert_int_equal(carom_world_step(b->world, 1.0 / steps, NULL), CAROM_OK);
  }
  assert_int_equal(carom_tree_get_speeds(b->world, b->bodies[0], speed, ARMS, NULL), CAROM_OK);
  assert_int_equal(
      carom_world_read_joints(b->world, CAROM_JOINT_BULK_VELOCITY, CAROM_SCALAR_F64, NULL, ARMS, list, 0, NULL),
      CAROM_OK);
  for (i = 0; i < ARMS; ++i) {
    assert_true(fabs(speed[i] - list[i]) < 1e-14);
    most = fmax(most, fabs(speed[i]));
  }
  assert_int_equal(
      carom_world_read_joints(b->world, CAROM_JOINT_BULK_POSITION, CAROM_SCALAR_F64, NULL, ARMS, list, 0, NULL),
      CAROM_OK);
  for (i = 0; i < ARMS; ++i) most = fmax(most, fabs(list[i]));
  assert_int_equal(bench_free(b), CAROM_OK);
  return most;
}

/* The torque of a joint bears the weights beyond it. Motors of those efforts hold the arm to rounding. */
static void its_efforts_hold_it(void** state) {
  Bench bench, *b = &bench;
  carom_joint joint[ARMS];
  const double g = 9.81, m = 2, still[ARMS] = {0, 0, 0};
  double force[ARMS];
  uint64_t hash, before;
  (void)state;
  assert_int_equal(bench_make(b, NULL, NULL), CAROM_OK);
  make_arm(b, joint, 1);
  assert_int_equal(carom_world_hash(b->world, &before, NULL), CAROM_OK);
  assert_int_equal(carom_tree_get_forces(b->world, b->bodies[0], still, NULL, force, ARMS, NULL), CAROM_OK);
  /* in the order of joints: 2, 1, 0 */
  assert_true(fabs(force[0] - m * g * 0.5) < 1e-12 && fabs(force[1] - m * g * (0.5 + 1.5)) < 1e-12);
  assert_true(fabs(force[2] - m * g * (0.5 + 1.5 + 2.5)) < 1e-12);
  assert_int_equal(carom_world_hash(b->world, &hash, NULL), CAROM_OK);
  assert_true(hash == before);
  assert_int_equal(bench_free(b), CAROM_OK);
  assert_true(motion_of_held_arm(64) < 1e-12 && motion_of_held_arm(128) < 1e-12);
}

/* Forward: M a = -bias is how the arm begins to fall. */
static void it_falls_as_its_mass_says(void** state) {
  Bench bench, *b = &bench;
  carom_joint joint[ARMS];
  const double h = 1e-6;
  double bias[ARMS], mass[ARMS][ARMS], speed[ARMS];
  int i, k;
  (void)state;
  assert_int_equal(bench_make(b, NULL, NULL), CAROM_OK);
  make_arm(b, joint, 1);
  assert_int_equal(carom_tree_get_forces(b->world, b->bodies[2], NULL, NULL, bias, ARMS, NULL), CAROM_OK);
  assert_int_equal(carom_tree_get_mass(b->world, b->bodies[2], &mass[0][0], ARMS, NULL), CAROM_OK);
  assert_int_equal(carom_world_step(b->world, h, NULL), CAROM_OK);
  assert_int_equal(carom_tree_get_speeds(b->world, b->bodies[2], speed, ARMS, NULL), CAROM_OK);
  for (i = 0; i < ARMS; ++i) {
    double sum = bias[i];
    for (k = 0; k < ARMS; ++k) sum += mass[i][k] * speed[k] / h;
    assert_true(fabs(sum) < 1e-6 * fabs(bias[2]));
  }
  assert_int_equal(bench_free(b), CAROM_OK);
}

static void what_is_no_tree_is_named(void** state) {
  Bench bench, *b = &bench;
  carom_joint joint[ARMS], other;
  carom_joint_desc d;
  carom_error e = CAROM_ERROR_INIT;
  char shown[32];
  double v[ARMS];
  uint64_t count = 77;
  (void)state;
  assert_int_equal(bench_make(b, NULL, NULL), CAROM_OK);
  make_arm(b, joint, 1);
  carom_joint_desc_init(&d, sizeof d);
  d.kind = CAROM_JOINT_GEAR, d.body_a = b->bodies[0], d.body_b = b->bodies[2];
  assert_int_equal(carom_joint_create(b->world, &d, &other, NULL), CAROM_OK);
  assert_int_equal(carom_tree_get_speeds(b->world, b->bodies[1], v, ARMS, &e), CAROM_E_UNSUPPORTED);
  assert_true(e.argument == 2 && strstr(e.message, "gear") && strstr(e.remedy, "hinges"));
  snprintf(shown, sizeof shown, "0x%016llx", (unsigned long long)other);
  assert_true(strstr(e.message, shown));
  assert_int_equal(carom_joint_destroy(b->world, other, NULL), CAROM_OK);
  other = hinge(b, CAROM_NULL_HANDLE, b->bodies[2], 3);
  assert_int_equal(carom_tree_get_coordinates(b->world, b->bodies[1], NULL, 0, 0, &count, &e), CAROM_E_UNSUPPORTED);
  assert_true(strstr(e.message, "loop") && strstr(e.remedy, "leave out") && count == 77);
  assert_int_equal(carom_joint_destroy(b->world, other, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_locks(b->world, b->bodies[1], CAROM_LOCK_LINEAR_Z, NULL), CAROM_OK);
  assert_int_equal(carom_tree_get_speeds(b->world, b->bodies[2], v, ARMS, &e), CAROM_E_UNSUPPORTED);
  snprintf(shown, sizeof shown, "0x%016llx", (unsigned long long)b->bodies[1]);
  assert_true(strstr(e.message, shown) && strstr(e.message, "locked"));
  assert_int_equal(carom_tree_get_speeds(b->world, b->ground, v, ARMS, &e), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(bench_free(b), CAROM_OK);
}

/* A tree of bodies that welds alone hold to the ground has no coordinates. */
static void none_is_a_number_too(void** state) {
  Bench bench, *b = &bench;
  carom_joint_desc d;
  carom_joint weld;
  uint64_t count = 77;
  (void)state;
  assert_int_equal(bench_make(b, NULL, NULL), CAROM_OK);
  carom_joint_desc_init(&d, sizeof d);
  d.kind = CAROM_JOINT_WELD, d.fields = CAROM_JOINT_WORLD_FRAME, d.body_a = b->ground, d.body_b = b->bodies[0];
  assert_int_equal(carom_joint_create(b->world, &d, &weld, NULL), CAROM_OK);
  assert_int_equal(carom_tree_get_coordinates(b->world, b->bodies[0], NULL, 0, 0, &count, NULL), CAROM_OK);
  assert_int_equal(count, 0);
  assert_int_equal(carom_tree_get_speeds(b->world, b->bodies[0], NULL, 0, NULL), CAROM_OK);
  assert_int_equal(carom_tree_get_forces(b->world, b->bodies[0], NULL, NULL, NULL, 0, NULL), CAROM_OK);
  assert_int_equal(carom_tree_get_mass(b->world, b->bodies[0], NULL, 0, NULL), CAROM_OK);
  assert_int_equal(bench_free(b), CAROM_OK);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(coordinates_are_listed), cmocka_unit_test(its_efforts_hold_it),
                                     cmocka_unit_test(it_falls_as_its_mass_says),
                                     cmocka_unit_test(what_is_no_tree_is_named),
                                     cmocka_unit_test(none_is_a_number_too)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
