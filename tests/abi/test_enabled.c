/* Bodies that a host takes out of steps, and back in. */
#include <stdlib.h>

#include "bench.h"
#include "carom_test.h"

static double height(Bench* b, carom_body body) {
  double at[3];
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, &body, 1, at, 0, NULL), CAROM_OK);
  return at[1];
}

static void step(Bench* b, int steps) {
  while (steps-- > 0) assert_int_equal(carom_world_step(b->world, 1.0 / 120, NULL), CAROM_OK);
}

static void enable(Bench* b, carom_body body, uint32_t on) {
  uint32_t now = 9;
  assert_int_equal(carom_body_set_enabled(b->world, body, on, NULL), CAROM_OK);
  assert_int_equal(carom_body_is_enabled(b->world, body, &now, NULL), CAROM_OK);
  assert_int_equal(now, on);
}

static uint32_t sleeps(Bench* b, carom_body body) {
  uint32_t asleep = 9;
  assert_int_equal(carom_body_is_asleep(b->world, body, &asleep, NULL), CAROM_OK);
  return asleep;
}

static uint64_t hash(Bench* b) {
  uint64_t h;
  assert_int_equal(carom_world_hash(b->world, &h, NULL), CAROM_OK);
  return h;
}

/* What a ray straight down meets at x, z. */
static carom_body under(Bench* b, double x, double z) {
  const double from[3] = {x, 20, z}, down[3] = {0, -1, 0};
  carom_world_hit hit;
  assert_int_equal(carom_world_cast_ray(b->world, from, down, 100, NULL, &hit, sizeof hit, NULL), CAROM_OK);
  return hit.body;
}

static void a_disabled_body_keeps_its_pose_and_velocity(void** state) {
  const double up[3] = {1, 2, 3}, still[3] = {0, 0, 0};
  double v[3];
  Bench b;
  double before;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_velocity(b.world, b.bodies[2], up, still, NULL), CAROM_OK);
  enable(&b, b.bodies[2], 0);
  before = height(&b, b.bodies[2]);
  step(&b, 200);
  assert_true(height(&b, b.bodies[2]) == before);
  assert_true(height(&b, b.bodies[0]) < 0.6); /* the others fell */
  assert_int_equal(
      carom_world_read(b.world, CAROM_FIELD_LINEAR_VELOCITY, CAROM_SCALAR_F64, &b.bodies[2], 1, v, 0, NULL), CAROM_OK);
  assert_true(v[0] == 1 && v[1] == 2 && v[2] == 3);
  enable(&b, b.bodies[2], 1);
  step(&b, 1);
  assert_true(height(&b, b.bodies[2]) > before); /* it goes on with its velocity */
  step(&b, 600);
  assert_true(height(&b, b.bodies[2]) < 0.6 && height(&b, b.bodies[2]) > 0.49); /* and touches again */
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void nothing_touches_it_and_no_query_finds_it(void** state) {
  Bench b;
  carom_body falling;
  carom_collider collider;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  step(&b, 400);
  assert_int_equal(
      bench_body(b.world, b.ball, CAROM_NULL_HANDLE, CAROM_BODY_STATIC, 9, 3, 0, &falling, &collider, NULL), CAROM_OK);
  assert_int_equal(
      bench_body(b.world, b.ball, CAROM_NULL_HANDLE, CAROM_BODY_DYNAMIC, 9, 4.5, 0, &b.bodies[0], &collider, NULL),
      CAROM_OK);
  step(&b, 60);
  assert_true(under(&b, 9, 0) == b.bodies[0]);
  enable(&b, b.bodies[0], 0);
  assert_true(under(&b, 9, 0) == falling);
  enable(&b, falling, 0);
  assert_true(under(&b, 9, 0) == b.ground);
  enable(&b, b.bodies[0], 1);
  step(&b, 300);
  assert_true(height(&b, b.bodies[0]) < 0.6); /* through what is disabled, onto the floor */
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void what_slept_on_it_wakes_and_falls(void** state) {
  const double half[3] = {2, 0.1, 2};
  Bench b;
  carom_shape slab;
  carom_body shelf, crate;
  carom_collider collider;
  int kind;
  (void)state;
  for (kind = 0; kind < 2; ++kind) { /* a static shelf, and one that is itself asleep on the floor */
    assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
    assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SLEEP, 1, NULL), CAROM_OK);
    assert_int_equal(carom_shape_create(b.engine, b.box, half, 3, &slab, NULL), CAROM_OK);
    assert_int_equal(bench_body(b.world, slab, CAROM_NULL_HANDLE, kind ? CAROM_BODY_DYNAMIC : CAROM_BODY_STATIC, 20,
                                0.1, 0, &shelf, &collider, NULL),
                     CAROM_OK);
    assert_int_equal(
        bench_body(b.world, b.crate, CAROM_NULL_HANDLE, CAROM_BODY_DYNAMIC, 20, 0.45, 0, &crate, &collider, NULL),
        CAROM_OK);
    step(&b, 480);
    assert_int_equal(sleeps(&b, crate), 1);
    assert_true(height(&b, crate) > 0.4);
    enable(&b, shelf, 0);
    assert_int_equal(sleeps(&b, shelf), 0);
    step(&b, 120);
    assert_true(height(&b, crate) < 0.26 && height(&b, crate) > 0.24);
    assert_true(fabs(height(&b, shelf) - 0.1) < 1e-3);
    assert_int_equal(bench_free(&b), CAROM_OK);
  }
}

static void joints_and_springs_of_it_hold_nothing(void** state) {
  carom_joint_desc hinge;
  carom_spring_desc spring;
  carom_joint joint;
  carom_spring pull;
  carom_body hung, sprung, post;
  carom_collider collider;
  Bench b;
  double high;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(bench_body(b.world, b.ball, CAROM_NULL_HANDLE, CAROM_BODY_DYNAMIC, 30, 8, 0, &hung, &collider, NULL),
                   CAROM_OK);
  assert_int_equal(
      bench_body(b.world, b.ball, CAROM_NULL_HANDLE, CAROM_BODY_DYNAMIC, 40, 8, 0, &sprung, &collider, NULL), CAROM_OK);
  assert_int_equal(
      bench_body(b.world, b.ball, CAROM_NULL_HANDLE, CAROM_BODY_KINEMATIC, 30, 10, 0, &post, &collider, NULL),
      CAROM_OK);
  carom_joint_desc_init(&hinge, sizeof hinge);
  hinge.kind = CAROM_JOINT_BALL, hinge.body_a = post, hinge.body_b = hung, hinge.fields = CAROM_JOINT_WORLD_FRAME;
  hinge.position_a[0] = 30, hinge.position_a[1] = 10;
  assert_int_equal(carom_joint_create(b.world, &hinge, &joint, NULL), CAROM_OK);
  carom_spring_desc_init(&spring, sizeof spring);
  spring.body_a = post, spring.body_b = sprung, spring.stiffness = 3000, spring.damping = 500, spring.rest = 10;
  assert_int_equal(carom_spring_create(b.world, &spring, &pull, NULL), CAROM_OK);
  step(&b, 30);
  high = height(&b, hung);
  assert_true(fabs(high - 8) < 1e-3);
  enable(&b, post, 0);
  step(&b, 240);
  assert_true(height(&b, hung) < 0.6 && height(&b, sprung) < 0.6);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void it_can_begin_disabled_and_a_descriptor_says_so(void** state) {
  carom_body_desc desc;
  carom_body body;
  Bench b;
  uint32_t on = 9;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  carom_body_desc_init(&desc, sizeof desc);
  desc.fields = CAROM_BODY_DISABLED, desc.position[1] = 50, desc.mass = 1, desc.fields |= CAROM_BODY_FIELD_MASS;
  assert_int_equal(carom_body_create(b.world, &desc, &body, NULL), CAROM_OK);
  step(&b, 20);
  assert_true(height(&b, body) == 50);
  assert_int_equal(carom_body_get(b.world, body, &desc, NULL), CAROM_OK);
  assert_true(desc.fields & CAROM_BODY_DISABLED);
  enable(&b, body, 1);
  step(&b, 20);
  assert_true(height(&b, body) < 50);
  enable(&b, body, 0);
  assert_int_equal(carom_body_destroy(b.world, body, NULL), CAROM_OK);
  desc.fields = 0;
  carom_body_desc_init(&desc, sizeof desc);
  assert_int_equal(carom_body_create(b.world, &desc, &body, NULL), CAROM_OK); /* takes the slot, not that */
  assert_int_equal(carom_body_is_enabled(b.world, body, &on, NULL), CAROM_OK);
  assert_int_equal(on, 1);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/* A snapshot brings it back either way, and the world goes on to the bit. */
static void a_snapshot_knows(void** state) {
  Bench b;
  uint64_t size = 0, h[2];
  void* bytes;
  int way;
  (void)state;
  for (way = 0; way < 2; ++way) {
    assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
    step(&b, 50);
    enable(&b, b.bodies[1], way);
    step(&b, 50);
    assert_int_equal(carom_world_save(b.world, CAROM_SNAPSHOT_STATE, NULL, 0, &size, NULL), CAROM_OK);
    bytes = malloc(size);
    assert_int_equal(carom_world_save(b.world, CAROM_SNAPSHOT_STATE, bytes, size, &size, NULL), CAROM_OK);
    step(&b, 60);
    h[0] = hash(&b);
    enable(&b, b.bodies[1], !way);
    step(&b, 10);
    assert_true(hash(&b) != h[0]);
    assert_int_equal(carom_world_restore(b.world, bytes, size, NULL), CAROM_OK);
    step(&b, 60);
    h[1] = hash(&b);
    assert_true(h[0] == h[1]);
    free(bytes);
    assert_int_equal(bench_free(&b), CAROM_OK);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(a_disabled_body_keeps_its_pose_and_velocity),
      cmocka_unit_test(nothing_touches_it_and_no_query_finds_it),
      cmocka_unit_test(what_slept_on_it_wakes_and_falls),
      cmocka_unit_test(joints_and_springs_of_it_hold_nothing),
      cmocka_unit_test(it_can_begin_disabled_and_a_descriptor_says_so),
      cmocka_unit_test(a_snapshot_knows),
  };
  return cmocka_run_group_tests_name("abi/enabled", tests, NULL, NULL);
}
