/* Sets of particles as a host uses them: made, filled, read and written in bulk, stepped, told what went wrong. */
#include "bench.h"
#include "carom_test.h"

/* The stage under semi-implicit Euler without substeps, so that a step can be worked out by hand. */
static void make_plain(Bench* b) {
  assert_int_equal(bench_make(b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b->world, CAROM_DIAL_INTEGRATOR, CAROM_INTEGRATOR_SEMI_IMPLICIT_EULER, NULL),
                   CAROM_OK);
  assert_int_equal(carom_world_set_dial(b->world, CAROM_DIAL_SUBSTEPS, 1, NULL), CAROM_OK);
}
static int make(void** state) {
  static Bench b;
  make_plain(&b);
  assert_int_equal(bench_particles(&b, NULL), CAROM_OK);
  *state = &b;
  return 0;
}
static int clear(void** state) {
  assert_int_equal(bench_free(*state), CAROM_OK);
  return 0;
}

static uint64_t count_of(const Bench* b, carom_particles set) {
  uint64_t n = 99;
  assert_int_equal(carom_particles_get_count(b->world, set, &n, NULL), CAROM_OK);
  return n;
}
static void positions(const Bench* b, double (*x)[3], uint64_t n) {
  assert_int_equal(carom_particles_read(b->world, b->particles, CAROM_FIELD_POSITION, 1, NULL, n, x, 0, NULL),
                   CAROM_OK);
}
static carom_step_report report_of(const Bench* b) {
  carom_step_report r;
  memset(&r, 0, sizeof r);
  r.struct_size = sizeof r;
  assert_int_equal(carom_world_get_report(b->world, &r, NULL), CAROM_OK);
  return r;
}

static void what_is_added_is_there_and_flies(void** state) {
  Bench* b = *state;
  double x[BENCH_PARTICLES][3], v[BENCH_PARTICLES][3], kg[BENCH_PARTICLES];
  const double h = 1.0 / 64;
  int i, k;
  assert_int_equal(count_of(b, b->particles), BENCH_PARTICLES);
  positions(b, x, BENCH_PARTICLES);
  for (i = 0; i < BENCH_PARTICLES; ++i)
    for (k = 0; k < 3; ++k) assert_true(x[i][k] == i + k);
  assert_int_equal(carom_world_step(b->world, h, NULL), CAROM_OK);
  assert_int_equal(
      carom_particles_read(b->world, b->particles, CAROM_FIELD_LINEAR_VELOCITY, 1, NULL, BENCH_PARTICLES, v, 0, NULL),
      CAROM_OK);
  assert_int_equal(
      carom_particles_read(b->world, b->particles, CAROM_FIELD_MASS, 1, NULL, BENCH_PARTICLES, kg, 0, NULL), CAROM_OK);
  positions(b, x, BENCH_PARTICLES);
  for (i = 0; i < BENCH_PARTICLES; ++i) { /* semi-implicit Euler */
    assert_true(kg[i] == 1);
    assert_true(v[i][1] == (i == 0 ? 1 : 0) + h * -9.81);
    for (k = 0; k < 3; ++k) assert_true(x[i][k] == i + k + h * v[i][k]);
  }
  assert_int_equal(report_of(b).particles, BENCH_PARTICLES);
  assert_int_equal(report_of(b).bodies, BENCH_BODIES + 1);
  assert_true(report_of(b).linear_energy > 2); /* of 1 kg each at 1 m/s, and what fell; bodies add theirs */
}

static void floats_and_strides_are_as_in_other_bulk_calls(void** state) {
  Bench* b = *state;
  float x[2][4] = {{0.1f, 0.2f, 0.3f, -1}, {1.5f, -2.5f, 1e6f, -1}}, back[2][3];
  unsigned char odd[2 * 29];
  const uint32_t last_two[2] = {BENCH_PARTICLES + 1, BENCH_PARTICLES};
  double precise[2][3], kg[2] = {5, 7};
  int i, k;
  assert_int_equal(carom_particles_add(b->world, b->particles, 2, CAROM_SCALAR_F32, x, sizeof *x, NULL, 0, NULL),
                   CAROM_OK);
  assert_int_equal(carom_particles_read(b->world, b->particles, CAROM_FIELD_POSITION, 0, last_two, 2, back, 0, NULL),
                   CAROM_OK);
  assert_int_equal(carom_particles_read(b->world, b->particles, CAROM_FIELD_POSITION, 1, last_two, 2, precise, 0, NULL),
                   CAROM_OK);
  for (i = 0; i < 2; ++i)
    for (k = 0; k < 3; ++k) assert_true(back[i][k] == x[1 - i][k] && precise[i][k] == x[1 - i][k]);
  memset(odd, 0xA5, sizeof odd);
  assert_int_equal(
      carom_particles_read(b->world, b->particles, CAROM_FIELD_POSITION, 1, last_two, 2, odd + 1, 28, NULL), CAROM_OK);
  for (i = 0; i < 2; ++i) {
    assert_memory_equal(odd + 1 + 28 * i, precise[i], 24);
    for (k = 24; k < 28; ++k) assert_int_equal(odd[1 + 28 * i + k], 0xA5);
  }
  assert_int_equal(
      carom_particles_write(b->world, b->particles, CAROM_FIELD_LINEAR_VELOCITY, 1, last_two, 2, odd + 1, 28, NULL),
      CAROM_OK);
  assert_int_equal(
      carom_particles_read(b->world, b->particles, CAROM_FIELD_LINEAR_VELOCITY, 0, last_two, 2, back, 0, NULL),
      CAROM_OK);
  for (i = 0; i < 2; ++i)
    for (k = 0; k < 3; ++k) assert_true(back[i][k] == x[1 - i][k]);
  assert_int_equal(carom_particles_write(b->world, b->particles, CAROM_FIELD_MASS, 1, last_two, 2, kg, 0, NULL),
                   CAROM_OK);
  assert_int_equal(carom_particles_read(b->world, b->particles, CAROM_FIELD_MASS, 1, last_two, 2, precise, 0, NULL),
                   CAROM_OK);
  assert_true(precise[0][0] == 5 && precise[0][1] == 7);
}

static void removing_keeps_the_order_of_the_others(void** state) {
  Bench* b = *state;
  const uint32_t gone[2] = {0, 3};
  double x[BENCH_PARTICLES][3];
  assert_int_equal(carom_particles_remove(b->world, b->particles, gone, 2, NULL), CAROM_OK);
  assert_int_equal(count_of(b, b->particles), 3);
  positions(b, x, 3);
  assert_true(x[0][0] == 1 && x[1][0] == 2 && x[2][0] == 4);
  assert_int_equal(carom_particles_remove(b->world, b->particles, gone, 0, NULL), CAROM_OK);
  assert_int_equal(carom_particles_remove(b->world, b->particles, NULL, 3, NULL), CAROM_OK);
  assert_int_equal(count_of(b, b->particles), 0);
  assert_int_equal(bench_steps(b->world, 2, NULL), CAROM_OK);
  assert_int_equal(report_of(b).particles, 0);
  /* Nothing is a fine number of particles, and needs no arrays. */
  assert_int_equal(carom_particles_add(b->world, b->particles, 0, 1, NULL, 0, NULL, 0, NULL), CAROM_OK);
  assert_int_equal(carom_particles_read(b->world, b->particles, CAROM_FIELD_MASS, 1, NULL, 0, NULL, 0, NULL), CAROM_OK);
  assert_int_equal(carom_particles_write(b->world, b->particles, CAROM_FIELD_MASS, 1, NULL, 0, NULL, 0, NULL),
                   CAROM_OK);
}

static void sets_keep_what_they_have_in_common(void** state) {
  Bench* b = *state;
  carom_particles_desc d, got;
  carom_particles light, sets[4] = {0, 0, 0, 77};
  const double zero[3] = {0, 0, 0}, h = 1.0 / 64;
  double v[3], kg[2];
  uint64_t n = 0;
  carom_particles_desc_init(&d, sizeof d);
  d.gravity_factor = -0.5, d.linear_damping = 0, d.mass = 0.25, d.capacity = 100;
  assert_int_equal(carom_particles_create(b->world, &d, &light, NULL), CAROM_OK);
  got.struct_size = sizeof got;
  assert_int_equal(carom_particles_get(b->world, light, &got, NULL), CAROM_OK);
  assert_true(got.gravity_factor == -0.5 && got.linear_damping == 0 && got.mass == 0.25 && got.capacity >= 100);
  assert_int_equal(carom_particles_add(b->world, light, 1, 1, zero, 0, NULL, 0, NULL), CAROM_OK);
  assert_int_equal(carom_world_step(b->world, h, NULL), CAROM_OK);
  assert_int_equal(carom_particles_read(b->world, light, CAROM_FIELD_LINEAR_VELOCITY, 1, NULL, 1, v, 0, NULL),
                   CAROM_OK);
  assert_true(v[1] == h * (-0.5 * -9.81));
  /* Drag acts from now on; who is there keeps his mass. */
  d.gravity_factor = 0, d.linear_damping = 64, d.mass = 3;
  assert_int_equal(carom_particles_update(b->world, light, &d, NULL), CAROM_OK);
  assert_int_equal(carom_particles_add(b->world, light, 1, 1, zero, 0, NULL, 0, NULL), CAROM_OK);
  assert_int_equal(carom_world_step(b->world, h, NULL), CAROM_OK);
  assert_int_equal(carom_particles_read(b->world, light, CAROM_FIELD_MASS, 1, NULL, 2, kg, 0, NULL), CAROM_OK);
  assert_true(kg[0] == 0.25 && kg[1] == 3);
  {
    double slow[6];
    assert_int_equal(carom_particles_read(b->world, light, CAROM_FIELD_LINEAR_VELOCITY, 1, NULL, 2, slow, 0, NULL),
                     CAROM_OK);
    assert_true(fabs(slow[1] - v[1] * exp(-1.0)) < 1e-15); /* a product of numbers below 0.1, rounded */
  }
  assert_int_equal(carom_world_get_particles(b->world, sets, 3, &n, NULL), CAROM_OK);
  assert_true(n == 2 && sets[0] == b->particles && sets[1] == light && sets[2] == 0 && sets[3] == 77);
  assert_int_equal(carom_particles_destroy(b->world, b->particles, NULL), CAROM_OK);
  assert_int_equal(carom_world_get_particles(b->world, NULL, 0, &n, NULL), CAROM_OK);
  assert_int_equal(n, 1);
  assert_int_equal(bench_steps(b->world, 2, NULL), CAROM_OK);
  assert_int_equal(report_of(b).particles, 2);
}

/* Bodies are none the wiser: the hash of their poses, read in bulk, is that of a world without particles. */
static void bodies_do_not_feel_them(void** state) {
  Bench *b = *state, other;
  double with[BENCH_BODIES][7], without[BENCH_BODIES][7];
  make_plain(&other);
  assert_int_equal(bench_steps(b->world, 100, NULL), CAROM_OK);
  assert_int_equal(bench_steps(other.world, 100, NULL), CAROM_OK);
  assert_int_equal(carom_world_read(b->world, CAROM_FIELD_POSE, 1, b->bodies, BENCH_BODIES, with, 0, NULL), CAROM_OK);
  assert_int_equal(carom_world_read(other.world, CAROM_FIELD_POSE, 1, other.bodies, BENCH_BODIES, without, 0, NULL),
                   CAROM_OK);
  assert_memory_equal(with, without, sizeof with);
  assert_int_equal(bench_free(&other), CAROM_OK);
}

static void who_leaves_the_world_is_held_and_told(void** state) {
  Bench* b = *state;
  const uint32_t sick[2] = {2, 4};
  const double edge[2][3] = {{0, 1e15, 0}, {-1e15, 0, 0}}, out[2][3] = {{0, 1e5, 0}, {-1e5, 0, 0}}, home[3] = {0, 1, 0};
  double x[BENCH_PARTICLES][3], held[BENCH_PARTICLES][3];
  carom_fault faults[3];
  uint32_t indices[3] = {77, 77, 77};
  uint64_t n = 0;
  int i;
  assert_int_equal(carom_particles_write(b->world, b->particles, CAROM_FIELD_POSITION, 1, sick, 2, edge, 0, NULL),
                   CAROM_OK);
  assert_int_equal(carom_particles_write(b->world, b->particles, CAROM_FIELD_LINEAR_VELOCITY, 1, sick, 2, out, 0, NULL),
                   CAROM_OK);
  assert_int_equal(bench_steps(b->world, 1, NULL), CAROM_OK);
  assert_int_equal(report_of(b).quarantined_particles, 2);
  assert_int_equal(report_of(b).quarantined_bodies, 0);
  memset(faults, 0, sizeof faults);
  assert_int_equal(carom_world_get_faults(b->world, faults, sizeof *faults, 3, &n, NULL), CAROM_OK);
  assert_int_equal(n, 1);
  assert_int_equal(faults[0].kind, CAROM_FAULT_PARTICLE_STATE);
  assert_true(faults[0].particles == b->particles && faults[0].particle == 2);
  assert_true(faults[0].body == CAROM_NULL_HANDLE && faults[0].shape == CAROM_NULL_HANDLE);
  /* A client of the header before sees a kind that it does not know, and no more than its record holds. */
  {
    unsigned char old[80 + 8];
    memset(old, 0xA5, sizeof old);
    assert_int_equal(carom_world_get_faults(b->world, (carom_fault*)(void*)old, 80, 1, &n, NULL), CAROM_OK);
    for (i = 80; i < 88; ++i) assert_int_equal(old[i], 0xA5);
  }
  assert_int_equal(carom_particles_get_quarantined(b->world, b->particles, indices, 3, &n, NULL), CAROM_OK);
  assert_true(n == 2 && indices[0] == 2 && indices[1] == 4 && indices[2] == 77);
  positions(b, x, BENCH_PARTICLES);
  assert_int_equal(bench_steps(b->world, 5, NULL), CAROM_OK);
  positions(b, held, BENCH_PARTICLES);
  for (i = 0; i < BENCH_PARTICLES; ++i) assert_int_equal(memcmp(x[i], held[i], sizeof x[i]) == 0, i == 2 || i == 4);
  /* One is put back, the other removed with the list that told of it. */
  assert_int_equal(carom_particles_write(b->world, b->particles, CAROM_FIELD_POSITION, 1, sick, 1, home, 0, NULL),
                   CAROM_OK);
  assert_int_equal(carom_particles_get_quarantined(b->world, b->particles, indices, 3, &n, NULL), CAROM_OK);
  assert_true(n == 1 && indices[0] == 4);
  assert_int_equal(carom_particles_remove(b->world, b->particles, indices, n, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b->world, 1, NULL), CAROM_OK);
  positions(b, x, BENCH_PARTICLES - 1);
  assert_true(x[2][1] < 1);
  assert_int_equal(report_of(b).quarantined_particles, 0);
}

static void the_faults_of_a_destroyed_set_are_gone(void** state) {
  Bench* b = *state;
  const uint32_t first = 0;
  const double edge[3] = {0, 1e15, 0}, out[3] = {0, 1e5, 0};
  uint64_t n = 9;
  assert_int_equal(carom_particles_write(b->world, b->particles, CAROM_FIELD_POSITION, 1, &first, 1, edge, 0, NULL),
                   CAROM_OK);
  assert_int_equal(
      carom_particles_write(b->world, b->particles, CAROM_FIELD_LINEAR_VELOCITY, 1, &first, 1, out, 0, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b->world, 1, NULL), CAROM_OK);
  assert_int_equal(carom_body_destroy(b->world, b->bodies[0], NULL),
                   CAROM_OK); /* slot numbers are no reason to forget it */
  assert_int_equal(carom_world_get_faults(b->world, NULL, 0, 0, &n, NULL), CAROM_OK);
  assert_int_equal(n, 1);
  assert_int_equal(carom_particles_destroy(b->world, b->particles, NULL), CAROM_OK);
  assert_int_equal(carom_world_get_faults(b->world, NULL, 0, 0, &n, NULL), CAROM_OK);
  assert_int_equal(n, 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(what_is_added_is_there_and_flies, make, clear),
      cmocka_unit_test_setup_teardown(floats_and_strides_are_as_in_other_bulk_calls, make, clear),
      cmocka_unit_test_setup_teardown(removing_keeps_the_order_of_the_others, make, clear),
      cmocka_unit_test_setup_teardown(sets_keep_what_they_have_in_common, make, clear),
      cmocka_unit_test_setup_teardown(bodies_do_not_feel_them, make, clear),
      cmocka_unit_test_setup_teardown(who_leaves_the_world_is_held_and_told, make, clear),
      cmocka_unit_test_setup_teardown(the_faults_of_a_destroyed_set_are_gone, make, clear),
  };
  return cmocka_run_group_tests_name("abi/particles", tests, NULL, NULL);
}
