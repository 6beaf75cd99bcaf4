/* Filters, sensors and events through the interface. */
#include <carom/events.h>
#include <carom/filter.h>

#include "bench.h"

#include "carom_test.h"

static void filters_are_set_read_and_obeyed(void **state) {
  Bench b;
  uint64_t category, mask, count, i, n;
  int32_t group;
  carom_contact contacts[64];
  int apart = 1;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_collider_get_filter(b.world, b.colliders[1], &category, &mask, &group, NULL), CAROM_OK);
  assert_true(category == CAROM_FILTER_CATEGORY && mask == CAROM_FILTER_MASK && group == 0);
  assert_int_equal(carom_collider_set_filter(b.world, b.colliders[1], 6, ~(uint64_t)1, -7, NULL), CAROM_OK);
  assert_int_equal(carom_collider_get_filter(b.world, b.colliders[1], &category, &mask, &group, NULL), CAROM_OK);
  assert_true(category == 6 && mask == ~(uint64_t)1 && group == -7);
  assert_int_equal(carom_body_set_filter(b.world, b.bodies[2], 1, 0, 0, NULL), CAROM_OK);
  assert_int_equal(carom_body_hold_apart(b.world, b.ground, b.bodies[3], 1, NULL), CAROM_OK);
  for (i = 0; i < 200; ++i) {
    assert_int_equal(carom_world_step(b.world, 1.0 / 64, NULL), CAROM_OK);
    assert_int_equal(carom_world_get_contacts(b.world, contacts, sizeof contacts[0], 64, &count, NULL), CAROM_OK);
    for (n = 0; n < count; ++n) apart &= contacts[n].body_a == b.ground && contacts[n].body_b == b.bodies[0];
  }
  assert_true(apart); /* the first alone lies on the floor */
  {
    double y[4][3];
    assert_int_equal(carom_world_read(b.world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, b.bodies, 4, y, 0, NULL), CAROM_OK);
    assert_true(y[0][1] > 0.49 && y[1][1] < -5 && y[2][1] < -5 && y[3][1] < -5);
  }
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void events_are_collected_counted_and_copied(void **state) {
  Bench b;
  carom_contact_event contacts[64], two[2];
  carom_sensor_event sensors[16];
  carom_sleep_event sleeps[16];
  uint64_t count;
  uint32_t is = 7;
  int i, begun = 0, hit = 0, ended = 0, entered = 0, asleep = 0, awake = 0;
  uint64_t k;
  carom_body door;
  carom_collider gate;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SLEEP, 1, NULL), CAROM_OK);
  assert_int_equal(bench_body(b.world, b.crate, 0, CAROM_BODY_STATIC, 0, 0.5, 0, &door, &gate, NULL), CAROM_OK);
  assert_int_equal(carom_collider_set_sensor(b.world, gate, 1, NULL), CAROM_OK);
  assert_int_equal(carom_collider_is_sensor(b.world, gate, &is, NULL), CAROM_OK);
  assert_int_equal(is, 1);
  assert_int_equal(bench_steps(b.world, 1, NULL), CAROM_OK);
  assert_int_equal(carom_world_get_contact_events(b.world, NULL, 0, 0, &count, NULL), CAROM_OK);
  assert_int_equal(count, 0);
  assert_int_equal(carom_world_collect_events(b.world, CAROM_EVENTS_CONTACT | CAROM_EVENTS_SENSOR | CAROM_EVENTS_SLEEP, 1,
                                              NULL), CAROM_OK);
  for (i = 0; i < 64 * 8; ++i) {
    assert_int_equal(carom_world_step(b.world, 1.0 / 64, NULL), CAROM_OK);
    assert_int_equal(carom_world_get_contact_events(b.world, contacts, sizeof contacts[0], 64, &count, NULL), CAROM_OK);
    for (k = 0; k < count; ++k) {
      assert_true(contacts[k].body_a != door && contacts[k].body_b != door);
      begun += contacts[k].kind == CAROM_CONTACT_BEGIN;
      ended += contacts[k].kind == CAROM_CONTACT_END;
      if (contacts[k].kind != CAROM_CONTACT_HIT) continue;
      ++hit;
      assert_true(contacts[k].approach_speed > 1 && contacts[k].impulse > 0);
    }
    if (count > 2) {
      uint64_t again;
      assert_int_equal(carom_world_get_contact_events(b.world, two, sizeof two[0], 2, &again, NULL), CAROM_OK);
      assert_true(again == count);
      assert_memory_equal(two, contacts, sizeof two);
    }
    assert_int_equal(carom_world_get_sensor_events(b.world, sensors, sizeof sensors[0], 16, &count, NULL), CAROM_OK);
    for (k = 0; k < count; ++k) {
      assert_true(sensors[k].sensor == gate && sensors[k].sensor_body == door);
      entered += sensors[k].kind == CAROM_SENSOR_ENTER;
    }
    assert_int_equal(carom_world_get_sleep_events(b.world, sleeps, sizeof sleeps[0], 16, &count, NULL), CAROM_OK);
    for (k = 0; k < count; ++k) {
      asleep += sleeps[k].kind == CAROM_SLEEP_ASLEEP;
      awake += sleeps[k].kind == CAROM_SLEEP_AWAKE;
    }
  }
  assert_true(begun >= 4 && hit >= 4 && entered >= 1);
  {
    carom_step_report report;
    report.struct_size = sizeof report;
    assert_int_equal(carom_world_get_report(b.world, &report, NULL), CAROM_OK);
    assert_true(report.asleep_bodies > 0 && (uint64_t)(asleep - awake) == report.asleep_bodies);
  }
  assert_true(begun >= ended + 4); /* each lies or rolls on something */
  assert_int_equal(carom_world_collect_events(b.world, 0, 0, NULL), CAROM_OK);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(filters_are_set_read_and_obeyed),
      cmocka_unit_test(events_are_collected_counted_and_copied),
  };
  return cmocka_run_group_tests_name("abi/events", tests, NULL, NULL);
}
