/* The scene that every host of tests/bindings builds; prints the hash of its world after 1, 2 and 3 s. Written with the
 * interface alone, as scene.py and scene.lua are: same calls in the same order, same bits.
 * usage: bindings_scene PLUGIN_DIR */
#include <carom/carom.h>
#include <stdio.h>
#include <string.h>

#define CHECK(call)                                                        \
  do {                                                                     \
    if ((call) != CAROM_OK) {                                              \
      fprintf(stderr, "%s\n%s\n%s\n", #call, error.message, error.remedy); \
      return 1;                                                            \
    }                                                                      \
  } while (0)

static carom_error error = CAROM_ERROR_INIT;

static int32_t load(carom_engine* engine, const char* folder, const char* name, const double* params, uint64_t count,
                    carom_shape* shape) {
  char path[4096];
  carom_plugin plugin;
  const int32_t result = snprintf(path, sizeof path, "%s/%s.so", folder, name) < (int)sizeof path
                             ? carom_plugin_load(engine, path, &plugin, &error)
                             : CAROM_E_LIMIT;
  return result == CAROM_OK ? carom_shape_create(engine, plugin, params, count, shape, &error) : result;
}

int main(int argc, char** argv) {
  const double ball_params[] = {0.3}, box_params[] = {0.4, 0.25, 0.3}, top_params[] = {0.35, 0.4}, up[3] = {0, 1, 0};
  const double at[3] = {4, 3, 0}, wind[3] = {1.5, 0, 0.5};
  carom_engine* engine;
  carom_world* world;
  carom_shape shapes[3], ground;
  carom_material material;
  carom_material_desc surface;
  carom_body_desc body;
  carom_collider_desc part;
  carom_joint_desc hinge;
  carom_joint joint;
  carom_body bodies[19];
  carom_collider collider;
  uint64_t hash;
  int i, second;

  if (argc < 2) return 2;
  CHECK(carom_engine_create(NULL, &engine, &error));
  CHECK(load(engine, argv[1], "sphere", ball_params, 1, &shapes[0]));
  CHECK(load(engine, argv[1], "box", box_params, 3, &shapes[1]));
  CHECK(load(engine, argv[1], "template", top_params, 2, &shapes[2]));
  CHECK(carom_shape_create_half_space(engine, up, 0, &ground, &error));
  CHECK(carom_world_create(engine, NULL, &world, &error));
  CHECK(carom_world_set_dial(world, CAROM_DIAL_SUBSTEPS, 5, &error));
  CHECK(carom_world_set_wind(world, wind, &error));
  carom_material_desc_init(&surface, sizeof surface);
  surface.friction = 0.6, surface.restitution = 0.3;
  CHECK(carom_material_create(world, &surface, &material, &error));
  for (i = 0; i < 19; ++i) { /* the ground, and 18 things in a heap */
    carom_body_desc_init(&body, sizeof body);
    carom_collider_desc_init(&part, sizeof part);
    part.material = material;
    if (i == 0) {
      body.type = CAROM_BODY_STATIC;
      part.shape = ground;
    } else {
      body.position[0] = (i % 3) * 0.5, body.position[1] = 0.6 + i * 0.55, body.position[2] = (i % 2) * 0.4;
      body.angular_velocity[0] = 0.5 * i, body.angular_velocity[2] = 1.0;
      part.shape = shapes[i % 3];
      part.density = 400 + 50 * i;
    }
    CHECK(carom_body_create(world, &body, &bodies[i], &error));
    CHECK(carom_collider_create(world, bodies[i], &part, &collider, &error));
    if (i) CHECK(carom_body_set_drag(world, bodies[i], 0.1, 0.02, &error));
  }
  carom_body_desc_init(&body, sizeof body);
  carom_collider_desc_init(&part, sizeof part);
  part.shape = shapes[1];
  body.position[0] = 4.5, body.position[1] = 3;
  CHECK(carom_body_create(world, &body, &bodies[0], &error));
  CHECK(carom_collider_create(world, bodies[0], &part, &collider, &error));
  carom_joint_desc_init(&hinge, sizeof hinge);
  hinge.kind = CAROM_JOINT_HINGE, hinge.fields = CAROM_JOINT_WORLD_FRAME, hinge.body_b = bodies[0];
  memcpy(hinge.position_a, at, sizeof at);
  hinge.orientation_a[0] = 0, hinge.orientation_a[1] = -0.6, hinge.orientation_a[2] = 0, hinge.orientation_a[3] = 0.8;
  CHECK(carom_joint_create(world, &hinge, &joint, &error));
  for (second = 0; second < 3; ++second) {
    for (i = 0; i < 60; ++i) CHECK(carom_world_step(world, 1.0 / 60, &error));
    CHECK(carom_world_hash(world, &hash, &error));
    printf("%016llx\n", (unsigned long long)hash);
  }
  CHECK(carom_world_destroy(world, &error));
  CHECK(carom_engine_destroy(engine, &error));
  return 0;
}
