/* A client of version 0.9, with declarations of its own: particles. It follows the headers until 1.0 is frozen. */
#include "stage.h"

typedef uint64_t carom_particles;
typedef struct carom_particles_desc {
  uint32_t struct_size;
  uint32_t reserved;
  double gravity_factor;
  double linear_damping;
  double mass;
  uint64_t capacity;
} carom_particles_desc;
int32_t carom_particles_desc_init(carom_particles_desc* desc, uint32_t struct_size);
int32_t carom_particles_create(carom_world* world, const carom_particles_desc* desc, carom_particles* set,
                               carom_error* error);
int32_t carom_particles_destroy(carom_world* world, carom_particles set, carom_error* error);
int32_t carom_particles_get(carom_world* world, carom_particles set, carom_particles_desc* desc, carom_error* error);
int32_t carom_particles_get_count(carom_world* world, carom_particles set, uint64_t* count, carom_error* error);
int32_t carom_particles_add(carom_world* world, carom_particles set, uint64_t n, uint32_t scalar, const void* positions,
                            uint64_t position_stride, const void* velocities, uint64_t velocity_stride,
                            carom_error* error);
int32_t carom_particles_remove(carom_world* world, carom_particles set, const uint32_t* indices, uint64_t n,
                               carom_error* error);
int32_t carom_particles_read(carom_world* world, carom_particles set, uint32_t field, uint32_t scalar,
                             const uint32_t* indices, uint64_t n, void* dst, uint64_t stride, carom_error* error);
int32_t carom_particles_write(carom_world* world, carom_particles set, uint32_t field, uint32_t scalar,
                              const uint32_t* indices, uint64_t n, const void* src, uint64_t stride,
                              carom_error* error);
int32_t carom_particles_update(carom_world* world, carom_particles set, const carom_particles_desc* desc,
                               carom_error* error);
int32_t carom_particles_get_quarantined(carom_world* world, carom_particles set, uint32_t* indices, uint64_t capacity,
                                        uint64_t* count, carom_error* error);
int32_t carom_world_get_particles(carom_world* world, carom_particles* sets, uint64_t capacity, uint64_t* count,
                                  carom_error* error);

int main(void) {
  Stage s;
  carom_particles_desc desc;
  carom_particles set, sets[2];
  uint64_t n = 9;
  uint32_t index = 0;
  const double x[6] = {0, 10, 0, 1, 20, 0}, v[6] = {1, 0, 0, 2, 0, 0};
  double back[6];
  const float up[3] = {0, 5, 0};
  stage_make(&s, 1);
  OK(carom_particles_desc_init(&desc, sizeof desc));
  desc.gravity_factor = 0.5;
  OK(carom_particles_create(s.world, &desc, &set, NULL));
  OK(carom_particles_add(s.world, set, 2, CAROM_SCALAR_F64, x, 0, v, 0, NULL));
  OK(carom_particles_get_count(s.world, set, &n, NULL));
  CHECK(n == 2);
  stage_steps(&s, 100);
  OK(carom_particles_read(s.world, set, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, NULL, 2, back, 0, NULL));
  CHECK(fabs(back[0] - 1) < 1e-9 && fabs(back[3] - 3) < 1e-9);
  CHECK(fabs(back[1] - (10 - 9.81 / 4)) < 0.025 && fabs(back[4] - (20 - 9.81 / 4)) < 0.025);
  OK(carom_particles_write(s.world, set, CAROM_FIELD_LINEAR_VELOCITY, CAROM_SCALAR_F32, &index, 1, up, 0, NULL));
  OK(carom_particles_remove(s.world, set, &index, 1, NULL));
  OK(carom_particles_update(s.world, set, NULL, NULL));
  OK(carom_particles_get(s.world, set, &desc, NULL));
  CHECK(desc.gravity_factor == 1);
  OK(carom_particles_get_quarantined(s.world, set, NULL, 0, &n, NULL));
  CHECK(n == 0);
  OK(carom_world_get_particles(s.world, sets, 2, &n, NULL));
  CHECK(n == 1 && sets[0] == set);
  OK(carom_particles_destroy(s.world, set, NULL));
  stage_end(&s);
  return 0;
}
