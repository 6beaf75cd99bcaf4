/* Same input, same bits: twice in one process, in another engine with other addresses and handles, after edits that were
 * refused, and against a golden hash that every compiler and build type must print. */
#define _POSIX_C_SOURCE 200112L
#include <stdlib.h>

#include "../abi/bench.h"
#include "carom_test.h"

/* By setting; the last two with contacts in floats. */
static const double kSolvers[] = {CAROM_SOLVER_SEVERITY, CAROM_SOLVER_SEVERITY, CAROM_SOLVER_SOFT_STEP,
                                  CAROM_SOLVER_DIRECT,   CAROM_SOLVER_AUTO,     CAROM_SOLVER_SOFT_STEP,
                                  CAROM_SOLVER_AUTO};
enum { kSettings = 7, kFirstInFloat = 5 };

/* Whether all steps below take a detour: half of them, then a snapshot, some steps more, the snapshot put back, and the
 * other half. */
static int detour = 0;

static int32_t steps_of(carom_world* world, int n, carom_error* e) {
  uint64_t size = 0;
  void* bytes;
  int32_t r;
  if (!detour) return bench_steps(world, n, e);
  r = bench_steps(world, n / 2, e);
  r = bench_first(r, carom_world_save(world, CAROM_SNAPSHOT_STATE, NULL, 0, &size, e));
  bytes = malloc((size_t)size);
  r = bench_first(r, carom_world_save(world, CAROM_SNAPSHOT_STATE, bytes, size, &size, e));
  r = bench_first(r, bench_steps(world, 23, e));
  r = bench_first(r, carom_world_restore(world, bytes, size, e));
  free(bytes);
  return bench_first(r, bench_steps(world, n - n / 2, e));
}

/* Bits of a world's state: those of carom_world_hash, and of every pose and velocity read in bulk. */
static uint64_t bits_after(const carom_engine_desc* desc, int steps, int setting) {
  Bench b;
  double poses[BENCH_BODIES][7], velocities[BENCH_BODIES][6];
  uint64_t hash, words[BENCH_BODIES * 13];
  size_t i;
  assert_int_equal(bench_make(&b, desc, NULL), CAROM_OK);
  if (setting == 1) {
    assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_PAIR_ROUTINES, 0, NULL), CAROM_OK);
    assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_INTEGRATOR, CAROM_INTEGRATOR_RK4, NULL), CAROM_OK);
    assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_BROAD_PHASE, CAROM_BROAD_GRID, NULL), CAROM_OK);
  }
  if (setting >= kFirstInFloat)
    assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_PRECISION, CAROM_PRECISION_FLOAT, NULL), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SOLVER, kSolvers[setting], NULL), CAROM_OK);
  assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SUBSTEPS, setting < 2 ? 1 : 4, NULL), CAROM_OK);
  /* So that auto gives to both of its solvers: with its default it would give nothing here to the direct one. */
  assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_DIRECT_SINK, 1e-4, NULL), CAROM_OK);
  assert_int_equal(steps_of(b.world, steps, NULL), CAROM_OK);
  hash = bench_hash(b.world);
  assert_int_equal(
      carom_world_read(b.world, CAROM_FIELD_POSE, CAROM_SCALAR_F64, b.bodies, BENCH_BODIES, poses, 0, NULL), CAROM_OK);
  assert_int_equal(
      carom_world_read(b.world, CAROM_FIELD_VELOCITY, CAROM_SCALAR_F64, b.bodies, BENCH_BODIES, velocities, 0, NULL),
      CAROM_OK);
  memcpy(words, poses, sizeof poses);
  memcpy(words + BENCH_BODIES * 7, velocities, sizeof velocities);
  for (i = 0; i < BENCH_BODIES * 13; ++i) hash = (hash ^ words[i]) * 0x9E3779B97F4A7C15u;
  assert_int_equal(bench_free(&b), CAROM_OK);
  return hash;
}

/* An allocator that returns other addresses each time, with other rubbish in them. */
static void* shifting_alloc(void* user, uint64_t size, uint64_t alignment) {
  static int calls = 0;
  const size_t shift = (size_t)alignment * (size_t)(++calls % 7);
  void* raw;
  unsigned char* p;
  (void)user;
  if (alignment < 2 * sizeof(void*)) alignment = 2 * sizeof(void*);
  raw = malloc((size_t)(size + 9 * alignment));
  if (!raw) return NULL;
  memset(raw, calls * 37, (size_t)(size + 9 * alignment));
  p = (unsigned char*)raw + 2 * alignment - (uintptr_t)raw % alignment + shift;
  memcpy(p - sizeof raw, &raw, sizeof raw);
  return p;
}
static void shifting_free(void* user, void* pointer, uint64_t size, uint64_t alignment) {
  void* raw;
  (void)user, (void)size, (void)alignment;
  memcpy(&raw, (unsigned char*)pointer - sizeof raw, sizeof raw);
  free(raw);
}

static void the_same_scene_twice_gives_the_same_bits(void** state) {
  (void)state;
  assert_true(bits_after(NULL, 200, 0) == bits_after(NULL, 200, 0));
  assert_true(bits_after(NULL, 200, 1) == bits_after(NULL, 200, 1));
  assert_true(bits_after(NULL, 200, 2) == bits_after(NULL, 200, 2));
}

static void the_hash_tells_one_step_and_one_dial_from_another(void** state) {
  (void)state;
  assert_true(bits_after(NULL, 200, 0) != bits_after(NULL, 201, 0));
  assert_true(bits_after(NULL, 200, 0) != bits_after(NULL, 200, 1));
}

static void addresses_and_what_memory_held_do_not_matter(void** state) {
  carom_engine_desc desc;
  (void)state;
  carom_engine_desc_init(&desc, sizeof desc);
  desc.alloc = shifting_alloc;
  desc.free = shifting_free;
  assert_true(bits_after(&desc, 200, 0) == bits_after(NULL, 200, 0));
  assert_true(bits_after(&desc, 200, 1) == bits_after(NULL, 200, 1));
  assert_true(bits_after(&desc, 200, 2) == bits_after(NULL, 200, 2));
}

static void handle_numbers_do_not_matter(void** state) {
  carom_engine* others[40];
  uint64_t before;
  size_t i;
  (void)state;
  before = bits_after(NULL, 100, 0);
  for (i = 0; i < 40; ++i) assert_int_equal(carom_engine_create(NULL, &others[i], NULL), CAROM_OK);
  assert_true(bits_after(NULL, 100, 0) == before);
  for (i = 0; i < 40; ++i) assert_int_equal(carom_engine_destroy(others[i], NULL), CAROM_OK);
}

/* What every compiler (gcc, clang), build type (Release, Debug, sanitizers) and machine must get: 200 steps of the stage, by
 * the specific routines, by the generic path, by the other solvers (soft_step, direct, auto), and with contacts in
 * floats (soft_step, auto). When physics is meant to change, so do these: say why in the commit. */
static void the_bits_are_those_of_every_other_build(void** state) {
  const uint64_t golden[kSettings] = {0xd26f51eb8ebaa981u, 0xea595e90983bc931u, 0x8a2dc29b81dc1924u,
                                      0xc119ab72f608f8b1u, 0x39bc280ebc116b2eu, 0x186a31bed1da3cddu,
                                      0x39bc280ebc116b2eu};
  int setting, wrong = 0;
  (void)state;
  for (setting = 0; setting < kSettings; ++setting) {
    const uint64_t got = bits_after(NULL, 200, setting);
    wrong += got != golden[setting];
    if (got != golden[setting]) print_error("setting %d: 0x%016llx\n", setting, (unsigned long long)got);
  }
  assert_int_equal(wrong, 0);
}

/* The same of a set of particles, by integrator: 200 steps with drag, of masses alike and, in the second half, each its
 * own. Their number fills neither lanes nor blocks. */
static void so_are_those_of_particles(void** state) {
  const uint64_t golden[4] = {0x656db2edaf9fb44au, 0xe10c751a5c6fd98du, 0x071954b2debbbf21u, 0x8755eef36ecd809bu};
  static double x[1003][3], kg[1003];
  int integrator, i, wrong = 0;
  (void)state;
  for (i = 0; i < 1003; ++i) {
    x[i][0] = 0.125 * (i % 31), x[i][1] = 0.25 * (i % 17), x[i][2] = 0.5 * (i % 7);
    kg[i] = 1 + i % 3;
  }
  for (integrator = 0; integrator < 4; ++integrator) {
    Bench b;
    carom_particles_desc desc;
    uint64_t got, energy;
    carom_step_report report;
    memset(&b, 0, sizeof b);
    assert_int_equal(carom_engine_create(NULL, &b.engine, NULL), CAROM_OK);
    assert_int_equal(carom_world_create(b.engine, NULL, &b.world, NULL), CAROM_OK);
    assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_INTEGRATOR, integrator, NULL), CAROM_OK);
    carom_particles_desc_init(&desc, sizeof desc);
    desc.gravity_factor = 0.75, desc.linear_damping = 0.3;
    assert_int_equal(carom_particles_create(b.world, &desc, &b.particles, NULL), CAROM_OK);
    assert_int_equal(carom_particles_add(b.world, b.particles, 1003, CAROM_SCALAR_F64, x, 0, x, 0, NULL), CAROM_OK);
    assert_int_equal(steps_of(b.world, 100, NULL), CAROM_OK);
    assert_int_equal(
        carom_particles_write(b.world, b.particles, CAROM_FIELD_MASS, CAROM_SCALAR_F64, NULL, 1003, kg, 0, NULL),
        CAROM_OK);
    assert_int_equal(steps_of(b.world, 100, NULL), CAROM_OK);
    report.struct_size = sizeof report;
    assert_int_equal(carom_world_get_report(b.world, &report, NULL), CAROM_OK);
    memcpy(&energy, &report.linear_energy, sizeof energy);
    got = bench_hash(b.world) ^ energy;
    wrong += got != golden[integrator];
    if (got != golden[integrator]) print_error("integrator %d: 0x%016llx\n", integrator, (unsigned long long)got);
    assert_int_equal(bench_free(&b), CAROM_OK);
  }
  assert_int_equal(wrong, 0);
}

/* The same of joints, by solver (soft_step, direct, auto): one of each kind between the world and the bodies of
 * the stage, a motor, a spring and limits on them; 200 steps. */
static void so_are_those_of_joints(void** state) {
  const uint64_t golden[3] = {0x5fe76185554603fau, 0xe103d169e33e3cb0u, 0x0b6db8df98b4ab40u};
  uint32_t solver, kind;
  int wrong = 0;
  (void)state;
  for (solver = CAROM_SOLVER_SOFT_STEP; solver <= CAROM_SOLVER_AUTO; ++solver) {
    Bench b;
    uint64_t got;
    carom_joint joints[CAROM_JOINT_UNIVERSAL + 1]; /* the hashes are of these kinds */
    carom_joint_limit limit;
    carom_joint_motor motor;
    carom_joint_spring spring;
    assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
    assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SOLVER, solver, NULL), CAROM_OK);
    for (kind = 0; kind <= CAROM_JOINT_UNIVERSAL; ++kind) {
      carom_joint_desc d;
      carom_joint_desc_init(&d, sizeof d);
      d.kind = kind, d.fields = CAROM_JOINT_WORLD_FRAME;
      d.body_a = kind < 3 ? CAROM_NULL_HANDLE : b.bodies[kind % 3], d.body_b = b.bodies[kind < 3 ? kind : 3];
      d.position_a[0] = 0.5 * kind, d.position_a[1] = 3 + 0.25 * kind, d.position_a[2] = 0.125;
      assert_int_equal(carom_joint_create(b.world, &d, &joints[kind], NULL), CAROM_OK);
    }
    carom_joint_limit_init(&limit, sizeof limit), carom_joint_motor_init(&motor, sizeof motor),
        carom_joint_spring_init(&spring, sizeof spring);
    limit.enabled = motor.enabled = spring.enabled = 1;
    limit.upper = 0.5, motor.speed = 3, motor.max_force = 5, spring.target = 0.25, spring.damping = 0.25;
    assert_int_equal(carom_joint_set_limit(b.world, joints[0], CAROM_COORDINATE_SWING, &limit, NULL), CAROM_OK);
    assert_int_equal(carom_joint_set_motor(b.world, joints[1], CAROM_COORDINATE_TWIST, &motor, NULL), CAROM_OK);
    assert_int_equal(carom_joint_set_spring(b.world, joints[2], CAROM_COORDINATE_SLIDE, &spring, NULL), CAROM_OK);
    assert_int_equal(steps_of(b.world, 200, NULL), CAROM_OK);
    got = bench_hash(b.world);
    wrong += got != golden[solver - CAROM_SOLVER_SOFT_STEP];
    if (got != golden[solver - CAROM_SOLVER_SOFT_STEP])
      print_error("solver %u: 0x%016llx\n", solver, (unsigned long long)got);
    assert_int_equal(bench_free(&b), CAROM_OK);
  }
  assert_int_equal(wrong, 0);
}

/* The same of bodies with a gravity factor, of locked bodies (also on a joint) and of belts, by solver, and of soft_step
 * with contacts in floats. 200 steps. */
static void so_are_those_of_factors_locks_and_belts(void** state) {
  const uint64_t golden[4] = {0x22e764d33cb317bcu, 0xb0cbb17e4eaf284cu, 0xc0b7376aa7b13273u, 0x11372563e5ca6756u};
  const double belt[3] = {0.75, 0, 0.25}, turn[3] = {0, 0.5, 0};
  uint32_t i;
  int wrong = 0;
  (void)state;
  for (i = 0; i < 4; ++i) {
    Bench b;
    const uint32_t solver = CAROM_SOLVER_SOFT_STEP + i % 3,
                   precision = i < 3 ? CAROM_PRECISION_DOUBLE : CAROM_PRECISION_FLOAT;
    uint64_t got;
    carom_joint_desc d;
    carom_joint joint;
    assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
    assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SOLVER, solver, NULL), CAROM_OK);
    assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_PRECISION, precision, NULL), CAROM_OK);
    assert_int_equal(carom_collider_set_surface_velocity(b.world, b.ground_collider, belt, turn, NULL), CAROM_OK);
    assert_int_equal(carom_collider_set_surface_velocity(b.world, b.colliders[3], turn, belt, NULL), CAROM_OK);
    assert_int_equal(carom_body_set_gravity_factor(b.world, b.bodies[0], 0.75, NULL), CAROM_OK);
    assert_int_equal(carom_body_set_locks(b.world, b.bodies[1], CAROM_LOCK_PLANE, NULL), CAROM_OK);
    assert_int_equal(carom_body_set_locks(b.world, b.bodies[3], CAROM_LOCK_LINEAR_X | CAROM_LOCK_ANGULAR_Y, NULL),
                     CAROM_OK);
    carom_joint_desc_init(&d, sizeof d);
    d.kind = CAROM_JOINT_BALL, d.fields = CAROM_JOINT_WORLD_FRAME;
    d.body_a = b.bodies[1], d.body_b = b.bodies[2], d.position_a[0] = 1.25, d.position_a[1] = 2;
    assert_int_equal(carom_joint_create(b.world, &d, &joint, NULL), CAROM_OK);
    assert_int_equal(steps_of(b.world, 200, NULL), CAROM_OK);
    got = bench_hash(b.world);
    wrong += got != golden[i];
    if (got != golden[i])
      print_error("solver %u, precision %u: 0x%016llx\n", solver, precision, (unsigned long long)got);
    assert_int_equal(bench_free(&b), CAROM_OK);
  }
  assert_int_equal(wrong, 0);
}

/* The same of a heap so large that its bodies are halved into regions, on one to three threads: soft_step
 * with contacts in doubles, auto, and soft_step with contacts in floats. 40 steps. */
static void so_are_those_of_heaps(void** state) {
  const uint64_t golden[3] = {0x1bb554cd8d1c22a6u, 0x388b317ce6a66f7fu, 0x04d9825aff7885dau};
  const uint32_t solver[3] = {CAROM_SOLVER_SOFT_STEP, CAROM_SOLVER_AUTO, CAROM_SOLVER_SOFT_STEP};
  const uint32_t precision[3] = {CAROM_PRECISION_DOUBLE, CAROM_PRECISION_AUTO, CAROM_PRECISION_FLOAT};
  int i, k, wrong = 0;
  (void)state;
  for (i = 0; i < 3; ++i) {
    Bench b;
    carom_jobs_desc jobs;
    carom_body body;
    carom_collider collider;
    uint64_t got;
    memset(&b, 0, sizeof b);
    assert_int_equal(carom_engine_create(NULL, &b.engine, NULL), CAROM_OK);
    carom_jobs_desc_init(&jobs, sizeof jobs);
    jobs.threads = (uint32_t)(1 + (i + detour) % 3);
#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
    jobs.threads = 1; /* there are no more */
#endif
    assert_int_equal(carom_engine_set_jobs(b.engine, &jobs, NULL), CAROM_OK);
    assert_int_equal(bench_shapes(&b, NULL), CAROM_OK);
    assert_int_equal(carom_world_create(b.engine, NULL, &b.world, NULL), CAROM_OK);
    assert_int_equal(bench_bodies(&b, NULL), CAROM_OK);
    assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SOLVER, solver[i], NULL), CAROM_OK);
    assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_PRECISION, precision[i], NULL), CAROM_OK);
    for (k = 0; k < 7 * 7 * 12; ++k)
      assert_int_equal(bench_body(b.world, k % 3 ? b.crate : b.ball, b.material, CAROM_BODY_DYNAMIC,
                                  4 + 1.0625 * (k % 7) + 0.03125 * (k % 5), 0.375 + 0.625 * (k / 49),
                                  1.5625 * (k / 7 % 7) + 0.03125 * (k % 3), &body, &collider, NULL),
                       CAROM_OK);
    assert_int_equal(steps_of(b.world, 40, NULL), CAROM_OK);
    got = bench_hash(b.world);
    wrong += got != golden[i];
    if (got != golden[i]) print_error("heap %d: 0x%016llx\n", i, (unsigned long long)got);
    assert_int_equal(bench_free(&b), CAROM_OK);
  }
  assert_int_equal(wrong, 0);
}

/* And all of these with a restore in the middle. */
static void a_restore_changes_no_bit(void** state) {
  detour = 1;
  the_bits_are_those_of_every_other_build(state);
  so_are_those_of_particles(state);
  so_are_those_of_joints(state);
  so_are_those_of_factors_locks_and_belts(state);
  so_are_those_of_heaps(state);
  detour = 0;
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(the_same_scene_twice_gives_the_same_bits),
      cmocka_unit_test(the_hash_tells_one_step_and_one_dial_from_another),
      cmocka_unit_test(addresses_and_what_memory_held_do_not_matter),
      cmocka_unit_test(handle_numbers_do_not_matter),
      cmocka_unit_test(the_bits_are_those_of_every_other_build),
      cmocka_unit_test(so_are_those_of_particles),
      cmocka_unit_test(so_are_those_of_joints),
      cmocka_unit_test(so_are_those_of_factors_locks_and_belts),
      cmocka_unit_test(so_are_those_of_heaps),
      cmocka_unit_test(a_restore_changes_no_bit),
  };
  return cmocka_run_group_tests_name("determinism/same_bits", tests, NULL, NULL);
}
