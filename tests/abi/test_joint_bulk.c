/* Joints read many at a time. Rates against central differences of the coordinates. */
#include "bench.h"
#include "carom_test.h"

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
        carom_world_read_joints(b->world, CAROM_JOINT_READ_SPEEDS, CAROM_SCALAR_F64, joint, 2 * KINDS, speed, 0, NULL),
        CAROM_OK);
    assert_int_equal(carom_world_read_joints(b->world, CAROM_JOINT_READ_AXIS_SPEEDS, CAROM_SCALAR_F64, joint, 2 * KINDS,
                                             rate, 0, NULL),
                     CAROM_OK);
    for (side = 0; side < 2; ++side) {
      for (i = 0; i < 2; ++i) place(b, i, &motion[i], side ? h : -h);
      assert_int_equal(carom_world_read_joints(b->world, CAROM_JOINT_READ_COORDINATES, CAROM_SCALAR_F64, joint,
                                               2 * KINDS, at[side], 0, NULL),
                       CAROM_OK);
      assert_int_equal(carom_world_read_joints(b->world, CAROM_JOINT_READ_AXES, CAROM_SCALAR_F64, joint, 2 * KINDS,
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
  assert_int_equal(carom_world_read_joints(b->world, CAROM_JOINT_READ_FORCE, CAROM_SCALAR_F64, NULL, 2, all, 0, NULL),
                   CAROM_OK);
  assert_int_equal(carom_world_read_joints(b->world, CAROM_JOINT_READ_ERROR, CAROM_SCALAR_F64, NULL, 2, error, 0, NULL),
                   CAROM_OK);
  assert_int_equal(
      carom_world_read_joints(b->world, CAROM_JOINT_READ_BROKEN, CAROM_SCALAR_F64, NULL, 2, broken, 0, NULL), CAROM_OK);
  assert_int_equal(
      carom_world_read_joints(b->world, CAROM_JOINT_READ_FORCE, CAROM_SCALAR_F32, joint, 2, some, sizeof some[0], NULL),
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
  assert_int_equal(carom_world_read_joints(b->world, CAROM_JOINT_READ_FORCE, CAROM_SCALAR_F64, NULL, 1, all, 0, NULL),
                   CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_world_read_joints(b->world, CAROM_JOINT_READ_COUNT, CAROM_SCALAR_F64, NULL, 2, all, 0, NULL),
                   CAROM_E_UNKNOWN_ENUM);
  assert_int_equal(carom_world_read_joints(b->world, CAROM_JOINT_READ_FORCE, CAROM_SCALAR_F64, NULL, 2, all, 8, NULL),
                   CAROM_E_BUFFER_TOO_SMALL);
  assert_int_equal(bench_free(b), CAROM_OK);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(rates_are_differences),
                                     cmocka_unit_test(forces_are_those_of_the_state)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
