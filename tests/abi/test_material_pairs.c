/* What two materials are to each other where a host says so, and not as they mix. */
#include <math.h>
#include <stdlib.h>

#include "bench.h"
#include "carom_test.h"

static carom_material made(carom_world* world, double friction) {
  carom_material_desc desc;
  carom_material material = 0;
  carom_material_desc_init(&desc, sizeof desc);
  desc.friction = friction;
  desc.friction_mix = CAROM_MIX_MAXIMUM;
  assert_int_equal(carom_material_create(world, &desc, &material, NULL), CAROM_OK);
  return material;
}

static void expect(carom_world* world, carom_material one, carom_material other, double friction, double spinning) {
  double surface[4] = {-1, -1, -1, -1};
  assert_int_equal(carom_material_get_pair(world, one, other, surface, NULL), CAROM_OK);
  assert_true(surface[0] == friction && surface[1] == 0 && surface[2] == 0 && surface[3] == spinning);
}

static void a_pair_is_said_in_any_order_and_taken_back(void** state) {
  const double said[4] = {0.125, 0, 0, 0.25}, anew[4] = {0.5, 0, 0, 0};
  Bench b;
  carom_material one, other, third;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  one = made(b.world, 0.75), other = made(b.world, 0.25), third = made(b.world, 0.5);
  expect(b.world, one, other, 0.75, 0);
  assert_int_equal(carom_material_set_pair(b.world, other, one, said, NULL), CAROM_OK);
  assert_int_equal(carom_material_set_pair(b.world, third, third, anew, NULL), CAROM_OK);
  expect(b.world, one, other, 0.125, 0.25);
  expect(b.world, other, one, 0.125, 0.25);
  expect(b.world, one, third, 0.75, 0);
  assert_int_equal(carom_material_set_pair(b.world, one, other, anew, NULL), CAROM_OK);
  expect(b.world, one, other, 0.5, 0);
  assert_int_equal(carom_material_set_pair(b.world, one, other, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_material_set_pair(b.world, one, other, NULL, NULL), CAROM_OK);
  expect(b.world, one, other, 0.75, 0);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void it_ends_with_either_material(void** state) {
  const double said[4] = {0.125, 0, 0, 0};
  Bench b;
  carom_material one, other;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  one = made(b.world, 0.75), other = made(b.world, 0.25);
  assert_int_equal(carom_material_set_pair(b.world, one, other, said, NULL), CAROM_OK);
  assert_int_equal(carom_material_destroy(b.world, other, NULL), CAROM_OK);
  other = made(b.world, 0.25); /* in the same slot */
  expect(b.world, one, other, 0.75, 0);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/* A box is pushed along a floor: friction is that of the pair. m/s after one second, from 4: 4 - friction g. */
static double speed_after_a_second(double friction, int saves) {
  const double half[3] = {0.5, 0.5, 0.5}, up[4] = {0, 1, 0, 0}, origin[3] = {0, 0, 0}, above[3] = {0, 0.5, 0};
  const double said[4] = {friction, 0, 0, 0}, push[3] = {4, 0, 0};
  Bench b;
  carom_world* world;
  carom_shape box, floor;
  carom_body ground, body;
  carom_collider_desc wear;
  carom_collider collider;
  carom_material one, other;
  double velocity[3];
  int i;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_world_create(b.engine, NULL, &world, NULL), CAROM_OK);
  one = made(world, 0.9), other = made(world, 0.8);
  assert_int_equal(carom_shape_create_named(b.engine, "carom.box", half, 3, &box, NULL), CAROM_OK);
  assert_int_equal(carom_shape_create_half_space(b.engine, up, 0, &floor, NULL), CAROM_OK);
  for (i = 0; i < 2; ++i) {
    carom_body_desc desc;
    carom_body_desc_init(&desc, sizeof desc);
    desc.type = i ? CAROM_BODY_DYNAMIC : CAROM_BODY_STATIC;
    desc.position[0] = 1000, desc.position[1] = i ? above[1] : origin[1];
    assert_int_equal(carom_body_create(world, &desc, i ? &body : &ground, NULL), CAROM_OK);
    carom_collider_desc_init(&wear, sizeof wear);
    wear.shape = i ? box : floor;
    wear.material = i ? one : other;
    assert_int_equal(carom_collider_create(world, i ? body : ground, &wear, &collider, NULL), CAROM_OK);
  }
  assert_int_equal(carom_material_set_pair(world, one, other, said, NULL), CAROM_OK);
  if (saves) {
    uint64_t size = 0;
    void* bytes;
    (void)carom_world_save(world, CAROM_SNAPSHOT_STATE, NULL, 0, &size, NULL);
    bytes = malloc(size);
    assert_int_equal(carom_world_save(world, CAROM_SNAPSHOT_STATE, bytes, size, &size, NULL), CAROM_OK);
    assert_int_equal(carom_material_set_pair(world, one, other, NULL, NULL), CAROM_OK);
    expect(world, one, other, 0.9, 0);
    assert_int_equal(carom_world_restore(world, bytes, size, NULL), CAROM_OK);
    expect(world, one, other, friction, 0);
    free(bytes);
  }
  assert_int_equal(carom_body_set_velocity(world, body, push, origin, NULL), CAROM_OK);
  assert_int_equal(bench_steps(world, 64, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_velocity(world, body, velocity, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_world_destroy(world, NULL), CAROM_OK);
  assert_int_equal(bench_free(&b), CAROM_OK);
  return velocity[0];
}

static void what_is_said_is_felt(void** state) {
  (void)state;
  assert_true(fabs(speed_after_a_second(0, 0) - 4) < 1e-9);
  assert_true(fabs(speed_after_a_second(0.125, 0) - (4 - 0.125 * 9.81)) < 1e-3);
  assert_true(fabs(speed_after_a_second(0.3, 0) - (4 - 0.3 * 9.81)) < 1e-3);
}

static void a_snapshot_has_it(void** state) {
  (void)state;
  assert_true(speed_after_a_second(0.125, 1) == speed_after_a_second(0.125, 0));
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(a_pair_is_said_in_any_order_and_taken_back),
      cmocka_unit_test(it_ends_with_either_material),
      cmocka_unit_test(what_is_said_is_felt),
      cmocka_unit_test(a_snapshot_has_it),
  };
  return cmocka_run_group_tests_name("abi/material_pairs", tests, NULL, NULL);
}
