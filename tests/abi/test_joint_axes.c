/* Six-axis joints and drives to an orientation as a host uses them: set, read, refused, saved. */
#include "bench.h"
#include "carom_test.h"

static int make(void** state) {
  static Bench b;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  *state = &b;
  return 0;
}
static int clear(void** state) {
  assert_int_equal(bench_free(*state), CAROM_OK);
  return 0;
}

static carom_joint join(const Bench* b, uint32_t kind, carom_body x, carom_body y) {
  carom_joint_desc d;
  carom_joint joint = 0;
  assert_int_equal(carom_joint_desc_init(&d, sizeof d), CAROM_OK);
  d.kind = kind, d.body_a = x, d.body_b = y, d.fields = CAROM_JOINT_WORLD_FRAME, d.position_a[1] = 4;
  assert_int_equal(carom_joint_create(b->world, &d, &joint, NULL), CAROM_OK);
  return joint;
}
static carom_joint_axis axis_desc(void) {
  carom_joint_axis d;
  assert_int_equal(carom_joint_axis_init(&d, sizeof d), CAROM_OK);
  return d;
}
static carom_joint_orientation_drive drive_desc(void) {
  carom_joint_orientation_drive d;
  assert_int_equal(carom_joint_orientation_drive_init(&d, sizeof d), CAROM_OK);
  return d;
}

/* Every number comes back as it was set. A limit that has no width, and what is locked, holds; broken ones do not. */
static void axes_are_what_was_set(void** state) {
  Bench* b = *state;
  const carom_joint joint = join(b, CAROM_JOINT_SIX_AXIS, CAROM_NULL_HANDLE, b->bodies[0]);
  carom_joint_axis axis = axis_desc(), back;
  carom_joint_orientation_drive drive = drive_desc(), drive_back;
  carom_joint_state s;
  uint32_t k;
  assert_true(axis.effort_limit == 1e30 && axis.speed_limit == 1e30);
  assert_true(axis.struct_size == sizeof axis && axis.max_force == 1e30 && axis.mode == CAROM_AXIS_MODE_FREE);
  assert_true(drive.struct_size == sizeof drive && drive.target[3] == 1 && drive.max_force[2] == 1e30);
  for (k = 0; k < CAROM_AXIS_COUNT; ++k) {
    back = axis_desc();
    assert_int_equal(carom_joint_get_axis(b->world, joint, k, &back, NULL), CAROM_OK);
    assert_memory_equal(&axis, &back, sizeof axis);
  }
  axis.mode = CAROM_AXIS_MODE_LIMITED, axis.lower = -0.1, axis.upper = 0.2, axis.drive = CAROM_DRIVE_EFFORT;
  axis.stop_gains = CAROM_GAINS_FORCE, axis.stop_stiffness = 900, axis.stop_damping = 7, axis.effort = -3,
  axis.max_force = 5;
  axis.drive_gains = CAROM_GAINS_ACCELERATION, axis.drive_stiffness = 2e5, axis.drive_damping = 2e4, axis.target = 0.3;
  axis.speed = 1.5, axis.rest = -0.4, axis.spring_stiffness = 3, axis.spring_damping = 0.5;
  axis.friction = 0.25, axis.armature = 0.01, axis.effort_limit = 4, axis.speed_limit = 1.25;
  assert_int_equal(carom_joint_set_axis(b->world, joint, CAROM_AXIS_TURN_Y, &axis, NULL), CAROM_OK);
  assert_int_equal(carom_joint_get_axis(b->world, joint, CAROM_AXIS_TURN_Y, &back, NULL), CAROM_OK);
  assert_memory_equal(&axis, &back, sizeof axis);
  drive.drive = CAROM_DRIVE_POSITION, drive.gains = CAROM_GAINS_FORCE, drive.stiffness = 20, drive.damping = 3;
  drive.target[0] = 0.6, drive.target[3] = 0.8, drive.velocity[1] = 2, drive.effort[2] = -4, drive.max_force[0] = 9;
  drive_back = drive_desc();
  assert_int_equal(carom_joint_set_orientation_drive(b->world, joint, &drive, NULL), CAROM_OK);
  assert_int_equal(carom_joint_get_orientation_drive(b->world, joint, &drive_back, NULL), CAROM_OK);
  assert_true(fabs(drive_back.target[0] - 0.6) < 1e-15 && fabs(drive_back.target[3] - 0.8) < 1e-15);
  memcpy(drive_back.target, drive.target, sizeof drive.target);
  assert_memory_equal(&drive, &drive_back, sizeof drive);
  assert_int_equal(bench_steps(b->world, 20, NULL), CAROM_OK);
  memset(&s, 0, sizeof s);
  s.struct_size = sizeof s;
  assert_int_equal(carom_joint_get_state(b->world, joint, &s, NULL), CAROM_OK);
  assert_true(s.axis[CAROM_AXIS_Y] != 0 && s.gap == 0);
  s.axis[0] = 77, s.struct_size = offsetof(carom_joint_state, axis); /* of an older header */
  assert_int_equal(carom_joint_get_state(b->world, joint, &s, NULL), CAROM_OK);
  assert_true(s.axis[0] == 77);
}

/* What is wrong is refused, says where, and changes nothing. */
static void wrong_axes_are_refused(void** state) {
  Bench* b = *state;
  const carom_joint six = join(b, CAROM_JOINT_SIX_AXIS, CAROM_NULL_HANDLE, b->bodies[0]);
  const carom_joint ball = join(b, CAROM_JOINT_BALL, CAROM_NULL_HANDLE, b->bodies[1]);
  const carom_joint hinge = join(b, CAROM_JOINT_HINGE, CAROM_NULL_HANDLE, b->bodies[2]);
  carom_joint_axis d;
  carom_joint_orientation_drive t;
  carom_joint_limit limit;
  carom_error e = CAROM_ERROR_INIT;
  const uint64_t hash = bench_hash(b->world);
#define AXIS_REFUSED(code, axis, change, word)                                 \
  do {                                                                         \
    d = axis_desc();                                                           \
    change;                                                                    \
    assert_int_equal(carom_joint_set_axis(b->world, six, axis, &d, &e), code); \
    assert_true(strstr(e.message, word) && e.remedy[0]);                       \
  } while (0)
  AXIS_REFUSED(CAROM_E_UNKNOWN_ENUM, CAROM_AXIS_COUNT, (void)0, "axis");
  AXIS_REFUSED(CAROM_E_UNKNOWN_ENUM, 0, d.mode = 3, "mode");
  AXIS_REFUSED(CAROM_E_UNKNOWN_ENUM, 0, d.drive = 4, "drive");
  AXIS_REFUSED(CAROM_E_UNKNOWN_ENUM, 0, d.stop_gains = 3, "stop_gains");
  AXIS_REFUSED(CAROM_E_UNKNOWN_ENUM, 0, d.spring_gains = 9, "spring_gains");
  AXIS_REFUSED(CAROM_E_OUT_OF_RANGE, 3, d.lower = 1001, "lower");
  AXIS_REFUSED(CAROM_E_OUT_OF_RANGE, 0, (d.mode = CAROM_AXIS_MODE_LIMITED, d.lower = 1), "upper");
  AXIS_REFUSED(CAROM_E_OUT_OF_RANGE, 0, d.drive_stiffness = 1e5, "drive_stiffness");
  AXIS_REFUSED(CAROM_E_OUT_OF_RANGE, 0, d.stop_damping = -1, "stop_damping");
  AXIS_REFUSED(CAROM_E_OUT_OF_RANGE, 0, d.max_force = -1, "max_force");
  AXIS_REFUSED(CAROM_E_NOT_FINITE, 0, d.effort = INFINITY, "effort");
  AXIS_REFUSED(CAROM_E_NOT_FINITE, 5, d.rest = NAN, "rest");
  AXIS_REFUSED(CAROM_E_OUT_OF_RANGE, 2, d.effort_limit = -1, "effort_limit");
  AXIS_REFUSED(CAROM_E_NOT_FINITE, 2, d.speed_limit = INFINITY, "speed_limit");
  d = axis_desc();
  assert_int_equal(carom_joint_set_axis(b->world, ball, 0, &d, &e), CAROM_E_UNSUPPORTED);
  assert_true(e.argument == 4 && strstr(e.message, "ball") && strstr(e.message, "SIX_AXIS"));
  assert_int_equal(carom_joint_get_axis(b->world, hinge, 0, &d, NULL), CAROM_E_UNSUPPORTED);
  d = axis_desc();
  assert_int_equal(carom_joint_set_axis(b->world, hinge, CAROM_AXIS_TURN_Y, &d, &e), CAROM_E_UNSUPPORTED);
  assert_true(e.argument == 4 && strstr(e.message, "hinge") && strstr(e.remedy, "CAROM_AXIS_TURN_X"));
  assert_int_equal(carom_joint_set_axis(b->world, six, 0, NULL, NULL), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_joint_axis_init(NULL, sizeof(carom_joint_axis)), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_joint_orientation_drive_init(NULL, sizeof(carom_joint_orientation_drive)),
                   CAROM_E_NULL_ARGUMENT);
  t = drive_desc();
  assert_int_equal(carom_joint_set_orientation_drive(b->world, hinge, &t, &e), CAROM_E_UNSUPPORTED);
  assert_true(e.argument == 3 && strstr(e.message, "hinge"));
  t.target[3] = 2;
  assert_int_equal(carom_joint_set_orientation_drive(b->world, ball, &t, &e), CAROM_E_NOT_UNIT);
  t = drive_desc(), t.reserved = 1;
  assert_int_equal(carom_joint_set_orientation_drive(b->world, ball, &t, NULL), CAROM_E_UNSUPPORTED);
  t = drive_desc(), t.max_force[1] = -1;
  assert_int_equal(carom_joint_set_orientation_drive(b->world, ball, &t, &e), CAROM_E_OUT_OF_RANGE);
  assert_true(strstr(e.message, "max_force[1]"));
  carom_joint_limit_init(&limit, sizeof limit);
  assert_int_equal(carom_joint_set_limit(b->world, six, CAROM_COORDINATE_TWIST, &limit, &e), CAROM_E_UNSUPPORTED);
  assert_true(strstr(e.message, "six_axis"));
  assert_true(bench_hash(b->world) == hash);
}

static void drive_all(const Bench* b, carom_joint six, carom_joint ball, double by) {
  carom_joint_axis d = axis_desc();
  carom_joint_orientation_drive t = drive_desc();
  d.drive = CAROM_DRIVE_POSITION, d.drive_stiffness = 2, d.drive_damping = 0.5, d.target = by;
  assert_int_equal(carom_joint_set_axis(b->world, six, CAROM_AXIS_X, &d, NULL), CAROM_OK);
  d = axis_desc(), d.mode = CAROM_AXIS_MODE_LIMITED, d.lower = -by, d.upper = by, d.stop_stiffness = 5;
  d.spring_gains = CAROM_GAINS_FORCE, d.spring_stiffness = 100;
  assert_int_equal(carom_joint_set_axis(b->world, six, CAROM_AXIS_Y, &d, NULL), CAROM_OK);
  d = axis_desc(), d.mode = CAROM_AXIS_MODE_LOCKED, d.lower = by;
  assert_int_equal(carom_joint_set_axis(b->world, six, CAROM_AXIS_TURN_Z, &d, NULL), CAROM_OK);
  t.drive = CAROM_DRIVE_POSITION, t.stiffness = 1.5, t.damping = 0.3, t.target[1] = 0.6, t.target[3] = 0.8,
  t.velocity[0] = by;
  assert_int_equal(carom_joint_set_orientation_drive(b->world, ball, &t, NULL), CAROM_OK);
}

/* All of it is part of a snapshot and of a copy: from there all goes on to the same bits, under each solver, however many
 * joints came and went before. */
static void axes_come_back(void** state) {
  Bench* b = *state;
  static unsigned char bytes[1 << 17];
  uint64_t size, hash;
  uint32_t solver;
  const carom_joint gone = join(b, CAROM_JOINT_SIX_AXIS, b->bodies[0], b->bodies[2]);
  const carom_joint six = join(b, CAROM_JOINT_SIX_AXIS, b->bodies[0], b->bodies[1]);
  const carom_joint ball = join(b, CAROM_JOINT_BALL, b->bodies[2], b->bodies[3]);
  drive_all(b, six, ball, 0.2);
  assert_int_equal(carom_joint_destroy(b->world, gone, NULL), CAROM_OK);
  for (solver = CAROM_SOLVER_SOFT_STEP; solver <= CAROM_SOLVER_AUTO; ++solver) {
    carom_world* other = NULL;
    carom_joint_axis axis = axis_desc();
    assert_int_equal(carom_world_set_dial(b->world, CAROM_DIAL_SOLVER, solver, NULL), CAROM_OK);
    assert_int_equal(bench_steps(b->world, 20, NULL), CAROM_OK);
    assert_int_equal(carom_world_save(b->world, 0, bytes, sizeof bytes, &size, NULL), CAROM_OK);
    assert_int_equal(carom_world_fork(b->world, &other, NULL), CAROM_OK);
    assert_int_equal(bench_steps(b->world, 20, NULL), CAROM_OK);
    hash = bench_hash(b->world);
    assert_int_equal(bench_steps(other, 20, NULL), CAROM_OK);
    assert_true(bench_hash(other) == hash);
    assert_int_equal(carom_world_destroy(other, NULL), CAROM_OK);
    drive_all(b, six, ball, 0.4);
    assert_int_equal(bench_steps(b->world, 3, NULL), CAROM_OK);
    assert_int_equal(carom_world_restore(b->world, bytes, size, NULL), CAROM_OK);
    assert_int_equal(carom_joint_get_axis(b->world, six, CAROM_AXIS_Y, &axis, NULL), CAROM_OK);
    assert_true(axis.upper == 0.2 && axis.stop_stiffness == 5 && axis.spring_gains == CAROM_GAINS_FORCE);
    assert_int_equal(bench_steps(b->world, 20, NULL), CAROM_OK);
    assert_true(bench_hash(b->world) == hash);
  }
}

/* A hinge and a slider have one axis, whose properties come, go and come back by snapshots, whole ones and copies. */
static void hinges_and_sliders_have_an_axis(void** state) {
  Bench* b = *state;
  static unsigned char bytes[1 << 17], whole[1 << 18];
  uint64_t size, whole_size, hash;
  const uint32_t axis_of[2] = {CAROM_AXIS_TURN_X, CAROM_AXIS_X};
  const double one[2] = {1.5, 0.25}, none[2] = {0, 0}, free[2] = {1e30, 1e30}, gains[4] = {20, 3, 10, 0.5};
  double back[2], gains_back[4];
  carom_joint joint[2];
  carom_joint_axis d, set;
  int i;
  uint32_t solver;
  joint[0] = join(b, CAROM_JOINT_HINGE, b->bodies[0], b->bodies[1]);
  joint[1] = join(b, CAROM_JOINT_SLIDER, b->bodies[2], b->bodies[3]);
  for (i = 0; i < 2; ++i) { /* nothing, until something is set */
    d = axis_desc(), set = axis_desc();
    assert_int_equal(carom_joint_get_axis(b->world, joint[i], axis_of[i], &d, NULL), CAROM_OK);
    assert_memory_equal(&d, &set, sizeof d);
    set.friction = 0.1, set.armature = 0.3, set.spring_gains = CAROM_GAINS_FORCE, set.spring_damping = 0.2;
    set.speed_limit = 3, set.effort_limit = 2;
    assert_int_equal(carom_joint_set_axis(b->world, joint[i], axis_of[i], &set, NULL), CAROM_OK);
    assert_int_equal(carom_joint_get_axis(b->world, joint[i], axis_of[i], &d, NULL), CAROM_OK);
    assert_memory_equal(&d, &set, sizeof d);
  }
  for (solver = CAROM_SOLVER_SOFT_STEP; solver <= CAROM_SOLVER_AUTO; ++solver) {
    carom_world* other = NULL;
    assert_int_equal(carom_world_set_dial(b->world, CAROM_DIAL_SOLVER, solver, NULL), CAROM_OK);
    assert_int_equal(bench_steps(b->world, 20, NULL), CAROM_OK);
    assert_int_equal(carom_world_save(b->world, 0, bytes, sizeof bytes, &size, NULL), CAROM_OK);
    assert_int_equal(carom_world_save(b->world, CAROM_SNAPSHOT_WHOLE, whole, sizeof whole, &whole_size, NULL),
                     CAROM_OK);
    assert_int_equal(carom_world_fork(b->world, &other, NULL), CAROM_OK);
    assert_int_equal(bench_steps(b->world, 20, NULL), CAROM_OK);
    hash = bench_hash(b->world);
    assert_int_equal(bench_steps(other, 20, NULL), CAROM_OK);
    assert_true(bench_hash(other) == hash);
    assert_int_equal(carom_world_restore(other, whole, whole_size, NULL), CAROM_OK);
    assert_int_equal(bench_steps(other, 20, NULL), CAROM_OK);
    assert_true(bench_hash(other) == hash);
    assert_int_equal(carom_world_destroy(other, NULL), CAROM_OK);
    set = axis_desc(); /* nothing again, of one or of both */
    for (i = 0; i < 2; ++i)
      if (i || solver % 2) assert_int_equal(carom_joint_set_axis(b->world, joint[i], axis_of[i], &set, NULL), CAROM_OK);
    assert_int_equal(bench_steps(b->world, 3, NULL), CAROM_OK);
    assert_int_equal(carom_world_restore(b->world, bytes, size, NULL), CAROM_OK);
    d = axis_desc();
    assert_int_equal(carom_joint_get_axis(b->world, joint[1], axis_of[1], &d, NULL), CAROM_OK);
    assert_true(d.friction == 0.1 && d.armature == 0.3 && d.speed_limit == 3 && d.effort_limit == 2);
    assert_int_equal(bench_steps(b->world, 20, NULL), CAROM_OK);
    assert_true(bench_hash(b->world) == hash);
  }
  /* What a snapshot does not have goes. */
  set = axis_desc();
  for (i = 0; i < 2; ++i) assert_int_equal(carom_joint_set_axis(b->world, joint[i], axis_of[i], &set, NULL), CAROM_OK);
  assert_int_equal(carom_world_save(b->world, 0, bytes, sizeof bytes, &size, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b->world, 5, NULL), CAROM_OK);
  hash = bench_hash(b->world);
  set.armature = 2;
  for (i = 0; i < 2; ++i) assert_int_equal(carom_joint_set_axis(b->world, joint[i], axis_of[i], &set, NULL), CAROM_OK);
  assert_int_equal(carom_world_restore(b->world, bytes, size, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b->world, 5, NULL), CAROM_OK);
  assert_true(bench_hash(b->world) == hash);
  /* In bulk. */
#define BULK(field, to)                                                                                              \
  do {                                                                                                               \
    assert_int_equal(carom_world_write_joints(b->world, field, CAROM_SCALAR_F64, joint, 2, to, 0, NULL), CAROM_OK);  \
    assert_int_equal(carom_world_read_joints(b->world, field, CAROM_SCALAR_F64, joint, 2, back, 0, NULL), CAROM_OK); \
    assert_memory_equal(back, to, sizeof back);                                                                      \
  } while (0)
  BULK(CAROM_JOINT_BULK_FRICTION, one);
  BULK(CAROM_JOINT_BULK_ARMATURE, one);
  BULK(CAROM_JOINT_BULK_EFFORT_LIMIT, one);
  BULK(CAROM_JOINT_BULK_SPEED_LIMIT, one);
  BULK(CAROM_JOINT_BULK_DRIVE_TARGET, one);
  BULK(CAROM_JOINT_BULK_DRIVE_VELOCITY, one);
  BULK(CAROM_JOINT_BULK_DRIVE_EFFORT, one);
  BULK(CAROM_JOINT_BULK_DRIVE_MAX_FORCE, one);
  assert_int_equal(
      carom_world_write_joints(b->world, CAROM_JOINT_BULK_DRIVE_GAINS, CAROM_SCALAR_F64, joint, 2, gains, 0, NULL),
      CAROM_OK);
  d = axis_desc();
  assert_int_equal(carom_joint_get_axis(b->world, joint[0], axis_of[0], &d, NULL), CAROM_OK);
  assert_true(d.friction == 1.5 && d.armature == 1.5 && d.effort_limit == 1.5 && d.speed_limit == 1.5);
  assert_true(d.target == 1.5 && d.speed == 1.5 && d.effort == 1.5 && d.max_force == 1.5 && d.drive_stiffness == 20 &&
              d.drive_damping == 3);
  assert_int_equal(
      carom_world_read_joints(b->world, CAROM_JOINT_BULK_DRIVE_GAINS, CAROM_SCALAR_F64, joint, 2, gains_back, 0, NULL),
      CAROM_OK);
  assert_memory_equal(gains_back, gains, sizeof gains);
  BULK(CAROM_JOINT_BULK_FRICTION, none);
  BULK(CAROM_JOINT_BULK_ARMATURE, none);
  BULK(CAROM_JOINT_BULK_EFFORT_LIMIT, free);
  BULK(CAROM_JOINT_BULK_SPEED_LIMIT, free);
  assert_int_equal(
      carom_world_write_joints(b->world, CAROM_JOINT_BULK_FRICTION, CAROM_SCALAR_F64, b->bodies, 1, one, 0, NULL),
      CAROM_E_WRONG_KIND);
}

/* Accelerations are of a snapshot, too. */
static void accelerations_come_back(void** state) {
  Bench* b = *state;
  static unsigned char bytes[1 << 17];
  uint64_t size;
  carom_joint_desc d;
  carom_joint joint;
  carom_world* other = NULL;
  double was, now;
  carom_joint_desc_init(&d, sizeof d);
  d.kind = CAROM_JOINT_SLIDER, d.body_b = b->bodies[0], d.fields = CAROM_JOINT_WORLD_FRAME | CAROM_JOINT_ACCELERATIONS;
  d.position_a[1] = 4, d.orientation_a[2] = d.orientation_a[3] = sqrt(0.5);
  assert_int_equal(carom_joint_create(b->world, &d, &joint, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b->world, 3, NULL), CAROM_OK);
#define READ_ONE(world, to) \
  assert_int_equal(         \
      carom_world_read_joints(world, CAROM_JOINT_BULK_ACCELERATION, CAROM_SCALAR_F64, NULL, 1, to, 0, NULL), CAROM_OK)
  READ_ONE(b->world, &was);
  assert_true(fabs(was + 9.81) < 1e-9);
  assert_int_equal(carom_world_save(b->world, 0, bytes, sizeof bytes, &size, NULL), CAROM_OK);
  assert_int_equal(carom_world_fork(b->world, &other, NULL), CAROM_OK);
  READ_ONE(other, &now);
  assert_true(now == was);
  assert_int_equal(carom_world_destroy(other, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b->world, 200, NULL), CAROM_OK); /* it has landed */
  assert_int_equal(carom_world_restore(b->world, bytes, size, NULL), CAROM_OK);
  READ_ONE(b->world, &now);
  assert_true(now == was);
}

/* A drive needs no allocation in a step, breaks as other joints do, and stays finite where its turns are no coordinates. */
static void extreme_axes_stay_finite(void** state) {
  Bench* b = *state;
  const carom_joint six = join(b, CAROM_JOINT_SIX_AXIS, b->bodies[0], b->bodies[1]);
  carom_joint_axis d = axis_desc();
  carom_joint_orientation_drive t = drive_desc();
  uint32_t solver, k;
  double x[BENCH_BODIES][3];
  int i;
  d.drive_gains = d.stop_gains = d.spring_gains = CAROM_GAINS_FORCE;
  d.drive_stiffness = d.drive_damping = d.stop_stiffness = d.spring_stiffness = d.spring_damping = 1e30;
  d.mode = CAROM_AXIS_MODE_LIMITED, d.lower = -3.14, d.upper = 3.14, d.drive = CAROM_DRIVE_POSITION;
  d.target = 3.14, d.rest = -3.14;
  for (k = 0; k < CAROM_AXIS_COUNT; ++k) assert_int_equal(carom_joint_set_axis(b->world, six, k, &d, NULL), CAROM_OK);
  t.drive = CAROM_DRIVE_POSITION, t.target[2] = 1, t.target[3] = 0, t.stiffness = 1e4, t.velocity[0] = 1e6;
  assert_int_equal(carom_joint_set_orientation_drive(b->world, six, &t, NULL), CAROM_OK);
  for (solver = CAROM_SOLVER_SOFT_STEP; solver <= CAROM_SOLVER_AUTO; ++solver) {
    assert_int_equal(carom_world_set_dial(b->world, CAROM_DIAL_SOLVER, solver, NULL), CAROM_OK);
    assert_int_equal(bench_steps(b->world, 40, NULL), CAROM_OK);
    assert_int_equal(
        carom_world_read(b->world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, b->bodies, BENCH_BODIES, x, 0, NULL),
        CAROM_OK);
    for (i = 0; i < BENCH_BODIES; ++i)
      for (k = 0; k < 3; ++k) assert_true(isfinite(x[i][k]));
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(axes_are_what_was_set, make, clear),
      cmocka_unit_test_setup_teardown(wrong_axes_are_refused, make, clear),
      cmocka_unit_test_setup_teardown(axes_come_back, make, clear),
      cmocka_unit_test_setup_teardown(hinges_and_sliders_have_an_axis, make, clear),
      cmocka_unit_test_setup_teardown(accelerations_come_back, make, clear),
      cmocka_unit_test_setup_teardown(extreme_axes_stay_finite, make, clear),
  };
  return cmocka_run_group_tests_name("abi/joint_axes", tests, NULL, NULL);
}
