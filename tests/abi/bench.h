/* A small stage for tests of the boundary: shapes registered by pointer, an engine, a world with a floor and bodies.
 * C and C++; sees include/carom alone. */
#ifndef CAROM_TESTS_ABI_BENCH_H
#define CAROM_TESTS_ABI_BENCH_H

#include <carom/carom.h>
#include <math.h>
#include <string.h>

/* ---- shapes ---- */
static int32_t bench_point(void* user, const double* params, uint64_t count, const double dir[3], double out[3]) {
  (void)user;
  (void)params, (void)count, (void)dir;
  out[0] = out[1] = out[2] = 0;
  return 0;
}

static int32_t bench_box(void* user, const double* params, uint64_t count, const double dir[3], double out[3]) {
  (void)user;
  int i;
  (void)count;
  for (i = 0; i < 3; ++i) out[i] = dir[i] < 0 ? -params[i] : params[i];
  return 0;
}

static const carom_param bench_radius_params[] = {{"radius", "m", 0, 1e3}};
static const carom_param bench_box_params[] = {
    {"half_x", "m", 0, 1e3}, {"half_y", "m", 0, 1e3}, {"half_z", "m", 0, 1e3}};
static const carom_geometry bench_sphere_geometry = {sizeof(carom_geometry),
                                                     CAROM_FORM_SPHERE,
                                                     {0, CAROM_NO_PARAM, CAROM_NO_PARAM, CAROM_NO_PARAM},
                                                     0,
                                                     CAROM_FORM_SPHERE,
                                                     {0, CAROM_NO_PARAM, CAROM_NO_PARAM, CAROM_NO_PARAM}};
static const carom_geometry bench_box_geometry = {sizeof(carom_geometry), CAROM_FORM_BOX, {0, 1, 2, CAROM_NO_PARAM},
                                                  CAROM_NO_PARAM,         CAROM_FORM_BOX, {0, 1, 2, CAROM_NO_PARAM}};

static carom_shape_plugin bench_plugin(const char* id, const carom_param* params, uint32_t count,
                                       const carom_geometry* geometry, carom_support_fn support) {
  carom_shape_plugin p;
  memset(&p, 0, sizeof p);
  p.struct_size = sizeof p;
  p.abi_major = CAROM_PLUGIN_ABI_MAJOR;
  p.abi_minor = CAROM_PLUGIN_ABI_MINOR;
  p.id = id;
  p.version = 1;
  p.params = params;
  p.param_count = count;
  p.geometry = geometry;
  p.support = support;
  return p;
}

static carom_shape_plugin bench_sphere_plugin(void) {
  return bench_plugin("test.sphere", bench_radius_params, 1, &bench_sphere_geometry, bench_point);
}
static carom_shape_plugin bench_box_plugin(void) {
  return bench_plugin("test.box", bench_box_params, 3, &bench_box_geometry, bench_box);
}

/* ---- the stage: a floor, three spheres and a box above it ---- */
#define BENCH_BODIES 4

typedef struct Bench {
  carom_shape_plugin sphere_plugin, box_plugin;
  carom_engine* engine;
  carom_world* world;
  carom_plugin sphere, box;
  carom_shape ball, crate, floor;
  carom_material material;
  carom_body ground;
  carom_collider ground_collider;
  carom_body bodies[BENCH_BODIES];
  carom_collider colliders[BENCH_BODIES];
  carom_particles particles; /* by bench_particles() */
  carom_joint joint;         /* by bench_joint() */
} Bench;

/* The first failure of a chain of calls, or CAROM_OK. */
static int32_t bench_first(int32_t so_far, int32_t next) { return so_far != CAROM_OK ? so_far : next; }

static int32_t bench_shapes(Bench* b, carom_error* e) {
  const double radius = 0.5, half[3] = {0.5, 0.25, 0.75}, up[3] = {0, 1, 0};
  int32_t r;
  b->sphere_plugin = bench_sphere_plugin();
  b->box_plugin = bench_box_plugin();
  r = carom_plugin_register(b->engine, &b->sphere_plugin, &b->sphere, e);
  r = bench_first(r, r ? r : carom_plugin_register(b->engine, &b->box_plugin, &b->box, e));
  r = bench_first(r, r ? r : carom_shape_create(b->engine, b->sphere, &radius, 1, &b->ball, e));
  r = bench_first(r, r ? r : carom_shape_create(b->engine, b->box, half, 3, &b->crate, e));
  return bench_first(r, r ? r : carom_shape_create_half_space(b->engine, up, 0, &b->floor, e));
}

static int32_t bench_body(carom_world* world, carom_shape shape, carom_material material, uint32_t type, double x,
                          double y, double z, carom_body* body, carom_collider* collider, carom_error* e) {
  carom_body_desc body_desc;
  carom_collider_desc collider_desc;
  int32_t r;
  carom_body_desc_init(&body_desc, sizeof body_desc);
  body_desc.type = type;
  body_desc.position[0] = x;
  body_desc.position[1] = y;
  body_desc.position[2] = z;
  r = carom_body_create(world, &body_desc, body, e);
  if (r) return r;
  carom_collider_desc_init(&collider_desc, sizeof collider_desc);
  collider_desc.shape = shape;
  collider_desc.material = material;
  return carom_collider_create(world, *body, &collider_desc, collider, e);
}

/* Bodies stand apart, then fall on the floor: the box upright, so that it topples. */
static int32_t bench_bodies(Bench* b, carom_error* e) {
  carom_material_desc material;
  int32_t r;
  int i;
  carom_material_desc_init(&material, sizeof material);
  material.restitution = 0.25;
  r = carom_material_create(b->world, &material, &b->material, e);
  if (!r)
    r = bench_body(b->world, b->floor, CAROM_NULL_HANDLE, CAROM_BODY_STATIC, 0, 0, 0, &b->ground, &b->ground_collider,
                   e);
  for (i = 0; !r && i < BENCH_BODIES; ++i)
    r = bench_body(b->world, i == 3 ? b->crate : b->ball, b->material, CAROM_BODY_DYNAMIC, 0.75 * i, 1 + 0.5 * i,
                   0.125 * i, &b->bodies[i], &b->colliders[i], e);
  return r;
}

#define BENCH_PARTICLES 5

/* A set of a few particles that fly apart. */
static int32_t bench_particles(Bench* b, carom_error* e) {
  const double x[BENCH_PARTICLES][3] = {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 5}, {4, 5, 6}};
  const double v[BENCH_PARTICLES][3] = {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, -1}};
  int32_t r = carom_particles_create(b->world, NULL, &b->particles, e);
  if (!r) r = carom_particles_add(b->world, b->particles, BENCH_PARTICLES, CAROM_SCALAR_F64, x, 0, v, 0, e);
  return r;
}

/* A hinge between the first body and the third, as they stand. */
static int32_t bench_joint(Bench* b, carom_error* e) {
  carom_joint_desc d;
  carom_joint_desc_init(&d, sizeof d);
  d.kind = CAROM_JOINT_HINGE, d.fields = CAROM_JOINT_WORLD_FRAME;
  d.body_a = b->bodies[0], d.body_b = b->bodies[2];
  return carom_joint_create(b->world, &d, &b->joint, e);
}

static int32_t bench_make(Bench* b, const carom_engine_desc* desc, carom_error* e) {
  int32_t r;
  memset(b, 0, sizeof *b);
  r = carom_engine_create(desc, &b->engine, e);
  if (!r) r = bench_shapes(b, e);
  if (!r) r = carom_world_create(b->engine, NULL, &b->world, e);
  if (!r) r = bench_bodies(b, e);
  return r;
}

static int32_t bench_free(Bench* b) {
  int32_t r = CAROM_OK;
  if (b->world) r = carom_world_destroy(b->world, NULL);
  if (b->engine) r = bench_first(r, carom_engine_destroy(b->engine, NULL));
  return r;
}

static int32_t bench_steps(carom_world* world, int n, carom_error* e) {
  int32_t r = CAROM_OK;
  int i;
  for (i = 0; !r && i < n; ++i) r = carom_world_step(world, 1.0 / 64, e);
  return r;
}

static uint64_t bench_hash(carom_world* world) {
  uint64_t hash = 0;
  return carom_world_hash(world, &hash, NULL) == CAROM_OK ? hash : 0;
}

/* Nobody need use all of the above. */
static inline void bench_unused(void) {
  (void)bench_make, (void)bench_free, (void)bench_steps, (void)bench_hash, (void)bench_particles, (void)bench_joint,
      (void)bench_unused;
}

#endif
