/* Gravity factor and axis locks of a body, surface velocity of a collider, as a host sets and reads them. */
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

static void they_are_what_they_were_set_to(void** state) {
  Bench* b = *state;
  const double linear[3] = {1, 2, -3}, angular[3] = {0.5, 0, 7};
  double factor = 9, v[3] = {9, 9, 9}, w[3] = {9, 9, 9};
  uint32_t locks = 9;
  assert_int_equal(carom_body_get_gravity_factor(b->world, b->bodies[1], &factor, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_locks(b->world, b->bodies[1], &locks, NULL), CAROM_OK);
  assert_int_equal(carom_collider_get_surface_velocity(b->world, b->colliders[1], v, w, NULL), CAROM_OK);
  assert_true(factor == 1 && locks == 0 && v[0] == 0 && v[1] == 0 && v[2] == 0 && w[0] == 0 && w[1] == 0 && w[2] == 0);
  assert_int_equal(carom_body_set_gravity_factor(b->world, b->bodies[1], -1e300, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_locks(b->world, b->bodies[1], CAROM_LOCK_PLANE, NULL), CAROM_OK);
  assert_int_equal(carom_collider_set_surface_velocity(b->world, b->colliders[1], linear, angular, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_gravity_factor(b->world, b->bodies[1], &factor, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_locks(b->world, b->bodies[1], &locks, NULL), CAROM_OK);
  assert_int_equal(carom_collider_get_surface_velocity(b->world, b->colliders[1], v, w, NULL), CAROM_OK);
  assert_true(factor == -1e300 && locks == CAROM_LOCK_PLANE);
  assert_memory_equal(v, linear, sizeof v);
  assert_memory_equal(w, angular, sizeof w);
  assert_int_equal(carom_body_get_locks(b->world, b->bodies[0], &locks, NULL), CAROM_OK);
  assert_int_equal(locks, 0); /* the others' stay as they are */
}

/* Set and taken back before a step they change nothing; set they do. */
static void what_is_set_is_felt_and_what_is_taken_back_is_not(void** state) {
  uint64_t hash[5];
  const double belt[3] = {1, 0, 0}, none[3] = {0, 0, 0};
  int i;
  (void)state;
  for (i = 0; i < 5; ++i) {
    Bench b;
    assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
    if (i == 1 || i == 4) assert_int_equal(carom_body_set_gravity_factor(b.world, b.bodies[0], 0.5, NULL), CAROM_OK);
    if (i == 2 || i == 4)
      assert_int_equal(carom_body_set_locks(b.world, b.bodies[3], CAROM_LOCK_PLANE, NULL), CAROM_OK);
    if (i == 3 || i == 4)
      assert_int_equal(carom_collider_set_surface_velocity(b.world, b.ground_collider, belt, none, NULL), CAROM_OK);
    if (i == 4) {
      assert_int_equal(carom_body_set_gravity_factor(b.world, b.bodies[0], 1, NULL), CAROM_OK);
      assert_int_equal(carom_body_set_locks(b.world, b.bodies[3], 0, NULL), CAROM_OK);
      assert_int_equal(carom_collider_set_surface_velocity(b.world, b.ground_collider, none, none, NULL), CAROM_OK);
    }
    assert_int_equal(bench_steps(b.world, 200, NULL), CAROM_OK);
    hash[i] = bench_hash(b.world);
    assert_int_equal(bench_free(&b), CAROM_OK);
  }
  for (i = 1; i < 4; ++i) assert_true(hash[i] != hash[0]);
  assert_true(hash[4] == hash[0]);
}

static void locked_velocities_are_gone_and_stay_away(void** state) {
  Bench* b = *state;
  const double linear[3] = {1, 2, 3}, angular[3] = {4, 5, 6}, push[3] = {7, 8, 9}, at[3] = {0, 30, 0};
  double v[6];
  int i;
  assert_int_equal(carom_body_set_velocity(b->world, b->bodies[3], linear, angular, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_locks(b->world, b->bodies[3], CAROM_LOCK_LINEAR_X | CAROM_LOCK_ANGULAR_Y, NULL),
                   CAROM_OK);
  for (i = 0; i < 3; ++i) {
    assert_int_equal(carom_world_read(b->world, CAROM_FIELD_VELOCITY, CAROM_SCALAR_F64, &b->bodies[3], 1, v, 0, NULL),
                     CAROM_OK);
    assert_true(v[0] == 0 && v[4] == 0 && v[3] != 0 && v[2] != 0);
    if (i == 0) assert_int_equal(carom_body_set_velocity(b->world, b->bodies[3], linear, angular, NULL), CAROM_OK);
    if (i == 1) assert_int_equal(carom_body_add_impulse(b->world, b->bodies[3], push, at, NULL), CAROM_OK);
  }
  assert_int_equal(carom_body_add_force(b->world, b->bodies[3], push, push, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b->world, 1, NULL), CAROM_OK);
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_VELOCITY, CAROM_SCALAR_F64, &b->bodies[3], 1, v, 0, NULL),
                   CAROM_OK);
  assert_true(v[0] == 0 && v[4] == 0);
}

static void severity_knows_no_locks(void** state) {
  Bench* b = *state;
  carom_error e = CAROM_ERROR_INIT;
  uint32_t locks = 9;
  assert_int_equal(carom_world_set_dial(b->world, CAROM_DIAL_SOLVER, CAROM_SOLVER_SEVERITY, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_locks(b->world, b->bodies[0], CAROM_LOCK_LINEAR_Z, &e), CAROM_E_UNSUPPORTED);
  assert_true(strstr(e.message, "severity") != NULL);
  assert_int_equal(carom_body_set_locks(b->world, b->bodies[0], 0, NULL), CAROM_OK); /* asks for nothing */
  assert_int_equal(carom_world_set_dial(b->world, CAROM_DIAL_SOLVER, CAROM_SOLVER_AUTO, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_locks(b->world, b->bodies[0], CAROM_LOCK_LINEAR_Z, NULL), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b->world, CAROM_DIAL_SOLVER, CAROM_SOLVER_SEVERITY, &e), CAROM_E_UNSUPPORTED);
  assert_true(strstr(e.message, "free them") != NULL);
  assert_int_equal(carom_body_get_locks(b->world, b->bodies[0], &locks, NULL), CAROM_OK);
  assert_int_equal(locks, CAROM_LOCK_LINEAR_Z);
  assert_int_equal(carom_body_destroy(b->world, b->bodies[0], NULL), CAROM_OK); /* takes its locks with it */
  assert_int_equal(carom_world_set_dial(b->world, CAROM_DIAL_SOLVER, CAROM_SOLVER_SEVERITY, NULL), CAROM_OK);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(they_are_what_they_were_set_to, make, clear),
      cmocka_unit_test(what_is_set_is_felt_and_what_is_taken_back_is_not),
      cmocka_unit_test_setup_teardown(locked_velocities_are_gone_and_stay_away, make, clear),
      cmocka_unit_test_setup_teardown(severity_knows_no_locks, make, clear),
  };
  return cmocka_run_group_tests_name("abi/body_effects", tests, NULL, NULL);
}
