/* Plugins that lie are refused when they are loaded or when a shape is made of them, or put in quarantine when they lie
 * later; valid ones are taken in, by path and by pointer. */
#include <dlfcn.h>
#include <fenv.h>
#include <float.h>
#include <stdio.h>

#include "bench.h"
#include "carom_test.h"

/* ---- invalid plugins by pointer: each a ball of params[0], but for its lie ---- */

static int32_t ball(void* user, const double* params, uint64_t count, const double dir[3], double out[3]) {
  (void)user;
  const double largest = fmax(fabs(dir[0]), fmax(fabs(dir[1]), fabs(dir[2])));
  const double x = dir[0] / largest, y = dir[1] / largest, z = dir[2] / largest;
  const double scale = params[0] / sqrt(x * x + y * y + z * z);
  (void)count;
  out[0] = scale * x;
  out[1] = scale * y;
  out[2] = scale * z;
  return 0;
}

static int32_t gives_nan(void* user, const double* params, uint64_t count, const double dir[3], double out[3]) {
  (void)user;
  const int32_t r = ball(NULL, params, count, dir, out);
  if (dir[0] > 0 && dir[1] > 0) out[2] = NAN;
  return r;
}
static int32_t not_repeatable(void* user, const double* params, uint64_t count, const double dir[3], double out[3]) {
  (void)user;
  static int calls = 0;
  const int32_t r = ball(NULL, params, count, dir, out);
  out[0] *= 1 + 1e-12 * (++calls % 2);
  return r;
}
/* The nearest point instead of the farthest. */
static int32_t not_convex(void* user, const double* params, uint64_t count, const double dir[3], double out[3]) {
  (void)user;
  const int32_t r = ball(NULL, params, count, dir, out);
  int i;
  for (i = 0; i < 3; ++i) out[i] = -out[i];
  return r;
}
/* A star: its support points are not those of its hull. */
static int32_t star(void* user, const double* params, uint64_t count, const double dir[3], double out[3]) {
  (void)user;
  const int32_t r = ball(NULL, params, count, dir, out);
  const double bump = 1 + 0.5 * sin(9 * atan2(out[1], out[0]));
  int i;
  for (i = 0; i < 3; ++i) out[i] *= bump;
  return r;
}
static int32_t unbounded(void* user, const double* params, uint64_t count, const double dir[3], double out[3]) {
  (void)user;
  const int32_t r = ball(NULL, params, count, dir, out);
  if (dir[1] > 0.5 * fabs(dir[0])) out[1] = 1e300;
  return r;
}
static int32_t scales(void* user, const double* params, uint64_t count, const double dir[3], double out[3]) {
  (void)user;
  int i;
  (void)count;
  for (i = 0; i < 3; ++i) out[i] = params[0] * dir[i]; /* right for unit directions only */
  return 0;
}
static int32_t refuses(void* user, const double* params, uint64_t count, const double dir[3], double out[3]) {
  (void)user;
  ball(NULL, params, count, dir, out);
  return dir[2] < 0 ? 3 : 0;
}
static int32_t changes_rounding(void* user, const double* params, uint64_t count, const double dir[3], double out[3]) {
  (void)user;
  fesetround(FE_TOWARDZERO);
  return ball(NULL, params, count, dir, out);
}

static carom_shape_plugin invalid_plugin(carom_support_fn support, const carom_geometry* geometry) {
  static const carom_param params[] = {{"radius", "m", 0.1, 10}};
  return bench_plugin("invalid_plugin", params, 1, geometry, support);
}

static int make(void** state) {
  static Bench b;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  *state = &b;
  return 0;
}
static int clear(void** state) {
  assert_int_equal(bench_free(*state), CAROM_OK);
  return 0;
}

/* A cube of half an edge, rounded by a radius: a smaller cube swollen by it. Rounder than it is large it makes no sense. */
static int32_t rounded_cube(void* user, const double* params, uint64_t count, const double given[3], double out[3]) {
  (void)user;
  const double big = fmax(fabs(given[0]), fmax(fabs(given[1]), fabs(given[2])));
  const double dir[3] = {given[0] / big, given[1] / big, given[2] / big}, core = params[0] - params[1];
  const double length = sqrt(dir[0] * dir[0] + dir[1] * dir[1] + dir[2] * dir[2]);
  int i;
  (void)count;
  for (i = 0; i < 3; ++i) out[i] = (dir[i] < 0 ? -core : core) + params[1] * dir[i] / length;
  return 0;
}

static void parameters_that_constrain_each_other_say_so(void** state) {
  static const carom_param params[] = {{"half", "m", 1e-3, 1e3}, {"radius", "m", 1e-3, 1e3}};
  static const carom_param_rule rules[] = {{"radius <= 0.99 half", 2, {1, 0, 0, 0}, {1, -0.99, 0, 0}, 0}};
  Bench* b = *state;
  carom_shape_plugin p = bench_plugin("rounded", params, 2, NULL, rounded_cube);
  carom_plugin plugin = 0;
  carom_shape shape = 0;
  carom_shape_info info = {0};
  carom_error e = CAROM_ERROR_INIT;
  const double thin[2] = {1, 0.25}, thick[2] = {1, 1.5};
  const double pi = 3.14159265358979323846;
  size_t k;
  assert_int_equal(carom_plugin_register(b->engine, &p, &plugin, &e),
                   CAROM_E_PLUGIN_INVALID); /* judged by one that is no set */
  p.rules = rules, p.rule_count = 1;
  assert_int_equal(carom_plugin_register(b->engine, &p, &plugin, &e), CAROM_OK);
  assert_int_equal(carom_shape_create(b->engine, plugin, thick, 2, &shape, &e), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(e.argument, 3);
  assert_non_null(strstr(e.message, "radius <= 0.99 half"));
  assert_int_equal(carom_shape_create(b->engine, plugin, thin, 2, &shape, &e), CAROM_OK);
  info.struct_size = sizeof info;
  assert_int_equal(carom_shape_get_info(b->engine, shape, &info, NULL), CAROM_OK);
  /* Of edge a = 1.5, swollen by r = 0.25: a^3 + 6 a^2 r + 3 pi a r^2 + 4/3 pi r^3. */
  assert_true(fabs(info.volume - (3.375 + 3.375 + pi * 0.28125 + pi / 48)) < 1e-3 * info.volume);
  for (k = 0; k < 6; ++k) {
    carom_param_rule bad = rules[0];
    carom_shape_plugin q = p;
    q.id = "rounded.bad", q.rules = &bad;
    if (k == 0) bad.text = NULL;
    if (k == 1) bad.term_count = 5;
    if (k == 2) bad.term_count = 0;
    if (k == 3) bad.param[0] = 2;
    if (k == 4) bad.weight[1] = NAN;
    if (k == 5) q.rules = NULL;
    assert_int_equal(carom_plugin_register(b->engine, &q, &plugin, &e), CAROM_E_PLUGIN_ABI);
  }
  p.id = "rounded.never",
  p.rules = rules; /* a rule that nothing keeps: shapes are judged when they are made, and there are none */
  {
    carom_param_rule never = {"never", 1, {0, 0, 0, 0}, {0, 0, 0, 0}, -1};
    p.rules = &never;
    assert_int_equal(carom_plugin_register(b->engine, &p, &plugin, &e), CAROM_OK);
    assert_int_equal(carom_shape_create(b->engine, plugin, thin, 2, &shape, &e), CAROM_E_OUT_OF_RANGE);
  }
}

static void a_invalid_support_function_is_refused_at_registration(void** state) {
  static const struct {
    const char* what;
    carom_support_fn support;
  } invalid_plugins[] = {{"gives nan", gives_nan},   {"not repeatable", not_repeatable},
                         {"not convex", not_convex}, {"star", star},
                         {"unbounded", unbounded},   {"scales", scales},
                         {"returns error", refuses}, {"changes rounding", changes_rounding}};
  Bench* b = *state;
  size_t i;
  for (i = 0; i < sizeof invalid_plugins / sizeof *invalid_plugins; ++i) {
    carom_shape_plugin p = invalid_plugin(invalid_plugins[i].support, NULL);
    carom_plugin plugin = 77;
    carom_error e = CAROM_ERROR_INIT;
    const int32_t r = carom_plugin_register(b->engine, &p, &plugin, &e);
    if (r != CAROM_E_PLUGIN_INVALID) print_error("%s: %s\n", invalid_plugins[i].what, carom_result_name(r));
    assert_int_equal(r, CAROM_E_PLUGIN_INVALID);
    assert_int_equal(e.argument, 2);
    assert_true(e.has_witness);
    assert_int_equal(plugin, 77);
    assert_int_equal(carom_plugin_find(b->engine, "invalid_plugin", &plugin, NULL), CAROM_E_NOT_FOUND);
    assert_int_equal(fegetround(), FE_TONEAREST);
  }
  {
    carom_shape_plugin p = invalid_plugin(ball, NULL); /* the control */
    carom_plugin plugin;
    assert_int_equal(carom_plugin_register(b->engine, &p, &plugin, NULL), CAROM_OK);
  }
}

static void a_nonsensical_struct_is_refused_before_anything_is_called(void** state) {
  Bench* b = *state;
  static const carom_param backward[] = {{"radius", "m", 2, 1}}, nameless[] = {{NULL, "m", 0, 1}};
  static const carom_param unbounded_nan[] = {{"radius", "m", 0, NAN}};
  carom_geometry g = bench_sphere_geometry;
  carom_plugin plugin;
  carom_error e = CAROM_ERROR_INIT;
  carom_shape_plugin good = invalid_plugin(gives_nan, NULL); /* would be INVALID if it were called */
  carom_shape_plugin p[20];
  size_t n = 0, i;
  for (i = 0; i < 20; ++i) p[i] = good;
  p[n++].struct_size = 8;
  p[n++].struct_size = 0;
  p[n++].struct_size = 0xFFFFFFF8u;
  p[n++].abi_major = CAROM_PLUGIN_ABI_MAJOR + 1;
  p[n++].abi_major = 0;
  p[n++].flags = 2;
  p[n++].id = NULL;
  p[n++].id = "";
  p[n++].support = NULL;
  p[n++].params = NULL;
  p[n++].params = backward;
  p[n++].params = nameless;
  p[n++].params = unbounded_nan;
  p[n++].param_count = 0xFFFFFFFFu;
  p[n++].param_tail_group = 2;
  g.form = 99;
  p[n++].geometry = &g;
  for (i = 0; i < n; ++i) {
    const int32_t r = carom_plugin_register(b->engine, &p[i], &plugin, &e);
    if (r != CAROM_E_PLUGIN_ABI) print_error("case %d: %s %s\n", (int)i, carom_result_name(r), e.message);
    assert_int_equal(r, CAROM_E_PLUGIN_ABI);
  }
  g = bench_sphere_geometry;
  good.geometry = &g;
  g.form_arg[0] = 1; /* of one parameter */
  assert_int_equal(carom_plugin_register(b->engine, &good, &plugin, &e), CAROM_E_PLUGIN_ABI);
  g = bench_sphere_geometry;
  g.core_radius_param = 5;
  assert_int_equal(carom_plugin_register(b->engine, &good, &plugin, &e), CAROM_E_PLUGIN_ABI);
  g = bench_sphere_geometry;
  g.mass_arg[0] = CAROM_NO_PARAM;
  assert_int_equal(carom_plugin_register(b->engine, &good, &plugin, &e), CAROM_E_PLUGIN_ABI);
  g = bench_sphere_geometry;
  g.struct_size = 4;
  assert_int_equal(carom_plugin_register(b->engine, &good, &plugin, &e), CAROM_E_PLUGIN_ABI);
}

static void a_struct_of_an_older_or_newer_minor_version_is_read_as_such(void** state) {
  Bench* b = *state;
  struct {
    carom_shape_plugin known;
    uint64_t tail;
  } newer;
  carom_plugin plugin;
  carom_shape_plugin older = invalid_plugin(ball, NULL);
  older.struct_size = offsetof(carom_shape_plugin, param_tail_group);
  older.param_tail_group = 0xFFFFFFFFu; /* beyond its end: not read */
  older.id = "older";
  assert_int_equal(carom_plugin_register(b->engine, &older, &plugin, NULL), CAROM_OK);
  memset(&newer, 0, sizeof newer);
  newer.known = invalid_plugin(ball, NULL);
  newer.known.struct_size = sizeof newer;
  newer.known.abi_minor = 7;
  newer.tail = 1;
  assert_int_equal(carom_plugin_register(b->engine, &newer.known, &plugin, NULL), CAROM_E_PLUGIN_ABI);
  newer.tail = 0;
  assert_int_equal(carom_plugin_register(b->engine, &newer.known, &plugin, NULL), CAROM_OK);
}

static void a_false_declaration_is_refused_with_its_witness(void** state) {
  Bench* b = *state;
  static const carom_geometry false_form = {sizeof(carom_geometry), CAROM_FORM_BOX,  {0, 0, 0, CAROM_NO_PARAM},
                                            CAROM_NO_PARAM,         CAROM_FORM_NONE, {0, 0, 0, 0}};
  static const carom_geometry false_core = {
      sizeof(carom_geometry), CAROM_FORM_SPHERE, {0, 0, 0, 0}, 0,
      CAROM_FORM_NONE,        {0, 0, 0, 0}}; /* the ball swollen by its radius again */
  static const carom_geometry false_mass = {sizeof(carom_geometry), CAROM_FORM_NONE, {0, 0, 0, 0},
                                            CAROM_NO_PARAM,         CAROM_FORM_BOX,  {0, 0, 0, CAROM_NO_PARAM}};
  static const carom_geometry true_all = {sizeof(carom_geometry), CAROM_FORM_SPHERE, {0, 0, 0, 0},
                                          CAROM_NO_PARAM,         CAROM_FORM_SPHERE, {0, 0, 0, 0}};
  const carom_geometry* lies[] = {&false_form, &false_core, &false_mass};
  const double radius = 0.7;
  size_t i;
  for (i = 0; i < 4; ++i) {
    carom_shape_plugin p = invalid_plugin(ball, i < 3 ? lies[i] : &true_all);
    carom_plugin plugin;
    carom_shape shape = 77;
    carom_error e = CAROM_ERROR_INIT;
    assert_int_equal(carom_plugin_register(b->engine, &p, &plugin, &e), CAROM_OK);
    if (i < 3) {
      assert_int_equal(carom_shape_create(b->engine, plugin, &radius, 1, &shape, &e), CAROM_E_DECLARATION_FALSE);
      assert_int_equal(e.argument, 2);
      assert_int_equal(shape, 77);
      if (i < 2) {
        const double* d = e.witness_dir;
        assert_true(e.has_witness && d[0] * d[0] + d[1] * d[1] + d[2] * d[2] > 0);
      }
    } else {
      assert_int_equal(carom_shape_create(b->engine, plugin, &radius, 1, &shape, &e), CAROM_OK);
      assert_int_equal(carom_shape_destroy(b->engine, shape, &e), CAROM_OK);
    }
    assert_int_equal(carom_plugin_unload(b->engine, plugin, &e), CAROM_OK); /* a refused shape holds nothing */
  }
}

/* Valid near 1, where it is asked at registration; not at 9. */
static int32_t lies_when_large(void* user, const double* params, uint64_t count, const double dir[3], double out[3]) {
  (void)user;
  return params[0] > 5 ? not_convex(NULL, params, count, dir, out) : ball(NULL, params, count, dir, out);
}

static void a_shape_that_lies_for_its_own_parameters_alone_is_refused(void** state) {
  Bench* b = *state;
  carom_shape_plugin p = invalid_plugin(lies_when_large, NULL);
  carom_plugin plugin;
  carom_shape shape;
  const double small = 1, large = 9;
  assert_int_equal(carom_plugin_register(b->engine, &p, &plugin, NULL), CAROM_OK);
  assert_int_equal(carom_shape_create(b->engine, plugin, &large, 1, &shape, NULL), CAROM_E_PLUGIN_INVALID);
  assert_int_equal(carom_shape_create(b->engine, plugin, &small, 1, &shape, NULL), CAROM_OK);
}

/* ---- lies later: valid until told otherwise ---- */

static uint32_t lie = 0; /* 0: valid; else CAROM_FAULT_* */

static int32_t lies_later(void* user, const double* params, uint64_t count, const double dir[3], double out[3]) {
  (void)user;
  ball(NULL, params, count, dir, out);
  if (lie == CAROM_FAULT_RETURNED) return 1;
  if (lie == CAROM_FAULT_NOT_FINITE) out[1] = NAN;
  if (lie == CAROM_FAULT_OUTSIDE) out[1] *= 1e6;
  return 0;
}

static int warnings = 0;
static void count_warnings(void* user, uint32_t level, const char* text) {
  (void)user;
  if (level == CAROM_LOG_WARNING && strstr(text, "quarantine")) ++warnings;
}

static void a_plugin_that_lies_later_is_quarantined_and_the_world_stays_finite(void** state) {
  uint32_t kind;
  (void)state;
  for (kind = CAROM_FAULT_RETURNED; kind <= CAROM_FAULT_OUTSIDE; ++kind) {
    Bench b;
    carom_shape_plugin p = invalid_plugin(lies_later, NULL);
    carom_plugin plugin;
    carom_shape shape;
    carom_body body[2];
    carom_collider collider;
    carom_fault faults[8];
    carom_fault_event events[8];
    carom_step_report report;
    uint64_t count = 0, told = 0;
    double pose[BENCH_BODIES + 3][7];
    const double radius = 0.5;
    size_t i;
    carom_engine_desc desc;
    carom_engine_desc_init(&desc, sizeof desc);
    desc.log = count_warnings;
    lie = 0;
    warnings = 0;
    assert_int_equal(bench_make(&b, &desc, NULL), CAROM_OK);
    assert_int_equal(carom_plugin_register(b.engine, &p, &plugin, NULL), CAROM_OK);
    assert_int_equal(carom_shape_create(b.engine, plugin, &radius, 1, &shape, NULL), CAROM_OK);
    for (i = 0; i < 2; ++i) /* two of them in contact with one another and with the box */
      assert_int_equal(bench_body(b.world, shape, 0, CAROM_BODY_DYNAMIC, 2.25 + 0.9 * (double)i, 3.0, 0.375, &body[i],
                                  &collider, NULL),
                       CAROM_OK);
    assert_int_equal(carom_world_collect_events(b.world, CAROM_EVENTS_FAULT, 0, NULL), CAROM_OK);
    assert_int_equal(bench_steps(b.world, 3, NULL), CAROM_OK);
    assert_int_equal(carom_world_get_faults(b.world, faults, sizeof *faults, 8, &count, NULL), CAROM_OK);
    assert_int_equal(count, 0);

    lie = kind;
    assert_int_equal(carom_world_step(b.world, 1.0 / 64, NULL), CAROM_OK);
    assert_int_equal(carom_world_get_faults(b.world, faults, sizeof *faults, 8, &count, NULL), CAROM_OK);
    assert_true(count >= 1);
    assert_int_equal(faults[0].kind, kind);
    assert_true(faults[0].shape == shape);
    assert_true(faults[0].body == body[0] || faults[0].body == body[1]);
    assert_true(faults[0].dir[0] != 0 || faults[0].dir[1] != 0 || faults[0].dir[2] != 0);
    report.struct_size = sizeof report;
    assert_int_equal(carom_world_get_report(b.world, &report, NULL), CAROM_OK);
    assert_true(report.faults == count);
    assert_int_equal(carom_world_get_fault_events(b.world, events, sizeof *events, 8, &told, NULL), CAROM_OK);
    assert_int_equal(told, count);
    for (i = 0; i < told; ++i) {
      assert_true(events[i].kind == faults[i].kind && events[i].shape == faults[i].shape &&
                  events[i].body == faults[i].body);
      assert_memory_equal(events[i].dir, faults[i].dir, sizeof events[i].dir); /* bits: it may be NaN */
      assert_memory_equal(events[i].out, faults[i].out, sizeof events[i].out);
      assert_true(events[i].step == report.steps);
    }
    assert_int_equal(warnings, count);

    assert_int_equal(bench_steps(b.world, 60, NULL), CAROM_OK);
    assert_int_equal(
        carom_world_read(b.world, CAROM_FIELD_POSE, CAROM_SCALAR_F64, NULL, BENCH_BODIES + 3, pose, 0, NULL), CAROM_OK);
    for (i = 0; i < (BENCH_BODIES + 3) * 7; ++i) assert_true(isfinite(pose[i / 7][i % 7]));
    /* In quarantine it is asked no more. */
    assert_int_equal(carom_world_get_faults(b.world, faults, sizeof *faults, 8, &count, NULL), CAROM_OK);
    assert_int_equal(count, 0);
    lie = 0;
    assert_int_equal(bench_free(&b), CAROM_OK);
  }
}

static void faults_of_a_destroyed_body_are_forgotten_with_it(void** state) {
  Bench b;
  carom_shape_plugin p = invalid_plugin(lies_later, NULL);
  carom_plugin plugin;
  carom_shape shape;
  carom_body body[2];
  carom_collider collider;
  carom_fault faults[8];
  uint64_t count = 0;
  const double radius = 0.5;
  size_t i;
  (void)state;
  lie = 0;
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK);
  assert_int_equal(carom_plugin_register(b.engine, &p, &plugin, NULL), CAROM_OK);
  assert_int_equal(carom_shape_create(b.engine, plugin, &radius, 1, &shape, NULL), CAROM_OK);
  for (i = 0; i < 2; ++i)
    assert_int_equal(
        bench_body(b.world, shape, 0, CAROM_BODY_DYNAMIC, 50 + 0.9 * (double)i, 3, 0, &body[i], &collider, NULL),
        CAROM_OK);
  lie = CAROM_FAULT_RETURNED;
  assert_int_equal(carom_world_step(b.world, 1.0 / 64, NULL), CAROM_OK);
  lie = 0;
  for (i = 0; i < 2; ++i) assert_int_equal(carom_body_destroy(b.world, body[i], NULL), CAROM_OK);
  assert_int_equal(carom_shape_destroy(b.engine, shape, NULL), CAROM_OK);
  /* Reading a fault here would read a shape that is gone: the address sanitizer watches. */
  assert_int_equal(carom_world_get_faults(b.world, faults, sizeof *faults, 8, &count, NULL), CAROM_OK);
  assert_int_equal(count, 0);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/* ---- shared objects ---- */

static void shared_objects_that_lie_are_refused(void** state) {
  static const struct {
    const char* file;
    int32_t code;
  } files[] = {{"wrong_major", CAROM_E_PLUGIN_ABI},
               {"short_struct", CAROM_E_PLUGIN_ABI},
               {"long_struct", CAROM_E_PLUGIN_ABI},
               {"null_support", CAROM_E_PLUGIN_ABI},
               {"no_symbol", CAROM_E_PLUGIN_LOAD},
               {"function_symbol", CAROM_E_PLUGIN_ABI},
               {"valid", CAROM_OK},
               {"valid", CAROM_E_ALREADY_EXISTS}};
  Bench* b = *state;
  size_t i;
  for (i = 0; i < sizeof files / sizeof *files; ++i) {
    char path[1024];
    carom_plugin plugin = 0;
    carom_error e = CAROM_ERROR_INIT;
    int32_t r;
    snprintf(path, sizeof path, "%s/%s.so", CAROM_INVALID_DIR, files[i].file);
    r = carom_plugin_load(b->engine, path, &plugin, &e);
    if (r != files[i].code) print_error("%s: %s %s\n", files[i].file, carom_result_name(r), e.message);
    assert_int_equal(r, files[i].code);
    assert_true((plugin != 0) == (r == CAROM_OK));
  }
}

static int keeps_denormals(void) {
  volatile double smallest = DBL_MIN, half = smallest / 2;
  return half != 0 && half * 2 == smallest;
}

static void a_loader_that_sets_flush_to_zero_does_not_change_our_thread(void** state) {
  Bench* b = *state;
  carom_plugin plugin;
  fenv_t before;
  assert_true(keeps_denormals());
  assert_int_equal(carom_plugin_load(b->engine, CAROM_INVALID_DIR "/flush_to_zero.so", &plugin, NULL), CAROM_OK);
  assert_true(keeps_denormals());
  assert_int_equal(fegetround(), FE_TONEAREST);
  /* The control: loaded by hand (a copy in the second file, for a constructor runs once) it does. */
  fegetenv(&before);
#if defined(__x86_64__)
  assert_non_null(dlopen(CAROM_INVALID_DIR "/flush_to_zero_too.so", RTLD_NOW | RTLD_LOCAL));
  assert_false(keeps_denormals());
#endif
  fesetenv(&before);
  assert_true(keeps_denormals());
}

static void a_step_is_the_same_whatever_the_hosts_float_environment(void** state) {
  Bench a, b;
  fenv_t before;
  (void)state;
  assert_int_equal(bench_make(&a, NULL, NULL), CAROM_OK);
  assert_int_equal(bench_steps(a.world, 50, NULL), CAROM_OK);
  fegetenv(&before);
  fesetround(FE_UPWARD);
  assert_int_equal(bench_make(&b, NULL, NULL), CAROM_OK); /* shapes too */
  assert_int_equal(bench_steps(b.world, 50, NULL), CAROM_OK);
  assert_int_equal(fegetround(), FE_UPWARD); /* and it is given back */
  fesetenv(&before);
  assert_true(bench_hash(a.world) == bench_hash(b.world));
  assert_int_equal(bench_free(&a), CAROM_OK);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/* ---- life ---- */

static void unloading_is_refused_while_shapes_live_and_is_logical(void** state) {
  Bench* b = *state;
  carom_shape_plugin p = invalid_plugin(ball, NULL);
  const carom_shape_plugin* described = NULL;
  carom_plugin plugin, again;
  carom_shape shape;
  const double radius = 1;
  assert_int_equal(carom_plugin_register(b->engine, &p, &plugin, NULL), CAROM_OK);
  assert_int_equal(carom_plugin_describe(b->engine, plugin, &described, NULL), CAROM_OK);
  assert_true(described == &p);
  assert_int_equal(carom_plugin_find(b->engine, "invalid_plugin", &again, NULL), CAROM_OK);
  assert_true(again == plugin);
  assert_int_equal(carom_shape_create(b->engine, plugin, &radius, 1, &shape, NULL), CAROM_OK);
  assert_int_equal(carom_plugin_unload(b->engine, plugin, NULL), CAROM_E_IN_USE);
  assert_int_equal(carom_shape_destroy(b->engine, shape, NULL), CAROM_OK);
  assert_int_equal(carom_plugin_unload(b->engine, plugin, NULL), CAROM_OK);
  assert_int_equal(carom_plugin_find(b->engine, "invalid_plugin", &again, NULL), CAROM_E_NOT_FOUND);
  assert_int_equal(carom_plugin_register(b->engine, &p, &again, NULL), CAROM_OK); /* and may come back */
  assert_true(again != plugin);
}

static void a_tail_of_parameters_comes_in_whole_groups(void** state) {
  Bench* b = *state;
  carom_plugin hull;
  carom_shape shape;
  double p[15] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}, got[15];
  uint64_t count = 15;
  carom_error e = CAROM_ERROR_INIT;
  assert_int_equal(carom_plugin_load(b->engine, CAROM_PLUGIN_DIR "/hull.so", &hull, &e), CAROM_OK);
  assert_int_equal(carom_shape_create(b->engine, hull, p, 13, &shape, &e), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(e.argument, 4);
  assert_int_equal(carom_shape_create(b->engine, hull, p, 0, &shape, &e), CAROM_E_OUT_OF_RANGE);
  p[14] = 1e30;
  assert_int_equal(carom_shape_create(b->engine, hull, p, 15, &shape, &e), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(e.argument, 3);
  p[14] = 1;
  assert_int_equal(carom_shape_create(b->engine, hull, p, 15, &shape, &e), CAROM_OK);
  assert_int_equal(carom_shape_get_params(b->engine, shape, got, &count, &e), CAROM_OK);
  assert_int_equal(count, 15);
  assert_memory_equal(got, p, sizeof p);
}

static void all_plugins_of_the_house_are_taken_in_and_measured(void** state) {
  static const char* names[] = {"template", "sphere", "box", "capsule", "cylinder", "cone", "ellipsoid"};
  Bench* b = *state;
  size_t i;
  for (i = 0; i < sizeof names / sizeof *names; ++i) {
    char path[1024];
    carom_plugin plugin;
    const carom_shape_plugin* d;
    carom_shape shape;
    carom_shape_info info;
    carom_error e = CAROM_ERROR_INIT;
    const double params[4] = {0.5, 0.75, 1.0, 1.25};
    int32_t r;
    int k;
    snprintf(path, sizeof path, "%s/%s.so", CAROM_PLUGIN_DIR, names[i]);
    assert_int_equal(carom_plugin_load(b->engine, path, &plugin, &e), CAROM_OK);
    assert_int_equal(carom_plugin_describe(b->engine, plugin, &d, &e), CAROM_OK);
    r = carom_shape_create(b->engine, plugin, params, d->param_count, &shape, &e);
    if (r) print_error("%s: %s\n", names[i], e.message);
    assert_int_equal(r, CAROM_OK);
    info.struct_size = sizeof info;
    assert_int_equal(carom_shape_get_info(b->engine, shape, &info, &e), CAROM_OK);
    assert_true(info.volume_min <= info.volume && info.volume <= info.volume_max && info.volume > 0);
    assert_true(info.mass_exact == (d->geometry != NULL));
    for (k = 0; k < 3; ++k) assert_true(info.aabb_min[k] < 0 && info.aabb_max[k] > 0);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test_setup_teardown(parameters_that_constrain_each_other_say_so, make, clear),
      cmocka_unit_test_setup_teardown(a_invalid_support_function_is_refused_at_registration, make, clear),
      cmocka_unit_test_setup_teardown(a_nonsensical_struct_is_refused_before_anything_is_called, make, clear),
      cmocka_unit_test_setup_teardown(a_struct_of_an_older_or_newer_minor_version_is_read_as_such, make, clear),
      cmocka_unit_test_setup_teardown(a_false_declaration_is_refused_with_its_witness, make, clear),
      cmocka_unit_test_setup_teardown(a_shape_that_lies_for_its_own_parameters_alone_is_refused, make, clear),
      cmocka_unit_test(a_plugin_that_lies_later_is_quarantined_and_the_world_stays_finite),
      cmocka_unit_test(faults_of_a_destroyed_body_are_forgotten_with_it),
      cmocka_unit_test_setup_teardown(shared_objects_that_lie_are_refused, make, clear),
      cmocka_unit_test_setup_teardown(a_loader_that_sets_flush_to_zero_does_not_change_our_thread, make, clear),
      cmocka_unit_test(a_step_is_the_same_whatever_the_hosts_float_environment),
      cmocka_unit_test_setup_teardown(unloading_is_refused_while_shapes_live_and_is_logical, make, clear),
      cmocka_unit_test_setup_teardown(a_tail_of_parameters_comes_in_whole_groups, make, clear),
      cmocka_unit_test_setup_teardown(all_plugins_of_the_house_are_taken_in_and_measured, make, clear),
  };
  return cmocka_run_group_tests_name("abi/plugins", tests, NULL, NULL);
}
