/* Ground of a height field, in whose valley a ball comes to rest, and of triangles, down which a crate slides. */
#include <carom/carom.h>
#include <math.h>
#include <stdio.h>
#define TRY(call) \
  if ((call) != CAROM_OK) return fprintf(stderr, "%s. %s\n", e.message, e.remedy), 1
#define CHECK(what) \
  if (!(what)) return fprintf(stderr, "wrong: %s\n", #what), 1

static int32_t place(carom_world* world, const carom_body_desc* about, const carom_collider_desc* part,
                     carom_body* body, carom_error* e) {
  carom_collider collider;
  const int32_t result = carom_body_create(world, about, body, e);
  return result == CAROM_OK ? carom_collider_create(world, *body, part, &collider, e) : result;
}

int main(void) {
  carom_error e = CAROM_ERROR_INIT;
  carom_engine* engine;
  carom_world* world;
  carom_collider_desc part[4]; /* a field, a mesh, a ball, a crate */
  carom_body ball, crate, ground;
  carom_material_desc slippery;
  carom_body_desc still, slow, tilted;
  const double tilt = acos(-1) / 6, s = sin(tilt), c = cos(tilt), radius = 0.5, half[3] = {0.5, 0.5, 0.5};
  const double x = 6 + 9 * c, y = 4 - 9 * s; /* a wall at its end */
  const double corners[18] = {6, 4, -2, 6, 4, 2, x, y, -2, x, y, 2, x, y + 3, -2, x, y + 3, 2};
  const uint32_t triangles[12] = {0, 1, 2, 2, 1, 3, 2, 3, 4, 4, 3, 5};
  double heights[81], at[2][3];
  const carom_height_field_desc valley = {sizeof valley, 0, 9, 9, heights, {1, 1}};
  const carom_mesh_desc ramp = {sizeof ramp, 0, corners, 6, triangles, 4};
  for (int i = 0; i < 81; i++) heights[i] = 0.25 * fmax(0, hypot(i % 9 - 4, i / 9 - 4) - 1); /* m, rows along z */
  TRY(carom_engine_create(NULL, &engine, &e));
  TRY(carom_world_create(engine, NULL, &world, &e));
  for (int i = 0; i < 4; i++) TRY(carom_collider_desc_init(&part[i], sizeof part[i]));
  carom_material_desc_init(&slippery, sizeof slippery), carom_body_desc_init(&still, sizeof still);
  slow = tilted = still, still.type = CAROM_BODY_STATIC, slippery.friction = 0;
  TRY(carom_shape_create_height_field(engine, &valley, &part[0].shape, &e));
  TRY(carom_shape_create_mesh(engine, &ramp, &part[1].shape, &e));
  TRY(carom_shape_create_named(engine, "sphere", &radius, 1, &part[2].shape, &e));
  TRY(carom_shape_create_named(engine, "box", half, 3, &part[3].shape, &e));
  TRY(carom_material_create(world, &slippery, &part[3].material, &e));
  slow.position[0] = 3, slow.position[1] = 2, slow.position[2] = 1, slow.linear_damping = slow.angular_damping = 0.5;
  tilted.position[0] = 6 + c + 0.5 * s, tilted.position[1] = 4 - s + 0.5 * c; /* 1 m down */
  tilted.orientation[2] = -sin(tilt / 2), tilted.orientation[3] = cos(tilt / 2);
  TRY(place(world, &still, &part[1], &ground, &e));
  still.position[0] = still.position[2] = -4; /* of the field's corner */
  TRY(place(world, &still, &part[0], &ground, &e));
  TRY(place(world, &slow, &part[2], &ball, &e));
  TRY(place(world, &tilted, &part[3], &crate, &e));
  for (int i = 0; i < 660; i++) {
    TRY(carom_world_step(world, 1.0 / 60, &e));
    TRY(carom_body_get_pose(world, i < 60 ? crate : ball, at[i < 60 ? 0 : 1], NULL, &e));
  }
  const double way = hypot(at[0][0] - tilted.position[0], at[0][1] - tilted.position[1]);
  printf("the crate slides by %.2f m in 1 s, and the ball lies at y = %.2f m\n", way, at[1][1]);
  CHECK(fabs(way - 9.81 * s / 2) < 0.01 && fabs(at[1][1] - 0.5) < 0.005 && fabs(at[1][0]) < 2);
  TRY(carom_world_destroy(world, &e));
  return carom_engine_destroy(engine, &e);
}
