/* Hulls of shapes at the boundary: what is taken, kept, refused; worlds of them as snapshots, forks and recordings. */
#define _GNU_SOURCE
#include <stdlib.h>

#include "bench.h"
#include "carom_test.h"

/* A dumb-bell of the bench's ball at two places and its crate between them, rounded. */
static int32_t bell(Bench* b, carom_shape* shape, carom_error* e) {
  const carom_shape parts[3] = {b->ball, b->crate, b->ball};
  const double at[9] = {0, -1, 0, 0, 0, 0, 0, 1, 0}, turn[12] = {0, 0, 0, 1, 0, 0.6, 0, 0.8, 0, 0, 0, 1};
  const double scale[9] = {0.5, 0.5, 0.5, 1, -2, 1, 1, 1, 1};
  return carom_shape_create_hull_of(b->engine, parts, 3, at, turn, scale, 0.0625, shape, e);
}

static void it_says_what_it_is_made_of_and_keeps_it(void** state) {
  Bench b;
  carom_shape shape = 0, parts[3] = {0, 0, 0}, plain = 0;
  carom_shape_info info;
  double at[9], turn[12], scale[9], radius = 0;
  uint64_t count = 3;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(bell(&b, &shape, NULL), CAROM_OK);
  assert_int_equal(carom_shape_get_parts(b.engine, shape, parts, at, turn, scale, &count, &radius, NULL), CAROM_OK);
  assert_true(count == 3 && parts[0] == b.ball && parts[1] == b.crate && parts[2] == b.ball && radius == 0.0625);
  assert_true(at[1] == -1 && at[7] == 1 && turn[5] == 0.6 && turn[11] == 1 && scale[4] == -2 && scale[0] == 0.5);
  info.struct_size = sizeof info;
  assert_int_equal(carom_shape_get_info(b.engine, shape, &info, NULL), CAROM_OK);
  assert_true(info.form == CAROM_FORM_NONE && info.plugin == CAROM_NULL_HANDLE && !info.is_half_space &&
              !info.is_scenery);
  assert_true(info.param_count == 0 && fabs(info.aabb_min[1] + 1.3125) < 1e-12 &&
              fabs(info.aabb_max[1] - 1.5625) < 1e-12);
  assert_true(info.volume_min > 0 && info.volume_max - info.volume_min < 2e-3 * info.volume);

  count = 0;
  assert_int_equal(carom_shape_get_parts(b.engine, shape, NULL, NULL, NULL, NULL, &count, NULL, NULL), CAROM_OK);
  assert_int_equal(count, 3);
  count = 2;
  assert_int_equal(carom_shape_get_parts(b.engine, shape, parts, NULL, NULL, NULL, &count, NULL, NULL),
                   CAROM_E_BUFFER_TOO_SMALL);
  assert_int_equal(count, 3);
  assert_int_equal(carom_shape_get_parts(b.engine, b.floor, parts, NULL, NULL, NULL, &count, &radius, NULL), CAROM_OK);
  assert_true(count == 0 && radius == 0);

  /* A part stays as long as the hull does. */
  {
    const double r = 0.75;
    assert_int_equal(carom_shape_create(b.engine, b.sphere, &r, 1, &plain, NULL), CAROM_OK);
  }
  carom_shape around = 0;
  assert_int_equal(carom_shape_create_hull_of(b.engine, &plain, 1, NULL, NULL, NULL, 0, &around, NULL), CAROM_OK);
  assert_int_equal(carom_shape_destroy(b.engine, plain, NULL), CAROM_E_IN_USE);
  assert_int_equal(carom_shape_destroy(b.engine, around, NULL), CAROM_OK);
  assert_int_equal(carom_shape_destroy(b.engine, plain, NULL), CAROM_OK);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

#define REFUSED(code, where, call) \
  (assert_int_equal(call, code), assert_int_equal(e.argument, where), assert_true(e.remedy[0] && other == 7))

static void what_makes_no_hull_is_refused(void** state) {
  Bench b;
  carom_error e = CAROM_ERROR_INIT;
  carom_shape other = 7, deep = 0, next = 0, parts[2], many[65];
  const double nan3[6] = {0, 0, 0, 0, 0, NAN}, far[3] = {0, 2e8, 0}, bad_turn[4] = {0, 0, 0, 2}, flat[3] = {1, 0, 1};
  int i;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  parts[0] = b.ball, parts[1] = b.floor;
  REFUSED(CAROM_E_NULL_ARGUMENT, 1, carom_shape_create_hull_of(NULL, parts, 1, NULL, NULL, NULL, 0, &other, &e));
  REFUSED(CAROM_E_NULL_ARGUMENT, 2, carom_shape_create_hull_of(b.engine, NULL, 1, NULL, NULL, NULL, 0, &other, &e));
  REFUSED(CAROM_E_NULL_ARGUMENT, 8, carom_shape_create_hull_of(b.engine, parts, 1, NULL, NULL, NULL, 0, NULL, &e));
  REFUSED(CAROM_E_OUT_OF_RANGE, 3, carom_shape_create_hull_of(b.engine, parts, 0, NULL, NULL, NULL, 0, &other, &e));
  REFUSED(CAROM_E_OUT_OF_RANGE, 3, carom_shape_create_hull_of(b.engine, parts, 4097, NULL, NULL, NULL, 0, &other, &e));
  REFUSED(CAROM_E_UNSUPPORTED, 2, carom_shape_create_hull_of(b.engine, parts, 2, NULL, NULL, NULL, 0, &other, &e));
  REFUSED(CAROM_E_OUT_OF_RANGE, 4, carom_shape_create_hull_of(b.engine, parts, 1, far, NULL, NULL, 0, &other, &e));
  REFUSED(CAROM_E_NOT_UNIT, 5, carom_shape_create_hull_of(b.engine, parts, 1, NULL, bad_turn, NULL, 0, &other, &e));
  REFUSED(CAROM_E_OUT_OF_RANGE, 6, carom_shape_create_hull_of(b.engine, parts, 1, NULL, NULL, flat, 0, &other, &e));
  REFUSED(CAROM_E_OUT_OF_RANGE, 7, carom_shape_create_hull_of(b.engine, parts, 1, NULL, NULL, NULL, -1, &other, &e));
  REFUSED(CAROM_E_NOT_FINITE, 7, carom_shape_create_hull_of(b.engine, parts, 1, NULL, NULL, NULL, NAN, &other, &e));
  parts[1] = b.ball;
  REFUSED(CAROM_E_NOT_FINITE, 4, carom_shape_create_hull_of(b.engine, parts, 2, nan3, NULL, NULL, 0, &other, &e));
  parts[1] = 12345;
  REFUSED(CAROM_E_INVALID_HANDLE, 2, carom_shape_create_hull_of(b.engine, parts, 2, NULL, NULL, NULL, 0, &other, &e));
  assert_int_equal(carom_shape_destroy(b.engine, b.ball, NULL), CAROM_E_IN_USE); /* by colliders alone, as before */

  deep = b.ball;
  for (i = 0; i < 8; ++i) {
    assert_int_equal(carom_shape_create_hull_of(b.engine, &deep, 1, NULL, NULL, NULL, 0.125, &next, &e), CAROM_OK);
    deep = next;
  }
  REFUSED(CAROM_E_LIMIT, 2, carom_shape_create_hull_of(b.engine, &deep, 1, NULL, NULL, NULL, 0, &other, &e));
  for (i = 0; i < 65; ++i) many[i] = b.ball;
  assert_int_equal(carom_shape_create_hull_of(b.engine, many, 64, NULL, NULL, NULL, 0, &next, &e), CAROM_OK);
  for (i = 0; i < 65; ++i) many[i] = next;
  assert_int_equal(carom_shape_create_hull_of(b.engine, many, 64, NULL, NULL, NULL, 0, &deep, &e), CAROM_OK);
  REFUSED(CAROM_E_LIMIT, 2, carom_shape_create_hull_of(b.engine, many, 65, NULL, NULL, NULL, 0, &other, &e));
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static carom_world* world_of_bells(Bench* b, carom_body* body) {
  carom_shape shape = 0, sweep = 0;
  carom_collider collider;
  const double at[6] = {-0.5, 0, 0, 0.5, 0.25, 0};
  const carom_shape twice[2] = {b->crate, b->crate};
  assert_int_equal(bell(b, &shape, NULL), CAROM_OK);
  assert_int_equal(carom_shape_create_hull_of(b->engine, twice, 2, at, NULL, NULL, 0, &sweep, NULL), CAROM_OK);
  assert_int_equal(bench_body(b->world, shape, b->material, CAROM_BODY_DYNAMIC, 4, 3, 0, body, &collider, NULL),
                   CAROM_OK);
  assert_int_equal(bench_body(b->world, sweep, b->material, CAROM_BODY_DYNAMIC, 4, 5, 0.25, body, &collider, NULL),
                   CAROM_OK);
  return b->world;
}

static uint64_t hash_of(carom_world* world) {
  uint64_t hash = 0;
  assert_int_equal(carom_world_hash(world, &hash, NULL), CAROM_OK);
  return hash;
}

/* A whole snapshot makes hulls and their parts anew in an engine that has only the plugins. */
static void snapshots_forks_and_restores_know_them(void** state) {
  Bench b, c;
  carom_body body;
  carom_world *fork = NULL, *built = NULL;
  uint64_t size = 0;
  void* bytes;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  world_of_bells(&b, &body);
  assert_int_equal(bench_steps(b.world, 60, NULL), CAROM_OK);
  assert_int_equal(carom_world_save(b.world, CAROM_SNAPSHOT_WHOLE, NULL, 0, &size, NULL), CAROM_OK);
  bytes = malloc(size);
  assert_int_equal(carom_world_save(b.world, CAROM_SNAPSHOT_WHOLE, bytes, size, &size, NULL), CAROM_OK);
  assert_int_equal(carom_world_fork(b.world, &fork, NULL), CAROM_OK);

  memset(&c, 0, sizeof c);
  assert_int_equal(carom_engine_create(NULL, &c.engine, NULL), CAROM_OK);
  assert_int_equal(carom_world_create(c.engine, NULL, &built, NULL), CAROM_OK);
  assert_int_equal(carom_world_restore(built, bytes, size, NULL), CAROM_E_NOT_FOUND); /* no plugin yet */
  assert_int_equal(carom_world_destroy(built, NULL), CAROM_OK);
  assert_int_equal(carom_plugin_register(c.engine, &b.sphere_plugin, &c.sphere, NULL), CAROM_OK);
  assert_int_equal(carom_plugin_register(c.engine, &b.box_plugin, &c.box, NULL), CAROM_OK);
  assert_int_equal(carom_world_create(c.engine, NULL, &built, NULL), CAROM_OK);
  assert_int_equal(carom_world_restore(built, bytes, size, NULL), CAROM_OK);

  assert_int_equal(bench_steps(b.world, 200, NULL), CAROM_OK);
  assert_int_equal(bench_steps(fork, 200, NULL), CAROM_OK);
  assert_int_equal(bench_steps(built, 200, NULL), CAROM_OK);
  assert_true(hash_of(b.world) == hash_of(fork) && hash_of(b.world) == hash_of(built));
  assert_int_equal(carom_world_restore(b.world, bytes, size, NULL), CAROM_OK); /* where it came from: the same shapes */
  assert_int_equal(bench_steps(b.world, 200, NULL), CAROM_OK);
  assert_true(hash_of(b.world) == hash_of(built));
  free(bytes);
  assert_int_equal(carom_world_destroy(fork, NULL), CAROM_OK);
  assert_int_equal(carom_world_destroy(built, NULL), CAROM_OK);
  assert_int_equal(carom_engine_destroy(c.engine, NULL), CAROM_OK);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/* Bytes that are damaged anywhere are refused, or mean a world; nothing is left behind in the engine either way. */
static void damaged_bytes_make_no_hull(void** state) {
  Bench b;
  carom_body body;
  uint64_t size = 0, at;
  unsigned char* bytes;
  int refused = 0;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  world_of_bells(&b, &body);
  assert_int_equal(carom_world_save(b.world, CAROM_SNAPSHOT_WHOLE, NULL, 0, &size, NULL), CAROM_OK);
  bytes = malloc(size);
  assert_int_equal(carom_world_save(b.world, CAROM_SNAPSHOT_WHOLE, bytes, size, &size, NULL), CAROM_OK);
  for (at = 0; at < size; at += 3) {
    carom_world* built = NULL;
    int32_t result;
    bytes[at] ^= 0x41;
    assert_int_equal(carom_world_create(b.engine, NULL, &built, NULL), CAROM_OK);
    result = carom_world_restore(built, bytes, size, NULL);
    refused += result != CAROM_OK;
    assert_int_equal(carom_world_destroy(built, NULL), CAROM_OK);
    bytes[at] ^= 0x41;
  }
  assert_true(refused > 0);
  free(bytes);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/* It rests where it should: a tapered capsule on its side leans on two circles, the bell on its crate. */
static void they_rest(void** state) {
  Bench b;
  carom_body body;
  carom_shape cone_like = 0;
  carom_collider collider;
  double x[3], small;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  small = 0.25;
  carom_shape little = 0;
  assert_int_equal(carom_shape_create(b.engine, b.sphere, &small, 1, &little, NULL), CAROM_OK);
  {
    const carom_shape parts[2] = {b.ball, little};
    const double at[6] = {-0.5, 0, 0, 0.75, 0, 0};
    assert_int_equal(carom_shape_create_hull_of(b.engine, parts, 2, at, NULL, NULL, 0, &cone_like, NULL), CAROM_OK);
  }
  assert_int_equal(bench_body(b.world, cone_like, b.material, CAROM_BODY_DYNAMIC, 6, 0.75, 0, &body, &collider, NULL),
                   CAROM_OK);
  assert_int_equal(bench_steps(b.world, 64 * 20, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_pose(b.world, body, x, NULL, NULL), CAROM_OK);
  /* Both balls touch the floor, their centres at 0.5 and 0.25, 1.25 apart; the origin lies 0.5 from the larger one's. */
  assert_true(fabs(x[1] - (0.5 - 0.5 / 1.25 * 0.25)) < 2e-3);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/* The plugin and the hull of two balls are one set. */
static void a_tapered_capsule_is_the_hull_of_two_balls(void** state) {
  static const double sizes[][3] = {{0.5, 0.25, 1}, {0, 0.5, 0.75}, {0.5, 0.5, 0.25}, {1, 0.1, 0.5}};
  carom_engine* engine = NULL;
  size_t i;
  (void)state;
  setenv("CAROM_PLUGIN_PATH", CAROM_PLUGIN_DIR, 1);
  assert_int_equal(carom_engine_create(NULL, &engine, NULL), CAROM_OK);
  for (i = 0; i < sizeof sizes / sizeof sizes[0]; ++i) {
    const double least = 1e-9, at[6] = {0, -sizes[i][2], 0, 0, sizes[i][2], 0};
    carom_shape balls[2], shape[2];
    carom_shape_info info[2];
    int k;
    for (k = 0; k < 2; ++k)
      assert_int_equal(
          carom_shape_create_named(engine, "sphere", sizes[i][k] > 0 ? &sizes[i][k] : &least, 1, &balls[k], NULL),
          CAROM_OK);
    assert_int_equal(carom_shape_create_named(engine, "tapered_capsule", sizes[i], 3, &shape[0], NULL), CAROM_OK);
    assert_int_equal(carom_shape_create_hull_of(engine, balls, 2, at, NULL, NULL, 0, &shape[1], NULL), CAROM_OK);
    for (k = 0; k < 200; ++k) {
      const double d[3] = {cos(k), sin(7 * k), sin(3 * k)};
      double p[2][3];
      assert_int_equal(carom_shape_support(engine, shape[0], d, 1, p[0], NULL), CAROM_OK);
      assert_int_equal(carom_shape_support(engine, shape[1], d, 1, p[1], NULL), CAROM_OK);
      assert_true(fabs(d[0] * (p[0][0] - p[1][0]) + d[1] * (p[0][1] - p[1][1]) + d[2] * (p[0][2] - p[1][2])) < 3e-9);
    }
    for (k = 0; k < 2; ++k) {
      info[k].struct_size = sizeof info[k];
      assert_int_equal(carom_shape_get_info(engine, shape[k], &info[k], NULL), CAROM_OK);
    }
    assert_true(info[0].volume_min <= info[1].volume_max && info[1].volume_min <= info[0].volume_max);
  }
  {
    const double none[3] = {0, 0, 1};
    carom_shape shape = 7;
    assert_int_equal(carom_shape_create_named(engine, "tapered_capsule", none, 3, &shape, NULL), CAROM_E_OUT_OF_RANGE);
    assert_int_equal(shape, 7);
  }
  assert_int_equal(carom_engine_destroy(engine, NULL), CAROM_OK);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(it_says_what_it_is_made_of_and_keeps_it),
      cmocka_unit_test(what_makes_no_hull_is_refused),
      cmocka_unit_test(snapshots_forks_and_restores_know_them),
      cmocka_unit_test(damaged_bytes_make_no_hull),
      cmocka_unit_test(they_rest),
      cmocka_unit_test(a_tapered_capsule_is_the_hull_of_two_balls),
  };
  return cmocka_run_group_tests_name("abi/hull_of", tests, NULL, NULL);
}
