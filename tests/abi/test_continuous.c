/* Bodies that are swept, as a host asks for it and reads of it. */
#include "bench.h"
#include "carom_test.h"

/* A plate of 2 mm at a height of 30 m, static. */
static carom_body plate(Bench* b) {
  const double half[3] = {3, 0.001, 3};
  carom_shape sheet;
  carom_body body;
  carom_body_desc desc;
  carom_collider_desc part;
  carom_collider collider;
  assert_int_equal(carom_shape_create(b->engine, b->box, half, 3, &sheet, NULL), CAROM_OK);
  carom_body_desc_init(&desc, sizeof desc);
  carom_collider_desc_init(&part, sizeof part);
  desc.type = CAROM_BODY_STATIC, desc.position[1] = 30;
  part.shape = sheet;
  assert_int_equal(carom_body_create(b->world, &desc, &body, NULL), CAROM_OK);
  assert_int_equal(carom_collider_create(b->world, body, &part, &collider, NULL), CAROM_OK);
  return body;
}

static double height(Bench* b, carom_body body) {
  double at[3];
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, &body, 1, at, 0, NULL), CAROM_OK);
  return at[1];
}

static void a_mode_is_kept_until_the_body_goes(void** state) {
  Bench b;
  uint32_t mode = 9;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_continuous(b.world, b.bodies[0], &mode, NULL), CAROM_OK);
  assert_int_equal(mode, CAROM_CONTINUOUS_AUTO);
  assert_int_equal(carom_body_set_continuous(b.world, b.bodies[0], CAROM_CONTINUOUS_ALWAYS, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_continuous(b.world, b.bodies[0], 3, NULL), CAROM_E_UNKNOWN_ENUM);
  assert_int_equal(carom_body_get_continuous(b.world, b.bodies[0], &mode, NULL), CAROM_OK);
  assert_int_equal(mode, CAROM_CONTINUOUS_ALWAYS);
  assert_int_equal(carom_body_get_continuous(b.world, b.bodies[1], &mode, NULL), CAROM_OK);
  assert_int_equal(mode, CAROM_CONTINUOUS_AUTO);
  assert_int_equal(carom_body_destroy(b.world, b.bodies[0], NULL), CAROM_OK);
  assert_int_equal(carom_body_set_continuous(b.world, b.bodies[0], 0, NULL), CAROM_E_STALE_HANDLE);
  {
    carom_body_desc desc;
    carom_body again;
    carom_body_desc_init(&desc, sizeof desc);
    assert_int_equal(carom_body_create(b.world, &desc, &again, NULL), CAROM_OK); /* takes the slot, not the mode */
    assert_int_equal(carom_body_get_continuous(b.world, again, &mode, NULL), CAROM_OK);
    assert_int_equal(mode, CAROM_CONTINUOUS_AUTO);
  }
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void what_is_swept_stops_and_is_counted(void** state) {
  static const struct {
    double dial;
    uint32_t mode;
    int stops;
  } cases[] = {{CAROM_SWEEP_FAST, CAROM_CONTINUOUS_AUTO, 1},
               {CAROM_SWEEP_FAST, CAROM_CONTINUOUS_NEVER, 0},
               {CAROM_SWEEP_FLAGGED, CAROM_CONTINUOUS_ALWAYS, 1},
               {CAROM_SWEEP_FLAGGED, CAROM_CONTINUOUS_AUTO, 0},
               {CAROM_SWEEP_NONE, CAROM_CONTINUOUS_ALWAYS, 0}};
  size_t i;
  (void)state;
  for (i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
    const double from[3] = {0, 40, 0}, upright[4] = {0, 0, 0, 1}, down[3] = {0, -400, 0}, still[3] = {0, 0, 0};
    Bench b;
    carom_step_report report;
    uint64_t swept = 0, hits = 0;
    int k;
    assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
    plate(&b);
    assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_CONTINUOUS, cases[i].dial, NULL), CAROM_OK);
    assert_int_equal(carom_body_set_continuous(b.world, b.bodies[0], cases[i].mode, NULL), CAROM_OK);
    assert_int_equal(carom_body_set_pose(b.world, b.bodies[0], from, upright, NULL), CAROM_OK);
    assert_int_equal(carom_body_set_velocity(b.world, b.bodies[0], down, still, NULL), CAROM_OK);
    for (k = 0; k < 3; ++k) {
      assert_int_equal(bench_steps(b.world, 1, NULL), CAROM_OK);
      report.struct_size = sizeof report;
      assert_int_equal(carom_world_get_report(b.world, &report, NULL), CAROM_OK);
      swept += report.swept_bodies, hits += report.sweep_hits;
    }
    assert_true((height(&b, b.bodies[0]) > 30) == cases[i].stops);
    assert_true(cases[i].stops ? swept > 0 && hits == 1 : swept == 0 && hits == 0);
    assert_int_equal(bench_free(&b), CAROM_OK);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(a_mode_is_kept_until_the_body_goes),
      cmocka_unit_test(what_is_swept_stops_and_is_counted),
  };
  return cmocka_run_group_tests_name("abi/continuous", tests, NULL, NULL);
}
