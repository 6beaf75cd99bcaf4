/* Meshes and height fields through the interface: made, described, stood on, asked, refused. */
#include "bench.h"
#include "carom_test.h"

#define SIDE 20

static const double upright[4] = {0, 0, 0, 1}, nowhere[3] = {0, 0, 0};

static double vertices[3 * (SIDE + 1) * (SIDE + 1)];
static uint32_t triangles[6 * SIDE * SIDE];

/* A level square of 10 m about the origin. */
static carom_mesh_desc level(void) {
  carom_mesh_desc d;
  uint32_t i, j, t = 0;
  for (j = 0; j <= SIDE; j++)
    for (i = 0; i <= SIDE; i++) {
      double* v = vertices + 3 * (j * (SIDE + 1) + i);
      v[0] = 0.5 * i - 5, v[1] = 0, v[2] = 0.5 * j - 5;
    }
  for (j = 0; j < SIDE; j++)
    for (i = 0; i < SIDE; i++) {
      const uint32_t a = j * (SIDE + 1) + i, c = a + SIDE + 1;
      const uint32_t corners[6] = {a, c, c + 1, a, c + 1, a + 1};
      memcpy(triangles + t, corners, sizeof corners);
      t += 6;
    }
  assert_int_equal(carom_mesh_desc_init(&d, sizeof d), CAROM_OK);
  d.vertices = vertices, d.vertex_count = (SIDE + 1) * (SIDE + 1);
  d.triangles = triangles, d.triangle_count = 2 * SIDE * SIDE;
  return d;
}

static carom_collider put(carom_world* world, carom_shape shape, double y, uint32_t type, carom_body* body) {
  carom_body_desc bd;
  carom_collider_desc cd;
  carom_collider collider = CAROM_NULL_HANDLE;
  carom_body_desc_init(&bd, sizeof bd), bd.type = type, bd.position[0] = 2.1, bd.position[1] = y, bd.position[2] = 3;
  if (type == CAROM_BODY_STATIC) bd.position[0] = bd.position[2] = 0;
  carom_collider_desc_init(&cd, sizeof cd), cd.shape = shape;
  assert_int_equal(carom_body_create(world, &bd, body, NULL), CAROM_OK);
  assert_int_equal(carom_collider_create(world, *body, &cd, &collider, NULL), CAROM_OK);
  return collider;
}

static double height_of(carom_world* world, carom_body body) {
  double p[3];
  assert_int_equal(carom_world_read(world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, &body, 1, p, 0, NULL), CAROM_OK);
  return p[1];
}

static void what_is_known_of_a_mesh(void** state) {
  Bench b;
  carom_mesh_desc d = level();
  carom_shape mesh, ball;
  carom_shape_info info;
  carom_scenery_info scenery;
  double corners[9 * 5];
  uint64_t count, next, at = 0, seen = 0;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  ball = b.ball;
  assert_int_equal(carom_shape_create_mesh(b.engine, &d, &mesh, NULL), CAROM_OK);
  info.struct_size = sizeof info;
  assert_int_equal(carom_shape_get_info(b.engine, mesh, &info, NULL), CAROM_OK);
  assert_true(info.is_scenery == 1 && info.form == CAROM_FORM_NONE && !info.is_half_space && info.volume == 0);
  assert_true(info.aabb_min[0] == -5 && info.aabb_max[2] == 5 && info.aabb_max[1] == 0);
  scenery.struct_size = sizeof scenery;
  assert_int_equal(carom_shape_get_scenery_info(b.engine, mesh, &scenery, NULL), CAROM_OK);
  assert_true(scenery.triangles == 800 && scenery.vertices == 441 && scenery.dropped == 0 &&
              scenery.boundary_edges == 80);
  assert_true(scenery.flags == 0 && scenery.bytes > 10000 && scenery.bytes < 200000);
  count = 0;
  assert_int_equal(carom_shape_get_triangles(b.engine, mesh, 0, NULL, &count, &next, NULL), CAROM_OK);
  assert_true(count == 800 && next == 800);
  while (at < 800) {
    count = 5;
    assert_int_equal(carom_shape_get_triangles(b.engine, mesh, at, corners, &count, &next, NULL), CAROM_OK);
    assert_true(next > at && count == next - at);
    at = next, seen += count;
  }
  assert_true(seen == 800);
  assert_true(corners[36] == 4.5 && corners[37] == 0 && corners[38] == 4.5); /* the last cell's first corner */
  assert_int_equal(carom_shape_get_triangles(b.engine, mesh, 801, corners, &count, &next, NULL), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_shape_get_triangles(b.engine, ball, 0, corners, &count, &next, NULL), CAROM_E_UNSUPPORTED);
  assert_int_equal(carom_shape_get_scenery_info(b.engine, ball, &scenery, NULL), CAROM_E_UNSUPPORTED);
  assert_int_equal(carom_shape_destroy(b.engine, mesh, NULL), CAROM_OK);
  assert_int_equal(carom_shape_get_scenery_info(b.engine, mesh, &scenery, NULL), CAROM_E_STALE_HANDLE);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void bodies_stand_on_it_and_worlds_answer_for_it(void** state) {
  Bench b;
  carom_mesh_desc d = level();
  carom_height_field_desc h;
  carom_shape shapes[2];
  double heights[12];
  int k, i;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_shape_create_mesh(b.engine, &d, &shapes[0], NULL), CAROM_OK);
  assert_int_equal(carom_height_field_desc_init(&h, sizeof h), CAROM_OK);
  for (i = 0; i < 12; i++) heights[i] = 0.5;
  h.columns = 4, h.rows = 3, h.heights = heights, h.spacing[0] = 3, h.spacing[1] = 4;
  assert_int_equal(carom_shape_create_height_field(b.engine, &h, &shapes[1], NULL), CAROM_OK);
  for (k = 0; k < 2; k++) {
    carom_world* world;
    carom_body floor, ball;
    carom_collider ground;
    carom_world_hit hit;
    const double from[3] = {2, 5, 1}, down[3] = {0, -1, 0};
    const double top = k == 0 ? 0 : 0.5;
    assert_int_equal(carom_world_create(b.engine, NULL, &world, NULL), CAROM_OK);
    ground = put(world, shapes[k], 0, CAROM_BODY_STATIC, &floor);
    put(world, b.ball, top + 0.6, CAROM_BODY_DYNAMIC, &ball);
    for (i = 0; i < 120; i++) assert_int_equal(carom_world_step(world, 1.0 / 60, NULL), CAROM_OK);
    assert_true(fabs(height_of(world, ball) - (top + 0.5)) < 1e-3);
    assert_int_equal(carom_world_cast_ray(world, from, down, 100, NULL, &hit, sizeof hit, NULL), CAROM_OK);
    assert_true(hit.outcome == CAROM_CAST_HIT && hit.collider == ground && fabs(hit.time - (5 - top)) < 1e-9);
    assert_true(hit.normal[1] == -1);
    assert_int_equal(carom_shape_destroy(b.engine, shapes[k], NULL), CAROM_E_IN_USE);
    assert_int_equal(carom_world_destroy(world, NULL), CAROM_OK);
  }
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void what_cannot_be_is_refused_and_changes_nothing(void** state) {
  Bench b;
  carom_mesh_desc good = level(), d;
  carom_height_field_desc field, f;
  carom_shape mesh, other = 77;
  carom_error error = CAROM_ERROR_INIT;
  double bad[9] = {0, 0, 0, 1, 0, 0, 0, 0, 1}, heights[4] = {0, 0, 0, 0}, out[3];
  uint32_t corners[3] = {0, 1, 2}, same[3] = {1, 1, 1};
  const double down[3] = {0, -1, 0};
  carom_distance distance;
  carom_cast cast;
  carom_body_desc bd;
  carom_collider_desc cd;
  carom_body body;
  carom_collider collider;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  carom_height_field_desc_init(&field, sizeof field), field.columns = field.rows = 2, field.heights = heights;

#define REFUSED(change, code)                                                                       \
  (d = good, change, assert_int_equal(carom_shape_create_mesh(b.engine, &d, &other, &error), code), \
   assert_true(other == 77), assert_true(error.argument == 2 && strlen(error.remedy) > 10))
  REFUSED(d.struct_size = 3, CAROM_E_STRUCT_SIZE);
  REFUSED(d.flags = 8, CAROM_E_UNSUPPORTED);
  REFUSED(d.vertices = NULL, CAROM_E_NULL_ARGUMENT);
  REFUSED(d.triangles = NULL, CAROM_E_NULL_ARGUMENT);
  REFUSED(d.vertex_count = 2, CAROM_E_OUT_OF_RANGE);
  REFUSED(d.triangle_count = 0, CAROM_E_OUT_OF_RANGE);
  REFUSED(d.triangle_count = (uint64_t)1 << 40, CAROM_E_OUT_OF_RANGE);
  REFUSED(d.vertex_count = 5, CAROM_E_OUT_OF_RANGE); /* an index beyond */
  REFUSED((d.vertices = bad, d.vertex_count = 3, d.triangles = same, d.triangle_count = 1), CAROM_E_OUT_OF_RANGE);
  bad[4] = NAN;
  REFUSED((d.vertices = bad, d.vertex_count = 3, d.triangles = corners, d.triangle_count = 1), CAROM_E_NOT_FINITE);
  bad[4] = 1e9;
  REFUSED((d.vertices = bad, d.vertex_count = 3, d.triangles = corners, d.triangle_count = 1), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_shape_create_mesh(b.engine, NULL, &other, NULL), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_shape_create_mesh(b.engine, &good, NULL, NULL), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_shape_create_mesh(NULL, &good, &other, NULL), CAROM_E_NULL_ARGUMENT);

#define NO_FIELD(change, code)                                                                               \
  (f = field, change, assert_int_equal(carom_shape_create_height_field(b.engine, &f, &other, &error), code), \
   assert_true(other == 77))
  NO_FIELD(f.columns = 1, CAROM_E_OUT_OF_RANGE);
  NO_FIELD(f.rows = 20000, CAROM_E_OUT_OF_RANGE);
  NO_FIELD(f.heights = NULL, CAROM_E_NULL_ARGUMENT);
  NO_FIELD(f.spacing[0] = 0, CAROM_E_OUT_OF_RANGE);
  NO_FIELD(f.spacing[1] = NAN, CAROM_E_NOT_FINITE);
  NO_FIELD(f.flags = 1, CAROM_E_UNSUPPORTED);
  heights[2] = INFINITY;
  NO_FIELD(f.columns = 2, CAROM_E_NOT_FINITE);
  heights[2] = NAN; /* a hole, and nothing else */
  NO_FIELD(f.columns = 2, CAROM_E_OUT_OF_RANGE);

  /* It has no volume, no support points, and asks nothing. */
  assert_int_equal(carom_shape_create_mesh(b.engine, &good, &mesh, NULL), CAROM_OK);
  carom_body_desc_init(&bd, sizeof bd), carom_collider_desc_init(&cd, sizeof cd), cd.shape = mesh;
  assert_int_equal(carom_body_create(b.world, &bd, &body, NULL), CAROM_OK);
  assert_int_equal(carom_collider_create(b.world, body, &cd, &collider, &error), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_shape_support(b.engine, mesh, down, 1, out, NULL), CAROM_E_UNSUPPORTED);
  distance.struct_size = sizeof distance, cast.struct_size = sizeof cast;
  assert_int_equal(
      carom_shape_distance(b.engine, mesh, nowhere, upright, mesh, nowhere, upright, NULL, &distance, NULL),
      CAROM_E_UNSUPPORTED);
  assert_int_equal(
      carom_shape_cast(b.engine, mesh, nowhere, upright, down, b.ball, nowhere, upright, NULL, &cast, NULL),
      CAROM_E_UNSUPPORTED);
  { /* but it is asked */
    const double above[3] = {1, 2, 1};
    assert_int_equal(
        carom_shape_distance(b.engine, b.ball, above, upright, mesh, nowhere, upright, NULL, &distance, NULL),
        CAROM_OK);
    assert_true(fabs(distance.separation - 1.5) < 1e-5 && fabs(distance.normal[1] + 1) < 1e-9);
    assert_int_equal(
        carom_shape_distance(b.engine, mesh, nowhere, upright, b.ball, above, upright, NULL, &distance, NULL),
        CAROM_OK);
    assert_true(fabs(distance.separation - 1.5) < 1e-5 && fabs(distance.normal[1] - 1) < 1e-9);
    assert_int_equal(
        carom_shape_cast(b.engine, b.ball, above, upright, down, mesh, nowhere, upright, NULL, &cast, NULL), CAROM_OK);
    assert_int_equal(cast.outcome, CAROM_CAST_MISS);
  }
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/* A direction of any length: turned into the surface's frame this one would be longer than any number. */
static void it_is_met_however_fast(void** state) {
  static const double turned[4] = {0, 0, 0.38268343236508978, 0.92387953251128674}; /* by 45 degrees about z */
  static const double direction[3] = {1.7e308, -1.7e308, 0}, from[3] = {-1, 1, 0.1};
  Bench b;
  carom_mesh_desc d = level();
  carom_shape surface;
  carom_cast cast;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_shape_create_mesh(b.engine, &d, &surface, NULL), CAROM_OK);
  cast.struct_size = sizeof cast;
  assert_int_equal(carom_ray_cast(b.engine, surface, nowhere, turned, from, direction, 1, NULL, &cast, NULL), CAROM_OK);
  assert_true(cast.outcome == CAROM_CAST_HIT || cast.outcome == CAROM_CAST_UNDECIDED);
  assert_int_equal(
      carom_shape_cast(b.engine, b.ball, from, upright, direction, surface, nowhere, turned, NULL, &cast, NULL),
      CAROM_OK);
  assert_true(cast.outcome != CAROM_CAST_MISS);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/* From beyond the reach of short numbers (1e17 m), and from where sums overflow. */
static void it_answers_from_any_distance(void** state) {
  static const double far[] = {1e16, 1e18, 1e38, 1e100, 1e300, 1.7e308};
  Bench b;
  carom_mesh_desc d = level();
  carom_height_field_desc f;
  double heights[9] = {0};
  carom_shape surface[2];
  uint32_t i, k, s;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_shape_create_mesh(b.engine, &d, &surface[0], NULL), CAROM_OK);
  carom_height_field_desc_init(&f, sizeof f);
  f.columns = f.rows = 3, f.heights = heights;
  assert_int_equal(carom_shape_create_height_field(b.engine, &f, &surface[1], NULL), CAROM_OK);
  for (s = 0; s < 2; s++)
    for (i = 0; i < sizeof far / sizeof *far; i++)
      for (k = 0; k < 6; k++) {
        const double sign = k < 3 ? 1 : -1;
        const int overflows = far[i] >= 1e100; /* its squares do */
        double from[3] = {0.3, 0.3, 0.3}, away[3] = {0, 0, 0}, back[3] = {0, 0, 0};
        carom_cast cast;
        carom_distance distance;
        carom_overlap overlap;
        carom_motion still, flies;
        from[k % 3] = sign * far[i], away[k % 3] = sign, back[k % 3] = -sign;
        cast.struct_size = sizeof cast, distance.struct_size = sizeof distance, overlap.struct_size = sizeof overlap;
        assert_int_equal(
            carom_ray_cast(b.engine, surface[s], nowhere, upright, from, away, INFINITY, NULL, &cast, NULL), CAROM_OK);
        assert_true(cast.outcome == CAROM_CAST_MISS || (overflows && cast.outcome == CAROM_CAST_UNDECIDED));
        assert_int_equal(
            carom_ray_cast(b.engine, surface[s], nowhere, upright, from, back, INFINITY, NULL, &cast, NULL), CAROM_OK);
        if (far[i] == 1e16 && k == 1)
          assert_true(cast.outcome == CAROM_CAST_HIT && fabs(cast.time / far[i] - 1) < 1e-12);
        assert_int_equal(
            carom_ray_cast(b.engine, surface[s], from, upright, nowhere, away, INFINITY, NULL, &cast, NULL), CAROM_OK);
        assert_int_equal(
            carom_shape_cast(b.engine, b.ball, from, upright, away, surface[s], nowhere, upright, NULL, &cast, NULL),
            CAROM_OK);
        assert_true(cast.outcome == CAROM_CAST_MISS || (overflows && cast.outcome == CAROM_CAST_UNDECIDED));
        carom_motion_init(&still, sizeof still), carom_motion_init(&flies, sizeof flies);
        memcpy(flies.position, from, sizeof from), memcpy(flies.linear_velocity, away, sizeof away);
        assert_int_equal(carom_shape_time_of_impact(b.engine, b.ball, &flies, surface[s], &still, 1, NULL, &cast, NULL),
                         CAROM_OK);
        assert_true(cast.outcome == CAROM_CAST_MISS || (overflows && cast.outcome == CAROM_CAST_UNDECIDED));
        assert_int_equal(
            carom_shape_overlap(b.engine, b.ball, from, upright, surface[s], nowhere, upright, NULL, &overlap, NULL),
            CAROM_OK);
        assert_true(overlap.outcome == CAROM_OVERLAP_APART || (overflows && overlap.outcome == CAROM_OVERLAP_TOUCHING));
        assert_int_equal(
            carom_shape_distance(b.engine, b.ball, from, upright, surface[s], nowhere, upright, NULL, &distance, NULL),
            CAROM_OK);
        if (!overflows) assert_true(fabs(distance.separation / far[i] - 1) < 1e-6);
      }
  assert_int_equal(bench_free(&b), CAROM_OK);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(what_is_known_of_a_mesh),
      cmocka_unit_test(bodies_stand_on_it_and_worlds_answer_for_it),
      cmocka_unit_test(what_cannot_be_is_refused_and_changes_nothing),
      cmocka_unit_test(it_answers_from_any_distance),
      cmocka_unit_test(it_is_met_however_fast),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
