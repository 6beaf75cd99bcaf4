/* Sleep through the boundary: the dial, the two calls, the descriptor's flag, the counts of the report; and the same bits
 * whatever the order of handles in bulk calls. */
#include "bench.h"
#include "carom_test.h"

/* Without gravity, and with nothing to hit, all lie still from the first step on; those that overlap are parted without a
 * velocity. */
static void still_stage(Bench* b) {
  const double none[3] = {0, 0, 0};
  assert_int_equal(bench_make(b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_world_set_gravity(b->world, none, NULL), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b->world, CAROM_DIAL_SOLVER, CAROM_SOLVER_SEVERITY, NULL), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b->world, CAROM_DIAL_SLEEP, 1, NULL), CAROM_OK);
}

static uint32_t asleep(const Bench* b, int i) {
  uint32_t yes = 77;
  assert_int_equal(carom_body_is_asleep(b->world, b->bodies[i], &yes, NULL), CAROM_OK);
  return yes;
}

static carom_step_report report(const Bench* b) {
  carom_step_report r;
  memset(&r, 0, sizeof r);
  r.struct_size = sizeof r;
  assert_int_equal(carom_world_get_report(b->world, &r, NULL), CAROM_OK);
  return r;
}

static void a_new_world_does_not_sleep(void** state) {
  Bench b;
  double value = 77;
  const double none[3] = {0, 0, 0};
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_world_set_gravity(b.world, none, NULL), CAROM_OK);
  assert_int_equal(carom_world_get_dial(b.world, CAROM_DIAL_SLEEP, &value, NULL), CAROM_OK);
  assert_true(value == 0);
  assert_int_equal(bench_steps(b.world, 100, NULL), CAROM_OK);
  assert_int_equal(asleep(&b, 0), 0);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void the_report_counts_who_falls_asleep_and_wakes(void** state) {
  Bench b;
  uint64_t fell = 0;
  int i;
  (void)state;
  still_stage(&b);
  for (i = 0; i < 40; ++i) {
    assert_int_equal(bench_steps(b.world, 1, NULL), CAROM_OK);
    fell += report(&b).fell_asleep;
  }
  assert_int_equal(fell, BENCH_BODIES);
  assert_int_equal(report(&b).asleep_bodies, BENCH_BODIES);
  assert_int_equal(report(&b).dynamic_bodies, BENCH_BODIES);
  for (i = 0; i < BENCH_BODIES; ++i) assert_int_equal(asleep(&b, i), 1);
  assert_int_equal(carom_body_wake(b.world, b.bodies[1], NULL), CAROM_OK);
  assert_int_equal(asleep(&b, 1), 0);
  assert_int_equal(bench_steps(b.world, 1, NULL), CAROM_OK);
  assert_int_equal(report(&b).woke_up + report(&b).asleep_bodies, BENCH_BODIES);
  assert_true(report(&b).woke_up >= 1);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void the_ground_never_sleeps_and_may_be_woken(void** state) {
  Bench b;
  uint32_t yes = 77;
  (void)state;
  still_stage(&b);
  assert_int_equal(bench_steps(b.world, 60, NULL), CAROM_OK);
  assert_int_equal(carom_body_is_asleep(b.world, b.ground, &yes, NULL), CAROM_OK);
  assert_int_equal(yes, 0);
  assert_int_equal(carom_body_wake(b.world, b.ground, NULL), CAROM_OK);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void stays_awake_is_kept_told_and_heeded(void** state) {
  Bench b;
  carom_body_desc desc, got;
  carom_body body;
  uint32_t yes = 77;
  (void)state;
  still_stage(&b);
  carom_body_desc_init(&desc, sizeof desc);
  assert_int_equal(desc.fields, 0);
  desc.fields = CAROM_BODY_STAYS_AWAKE;
  desc.position[1] = 50;
  assert_int_equal(carom_body_create(b.world, &desc, &body, NULL), CAROM_OK);
  got.struct_size = sizeof got;
  assert_int_equal(carom_body_get(b.world, body, &got, NULL), CAROM_OK);
  assert_true(got.fields & CAROM_BODY_STAYS_AWAKE);
  assert_int_equal(bench_steps(b.world, 100, NULL), CAROM_OK);
  assert_int_equal(carom_body_is_asleep(b.world, body, &yes, NULL), CAROM_OK);
  assert_int_equal(yes, 0);
  assert_int_equal(asleep(&b, 0), 1);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/* A heap falls, sleeps, is hit by forces written in bulk in one order or the other, and sleeps again. */
static uint64_t bits_of_a_night(int backwards) {
  Bench b;
  carom_body handles[BENCH_BODIES];
  double forces[BENCH_BODIES][6];
  uint64_t hash;
  int i;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SLEEP, 1, NULL), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SLEEP_SPEED, 0.5, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 400, NULL), CAROM_OK);
  assert_true(report(&b).asleep_bodies > 0);
  memset(forces, 0, sizeof forces);
  for (i = 0; i < BENCH_BODIES; ++i) {
    const int at = backwards ? BENCH_BODIES - 1 - i : i;
    handles[i] = b.bodies[at];
    forces[i][0] = 1000.0 * (at + 1);
  }
  assert_int_equal(
      carom_world_write(b.world, CAROM_FIELD_FORCE, CAROM_SCALAR_F64, handles, BENCH_BODIES, forces, 0, NULL),
      CAROM_OK);
  assert_int_equal(bench_steps(b.world, 300, NULL), CAROM_OK);
  hash = bench_hash(b.world);
  assert_int_equal(bench_free(&b), CAROM_OK);
  return hash;
}

static void the_order_of_a_hosts_handles_does_not_matter(void** state) {
  (void)state;
  assert_true(bits_of_a_night(0) == bits_of_a_night(0));
  assert_true(bits_of_a_night(0) == bits_of_a_night(1));
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(a_new_world_does_not_sleep),
      cmocka_unit_test(the_report_counts_who_falls_asleep_and_wakes),
      cmocka_unit_test(the_ground_never_sleeps_and_may_be_woken),
      cmocka_unit_test(stays_awake_is_kept_told_and_heeded),
      cmocka_unit_test(the_order_of_a_hosts_handles_does_not_matter),
  };
  return cmocka_run_group_tests_name("abi/sleep", tests, NULL, NULL);
}
