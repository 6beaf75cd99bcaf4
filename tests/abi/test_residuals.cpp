// Residuals and the budget as a host meets them.
#include <carom/carom.h>

#include <cmath>

#include "bench.h"
#include "carom_test.h"

namespace {

carom_residuals residuals_of(carom_world* world) {
  carom_residuals r = {};
  r.struct_size = sizeof r;
  assert_int_equal(carom_world_get_residuals(world, &r, nullptr), CAROM_OK);
  return r;
}

double substeps_of(carom_world* world) {
  double n = 0;
  assert_int_equal(carom_world_get_dial(world, CAROM_DIAL_SUBSTEPS, &n, nullptr), CAROM_OK);
  return n;
}

void residuals_agree_with_the_report_and_change_nothing(void**) {
  Bench b, twin;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  assert_int_equal(bench_make(&twin, nullptr, nullptr), CAROM_OK);
  for (int i = 0; i < 120; ++i) {
    assert_int_equal(bench_steps(b.world, 1, nullptr), CAROM_OK);
    assert_int_equal(bench_steps(twin.world, 1, nullptr), CAROM_OK);
    const carom_residuals r = residuals_of(b.world);
    carom_step_report report = {};
    report.struct_size = sizeof report;
    assert_int_equal(carom_world_get_report(b.world, &report, nullptr), CAROM_OK);
    assert_true(r.contact_points == report.contact_points && r.max_penetration == report.max_penetration);
    assert_true(std::isfinite(r.complementarity) && std::isfinite(r.energy));
    assert_true(r.complementarity >= 0 && r.cone >= 0 && r.slip >= 0);
    assert_true(r.energy_drift == 0 && r.ledger_is_kept == 0);
    assert_true(bench_hash(b.world) == bench_hash(twin.world));
  }
  assert_int_equal(carom_world_enable_ledger(b.world, 1, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 1, nullptr), CAROM_OK);
  assert_int_equal(residuals_of(b.world).ledger_is_kept, 1);
  assert_int_equal(bench_free(&b), CAROM_OK);
  assert_int_equal(bench_free(&twin), CAROM_OK);
}

void residuals_are_safe_after_edits(void**) {
  Bench b;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 60, nullptr), CAROM_OK);
  uint64_t count = 0;
  carom_body all[64];
  assert_int_equal(carom_world_get_bodies(b.world, all, 64, &count, nullptr), CAROM_OK);
  for (uint64_t i = 0; i < count && i < 64; ++i) {
    assert_int_equal(carom_body_destroy(b.world, all[i], nullptr), CAROM_OK);
    assert_true(std::isfinite(residuals_of(b.world).complementarity));
  }
  assert_true(residuals_of(b.world).energy == 0);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

void a_budget_drives_substeps_between_its_bounds(void**) {
  Bench b;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  double seconds = -1;
  uint32_t fewest = 9, most = 9;
  assert_int_equal(carom_world_get_budget(b.world, &seconds, &fewest, &most, nullptr), CAROM_OK);
  assert_true(seconds == 0 && fewest == 0 && most == 0);
  assert_int_equal(carom_world_set_budget(b.world, 10, 2, 7, nullptr), CAROM_OK);  // room for all
  assert_int_equal(bench_steps(b.world, 20, nullptr), CAROM_OK);
  assert_true(substeps_of(b.world) == 7);
  assert_int_equal(carom_world_set_budget(b.world, 1e-9, 2, 7, nullptr), CAROM_OK);  // for none
  assert_int_equal(bench_steps(b.world, 3, nullptr), CAROM_OK);
  assert_true(substeps_of(b.world) == 2);
  assert_int_equal(carom_world_get_budget(b.world, &seconds, &fewest, &most, nullptr), CAROM_OK);
  assert_true(seconds == 1e-9 && fewest == 2 && most == 7);
  assert_int_equal(carom_world_set_budget(b.world, 0, 0, 0, nullptr), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SUBSTEPS, 5, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 5, nullptr), CAROM_OK);
  assert_true(substeps_of(b.world) == 5);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(residuals_agree_with_the_report_and_change_nothing),
      cmocka_unit_test(residuals_are_safe_after_edits),
      cmocka_unit_test(a_budget_drives_substeps_between_its_bounds),
  };
  return cmocka_run_group_tests_name("abi/residuals", tests, nullptr, nullptr);
}
