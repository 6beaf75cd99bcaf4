/* Joints as a host uses them: made, limited, driven, read, broken, refused. */
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

static carom_joint_desc desc_of(uint32_t kind, carom_body a, carom_body b) {
  carom_joint_desc d;
  assert_int_equal(carom_joint_desc_init(&d, sizeof d), CAROM_OK);
  d.kind = kind, d.body_a = a, d.body_b = b;
  d.fields = CAROM_JOINT_WORLD_FRAME;
  d.position_a[1] = 4;
  return d;
}
static carom_joint join(const Bench* b, uint32_t kind, carom_body x, carom_body y) {
  const carom_joint_desc d = desc_of(kind, x, y);
  carom_joint joint = 0;
  assert_int_equal(carom_joint_create(b->world, &d, &joint, NULL), CAROM_OK);
  return joint;
}
static carom_joint_state state_of(const Bench* b, carom_joint joint) {
  carom_joint_state s;
  memset(&s, 0, sizeof s);
  s.struct_size = sizeof s;
  assert_int_equal(carom_joint_get_state(b->world, joint, &s, NULL), CAROM_OK);
  return s;
}
static uint64_t count_of(const Bench* b) {
  uint64_t n = 99;
  assert_int_equal(carom_world_get_joints(b->world, NULL, 0, &n, NULL), CAROM_OK);
  return n;
}

static void every_kind_holds(void** state) {
  Bench* b = *state;
  carom_joint joints[CAROM_JOINT_COUPLING];
  uint32_t kind;
  int i;
  for (kind = 0; kind < CAROM_JOINT_COUPLING; ++kind)
    joints[kind] = join(b, kind, CAROM_NULL_HANDLE, b->bodies[kind % 4]);
  assert_int_equal(count_of(b), CAROM_JOINT_COUPLING);
  assert_int_equal(bench_steps(b->world, 60, NULL), CAROM_OK);
  for (i = 0; i < 4; ++i) { /* some are held by two */
    const carom_joint_state s = state_of(b, joints[i]);
    assert_true(s.gap < 2e-2 && s.angle < 2e-2 && !s.broken);
  }
  for (kind = 0; kind < CAROM_JOINT_COUPLING; ++kind) {
    carom_joint_desc d;
    memset(&d, 0, sizeof d);
    d.struct_size = sizeof d;
    assert_int_equal(carom_joint_get(b->world, joints[kind], &d, NULL), CAROM_OK);
    assert_int_equal(d.kind, kind);
    assert_true(d.body_a == CAROM_NULL_HANDLE && d.body_b == b->bodies[kind % 4]);
    assert_true(d.position_a[1] == 4);
  }
}

static void a_body_takes_its_joints_with_it(void** state) {
  Bench* b = *state;
  carom_joint list[4], gone, stays;
  carom_joint_state s;
  uint64_t n;
  gone = join(b, CAROM_JOINT_BALL, b->bodies[0], b->bodies[1]);
  stays = join(b, CAROM_JOINT_HINGE, b->bodies[1], b->bodies[2]);
  assert_int_equal(carom_body_destroy(b->world, b->bodies[0], NULL), CAROM_OK);
  s.struct_size = sizeof s;
  assert_int_equal(carom_joint_get_state(b->world, gone, &s, NULL), CAROM_E_STALE_HANDLE);
  assert_int_equal(carom_world_get_joints(b->world, list, 4, &n, NULL), CAROM_OK);
  assert_true(n == 1 && list[0] == stays);
  assert_int_equal(bench_steps(b->world, 10, NULL), CAROM_OK);
  assert_int_equal(carom_joint_destroy(b->world, stays, NULL), CAROM_OK);
  assert_int_equal(carom_joint_destroy(b->world, stays, NULL), CAROM_E_STALE_HANDLE);
  assert_int_equal(carom_joint_destroy(b->world, b->bodies[1], NULL), CAROM_E_WRONG_KIND);
  assert_int_equal(carom_joint_destroy(b->world, 12345, NULL), CAROM_E_INVALID_HANDLE);
  assert_int_equal(bench_steps(b->world, 10, NULL), CAROM_OK);
  assert_int_equal(count_of(b), 0);
}

static void limits_motors_and_springs_are_what_was_set(void** state) {
  Bench* b = *state;
  const carom_joint hinge = join(b, CAROM_JOINT_HINGE, CAROM_NULL_HANDLE, b->bodies[0]);
  carom_joint_limit limit, limit_back;
  carom_joint_motor motor, motor_back;
  carom_joint_spring spring, spring_back;
  carom_joint_limit_init(&limit, sizeof limit), carom_joint_motor_init(&motor, sizeof motor),
      carom_joint_spring_init(&spring, sizeof spring);
  limit.enabled = motor.enabled = spring.enabled = 1;
  limit.lower = -1, limit.upper = 0.5, motor.speed = 2, motor.max_force = 30, spring.target = 0.25,
  spring.damping = 0.5;
  limit_back = limit, motor_back = motor, spring_back = spring;
  assert_int_equal(carom_joint_set_limit(b->world, hinge, CAROM_COORDINATE_TWIST, &limit, NULL), CAROM_OK);
  assert_int_equal(carom_joint_set_motor(b->world, hinge, CAROM_COORDINATE_TWIST, &motor, NULL), CAROM_OK);
  assert_int_equal(carom_joint_set_spring(b->world, hinge, CAROM_COORDINATE_TWIST, &spring, NULL), CAROM_OK);
  limit.lower = motor.max_force = spring.target = 0;
  assert_int_equal(carom_joint_get_limit(b->world, hinge, CAROM_COORDINATE_TWIST, &limit, NULL), CAROM_OK);
  assert_int_equal(carom_joint_get_motor(b->world, hinge, CAROM_COORDINATE_TWIST, &motor, NULL), CAROM_OK);
  assert_int_equal(carom_joint_get_spring(b->world, hinge, CAROM_COORDINATE_TWIST, &spring, NULL), CAROM_OK);
  assert_memory_equal(&limit, &limit_back, sizeof limit);
  assert_memory_equal(&motor, &motor_back, sizeof motor);
  assert_memory_equal(&spring, &spring_back, sizeof spring);
  assert_int_equal(bench_steps(b->world, 100, NULL), CAROM_OK);
}

static void what_broke_says_so(void** state) {
  Bench* b = *state;
  carom_joint_desc d = desc_of(CAROM_JOINT_WELD, CAROM_NULL_HANDLE, b->bodies[0]);
  carom_joint weak, strong;
  d.break_force = 1;
  assert_int_equal(carom_joint_create(b->world, &d, &weak, NULL), CAROM_OK);
  d.body_b = b->bodies[1], d.break_force = 1e9;
  assert_int_equal(carom_joint_create(b->world, &d, &strong, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b->world, 5, NULL), CAROM_OK);
  assert_true(state_of(b, weak).broken == 1 && state_of(b, strong).broken == 0);
  assert_int_equal(count_of(b), 2); /* the handle stays */
}

static void severity_knows_no_joints(void** state) {
  Bench* b = *state;
  carom_joint_desc d = desc_of(CAROM_JOINT_BALL, b->bodies[0], b->bodies[1]);
  carom_joint joint = 7;
  carom_error e = CAROM_ERROR_INIT;
  uint64_t hash;
  double solver;
  assert_int_equal(carom_world_set_dial(b->world, CAROM_DIAL_SOLVER, CAROM_SOLVER_SEVERITY, NULL), CAROM_OK);
  assert_int_equal(carom_joint_create(b->world, &d, &joint, &e), CAROM_E_UNSUPPORTED);
  assert_true(joint == 7 && strstr(e.message, "severity") && count_of(b) == 0);
  assert_int_equal(carom_world_set_dial(b->world, CAROM_DIAL_SOLVER, CAROM_SOLVER_AUTO, NULL), CAROM_OK);
  assert_int_equal(carom_joint_create(b->world, &d, &joint, &e), CAROM_OK);
  hash = bench_hash(b->world);
  assert_int_equal(carom_world_set_dial(b->world, CAROM_DIAL_SOLVER, CAROM_SOLVER_SEVERITY, &e), CAROM_E_UNSUPPORTED);
  assert_int_equal(carom_world_get_dial(b->world, CAROM_DIAL_SOLVER, &solver, NULL), CAROM_OK);
  assert_true(solver == CAROM_SOLVER_AUTO && bench_hash(b->world) == hash && strstr(e.message, "destroy them"));
  assert_int_equal(carom_joint_destroy(b->world, joint, NULL), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b->world, CAROM_DIAL_SOLVER, CAROM_SOLVER_SEVERITY, NULL), CAROM_OK);
}

#define REFUSED(result, change)                                                              \
  do {                                                                                       \
    carom_joint_desc d = desc_of(CAROM_JOINT_BALL, b->bodies[0], b->bodies[1]);              \
    carom_joint joint = 7;                                                                   \
    carom_error e = CAROM_ERROR_INIT;                                                        \
    change;                                                                                  \
    assert_int_equal(carom_joint_create(b->world, &d, &joint, &e), result);                  \
    assert_true(joint == 7 && e.code == result && e.argument == 2 && strlen(e.message) > 8); \
    assert_true(bench_hash(b->world) == hash && count_of(b) == 1);                           \
  } while (0)

static void wrong_joints_are_refused(void** state) {
  Bench* b = *state;
  const carom_joint good = join(b, CAROM_JOINT_BALL, b->bodies[2], b->bodies[3]);
  const uint64_t hash = bench_hash(b->world);
  const double nan = NAN, inf = INFINITY;
  carom_error error = CAROM_ERROR_INIT;
  carom_joint_limit limit;
  carom_joint_motor motor;
  carom_joint_spring spring;
  carom_joint_state s;
  REFUSED(CAROM_E_STRUCT_SIZE, d.struct_size = 5);
  REFUSED(CAROM_E_UNSUPPORTED, d.reserved = 1);
  REFUSED(CAROM_E_UNSUPPORTED, d.fields = 16);
  REFUSED(CAROM_E_UNKNOWN_ENUM, d.kind = CAROM_JOINT_COUNT);
  REFUSED(CAROM_E_OUT_OF_RANGE, d.body_b = d.body_a);
  REFUSED(CAROM_E_OUT_OF_RANGE, d.body_a = d.body_b = 0);
  REFUSED(CAROM_E_OUT_OF_RANGE, (d.body_a = 0, d.body_b = b->ground));
  REFUSED(CAROM_E_WRONG_KIND, d.body_a = b->colliders[0]);
  REFUSED(CAROM_E_INVALID_HANDLE, d.body_b = 77);
  REFUSED(CAROM_E_NOT_FINITE, d.position_a[2] = nan);
  REFUSED(CAROM_E_OUT_OF_RANGE, d.position_a[2] = 1e300);
  REFUSED(CAROM_E_NOT_UNIT, d.orientation_a[3] = 0);
  REFUSED(CAROM_E_NOT_FINITE, d.orientation_a[1] = inf);
  REFUSED(CAROM_E_NOT_FINITE, (d.fields = 0, d.position_b[0] = inf));
  REFUSED(CAROM_E_NOT_UNIT, (d.fields = 0, d.orientation_b[0] = 2));
  REFUSED(CAROM_E_OUT_OF_RANGE, d.length = -1);
  REFUSED(CAROM_E_NOT_FINITE, d.break_force = nan);
  REFUSED(CAROM_E_OUT_OF_RANGE, d.break_torque = -1);
  carom_joint_limit_init(&limit, sizeof limit), carom_joint_motor_init(&motor, sizeof motor),
      carom_joint_spring_init(&spring, sizeof spring);
  assert_int_equal(carom_joint_set_limit(b->world, good, CAROM_COORDINATE_SLIDE, &limit, &error), CAROM_E_UNSUPPORTED);
  assert_non_null(strstr(error.message, "free: TWIST, SWING")); /* those that it has */
  assert_int_equal(carom_joint_set_limit(b->world, good, 4, &limit, NULL), CAROM_E_UNKNOWN_ENUM);
  assert_int_equal(carom_joint_set_motor(b->world, good, CAROM_COORDINATE_SWING, &motor, NULL), CAROM_E_UNSUPPORTED);
  assert_int_equal(carom_joint_set_spring(b->world, good, CAROM_COORDINATE_SWING, &spring, NULL), CAROM_E_UNSUPPORTED);
  limit.lower = 1, limit.upper = 0.5;
  assert_int_equal(carom_joint_set_limit(b->world, good, CAROM_COORDINATE_TWIST, &limit, NULL), CAROM_E_OUT_OF_RANGE);
  limit.lower = -1001;
  assert_int_equal(carom_joint_set_limit(b->world, good, CAROM_COORDINATE_TWIST, &limit, NULL), CAROM_E_OUT_OF_RANGE);
  limit.enabled = 2, limit.lower = 0;
  assert_int_equal(carom_joint_set_limit(b->world, good, CAROM_COORDINATE_TWIST, &limit, NULL), CAROM_E_UNKNOWN_ENUM);
  motor.max_force = -1;
  assert_int_equal(carom_joint_set_motor(b->world, good, CAROM_COORDINATE_TWIST, &motor, NULL), CAROM_E_OUT_OF_RANGE);
  motor.max_force = 1, motor.speed = nan;
  assert_int_equal(carom_joint_set_motor(b->world, good, CAROM_COORDINATE_TWIST, &motor, NULL), CAROM_E_NOT_FINITE);
  spring.frequency = 1e5;
  assert_int_equal(carom_joint_set_spring(b->world, good, CAROM_COORDINATE_TWIST, &spring, NULL), CAROM_E_OUT_OF_RANGE);
  s.struct_size = 3;
  assert_int_equal(carom_joint_get_state(b->world, good, &s, NULL), CAROM_E_STRUCT_SIZE);
  assert_int_equal(carom_joint_get_state(b->world, good, NULL, NULL), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_joint_create(b->world, NULL, NULL, NULL), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_joint_create(NULL, NULL, NULL, NULL), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_world_get_joints(b->world, NULL, 0, NULL, NULL), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_joint_desc_init(NULL, sizeof(carom_joint_desc)), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_joint_limit_init(NULL, sizeof(carom_joint_limit)), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_joint_motor_init(NULL, sizeof(carom_joint_motor)), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_joint_spring_init(NULL, sizeof(carom_joint_spring)), CAROM_E_NULL_ARGUMENT);
  assert_true(bench_hash(b->world) == hash);
}

/* Frames a kilometre off their bodies, rods of no length, contradictions, locked limits: whatever is asked for, numbers
 * stay numbers. */
static void nonsense_stays_finite(void** state) {
  Bench* b = *state;
  uint32_t solver;
  int i, k;
  carom_joint_desc d = desc_of(CAROM_JOINT_WELD, b->bodies[0], b->bodies[1]);
  carom_joint joint;
  carom_joint_limit limit;
  carom_joint_motor motor;
  double x[BENCH_BODIES][3];
  d.position_a[0] = 1000;
  assert_int_equal(carom_joint_create(b->world, &d, &joint, NULL), CAROM_OK);
  d.fields = 0, d.position_a[0] = 3, d.position_b[1] = -5; /* cannot be, with the first */
  assert_int_equal(carom_joint_create(b->world, &d, &joint, NULL), CAROM_OK);
  d.kind = CAROM_JOINT_DISTANCE, d.fields = CAROM_JOINT_FIELD_LENGTH, d.body_b = b->bodies[2];
  assert_int_equal(carom_joint_create(b->world, &d, &joint, NULL), CAROM_OK);
  d.kind = CAROM_JOINT_HINGE, d.fields = CAROM_JOINT_WORLD_FRAME, d.body_a = b->bodies[3], d.body_b = b->ground;
  assert_int_equal(carom_joint_create(b->world, &d, &joint, NULL), CAROM_OK);
  carom_joint_limit_init(&limit, sizeof limit), carom_joint_motor_init(&motor, sizeof motor);
  limit.enabled = motor.enabled = 1, limit.lower = limit.upper = 3.14159, motor.speed = 1e6, motor.max_force = 1e30;
  assert_int_equal(carom_joint_set_limit(b->world, joint, CAROM_COORDINATE_TWIST, &limit, NULL), CAROM_OK);
  assert_int_equal(carom_joint_set_motor(b->world, joint, CAROM_COORDINATE_TWIST, &motor, NULL), CAROM_OK);
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

/* A pulley holds nothing until it is strung; then its rope keeps its length. What is wrong is refused, and changes nothing. */
static void a_pulley_is_strung(void** state) {
  Bench* b = *state;
  const carom_joint ball = join(b, CAROM_JOINT_BALL, CAROM_NULL_HANDLE, b->bodies[2]);
  carom_joint_desc d = desc_of(CAROM_JOINT_PULLEY, b->bodies[0], b->bodies[1]);
  carom_joint pulley = 0;
  carom_joint_transmission t, back;
  carom_joint_state s;
  carom_error e = CAROM_ERROR_INIT;
  uint64_t hash;
  d.fields = 0, d.position_a[1] = 0;
  assert_int_equal(carom_joint_create(b->world, &d, &pulley, NULL), CAROM_OK);
  assert_int_equal(carom_joint_transmission_init(NULL, sizeof(carom_joint_transmission)), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_joint_transmission_init(&t, sizeof t), CAROM_OK);
  assert_true(t.struct_size == sizeof t && t.ratio == 1 && t.fields == 0);
  back.struct_size = sizeof back;
  assert_int_equal(carom_joint_get_transmission(b->world, pulley, &back, NULL), CAROM_OK);
  assert_true(back.ratio == 0);
  assert_int_equal(bench_steps(b->world, 10, NULL), CAROM_OK);
  s = state_of(b, pulley);
  assert_true(s.force[1] == 0 && s.gap == 0);
  hash = bench_hash(b->world);
  assert_int_equal(carom_joint_set_transmission(b->world, ball, &t, &e), CAROM_E_UNSUPPORTED);
  assert_true(e.argument == 3 && strstr(e.message, "PULLEY"));
  assert_int_equal(carom_joint_get_transmission(b->world, ball, &back, NULL), CAROM_E_UNSUPPORTED);
  t.ratio = 0;
  assert_int_equal(carom_joint_set_transmission(b->world, pulley, &t, &e), CAROM_E_OUT_OF_RANGE);
  assert_true(e.argument == 3 && strstr(e.message, "ratio"));
  t.ratio = NAN;
  assert_int_equal(carom_joint_set_transmission(b->world, pulley, &t, NULL), CAROM_E_NOT_FINITE);
  t.ratio = 2, t.anchor_b[1] = 1e300;
  assert_int_equal(carom_joint_set_transmission(b->world, pulley, &t, NULL), CAROM_E_OUT_OF_RANGE);
  t.anchor_b[1] = 9, t.fields = 1;
  assert_int_equal(carom_joint_set_transmission(b->world, pulley, &t, NULL), CAROM_E_UNSUPPORTED);
  t.fields = 0;
  assert_true(bench_hash(b->world) == hash);
  t.anchor_a[1] = 9;
  assert_int_equal(carom_joint_set_transmission(b->world, pulley, &t, NULL), CAROM_OK);
  assert_int_equal(carom_joint_get_transmission(b->world, pulley, &back, NULL), CAROM_OK);
  assert_true(back.ratio == 2 && back.anchor_a[1] == 9 && back.fields == CAROM_JOINT_FIELD_LENGTH);
  assert_true(fabs(back.length - state_of(b, pulley).coordinate[CAROM_COORDINATE_DISTANCE]) < 1e-12);
  assert_int_equal(bench_steps(b->world, 20, NULL), CAROM_OK);
  assert_true(state_of(b, pulley).gap < 1e-3);
}

/* A gear's turns and a pulley's rope are part of a snapshot: from there all goes on to the same bits. */
static void gears_and_pulleys_come_back(void** state) {
  Bench* b = *state;
  static unsigned char bytes[1 << 17];
  uint64_t size, hash;
  int whole;
  const carom_joint gear = join(b, CAROM_JOINT_GEAR, b->bodies[0], b->bodies[1]);
  const carom_joint pulley = join(b, CAROM_JOINT_PULLEY, b->bodies[2], b->bodies[3]);
  carom_joint_transmission t, back;
  assert_int_equal(carom_joint_transmission_init(&t, sizeof t), CAROM_OK);
  t.ratio = -2.5;
  assert_int_equal(carom_joint_set_transmission(b->world, pulley, &t, NULL), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_joint_set_transmission(b->world, gear, &t, NULL), CAROM_OK);
  t.ratio = 0;
  assert_int_equal(carom_joint_set_transmission(b->world, gear, &t, NULL), CAROM_E_OUT_OF_RANGE);
  t.ratio = 2, t.anchor_a[1] = 9, t.anchor_b[1] = 8;
  assert_int_equal(carom_joint_set_transmission(b->world, pulley, &t, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b->world, 20, NULL), CAROM_OK);
  for (whole = 0; whole < 2; ++whole) {
    carom_world* other = NULL;
    assert_int_equal(carom_world_save(b->world, 0, bytes, sizeof bytes, &size, NULL), CAROM_OK);
    if (whole) assert_int_equal(carom_world_fork(b->world, &other, NULL), CAROM_OK);
    assert_int_equal(bench_steps(b->world, 20, NULL), CAROM_OK);
    hash = bench_hash(b->world);
    if (whole) {
      assert_int_equal(bench_steps(other, 20, NULL), CAROM_OK);
      assert_true(bench_hash(other) == hash);
      assert_int_equal(carom_world_destroy(other, NULL), CAROM_OK);
      continue;
    }
    t.ratio = 3;
    assert_int_equal(carom_joint_set_transmission(b->world, pulley, &t, NULL), CAROM_OK);
    assert_int_equal(carom_joint_set_transmission(b->world, gear, &t, NULL), CAROM_OK);
    assert_int_equal(carom_world_restore(b->world, bytes, size, NULL), CAROM_OK);
    back.struct_size = sizeof back;
    assert_int_equal(carom_joint_get_transmission(b->world, gear, &back, NULL), CAROM_OK);
    assert_true(back.ratio == -2.5);
    assert_int_equal(carom_joint_get_transmission(b->world, pulley, &back, NULL), CAROM_OK);
    assert_true(back.ratio == 2 && back.anchor_b[1] == 8);
    assert_int_equal(bench_steps(b->world, 20, NULL), CAROM_OK);
    assert_true(bench_hash(b->world) == hash);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(every_kind_holds, make, clear),
      cmocka_unit_test_setup_teardown(a_body_takes_its_joints_with_it, make, clear),
      cmocka_unit_test_setup_teardown(limits_motors_and_springs_are_what_was_set, make, clear),
      cmocka_unit_test_setup_teardown(what_broke_says_so, make, clear),
      cmocka_unit_test_setup_teardown(severity_knows_no_joints, make, clear),
      cmocka_unit_test_setup_teardown(wrong_joints_are_refused, make, clear),
      cmocka_unit_test_setup_teardown(a_pulley_is_strung, make, clear),
      cmocka_unit_test_setup_teardown(gears_and_pulleys_come_back, make, clear),
      cmocka_unit_test_setup_teardown(nonsense_stays_finite, make, clear),
  };
  return cmocka_run_group_tests_name("abi/joints", tests, NULL, NULL);
}
