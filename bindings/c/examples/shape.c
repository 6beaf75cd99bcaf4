/* A shape of your own: a support function is all of it. An elliptic cylinder, its axis upright. */
#include <carom/carom.h>
#include <math.h>
#include <stdio.h>
#define TRY(call) \
  if ((call) != CAROM_OK) return fprintf(stderr, "%s. %s\n", e.message, e.remedy), 1
#define CHECK(what) \
  if (!(what)) return fprintf(stderr, "wrong: %s\n", #what), 1

/* The farthest point of the shape along a direction. */
static int32_t support(void* user, const double* p, uint64_t n, const double d[3], double out[3]) {
  const double length = hypot(p[0] * d[0], p[2] * d[2]);
  (void)user, (void)n;
  out[0] = length > 0 ? p[0] * p[0] * d[0] / length : 0;
  out[1] = copysign(p[1], d[1]);
  out[2] = length > 0 ? p[2] * p[2] * d[2] / length : 0;
  return 0;
}

int main(void) {
  carom_error e = CAROM_ERROR_INIT;
  carom_engine* engine;
  carom_world* world;
  carom_plugin kind;
  carom_shape shape;
  carom_body ground, body;
  const carom_param half[3] = {{"a", "m", 1e-6, 1e3}, {"h", "m", 1e-6, 1e3}, {"b", "m", 1e-6, 1e3}};
  carom_shape_plugin about = {.struct_size = sizeof about, .abi_major = CAROM_PLUGIN_ABI_MAJOR};
  const double up[4] = {0, 1, 0, 0}, origin[3] = {0, 0, 0}, size[3] = {0.6, 0.2, 0.3}, at[3] = {0, 1, 0};
  double mass, position[3];
  about.abi_minor = CAROM_PLUGIN_ABI_MINOR, about.id = "example.elliptic_cylinder", about.version = 1;
  about.param_count = 3, about.params = half, about.support = support;
  TRY(carom_engine_create(NULL, &engine, &e));
  TRY(carom_world_create(engine, NULL, &world, &e));
  TRY(carom_body_create_named(world, CAROM_BODY_STATIC, "half_space", up, 4, origin, &ground, &e));
  TRY(carom_plugin_register(engine, &about, &kind, &e));
  TRY(carom_shape_create(engine, kind, size, 3, &shape, &e));
  TRY(carom_body_create_named(world, CAROM_BODY_DYNAMIC, about.id, size, 3, at, &body, &e)); /* 1000 kg/m^3 */
  for (int i = 0; i < 120; i++) TRY(carom_world_step(world, 1.0 / 60, &e));
  TRY(carom_body_get_mass(world, body, &mass, NULL, NULL, &e));
  TRY(carom_body_get_pose(world, body, position, NULL, &e));
  printf("it weighs %.0f kg and lies at y = %.2f m\n", mass, position[1]);
  CHECK(fabs(mass / (1000 * acos(-1) * 0.6 * 0.3 * 0.4) - 1) < 0.005 && fabs(position[1] - 0.2) < 0.005);
  TRY(carom_world_destroy(world, &e));
  TRY(carom_engine_destroy(engine, &e));
  return 0;
}
