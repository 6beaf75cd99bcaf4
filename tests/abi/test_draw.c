/* Debug draw: the lines there should be, where they should be, and nothing changed by looking. */
#include "bench.h"
#include "carom_test.h"

#define MOST 4096

static carom_draw_line lines[MOST];

static uint64_t drawn(carom_world* world, uint32_t what, uint32_t colouring) {
  carom_draw_desc d;
  uint64_t count = 0;
  assert_int_equal(carom_draw_desc_init(&d, sizeof d), CAROM_OK);
  d.what = what, d.colouring = colouring, d.scale = 0.25;
  assert_int_equal(carom_world_draw(world, &d, lines, 0, MOST, &count, NULL), CAROM_OK);
  assert_true(count <= MOST);
  return count;
}

static double length(const carom_draw_line* l) {
  const double x = l->to[0] - l->from[0], y = l->to[1] - l->from[1], z = l->to[2] - l->from[2];
  return sqrt(x * x + y * y + z * z);
}

/* A floor, three balls of radius 0.5, a crate of half extents 0.5, 0.25, 0.75. */
static void shapes_are_outlined(void** state) {
  Bench b;
  uint64_t i, n, of_crate = 0, of_balls = 0;
  double edges = 0;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  n = drawn(b.world, CAROM_DRAW_SHAPES, CAROM_DRAW_BY_TYPE);
  for (i = 0; i < n; i++) {
    assert_int_equal(lines[i].kind, CAROM_DRAW_SHAPES);
    if (lines[i].body == b.bodies[3]) {
      of_crate++, edges += length(&lines[i]);
    } else {
      double p[3], d = 0;
      int k;
      assert_int_equal(carom_world_read(b.world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, &lines[i].body, 1, p, 0, NULL),
                       CAROM_OK);
      for (k = 0; k < 3; k++) d += (lines[i].from[k] - p[k]) * (lines[i].from[k] - p[k]);
      assert_true(fabs(sqrt(d) - 0.5) < 1e-12); /* on the ball */
      of_balls++;
    }
  }
  assert_true(of_crate == 12 && fabs(edges - 4 * (1 + 0.5 + 1.5)) < 1e-12);
  assert_true(of_balls == 3 * 3 * 32);
  assert_int_equal(drawn(b.world, CAROM_DRAW_BOUNDS, CAROM_DRAW_BY_TYPE), 4 * 12); /* none of the floor */
  assert_int_equal(drawn(b.world, CAROM_DRAW_BODIES, CAROM_DRAW_BY_TYPE), 5 * 3);
  assert_int_equal(drawn(b.world, CAROM_DRAW_SCENERY, CAROM_DRAW_BY_TYPE), 0);
  assert_int_equal(drawn(b.world, 0, CAROM_DRAW_BY_TYPE), 0);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void scenery_has_each_side_once(void** state) {
  Bench b;
  const double xyz[12] = {0, 0, 0, 0, 0, 1, 1, 0, 1, 1, 0, 0};
  const uint32_t corners[6] = {0, 1, 2, 0, 2, 3};
  carom_mesh_desc d;
  carom_shape mesh;
  carom_body_desc bd;
  carom_collider_desc cd;
  carom_body body;
  carom_collider collider;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  carom_mesh_desc_init(&d, sizeof d), d.vertices = xyz, d.vertex_count = 4, d.triangles = corners, d.triangle_count = 2;
  assert_int_equal(carom_shape_create_mesh(b.engine, &d, &mesh, NULL), CAROM_OK);
  carom_body_desc_init(&bd, sizeof bd), bd.type = CAROM_BODY_STATIC, carom_collider_desc_init(&cd, sizeof cd),
                                        cd.shape = mesh;
  assert_int_equal(carom_body_create(b.world, &bd, &body, NULL), CAROM_OK);
  assert_int_equal(carom_collider_create(b.world, body, &cd, &collider, NULL), CAROM_OK);
  assert_int_equal(drawn(b.world, CAROM_DRAW_SCENERY, CAROM_DRAW_BY_TYPE), 5);
  assert_true(lines[0].body == body);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void contacts_joints_and_islands_are_told_apart(void** state) {
  Bench b;
  carom_joint_desc jd;
  carom_joint joint;
  carom_contact contacts[32];
  uint64_t i, n, count = 0;
  uint32_t colour[4] = {0, 0, 0, 0};
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  carom_joint_desc_init(&jd, sizeof jd);
  jd.kind = CAROM_JOINT_BALL, jd.fields = CAROM_JOINT_WORLD_FRAME, jd.body_a = b.bodies[0], jd.body_b = b.bodies[1];
  jd.position_a[1] = 1.25;
  assert_int_equal(carom_joint_create(b.world, &jd, &joint, NULL), CAROM_OK);
  assert_int_equal(drawn(b.world, CAROM_DRAW_JOINTS, CAROM_DRAW_BY_TYPE), 7);
  assert_true(fabs(lines[0].from[1] - 1.25) < 1e-12 && fabs(length(&lines[0]) - 0.25) < 1e-12);
  assert_true(lines[0].colour != lines[1].colour && lines[6].body == b.bodies[1]);
  n = drawn(b.world, CAROM_DRAW_SHAPES, CAROM_DRAW_BY_ISLAND);
  for (i = 0; i < n; i++) {
    int k;
    for (k = 0; k < 4; k++)
      if (lines[i].body == b.bodies[k]) colour[k] = lines[i].colour;
  }
  assert_true(colour[0] == colour[1] && colour[1] != colour[2] && colour[2] != colour[3]);
  for (i = 0; i < 240; i++) assert_int_equal(carom_world_step(b.world, 1.0 / 60, NULL), CAROM_OK);
  assert_int_equal(carom_world_get_contacts(b.world, contacts, sizeof *contacts, 32, &count, NULL), CAROM_OK);
  assert_true(count > 0 && count <= 32);
  assert_int_equal(drawn(b.world, CAROM_DRAW_CONTACTS, CAROM_DRAW_BY_TYPE), count);
  for (i = 0; i < count; i++) {
    assert_true(lines[i].from[1] == contacts[i].point[1] && lines[i].body == contacts[i].body_b);
    assert_true(fabs(length(&lines[i]) - 0.25) < 1e-12);
  }
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void looking_changes_nothing_and_bad_wishes_are_refused(void** state) {
  Bench b;
  carom_draw_desc d;
  carom_error error = CAROM_ERROR_INIT;
  uint64_t before = 0, after = 0, count = 77, all;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_world_hash(b.world, &before, NULL), CAROM_OK);
  all = drawn(b.world, 63, CAROM_DRAW_BY_ISLAND);
  assert_int_equal(carom_world_hash(b.world, &after, NULL), CAROM_OK);
  assert_true(before == after);
  /* as many as there is room for; without a place, their number */
  carom_draw_desc_init(&d, sizeof d), d.what = 63;
  lines[3].colour = 12345;
  assert_int_equal(carom_world_draw(b.world, &d, lines, sizeof *lines, 3, &count, NULL), CAROM_OK);
  assert_true(count == all && lines[3].colour == 12345);
  assert_int_equal(carom_world_draw(b.world, &d, NULL, 0, 0, &count, NULL), CAROM_OK);
  assert_true(count == all);
  assert_int_equal(carom_world_draw(b.world, NULL, NULL, 0, 0, &count, NULL), CAROM_OK);
  assert_true(count == 12 + 3 * 3 * 32);

#define REFUSED(change, code)                              \
  (carom_draw_desc_init(&d, sizeof d), change, count = 77, \
   assert_int_equal(carom_world_draw(b.world, &d, lines, 0, MOST, &count, &error), code), assert_true(count == 77))
  REFUSED(d.what = 64, CAROM_E_UNSUPPORTED);
  REFUSED(d.reserved = 1, CAROM_E_UNSUPPORTED);
  REFUSED(d.colouring = 2, CAROM_E_UNKNOWN_ENUM);
  REFUSED(d.scale = 0, CAROM_E_OUT_OF_RANGE);
  REFUSED(d.scale = NAN, CAROM_E_NOT_FINITE);
  REFUSED(d.struct_size = 2, CAROM_E_STRUCT_SIZE);
  carom_draw_desc_init(&d, sizeof d);
  assert_int_equal(carom_world_draw(NULL, &d, lines, 0, MOST, &count, NULL), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_world_draw(b.world, &d, lines, 0, MOST, NULL, NULL), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_world_draw(b.world, &d, lines, 7, MOST, &count, NULL), CAROM_E_BUFFER_TOO_SMALL);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(shapes_are_outlined),
      cmocka_unit_test(scenery_has_each_side_once),
      cmocka_unit_test(contacts_joints_and_islands_are_told_apart),
      cmocka_unit_test(looking_changes_nothing_and_bad_wishes_are_refused),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
