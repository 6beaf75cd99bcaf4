/* Bulk calls: one for n bodies, in float or double, at any stride; all or nothing. */
#include "bench.h"
#include "carom_test.h"

static int make(void** state) {
  static Bench b;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 20, NULL), CAROM_OK);
  *state = &b;
  return 0;
}
static int clear(void** state) {
  assert_int_equal(bench_free(*state), CAROM_OK);
  return 0;
}

static const int scalars[CAROM_FIELD_COUNT] = {3, 4, 7, 3, 3, 6, 6, 3, 1};

static void fields_agree_with_single_calls(void** state) {
  Bench* b = *state;
  int i, k;
  for (i = 0; i < BENCH_BODIES; ++i) {
    carom_body_desc d;
    double pose[7], velocity[6], position[3], turn[4], linear[3], angular[3], mass, center[3];
    const carom_body body = b->bodies[i];
    d.struct_size = sizeof d;
    assert_int_equal(carom_body_get(b->world, body, &d, NULL), CAROM_OK);
    assert_int_equal(carom_world_read(b->world, CAROM_FIELD_POSE, 1, &body, 1, pose, 0, NULL), CAROM_OK);
    assert_int_equal(carom_world_read(b->world, CAROM_FIELD_POSITION, 1, &body, 1, position, 0, NULL), CAROM_OK);
    assert_int_equal(carom_world_read(b->world, CAROM_FIELD_ORIENTATION, 1, &body, 1, turn, 0, NULL), CAROM_OK);
    assert_int_equal(carom_world_read(b->world, CAROM_FIELD_VELOCITY, 1, &body, 1, velocity, 0, NULL), CAROM_OK);
    assert_int_equal(carom_world_read(b->world, CAROM_FIELD_LINEAR_VELOCITY, 1, &body, 1, linear, 0, NULL), CAROM_OK);
    assert_int_equal(carom_world_read(b->world, CAROM_FIELD_ANGULAR_VELOCITY, 1, &body, 1, angular, 0, NULL), CAROM_OK);
    assert_int_equal(carom_world_read(b->world, CAROM_FIELD_MASS, 1, &body, 1, &mass, 0, NULL), CAROM_OK);
    assert_int_equal(carom_world_read(b->world, CAROM_FIELD_CENTER, 1, &body, 1, center, 0, NULL), CAROM_OK);
    assert_true(mass == d.mass && mass > 0);
    for (k = 0; k < 3; ++k) {
      assert_true(pose[k] == d.position[k] && position[k] == d.position[k]);
      assert_true(velocity[k] == d.linear_velocity[k] && linear[k] == d.linear_velocity[k]);
      assert_true(velocity[3 + k] == d.angular_velocity[k] && angular[k] == d.angular_velocity[k]);
      assert_true(fabs(center[k] - position[k]) < 1e-12); /* these shapes are centred; a rounding of ~4 m */
    }
    for (k = 0; k < 4; ++k) assert_true(pose[3 + k] == d.orientation[k] && turn[k] == d.orientation[k]);
  }
}

static void floats_are_the_doubles_rounded(void** state) {
  Bench* b = *state;
  uint32_t field;
  int i;
  for (field = 0; field < CAROM_FIELD_COUNT; ++field) {
    double d[BENCH_BODIES * 7];
    float f[BENCH_BODIES * 7];
    assert_int_equal(carom_world_read(b->world, field, CAROM_SCALAR_F64, b->bodies, BENCH_BODIES, d, 0, NULL),
                     CAROM_OK);
    assert_int_equal(carom_world_read(b->world, field, CAROM_SCALAR_F32, b->bodies, BENCH_BODIES, f, 0, NULL),
                     CAROM_OK);
    for (i = 0; i < BENCH_BODIES * scalars[field]; ++i) assert_true(f[i] == (float)d[i]);
  }
}

static void a_stride_leaves_the_gaps_alone(void** state) {
  Bench* b = *state;
  double tight[BENCH_BODIES][3];
  unsigned char wide[BENCH_BODIES * 37 + 1]; /* 37: no alignment at all */
  int i, k;
  memset(wide, 0xA5, sizeof wide);
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_POSITION, 1, b->bodies, BENCH_BODIES, tight, 0, NULL),
                   CAROM_OK);
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_POSITION, 1, b->bodies, BENCH_BODIES, wide + 1, 37, NULL),
                   CAROM_OK);
  assert_int_equal(wide[0], 0xA5);
  for (i = 0; i < BENCH_BODIES; ++i) {
    assert_memory_equal(wide + 1 + 37 * i, tight[i], sizeof tight[i]);
    for (k = 24; k < 37; ++k) assert_int_equal(wide[1 + 37 * i + k], 0xA5);
  }
  assert_int_equal(carom_world_write(b->world, CAROM_FIELD_POSITION, 1, b->bodies, BENCH_BODIES, wide + 1, 37, NULL),
                   CAROM_OK);
}

static void no_handles_means_all_bodies_in_their_order(void** state) {
  Bench* b = *state;
  carom_body bodies[BENCH_BODIES + 1];
  double all[BENCH_BODIES + 1][7], some[BENCH_BODIES + 1][7];
  uint64_t count = 0, n = 0;
  assert_int_equal(carom_world_get_bodies(b->world, NULL, 0, &count, NULL), CAROM_OK);
  assert_int_equal(count, BENCH_BODIES + 1);
  assert_int_equal(carom_world_get_bodies(b->world, bodies, count, &n, NULL), CAROM_OK);
  assert_true(n == count && bodies[0] == b->ground && bodies[1] == b->bodies[0] && bodies[4] == b->bodies[3]);
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_POSE, 1, NULL, count, all, 0, NULL), CAROM_OK);
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_POSE, 1, bodies, count, some, 0, NULL), CAROM_OK);
  assert_memory_equal(all, some, sizeof all);
  /* A hole in the middle is skipped. */
  assert_int_equal(carom_body_destroy(b->world, b->bodies[1], NULL), CAROM_OK);
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_POSE, 1, NULL, count, all, 0, NULL), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_POSE, 1, NULL, count - 1, all, 0, NULL), CAROM_OK);
  assert_memory_equal(all[2], some[3], sizeof *all);
  bodies[1] = 77;
  assert_int_equal(carom_world_get_bodies(b->world, bodies, 1, &n, NULL), CAROM_OK); /* room for one: one is written */
  assert_true(n == count - 1 && bodies[0] == b->ground && bodies[1] == 77);
}

static void what_is_written_is_read_back(void** state) {
  Bench* b = *state;
  static const double s = 0.70710678118654757;
  double pose[2][7] = {{1, 2, 3, 0, 0, 0, 1}, {-1, 50, 2, 0, 0, 0, 1}}, velocity[2][6], force[2][6], got[2][7];
  int i;
  pose[1][3] = s, pose[1][6] = s;
  for (i = 0; i < 12; ++i) velocity[i / 6][i % 6] = i + 0.5, force[i / 6][i % 6] = -i;
  assert_int_equal(carom_world_write(b->world, CAROM_FIELD_POSE, 1, b->bodies, 2, pose, 0, NULL), CAROM_OK);
  assert_int_equal(carom_world_write(b->world, CAROM_FIELD_VELOCITY, 1, b->bodies, 2, velocity, 0, NULL), CAROM_OK);
  assert_int_equal(carom_world_write(b->world, CAROM_FIELD_FORCE, 1, b->bodies, 2, force, 0, NULL), CAROM_OK);
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_VELOCITY, 1, b->bodies, 2, got, 0, NULL), CAROM_OK);
  assert_memory_equal(got, velocity, sizeof velocity);
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_FORCE, 1, b->bodies, 2, got, 0, NULL), CAROM_OK);
  assert_memory_equal(got, force, sizeof force);
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_POSE, 1, b->bodies, 2, got, 0, NULL), CAROM_OK);
  for (i = 0; i < 7; ++i) {
    assert_true(got[0][i] == pose[0][i]);
    assert_true(fabs(got[1][i] - pose[1][i]) <=
                4 * 2.2e-16 * fabs(pose[1][i])); /* renormalised, and about the centre */
  }
  /* The force is replaced, then used up by one step. */
  assert_int_equal(carom_world_write(b->world, CAROM_FIELD_FORCE, 1, b->bodies, 2, velocity, 0, NULL), CAROM_OK);
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_FORCE, 1, b->bodies, 2, got, 0, NULL), CAROM_OK);
  assert_memory_equal(got, velocity, sizeof velocity);
  assert_int_equal(carom_world_step(b->world, 0.01, NULL), CAROM_OK);
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_FORCE, 1, b->bodies, 2, got, 0, NULL), CAROM_OK);
  for (i = 0; i < 12; ++i) assert_true((&got[0][0])[i] == 0);
}

static void one_bad_record_and_nothing_is_written(void** state) {
  Bench* b = *state;
  double before[BENCH_BODIES][3], after[BENCH_BODIES][3], wrong[BENCH_BODIES][3];
  carom_body bodies[BENCH_BODIES];
  const uint64_t hash = bench_hash(b->world);
  int i;
  memcpy(bodies, b->bodies, sizeof bodies);
  for (i = 0; i < 3 * BENCH_BODIES; ++i) (&wrong[0][0])[i] = 9;
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_POSITION, 1, bodies, BENCH_BODIES, before, 0, NULL),
                   CAROM_OK);
  bodies[BENCH_BODIES - 1] = 12345;
  assert_int_equal(carom_world_write(b->world, CAROM_FIELD_POSITION, 1, bodies, BENCH_BODIES, wrong, 0, NULL),
                   CAROM_E_INVALID_HANDLE);
  wrong[BENCH_BODIES - 1][2] = NAN;
  assert_int_equal(carom_world_write(b->world, CAROM_FIELD_POSITION, 1, b->bodies, BENCH_BODIES, wrong, 0, NULL),
                   CAROM_E_NOT_FINITE);
  assert_true(bench_hash(b->world) == hash);
  memcpy(after, before, sizeof after);
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_POSITION, 1, bodies, BENCH_BODIES, after, 0, NULL),
                   CAROM_E_INVALID_HANDLE);
  assert_memory_equal(after, before, sizeof after); /* a read that fails writes nothing either */
}

static void none_at_all_is_fine(void** state) {
  Bench* b = *state;
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_POSE, 1, b->bodies, 0, NULL, 0, NULL), CAROM_OK);
  assert_int_equal(carom_world_write(b->world, CAROM_FIELD_POSE, 1, b->bodies, 0, NULL, 0, NULL), CAROM_OK);
}

static void a_static_body_may_be_placed_but_not_moved(void** state) {
  Bench* b = *state;
  const double pose[7] = {0, -1, 0, 0, 0, 0, 1}, still[6] = {0, 0, 0, 0, 0, 0}, moving[6] = {0, 0, 1, 0, 0, 0};
  double mass = 7;
  assert_int_equal(carom_world_write(b->world, CAROM_FIELD_POSE, 1, &b->ground, 1, pose, 0, NULL), CAROM_OK);
  assert_int_equal(carom_world_write(b->world, CAROM_FIELD_VELOCITY, 1, &b->ground, 1, still, 0, NULL), CAROM_OK);
  assert_int_equal(carom_world_write(b->world, CAROM_FIELD_VELOCITY, 1, &b->ground, 1, moving, 0, NULL),
                   CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_world_write(b->world, CAROM_FIELD_LINEAR_VELOCITY, 1, &b->ground, 1, moving, 0, NULL),
                   CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_MASS, 1, &b->ground, 1, &mass, 0, NULL), CAROM_OK);
  assert_true(mass == 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(fields_agree_with_single_calls, make, clear),
      cmocka_unit_test_setup_teardown(floats_are_the_doubles_rounded, make, clear),
      cmocka_unit_test_setup_teardown(a_stride_leaves_the_gaps_alone, make, clear),
      cmocka_unit_test_setup_teardown(no_handles_means_all_bodies_in_their_order, make, clear),
      cmocka_unit_test_setup_teardown(what_is_written_is_read_back, make, clear),
      cmocka_unit_test_setup_teardown(one_bad_record_and_nothing_is_written, make, clear),
      cmocka_unit_test_setup_teardown(none_at_all_is_fine, make, clear),
      cmocka_unit_test_setup_teardown(a_static_body_may_be_placed_but_not_moved, make, clear),
  };
  return cmocka_run_group_tests_name("abi/bulk", tests, NULL, NULL);
}
