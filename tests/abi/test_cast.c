/* Casts through the interface: rays, batches of them at any stride and in float, shape casts, times of impact, overlap. */
#include "bench.h"
#include "carom_test.h"

static const double zero[3] = {0, 0, 0}, upright[4] = {0, 0, 0, 1};

static carom_cast fresh(void) {
  carom_cast r;
  memset(&r, 0, sizeof r);
  r.struct_size = sizeof r;
  return r;
}

static int near_to(double x, double y, double error) { return fabs(x - y) <= error; }

static void a_ray_meets_a_crate_and_says_where(void** state) {
  Bench b;
  carom_cast r = fresh();
  carom_cast_desc desc;
  const double position[3] = {1, 2, 3}, quarter[4] = {0, 0, 0.70710678118654752, 0.70710678118654752};
  const double origin[3] = {1, 10, 3}, down[3] = {0, -2, 0}, up[3] = {0, 2, 0};
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  /* Half extents 0.5, 0.25, 0.75; a quarter turn about z stands x up. */
  assert_int_equal(carom_ray_cast(b.engine, b.crate, position, quarter, origin, down, 100, NULL, &r, NULL), CAROM_OK);
  assert_int_equal(r.outcome, CAROM_CAST_HIT);
  assert_int_equal(r.status, CAROM_QUERY_EXACT_ENOUGH);
  assert_true(r.lower <= 3.75 && 3.75 <= r.upper && r.lower <= r.time && r.time <= r.upper &&
              near_to(r.time, 3.75, 1e-13));
  assert_true(near_to(r.point_b[1], 2.5, 1e-12) && near_to(r.point_a[1], 2.5, 1e-12) &&
              near_to(r.point_b[0], 1, 1e-12));
  assert_true(near_to(r.normal[1], -1, 1e-12) && r.support_calls == 0 && r.slack > 0 && r.slack < 1e-12);
  carom_cast_desc_init(&desc, sizeof desc);
  desc.flags = CAROM_ASK_GENERIC; /* without the routine of boxes */
  assert_int_equal(carom_ray_cast(b.engine, b.crate, position, quarter, origin, down, 100, &desc, &r, NULL), CAROM_OK);
  assert_true(r.outcome == CAROM_CAST_HIT && near_to(r.time, 3.75, 1e-13) && r.support_calls > 0);
  desc.flags = CAROM_ASK_IGNORE_TOUCHED;
  assert_int_equal(carom_ray_cast(b.engine, b.crate, position, quarter, position, up, 1, &desc, &r, NULL), CAROM_OK);
  assert_int_equal(r.outcome, CAROM_CAST_MISS);
  assert_int_equal(carom_ray_cast(b.engine, b.crate, position, quarter, origin, up, HUGE_VAL, NULL, &r, NULL),
                   CAROM_OK);
  assert_int_equal(r.outcome, CAROM_CAST_MISS);
  assert_int_equal(carom_ray_cast(b.engine, b.crate, position, quarter, position, up, 1, NULL, &r, NULL), CAROM_OK);
  assert_int_equal(r.outcome, CAROM_CAST_OVERLAP);
  assert_true(r.time == 0 && r.upper == 0);
  assert_int_equal(carom_ray_cast(b.engine, b.floor, zero, upright, origin, down, 100, NULL, &r, NULL), CAROM_OK);
  assert_true(r.outcome == CAROM_CAST_HIT && near_to(r.time, 5, 1e-13));
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void shapes_are_cast_and_meet_in_time(void** state) {
  Bench b;
  carom_cast r = fresh();
  carom_cast_desc desc;
  carom_motion still, rod;
  const double above[3] = {0, 5, 0}, motion[3] = {0, -10, 0}, beside[3] = {0.1, 0.2, 0};
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  carom_cast_desc_init(&desc, sizeof desc);
  assert_int_equal(carom_shape_cast(b.engine, b.ball, above, upright, motion, b.crate, zero, upright, NULL, &r, NULL),
                   CAROM_OK);
  assert_true(r.outcome == CAROM_CAST_HIT && near_to(r.time, 0.425, 1e-12) && near_to(r.normal[1], -1, 1e-12));
  assert_true(near_to(r.point_a[1], 0.25, 1e-11) && near_to(r.point_b[1], 0.25, 1e-11));
  desc.target = 0.25;
  assert_int_equal(carom_shape_cast(b.engine, b.ball, above, upright, motion, b.crate, zero, upright, &desc, &r, NULL),
                   CAROM_OK);
  assert_true(r.outcome == CAROM_CAST_HIT && near_to(r.time, 0.4, 1e-12) && r.separation == 0.25);
  assert_int_equal(carom_shape_cast(b.engine, b.ball, beside, upright, motion, b.crate, zero, upright, NULL, &r, NULL),
                   CAROM_OK);
  assert_true(r.outcome == CAROM_CAST_OVERLAP && near_to(r.separation, -0.55, 1e-5));

  /* A crate that turns about its end strikes the floor: its corner, 1 m and 0.25 m from the centre of rotation. */
  carom_motion_init(&still, sizeof still);
  carom_motion_init(&rod, sizeof rod);
  rod.position[0] = 0.5;
  rod.position[1] = 0.9;
  rod.center[0] = -0.5;
  rod.angular_velocity[2] = -2;
  assert_int_equal(carom_shape_time_of_impact(b.engine, b.crate, &rod, b.floor, &still, 10, NULL, &r, NULL), CAROM_OK);
  assert_int_equal(r.outcome, CAROM_CAST_HIT);
  { /* lowest when turned by t: sin t + 0.25 cos t = 0.9 */
    const double truth = (asin(0.9 / sqrt(1.0625)) - atan(0.25)) / 2;
    assert_true(r.lower <= truth && truth <= r.upper && r.upper - r.lower < 1e-5 && near_to(r.normal[1], -1, 1e-12));
  }
  rod.angular_velocity[2] = 0;
  assert_int_equal(carom_shape_time_of_impact(b.engine, b.crate, &rod, b.floor, &still, 10, NULL, &r, NULL), CAROM_OK);
  assert_int_equal(r.outcome, CAROM_CAST_MISS);
  assert_true(r.lower == 10);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void overlap_comes_with_its_proof(void** state) {
  Bench b;
  carom_overlap r;
  const double apart[3] = {0, 1, 0}, in[3] = {0.25, 0.25, 0};
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  r.struct_size = sizeof r;
  assert_int_equal(carom_shape_overlap(b.engine, b.ball, apart, upright, b.crate, zero, upright, NULL, &r, NULL),
                   CAROM_OK);
  assert_true(r.outcome == CAROM_OVERLAP_APART && r.separation_bound > 0 && r.separation_bound <= 0.25 &&
              r.normal[1] < 0);
  assert_int_equal(carom_shape_overlap(b.engine, b.ball, in, upright, b.crate, zero, upright, NULL, &r, NULL),
                   CAROM_OK);
  assert_int_equal(r.outcome, CAROM_OVERLAP_OVERLAPPING);
  assert_true(fabs(r.point[0]) <= 0.5 && fabs(r.point[1]) <= 0.25 && fabs(r.point[2]) <= 0.75);
  assert_true(hypot(r.point[0] - 0.25, r.point[1] - 0.25) <= 0.5);
  assert_int_equal(carom_shape_overlap(b.engine, b.ball, in, upright, b.floor, zero, upright, NULL, &r, NULL),
                   CAROM_OK);
  assert_int_equal(r.outcome, CAROM_OVERLAP_OVERLAPPING);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

#define RAYS 64

static void a_batch_answers_as_single_rays_do(void** state) {
  Bench b;
  carom_shape shapes[3];
  double positions[9] = {0, 0, 0, 2, 0, 0, 0, -1, 0};
  const double orientations[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  struct {
    double o[3], d[3], max, canary;
  } in[RAYS];
  carom_ray_hit hits[RAYS];
  double times[RAYS];
  uint32_t met[RAYS], outcomes[RAYS], i, k;
  carom_rays rays;
  carom_ray_hits out;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  shapes[0] = b.ball, shapes[1] = b.crate, shapes[2] = b.floor;
  for (i = 0; i < RAYS; ++i) {
    in[i].o[0] = -3 + 0.1 * i, in[i].o[1] = 3, in[i].o[2] = 0.01 * i;
    in[i].d[0] = 0.05 * i, in[i].d[1] = i % 5 ? -1 : 1, in[i].d[2] = 0;
    in[i].max = i % 7 ? 10 : 2;
  }
  in[5].o[1] = HUGE_VAL - HUGE_VAL; /* NaN */
  in[6].max = -1;
  in[7].d[0] = HUGE_VAL;
  memset(&rays, 0, sizeof rays);
  rays.struct_size = sizeof rays;
  rays.scalar = CAROM_SCALAR_F64;
  rays.count = RAYS;
  rays.origins = in[0].o, rays.directions = in[0].d, rays.max = &in[0].max;
  rays.origin_stride = rays.direction_stride = rays.max_stride = sizeof in[0];
  memset(&out, 0, sizeof out);
  out.struct_size = sizeof out;
  out.scalar = CAROM_SCALAR_F64;
  out.records = hits, out.times = times, out.shapes = met, out.outcomes = outcomes;
  assert_int_equal(carom_rays_cast(b.engine, shapes, positions, orientations, 3, &rays, NULL, &out, NULL), CAROM_OK);
  for (i = 0; i < RAYS; ++i) {
    double soonest = HUGE_VAL;
    uint32_t first = CAROM_NO_SHAPE;
    if (i >= 5 && i <= 7) {
      assert_true(hits[i].outcome == CAROM_CAST_BAD_RAY && met[i] == CAROM_NO_SHAPE && times[i] == 0);
      continue;
    }
    for (k = 0; k < 3; ++k) {
      carom_cast r = fresh();
      assert_int_equal(
          carom_ray_cast(b.engine, shapes[k], positions + 3 * k, upright, in[i].o, in[i].d, in[i].max, NULL, &r, NULL),
          CAROM_OK);
      if (r.outcome != CAROM_CAST_MISS && r.time < soonest) soonest = r.time, first = k;
    }
    assert_int_equal(met[i], first);
    assert_int_equal(hits[i].shape, first);
    assert_int_equal(hits[i].outcome, outcomes[i]);
    assert_true(times[i] == hits[i].time && times[i] == (first == CAROM_NO_SHAPE ? in[i].max : soonest));
  }
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void a_batch_takes_and_gives_floats_and_prefixes(void** state) {
  Bench b;
  float origins[RAYS][3], directions[RAYS][3], times[RAYS], normals[RAYS][3], points[RAYS][3];
  struct {
    uint32_t outcome, status, shape, reserved;
    double time;
  } prefix[RAYS];
  carom_rays rays;
  carom_ray_hits out;
  uint32_t i, hits = 0;
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  for (i = 0; i < RAYS; ++i) {
    origins[i][0] = -1 + (float)i / 32, origins[i][1] = 2, origins[i][2] = 0;
    directions[i][0] = 0, directions[i][1] = -4, directions[i][2] = 0;
  }
  memset(&rays, 0, sizeof rays);
  rays.struct_size = sizeof rays;
  rays.count = RAYS; /* scalar: float, as zero says */
  rays.origins = origins, rays.directions = directions;
  memset(&out, 0, sizeof out);
  out.struct_size = sizeof out;
  out.times = times, out.normals = normals, out.points = points;
  out.records = (carom_ray_hit*)(void*)prefix, out.record_stride = sizeof *prefix;
  assert_int_equal(carom_rays_cast(b.engine, &b.ball, zero, upright, 1, &rays, NULL, &out, NULL), CAROM_OK);
  for (i = 0; i < RAYS; ++i) {
    const double x = origins[i][0];
    if (fabs(x) > 0.5) {
      assert_true(prefix[i].outcome == CAROM_CAST_MISS && times[i] == 1 && points[i][0] == 0);
      continue;
    }
    if (fabs(x) == 0.5) continue; /* a tangent may go either way */
    ++hits;
    assert_int_equal(prefix[i].outcome, CAROM_CAST_HIT);
    assert_true(near_to(times[i], (2 - sqrt(0.25 - x * x)) / 4, 1e-7) && times[i] == (float)prefix[i].time);
    assert_true(near_to(points[i][0], x, 1e-7) && near_to(normals[i][0], -2 * x, 1e-6));
  }
  assert_true(hits > 25);
  rays.count = 0; /* nothing to do, nothing needed */
  rays.origins = rays.directions = NULL;
  assert_int_equal(carom_rays_cast(b.engine, NULL, NULL, NULL, 0, &rays, NULL, &out, NULL), CAROM_OK);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/* Lies once asked often enough: making the shape comes first. */
static int calls_left = 1 << 30;
static int32_t tiring(void* user, const double* params, uint64_t count, const double dir[3], double out[3]) {
  (void)user;
  return --calls_left < 0 ? 5 : bench_box(NULL, params, count, dir, out);
}

static void a_fault_is_a_status_and_spoils_no_other_ray(void** state) {
  Bench b;
  carom_shape_plugin plugin = bench_plugin("test.tiring", bench_box_params, 3, NULL, tiring);
  const double half[3] = {0.5, 0.5, 0.5}, origins[6] = {0, 5, 0, 10, 5, 0}, down[6] = {0, -9, 0, 0, -9, 0};
  const double positions[6] = {0, 0, 0, 10, 0, 0}, orientations[8] = {0, 0, 0, 1, 0, 0, 0, 1};
  carom_plugin handle;
  carom_shape shapes[2];
  carom_ray_hit hits[2];
  carom_rays rays;
  carom_ray_hits out;
  carom_cast r = fresh();
  (void)state;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  calls_left = 1 << 30;
  assert_int_equal(carom_plugin_register(b.engine, &plugin, &handle, NULL), CAROM_OK);
  assert_int_equal(carom_shape_create(b.engine, handle, half, 3, &shapes[0], NULL), CAROM_OK);
  shapes[1] = b.ball;
  calls_left = 0;
  assert_int_equal(carom_ray_cast(b.engine, shapes[0], zero, upright, origins, down, 1, NULL, &r, NULL), CAROM_OK);
  assert_int_equal(r.status, CAROM_QUERY_FAULT);
  memset(&rays, 0, sizeof rays);
  rays.struct_size = sizeof rays;
  rays.scalar = CAROM_SCALAR_F64;
  rays.count = 2;
  rays.origins = origins, rays.directions = down;
  memset(&out, 0, sizeof out);
  out.struct_size = sizeof out;
  out.records = hits;
  assert_int_equal(carom_rays_cast(b.engine, shapes, positions, orientations, 2, &rays, NULL, &out, NULL), CAROM_OK);
  assert_true(hits[0].status == CAROM_QUERY_FAULT && hits[0].shape == 0);
  assert_true(hits[1].status == CAROM_QUERY_EXACT_ENOUGH && hits[1].shape == 1 && hits[1].outcome == CAROM_CAST_HIT);
  /* Nothing stays pinned. */
  assert_int_equal(carom_shape_destroy(b.engine, shapes[0], NULL), CAROM_OK);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(a_ray_meets_a_crate_and_says_where),
      cmocka_unit_test(shapes_are_cast_and_meet_in_time),
      cmocka_unit_test(overlap_comes_with_its_proof),
      cmocka_unit_test(a_batch_answers_as_single_rays_do),
      cmocka_unit_test(a_batch_takes_and_gives_floats_and_prefixes),
      cmocka_unit_test(a_fault_is_a_status_and_spoils_no_other_ray),
  };
  return cmocka_run_group_tests_name("abi/cast", tests, NULL, NULL);
}
