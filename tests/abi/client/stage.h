/* What the kept clients share, all of it of version 0.9: a world with a floor and a ball. */
#ifndef STAGE_H
#define STAGE_H
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "first.h"

#define CHECK(condition)                                     \
  do {                                                       \
    if (!(condition)) {                                      \
      printf("%s:%d: %s\n", __FILE__, __LINE__, #condition); \
      exit(1);                                               \
    }                                                        \
  } while (0)
#define OK(call) CHECK((call) == CAROM_OK)

typedef struct Stage {
  carom_engine* engine;
  carom_world* world;
  carom_plugin plugin;
  carom_shape ball, floor;
  carom_body ground, body;
  carom_collider ground_collider, collider;
} Stage;

static int32_t stage_point(void* user, const double* params, uint64_t count, const double dir[3], double out[3]) {
  (void)user, (void)params, (void)count, (void)dir;
  out[0] = out[1] = out[2] = 0;
  return 0;
}

static const carom_param stage_params[] = {{"radius", "m", 0, 1000}};
static const carom_geometry stage_geometry = {sizeof(carom_geometry),
                                              CAROM_FORM_SPHERE,
                                              {0, CAROM_NO_PARAM, CAROM_NO_PARAM, CAROM_NO_PARAM},
                                              0,
                                              CAROM_FORM_SPHERE,
                                              {0, CAROM_NO_PARAM, CAROM_NO_PARAM, CAROM_NO_PARAM}};
static const carom_shape_plugin stage_plugin = {
    .struct_size = sizeof(carom_shape_plugin),
    .abi_major = CAROM_PLUGIN_ABI_MAJOR,
    .abi_minor = CAROM_PLUGIN_ABI_MINOR,
    .id = "kept.sphere",
    .version = 1,
    .param_count = 1,
    .params = stage_params,
    .geometry = &stage_geometry,
    .support = stage_point,
};

/* A ball of radius 0.5 m and 1000 kg/m^3 on body `body`. */
static carom_body stage_ball(Stage* s, double x, double y, double z, carom_collider* collider) {
  carom_body_desc desc;
  carom_collider_desc part;
  carom_body body = 0;
  OK(carom_body_desc_init(&desc, sizeof desc));
  desc.position[0] = x, desc.position[1] = y, desc.position[2] = z;
  OK(carom_body_create(s->world, &desc, &body, NULL));
  OK(carom_collider_desc_init(&part, sizeof part));
  part.shape = s->ball;
  OK(carom_collider_create(s->world, body, &part, collider, NULL));
  return body;
}

/* A floor at y = 0, a ball with its centre at (0, y, 0). */
static void stage_world(Stage* s, double y) {
  carom_body_desc desc;
  carom_collider_desc part;
  OK(carom_world_create(s->engine, NULL, &s->world, NULL));
  OK(carom_body_desc_init(&desc, sizeof desc));
  desc.type = CAROM_BODY_STATIC;
  OK(carom_body_create(s->world, &desc, &s->ground, NULL));
  OK(carom_collider_desc_init(&part, sizeof part));
  part.shape = s->floor;
  OK(carom_collider_create(s->world, s->ground, &part, &s->ground_collider, NULL));
  s->body = stage_ball(s, 0, y, 0, &s->collider);
}

static void stage_engine(Stage* s) {
  const double radius = 0.5, up[3] = {0, 1, 0};
  memset(s, 0, sizeof *s);
  OK(carom_engine_create(NULL, &s->engine, NULL));
  OK(carom_plugin_register(s->engine, &stage_plugin, &s->plugin, NULL));
  OK(carom_shape_create(s->engine, s->plugin, &radius, 1, &s->ball, NULL));
  OK(carom_shape_create_half_space(s->engine, up, 0, &s->floor, NULL));
}

static void stage_make(Stage* s, double y) {
  stage_engine(s);
  stage_world(s, y);
}

static void stage_steps(Stage* s, int n) {
  while (n-- > 0) OK(carom_world_step(s->world, 0.01, NULL));
}

static void stage_position(Stage* s, carom_body body, double at[3]) {
  OK(carom_world_read(s->world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, &body, 1, at, 0, NULL));
}

static void stage_end(Stage* s) {
  OK(carom_world_destroy(s->world, NULL));
  OK(carom_engine_destroy(s->engine, NULL));
}

/* Not every client uses all of it. */
typedef void (*stage_any)(void);
extern const stage_any stage_all[];
const stage_any stage_all[] = {(stage_any)stage_make, (stage_any)stage_steps, (stage_any)stage_position,
                               (stage_any)stage_end};

#endif
