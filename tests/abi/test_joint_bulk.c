/* Joints read and written many at a time. Rates against central differences of the coordinates. */
#include "bench.h"
#include "carom_test.h"

static const double upright[4] = {0, 0, 0, 1};

#define KINDS 6

/* Numbers from -1 to 1. */
static uint64_t seed = 88172645463325252u;
static double draw(void) {
  seed ^= seed << 13, seed ^= seed >> 7, seed ^= seed << 17;
  return (double)(seed >> 11) * 0x1p-52 - 1;
}

/* q rotated by the rotation vector w. */
static void turn(const double w[3], const double q[4], double out[4]) {
  const double a = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]), s = a > 0 ? sin(a / 2) / a : 0.5, c = cos(a / 2);
  const double x = s * w[0], y = s * w[1], z = s * w[2];
  out[0] = c * q[0] + x * q[3] + y * q[2] - z * q[1];
  out[1] = c * q[1] - x * q[2] + y * q[3] + z * q[0];
  out[2] = c * q[2] + x * q[1] - y * q[0] + z * q[3];
  out[3] = c * q[3] - x * q[0] - y * q[1] - z * q[2];
}

typedef struct Motion {
  double p[3], q[4], v[3], w[3];
} Motion;

static void place(const Bench* b, int i, const Motion* m, double t) {
  double p[3], q[4], w[3];
  int k;
  for (k = 0; k < 3; ++k) p[k] = m->p[k] + t * m->v[k], w[k] = t * m->w[k];
  turn(w, m->q, q);
  assert_int_equal(carom_body_set_pose(b->world, b->bodies[i], p, q, NULL), CAROM_OK);
}

static void rates_are_differences(void** state) {
  static const uint32_t kinds[KINDS] = {CAROM_JOINT_BALL, CAROM_JOINT_HINGE,  CAROM_JOINT_SLIDER,
                                        CAROM_JOINT_WELD, CAROM_JOINT_PULLEY, CAROM_JOINT_SIX_AXIS};
  const double h = 1e-5;
  Bench bench, *b = &bench;
  int trial;
  (void)state;
  assert_int_equal(bench_make(b, NULL, NULL), CAROM_OK);
  for (trial = 0; trial < 60; ++trial) {
    Motion motion[2];
    carom_joint joint[2 * KINDS];
    double speed[2 * KINDS][4], rate[2 * KINDS][6], at[2][2 * KINDS][4], axis[2][2 * KINDS][6];
    uint64_t count = 0;
    int i, k, side;
    for (i = 0; i < 2; ++i) {
      double length = 0;
      for (k = 0; k < 4; ++k) motion[i].q[k] = draw(), length += motion[i].q[k] * motion[i].q[k];
      for (k = 0; k < 4; ++k) motion[i].q[k] /= sqrt(length);
      for (k = 0; k < 3; ++k) motion[i].p[k] = 3 * draw(), motion[i].v[k] = draw(), motion[i].w[k] = 2 * draw();
      place(b, i, &motion[i], 0);
      assert_int_equal(carom_body_set_velocity(b->world, b->bodies[i], motion[i].v, motion[i].w, NULL), CAROM_OK);
    }
    for (i = 0; i < 2 * KINDS; ++i) {
      carom_joint_desc d;
      double length = 0;
      carom_joint_desc_init(&d, sizeof d);
      d.kind = kinds[i / 2], d.body_a = i % 2 ? b->bodies[0] : CAROM_NULL_HANDLE, d.body_b = b->bodies[1];
      for (k = 0; k < 3; ++k) d.position_a[k] = draw(), d.position_b[k] = draw();
      for (k = 0; k < 4; ++k) d.orientation_a[k] = draw(), length += d.orientation_a[k] * d.orientation_a[k];
      for (k = 0; k < 4; ++k) d.orientation_a[k] /= sqrt(length);
      assert_int_equal(carom_joint_create(b->world, &d, &joint[i], NULL), CAROM_OK);
      if (d.kind == CAROM_JOINT_PULLEY) {
        carom_joint_transmission t;
        carom_joint_transmission_init(&t, sizeof t);
        t.ratio = 2.5, t.anchor_a[1] = 9, t.anchor_b[1] = 8;
        assert_int_equal(carom_joint_set_transmission(b->world, joint[i], &t, NULL), CAROM_OK);
      }
    }
    assert_int_equal(
        carom_world_read_joints(b->world, CAROM_JOINT_BULK_SPEEDS, CAROM_SCALAR_F64, joint, 2 * KINDS, speed, 0, NULL),
        CAROM_OK);
    assert_int_equal(carom_world_read_joints(b->world, CAROM_JOINT_BULK_AXIS_SPEEDS, CAROM_SCALAR_F64, joint, 2 * KINDS,
                                             rate, 0, NULL),
                     CAROM_OK);
    for (side = 0; side < 2; ++side) {
      for (i = 0; i < 2; ++i) place(b, i, &motion[i], side ? h : -h);
      assert_int_equal(carom_world_read_joints(b->world, CAROM_JOINT_BULK_COORDINATES, CAROM_SCALAR_F64, joint,
                                               2 * KINDS, at[side], 0, NULL),
                       CAROM_OK);
      assert_int_equal(carom_world_read_joints(b->world, CAROM_JOINT_BULK_AXES, CAROM_SCALAR_F64, joint, 2 * KINDS,
                                               axis[side], 0, NULL),
                       CAROM_OK);
    }
    for (i = 0; i < 2 * KINDS; ++i) {
      /* Central differences err by h^2 / 6 of a third derivative. That of a twist grows as a swing nears pi, by 1 /
         cos^3 of its half; that of a swing as axes nearly agree, by 1 / sin^2. Rates are below 10 rad/s. */
      const double swing = at[0][i][1],
                   bound = 1e-8 / (pow(fmax(cos(swing / 2), 1e-2), 3) * pow(fmax(sin(swing), 1e-2), 2));
      for (k = 0; k < 4; ++k) {
        const double difference = (at[1][i][k] - at[0][i][k]) / (2 * h);
        if (fabs(at[1][i][k] - at[0][i][k]) > 1) continue; /* across a whole turn */
        assert_true(fabs(difference - speed[i][k]) < bound * (1 + fabs(difference)));
      }
      for (k = 0; k < 6; ++k) {
        const double difference = (axis[1][i][k] - axis[0][i][k]) / (2 * h);
        if (fabs(axis[1][i][k] - axis[0][i][k]) > 1) continue;
        assert_true(fabs(difference - rate[i][k]) < bound * (1 + fabs(difference)));
      }
      assert_int_equal(carom_joint_destroy(b->world, joint[i], NULL), CAROM_OK);
    }
    assert_int_equal(carom_world_get_joints(b->world, NULL, 0, &count, NULL), CAROM_OK);
    assert_int_equal(count, 0);
  }
  assert_int_equal(bench_free(b), CAROM_OK);
}

/* A body of 3 kg on a ball bears its weight, whoever asks: one by one, all, in floats, at a stride. */
static void forces_are_those_of_the_state(void** state) {
  Bench bench, *b = &bench;
  carom_joint_desc d;
  carom_joint joint[2];
  carom_joint_state one;
  double all[2][3], error[2][2], broken[2];
  struct {
    float force[3], rest;
  } some[2];
  int i;
  (void)state;
  assert_int_equal(bench_make(b, NULL, NULL), CAROM_OK);
  for (i = 0; i < 2; ++i) {
    carom_joint_desc_init(&d, sizeof d);
    d.kind = CAROM_JOINT_WELD, d.body_b = b->bodies[i], d.fields = CAROM_JOINT_WORLD_FRAME;
    assert_int_equal(carom_body_set_mass(b->world, b->bodies[i], 3 + i, NULL, NULL, NULL), CAROM_OK);
    assert_int_equal(carom_joint_create(b->world, &d, &joint[i], NULL), CAROM_OK);
  }
  assert_int_equal(bench_steps(b->world, 30, NULL), CAROM_OK);
  memset(some, 0x11, sizeof some);
  assert_int_equal(carom_world_read_joints(b->world, CAROM_JOINT_BULK_FORCE, CAROM_SCALAR_F64, NULL, 2, all, 0, NULL),
                   CAROM_OK);
  assert_int_equal(carom_world_read_joints(b->world, CAROM_JOINT_BULK_ERROR, CAROM_SCALAR_F64, NULL, 2, error, 0, NULL),
                   CAROM_OK);
  assert_int_equal(
      carom_world_read_joints(b->world, CAROM_JOINT_BULK_BROKEN, CAROM_SCALAR_F64, NULL, 2, broken, 0, NULL), CAROM_OK);
  assert_int_equal(
      carom_world_read_joints(b->world, CAROM_JOINT_BULK_FORCE, CAROM_SCALAR_F32, joint, 2, some, sizeof some[0], NULL),
      CAROM_OK);
  for (i = 0; i < 2; ++i) {
    one.struct_size = sizeof one;
    assert_int_equal(carom_joint_get_state(b->world, joint[i], &one, NULL), CAROM_OK);
    assert_memory_equal(one.force, all[i], sizeof all[i]);
    assert_true(error[i][0] == one.gap && error[i][1] == one.angle && broken[i] == 0);
    assert_true(fabs(all[i][1] - (3 + i) * 9.81) < 0.01);
    assert_true(some[i].force[1] == (float)all[i][1]);
    assert_int_equal(*(const unsigned char*)&some[i].rest, 0x11);
  }
  assert_int_equal(carom_world_read_joints(b->world, CAROM_JOINT_BULK_FORCE, CAROM_SCALAR_F64, NULL, 1, all, 0, NULL),
                   CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_world_read_joints(b->world, CAROM_JOINT_BULK_COUNT, CAROM_SCALAR_F64, NULL, 2, all, 0, NULL),
                   CAROM_E_UNKNOWN_ENUM);
  assert_int_equal(carom_world_read_joints(b->world, CAROM_JOINT_BULK_FORCE, CAROM_SCALAR_F64, NULL, 2, all, 8, NULL),
                   CAROM_E_BUFFER_TOO_SMALL);
  assert_int_equal(bench_free(b), CAROM_OK);
}

/* ---- writing ---- */

#define ROW(field, joints, n, src) carom_world_write_joints(b->world, field, CAROM_SCALAR_F64, joints, n, src, 0, NULL)
#define READ(field, joints, n, dst) \
  assert_int_equal(carom_world_read_joints(b->world, field, CAROM_SCALAR_F64, joints, n, dst, 0, NULL), CAROM_OK)

static carom_joint join(const Bench* b, uint32_t kind, int body, const double at[3]) {
  carom_joint_desc d;
  carom_joint joint;
  carom_joint_desc_init(&d, sizeof d);
  d.kind = kind, d.body_b = b->bodies[body];
  if (kind != CAROM_JOINT_DISTANCE) d.fields = CAROM_JOINT_WORLD_FRAME; /* a rod ends at the body's origin */
  memcpy(d.position_a, at, sizeof d.position_a);
  assert_int_equal(carom_joint_create(b->world, &d, &joint, NULL), CAROM_OK);
  return joint;
}

/* A hinge, a slider and a rope, each on a body of its own. */
static void join_three(const Bench* b, carom_joint joint[3]) {
  static const double at[3][3] = {{0, 3, 0}, {2, 3, 0}, {4, 9, 0}};
  int i;
  joint[0] = join(b, CAROM_JOINT_HINGE, 0, at[0]);
  joint[1] = join(b, CAROM_JOINT_SLIDER, 1, at[1]);
  joint[2] = join(b, CAROM_JOINT_DISTANCE, 2, at[2]);
  for (i = 0; i < 3; ++i)
    assert_int_equal(carom_body_set_mass(b->world, b->bodies[i], 2 + i, NULL, NULL, NULL), CAROM_OK);
}

static uint64_t hash_after(const Bench* b, int steps) {
  uint64_t hash = 0;
  assert_int_equal(bench_steps(b->world, steps, NULL), CAROM_OK);
  assert_int_equal(carom_world_hash(b->world, &hash, NULL), CAROM_OK);
  return hash;
}

/* What one call writes for all is what one call a joint sets: field by field, and in the bits of the motion. */
static void written_is_as_set_one_by_one(void** state) {
  static const uint32_t ways[3] = {CAROM_COORDINATE_TWIST, CAROM_COORDINATE_SLIDE, CAROM_COORDINATE_DISTANCE};
  static const double motors[3][3] = {{1, 2, 7}, {0, -1, 50}, {1, 0.1, 30}};
  static const double springs[3][5] = {{0, 0.1, 2, 1, 1e30}, {1, -0.3, 3, 0.5, 400}, {0, 1, 1, 1, 5}};
  static const double limits[3][3] = {{1, -0.5, 0.7}, {1, -1, 1}, {1, 0, 7}};
  uint64_t hash[2];
  int way, i;
  (void)state;
  for (way = 0; way < 2; ++way) {
    Bench bench, *b = &bench;
    carom_joint joint[3];
    double back[3][5];
    assert_int_equal(bench_make(b, NULL, NULL), CAROM_OK);
    join_three(b, joint);
    if (way == 0) {
      assert_int_equal(ROW(CAROM_JOINT_BULK_MOTOR, joint, 3, motors), CAROM_OK);
      assert_int_equal(ROW(CAROM_JOINT_BULK_SPRING, NULL, 3, springs), CAROM_OK);
      assert_int_equal(ROW(CAROM_JOINT_BULK_LIMIT, joint, 3, limits), CAROM_OK);
      READ(CAROM_JOINT_BULK_MOTOR, joint, 3, back);
      assert_memory_equal(back, motors, sizeof motors);
      READ(CAROM_JOINT_BULK_SPRING, joint, 3, back);
      assert_memory_equal(back, springs, sizeof springs);
      READ(CAROM_JOINT_BULK_LIMIT, joint, 3, back);
      assert_memory_equal(back, limits, sizeof limits);
    }
    for (i = 0; i < 3; ++i) {
      carom_joint_motor motor;
      carom_joint_spring spring;
      carom_joint_limit limit;
      carom_joint_motor_init(&motor, sizeof motor), carom_joint_spring_init(&spring, sizeof spring);
      carom_joint_limit_init(&limit, sizeof limit);
      if (way == 0) { /* what was written is what a call for one reads */
        assert_int_equal(carom_joint_get_motor(b->world, joint[i], ways[i], &motor, NULL), CAROM_OK);
        assert_int_equal(carom_joint_get_spring(b->world, joint[i], ways[i], &spring, NULL), CAROM_OK);
        assert_int_equal(carom_joint_get_limit(b->world, joint[i], ways[i], &limit, NULL), CAROM_OK);
        assert_true(motor.enabled == motors[i][0] && motor.speed == motors[i][1] && motor.max_force == motors[i][2]);
        assert_true(spring.enabled == springs[i][0] && spring.target == springs[i][1] &&
                    spring.frequency == springs[i][2] && spring.damping == springs[i][3] &&
                    spring.max_force == springs[i][4]);
        assert_true(limit.enabled == limits[i][0] && limit.lower == limits[i][1] && limit.upper == limits[i][2]);
      } else {
        motor.enabled = (uint32_t)motors[i][0], motor.speed = motors[i][1], motor.max_force = motors[i][2];
        spring.enabled = (uint32_t)springs[i][0], spring.target = springs[i][1], spring.frequency = springs[i][2];
        spring.damping = springs[i][3], spring.max_force = springs[i][4];
        limit.enabled = (uint32_t)limits[i][0], limit.lower = limits[i][1], limit.upper = limits[i][2];
        assert_int_equal(carom_joint_set_motor(b->world, joint[i], ways[i], &motor, NULL), CAROM_OK);
        assert_int_equal(carom_joint_set_spring(b->world, joint[i], ways[i], &spring, NULL), CAROM_OK);
        assert_int_equal(carom_joint_set_limit(b->world, joint[i], ways[i], &limit, NULL), CAROM_OK);
      }
    }
    hash[way] = hash_after(b, 40);
    assert_int_equal(bench_free(b), CAROM_OK);
  }
  assert_true(hash[0] == hash[1]);
}

/* Likewise of axes and orientations: floats, at a stride, of one joint among others. */
static void axes_are_written_too(void** state) {
  Bench bench, *b = &bench;
  carom_joint six, ball;
  carom_joint_axis axis;
  carom_joint_orientation_drive turn;
  const double origin[3] = {0, 3, 0};
  const float targets[8] = {1, 2, 3, 0.5f, -0.25f, 4, 99, 99};
  const double gains[12] = {1, 0.5, 2, 0.5, 3, 0.5, 4, 0.5, 5, 0.5, 6, 0.5};
  const double limits[12] = {-1, 1, -2, 2, -3, 3, -4, 4, -5, 5, -6, 6};
  const double most[6] = {1, 2, 3, 4, 5, 1e30}, pose[4] = {0, 0.6, 0, 0.8}, spin[3] = {1, 2, 3}, pull[2] = {7, 0.25};
  double back[12];
  uint32_t k;
  (void)state;
  assert_int_equal(bench_make(b, NULL, NULL), CAROM_OK);
  six = join(b, CAROM_JOINT_SIX_AXIS, 0, origin), ball = join(b, CAROM_JOINT_BALL, 1, origin);
  assert_int_equal(carom_world_write_joints(b->world, CAROM_JOINT_BULK_AXIS_TARGETS, CAROM_SCALAR_F32, &six, 1, targets,
                                            sizeof targets, NULL),
                   CAROM_OK);
  assert_int_equal(ROW(CAROM_JOINT_BULK_AXIS_TARGET_VELOCITIES, &six, 1, gains), CAROM_OK);
  assert_int_equal(ROW(CAROM_JOINT_BULK_AXIS_TARGET_EFFORTS, &six, 1, limits), CAROM_OK);
  assert_int_equal(ROW(CAROM_JOINT_BULK_AXIS_GAINS, &six, 1, gains), CAROM_OK);
  assert_int_equal(ROW(CAROM_JOINT_BULK_AXIS_LIMITS, &six, 1, limits), CAROM_OK);
  assert_int_equal(ROW(CAROM_JOINT_BULK_AXIS_MAX_FORCES, &six, 1, most), CAROM_OK);
  for (k = 0; k < CAROM_AXIS_COUNT; ++k) {
    carom_joint_axis_init(&axis, sizeof axis);
    assert_int_equal(carom_joint_get_axis(b->world, six, k, &axis, NULL), CAROM_OK);
    assert_true(axis.target == targets[k] && axis.speed == gains[k] && axis.effort == limits[k]);
    assert_true(axis.drive_stiffness == gains[2 * k] && axis.drive_damping == gains[2 * k + 1]);
    assert_true(axis.lower == limits[2 * k] && axis.upper == limits[2 * k + 1] && axis.max_force == most[k]);
    assert_true(axis.mode == CAROM_AXIS_MODE_FREE && axis.drive == CAROM_DRIVE_NONE);
  }
  READ(CAROM_JOINT_BULK_AXIS_LIMITS, &six, 1, back);
  assert_memory_equal(back, limits, sizeof limits);
  READ(CAROM_JOINT_BULK_AXIS_GAINS, &six, 1, back);
  assert_memory_equal(back, gains, sizeof gains);
  READ(CAROM_JOINT_BULK_AXIS_MAX_FORCES, &six, 1, back);
  assert_memory_equal(back, most, sizeof most);
  assert_int_equal(ROW(CAROM_JOINT_BULK_AXIS_FRICTIONS, &six, 1, most), CAROM_OK);
  assert_int_equal(ROW(CAROM_JOINT_BULK_AXIS_ARMATURES, &six, 1, gains), CAROM_OK);
  READ(CAROM_JOINT_BULK_AXIS_FRICTIONS, &six, 1, back);
  assert_memory_equal(back, most, sizeof most);
  READ(CAROM_JOINT_BULK_AXIS_ARMATURES, &six, 1, back);
  assert_memory_equal(back, gains, 6 * sizeof *gains);
  assert_int_equal(ROW(CAROM_JOINT_BULK_AXIS_FRICTIONS, &six, 1, limits), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_joint_get_axis(b->world, six, CAROM_AXIS_TURN_Z, &axis, NULL), CAROM_OK);
  assert_true(axis.friction == 1e30 && axis.armature == 0.5);
  {
    const carom_joint both[2] = {ball, six};
    double poses[8], spins[6], pulls[4];
    memcpy(poses, pose, sizeof pose), memcpy(poses + 4, pose, sizeof pose);
    memcpy(spins, spin, sizeof spin), memcpy(spins + 3, spin, sizeof spin);
    memcpy(pulls, pull, sizeof pull), memcpy(pulls + 2, pull, sizeof pull);
    assert_int_equal(ROW(CAROM_JOINT_BULK_ORIENTATION_TARGET, both, 2, poses), CAROM_OK);
    assert_int_equal(ROW(CAROM_JOINT_BULK_ORIENTATION_VELOCITY, both, 2, spins), CAROM_OK);
    assert_int_equal(ROW(CAROM_JOINT_BULK_ORIENTATION_EFFORT, both, 2, spins), CAROM_OK);
    assert_int_equal(ROW(CAROM_JOINT_BULK_ORIENTATION_GAINS, both, 2, pulls), CAROM_OK);
    for (k = 0; k < 2; ++k) {
      carom_joint_orientation_drive_init(&turn, sizeof turn);
      assert_int_equal(carom_joint_get_orientation_drive(b->world, both[k], &turn, NULL), CAROM_OK);
      assert_true(fabs(turn.target[1] - 0.6) < 1e-15 && turn.velocity[2] == 3 && turn.effort[1] == 2);
      assert_true(turn.stiffness == 7 && turn.damping == 0.25 && turn.drive == CAROM_DRIVE_NONE);
    }
  }
  /* lower above upper is refused where it is a limit */
  carom_joint_axis_init(&axis, sizeof axis);
  axis.mode = CAROM_AXIS_MODE_LIMITED, axis.upper = 1;
  assert_int_equal(carom_joint_set_axis(b->world, six, CAROM_AXIS_Z, &axis, NULL), CAROM_OK);
  back[4] = 2, back[5] = 1;
  for (k = 0; k < 12; ++k)
    if (k != 4 && k != 5) back[k] = 0;
  assert_int_equal(ROW(CAROM_JOINT_BULK_AXIS_LIMITS, &six, 1, back), CAROM_E_OUT_OF_RANGE);
  READ(CAROM_JOINT_BULK_AXIS_LIMITS, &six, 1, back);
  assert_true(back[0] == -1 && back[5] == 1);
  assert_int_equal(bench_free(b), CAROM_OK);
}

/* What is wrong with the last record changes nothing of the first, and is named. */
static void a_wrong_record_changes_nothing(void** state) {
  static const struct {
    uint32_t field;
    int width;
    double first[5], last[5];
    int32_t code;
    const char* words;
  } rows[] = {
      {CAROM_JOINT_BULK_TARGET, 1, {0.5}, {NAN}, CAROM_E_NOT_FINITE, "number 0 of target of joint 2"},
      {CAROM_JOINT_BULK_TARGET, 1, {0.5}, {-1}, CAROM_E_OUT_OF_RANGE, "target"},
      {CAROM_JOINT_BULK_TARGET_VELOCITY, 1, {0.5}, {INFINITY}, CAROM_E_NOT_FINITE, "target_velocity"},
      {CAROM_JOINT_BULK_TARGET_EFFORT, 1, {0.5}, {2e30}, CAROM_E_OUT_OF_RANGE, "target_effort"},
      {CAROM_JOINT_BULK_MOTOR, 3, {1, 2, 3}, {0.5, 2, 3}, CAROM_E_OUT_OF_RANGE, "must be 0 or 1"},
      {CAROM_JOINT_BULK_MOTOR, 3, {1, 2, 3}, {1, 2, -3}, CAROM_E_OUT_OF_RANGE, "number 2 of motor of joint 2"},
      {CAROM_JOINT_BULK_SPRING, 5, {1, 0.1, 2, 3, 4}, {1, 0.1, 2, NAN, 4}, CAROM_E_NOT_FINITE, "number 3 of spring"},
      {CAROM_JOINT_BULK_LIMIT, 3, {1, -1, 1}, {1, 2, 1}, CAROM_E_OUT_OF_RANGE, "number 2 of limit"},
  };
  Bench bench, *b = &bench;
  carom_joint joint[3], weld, mixed[2];
  carom_error e = CAROM_ERROR_INIT;
  const double origin[3] = {0, 3, 0};
  double values[15], before[15], after[15];
  size_t r;
  int k;
  (void)state;
  assert_int_equal(bench_make(b, NULL, NULL), CAROM_OK);
  join_three(b, joint);
  for (r = 0; r < sizeof rows / sizeof rows[0]; ++r) {
    const int w = rows[r].width;
    for (k = 0; k < w; ++k) values[k] = values[w + k] = rows[r].first[k], values[2 * w + k] = rows[r].last[k];
    READ(rows[r].field, joint, 3, before);
    assert_int_equal(carom_world_write_joints(b->world, rows[r].field, CAROM_SCALAR_F64, joint, 3, values, 0, &e),
                     rows[r].code);
    assert_true(e.argument == 6 && strstr(e.message, rows[r].words) && e.remedy[0]);
    READ(rows[r].field, joint, 3, after);
    assert_memory_equal(before, after, sizeof(double) * 3 * (size_t)w);
    assert_int_equal(ROW(rows[r].field, joint, 2, values), CAROM_OK); /* the others are good */
  }
  /* A kind without the field, last of the list; a joint that is gone; what is read only. */
  weld = join(b, CAROM_JOINT_WELD, 3, origin);
  mixed[0] = joint[0], mixed[1] = weld;
  values[0] = values[1] = 0.25;
  READ(CAROM_JOINT_BULK_TARGET, joint, 1, before);
  assert_int_equal(
      carom_world_write_joints(b->world, CAROM_JOINT_BULK_TARGET, CAROM_SCALAR_F64, mixed, 2, values, 0, &e),
      CAROM_E_UNSUPPORTED);
  assert_true(e.argument == 4 && strstr(e.message, "joint 1 is a weld") && strstr(e.remedy, "list such joints"));
  assert_int_equal(
      carom_world_read_joints(b->world, CAROM_JOINT_BULK_EFFORT, CAROM_SCALAR_F64, mixed, 2, values, 0, NULL),
      CAROM_E_UNSUPPORTED);
  assert_int_equal(ROW(CAROM_JOINT_BULK_AXIS_TARGETS, mixed, 2, values), CAROM_E_UNSUPPORTED);
  assert_int_equal(ROW(CAROM_JOINT_BULK_ORIENTATION_EFFORT, mixed, 2, values), CAROM_E_UNSUPPORTED);
  assert_int_equal(carom_joint_destroy(b->world, weld, NULL), CAROM_OK);
  assert_int_equal(ROW(CAROM_JOINT_BULK_TARGET, mixed, 2, values), CAROM_E_STALE_HANDLE);
  assert_int_equal(ROW(CAROM_JOINT_BULK_EFFORT, joint, 1, values), CAROM_E_UNSUPPORTED);
  assert_int_equal(ROW(CAROM_JOINT_BULK_ACCELERATION, joint, 1, values), CAROM_E_UNSUPPORTED);
  READ(CAROM_JOINT_BULK_TARGET, joint, 1, after);
  assert_true(before[0] == after[0]);
  assert_int_equal(bench_free(b), CAROM_OK);
}

/* Two hinges, one on the other, and a slider on that: written together, of which the last may be wrong. */
static void bodies_are_moved_along(void** state) {
  Bench bench, *b = &bench;
  carom_joint joint[3], rod, both[2];
  carom_joint_desc d;
  carom_error e = CAROM_ERROR_INIT;
  const double h = sqrt(0.5), to[3] = {3.141592653589793 / 2, -3.141592653589793, 0.5}, fast[3] = {2, 0, 0};
  double at[3][3], was[3], q[4], v[3], w[3], back[3];
  uint64_t hash[2];
  int i;
  (void)state;
  assert_int_equal(bench_make(b, NULL, NULL), CAROM_OK);
  for (i = 0; i < 3; ++i) { /* joints about z at the origin and at (2, 0, 0); a rail along x at (4, 0, 0) */
    const double place[3] = {2.0 * i + 1, 0, 0};
    assert_int_equal(carom_body_set_pose(b->world, b->bodies[i], place, upright, NULL), CAROM_OK);
    carom_joint_desc_init(&d, sizeof d);
    d.kind = i == 2 ? CAROM_JOINT_SLIDER : CAROM_JOINT_HINGE, d.fields = CAROM_JOINT_WORLD_FRAME;
    d.body_a = i ? b->bodies[i - 1] : CAROM_NULL_HANDLE, d.body_b = b->bodies[i], d.position_a[0] = 2 * i;
    if (i < 2) d.orientation_a[1] = -h, d.orientation_a[3] = h;
    if (i == 1) d.fields |= CAROM_JOINT_ACCELERATIONS;
    assert_int_equal(carom_joint_create(b->world, &d, &joint[i], NULL), CAROM_OK);
  }
  assert_int_equal(ROW(CAROM_JOINT_BULK_POSITION, joint, 3, to), CAROM_OK);
  assert_int_equal(ROW(CAROM_JOINT_BULK_VELOCITY, joint, 3, fast), CAROM_OK);
  /* Up to (0, 2, 0), down from there, half a metre further down. */
  for (i = 0; i < 3; ++i) assert_int_equal(carom_body_get_pose(b->world, b->bodies[i], at[i], q, NULL), CAROM_OK);
  assert_true(fabs(at[0][0]) < 1e-15 && fabs(at[0][1] - 1) < 1e-15);
  assert_true(fabs(at[1][0]) < 1e-15 && fabs(at[1][1] - 1) < 1e-15);
  assert_true(fabs(at[2][0]) < 4e-15 && fabs(at[2][1] + 1.5) < 4e-15);
  assert_int_equal(carom_body_get_velocity(b->world, b->bodies[2], v, w, NULL), CAROM_OK);
  assert_true(fabs(v[0] - 3) < 1e-14 && fabs(v[1]) < 1e-14 && fabs(w[2] - 2) < 1e-15);
  READ(CAROM_JOINT_BULK_POSITION, joint, 3, back);
  for (i = 0; i < 3; ++i) assert_true(fabs(back[i] - to[i]) < 1e-15);
  READ(CAROM_JOINT_BULK_VELOCITY, joint, 3, back);
  for (i = 0; i < 3; ++i) assert_true(fabs(back[i] - fast[i]) < 1e-14);
  READ(CAROM_JOINT_BULK_ACCELERATION, joint + 1, 1, back);
  assert_true(back[0] == 0);
  assert_int_equal(carom_joint_get(b->world, joint[1], &d, NULL), CAROM_OK);
  assert_true(d.fields & CAROM_JOINT_ACCELERATIONS);
  assert_int_equal(
      carom_world_read_joints(b->world, CAROM_JOINT_BULK_ACCELERATION, CAROM_SCALAR_F64, joint, 2, back, 0, &e),
      CAROM_E_UNSUPPORTED);
  assert_true(e.argument == 4 && strstr(e.message, "joint 0") && strstr(e.remedy, "CAROM_JOINT_ACCELERATIONS"));
  /* What is refused changes nothing. */
  assert_int_equal(carom_world_hash(b->world, &hash[0], NULL), CAROM_OK);
  memcpy(was, to, sizeof was), was[2] = NAN;
  assert_int_equal(ROW(CAROM_JOINT_BULK_POSITION, joint, 3, was), CAROM_E_NOT_FINITE);
  was[2] = 2e9;
  assert_int_equal(ROW(CAROM_JOINT_BULK_POSITION, joint, 3, was), CAROM_E_OUT_OF_RANGE);
  was[0] = 1e9, was[1] = 1e9, was[2] = 1e9;
  assert_int_equal(
      carom_world_write_joints(b->world, CAROM_JOINT_BULK_VELOCITY, CAROM_SCALAR_F64, joint, 3, was, 0, &e),
      CAROM_E_OUT_OF_RANGE);
  assert_true(e.argument == 6 && e.remedy[0]);
  {
    const double far_up[3] = {0, 9, 0};
    rod = join(b, CAROM_JOINT_DISTANCE, 2, far_up);
  }
  both[0] = joint[0], both[1] = rod;
  assert_int_equal(carom_world_write_joints(b->world, CAROM_JOINT_BULK_POSITION, CAROM_SCALAR_F64, both, 2, to, 0, &e),
                   CAROM_E_UNSUPPORTED);
  assert_true(e.argument == 4 && strstr(e.message, "joint 1 is a distance") && strstr(e.remedy, "AXES"));
  was[0] = 0.25, was[1] = 0;
  assert_int_equal(
      carom_world_write_joints(b->world, CAROM_JOINT_BULK_POSITION, CAROM_SCALAR_F64, joint + 1, 1, was, 0, &e),
      CAROM_E_UNSUPPORTED);
  assert_true(e.argument == 4 && strstr(e.message, "joint 0 is part of a loop") && strstr(e.remedy, "leave out"));
  assert_int_equal(carom_joint_destroy(b->world, rod, NULL), CAROM_OK);
  assert_int_equal(carom_world_hash(b->world, &hash[1], NULL), CAROM_OK);
  assert_true(hash[0] == hash[1]);
  assert_int_equal(bench_free(b), CAROM_OK);
}

/* Efforts: a wheel by its motor's torque, a weight that a slider's motor lifts, one that a rod holds. */
static void efforts_are_those_of_the_drives(void** state) {
  Bench bench, *b = &bench;
  carom_joint joint[3];
  double effort[3], want[3] = {1.5, 2.5, 0}, motion[3], speed[3], still[3], six[6];
  const double h = 1.0 / 64, wide[9] = {0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5}, none[3] = {0, 0, 0};
  int i;
  (void)state;
  assert_int_equal(bench_make(b, NULL, NULL), CAROM_OK);
  for (i = 0; i < 3; ++i) { /* a wheel on its axle, a carriage on a level rail, a bob on a rod 2 m below */
    double at[3] = {0, 20, 0};
    at[0] = 10 * i;
    assert_int_equal(carom_body_set_pose(b->world, b->bodies[i], at, upright, NULL), CAROM_OK);
    assert_int_equal(carom_body_set_mass(b->world, b->bodies[i], 2, none, wide, NULL), CAROM_OK);
    at[1] += i == 2 ? 2 : 0;
    joint[i] = join(b, i == 0 ? CAROM_JOINT_HINGE : i == 1 ? CAROM_JOINT_SLIDER : CAROM_JOINT_DISTANCE, i, at);
  }
  assert_int_equal(ROW(CAROM_JOINT_BULK_TARGET_EFFORT, joint, 2, want), CAROM_OK);
  READ(CAROM_JOINT_BULK_TARGET_EFFORT, joint, 3, effort);
  assert_true(effort[0] == 1.5 && effort[1] == 2.5 && effort[2] == 0);
  assert_int_equal(bench_steps(b->world, 30, NULL), CAROM_OK);
  READ(CAROM_JOINT_BULK_EFFORT, joint, 3, effort);
  READ(CAROM_JOINT_BULK_VELOCITY, joint, 3, speed);
  READ(CAROM_JOINT_BULK_POSITION, joint, 3, motion);
  assert_true(fabs(effort[0] - 1.5) < 1e-12 && fabs(effort[1] - 2.5) < 1e-12);
  assert_true(fabs(effort[2] + 2 * 9.81) < 1e-9); /* the rod pulls towards A: against what its length grows by */
  assert_true(fabs(speed[0] - 1.5 / 0.5 * 30 * h) < 1e-9 && fabs(speed[1] - 2.5 / 2 * 30 * h) < 1e-9);
  assert_true(fabs(motion[0] - 1.5 / 0.5 / 2 * 900 * h * h) < 0.03 && fabs(motion[2] - 2) < 1e-9);
  READ(CAROM_JOINT_BULK_AXIS_EFFORTS, joint + 1, 1, six);
  assert_true(fabs(six[0] - 2.5) < 1e-12 && fabs(six[1] - 2 * 9.81) < 1e-9);
  /* No effort: it rolls on as it is. A motor of another speed is none of an effort. */
  want[0] = want[1] = 0;
  assert_int_equal(ROW(CAROM_JOINT_BULK_TARGET_EFFORT, joint, 2, want), CAROM_OK);
  assert_int_equal(bench_steps(b->world, 5, NULL), CAROM_OK);
  READ(CAROM_JOINT_BULK_VELOCITY, joint, 3, still);
  assert_true(fabs(still[0] - speed[0]) < 1e-12 && fabs(still[1] - speed[1]) < 1e-12);
  want[0] = 3;
  assert_int_equal(ROW(CAROM_JOINT_BULK_TARGET_VELOCITY, joint, 1, want), CAROM_OK);
  READ(CAROM_JOINT_BULK_TARGET_EFFORT, joint, 1, effort);
  assert_true(effort[0] == 0);
  assert_int_equal(bench_free(b), CAROM_OK);
}

/* Turns are counted: a wheel that has turned three times is at 6 pi, not at 0. */
static void positions_count_turns(void** state) {
  Bench bench, *b = &bench;
  const double at[3] = {0, 20, 0}, motor[3] = {1, 6.283185307179586, 1e6};
  double position;
  carom_joint joint;
  (void)state;
  assert_int_equal(bench_make(b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_pose(b->world, b->bodies[0], at, upright, NULL), CAROM_OK);
  joint = join(b, CAROM_JOINT_HINGE, 0, at);
  assert_int_equal(ROW(CAROM_JOINT_BULK_MOTOR, &joint, 1, motor), CAROM_OK);
  assert_int_equal(bench_steps(b->world, 192, NULL), CAROM_OK);
  READ(CAROM_JOINT_BULK_POSITION, &joint, 1, &position);
  assert_true(fabs(position - 6 * 3.141592653589793) < 0.1);
  assert_int_equal(bench_free(b), CAROM_OK);
}

/* Targets that are written anew each step, the same ones, let a robot sleep. Others wake it. */
static void what_is_written_again_wakes_nothing(void** state) {
  Bench bench, *b = &bench;
  const double at[3] = {0, 20, 0};
  double spring[5] = {1, 0, 2, 1, 1e30};
  uint32_t asleep = 0;
  carom_joint joint;
  int i;
  (void)state;
  assert_int_equal(bench_make(b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b->world, CAROM_DIAL_SLEEP, 1, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_pose(b->world, b->bodies[0], at, upright, NULL), CAROM_OK);
  joint = join(b, CAROM_JOINT_HINGE, 0, at);
  for (i = 0; i < 120; ++i) {
    assert_int_equal(ROW(CAROM_JOINT_BULK_SPRING, &joint, 1, spring), CAROM_OK);
    assert_int_equal(bench_steps(b->world, 1, NULL), CAROM_OK);
  }
  assert_int_equal(carom_body_is_asleep(b->world, b->bodies[0], &asleep, NULL), CAROM_OK);
  assert_int_equal(asleep, 1);
  spring[1] = 0.5;
  assert_int_equal(ROW(CAROM_JOINT_BULK_SPRING, &joint, 1, spring), CAROM_OK);
  assert_int_equal(carom_body_is_asleep(b->world, b->bodies[0], &asleep, NULL), CAROM_OK);
  assert_int_equal(asleep, 0);
  assert_int_equal(bench_free(b), CAROM_OK);
}

static void widths_are_known(void** state) {
  uint32_t field, width = 77;
  (void)state;
  assert_int_equal(carom_joint_bulk_width(CAROM_JOINT_BULK_COUNT, &width), CAROM_E_UNKNOWN_ENUM);
  assert_int_equal(carom_joint_bulk_width(0, NULL), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(width, 77);
  for (field = 0; field < CAROM_JOINT_BULK_COUNT; ++field) {
    assert_int_equal(carom_joint_bulk_width(field, &width), CAROM_OK);
    assert_in_range(width, 1, 12);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(rates_are_differences),
                                     cmocka_unit_test(forces_are_those_of_the_state),
                                     cmocka_unit_test(written_is_as_set_one_by_one),
                                     cmocka_unit_test(axes_are_written_too),
                                     cmocka_unit_test(a_wrong_record_changes_nothing),
                                     cmocka_unit_test(bodies_are_moved_along),
                                     cmocka_unit_test(efforts_are_those_of_the_drives),
                                     cmocka_unit_test(positions_count_turns),
                                     cmocka_unit_test(what_is_written_again_wakes_nothing),
                                     cmocka_unit_test(widths_are_known)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
