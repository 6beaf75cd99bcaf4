/* Contact groups as a host reads them, and how solver auto answered each. */
#include "bench.h"
#include "carom_test.h"

static void groups_are_those_of_the_report(void** state) {
  Bench b;
  carom_group groups[16];
  carom_step_report report = {0};
  uint64_t count = 0, points = 0, i;
  (void)state;
  report.struct_size = sizeof report;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SOLVER, CAROM_SOLVER_AUTO, NULL), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SUBSTEPS, 4, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 120, NULL), CAROM_OK);
  assert_int_equal(carom_world_get_report(b.world, &report, NULL), CAROM_OK);
  assert_int_equal(carom_world_get_groups(b.world, groups, sizeof *groups, 16, &count, NULL), CAROM_OK);
  assert_true(count > 0 && count <= 16 && count == report.groups);
  for (i = 0; i < count; ++i) {
    points += groups[i].points;
    assert_true(groups[i].bodies > 0 && groups[i].body != CAROM_NULL_HANDLE);
    assert_true(groups[i].solver == CAROM_SOLVER_SOFT_STEP || groups[i].solver == CAROM_SOLVER_DIRECT);
    assert_true(groups[i].reason <= CAROM_REASON_FEW && groups[i].mass_ratio >= 1 && groups[i].sink >= 0);
  }
  assert_true(points == report.contact_points);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void other_solvers_have_none(void** state) {
  Bench b;
  uint64_t count = 99;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SOLVER, CAROM_SOLVER_SOFT_STEP, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 120, NULL), CAROM_OK);
  assert_int_equal(carom_world_get_groups(b.world, NULL, sizeof(carom_group), 0, &count, NULL), CAROM_OK);
  assert_true(count == 0);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(groups_are_those_of_the_report),
      cmocka_unit_test(other_solvers_have_none),
  };
  return cmocka_run_group_tests_name("abi/groups", tests, NULL, NULL);
}
