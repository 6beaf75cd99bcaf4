/* What a body is and has, set and read one thing a call: poses, velocities, masses, kinds, damping, colliders. */
#include "bench.h"
#include "carom_test.h"

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

static double height(const Bench* b, int i) {
  double p[3];
  assert_int_equal(carom_body_get_pose(b->world, b->bodies[i], p, NULL, NULL), CAROM_OK);
  return p[1];
}

static void poses_and_velocities_are_those_of_the_descriptor(void** state) {
  Bench* b = *state;
  carom_body_desc d;
  double p[3], q[4], v[3], w[3];
  assert_int_equal(bench_steps(b->world, 70, NULL), CAROM_OK); /* the box topples */
  d.struct_size = sizeof d;
  assert_int_equal(carom_body_get(b->world, b->bodies[3], &d, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_pose(b->world, b->bodies[3], p, q, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_velocity(b->world, b->bodies[3], v, w, NULL), CAROM_OK);
  assert_memory_equal(p, d.position, sizeof p);
  assert_memory_equal(q, d.orientation, sizeof q);
  assert_memory_equal(v, d.linear_velocity, sizeof v);
  assert_memory_equal(w, d.angular_velocity, sizeof w);
  assert_int_equal(carom_body_get_pose(b->world, b->bodies[3], NULL, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_velocity(b->world, b->bodies[3], NULL, NULL, NULL), CAROM_OK);
}

/* A mass that is given acts: the same push moves a body that is twice as heavy half as fast. */
static void masses_are_given_and_taken_back(void** state) {
  Bench* b = *state;
  const double push[3] = {3, 0, 0}, zero[3] = {0, 0, 0}, tensor[9] = {2, 0, 0, 0, 3, 0, 0, 0, 4};
  const double off[3] = {0.1, 0, 0};
  double mass, of_density, center[3], inertia[9], own[9], p[3], after[3], v[3], w[3];
  int i;
  assert_int_equal(carom_world_set_gravity(b->world, zero, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_mass(b->world, b->bodies[3], &of_density, center, own, NULL), CAROM_OK);
  assert_true(fabs(of_density - 1000 * 1 * 0.5 * 1.5) < 1e-9 && center[0] == 0);
  assert_int_equal(carom_body_set_mass(b->world, b->bodies[3], 2 * of_density, NULL, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_mass(b->world, b->bodies[3], &mass, NULL, inertia, NULL), CAROM_OK);
  assert_true(mass == 2 * of_density);
  for (i = 0; i < 9; ++i) assert_true(fabs(inertia[i] - 2 * own[i]) <= 1e-12 * own[0]);
  assert_int_equal(carom_body_set_mass(b->world, b->bodies[3], 5, off, tensor, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_mass(b->world, b->bodies[3], &mass, center, inertia, NULL), CAROM_OK);
  assert_true(mass == 5 && center[0] == 0.1);
  assert_memory_equal(inertia, tensor, sizeof tensor);
  assert_int_equal(carom_body_get_pose(b->world, b->bodies[3], p, NULL, NULL), CAROM_OK);
  after[0] = p[0] + 0.1, after[1] = p[1], after[2] = p[2]; /* the centre now, so nothing turns */
  assert_int_equal(carom_body_add_impulse(b->world, b->bodies[3], push, after, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_velocity(b->world, b->bodies[3], v, w, NULL), CAROM_OK);
  assert_true(fabs(v[0] - 0.6) < 1e-15 && fabs(w[1]) < 1e-15 && fabs(w[2]) < 1e-15);
  assert_int_equal(carom_body_set_mass(b->world, b->bodies[3], 0, NULL, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_mass(b->world, b->bodies[3], &mass, NULL, inertia, NULL), CAROM_OK);
  assert_true(mass == of_density);
  assert_memory_equal(inertia, own, sizeof own);
}

static void wrong_masses_change_nothing(void** state) {
  Bench* b = *state;
  const double slanted[9] = {2, 1, 0, 0, 3, 0, 0, 0, 4}, negative[9] = {-1, 0, 0, 0, 1, 0, 0, 0, 1},
               off[3] = {0.1, 0, 0};
  double before, after;
  carom_error e = CAROM_ERROR_INIT;
  assert_int_equal(carom_body_get_mass(b->world, b->bodies[0], &before, NULL, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_mass(b->world, b->bodies[0], -1, NULL, NULL, &e), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(e.argument, 3);
  assert_int_equal(carom_body_set_mass(b->world, b->bodies[0], 1e-310, NULL, NULL, &e), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_body_set_mass(b->world, b->bodies[0], 0, off, NULL, &e), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_body_set_mass(b->world, b->bodies[0], 1, NULL, slanted, &e), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(e.argument, 5);
  assert_int_equal(carom_body_set_mass(b->world, b->bodies[0], 1, NULL, negative, &e), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_body_set_mass(b->world, b->ground, 1, NULL, NULL, &e), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(e.argument, 2);
  assert_int_equal(carom_body_get_mass(b->world, b->bodies[0], &after, NULL, NULL, NULL), CAROM_OK);
  assert_true(before == after);
}

/* What is static stands in the air, what is kinematic goes its way, what is dynamic again falls, g t^2 / 2 to a step.
 */
static void kinds_change_and_act(void** state) {
  Bench* b = *state;
  const double up[3] = {0, 1, 0}, zero[3] = {0, 0, 0};
  double before = height(b, 0), mass;
  uint32_t type;
  int i;
  for (i = 0; i < 2; ++i) { /* while it moves, and from rest */
    assert_int_equal(bench_steps(b->world, 5, NULL), CAROM_OK);
    assert_int_equal(carom_body_set_type(b->world, b->bodies[0], CAROM_BODY_STATIC, NULL), CAROM_OK);
    assert_int_equal(carom_body_get_type(b->world, b->bodies[0], &type, NULL), CAROM_OK);
    assert_int_equal(type, CAROM_BODY_STATIC);
    before = height(b, 0);
    assert_int_equal(bench_steps(b->world, 30, NULL), CAROM_OK);
    assert_true(height(b, 0) == before);
  }
  assert_int_equal(carom_body_set_type(b->world, b->bodies[0], CAROM_BODY_KINEMATIC, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_velocity(b->world, b->bodies[0], up, zero, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b->world, 64, NULL), CAROM_OK); /* 1 s */
  assert_true(fabs(height(b, 0) - before - 1) < 1e-9);
  assert_int_equal(carom_body_set_type(b->world, b->bodies[0], CAROM_BODY_DYNAMIC, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_mass(b->world, b->bodies[0], &mass, NULL, NULL, NULL), CAROM_OK);
  assert_true(fabs(mass - 4 * M_PI / 3 * 125) < 1e-6);
  assert_int_equal(carom_body_set_velocity(b->world, b->bodies[0], zero, zero, NULL), CAROM_OK);
  before = height(b, 0);
  assert_int_equal(bench_steps(b->world, 16, NULL), CAROM_OK);
  assert_true(fabs(before - height(b, 0) - 9.81 * 0.25 * 0.25 / 2) < 9.81 * 0.25 / 64);
}

/* What lies on a body that becomes static goes on lying on it; what slept wakes where its ground gives way. */
static void neighbours_of_what_changes_its_kind_notice(void** state) {
  Bench* b = *state;
  const double half[3] = {0.5, 0.5, 0.5}, at[3] = {5, 0.5, 0}, above[3] = {5, 1.5, 0}, start[3] = {5, 3, 0};
  const double q[4] = {0, 0, 0, 1};
  carom_body below = 0, on = 0;
  double p[3];
  uint32_t asleep;
  (void)half;
  assert_int_equal(carom_world_set_dial(b->world, CAROM_DIAL_SLEEP, 1, NULL), CAROM_OK);
  assert_int_equal(carom_body_create_named(b->world, CAROM_BODY_STATIC, "test.box", half, 3, at, &below, NULL),
                   CAROM_OK);
  assert_int_equal(carom_body_create_named(b->world, CAROM_BODY_DYNAMIC, "test.box", half, 3, above, &on, NULL),
                   CAROM_OK);
  assert_int_equal(bench_steps(b->world, 240, NULL), CAROM_OK);
  assert_int_equal(carom_body_is_asleep(b->world, on, &asleep, NULL), CAROM_OK);
  assert_int_equal(asleep, 1);
  assert_int_equal(carom_body_set_pose(b->world, below, start, q, NULL), CAROM_OK); /* static things that move wake */
  assert_int_equal(carom_body_set_type(b->world, below, CAROM_BODY_DYNAMIC, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b->world, 240, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_pose(b->world, on, p, NULL, NULL), CAROM_OK);
  assert_true(fabs(p[1] - 0.5) < 0.01);
  assert_int_equal(carom_body_get_pose(b->world, below, p, NULL, NULL), CAROM_OK);
  assert_true(fabs(p[1] - 1.5) < 0.02);
  assert_int_equal(bench_steps(b->world, 240, NULL),
                   CAROM_OK); /* both asleep: the lower one becomes static, the upper falls not */
  assert_int_equal(carom_body_set_type(b->world, on, CAROM_BODY_STATIC, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b->world, 60, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_pose(b->world, below, p, NULL, NULL), CAROM_OK);
  assert_true(fabs(p[1] - 1.5) < 0.02);
}

static void kinds_that_do_not_fit_are_refused(void** state) {
  Bench* b = *state;
  carom_joint_desc d;
  carom_joint joint;
  carom_spring_desc tie;
  carom_spring spring;
  carom_error e = CAROM_ERROR_INIT;
  assert_int_equal(carom_body_set_type(b->world, b->ground, CAROM_BODY_KINEMATIC, &e), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_body_set_type(b->world, b->bodies[0], 3, &e), CAROM_E_UNKNOWN_ENUM);
  assert_int_equal(carom_joint_desc_init(&d, sizeof d), CAROM_OK);
  d.kind = CAROM_JOINT_BALL, d.body_a = CAROM_NULL_HANDLE, d.body_b = b->bodies[0];
  assert_int_equal(carom_joint_create(b->world, &d, &joint, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_type(b->world, b->bodies[0], CAROM_BODY_STATIC, &e), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(e.argument, 3);
  assert_int_equal(carom_joint_destroy(b->world, joint, NULL), CAROM_OK);
  assert_int_equal(carom_spring_desc_init(&tie, sizeof tie), CAROM_OK);
  tie.body_a = b->bodies[0];
  assert_int_equal(carom_spring_create(b->world, &tie, &spring, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_type(b->world, b->bodies[0], CAROM_BODY_KINEMATIC, &e), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_spring_destroy(b->world, spring, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_type(b->world, b->bodies[0], CAROM_BODY_STATIC, NULL), CAROM_OK);
}

/* v = v_0 exp(-c t), exactly. */
static void damping_acts(void** state) {
  Bench* b = *state;
  const double zero[3] = {0, 0, 0}, v0[3] = {0, 0, 2}, alone[3] = {20, 5, 0};
  const double q[4] = {0, 0, 0, 1};
  double v[3], linear, angular;
  uint64_t user;
  assert_int_equal(carom_world_set_gravity(b->world, zero, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_pose(b->world, b->bodies[1], alone, q, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_damping(b->world, b->bodies[1], 0.75, 0.25, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_damping(b->world, b->bodies[1], &linear, &angular, NULL), CAROM_OK);
  assert_true(linear == 0.75 && angular == 0.25);
  assert_int_equal(carom_body_set_damping(b->world, b->bodies[1], -1, 0, NULL), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_body_set_velocity(b->world, b->bodies[1], v0, zero, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b->world, 64, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_velocity(b->world, b->bodies[1], v, NULL, NULL), CAROM_OK);
  assert_true(fabs(v[2] - 2 * exp(-0.75)) < 1e-12);
  assert_int_equal(carom_body_set_user(b->world, b->bodies[1], 77, NULL), CAROM_OK);
  assert_int_equal(carom_body_get_user(b->world, b->bodies[1], &user, NULL), CAROM_OK);
  assert_int_equal(user, 77);
}

/* A world is copied whatever was changed of its bodies, and the copy steps as it does. */
static void copies_have_what_was_changed(void** state) {
  Bench* b = *state;
  carom_world* copy = NULL;
  const double down[3] = {0, -0.25, 0}, q[4] = {0, 0, 0, 1};
  int i;
  for (i = 0; i < 2; ++i) { /* a world that was copied before, too */
    assert_int_equal(carom_body_set_mass(b->world, b->bodies[0], 3 + i, NULL, NULL, NULL), CAROM_OK);
    assert_int_equal(carom_body_set_damping(b->world, b->bodies[1], 0.5 + i, 0, NULL), CAROM_OK);
    assert_int_equal(carom_body_set_type(b->world, b->bodies[0], i ? CAROM_BODY_DYNAMIC : CAROM_BODY_STATIC, NULL),
                     CAROM_OK);
    if (!i) assert_int_equal(carom_body_set_type(b->world, b->bodies[0], CAROM_BODY_DYNAMIC, NULL), CAROM_OK);
    assert_int_equal(carom_collider_set_density(b->world, b->colliders[2], 100 + i, NULL), CAROM_OK);
    assert_int_equal(carom_collider_set_material(b->world, b->colliders[2], i ? b->material : CAROM_NULL_HANDLE, NULL),
                     CAROM_OK);
    assert_int_equal(carom_collider_set_pose(b->world, b->colliders[3], down, q, NULL), CAROM_OK);
    assert_int_equal(bench_steps(b->world, 10, NULL), CAROM_OK);
    assert_int_equal(carom_world_fork(b->world, &copy, NULL), CAROM_OK);
    assert_int_equal(bench_steps(b->world, 30, NULL), CAROM_OK);
    assert_int_equal(bench_steps(copy, 30, NULL), CAROM_OK);
    assert_true(bench_hash(b->world) == bench_hash(copy));
    assert_int_equal(carom_world_destroy(copy, NULL), CAROM_OK);
  }
}

/* Surfaces, densities and places of colliders: ice lets slide, a shape that is moved touches elsewhere. */
static void colliders_are_changed_in_place(void** state) {
  Bench* b = *state;
  carom_collider found[2] = {0, 0};
  carom_collider_desc d;
  carom_body owner;
  uint64_t count = 0;
  const double down[3] = {0, -0.25, 0}, q[4] = {0, 0, 0, 1};
  double mass, center[3], p[3];
  assert_int_equal(carom_body_get_colliders(b->world, b->bodies[0], found, 2, &count, NULL), CAROM_OK);
  assert_int_equal(count, 1);
  assert_true(found[0] == b->colliders[0] && found[1] == 0);
  assert_int_equal(carom_body_get_colliders(b->world, b->bodies[0], NULL, 0, &count, NULL), CAROM_OK);
  assert_int_equal(carom_collider_set_material(b->world, found[0], CAROM_NULL_HANDLE, NULL), CAROM_OK);
  assert_int_equal(carom_collider_set_density(b->world, found[0], 500, NULL), CAROM_OK);
  assert_int_equal(carom_collider_set_pose(b->world, found[0], down, q, NULL), CAROM_OK);
  d.struct_size = sizeof d;
  assert_int_equal(carom_collider_get(b->world, found[0], &d, &owner, NULL), CAROM_OK);
  assert_true(d.material == CAROM_NULL_HANDLE && d.density == 500 && d.position[1] == -0.25 && owner == b->bodies[0]);
  assert_int_equal(carom_body_get_mass(b->world, b->bodies[0], &mass, center, NULL, NULL), CAROM_OK);
  assert_true(fabs(mass - 4 * M_PI / 3 * 0.125 * 500) < 1e-9 && fabs(center[1] + 0.25) < 1e-15);
  assert_int_equal(bench_steps(b->world, 240, NULL),
                   CAROM_OK); /* the ball has radius 0.5 and hangs 0.25 below its body */
  assert_int_equal(carom_body_get_pose(b->world, b->bodies[0], p, NULL, NULL), CAROM_OK);
  assert_true(p[1] > 0.2 && p[1] < 0.8);
  assert_int_equal(carom_collider_destroy(b->world, found[0], NULL), CAROM_OK);
  assert_int_equal(carom_collider_set_density(b->world, found[0], 1, NULL), CAROM_E_STALE_HANDLE);
}

int main(void) {
#define TEST(f) cmocka_unit_test_setup_teardown(f, make, clear)
  const struct CMUnitTest tests[] = {
      TEST(poses_and_velocities_are_those_of_the_descriptor),
      TEST(masses_are_given_and_taken_back),
      TEST(wrong_masses_change_nothing),
      TEST(kinds_change_and_act),
      TEST(neighbours_of_what_changes_its_kind_notice),
      TEST(kinds_that_do_not_fit_are_refused),
      TEST(damping_acts),
      TEST(colliders_are_changed_in_place),
      TEST(copies_have_what_was_changed),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
