/* Couplings as a host uses them: made, read, set anew, saved, recorded, refused; they go with their joints. */
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

static carom_joint join(const Bench* b, uint32_t kind, int body) {
  carom_joint_desc d;
  carom_joint joint = 0;
  assert_int_equal(carom_joint_desc_init(&d, sizeof d), CAROM_OK);
  d.kind = kind, d.body_b = b->bodies[body], d.fields = CAROM_JOINT_WORLD_FRAME;
  d.position_a[0] = 3 * body, d.position_a[1] = 6;
  assert_int_equal(carom_joint_create(b->world, &d, &joint, NULL), CAROM_OK);
  return joint;
}
static carom_joint_coupling coupling_of(carom_joint follower, carom_joint leader) {
  carom_joint_coupling c;
  assert_int_equal(carom_joint_coupling_init(&c, sizeof c), CAROM_OK);
  assert_true(c.struct_size == sizeof c && c.polynomial[1] == 1 && c.polynomial[0] == 0);
  c.follower = follower, c.leader = leader;
  return c;
}
static double off(const Bench* b, carom_joint joint) {
  carom_joint_state s;
  memset(&s, 0, sizeof s);
  s.struct_size = sizeof s;
  assert_int_equal(carom_joint_get_state(b->world, joint, &s, NULL), CAROM_OK);
  assert_true(s.force[0] == 0 && s.force[1] == 0 && s.force[2] == 0);
  return s.gap + s.angle;
}
static uint64_t count_of(const Bench* b) {
  uint64_t n = 99;
  assert_int_equal(carom_world_get_joints(b->world, NULL, 0, &n, NULL), CAROM_OK);
  return n;
}

static void one_joint_follows_another(void** state) {
  Bench* b = *state;
  const carom_joint hinge = join(b, CAROM_JOINT_HINGE, 0), slider = join(b, CAROM_JOINT_SLIDER, 1);
  carom_joint_coupling c = coupling_of(slider, hinge), back;
  carom_joint_desc d;
  carom_joint coupling = 0;
  const double still[3] = {0, 0, 0}, spin[3] = {2, 0, 0};
  c.polynomial[1] = 0.25, c.polynomial[2] = 0.1, c.user = 7;
  assert_int_equal(carom_joint_couple(b->world, &c, &coupling, NULL), CAROM_OK);
  assert_int_equal(count_of(b), 3);
  memset(&back, 0, sizeof back);
  back.struct_size = sizeof back;
  assert_int_equal(carom_joint_get_coupling(b->world, coupling, &back, NULL), CAROM_OK);
  assert_true(back.follower == slider && back.leader == hinge && back.user == 7);
  assert_memory_equal(back.polynomial, c.polynomial, sizeof c.polynomial);
  memset(&d, 0, sizeof d);
  d.struct_size = sizeof d;
  assert_int_equal(carom_joint_get(b->world, coupling, &d, NULL), CAROM_OK);
  assert_int_equal(d.kind, CAROM_JOINT_COUPLING);
  assert_string_equal(carom_joint_kind_name(d.kind), "coupling");
  assert_int_equal(carom_body_set_velocity(b->world, b->bodies[0], still, spin, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b->world, 60, NULL), CAROM_OK);
  assert_true(off(b, coupling) < 1e-6);
  c.follower = c.leader = CAROM_NULL_HANDLE, c.polynomial[1] = -0.5, c.polynomial[2] = 0;
  assert_int_equal(carom_joint_set_coupling(b->world, coupling, &c, NULL), CAROM_OK);
  assert_int_equal(carom_joint_get_coupling(b->world, coupling, &back, NULL), CAROM_OK);
  assert_true(back.polynomial[1] == -0.5 && back.follower == slider);
  assert_int_equal(bench_steps(b->world, 240, NULL), CAROM_OK);
  assert_true(off(b, coupling) < 1e-3); /* led back */
}

static void it_goes_with_its_joints(void** state) {
  Bench* b = *state;
  int k;
  for (k = 0; k < 3; ++k) {
    const carom_joint one = join(b, CAROM_JOINT_HINGE, 0), other = join(b, CAROM_JOINT_HINGE, 1);
    const carom_joint_coupling c = coupling_of(one, other);
    carom_joint coupling = 0;
    carom_joint_state s;
    assert_int_equal(carom_joint_couple(b->world, &c, &coupling, NULL), CAROM_OK);
    assert_int_equal(bench_steps(b->world, 3, NULL), CAROM_OK);
    assert_int_equal(carom_joint_destroy(b->world, k == 0 ? one : k == 1 ? other : coupling, NULL), CAROM_OK);
    s.struct_size = sizeof s;
    assert_int_equal(carom_joint_get_state(b->world, coupling, &s, NULL), CAROM_E_STALE_HANDLE);
    assert_int_equal(count_of(b), k == 2 ? 2 : 1);
    if (k != 0) assert_int_equal(carom_joint_destroy(b->world, one, NULL), CAROM_OK);
    if (k != 1) assert_int_equal(carom_joint_destroy(b->world, other, NULL), CAROM_OK);
    assert_int_equal(bench_steps(b->world, 3, NULL), CAROM_OK);
  }
  assert_int_equal(count_of(b), 0);
}

/* Polynomials are part of snapshots, couplings of whole ones: from there all goes on to the same bits. */
static void snapshots_have_it(void** state) {
  Bench* b = *state;
  static unsigned char bytes[1 << 17];
  uint64_t size, hash;
  const carom_joint hinge = join(b, CAROM_JOINT_HINGE, 0), slider = join(b, CAROM_JOINT_SLIDER, 1);
  carom_joint_coupling c = coupling_of(slider, hinge), back;
  carom_joint coupling = 0;
  carom_world* other = NULL;
  const double still[3] = {0, 0, 0}, spin[3] = {5, 0, 0};
  c.polynomial[1] = 0.25, c.polynomial[3] = 0.01;
  assert_int_equal(carom_joint_couple(b->world, &c, &coupling, NULL), CAROM_OK);
  assert_int_equal(carom_body_set_velocity(b->world, b->bodies[0], still, spin, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b->world, 20, NULL), CAROM_OK);
  assert_int_equal(carom_world_save(b->world, 0, bytes, sizeof bytes, &size, NULL), CAROM_OK);
  assert_int_equal(carom_world_fork(b->world, &other, NULL), CAROM_OK);
  assert_int_equal(bench_steps(b->world, 20, NULL), CAROM_OK);
  hash = bench_hash(b->world);
  assert_int_equal(bench_steps(other, 20, NULL), CAROM_OK);
  assert_true(bench_hash(other) == hash);
  memset(&back, 0, sizeof back);
  back.struct_size = sizeof back;
  assert_int_equal(carom_world_destroy(other, NULL), CAROM_OK);
  c.polynomial[1] = 3;
  assert_int_equal(carom_joint_set_coupling(b->world, coupling, &c, NULL), CAROM_OK);
  assert_true(bench_hash(b->world) != hash);
  assert_int_equal(carom_world_restore(b->world, bytes, size, NULL), CAROM_OK);
  assert_int_equal(carom_joint_get_coupling(b->world, coupling, &back, NULL), CAROM_OK);
  assert_true(back.polynomial[1] == 0.25);
  assert_int_equal(bench_steps(b->world, 20, NULL), CAROM_OK);
  assert_true(bench_hash(b->world) == hash);
  /* What couples other joints is another structure. */
  assert_int_equal(carom_joint_destroy(b->world, coupling, NULL), CAROM_OK);
  c.follower = hinge, c.leader = slider;
  assert_int_equal(carom_joint_couple(b->world, &c, &coupling, NULL), CAROM_OK);
  assert_true(carom_world_restore(b->world, bytes, size, NULL) != CAROM_OK);
}

#define REFUSED(result, change)                                                             \
  do {                                                                                      \
    carom_joint_coupling c = coupling_of(hinge, slider);                                    \
    carom_joint made = 7;                                                                   \
    carom_error e = CAROM_ERROR_INIT;                                                       \
    change;                                                                                 \
    assert_int_equal(carom_joint_couple(b->world, &c, &made, &e), result);                  \
    assert_true(made == 7 && e.code == result && e.argument == 2 && strlen(e.message) > 8); \
    assert_true(bench_hash(b->world) == hash && count_of(b) == 3);                          \
  } while (0)

static void wrong_ones_are_refused(void** state) {
  Bench* b = *state;
  const carom_joint hinge = join(b, CAROM_JOINT_HINGE, 0), slider = join(b, CAROM_JOINT_SLIDER, 1),
                    ball = join(b, CAROM_JOINT_BALL, 2);
  const uint64_t hash = bench_hash(b->world);
  carom_joint_coupling good = coupling_of(hinge, slider);
  carom_joint_desc d;
  carom_joint joint = 7;
  carom_error why = CAROM_ERROR_INIT;
  REFUSED(CAROM_E_OUT_OF_RANGE, c.leader = hinge);
  REFUSED(CAROM_E_UNSUPPORTED, c.leader = ball);
  REFUSED(CAROM_E_UNSUPPORTED, c.follower = ball);
  REFUSED(CAROM_E_INVALID_HANDLE, c.follower = CAROM_NULL_HANDLE);
  REFUSED(CAROM_E_WRONG_KIND, c.leader = b->bodies[0]);
  REFUSED(CAROM_E_NOT_FINITE, c.polynomial[4] = NAN);
  REFUSED(CAROM_E_OUT_OF_RANGE, c.polynomial[0] = 1e10);
  REFUSED(CAROM_E_UNSUPPORTED, c.reserved = 1);
  REFUSED(CAROM_E_STRUCT_SIZE, c.struct_size = 3);
  assert_int_equal(carom_joint_couple(b->world, NULL, &joint, NULL), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_joint_couple(b->world, &good, NULL, NULL), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_joint_couple(NULL, &good, &joint, NULL), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_joint_coupling_init(NULL, sizeof good), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_joint_set_coupling(b->world, ball, &good, &why), CAROM_E_UNSUPPORTED);
  assert_int_equal(carom_joint_get_coupling(b->world, ball, &good, &why), CAROM_E_UNSUPPORTED);
  carom_joint_desc_init(&d, sizeof d);
  d.kind = CAROM_JOINT_COUPLING, d.body_b = b->bodies[3];
  assert_int_equal(carom_joint_create(b->world, &d, &joint, &why), CAROM_E_UNSUPPORTED);
  assert_true(joint == 7 && strstr(why.remedy, "carom_joint_couple") && bench_hash(b->world) == hash);
  good = coupling_of(hinge, slider);
  assert_int_equal(carom_joint_couple(b->world, &good, &joint, NULL), CAROM_OK);
  good.leader = hinge;
  assert_int_equal(carom_joint_set_coupling(b->world, joint, &good, &why), CAROM_E_UNSUPPORTED);
  assert_int_equal(why.argument, 3);
  good = coupling_of(joint, hinge);
  assert_int_equal(carom_joint_couple(b->world, &good, &joint, &why),
                   CAROM_E_UNSUPPORTED); /* a coupling is not coupled */
}

/* A tree with a coupling is a tree yet, and moving its joints leaves the coupling to lead back. */
static void trees_and_moves_go_on(void** state) {
  Bench* b = *state;
  const carom_joint hinge = join(b, CAROM_JOINT_HINGE, 0), other = join(b, CAROM_JOINT_HINGE, 1);
  const carom_joint_coupling c = coupling_of(hinge, other);
  const double place = 0.3;
  carom_joint coupling = 0;
  uint64_t n = 0;
  assert_int_equal(carom_joint_couple(b->world, &c, &coupling, NULL), CAROM_OK);
  assert_int_equal(carom_tree_get_coordinates(b->world, b->bodies[0], NULL, 0, 0, &n, NULL), CAROM_OK);
  assert_int_equal(n, 1);
  assert_int_equal(
      carom_world_write_joints(b->world, CAROM_JOINT_BULK_POSITION, CAROM_SCALAR_F64, &other, 1, &place, 0, NULL),
      CAROM_OK);
  assert_true(fabs(off(b, coupling) - 0.3) < 1e-12);
  assert_int_equal(bench_steps(b->world, 240, NULL), CAROM_OK);
  assert_true(off(b, coupling) < 1e-3);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(one_joint_follows_another, make, clear),
      cmocka_unit_test_setup_teardown(it_goes_with_its_joints, make, clear),
      cmocka_unit_test_setup_teardown(snapshots_have_it, make, clear),
      cmocka_unit_test_setup_teardown(wrong_ones_are_refused, make, clear),
      cmocka_unit_test_setup_teardown(trees_and_moves_go_on, make, clear),
  };
  return cmocka_run_group_tests_name("abi/couplings", tests, NULL, NULL);
}
