/* The same bits on every platform, in a form that needs nothing but the library: no test library, no files of ours. One scene
 * with every shape, every kind of joint and every solver; prints a hash a solver, then one of all, and compares it.
 * Then plugins that can't be loaded here: each must be refused with a message that names the file, and with a cure.
 * usage: platform_every [PLUGINS FOLDER]   plugins of one folder, files that are none made in the other; without folders
 *        the shapes that are linked into the library. */
#include <carom/carom.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if defined(_WIN32)
#define ENDING ".dll"
#else
#define ENDING ".so"
#endif
#define COUNT(array) (sizeof(array) / sizeof *(array))
#define TRY(call)                                                                  \
  do {                                                                             \
    if ((call) != CAROM_OK) {                                                      \
      fprintf(stderr, "line %d: %s. %s\n", __LINE__, error.message, error.remedy); \
      exit(1);                                                                     \
    }                                                                              \
  } while (0)

/* Of all hashes below. If bits change, it changes with those of tests/determinism. */
static const uint64_t golden = 0x65c6d98f656229d9u;

static const uint64_t golden_hulls = 0x5de80c9797e28e73u; /* of the heap of hulls of shapes and tapered capsules */

static carom_error error = CAROM_ERROR_INIT;
static carom_engine* engine;

/* ---- the scene ---- */

static const struct {
  const char* name;
  double params[18];
  uint64_t count;
} shapes[] = {{"sphere", {0.3}, 1},
              {"box", {0.4, 0.25, 0.3}, 3},
              {"capsule", {0.2, 0.3}, 2},
              {"cone", {0.3, 0.35}, 2},
              {"cylinder", {0.3, 0.25}, 2},
              {"ellipsoid", {0.4, 0.25, 0.3}, 3},
              {"hull", {0.4, 0, 0, -0.4, 0, 0, 0, 0.3, 0, 0, -0.3, 0, 0, 0, 0.35, 0.1, 0.1, -0.35}, 18}};

static carom_shape shape_of[COUNT(shapes)], ground[3];

static void make_shapes(const char* plugins) {
  static const double up[3] = {0, 1, 0};
  static const double corners[] = {-6, 0, -6, 6, 0, -6, 6, 0.5, 6, -6, 0.25, 6};
  static const uint32_t triangles[] = {0, 3, 2, 0, 2, 1};
  double heights[9 * 9];
  carom_mesh_desc mesh;
  carom_height_field_desc field;
  size_t i;
  if (!plugins) TRY(carom_plugins_register_standard(engine, &error));
  for (i = 0; i < COUNT(shapes); ++i) {
    char path[4096];
    carom_plugin plugin;
    if (plugins) {
      snprintf(path, sizeof path, "%s/%s" ENDING, plugins, shapes[i].name);
      TRY(carom_plugin_load(engine, path, &plugin, &error));
    }
    TRY(carom_shape_create_named(engine, shapes[i].name, shapes[i].params, shapes[i].count, &shape_of[i], &error));
  }
  for (i = 0; i < COUNT(heights); ++i) heights[i] = 0.125 * (double)(i * 5 % 7);
  carom_mesh_desc_init(&mesh, sizeof mesh);
  mesh.vertices = corners, mesh.vertex_count = 4, mesh.triangles = triangles, mesh.triangle_count = 2;
  carom_height_field_desc_init(&field, sizeof field);
  field.columns = field.rows = 9, field.heights = heights, field.spacing[0] = field.spacing[1] = 1;
  TRY(carom_shape_create_half_space(engine, up, 0, &ground[0], &error));
  TRY(carom_shape_create_mesh(engine, &mesh, &ground[1], &error));
  TRY(carom_shape_create_height_field(engine, &field, &ground[2], &error));
}

static carom_body body_at(carom_world* world, uint32_t type, carom_shape shape, double x, double y, double z) {
  carom_body_desc desc;
  carom_collider_desc part;
  carom_body body;
  carom_collider collider;
  carom_body_desc_init(&desc, sizeof desc);
  carom_collider_desc_init(&part, sizeof part);
  desc.type = type, desc.position[0] = x, desc.position[1] = y, desc.position[2] = z;
  desc.angular_velocity[0] = 0.5 * z, desc.angular_velocity[2] = 0.25 * x;
  part.shape = shape;
  if (type == CAROM_BODY_STATIC) desc.angular_velocity[0] = desc.angular_velocity[2] = 0;
  TRY(carom_body_create(world, &desc, &body, &error));
  TRY(carom_collider_create(world, body, &part, &collider, &error));
  return body;
}

static void join(carom_world* world, uint32_t kind, carom_body a, carom_body b, double x, double y) {
  carom_joint_desc desc;
  carom_joint_transmission rope;
  carom_joint_axis axis;
  carom_joint joint;
  carom_joint_desc_init(&desc, sizeof desc);
  desc.kind = kind, desc.fields = CAROM_JOINT_WORLD_FRAME, desc.body_a = a, desc.body_b = b;
  desc.position_a[0] = x, desc.position_a[1] = y, desc.position_a[2] = 0.125;
  desc.orientation_a[1] = -0.6, desc.orientation_a[3] = 0.8;
  TRY(carom_joint_create(world, &desc, &joint, &error));
  if (kind == CAROM_JOINT_PULLEY || kind == CAROM_JOINT_GEAR) {
    carom_joint_transmission_init(&rope, sizeof rope);
    rope.ratio = 1.5;
    if (kind == CAROM_JOINT_PULLEY)
      rope.anchor_a[0] = x - 0.5, rope.anchor_b[0] = x + 0.5, rope.anchor_a[1] = rope.anchor_b[1] = y + 2;
    TRY(carom_joint_set_transmission(world, joint, &rope, &error));
  }
  if (kind == CAROM_JOINT_SIX_AXIS) {
    carom_joint_axis_init(&axis, sizeof axis);
    axis.mode = CAROM_AXIS_MODE_LIMITED, axis.lower = -0.25, axis.upper = 0.5;
    TRY(carom_joint_set_axis(world, joint, 0, &axis, &error));
    TRY(carom_joint_set_axis(world, joint, 3, &axis, &error));
  }
}

/* A heap of 24 shapes on three kinds of ground; for each kind of joint a chain of two bodies in the air. */
static uint64_t hash_of(uint32_t solver, double precision) {
  carom_world* world;
  uint64_t hash;
  int i;
  TRY(carom_world_create(engine, NULL, &world, &error));
  TRY(carom_world_set_dial(world, CAROM_DIAL_SOLVER, solver, &error));
  TRY(carom_world_set_dial(world, CAROM_DIAL_PRECISION, precision, &error));
  body_at(world, CAROM_BODY_STATIC, ground[0], 0, -1, 0);
  body_at(world, CAROM_BODY_STATIC, ground[1], -6, 0, 0);
  body_at(world, CAROM_BODY_STATIC, ground[2], 2, 0, -4);
  for (i = 0; i < 24; ++i)
    body_at(world, CAROM_BODY_DYNAMIC, shape_of[i % 7], (i % 4) * 2.5 - 5, 1.25 + 0.5 * (i / 4), (i % 3) * 0.5 - 0.5);
  for (i = 0; i < (int)CAROM_JOINT_COUPLING && solver != CAROM_SOLVER_SEVERITY; ++i) { /* that one takes none */
    const double x = 1.5 * i - 6;
    const carom_body a = body_at(world, CAROM_BODY_DYNAMIC, shape_of[i % 7], x, 8, 0),
                     b = body_at(world, CAROM_BODY_DYNAMIC, shape_of[1], x + 0.75, 8.25, 0.25);
    join(world, CAROM_JOINT_BALL, CAROM_NULL_HANDLE, a, x - 0.25, 8.5);
    join(world, (uint32_t)i, a, b, x + 0.375, 8.125);
  }
  for (i = 0; i < 120; ++i) TRY(carom_world_step(world, 1.0 / 60, &error));
  TRY(carom_world_hash(world, &hash, &error));
  TRY(carom_world_destroy(world, &error));
  printf("  solver %u, %s: %016llx\n", solver, precision == CAROM_PRECISION_FLOAT ? "contacts in floats" : "doubles",
         (unsigned long long)hash);
  return hash;
}

/* A heap of tapered capsules, sweeps, rounded and scaled shapes. After the scene above, whose bits are older. */
static uint64_t hash_of_hulls(const char* plugins) {
  static const double tapered[3] = {0.3, 0.15, 0.3}, turn[8] = {0, 0.6, 0, 0.8, 0, 0, 0, 1};
  static const double apart[6] = {-0.25, 0, 0, 0.25, 0.125, 0}, scale[6] = {1, 0.5, 1, 0.75, -1, 1.25};
  carom_shape made[5], two[2];
  carom_world* world;
  uint64_t hash;
  int i;
  if (plugins) {
    char path[4096];
    carom_plugin plugin;
    snprintf(path, sizeof path, "%s/tapered_capsule" ENDING, plugins);
    TRY(carom_plugin_load(engine, path, &plugin, &error));
  }
  TRY(carom_shape_create_named(engine, "tapered_capsule", tapered, 3, &made[0], &error));
  two[0] = two[1] = shape_of[1]; /* corners alone: a polytope */
  TRY(carom_shape_create_hull_of(engine, two, 2, apart, turn, NULL, 0, &made[1], &error));
  two[0] = shape_of[0], two[1] = shape_of[5];
  TRY(carom_shape_create_hull_of(engine, two, 2, apart, turn, scale, 0, &made[2], &error));
  two[0] = shape_of[1], two[1] = shape_of[2];
  TRY(carom_shape_create_hull_of(engine, two, 2, apart, NULL, scale, 0.0625, &made[3], &error));
  two[0] = made[3], two[1] = made[0];
  TRY(carom_shape_create_hull_of(engine, two, 2, apart, turn, NULL, 0, &made[4], &error));
  TRY(carom_world_create(engine, NULL, &world, &error));
  body_at(world, CAROM_BODY_STATIC, ground[0], 0, 0, 0);
  for (i = 0; i < 20; ++i)
    body_at(world, CAROM_BODY_DYNAMIC, made[i % 5], (i % 4) * 1.25 - 2, 1 + 0.75 * (i / 4), (i % 3) * 0.5 - 0.5);
  for (i = 0; i < 120; ++i) TRY(carom_world_step(world, 1.0 / 60, &error));
  TRY(carom_world_hash(world, &hash, &error));
  TRY(carom_world_destroy(world, &error));
  return hash;
}

/* ---- plugins that are none here ---- */

static int wrong = 0;

static void refused(const char* path, int32_t code, const char* says, const char* cure) {
  carom_error e = CAROM_ERROR_INIT;
  carom_plugin plugin = 0;
  const int32_t result = carom_plugin_load(engine, path, &plugin, &e);
  const char* name = strrchr(path, '/');
  if (result == code && strstr(e.message, name ? name + 1 : path) && strstr(e.message, says) && strstr(e.remedy, cure))
    return;
  fprintf(stderr, "%s: %s: %s. %s\n  expected: %s: ...%s..., %s\n", path, carom_result_name(result), e.message,
          e.remedy, carom_result_name(code), says, cure);
  ++wrong;
}

static void refused_bytes(const char* folder, const char* name, const void* bytes, size_t size, const char* says,
                          const char* cure) {
  char path[4096];
  FILE* file;
  snprintf(path, sizeof path, "%s/%s" ENDING, folder, name);
  file = fopen(path, "wb");
  if (!file || fwrite(bytes, 1, size, file) != size || fclose(file)) {
    fprintf(stderr, "cannot write %s\n", path);
    exit(1);
  }
  refused(path, CAROM_E_PLUGIN_LOAD, says, cure);
#if !defined(__wasm__) /* it has no files */
  remove(path);
#endif
}

static void refused_copy(const char* plugins, const char* folder) { /* the beginning of one: a copy that broke off */
  char path[4096], half[512];
  FILE* file;
  snprintf(path, sizeof path, "%s/box" ENDING, plugins);
  file = fopen(path, "rb");
  if (!file || fread(half, 1, sizeof half, file) != sizeof half) exit(1);
  fclose(file);
  refused_bytes(folder, "half", half, sizeof half, "", "build");
}

#if defined(__linux__)
/* A plugin whose text says something else: of a library that it needs, or of the C library that it was linked with. */
static void refused_altered(const char* folder, const char* old, const char* new_text, const char* cure) {
  static char image[1 << 20];
  char path[4096];
  const size_t length = strlen(old);
  size_t size, i, found = 0;
  FILE* file;
  snprintf(path, sizeof path, "%s/calls_c" ENDING, folder);
  file = fopen(path, "rb");
  size = file ? fread(image, 1, sizeof image, file) : 0;
  if (!size || size == sizeof image || fclose(file)) exit(1);
  for (i = 0; i + length < size; ++i)
    if (!memcmp(image + i, old, length)) memcpy(image + i, new_text, length), ++found;
  if (found) refused_bytes(folder, "altered", image, size, new_text, cure); /* musl has no such words */
}
#endif

/* The first bytes of shared objects: of a format, and in it the number of a machine. */
static const struct {
  const char *system, *machine;
  char bytes[8];
  size_t machine_at, machine_bytes;
  uint32_t machine_number;
} kinds[] = {{"Linux (ELF)", "x86-64", "\177ELF\2\1\1", 18, 2, 62},
             {"Linux (ELF)", "arm64", "\177ELF\2\1\1", 18, 2, 183},
             {"Linux (ELF)", "RISC-V", "\177ELF\2\1\1", 18, 2, 243},
             {"macOS", "x86-64", "\xCF\xFA\xED\xFE", 4, 4, 0x01000007},
             {"macOS", "arm64", "\xCF\xFA\xED\xFE", 4, 4, 0x0100000C},
             {"Windows", "x86-64", "MZ", 4, 2, 0x8664},
             {"Windows", "arm64", "MZ", 4, 2, 0xAA64},
             {"WebAssembly", "", "\0asm\1", 0, 0, 0}};
#if defined(_WIN32)
static const char* const this_system = "Windows";
#elif defined(__APPLE__)
static const char* const this_system = "macOS";
#else
static const char* const this_system = "Linux (ELF)";
#endif
#if defined(__aarch64__)
static const char* const this_machine = "arm64";
#else
static const char* const this_machine = "x86-64";
#endif

static void wrong_files(const char* plugins, const char* folder) {
  char path[4096], says[200];
  size_t i, k;
  for (i = 0; i < COUNT(kinds); ++i) {
    unsigned char head[256] = {0};
    if (!strcmp(kinds[i].system, this_system) && !strcmp(kinds[i].machine, this_machine)) continue;
    memcpy(head, kinds[i].bytes, 7);
    for (k = 0; k < kinds[i].machine_bytes; ++k)
      head[kinds[i].machine_at + k + (head[0] == 'M' ? 0x80 : 0)] = kinds[i].machine_number >> 8 * k & 255;
    if (head[0] == 'M') head[0x3C] = 0x80, memcpy(head + 0x80, "PE", 2);
    snprintf(says, sizeof says, "%s%s%s, this program for ", kinds[i].system, kinds[i].machine[0] ? ", " : "",
             kinds[i].machine);
    refused_bytes(folder, "other", head, sizeof head, says, "build the plugin again");
  }
  refused_bytes(folder, "text", "int support(void);\n", 19, "no shared object", "the compiler made");
  refused_bytes(folder, "empty", "", 0, "no shared object", "the compiler made");
  refused_copy(plugins, folder);
#if defined(__linux__)
  refused_altered(folder, "libc.so.6", "libc.so.9", "install the library that is named");
  refused_altered(folder, "GLIBC_2.", "GLIBC_9.", "build the plugin on this system");
#endif
  refused("box" ENDING, CAROM_E_PLUGIN_PATH, "not an absolute path", "absolute path");
  refused(folder, CAROM_E_PLUGIN_PATH, "not a readable file", "absolute path");
  snprintf(path, sizeof path, "%s/there_is_none" ENDING, folder);
  refused(path, CAROM_E_PLUGIN_PATH, "not a readable file", "absolute path");
  /* Shared objects of this system that are no plugins, or of another version: tests/abi/invalid_plugins. */
  snprintf(path, sizeof path, "%s/no_symbol" ENDING, folder);
  refused(path, CAROM_E_PLUGIN_LOAD, CAROM_SHAPE_PLUGIN_SYMBOL, CAROM_SHAPE_PLUGIN_SYMBOL);
  snprintf(path, sizeof path, "%s/function_symbol" ENDING, folder);
  refused(path, CAROM_E_PLUGIN_ABI, "no data but something else", "rebuild the plugin");
  snprintf(path, sizeof path, "%s/wrong_major" ENDING, folder);
  refused(path, CAROM_E_PLUGIN_ABI, "abi_major", "rebuild the plugin");
  snprintf(path, sizeof path, "%s/short_struct" ENDING, folder);
  refused(path, CAROM_E_PLUGIN_ABI, "", "rebuild the plugin");
  snprintf(path, sizeof path, "%s/long_struct" ENDING, folder);
  refused(path, CAROM_E_PLUGIN_ABI, "plugin", "rebuild the plugin"); /* by the size of the symbol, where it is known */
}

/* Plugins are found by name beside the library, and of others it is said where they were looked for. */
static void names(void) {
  carom_error e = CAROM_ERROR_INIT;
  carom_shape shape;
  const double radius = 1, top[2] = {0.3, 0.35};
  if (carom_shape_create_named(engine, "template", top, 2, &shape, &e) != CAROM_OK)
    fprintf(stderr, "by name: %s. %s\n", e.message, e.remedy), ++wrong;
  if (carom_shape_create_named(engine, "there_is_none", &radius, 1, &shape, &e) != CAROM_E_NOT_FOUND ||
      !strstr(e.message, "there_is_none") || !strstr(e.message, "plugins") || !strstr(e.remedy, "CAROM_PLUGIN_PATH"))
    fprintf(stderr, "by name: %s. %s\n", e.message, e.remedy), ++wrong;
}

int main(int argc, char** argv) {
  static const double precisions[] = {CAROM_PRECISION_DOUBLE, CAROM_PRECISION_FLOAT};
  uint64_t all = 0, hulls;
  uint32_t solver;
  size_t k;
  const char* plugins = argc > 2 ? argv[1] : NULL;
  TRY(carom_engine_create(NULL, &engine, &error));
  make_shapes(plugins);
  for (solver = 0; solver <= CAROM_SOLVER_AUTO; ++solver)
    for (k = 0; k < COUNT(precisions); ++k) all = (all ^ hash_of(solver, precisions[k])) * 0x100000001B3u + solver;
  hulls = hash_of_hulls(plugins);
  if (plugins) wrong_files(plugins, argv[2]), names();
  printf("every shape, joint and solver: %016llx\n", (unsigned long long)all);
  if (all != golden) fprintf(stderr, "  other platforms have %016llx\n", (unsigned long long)golden), ++wrong;
  printf("hulls of shapes: %016llx\n", (unsigned long long)hulls);
  if (hulls != golden_hulls)
    fprintf(stderr, "  other platforms have %016llx\n", (unsigned long long)golden_hulls), ++wrong;
  TRY(carom_engine_destroy(engine, &error));
  return wrong != 0;
}
