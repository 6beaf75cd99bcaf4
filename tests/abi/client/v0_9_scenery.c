/* A client of version 0.9, with declarations of its own: scenery, locks, weights, sweeps, moving surfaces, drawing. It follows the headers until 1.0 is frozen. */
#include "stage.h"

typedef struct carom_mesh_desc {
  uint32_t struct_size;
  uint32_t flags;
  const double* vertices;
  uint64_t vertex_count;
  const uint32_t* triangles;
  uint64_t triangle_count;
} carom_mesh_desc;
typedef struct carom_height_field_desc {
  uint32_t struct_size;
  uint32_t flags;
  uint32_t columns;
  uint32_t rows;
  const double* heights;
  double spacing[2];
} carom_height_field_desc;
typedef struct carom_scenery_info {
  uint32_t struct_size;
  uint32_t flags;
  uint64_t triangles;
  uint64_t vertices;
  uint64_t dropped;
  uint64_t boundary_edges;
  uint64_t bytes;
} carom_scenery_info;
int32_t carom_mesh_desc_init(carom_mesh_desc* desc, uint32_t struct_size);
int32_t carom_height_field_desc_init(carom_height_field_desc* desc, uint32_t struct_size);
int32_t carom_shape_create_mesh(carom_engine* engine, const carom_mesh_desc* desc, carom_shape* shape,
                                carom_error* error);
int32_t carom_shape_create_height_field(carom_engine* engine, const carom_height_field_desc* desc, carom_shape* shape,
                                        carom_error* error);
int32_t carom_shape_get_scenery_info(carom_engine* engine, carom_shape shape, carom_scenery_info* info,
                                     carom_error* error);
int32_t carom_shape_get_triangles(carom_engine* engine, carom_shape shape, uint64_t first, double* corners,
                                  uint64_t* count, uint64_t* next, carom_error* error);
#define CAROM_LOCK_LINEAR_X 0x1u
int32_t carom_body_set_locks(carom_world* world, carom_body body, uint32_t locks, carom_error* error);
int32_t carom_body_get_locks(carom_world* world, carom_body body, uint32_t* locks, carom_error* error);
int32_t carom_body_set_gravity_factor(carom_world* world, carom_body body, double factor, carom_error* error);
int32_t carom_body_get_gravity_factor(carom_world* world, carom_body body, double* factor, carom_error* error);
#define CAROM_CONTINUOUS_ALWAYS 1u
int32_t carom_body_set_continuous(carom_world* world, carom_body body, uint32_t mode, carom_error* error);
int32_t carom_body_get_continuous(carom_world* world, carom_body body, uint32_t* mode, carom_error* error);
int32_t carom_collider_set_surface_velocity(carom_world* world, carom_collider collider, const double linear[3],
                                            const double angular[3], carom_error* error);
int32_t carom_collider_get_surface_velocity(carom_world* world, carom_collider collider, double linear[3],
                                            double angular[3], carom_error* error);
typedef struct carom_draw_desc {
  uint32_t struct_size;
  uint32_t what;
  uint32_t colouring;
  uint32_t reserved;
  double scale;
} carom_draw_desc;
typedef struct carom_draw_line {
  double from[3], to[3];
  uint32_t colour;
  uint32_t kind;
  carom_body body;
} carom_draw_line;
int32_t carom_draw_desc_init(carom_draw_desc* desc, uint32_t struct_size);
int32_t carom_world_draw(carom_world* world, const carom_draw_desc* desc, carom_draw_line* dst, uint64_t stride,
                         uint64_t capacity, uint64_t* count, carom_error* error);

int main(void) {
  Stage s;
  carom_mesh_desc mesh;
  carom_height_field_desc field;
  carom_scenery_info info;
  carom_shape level, hills;
  carom_collider_desc part;
  carom_collider collider;
  carom_body light;
  carom_draw_desc draw;
  carom_draw_line lines[4];
  uint64_t n = 0, next = 0, room = 4;
  uint32_t bits = 0;
  double factor = 0, at[3], corners[36], v[3], w[3];
  const double square[12] = {-50, 2, -50, -50, 2, 50, 50, 2, 50, 50, 2, -50}, heights[4] = {0, 0, 0, 0};
  const uint32_t triangles[6] = {0, 1, 2, 0, 2, 3};
  const double belt[3] = {1, 0, 0}, still[3] = {0, 0, 0}, push[3] = {3, 0, 0};

  stage_make(&s, 4);
  OK(carom_mesh_desc_init(&mesh, sizeof mesh));
  mesh.vertices = square, mesh.vertex_count = 4, mesh.triangles = triangles, mesh.triangle_count = 2;
  OK(carom_shape_create_mesh(s.engine, &mesh, &level, NULL));
  info.struct_size = sizeof info;
  OK(carom_shape_get_scenery_info(s.engine, level, &info, NULL));
  CHECK(info.triangles == 2 && info.vertices == 4 && info.boundary_edges == 4);
  OK(carom_shape_get_triangles(s.engine, level, 0, corners, &room, &next, NULL));
  CHECK(room == 2 && next == 2);
  OK(carom_height_field_desc_init(&field, sizeof field));
  field.columns = field.rows = 2, field.heights = heights;
  OK(carom_shape_create_height_field(s.engine, &field, &hills, NULL));
  OK(carom_collider_desc_init(&part, sizeof part));
  part.shape = level;
  OK(carom_collider_create(s.world, s.ground, &part, &collider, NULL));
  OK(carom_collider_set_surface_velocity(s.world, collider, belt, still, NULL));
  OK(carom_collider_get_surface_velocity(s.world, collider, v, w, NULL));
  CHECK(v[0] == 1 && w[0] == 0);

  light = stage_ball(&s, 20, 4, 0, &collider);
  OK(carom_body_set_gravity_factor(s.world, light, 0, NULL));
  OK(carom_body_get_gravity_factor(s.world, light, &factor, NULL));
  CHECK(factor == 0);
  OK(carom_body_set_locks(s.world, light, CAROM_LOCK_LINEAR_X, NULL));
  OK(carom_body_get_locks(s.world, light, &bits, NULL));
  CHECK(bits == CAROM_LOCK_LINEAR_X);
  OK(carom_body_set_velocity(s.world, light, push, still, NULL));
  OK(carom_body_set_continuous(s.world, s.body, CAROM_CONTINUOUS_ALWAYS, NULL));
  OK(carom_body_get_continuous(s.world, s.body, &bits, NULL));
  CHECK(bits == CAROM_CONTINUOUS_ALWAYS);
  stage_steps(&s, 300);
  stage_position(&s, light, at);
  CHECK(at[0] == 20 && fabs(at[1] - 4) < 1e-12);
  stage_position(&s, s.body, at);
  CHECK(fabs(at[1] - 2.5) < 0.01 && at[0] > 0.3); /* on the belt, and carried along */
  OK(carom_draw_desc_init(&draw, sizeof draw));
  OK(carom_world_draw(s.world, &draw, lines, sizeof *lines, 4, &n, NULL));
  CHECK(n > 10);
  stage_end(&s);
  return 0;
}
