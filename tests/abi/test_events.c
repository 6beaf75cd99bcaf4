/* Filters, sensors and events through the interface. */
#include <carom/events.h>
#include <carom/filter.h>

#include "bench.h"
#include "carom_test.h"

static void filters_are_set_read_and_obeyed(void** state) {
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
  assert_int_equal(carom_body_ignore_collision(b.world, b.ground, b.bodies[3], 1, NULL), CAROM_OK);
  for (i = 0; i < 200; ++i) {
    assert_int_equal(carom_world_step(b.world, 1.0 / 64, NULL), CAROM_OK);
    assert_int_equal(carom_world_get_contacts(b.world, contacts, sizeof contacts[0], 64, &count, NULL), CAROM_OK);
    for (n = 0; n < count; ++n) apart &= contacts[n].body_a == b.ground && contacts[n].body_b == b.bodies[0];
  }
  assert_true(apart); /* the first alone lies on the floor */
  {
    double y[4][3];
    assert_int_equal(carom_world_read(b.world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, b.bodies, 4, y, 0, NULL),
                     CAROM_OK);
    assert_true(y[0][1] > 0.49 && y[1][1] < -5 && y[2][1] < -5 && y[3][1] < -5);
  }
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void events_are_collected_counted_and_copied(void** state) {
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
  assert_int_equal(
      carom_world_collect_events(b.world, CAROM_EVENTS_CONTACT | CAROM_EVENTS_SENSOR | CAROM_EVENTS_SLEEP, 1, NULL),
      CAROM_OK);
  for (i = 0; i < 64 * 16; ++i) {
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
    assert_true(asleep > 0 &&
                (uint64_t)(asleep - awake) == report.asleep_bodies); /* balls roll on: who sleeps last is chance */
  }
  assert_true(begun >= ended + 4); /* each lies or rolls on something */
  assert_int_equal(carom_world_collect_events(b.world, 0, 0, NULL), CAROM_OK);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/* A weight on a rod that does not hold it, beside one on a rod that does. */
static void a_joint_that_breaks_is_told_once(void** state) {
  Bench b;
  carom_joint_desc d;
  carom_joint weak, strong;
  carom_joint_event events[4];
  carom_step_report report;
  carom_body_desc body;
  uint64_t count = 9, told = 0;
  int i;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_joint_desc_init(&d, sizeof d), CAROM_OK);
  memset(&body, 0, sizeof body);
  body.struct_size = sizeof body;
  assert_int_equal(carom_body_get(b.world, b.bodies[3], &body, NULL), CAROM_OK);
  d.kind = CAROM_JOINT_WELD, d.fields = CAROM_JOINT_WORLD_FRAME;
  d.body_b = b.bodies[3];
  for (i = 0; i < 3; ++i) d.position_a[i] = body.position[i];
  d.break_force = 0.9 * body.mass * 9.81;
  assert_int_equal(carom_joint_create(b.world, &d, &weak, NULL), CAROM_OK);
  d.body_b = b.bodies[2], d.position_a[0] = 1.5, d.position_a[1] = 2, d.position_a[2] = 0.25, d.break_force = 1e9;
  assert_int_equal(carom_joint_create(b.world, &d, &strong, NULL), CAROM_OK);
  assert_int_equal(carom_world_collect_events(b.world, CAROM_EVENTS_JOINT, 0, NULL), CAROM_OK);
  for (i = 0; i < 60; ++i) {
    assert_int_equal(carom_world_step(b.world, 1.0 / 64, NULL), CAROM_OK);
    assert_int_equal(carom_world_get_joint_events(b.world, events, sizeof events[0], 4, &count, NULL), CAROM_OK);
    if (count == 0) continue;
    ++told;
    report.struct_size = sizeof report;
    assert_int_equal(carom_world_get_report(b.world, &report, NULL), CAROM_OK);
    assert_true(count == 1 && events[0].joint == weak && events[0].step == report.steps);
    assert_true(events[0].body_a == CAROM_NULL_HANDLE && events[0].body_b == b.bodies[3]);
    /* What holds a body that rests bears its weight, upwards on it; nothing but that acts. */
    assert_true(fabs(events[0].force[1] - body.mass * 9.81) < 1e-6 * body.mass * 9.81);
    assert_true(fabs(events[0].force[0]) + fabs(events[0].force[2]) < 1e-6 * body.mass * 9.81);
    assert_true(fabs(events[0].torque[0]) + fabs(events[0].torque[1]) + fabs(events[0].torque[2]) < 1e-6 * body.mass);
  }
  assert_int_equal(told, 1);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void a_body_that_leaves_the_finite_world_is_told_once(void** state) {
  Bench b;
  carom_fault_event events[4];
  carom_fault faults[4];
  carom_step_report report;
  uint64_t count = 9, told = 0;
  int i, asked;
  (void)state;
  for (asked = 0; asked < 2; ++asked) {
    assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
    assert_int_equal(carom_world_collect_events(b.world, asked ? CAROM_EVENTS_FAULT : 0, 0, NULL), CAROM_OK);
    for (i = 0; i < 20; ++i) {
      if (i == 10) assert_int_equal(carom_body_set_gravity_factor(b.world, b.bodies[1], 1e300, NULL), CAROM_OK);
      assert_int_equal(carom_world_step(b.world, 1.0 / 64, NULL), CAROM_OK);
      assert_int_equal(carom_world_get_fault_events(b.world, events, sizeof events[0], 4, &count, NULL), CAROM_OK);
      assert_int_equal(count, asked && i == 10);
      told += count;
      if (count == 0) continue;
      report.struct_size = sizeof report;
      assert_int_equal(carom_world_get_report(b.world, &report, NULL), CAROM_OK);
      assert_int_equal(events[0].kind, CAROM_FAULT_BODY_STATE);
      assert_true(events[0].body == b.bodies[1] && events[0].shape == CAROM_NULL_HANDLE &&
                  events[0].particles == CAROM_NULL_HANDLE && events[0].step == report.steps);
      /* By then it may be gone: the list of faults forgets it, the event keeps its name. */
      assert_int_equal(carom_body_destroy(b.world, b.bodies[1], NULL), CAROM_OK);
      assert_int_equal(carom_world_get_faults(b.world, faults, sizeof faults[0], 4, &count, NULL), CAROM_OK);
      assert_int_equal(count, 0);
      assert_int_equal(carom_world_get_fault_events(b.world, events, sizeof events[0], 4, &count, NULL), CAROM_OK);
      assert_true(count == 1 && events[0].body == b.bodies[1]);
    }
    assert_int_equal(bench_free(&b), CAROM_OK);
  }
  assert_int_equal(told, 1);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(filters_are_set_read_and_obeyed),
      cmocka_unit_test(events_are_collected_counted_and_copied),
      cmocka_unit_test(a_joint_that_breaks_is_told_once),
      cmocka_unit_test(a_body_that_leaves_the_finite_world_is_told_once),
  };
  return cmocka_run_group_tests_name("abi/events", tests, NULL, NULL);
}
