/* Structs of other versions of the header: a shorter one means defaults, a longer one may not ask for what this library
 * does not know, and nothing is ever written beyond the size that the caller's struct has. */
#include "bench.h"
#include "carom_test.h"

/* A descriptor followed by what a newer header might have added. */
typedef struct Longer {
  union {
    carom_body_desc body;
    carom_world_desc world;
    carom_engine_desc engine;
    carom_material_desc material;
    carom_collider_desc collider;
    carom_distance_desc distance;
    carom_shape_info info;
  } known;
  uint64_t tail[4];
} Longer;

static void sizes_of_no_version_are_refused(void** state) {
  static const uint32_t sizes[] = {0, 1, 4, 7, 9, 12, 4104, 0xCDCDCDCDu, 0xFFFFFFFFu};
  Bench b;
  size_t i;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  for (i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
    carom_engine_desc engine_desc;
    carom_world_desc world_desc;
    carom_body_desc body_desc;
    carom_material_desc material_desc;
    carom_collider_desc collider_desc;
    carom_distance_desc distance_desc;
    carom_shape_info info;
    carom_step_report report;
    carom_ledger_state ledger;
    carom_residuals residuals;
    carom_dial_info dial;
    carom_engine* engine = NULL;
    carom_world* world = NULL;
    carom_body body = 0;
    carom_material material = 0;
    carom_collider collider = 0;
    carom_distance distance;
    carom_cast_desc cast_desc;
    carom_cast cast;
    carom_overlap overlap;
    carom_motion motion, good_motion;
    carom_rays rays;
    carom_ray_hits hits;
    carom_particles_desc particles_desc;
    carom_particles particles = 0;
    const double zero[3] = {0, 0, 0}, upright[4] = {0, 0, 0, 1};
    carom_engine_desc_init(&engine_desc, sizeof engine_desc);
    carom_world_desc_init(&world_desc, sizeof world_desc);
    carom_body_desc_init(&body_desc, sizeof body_desc);
    carom_material_desc_init(&material_desc, sizeof material_desc);
    carom_collider_desc_init(&collider_desc, sizeof collider_desc);
    carom_distance_desc_init(&distance_desc, sizeof distance_desc);
    carom_particles_desc_init(&particles_desc, sizeof particles_desc);
    collider_desc.shape = b.ball;
    engine_desc.struct_size = world_desc.struct_size = body_desc.struct_size = material_desc.struct_size =
        collider_desc.struct_size = distance_desc.struct_size = particles_desc.struct_size = info.struct_size =
            report.struct_size = dial.struct_size = ledger.struct_size = residuals.struct_size = sizes[i];
    distance.struct_size = sizeof distance;
    assert_int_equal(carom_particles_create(b.world, &particles_desc, &particles, NULL), CAROM_E_STRUCT_SIZE);
    assert_int_equal(carom_engine_create(&engine_desc, &engine, NULL), CAROM_E_STRUCT_SIZE);
    assert_int_equal(carom_world_create(b.engine, &world_desc, &world, NULL), CAROM_E_STRUCT_SIZE);
    assert_int_equal(carom_body_create(b.world, &body_desc, &body, NULL), CAROM_E_STRUCT_SIZE);
    assert_int_equal(carom_body_get(b.world, b.bodies[0], &body_desc, NULL), CAROM_E_STRUCT_SIZE);
    assert_int_equal(carom_material_create(b.world, &material_desc, &material, NULL), CAROM_E_STRUCT_SIZE);
    assert_int_equal(carom_material_update(b.world, b.material, &material_desc, NULL), CAROM_E_STRUCT_SIZE);
    assert_int_equal(carom_collider_create(b.world, b.bodies[0], &collider_desc, &collider, NULL), CAROM_E_STRUCT_SIZE);
    assert_int_equal(carom_collider_get(b.world, b.colliders[0], &collider_desc, &body, NULL), CAROM_E_STRUCT_SIZE);
    assert_int_equal(carom_shape_get_info(b.engine, b.ball, &info, NULL), CAROM_E_STRUCT_SIZE);
    assert_int_equal(carom_world_get_report(b.world, &report, NULL), CAROM_E_STRUCT_SIZE);
    assert_int_equal(carom_world_get_ledger_state(b.world, &ledger, NULL), CAROM_E_STRUCT_SIZE);
    assert_int_equal(carom_world_get_residuals(b.world, &residuals, NULL), CAROM_E_STRUCT_SIZE);
    assert_int_equal(carom_dial_get_info(0, &dial, NULL), CAROM_E_STRUCT_SIZE);
    assert_int_equal(
        carom_shape_distance(b.engine, b.ball, zero, upright, b.crate, zero, upright, &distance_desc, &distance, NULL),
        CAROM_E_STRUCT_SIZE);
    distance.struct_size = sizes[i];
    assert_int_equal(
        carom_shape_distance(b.engine, b.ball, zero, upright, b.crate, zero, upright, NULL, &distance, NULL),
        CAROM_E_STRUCT_SIZE);
    carom_cast_desc_init(&cast_desc, sizeof cast_desc);
    carom_motion_init(&motion, sizeof motion);
    carom_motion_init(&good_motion, sizeof good_motion);
    memset(&rays, 0, sizeof rays);
    memset(&hits, 0, sizeof hits);
    cast.struct_size = sizeof cast;
    hits.struct_size = sizeof hits;
    cast_desc.struct_size = motion.struct_size = rays.struct_size = overlap.struct_size = sizes[i];
    assert_int_equal(carom_ray_cast(b.engine, b.ball, zero, upright, zero, zero, 1, &cast_desc, &cast, NULL),
                     CAROM_E_STRUCT_SIZE);
    assert_int_equal(carom_shape_time_of_impact(b.engine, b.ball, &good_motion, b.crate, &motion, 1, NULL, &cast, NULL),
                     CAROM_E_STRUCT_SIZE);
    assert_int_equal(carom_rays_cast(b.engine, &b.ball, zero, upright, 1, &rays, NULL, &hits, NULL),
                     CAROM_E_STRUCT_SIZE);
    rays.struct_size = sizeof rays;
    hits.struct_size = cast.struct_size = sizes[i];
    assert_int_equal(carom_rays_cast(b.engine, &b.ball, zero, upright, 1, &rays, NULL, &hits, NULL),
                     CAROM_E_STRUCT_SIZE);
    assert_int_equal(carom_ray_cast(b.engine, b.ball, zero, upright, zero, zero, 1, NULL, &cast, NULL),
                     CAROM_E_STRUCT_SIZE);
    assert_int_equal(carom_shape_cast(b.engine, b.ball, zero, upright, zero, b.crate, zero, upright, NULL, &cast, NULL),
                     CAROM_E_STRUCT_SIZE);
    assert_int_equal(
        carom_shape_time_of_impact(b.engine, b.ball, &good_motion, b.crate, &good_motion, 1, NULL, &cast, NULL),
        CAROM_E_STRUCT_SIZE);
    assert_int_equal(carom_shape_overlap(b.engine, b.ball, zero, upright, b.crate, zero, upright, NULL, &overlap, NULL),
                     CAROM_E_STRUCT_SIZE);
    assert_true(!engine && !world && !body && !material && !collider && !particles);
  }
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void a_shorter_descriptor_means_defaults_for_the_rest(void** state) {
  Bench b;
  carom_body_desc desc, got;
  carom_world_desc world_desc;
  carom_world* world;
  carom_body body;
  double gravity[3];
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  /* A header whose body ended after the position: what lies beyond is not even read. */
  memset(&desc, 0xFF, sizeof desc);
  desc.struct_size = offsetof(carom_body_desc, orientation);
  desc.fields = desc.reserved = 0;
  desc.type = CAROM_BODY_DYNAMIC;
  desc.position[0] = 1, desc.position[1] = 2, desc.position[2] = 3;
  assert_int_equal(carom_body_create(b.world, &desc, &body, NULL), CAROM_OK);
  got.struct_size = sizeof got;
  assert_int_equal(carom_body_get(b.world, body, &got, NULL), CAROM_OK);
  assert_true(got.position[0] == 1 && got.position[1] == 2 && got.position[2] == 3);
  assert_true(got.orientation[3] == 1 && got.linear_velocity[0] == 0 && got.linear_damping == 0 && got.user == 0);
  assert_true(got.mass == 1); /* a particle */

  memset(&world_desc, 0xFF, sizeof world_desc);
  world_desc.struct_size = 8;
  world_desc.reserved = 0;
  assert_int_equal(carom_world_create(b.engine, &world_desc, &world, NULL), CAROM_OK);
  assert_int_equal(carom_world_get_gravity(world, gravity, NULL), CAROM_OK);
  assert_true(gravity[0] == 0 && gravity[1] == -9.81 && gravity[2] == 0);
  assert_int_equal(carom_world_destroy(world, NULL), CAROM_OK);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void a_longer_descriptor_is_fine_while_its_tail_is_zero(void** state) {
  Bench b;
  Longer longer;
  carom_body body;
  carom_error e = CAROM_ERROR_INIT;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  memset(&longer, 0, sizeof longer);
  carom_body_desc_init(&longer.known.body, sizeof longer.known.body);
  longer.known.body.struct_size = (uint32_t)(sizeof(carom_body_desc) + 16);
  assert_int_equal(carom_body_create(b.world, &longer.known.body, &body, &e), CAROM_OK);
  ((unsigned char*)&longer)[sizeof(carom_body_desc) + 15] = 1; /* the last byte that the newer header has */
  assert_int_equal(carom_body_create(b.world, &longer.known.body, &body, &e), CAROM_E_UNSUPPORTED);
  assert_int_equal(e.argument, 2);
  ((unsigned char*)&longer)[sizeof(carom_body_desc) + 15] = 0;
  ((unsigned char*)&longer)[sizeof(carom_body_desc) + 16] = 1; /* beyond it: none of our business */
  assert_int_equal(carom_body_create(b.world, &longer.known.body, &body, &e), CAROM_OK);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void outputs_are_written_up_to_the_callers_size(void** state) {
  Bench b;
  carom_shape_info full, part;
  Longer longer;
  size_t size, i;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  memset(&full, 0, sizeof full);
  full.struct_size = sizeof full;
  assert_int_equal(carom_shape_get_info(b.engine, b.crate, &full, NULL), CAROM_OK);
  assert_int_equal(full.struct_size, sizeof full);
  for (size = 8; size <= sizeof full; size += 8) {
    const unsigned char* bytes = (const unsigned char*)&part;
    memset(&part, 0xA5, sizeof part);
    part.struct_size = (uint32_t)size;
    assert_int_equal(carom_shape_get_info(b.engine, b.crate, &part, NULL), CAROM_OK);
    assert_int_equal(part.struct_size, size);
    assert_memory_equal(bytes + 4, (const unsigned char*)&full + 4, size - 4);
    for (i = size; i < sizeof part; ++i) assert_int_equal(bytes[i], 0xA5);
  }
  /* A newer caller: what this library does not know stays as it was. */
  memset(&longer, 0xA5, sizeof longer);
  longer.known.info.struct_size = (uint32_t)(sizeof(carom_shape_info) + 24);
  assert_int_equal(carom_shape_get_info(b.engine, b.crate, &longer.known.info, NULL), CAROM_OK);
  assert_memory_equal((const unsigned char*)&longer + 4, (const unsigned char*)&full + 4, sizeof full - 4);
  for (i = sizeof full; i < sizeof longer; ++i) assert_int_equal(((const unsigned char*)&longer)[i], 0xA5);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void errors_are_written_up_to_the_callers_size(void** state) {
  carom_error full = CAROM_ERROR_INIT, part;
  const unsigned char* bytes = (const unsigned char*)&part;
  size_t size, i;
  (void)state;
  assert_int_equal(carom_world_step(NULL, 0, &full), CAROM_E_NULL_ARGUMENT);
  for (size = 8; size <= sizeof full; size += 8) {
    memset(&part, 0xA5, sizeof part);
    part.struct_size = (uint32_t)size;
    assert_int_equal(carom_world_step(NULL, 0, &part), CAROM_E_NULL_ARGUMENT);
    assert_int_equal(part.struct_size, size);
    assert_int_equal(part.code, CAROM_E_NULL_ARGUMENT);
    for (i = size; i < sizeof part; ++i) assert_int_equal(bytes[i], 0xA5);
    /* Text that is cut still ends. */
    if (size > offsetof(carom_error, message))
      assert_non_null(memchr(part.message, 0, size - offsetof(carom_error, message)));
    if (size > offsetof(carom_error, remedy))
      assert_non_null(memchr(part.remedy, 0, size - offsetof(carom_error, remedy)));
  }
}

static void a_success_leaves_the_error_object_alone(void** state) {
  carom_error e = CAROM_ERROR_INIT;
  carom_error before;
  carom_engine* engine = NULL;
  (void)state;
  e.code = 5;
  memset(e.message, 'x', sizeof e.message);
  before = e;
  assert_int_equal(carom_engine_create(NULL, &engine, &e), CAROM_OK);
  assert_memory_equal(&e, &before, sizeof e);
  assert_int_equal(carom_engine_destroy(engine, &e), CAROM_OK);
}

static void elements_of_an_older_header_get_their_prefix(void** state) {
  Bench b;
  carom_contact full[16];
  struct {
    carom_collider a, b;
    uint64_t canary;
  } old[16];
  uint64_t count = 0, again = 0, i;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 60, NULL), CAROM_OK);
  assert_int_equal(carom_world_get_contacts(b.world, full, sizeof *full, 16, &count, NULL), CAROM_OK);
  assert_true(count > 0 && count <= 16);
  memset(old, 0xA5, sizeof old);
  /* Stride is the whole record here, so the record of 24 bytes is filled with the first 24 of the element. */
  assert_int_equal(carom_world_get_contacts(b.world, (carom_contact*)(void*)old, sizeof *old, 16, &again, NULL),
                   CAROM_OK);
  assert_true(again == count);
  for (i = 0; i < count; ++i) {
    assert_true(old[i].a == full[i].collider_a && old[i].b == full[i].collider_b && old[i].canary == full[i].body_a);
  }
  for (i = count; i < 16; ++i) assert_true(old[i].a == 0xA5A5A5A5A5A5A5A5ull);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(sizes_of_no_version_are_refused),
      cmocka_unit_test(a_shorter_descriptor_means_defaults_for_the_rest),
      cmocka_unit_test(a_longer_descriptor_is_fine_while_its_tail_is_zero),
      cmocka_unit_test(outputs_are_written_up_to_the_callers_size),
      cmocka_unit_test(errors_are_written_up_to_the_callers_size),
      cmocka_unit_test(a_success_leaves_the_error_object_alone),
      cmocka_unit_test(elements_of_an_older_header_get_their_prefix),
  };
  return cmocka_run_group_tests_name("abi/struct_size", tests, NULL, NULL);
}
