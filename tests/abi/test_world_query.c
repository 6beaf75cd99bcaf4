/* Questions to a world through the interface: single and in batches, in float and double, at any stride, first, any and
 * all, truncated lists, moving shapes, overlap, nearest, and what is passed over. */
#include "bench.h"
#include "carom_test.h"

static const double upright[4] = {0, 0, 0, 1};

static int near_to(double x, double y, double error) { return fabs(x - y) <= error; }

/* The stage: floor y <= 0, balls of radius 0.5 at (0, 1, 0), (0.75, 1.5, 0.125), (1.5, 2, 0.25), a crate of half extents
 * 0.5, 0.25, 0.75 at (2.25, 2.5, 0.375). */

static void one_ray_meets_what_is_first(void** state) {
  Bench b;
  carom_world_hit hit;
  carom_query_desc desc;
  const double from[3] = {-5, 1, 0}, along[3] = {2, 0, 0}, above[3] = {2.25, 10, 0.375}, down[3] = {0, -1, 0};
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  memset(&hit, 0xff, sizeof hit);
  assert_int_equal(carom_world_cast_ray(b.world, from, along, 10, NULL, &hit, sizeof hit, NULL), CAROM_OK);
  assert_true(hit.outcome == CAROM_CAST_HIT && hit.status == CAROM_QUERY_EXACT_ENOUGH && hit.query == 0);
  assert_true(hit.collider == b.colliders[0] && hit.body == b.bodies[0]);
  assert_true(hit.lower <= 2.25 && 2.25 <= hit.upper && near_to(hit.time, 2.25, 1e-12));
  assert_true(near_to(hit.normal[0], 1, 1e-12) && near_to(hit.point[0], -0.5, 1e-12) && hit.point[1] == 1);

  assert_int_equal(carom_query_desc_init(&desc, sizeof desc), CAROM_OK);
  desc.ignore = b.bodies[0];
  assert_int_equal(carom_world_cast_ray(b.world, from, along, 10, &desc, &hit, sizeof hit, NULL), CAROM_OK);
  assert_true(hit.outcome == CAROM_CAST_MISS && hit.time == 10); /* it passes the next by hypot(0.5, 0.125) > 0.5 */

  assert_int_equal(carom_world_cast_ray(b.world, above, down, 100, NULL, &hit, sizeof hit, NULL), CAROM_OK);
  assert_true(hit.collider == b.colliders[3] && near_to(hit.time, 7.25, 1e-12));
  desc.flags = CAROM_ASK_GENERIC;
  desc.ignore = b.bodies[3];
  assert_int_equal(carom_world_cast_ray(b.world, above, down, 100, &desc, &hit, sizeof hit, NULL), CAROM_OK);
  assert_true(hit.collider == b.ground_collider && hit.body == b.ground && near_to(hit.time, 10, 1e-12));
  desc.mask = ~(uint64_t)1; /* nobody has another category yet */
  assert_int_equal(carom_world_cast_ray(b.world, above, down, 100, &desc, &hit, sizeof hit, NULL), CAROM_OK);
  assert_true(hit.outcome == CAROM_CAST_MISS && hit.collider == CAROM_NULL_HANDLE && hit.time == 100);

  /* A body that moved is met where it is now; one that is gone, no more. */
  {
    const double far[3] = {-3, 1, 0};
    assert_int_equal(carom_body_set_pose(b.world, b.bodies[2], far, upright, NULL), CAROM_OK);
    assert_int_equal(carom_world_cast_ray(b.world, from, along, 10, NULL, &hit, sizeof hit, NULL), CAROM_OK);
    assert_true(hit.collider == b.colliders[2] && near_to(hit.time, 0.75, 1e-12));
    assert_int_equal(carom_body_destroy(b.world, b.bodies[2], NULL), CAROM_OK);
    assert_int_equal(carom_world_cast_ray(b.world, from, along, 10, NULL, &hit, sizeof hit, NULL), CAROM_OK);
    assert_true(hit.collider == b.colliders[0]);
  }
  assert_int_equal(bench_free(&b), CAROM_OK);
}

#define RAYS 40

static void batches_answer_as_single_rays_do(void** state) {
  Bench b;
  struct {
    float o[3], d[3], max, canary;
  } in[RAYS];
  struct {
    carom_world_hit hit;
    double canary;
  } out[RAYS];
  uint32_t outcomes[RAYS], any[RAYS], i, hits_seen = 0;
  carom_collider met[RAYS];
  float times[RAYS];
  carom_world_hit all[RAYS * 5], few[7];
  uint64_t count, again, k;
  carom_rays rays;
  carom_world_hits hits;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  for (i = 0; i < RAYS; ++i) {
    in[i].o[0] = -1 + 0.1f * (float)i, in[i].o[1] = 8, in[i].o[2] = 0.01f * (float)i;
    in[i].d[0] = 0.01f * (float)i, in[i].d[1] = i % 5 ? -1 : 1, in[i].d[2] = 0;
    in[i].max = i == 11 ? -1.0f : 20.0f;
    in[i].canary = 7;
    out[i].canary = 8;
  }
  memset(&rays, 0, sizeof rays);
  rays.struct_size = sizeof rays;
  rays.scalar = CAROM_SCALAR_F32;
  rays.count = RAYS;
  rays.origins = in[0].o;
  rays.directions = in[0].d;
  rays.max = &in[0].max;
  rays.origin_stride = rays.direction_stride = rays.max_stride = sizeof in[0];
  memset(&hits, 0, sizeof hits);
  hits.struct_size = sizeof hits;
  hits.scalar = CAROM_SCALAR_F32;
  hits.records = &out[0].hit;
  hits.record_stride = sizeof out[0];
  hits.outcomes = outcomes;
  hits.colliders = met;
  hits.times = times;
  assert_int_equal(carom_world_cast_rays(b.world, &rays, CAROM_WANT_FIRST, NULL, &hits, NULL), CAROM_OK);
  for (i = 0; i < RAYS; ++i) {
    double o[3], d[3];
    carom_world_hit one;
    int c;
    assert_true(out[i].canary == 8 && out[i].hit.query == i && outcomes[i] == out[i].hit.outcome);
    assert_true(met[i] == out[i].hit.collider && times[i] == (float)out[i].hit.time);
    if (i == 11) {
      assert_int_equal(outcomes[i], CAROM_CAST_BAD_RAY);
      continue;
    }
    for (c = 0; c < 3; ++c) o[c] = in[i].o[c], d[c] = in[i].d[c];
    assert_int_equal(carom_world_cast_ray(b.world, o, d, in[i].max, NULL, &one, sizeof one, NULL), CAROM_OK);
    one.query = i;
    assert_memory_equal(&one, &out[i].hit, sizeof one);
    hits_seen += one.outcome == CAROM_CAST_HIT;
  }
  assert_true(hits_seen > 25);

  /* Whether: the same yes and no. */
  memset(&hits, 0, sizeof hits);
  hits.struct_size = sizeof hits;
  hits.outcomes = any;
  assert_int_equal(carom_world_cast_rays(b.world, &rays, CAROM_WANT_ANY, NULL, &hits, NULL), CAROM_OK);
  for (i = 0; i < RAYS; ++i) assert_int_equal(any[i], outcomes[i]);

  /* All: counted first, then written; the first of each ray is the first; too little room is told. */
  assert_int_equal(carom_world_cast_rays_all(b.world, &rays, NULL, NULL, 0, 0, &count, NULL), CAROM_OK);
  assert_true(count > hits_seen && count <= RAYS * 5);
  assert_int_equal(carom_world_cast_rays_all(b.world, &rays, NULL, all, sizeof all[0], RAYS * 5, &again, NULL),
                   CAROM_OK);
  assert_true(again == count);
  for (k = 0; k < count; ++k) {
    const int first = k == 0 || all[k].query != all[k - 1].query;
    if (first)
      assert_memory_equal(&all[k], &out[all[k].query].hit, sizeof all[k]);
    else
      assert_true(all[k].time >= all[k - 1].time && all[k].query >= all[k - 1].query);
  }
  assert_int_equal(carom_world_cast_rays_all(b.world, &rays, NULL, few, sizeof few[0], 7, &again, NULL), CAROM_OK);
  assert_true(again == count);
  assert_memory_equal(few, all, sizeof few);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void shapes_are_cast_placed_and_measured(void** state) {
  Bench b;
  carom_shape shapes[3];
  const double positions[9] = {0, 5, 0, 2.25, 8, 0.375, 9, 9, 9}, motions[9] = {0, -10, 0, 0, -10, 0, 0, 1, 0};
  carom_query_shapes ask;
  carom_world_hit hit[3], all[9];
  carom_query_desc desc;
  uint64_t count;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  shapes[0] = b.ball, shapes[1] = b.crate, shapes[2] = CAROM_NULL_HANDLE;
  memset(&ask, 0, sizeof ask);
  ask.struct_size = sizeof ask;
  ask.scalar = CAROM_SCALAR_F64;
  ask.count = 3;
  ask.shapes = shapes;
  ask.positions = positions;
  ask.motions = motions;
  assert_int_equal(carom_world_cast_shapes(b.world, &ask, CAROM_WANT_FIRST, NULL, hit, 0, NULL), CAROM_OK);
  /* Ball on ball: from 5 down to 2 m above the floor, were there no other: that at (0.75, 1.5) is met first. */
  {
    const double beside = sqrt(0.75 * 0.75 + 0.125 * 0.125), drop = 5 - (1.5 + sqrt(1 - beside * beside));
    assert_true(hit[0].outcome == CAROM_CAST_HIT && hit[0].collider == b.colliders[1]);
    assert_true(near_to(hit[0].time, drop / 10, 1e-7) && hit[0].normal[1] < 0);
  }
  assert_true(hit[1].outcome == CAROM_CAST_HIT && hit[1].collider == b.colliders[3] && near_to(hit[1].time, 0.5, 1e-9));
  assert_true(hit[2].outcome == CAROM_CAST_MISS && hit[2].query == 2 && hit[2].time == 1);
  assert_int_equal(carom_world_cast_shapes(b.world, &ask, CAROM_WANT_ANY, NULL, hit, 0, NULL), CAROM_OK);
  assert_true(hit[0].outcome == CAROM_CAST_HIT && hit[1].outcome == CAROM_CAST_HIT &&
              hit[2].outcome == CAROM_CAST_MISS);
  assert_int_equal(carom_world_cast_shapes_all(b.world, &ask, NULL, all, sizeof all[0], 9, &count, NULL), CAROM_OK);
  assert_true(count >= 5 && all[0].collider == b.colliders[1] && all[1].collider == b.colliders[0]);

  /* Overlap: the crate where its twin is, and everything near a ball that counts from 1 m on. */
  ask.motions = NULL;
  {
    const double here[9] = {2.25, 2.5, 0.375, 0, 3, 0, 0, 0.25, 0};
    shapes[0] = b.crate, shapes[1] = b.ball;
    ask.positions = here;
    assert_int_equal(carom_world_overlap_shapes(b.world, &ask, NULL, all, sizeof all[0], 9, &count, NULL), CAROM_OK);
    /* the crate reaches the third ball, too; the ball touches nothing; the point is above the floor */
    assert_true(count >= 1 && all[0].query == 0);
    carom_query_desc_init(&desc, sizeof desc);
    desc.target = 0.75;
    ask.count = 1;
    ask.positions = here + 3;
    ask.shapes = shapes + 1;
    assert_int_equal(carom_world_overlap_shapes(b.world, &ask, &desc, all, sizeof all[0], 9, &count, NULL), CAROM_OK);
    /* 3 - 1 - 1 = 1 m from the first, hypot(0.75, 1.5, 0.125) - 1 = 0.68 m from the second, 0.82 m from the third */
    assert_true(count == 1 && all[0].collider == b.colliders[1] && all[0].outcome == CAROM_CAST_OVERLAP);

    assert_int_equal(carom_world_find_nearest(b.world, &ask, HUGE_VAL, NULL, hit, 0, NULL), CAROM_OK);
    assert_true(hit[0].collider == b.colliders[1] && hit[0].outcome == CAROM_CAST_HIT);
    assert_true(near_to(hit[0].separation, sqrt(0.75 * 0.75 + 1.5 * 1.5 + 0.125 * 0.125) - 1, 1e-6));
    assert_true(hit[0].lower <= hit[0].separation && hit[0].separation <= hit[0].upper);
    assert_int_equal(carom_world_find_nearest(b.world, &ask, 0.5, NULL, hit, 0, NULL), CAROM_OK);
    assert_int_equal(hit[0].outcome, CAROM_CAST_MISS);
    ask.shapes = NULL; /* points */
    ask.positions = here + 6;
    assert_int_equal(carom_world_find_nearest(b.world, &ask, 1, NULL, hit, 0, NULL), CAROM_OK);
    assert_true(
        near_to(hit[0].separation, 0.25, 1e-9)); /* 0.25 m above the floor and below the first ball: the lower slot */
    assert_true(hit[0].collider == b.ground_collider);
  }
  assert_int_equal(bench_free(&b), CAROM_OK);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(one_ray_meets_what_is_first),
      cmocka_unit_test(batches_answer_as_single_rays_do),
      cmocka_unit_test(shapes_are_cast_placed_and_measured),
  };
  return cmocka_run_group_tests_name("abi/world_query", tests, NULL, NULL);
}
