/* A host that links nothing: the library by dlopen, every function by name, with the types of a foreign-function caller. */
#include <dlfcn.h>

#include "bench.h"
#include "carom_test.h"

static void* library;

/* POSIX lets a data pointer from dlsym be one to a function; ISO C has no cast for it. */
static void find(const char* name, void* function) {
  void* symbol = dlsym(library, name);
  if (!symbol) print_error("%s\n", dlerror());
  assert_non_null(symbol);
  memcpy(function, &symbol, sizeof symbol);
}

static void a_ball_falls_for_a_host_that_links_nothing(void** state) {
  int32_t (*version)(uint32_t*, uint32_t*, uint32_t*);
  int32_t (*engine_create)(const void*, void**, void*);
  int32_t (*engine_destroy)(void*, void*);
  int32_t (*plugin_register)(void*, const void*, uint64_t*, void*);
  int32_t (*shape_create)(void*, uint64_t, const double*, uint64_t, uint64_t*, void*);
  int32_t (*world_create)(void*, const void*, void**, void*);
  int32_t (*world_destroy)(void*, void*);
  int32_t (*world_step)(void*, double, void*);
  int32_t (*body_desc_init)(void*, uint32_t);
  int32_t (*body_create)(void*, const void*, uint64_t*, void*);
  int32_t (*collider_desc_init)(void*, uint32_t);
  int32_t (*collider_create)(void*, uint64_t, const void*, uint64_t*, void*);
  int32_t (*world_read)(void*, uint32_t, uint32_t, const uint64_t*, uint64_t, void*, uint64_t, void*);
  uint32_t major, minor, patch;
  void *engine = NULL, *world = NULL;
  uint64_t plugin, shape, body, collider;
  const double radius = 0.5;
  float y[3] = {0, 0, 0};
  carom_shape_plugin sphere = bench_sphere_plugin();
  carom_body_desc body_desc;
  carom_collider_desc collider_desc;
  int i;
  (void)state;

  library = dlopen(CAROM_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  if (!library) print_error("%s\n", dlerror());
  assert_non_null(library);
  find("carom_version", &version);
  find("carom_engine_create", &engine_create);
  find("carom_engine_destroy", &engine_destroy);
  find("carom_plugin_register", &plugin_register);
  find("carom_shape_create", &shape_create);
  find("carom_world_create", &world_create);
  find("carom_world_destroy", &world_destroy);
  find("carom_world_step", &world_step);
  find("carom_body_desc_init", &body_desc_init);
  find("carom_body_create", &body_create);
  find("carom_collider_desc_init", &collider_desc_init);
  find("carom_collider_create", &collider_create);
  find("carom_world_read", &world_read);

  assert_int_equal(version(&major, &minor, &patch), 0);
  assert_int_equal(major, CAROM_VERSION_MAJOR);
  assert_int_equal(engine_create(NULL, &engine, NULL), 0);
  assert_int_equal(plugin_register(engine, &sphere, &plugin, NULL), 0);
  assert_int_equal(shape_create(engine, plugin, &radius, 1, &shape, NULL), 0);
  assert_int_equal(world_create(engine, NULL, &world, NULL), 0);
  body_desc_init(&body_desc, sizeof body_desc);
  assert_int_equal(body_create(world, &body_desc, &body, NULL), 0);
  collider_desc_init(&collider_desc, sizeof collider_desc);
  collider_desc.shape = shape;
  assert_int_equal(collider_create(world, body, &collider_desc, &collider, NULL), 0);
  for (i = 0; i < 64; ++i) assert_int_equal(world_step(world, 1.0 / 64, NULL), 0);
  assert_int_equal(world_read(world, CAROM_FIELD_POSITION, CAROM_SCALAR_F32, &body, 1, y, 0, NULL), 0);
  assert_true(fabs(y[1] + 9.81 / 2) <=
              9.81 / 2 / 64 + 1e-5); /* Euler: g t dt / 2 off, on either side; float rounding */
  assert_int_equal(world_destroy(world, NULL), 0);
  assert_int_equal(engine_destroy(engine, NULL), 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(a_ball_falls_for_a_host_that_links_nothing)};
  return cmocka_run_group_tests_name("abi/ffi", tests, NULL, NULL);
}
