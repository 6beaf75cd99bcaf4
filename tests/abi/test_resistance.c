/* Resistance of materials to rolling and spinning, as a host sets and reads it. */
#include "bench.h"
#include "carom_test.h"

static void it_is_nothing_until_it_is_set_and_outlives_an_update(void** state) {
  Bench b;
  carom_material_desc desc;
  double rolling = 1, spinning = 1;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_material_get_resistance(b.world, b.material, &rolling, &spinning, NULL), CAROM_OK);
  assert_true(rolling == 0 && spinning == 0);
  assert_int_equal(carom_material_set_resistance(b.world, b.material, 0.25, 0.125, NULL), CAROM_OK);
  carom_material_desc_init(&desc, sizeof desc);
  assert_int_equal(carom_material_update(b.world, b.material, &desc, NULL), CAROM_OK);
  assert_int_equal(carom_material_get_resistance(b.world, b.material, &rolling, &spinning, NULL), CAROM_OK);
  assert_true(rolling == 0.25 && spinning == 0.125);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/* Two worlds that differ in nothing else: once bodies touch, what resists goes another way, and what was set and taken
 * back does not. */
static void what_is_set_is_felt(void** state) {
  uint64_t hash[3];
  int i;
  (void)state;
  for (i = 0; i < 3; ++i) {
    Bench b;
    carom_collider_desc wear;
    assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
    carom_collider_desc_init(&wear, sizeof wear);
    if (i > 0) assert_int_equal(carom_material_set_resistance(b.world, b.material, 0.25, 0.125, NULL), CAROM_OK);
    if (i > 1) assert_int_equal(carom_material_set_resistance(b.world, b.material, 0, 0, NULL), CAROM_OK);
    wear.shape = b.floor;
    wear.material = b.material;
    assert_int_equal(carom_collider_destroy(b.world, b.ground_collider, NULL), CAROM_OK);
    assert_int_equal(carom_collider_create(b.world, b.ground, &wear, &b.ground_collider, NULL), CAROM_OK);
    assert_int_equal(bench_steps(b.world, 200, NULL), CAROM_OK);
    hash[i] = bench_hash(b.world);
    assert_int_equal(bench_free(&b), CAROM_OK);
  }
  assert_true(hash[0] != hash[1] && hash[0] == hash[2]);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(it_is_nothing_until_it_is_set_and_outlives_an_update),
      cmocka_unit_test(what_is_set_is_felt),
  };
  return cmocka_run_group_tests_name("abi/resistance", tests, NULL, NULL);
}
