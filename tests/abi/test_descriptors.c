/* Descriptors: they grow with the caller's size, and what they say is what the calls for one thing each would have
 * said. */
#include <stddef.h>

#include "bench.h"
#include "carom_test.h"

enum {
  kFirstBody = offsetof(carom_body_desc, gravity_factor),
  kFirstCollider = offsetof(carom_collider_desc, category)
};

static int make(void** state) {
  static Bench b;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  *state = &b;
  return 0;
}
static int clear(void** state) {
  assert_int_equal(bench_free(*state), CAROM_OK);
  return 0;
}
static uint64_t hash_of(carom_world* world) {
  uint64_t hash = 0;
  assert_int_equal(carom_world_hash(world, &hash, NULL), CAROM_OK);
  return hash;
}

static void an_older_struct_is_filled_to_its_end_and_no_further(void** state) {
  Bench* b = *state;
  union {
    carom_body_desc desc;
    unsigned char bytes[sizeof(carom_body_desc)];
  } older;
  carom_body_desc now;
  carom_body body;
  size_t i;
  memset(older.bytes, 0xAB, sizeof older.bytes);
  assert_int_equal(carom_body_desc_init(&older.desc, kFirstBody), CAROM_OK);
  assert_int_equal(older.desc.struct_size, kFirstBody);
  for (i = kFirstBody; i < sizeof older.bytes; ++i) assert_int_equal(older.bytes[i], 0xAB);
  assert_int_equal(carom_body_create(b->world, &older.desc, &body, NULL), CAROM_OK);
  now.struct_size = sizeof now;
  assert_int_equal(carom_body_get(b->world, body, &now, NULL), CAROM_OK);
  assert_true(now.gravity_factor == 1 && now.locks == 0 &&
              now.force_field_mask == 1); /* what it does not say is as usual */
}

static void of_a_newer_struct_the_rest_is_zero(void** state) {
  struct {
    carom_collider_desc known;
    uint64_t more[4];
  } newer;
  int i;
  (void)state;
  memset(&newer, 0xAB, sizeof newer);
  assert_int_equal(carom_collider_desc_init(&newer.known, sizeof newer), CAROM_OK);
  assert_int_equal(newer.known.struct_size, sizeof newer);
  assert_true(newer.known.density == 1000 && newer.known.mask == CAROM_FILTER_MASK);
  for (i = 0; i < 4; ++i) assert_true(newer.more[i] == 0);
}

static void a_size_of_no_version_is_refused_and_nothing_written(void** state) {
  static const uint32_t sizes[] = {0, 1, 4, 7, 9, 12, 4104, 0xCDCDCDCDu};
  union {
    carom_body_desc desc;
    unsigned char bytes[sizeof(carom_body_desc)];
  } d;
  size_t i, k;
  (void)state;
  for (i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
    memset(d.bytes, 0xAB, sizeof d.bytes);
    assert_int_equal(carom_body_desc_init(&d.desc, sizes[i]), CAROM_E_STRUCT_SIZE);
    for (k = 0; k < sizeof d.bytes; ++k) assert_int_equal(d.bytes[k], 0xAB);
  }
}

/* A body with all that can be said of one. */
static carom_body_desc whole_body(void) {
  carom_body_desc d;
  assert_int_equal(carom_body_desc_init(&d, sizeof d), CAROM_OK);
  d.position[1] = 3;
  d.angular_velocity[0] = 2;
  d.gravity_factor = 0.25;
  d.locks = CAROM_LOCK_LINEAR_Z;
  d.continuous = CAROM_CONTINUOUS_ALWAYS;
  d.linear_drag = 0.5, d.quadratic_drag = 0.125;
  d.force_field_mask = 6;
  d.magnetic_moment[0] = 1, d.magnetic_moment[1] = -2, d.magnetic_moment[2] = 3;
  d.user = 77;
  return d;
}
static carom_collider_desc whole_collider(carom_shape shape) {
  carom_collider_desc d;
  assert_int_equal(carom_collider_desc_init(&d, sizeof d), CAROM_OK);
  d.shape = shape;
  d.category = 4, d.mask = ~(uint64_t)2, d.group = -3, d.sensor = 1;
  d.surface_linear[0] = 0.5, d.surface_angular[1] = -0.25;
  return d;
}

static void one_call_says_what_many_say(void** state) {
  Bench* b = *state;
  carom_body_desc said = whole_body(), plain, back;
  carom_collider_desc part = whole_collider(b->crate), plain_part, part_back;
  const double moment[4] = {1, -2, 3, 0};
  carom_body one, other;
  carom_collider of_one, of_other;
  int i;
  assert_int_equal(carom_body_create(b->world, &said, &one, NULL), CAROM_OK);
  assert_int_equal(carom_collider_create(b->world, one, &part, &of_one, NULL), CAROM_OK);
  back.struct_size = sizeof back;
  assert_int_equal(carom_body_get(b->world, one, &back, NULL), CAROM_OK);
  assert_memory_equal(&back.gravity_factor, &said.gravity_factor, sizeof said - kFirstBody);
  assert_true(back.user == 77);
  part_back.struct_size = sizeof part_back;
  assert_int_equal(carom_collider_get(b->world, of_one, &part_back, &other, NULL), CAROM_OK);
  assert_memory_equal(&part_back.category, &part.category, sizeof part - kFirstCollider);

  /* The same, 20 m away, by a call for each: after 60 steps they have come the same way. */
  assert_int_equal(carom_body_desc_init(&plain, sizeof plain), CAROM_OK);
  plain.position[1] = 3, plain.position[0] = 20, plain.angular_velocity[0] = 2;
  assert_int_equal(carom_body_create(b->world, &plain, &other, NULL), CAROM_OK);
  assert_int_equal(carom_collider_desc_init(&plain_part, sizeof plain_part), CAROM_OK);
  plain_part.shape = b->crate;
  assert_int_equal(carom_collider_create(b->world, other, &plain_part, &of_other, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_gravity_factor(b->world, other, 0.25, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_locks(b->world, other, CAROM_LOCK_LINEAR_Z, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_continuous(b->world, other, CAROM_CONTINUOUS_ALWAYS, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_drag(b->world, other, 0.5, 0.125, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_force_field_mask(b->world, other, 6, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_attribute(b->world, other, CAROM_ATTRIBUTE_MAGNETIC_MOMENT, moment, NULL), CAROM_OK);
  assert_int_equal(carom_collider_set_filter(b->world, of_other, 4, ~(uint64_t)2, -3, NULL), CAROM_OK);
  assert_int_equal(carom_collider_set_sensor(b->world, of_other, 1, NULL), CAROM_OK);
  assert_int_equal(
      carom_collider_set_surface_velocity(b->world, of_other, part.surface_linear, part.surface_angular, NULL),
      CAROM_OK);
  assert_int_equal(bench_steps(b->world, 60, NULL), CAROM_OK);
  for (i = 0; i < 2; ++i) {
    double v[2][3], w[2][3];
    assert_int_equal(carom_body_get_velocity(b->world, one, v[0], w[0], NULL), CAROM_OK);
    assert_int_equal(carom_body_get_velocity(b->world, other, v[1], w[1], NULL), CAROM_OK);
    assert_memory_equal(v[0], v[1], sizeof v[0]);
    assert_memory_equal(w[0], w[1], sizeof w[0]);
    assert_true(v[0][1] < 0 && v[0][1] > -9.81 * 0.25 * (i + 1)); /* a quarter of its weight, less what the air takes */
    assert_int_equal(bench_steps(b->world, 60, NULL), CAROM_OK);
  }
}

static void what_is_wrong_is_refused_and_changes_nothing(void** state) {
  Bench* b = *state;
  const uint64_t before = hash_of(b->world);
  carom_error error = CAROM_ERROR_INIT;
  carom_body body = 0;
  carom_collider collider = 0;
  carom_body_desc d;
  carom_collider_desc part;
#define REFUSED(change, code)                                               \
  do {                                                                      \
    d = whole_body();                                                       \
    change;                                                                 \
    assert_int_equal(carom_body_create(b->world, &d, &body, &error), code); \
    assert_true(error.argument == 2 && body == 0 && error.remedy[0]);       \
    assert_true(hash_of(b->world) == before);                               \
  } while (0)
#define REFUSED_PART(change, code)                                                                   \
  do {                                                                                               \
    part = whole_collider(b->crate);                                                                 \
    change;                                                                                          \
    assert_int_equal(carom_collider_create(b->world, b->bodies[0], &part, &collider, &error), code); \
    assert_true(error.argument == 3 && collider == 0);                                               \
    assert_true(hash_of(b->world) == before);                                                        \
  } while (0)
  REFUSED(d.gravity_factor = NAN, CAROM_E_NOT_FINITE);
  REFUSED(d.locks = 64, CAROM_E_UNSUPPORTED);
  REFUSED(d.type = CAROM_BODY_KINEMATIC, CAROM_E_OUT_OF_RANGE); /* locks are of dynamic bodies */
  REFUSED(d.continuous = 3, CAROM_E_UNKNOWN_ENUM);
  REFUSED(d.linear_drag = -1, CAROM_E_OUT_OF_RANGE);
  REFUSED(d.quadratic_drag = INFINITY, CAROM_E_NOT_FINITE);
  REFUSED(d.reserved2 = 1, CAROM_E_UNSUPPORTED);
  REFUSED(d.magnetic_moment[2] = 1e13, CAROM_E_OUT_OF_RANGE);
  REFUSED_PART(part.sensor = 2, CAROM_E_OUT_OF_RANGE);
  REFUSED_PART(part.surface_linear[1] = 1e7, CAROM_E_OUT_OF_RANGE);
  REFUSED_PART(part.surface_angular[0] = NAN, CAROM_E_NOT_FINITE);
  assert_int_equal(carom_world_set_dial(b->world, CAROM_DIAL_SOLVER, CAROM_SOLVER_SEVERITY, NULL), CAROM_OK);
  d = whole_body();
  assert_int_equal(carom_body_create(b->world, &d, &body, &error), CAROM_E_UNSUPPORTED); /* it knows no locks */
}

/* A slot that is used again has nothing of what was there before. */
static void nothing_is_left_to_the_next_one(void** state) {
  Bench* b = *state;
  carom_body_desc said = whole_body(), usual, back;
  carom_collider_desc part = whole_collider(b->crate), plain, part_back;
  carom_body body, of;
  carom_collider collider;
  assert_int_equal(carom_body_create(b->world, &said, &body, NULL), CAROM_OK);
  assert_int_equal(carom_collider_create(b->world, body, &part, &collider, NULL), CAROM_OK);
  assert_int_equal(carom_body_destroy(b->world, body, NULL), CAROM_OK);
  carom_body_desc_init(&usual, sizeof usual);
  assert_int_equal(carom_body_create(b->world, &usual, &body, NULL), CAROM_OK);
  carom_collider_desc_init(&plain, sizeof plain);
  plain.shape = b->crate;
  assert_int_equal(carom_collider_create(b->world, body, &plain, &collider, NULL), CAROM_OK);
  back.struct_size = sizeof back, part_back.struct_size = sizeof part_back;
  assert_int_equal(carom_body_get(b->world, body, &back, NULL), CAROM_OK);
  assert_int_equal(carom_collider_get(b->world, collider, &part_back, &of, NULL), CAROM_OK);
  assert_memory_equal(&back.gravity_factor, &usual.gravity_factor, sizeof usual - kFirstBody);
  assert_memory_equal(&part_back.category, &plain.category, sizeof plain - kFirstCollider);
}

/* ---- closures: one support function, told apart by what it is handed ---- */
static int32_t cube_of(void* user, const double* params, uint64_t count, const double dir[3], double out[3]) {
  const double half = *(const double*)user;
  int i;
  (void)params, (void)count;
  for (i = 0; i < 3; ++i) out[i] = dir[i] < 0 ? -half : half;
  return 0;
}

static void a_function_is_handed_what_its_plugin_holds(void** state) {
  static double half[2] = {0.5, 1.25};
  static const carom_param unused = {"unused", "1", 0, 1};
  Bench* b = *state;
  carom_shape_plugin p[2];
  const double param = 0.5, dir[3] = {0, 0, 2}, at[2][3] = {{0, 0, 0}, {3, 0, 0}}, upright[4] = {0, 0, 0, 1};
  double out[3];
  carom_shape shape[2];
  carom_distance distance;
  int k;
  memset(p, 0, sizeof p);
  for (k = 0; k < 2; ++k) {
    carom_plugin plugin;
    p[k].struct_size = sizeof p[k], p[k].abi_major = CAROM_PLUGIN_ABI_MAJOR, p[k].version = 1;
    p[k].id = k ? "test.large" : "test.small";
    p[k].params = &unused, p[k].param_count = 1, p[k].support = cube_of, p[k].user = &half[k];
    assert_int_equal(carom_plugin_register(b->engine, &p[k], &plugin, NULL), CAROM_OK);
    assert_int_equal(carom_shape_create(b->engine, plugin, &param, 1, &shape[k], NULL), CAROM_OK);
    assert_int_equal(carom_shape_support(b->engine, shape[k], dir, 1, out, NULL), CAROM_OK);
    assert_true(fabs(out[2] - half[k]) < 1e-12);
  }
  distance.struct_size = sizeof distance;
  assert_int_equal(
      carom_shape_distance(b->engine, shape[0], at[0], upright, shape[1], at[1], upright, NULL, &distance, NULL),
      CAROM_OK);
  assert_true(fabs(distance.separation - 1.25) < 1e-5);
}

static void a_library_without_shapes_says_so(void** state) {
  Bench* b = *state;
  carom_error error = CAROM_ERROR_INIT;
  assert_int_equal(carom_plugins_register_standard(NULL, &error), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_plugins_register_standard(b->engine, &error), CAROM_E_UNSUPPORTED);
  assert_true(strstr(error.message, "carom_shape_create_named") != NULL && error.remedy[0]);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(an_older_struct_is_filled_to_its_end_and_no_further, make, clear),
      cmocka_unit_test(of_a_newer_struct_the_rest_is_zero),
      cmocka_unit_test(a_size_of_no_version_is_refused_and_nothing_written),
      cmocka_unit_test_setup_teardown(one_call_says_what_many_say, make, clear),
      cmocka_unit_test_setup_teardown(what_is_wrong_is_refused_and_changes_nothing, make, clear),
      cmocka_unit_test_setup_teardown(nothing_is_left_to_the_next_one, make, clear),
      cmocka_unit_test_setup_teardown(a_function_is_handed_what_its_plugin_holds, make, clear),
      cmocka_unit_test_setup_teardown(a_library_without_shapes_says_so, make, clear),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
