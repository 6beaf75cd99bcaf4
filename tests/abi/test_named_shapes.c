/* Shapes by name: registered ones first, then files of the folders that $CAROM_PLUGIN_PATH names, then those of the
 * library. */
#define _GNU_SOURCE
#include <stdlib.h>

#include "bench.h"
#include "carom_test.h"

static carom_engine* engine_of(void) {
  carom_engine* engine = NULL;
  assert_int_equal(carom_engine_create(NULL, &engine, NULL), CAROM_OK);
  return engine;
}

/* Every standard shape, by its short name and by its id, from a folder that the environment names. */
static void standard_shapes_are_found(void** state) {
  static const struct {
    const char *name, *id;
    double params[12];
    uint64_t count;
    double volume;
  } cases[] = {
      {"box", "carom.box", {0.5, 1, 2}, 3, 8},
      {"sphere", "carom.sphere", {2}, 1, 32 * M_PI / 3},
      {"capsule", "carom.capsule", {1, 2}, 2, 4 * M_PI / 3 + 4 * M_PI},
      {"cylinder", "carom.cylinder", {1, 2}, 2, 4 * M_PI},
      {"cone", "carom.cone", {1, 3}, 2, 2 * M_PI},
      {"ellipsoid", "carom.ellipsoid", {1, 2, 3}, 3, 8 * M_PI},
      {"hull", "carom.hull", {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 12, 1.0 / 6},
  };
  carom_engine* engine = engine_of();
  size_t i;
  int which;
  (void)state;
  setenv("CAROM_PLUGIN_PATH", "/nothing/here:relative:" CAROM_PLUGIN_DIR, 1);
  for (i = 0; i < sizeof cases / sizeof cases[0]; ++i)
    for (which = 0; which < 2; ++which) {
      carom_shape shape = 0;
      carom_shape_info info;
      assert_int_equal(carom_shape_create_named(engine, which ? cases[i].id : cases[i].name, cases[i].params,
                                                cases[i].count, &shape, NULL),
                       CAROM_OK);
      info.struct_size = sizeof info;
      assert_int_equal(carom_shape_get_info(engine, shape, &info, NULL), CAROM_OK);
      assert_true(fabs(info.volume - cases[i].volume) < 1e-9 * cases[i].volume);
    }
  assert_int_equal(carom_engine_destroy(engine, NULL), CAROM_OK);
}

/* What is not there says where it was looked for. */
static void what_is_not_found_says_where_it_was_looked_for(void** state) {
  carom_engine* engine = engine_of();
  carom_error e = CAROM_ERROR_INIT;
  const double radius = 1;
  carom_shape shape = 7;
  (void)state;
  setenv("CAROM_PLUGIN_PATH", "/nothing/here", 1);
  assert_int_equal(carom_shape_create_named(engine, "bananas", &radius, 1, &shape, &e), CAROM_E_NOT_FOUND);
  assert_non_null(strstr(e.message, "bananas"));
  assert_non_null(strstr(e.message, "/nothing/here"));
  assert_int_equal(e.argument, 2);
  assert_true(strstr(e.remedy, "CAROM_PLUGIN_PATH") && shape == 7);
  assert_int_equal(carom_shape_create_named(engine, "../box", &radius, 1, &shape, &e), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_shape_create_named(engine, "", &radius, 1, &shape, &e), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_shape_create_named(engine, NULL, &radius, 1, &shape, &e), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_shape_create_named(NULL, "box", &radius, 1, &shape, &e), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_shape_create_named(engine, "half_space", &radius, 1, &shape, &e), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(e.argument, 4);
  assert_int_equal(carom_engine_destroy(engine, NULL), CAROM_OK);
}

/* A file's name stands for its plugin, whatever the id: every time, not only when it is loaded. */
static void files_are_found_by_their_names(void** state) {
  carom_engine* engine = engine_of();
  carom_error e = CAROM_ERROR_INIT;
  carom_shape shape[3] = {0, 0, 0};
  carom_shape_info info[3];
  const double size[2] = {1, 2};
  int i;
  (void)state;
  setenv("CAROM_PLUGIN_PATH", CAROM_INVALID_DIR, 1);
  for (i = 0; i < 2; ++i) {
    assert_int_equal(carom_shape_create_named(engine, "valid", &size[i], 1, &shape[i], &e), CAROM_OK);
    info[i].struct_size = sizeof info[i];
    assert_int_equal(carom_shape_get_info(engine, shape[i], &info[i], NULL), CAROM_OK);
  }
  assert_true(shape[0] != shape[1] && info[0].plugin == info[1].plugin);
  assert_int_equal(carom_shape_create_named(engine, "invalid_plugin.valid", size, 1, &shape[2], &e), CAROM_OK);
  assert_int_equal(carom_engine_destroy(engine, NULL), CAROM_OK);
}

/* A plugin of the host's own comes before files of the same name. */
static void registered_plugins_come_first(void** state) {
  carom_engine* engine = engine_of();
  carom_shape_plugin mine = bench_box_plugin();
  carom_plugin plugin = 0;
  carom_shape shape = 0;
  carom_shape_info info;
  const double half[3] = {1, 1, 1};
  (void)state;
  setenv("CAROM_PLUGIN_PATH", CAROM_PLUGIN_DIR, 1);
  mine.id = "carom.cone";
  assert_int_equal(carom_plugin_register(engine, &mine, &plugin, NULL), CAROM_OK);
  assert_int_equal(carom_shape_create_named(engine, "cone", half, 3, &shape, NULL), CAROM_OK);
  info.struct_size = sizeof info;
  assert_int_equal(carom_shape_get_info(engine, shape, &info, NULL), CAROM_OK);
  assert_true(info.plugin == plugin);
  assert_int_equal(carom_engine_destroy(engine, NULL), CAROM_OK);
}

/* A ground and a ball on it in two calls; the second ball has the first one's shape. */
static void a_scene_of_three_calls(void** state) {
  carom_engine* engine = engine_of();
  carom_world* world = NULL;
  const double up[4] = {0, 1, 0, 0}, zero[3] = {0, 0, 0}, above[3] = {0, 2, 0}, aside[3] = {3, 2, 0}, radius = 0.5;
  carom_body ground = 0, ball[2] = {0, 0};
  carom_collider collider[2];
  carom_collider_desc desc[2];
  carom_body owner;
  carom_error e = CAROM_ERROR_INIT;
  double p[3];
  uint64_t count;
  int i;
  (void)state;
  setenv("CAROM_PLUGIN_PATH", CAROM_PLUGIN_DIR, 1);
  assert_int_equal(carom_world_create(engine, NULL, &world, NULL), CAROM_OK);
  assert_int_equal(carom_body_create_named(world, CAROM_BODY_STATIC, "half_space", up, 4, zero, &ground, NULL),
                   CAROM_OK);
  assert_int_equal(carom_body_create_named(world, CAROM_BODY_DYNAMIC, "sphere", &radius, 1, above, &ball[0], NULL),
                   CAROM_OK);
  assert_int_equal(
      carom_body_create_named(world, CAROM_BODY_DYNAMIC, "carom.sphere", &radius, 1, aside, &ball[1], NULL), CAROM_OK);
  for (i = 0; i < 120; ++i) assert_int_equal(carom_world_step(world, 1.0 / 60, NULL), CAROM_OK);
  for (i = 0; i < 2; ++i) {
    assert_int_equal(carom_body_get_pose(world, ball[i], p, NULL, NULL), CAROM_OK);
    assert_true(fabs(p[1] - 0.5) < 1e-3);
    assert_int_equal(carom_body_get_colliders(world, ball[i], &collider[i], 1, &count, NULL), CAROM_OK);
    desc[i].struct_size = sizeof desc[i];
    assert_int_equal(carom_collider_get(world, collider[i], &desc[i], &owner, NULL), CAROM_OK);
  }
  assert_true(desc[0].shape == desc[1].shape);
  /* What fails leaves nothing behind. */
  assert_int_equal(carom_body_create_named(world, CAROM_BODY_DYNAMIC, "half_space", up, 4, zero, &ground, &e),
                   CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_body_create_named(world, 9, "sphere", &radius, 1, zero, &ground, &e), CAROM_E_UNKNOWN_ENUM);
  assert_int_equal(e.argument, 2);
  assert_int_equal(carom_body_create_named(world, CAROM_BODY_DYNAMIC, "bananas", &radius, 1, zero, &ground, &e),
                   CAROM_E_NOT_FOUND);
  assert_int_equal(e.argument, 3);
  assert_int_equal(carom_body_create_named(world, CAROM_BODY_DYNAMIC, "sphere", &radius, 2, zero, &ground, &e),
                   CAROM_E_OUT_OF_RANGE);
  assert_int_equal(e.argument, 5);
  assert_int_equal(carom_world_get_bodies(world, NULL, 0, &count, NULL), CAROM_OK);
  assert_int_equal(count, 3);
  assert_int_equal(carom_world_destroy(world, NULL), CAROM_OK);
  assert_int_equal(carom_engine_destroy(engine, NULL), CAROM_OK);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(standard_shapes_are_found), cmocka_unit_test(what_is_not_found_says_where_it_was_looked_for),
      cmocka_unit_test(files_are_found_by_their_names), cmocka_unit_test(registered_plugins_come_first),
      cmocka_unit_test(a_scene_of_three_calls)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
