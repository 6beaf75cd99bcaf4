/* A client of version 0.9, with declarations of its own: rays and moving shapes. It follows the headers until 1.0 is frozen. */
#include "stage.h"

#define CAROM_CAST_HIT 1u
#define CAROM_OVERLAP_APART 0u
typedef struct carom_cast_desc {
  uint32_t struct_size;
  uint32_t iterations;
  double tolerance;
  double target;
} carom_cast_desc;
typedef struct carom_cast {
  uint32_t struct_size;
  uint32_t outcome;
  uint32_t status;
  uint32_t iterations;
  double time;
  double lower;
  double upper;
  double separation;
  double slack;
  double normal[3];
  double point_a[3];
  double point_b[3];
  uint32_t support_calls;
  uint32_t reserved;
} carom_cast;
typedef struct carom_motion {
  uint32_t struct_size;
  uint32_t reserved;
  double position[3];
  double orientation[4];
  double center[3];
  double linear_velocity[3];
  double angular_velocity[3];
} carom_motion;
typedef struct carom_overlap {
  uint32_t struct_size;
  uint32_t outcome;
  double separation_bound;
  double normal[3];
  double point[3];
  double slack;
  uint32_t support_calls;
  uint32_t reserved;
} carom_overlap;
typedef struct carom_rays {
  uint32_t struct_size;
  uint32_t scalar;
  uint64_t count;
  const void* origins;
  const void* directions;
  const void* max;
  uint64_t origin_stride;
  uint64_t direction_stride;
  uint64_t max_stride;
} carom_rays;
typedef struct carom_ray_hit {
  uint32_t outcome;
  uint32_t status;
  uint32_t shape;
  uint32_t reserved;
  double time;
  double lower;
  double upper;
  double normal[3];
  double point[3];
} carom_ray_hit;
typedef struct carom_ray_hits {
  uint32_t struct_size;
  uint32_t scalar;
  carom_ray_hit* records;
  uint32_t* outcomes;
  uint32_t* shapes;
  void* times;
  void* normals;
  void* points;
  uint64_t record_stride;
  uint64_t outcome_stride;
  uint64_t shape_stride;
  uint64_t time_stride;
  uint64_t normal_stride;
  uint64_t point_stride;
} carom_ray_hits;
int32_t carom_cast_desc_init(carom_cast_desc* desc, uint32_t struct_size);
int32_t carom_motion_init(carom_motion* motion, uint32_t struct_size);
int32_t carom_ray_cast(carom_engine* engine, carom_shape shape, const double position[3], const double orientation[4],
                       const double origin[3], const double direction[3], double max, const carom_cast_desc* desc,
                       carom_cast* result, carom_error* error);
int32_t carom_shape_cast(carom_engine* engine, carom_shape shape_a, const double position_a[3],
                         const double orientation_a[4], const double motion[3], carom_shape shape_b,
                         const double position_b[3], const double orientation_b[4], const carom_cast_desc* desc,
                         carom_cast* result, carom_error* error);
int32_t carom_shape_time_of_impact(carom_engine* engine, carom_shape shape_a, const carom_motion* motion_a,
                                   carom_shape shape_b, const carom_motion* motion_b, double duration,
                                   const carom_cast_desc* desc, carom_cast* result, carom_error* error);
int32_t carom_shape_overlap(carom_engine* engine, carom_shape shape_a, const double position_a[3],
                            const double orientation_a[4], carom_shape shape_b, const double position_b[3],
                            const double orientation_b[4], const carom_cast_desc* desc, carom_overlap* result,
                            carom_error* error);
int32_t carom_rays_cast(carom_engine* engine, const carom_shape* shapes, const double* positions,
                        const double* orientations, uint64_t shape_count, const carom_rays* rays,
                        const carom_cast_desc* desc, const carom_ray_hits* hits, carom_error* error);

int main(void) {
  Stage s;
  carom_error error = CAROM_ERROR_INIT;
  carom_cast_desc desc;
  carom_cast hit;
  carom_motion moves, rests;
  carom_overlap overlap;
  carom_rays rays;
  carom_ray_hits hits;
  carom_ray_hit records[2];
  const double here[3] = {0, 0, 0}, far[3] = {3, 0, 0}, upright[4] = {0, 0, 0, 1}, to_far[3] = {6, 0, 0};
  const float origins[6] = {-2, 0, 0, -2, 2, 0}, directions[6] = {1, 0, 0, 1, 0, 0}, most[2] = {9, 9};

  stage_make(&s, 1);
  OK(carom_cast_desc_init(&desc, sizeof desc));
  hit.struct_size = sizeof hit;
  OK(carom_ray_cast(s.engine, s.ball, far, upright, here, to_far, 1, &desc, &hit, &error));
  CHECK(hit.outcome == CAROM_CAST_HIT && fabs(hit.time - 2.5 / 6) < 1e-6 && hit.normal[0] > 0.99);
  OK(carom_shape_cast(s.engine, s.ball, here, upright, to_far, s.ball, far, upright, NULL, &hit, &error));
  CHECK(hit.outcome == CAROM_CAST_HIT && fabs(hit.time - 2. / 6) < 1e-6 && hit.lower <= hit.time &&
        hit.time <= hit.upper);
  OK(carom_motion_init(&moves, sizeof moves));
  OK(carom_motion_init(&rests, sizeof rests));
  moves.linear_velocity[0] = 1, rests.position[0] = 3;
  OK(carom_shape_time_of_impact(s.engine, s.ball, &moves, s.ball, &rests, 10, NULL, &hit, &error));
  CHECK(hit.outcome == CAROM_CAST_HIT && fabs(hit.time - 2) < 1e-5);
  overlap.struct_size = sizeof overlap;
  OK(carom_shape_overlap(s.engine, s.ball, here, upright, s.ball, far, upright, NULL, &overlap, &error));
  CHECK(overlap.outcome == CAROM_OVERLAP_APART && overlap.separation_bound > 0 && overlap.separation_bound <= 2);

  memset(&rays, 0, sizeof rays);
  memset(&hits, 0, sizeof hits);
  rays.struct_size = sizeof rays, rays.scalar = CAROM_SCALAR_F32, rays.count = 2;
  rays.origins = origins, rays.directions = directions, rays.max = most;
  hits.struct_size = sizeof hits, hits.scalar = CAROM_SCALAR_F64, hits.records = records;
  OK(carom_rays_cast(s.engine, &s.ball, here, upright, 1, &rays, NULL, &hits, &error));
  CHECK(records[0].outcome == CAROM_CAST_HIT && fabs(records[0].time - 1.5) < 1e-6 && records[0].shape == 0);
  CHECK(records[1].outcome != CAROM_CAST_HIT);
  stage_end(&s);
  return 0;
}
