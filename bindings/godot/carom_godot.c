// The class CaromWorld for Godot 4.2 and newer: bodies, shapes, joints, rays, snapshots. Plain C on Godot's interface header.
#include <carom/carom.h>
#include <gdextension_interface.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Names of types as the tables below write them.
enum {
  NOTHING = GDEXTENSION_VARIANT_TYPE_NIL,
  TRUTH = GDEXTENSION_VARIANT_TYPE_BOOL,
  WHOLE = GDEXTENSION_VARIANT_TYPE_INT,
  NUMBER = GDEXTENSION_VARIANT_TYPE_FLOAT,
  TEXT = GDEXTENSION_VARIANT_TYPE_STRING,
  VECTOR = GDEXTENSION_VARIANT_TYPE_VECTOR3,
  PLACE = GDEXTENSION_VARIANT_TYPE_TRANSFORM3D,
  TABLE = GDEXTENSION_VARIANT_TYPE_DICTIONARY,
  BYTES = GDEXTENSION_VARIANT_TYPE_PACKED_BYTE_ARRAY,
  FLOATS = GDEXTENSION_VARIANT_TYPE_PACKED_FLOAT32_ARRAY,
  DOUBLES = GDEXTENSION_VARIANT_TYPE_PACKED_FLOAT64_ARRAY,
  TYPES = GDEXTENSION_VARIANT_TYPE_VARIANT_MAX
};

#ifdef GODOT_DOUBLE  // a Godot that was built with precision=double
typedef double real;
#else
typedef float real;
#endif
typedef struct {
  real x, y, z;
} vector;
typedef struct {
  vector row[3];  // of the basis
  vector origin;
} place;
// Room for any value of Godot's, a Variant too.
typedef union {
  place room;
  int64_t whole;
  double number;
  char bytes[64];
} value;

// Godot's functions that are called, under their names.
#define CALLED(X)                                                                    \
  X(ClassdbConstructObject, classdb_construct_object)                                \
  X(ClassdbRegisterExtensionClass2, classdb_register_extension_class2)               \
  X(ClassdbRegisterExtensionClassMethod, classdb_register_extension_class_method)    \
  X(ClassdbUnregisterExtensionClass, classdb_unregister_extension_class)             \
  X(ObjectSetInstance, object_set_instance)                                          \
  X(PrintErrorWithMessage, print_error_with_message)                                 \
  X(StringNewWithUtf8Chars, string_new_with_utf8_chars)                              \
  X(StringToUtf8Chars, string_to_utf8_chars)                                         \
  X(StringNameNewWithLatin1Chars, string_name_new_with_latin1_chars)                 \
  X(VariantDestroy, variant_destroy)                                                 \
  X(VariantGetType, variant_get_type)                                                \
  X(VariantCanConvertStrict, variant_can_convert_strict)                             \
  X(GetVariantFromTypeConstructor, get_variant_from_type_constructor)                \
  X(GetVariantToTypeConstructor, get_variant_to_type_constructor)                    \
  X(VariantGetPtrConstructor, variant_get_ptr_constructor)                           \
  X(VariantGetPtrDestructor, variant_get_ptr_destructor)                             \
  X(VariantGetPtrBuiltinMethod, variant_get_ptr_builtin_method)                      \
  X(PackedByteArrayOperatorIndex, packed_byte_array_operator_index)                  \
  X(PackedByteArrayOperatorIndexConst, packed_byte_array_operator_index_const)       \
  X(PackedFloat32ArrayOperatorIndex, packed_float32_array_operator_index)            \
  X(PackedFloat64ArrayOperatorIndexConst, packed_float64_array_operator_index_const) \
  X(DictionaryOperatorIndex, dictionary_operator_index)

#define FIELD(type, name) GDExtensionInterface##type name;
static struct {
  CALLED(FIELD)
  GDExtensionClassLibraryPtr library;
  GDExtensionVariantFromTypeConstructorFunc wrap[TYPES];
  GDExtensionTypeFromVariantConstructorFunc unwrap[TYPES];
  GDExtensionPtrConstructor make[TYPES];
  GDExtensionPtrDestructor destroy[TYPES];  // NULL of what needs none
  GDExtensionPtrBuiltInMethod size[TYPES], resize[TYPES];
  value class_name, parent_name, empty_name, empty_text;
} godot;
static carom_engine* engine;  // one for all worlds

// What an instance of the class is.
typedef struct {
  carom_world* world;
} owner;

#define OF(T, at) (*(const T*)(at))
typedef const GDExtensionConstTypePtr* arguments;

// Whether a call went well; else Godot shows what was wrong and what to do.
static bool done(int32_t code, const carom_error* e) {
  char text[sizeof e->message + sizeof e->remedy + 16];
  if (code == CAROM_OK) return true;
  snprintf(text, sizeof text, "%s. Remedy: %s", e->message, e->remedy);
  godot.print_error_with_message(carom_result_name(code), text, "CaromWorld", "carom_godot.c", 0, 1);
  return false;
}
#define CALL(function, ...) done(function(__VA_ARGS__, &error), &error)
#define ERROR carom_error error = {.struct_size = sizeof error}

static void put3(double to[3], vector v) { to[0] = v.x, to[1] = v.y, to[2] = v.z; }
static vector get3(const double v[3]) { return (vector){(real)v[0], (real)v[1], (real)v[2]}; }

// The rotation of a basis, x, y, z, w, of the largest of its four numbers. Godot's bases may be scaled: carom's may not.
static void rotation_of(const place* p, double q[4]) {
  double m[3][3], size = 0;
  for (int i = 0; i < 3; ++i) put3(m[i], p->row[i]);
  for (int j = 0; j < 3; ++j) {
    double n = 0;
    for (int i = 0; i < 3; ++i) n += m[i][j] * m[i][j];
    for (int i = 0; i < 3 && n > 0; ++i) m[i][j] /= sqrt(n);
  }
  const double trace = m[0][0] + m[1][1] + m[2][2];
  int k = 0;
  for (int i = 1; i < 3; ++i) k = m[i][i] > m[k][k] ? i : k;
  if (trace >= m[k][k]) {
    q[0] = m[2][1] - m[1][2], q[1] = m[0][2] - m[2][0], q[2] = m[1][0] - m[0][1], q[3] = 1 + trace;
  } else {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    q[k] = 1 + 2 * m[k][k] - trace, q[a] = m[k][a] + m[a][k], q[b] = m[k][b] + m[b][k], q[3] = m[b][a] - m[a][b];
  }
  for (int i = 0; i < 4; ++i) size += q[i] * q[i];
  for (int i = 0; i < 4; ++i) q[i] /= sqrt(size);
}

static place place_of(const double pose[7]) {
  const double *q = pose + 3, x = q[0], y = q[1], z = q[2], w = q[3];
  const double m[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                          {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                          {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
  return (place){{get3(m[0]), get3(m[1]), get3(m[2])}, get3(pose)};
}

static int64_t size_of(int type, GDExtensionConstTypePtr array) {
  int64_t n = 0;
  godot.size[type]((GDExtensionTypePtr)array, NULL, (GDExtensionTypePtr)&n, 0);
  return n;
}

static void resize(int type, void* array, int64_t n) {
  int64_t result = 0;
  const GDExtensionConstTypePtr given[] = {(GDExtensionConstTypePtr)&n};
  godot.resize[type](array, given, (GDExtensionTypePtr)&result, 1);
}

// A shape by the name of its plugin, a text of Godot's, and its parameters, doubles of Godot's.
static bool shape_of(GDExtensionConstTypePtr name, GDExtensionConstTypePtr params, carom_shape* shape) {
  char text[256] = {0};
  const int64_t n = size_of(DOUBLES, params);
  const double none = 0;
  ERROR;
  godot.string_to_utf8_chars((GDExtensionConstStringPtr)name, text, sizeof text - 1);
  return CALL(carom_shape_create_named, engine, text,
              n ? godot.packed_float64_array_operator_index_const(params, 0) : &none, (uint64_t)n, shape);
}

static bool add_collider(owner* o, carom_body body, carom_shape shape, const place* at) {
  carom_collider_desc part;
  carom_collider collider;
  ERROR;
  carom_collider_desc_init(&part, sizeof part);
  part.shape = shape;
  if (at) put3(part.position, at->origin), rotation_of(at, part.orientation);
  return CALL(carom_collider_create, o->world, body, &part, &collider);
}

// The methods. A handle is a whole number, 0 where a call failed.

static void add_body(owner* o, arguments a, void* ret) {  // type, shape, params, place
  const place* at = (const place*)a[3];
  carom_body_desc desc;
  carom_body body = 0;
  carom_shape shape;
  ERROR;
  *(int64_t*)ret = 0;
  carom_body_desc_init(&desc, sizeof desc);
  desc.type = (uint32_t)OF(int64_t, a[0]);
  put3(desc.position, at->origin), rotation_of(at, desc.orientation);
  if (!shape_of(a[1], a[2], &shape) || !CALL(carom_body_create, o->world, &desc, &body)) return;
  if (add_collider(o, body, shape, NULL))
    *(int64_t*)ret = (int64_t)body;
  else
    carom_body_destroy(o->world, body, NULL);
}

static void add_shape(owner* o, arguments a, void* ret) {  // body, shape, params, place
  carom_shape shape;
  *(GDExtensionBool*)ret =
      shape_of(a[1], a[2], &shape) && add_collider(o, (carom_body)OF(int64_t, a[0]), shape, (const place*)a[3]);
}

static void destroy_body(owner* o, arguments a, void* ret) {
  ERROR;
  *(GDExtensionBool*)ret = CALL(carom_body_destroy, o->world, (carom_body)OF(int64_t, a[0]));
}

static void step(owner* o, arguments a, void* ret) {  // s
  ERROR;
  *(GDExtensionBool*)ret = CALL(carom_world_step, o->world, OF(double, a[0]));
}

static void get_body_transform(owner* o, arguments a, void* ret) {
  double pose[7] = {0, 0, 0, 0, 0, 0, 1};
  ERROR;
  CALL(carom_body_get_pose, o->world, (carom_body)OF(int64_t, a[0]), pose, pose + 3);
  *(place*)ret = place_of(pose);
}

static void set_body_transform(owner* o, arguments a, void* ret) {  // body, place
  const place* at = (const place*)a[1];
  double p[3], q[4];
  ERROR;
  put3(p, at->origin), rotation_of(at, q);
  *(GDExtensionBool*)ret = CALL(carom_body_set_pose, o->world, (carom_body)OF(int64_t, a[0]), p, q);
}

static void velocity_of(owner* o, arguments a, void* ret, int which) {
  double v[2][3] = {{0}};
  ERROR;
  CALL(carom_body_get_velocity, o->world, (carom_body)OF(int64_t, a[0]), v[0], v[1]);
  *(vector*)ret = get3(v[which]);
}
static void get_linear_velocity(owner* o, arguments a, void* ret) { velocity_of(o, a, ret, 0); }
static void get_angular_velocity(owner* o, arguments a, void* ret) { velocity_of(o, a, ret, 1); }

static void set_velocity(owner* o, arguments a, void* ret) {  // body, m/s, rad/s
  double v[3], w[3];
  ERROR;
  put3(v, OF(vector, a[1])), put3(w, OF(vector, a[2]));
  *(GDExtensionBool*)ret = CALL(carom_body_set_velocity, o->world, (carom_body)OF(int64_t, a[0]), v, w);
}

static void add_force(owner* o, arguments a, void* ret) {  // body, N, N m
  double f[3], t[3];
  ERROR;
  put3(f, OF(vector, a[1])), put3(t, OF(vector, a[2]));
  *(GDExtensionBool*)ret = CALL(carom_body_add_force, o->world, (carom_body)OF(int64_t, a[0]), f, t);
}

static void add_joint(owner* o, arguments a, void* ret) {  // kind, body a or 0, body b, place in the world
  const place* at = (const place*)a[3];
  carom_joint_desc desc;
  carom_joint joint = 0;
  ERROR;
  carom_joint_desc_init(&desc, sizeof desc);
  desc.kind = (uint32_t)OF(int64_t, a[0]);
  desc.fields = CAROM_JOINT_WORLD_FRAME;
  desc.body_a = (carom_body)OF(int64_t, a[1]), desc.body_b = (carom_body)OF(int64_t, a[2]);
  put3(desc.position_a, at->origin), rotation_of(at, desc.orientation_a);
  *(int64_t*)ret = CALL(carom_joint_create, o->world, &desc, &joint) ? (int64_t)joint : 0;
}

static void set_joint_motor(owner* o, arguments a, void* ret) {  // joint, coordinate, speed, greatest force
  carom_joint_motor motor;
  ERROR;
  carom_joint_motor_init(&motor, sizeof motor);
  motor.enabled = 1, motor.speed = OF(double, a[2]), motor.max_force = OF(double, a[3]);
  *(GDExtensionBool*)ret =
      CALL(carom_joint_set_motor, o->world, (carom_joint)OF(int64_t, a[0]), (uint32_t)OF(int64_t, a[1]), &motor);
}

static void set_joint_limit(owner* o, arguments a, void* ret) {  // joint, coordinate, lower, upper
  carom_joint_limit limit;
  ERROR;
  carom_joint_limit_init(&limit, sizeof limit);
  limit.enabled = 1, limit.lower = OF(double, a[2]), limit.upper = OF(double, a[3]);
  *(GDExtensionBool*)ret =
      CALL(carom_joint_set_limit, o->world, (carom_joint)OF(int64_t, a[0]), (uint32_t)OF(int64_t, a[1]), &limit);
}

// @return a table of what a ray meets first; empty where it meets nothing
static void put(void* table, const char* name, int type, void* it) {
  value text, key;
  godot.string_new_with_utf8_chars((GDExtensionUninitializedStringPtr)&text, name);
  godot.wrap[TEXT]((GDExtensionUninitializedVariantPtr)&key, (GDExtensionTypePtr)&text);
  GDExtensionVariantPtr at = godot.dictionary_operator_index(table, (GDExtensionConstVariantPtr)&key);
  godot.variant_destroy(at);
  godot.wrap[type]((GDExtensionUninitializedVariantPtr)at, it);
  godot.variant_destroy((GDExtensionVariantPtr)&key);
  godot.destroy[TEXT]((GDExtensionTypePtr)&text);
}

static void intersect_ray(owner* o, arguments a, void* ret) {  // from, to
  double from[3], way[3];
  carom_world_hit hit;
  ERROR;
  put3(from, OF(vector, a[0])), put3(way, OF(vector, a[1]));
  for (int i = 0; i < 3; ++i) way[i] -= from[i];
  if (!CALL(carom_world_cast_ray, o->world, from, way, 1, NULL, &hit, sizeof hit) || hit.outcome == CAROM_CAST_MISS)
    return;
  int64_t body = (int64_t)hit.body;
  vector point = get3(hit.point),
         normal = {(real)-hit.normal[0], (real)-hit.normal[1], (real)-hit.normal[2]};  // out of the body, as Godot's
  put(ret, "body", WHOLE, &body);
  put(ret, "position", VECTOR, &point);
  put(ret, "normal", VECTOR, &normal);
  put(ret, "fraction", NUMBER, &hit.time);
}

static void get_transforms(owner* o, arguments a, void* ret) {  // of all bodies, as MultiMesh.buffer has them
  uint64_t n = 0;
  ERROR;
  (void)a;
  if (!CALL(carom_world_get_bodies, o->world, NULL, 0, &n)) return;
  double(*pose)[7] = malloc(n * sizeof *pose + 1);
  resize(FLOATS, ret, (int64_t)(12 * n));
  if (n && CALL(carom_world_read, o->world, CAROM_FIELD_POSE, CAROM_SCALAR_F64, NULL, n, pose, sizeof *pose)) {
    float* out = godot.packed_float32_array_operator_index(ret, 0);
    for (uint64_t i = 0; i < n; ++i) {
      const place p = place_of(pose[i]);
      const real origin[] = {p.origin.x, p.origin.y, p.origin.z};
      for (int r = 0; r < 3; ++r, out += 4)
        out[0] = (float)p.row[r].x, out[1] = (float)p.row[r].y, out[2] = (float)p.row[r].z, out[3] = (float)origin[r];
    }
  }
  free(pose);
}

static void save(owner* o, arguments a, void* ret) {
  uint64_t n = 0;
  ERROR;
  (void)a;
  carom_world_save(o->world, CAROM_SNAPSHOT_STATE, NULL, 0, &n, NULL);  // says how many
  resize(BYTES, ret, (int64_t)n);
  if (n) CALL(carom_world_save, o->world, CAROM_SNAPSHOT_STATE, godot.packed_byte_array_operator_index(ret, 0), n, &n);
}

static void restore(owner* o, arguments a, void* ret) {
  const int64_t n = size_of(BYTES, a[0]);
  ERROR;
  *(GDExtensionBool*)ret =
      CALL(carom_world_restore, o->world,
           n ? godot.packed_byte_array_operator_index_const(a[0], 0) : (const uint8_t*)"", (uint64_t)n);
}

static void hash(owner* o, arguments a, void* ret) {
  uint64_t h = 0;
  ERROR;
  (void)a;
  CALL(carom_world_hash, o->world, &h);
  *(int64_t*)ret = (int64_t)h;
}

static void set_dial(owner* o, arguments a, void* ret) {  // name, value
  char name[256] = {0};
  uint32_t dial = 0;
  ERROR;
  godot.string_to_utf8_chars((GDExtensionConstStringPtr)a[0], name, sizeof name - 1);
  *(GDExtensionBool*)ret =
      CALL(carom_dial_find, name, &dial) && CALL(carom_world_set_dial, o->world, dial, OF(double, a[1]));
}

enum { MOST = 4 };  // arguments
typedef struct {
  const char* name;
  void (*run)(owner*, arguments, void*);
  int returns, takes[MOST];  // types; NOTHING ends them
  const char* names[MOST];
} method;

static const method METHODS[] = {
    {"add_body", add_body, WHOLE, {WHOLE, TEXT, DOUBLES, PLACE}, {"type", "shape", "params", "transform"}},
    {"add_shape", add_shape, TRUTH, {WHOLE, TEXT, DOUBLES, PLACE}, {"body", "shape", "params", "transform"}},
    {"destroy_body", destroy_body, TRUTH, {WHOLE}, {"body"}},
    {"step", step, TRUTH, {NUMBER}, {"delta"}},
    {"get_body_transform", get_body_transform, PLACE, {WHOLE}, {"body"}},
    {"set_body_transform", set_body_transform, TRUTH, {WHOLE, PLACE}, {"body", "transform"}},
    {"get_linear_velocity", get_linear_velocity, VECTOR, {WHOLE}, {"body"}},
    {"get_angular_velocity", get_angular_velocity, VECTOR, {WHOLE}, {"body"}},
    {"set_velocity", set_velocity, TRUTH, {WHOLE, VECTOR, VECTOR}, {"body", "linear", "angular"}},
    {"add_force", add_force, TRUTH, {WHOLE, VECTOR, VECTOR}, {"body", "force", "torque"}},
    {"add_joint", add_joint, WHOLE, {WHOLE, WHOLE, WHOLE, PLACE}, {"kind", "body_a", "body_b", "transform"}},
    {"set_joint_motor",
     set_joint_motor,
     TRUTH,
     {WHOLE, WHOLE, NUMBER, NUMBER},
     {"joint", "coordinate", "speed", "max_force"}},
    {"set_joint_limit",
     set_joint_limit,
     TRUTH,
     {WHOLE, WHOLE, NUMBER, NUMBER},
     {"joint", "coordinate", "lower", "upper"}},
    {"intersect_ray", intersect_ray, TABLE, {VECTOR, VECTOR}, {"from", "to"}},
    {"get_transforms", get_transforms, FLOATS, {NOTHING}, {NULL}},
    {"save", save, BYTES, {NOTHING}, {NULL}},
    {"restore", restore, TRUTH, {BYTES}, {"bytes"}},
    {"hash", hash, WHOLE, {NOTHING}, {NULL}},
    {"set_dial", set_dial, TRUTH, {TEXT, NUMBER}, {"dial", "value"}},
};
enum { METHOD_COUNT = sizeof METHODS / sizeof *METHODS };

static int count_of(const method* m) {
  int n = 0;
  while (n < MOST && m->takes[n] != NOTHING) ++n;
  return n;
}

// Godot calls so where it knows the types: values as they are, and one that is there to be written.
static void call_typed(void* data, GDExtensionClassInstancePtr self, const GDExtensionConstTypePtr* given,
                       GDExtensionTypePtr ret) {
  ((const method*)data)->run((owner*)self, given, ret);
}

// And so from a script that does not: as Variants.
static void call_variants(void* data, GDExtensionClassInstancePtr self, const GDExtensionConstVariantPtr* given,
                          GDExtensionInt count, GDExtensionVariantPtr ret, GDExtensionCallError* error) {
  const method* m = data;
  const int wanted = count_of(m);
  value in[MOST], out;
  GDExtensionConstTypePtr at[MOST];
  error->error = GDEXTENSION_CALL_OK;
  if (count != wanted) {
    error->error =
        count < wanted ? GDEXTENSION_CALL_ERROR_TOO_FEW_ARGUMENTS : GDEXTENSION_CALL_ERROR_TOO_MANY_ARGUMENTS;
    error->argument = error->expected = wanted;
    return;
  }
  for (int i = 0; i < wanted; ++i) {
    const int type = (int)godot.variant_get_type(given[i]);
    if (godot.variant_can_convert_strict((GDExtensionVariantType)type, (GDExtensionVariantType)m->takes[i])) continue;
    error->error = GDEXTENSION_CALL_ERROR_INVALID_ARGUMENT;
    error->argument = i, error->expected = m->takes[i];
    return;
  }
  for (int i = 0; i < wanted; ++i) {
    godot.unwrap[m->takes[i]]((GDExtensionUninitializedTypePtr)&in[i], (GDExtensionVariantPtr)given[i]);
    at[i] = (GDExtensionConstTypePtr)&in[i];
  }
  godot.make[m->returns]((GDExtensionUninitializedTypePtr)&out, NULL);
  m->run((owner*)self, at, &out);
  godot.variant_destroy(ret);
  godot.wrap[m->returns]((GDExtensionUninitializedVariantPtr)ret, (GDExtensionTypePtr)&out);
  if (godot.destroy[m->returns]) godot.destroy[m->returns]((GDExtensionTypePtr)&out);
  for (int i = 0; i < wanted; ++i)
    if (godot.destroy[m->takes[i]]) godot.destroy[m->takes[i]]((GDExtensionTypePtr)&in[i]);
}

static GDExtensionObjectPtr create(void* data) {
  owner* o = calloc(1, sizeof *o);
  ERROR;
  (void)data;
  CALL(carom_world_create, engine, NULL, &o->world);  // of a world that is NULL each call says so
  GDExtensionObjectPtr object = godot.classdb_construct_object((GDExtensionConstStringNamePtr)&godot.parent_name);
  godot.object_set_instance(object, (GDExtensionConstStringNamePtr)&godot.class_name, (GDExtensionClassInstancePtr)o);
  return object;
}

static void give_back(void* data, GDExtensionClassInstancePtr self) {
  (void)data;
  if (!self) return;
  if (((owner*)self)->world) carom_world_destroy(((owner*)self)->world, NULL);
  free(self);
}

static void name_of(value* to, const char* text) {
  godot.string_name_new_with_latin1_chars((GDExtensionUninitializedStringNamePtr)to, text, 0);
}

static GDExtensionPropertyInfo info_of(int type, value* name) {
  return (GDExtensionPropertyInfo){.type = (GDExtensionVariantType)type,
                                   .name = (GDExtensionStringNamePtr)name,
                                   .class_name = (GDExtensionStringNamePtr)&godot.empty_name,
                                   .hint_string = (GDExtensionStringPtr)&godot.empty_text,
                                   .usage = 6 /* stored, in the editor */};
}

static void register_method(const method* m) {
  value names[MOST], name;
  GDExtensionPropertyInfo given[MOST], returned = info_of(m->returns, &godot.empty_name);
  GDExtensionClassMethodArgumentMetadata kinds[MOST] = {GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE};
  const int n = count_of(m);
  name_of(&name, m->name);
  for (int i = 0; i < n; ++i) name_of(&names[i], m->names[i]), given[i] = info_of(m->takes[i], &names[i]);
  const GDExtensionClassMethodInfo info = {.name = (GDExtensionStringNamePtr)&name,
                                           .method_userdata = (void*)m,
                                           .call_func = call_variants,
                                           .ptrcall_func = call_typed,
                                           .method_flags = GDEXTENSION_METHOD_FLAGS_DEFAULT,
                                           .has_return_value = 1,
                                           .return_value_info = &returned,
                                           .argument_count = (uint32_t)n,
                                           .arguments_info = given,
                                           .arguments_metadata = kinds};
  godot.classdb_register_extension_class_method(godot.library, (GDExtensionConstStringNamePtr)&godot.class_name, &info);
  GDExtensionPtrDestructor done_with = godot.destroy[GDEXTENSION_VARIANT_TYPE_STRING_NAME];
  for (int i = 0; i < n; ++i) done_with((GDExtensionTypePtr)&names[i]);
  done_with((GDExtensionTypePtr)&name);
}

static void begin(void* data, GDExtensionInitializationLevel level) {
  ERROR;
  (void)data;
  if (level != GDEXTENSION_INITIALIZATION_SCENE) return;
  for (int type = TRUTH; type < TYPES; ++type) {
    godot.wrap[type] = godot.get_variant_from_type_constructor((GDExtensionVariantType)type);
    godot.unwrap[type] = godot.get_variant_to_type_constructor((GDExtensionVariantType)type);
    godot.make[type] = godot.variant_get_ptr_constructor((GDExtensionVariantType)type, 0);
    godot.destroy[type] = godot.variant_get_ptr_destructor((GDExtensionVariantType)type);
  }
  name_of(&godot.class_name, "CaromWorld"), name_of(&godot.parent_name, "RefCounted"), name_of(&godot.empty_name, "");
  godot.string_new_with_utf8_chars((GDExtensionUninitializedStringPtr)&godot.empty_text, "");
  value size, resized;
  name_of(&size, "size"), name_of(&resized, "resize");
  for (int i = 0; i < 3; ++i) {  // with the hashes of their signatures, the same since 4.0
    const int type = (int[]){BYTES, FLOATS, DOUBLES}[i];
    godot.size[type] = godot.variant_get_ptr_builtin_method((GDExtensionVariantType)type,
                                                            (GDExtensionConstStringNamePtr)&size, 3173160232);
    godot.resize[type] = godot.variant_get_ptr_builtin_method((GDExtensionVariantType)type,
                                                              (GDExtensionConstStringNamePtr)&resized, 848867239);
  }
  godot.destroy[GDEXTENSION_VARIANT_TYPE_STRING_NAME]((GDExtensionTypePtr)&size);
  godot.destroy[GDEXTENSION_VARIANT_TYPE_STRING_NAME]((GDExtensionTypePtr)&resized);
  if (!done(carom_engine_create(NULL, &engine, &error), &error)) return;
  carom_plugins_register_standard(engine, NULL);  // where shapes are linked in; else they are files
  const GDExtensionClassCreationInfo2 info = {
      .is_exposed = 1, .create_instance_func = create, .free_instance_func = give_back};
  godot.classdb_register_extension_class2(godot.library, (GDExtensionConstStringNamePtr)&godot.class_name,
                                          (GDExtensionConstStringNamePtr)&godot.parent_name, &info);
  for (int i = 0; i < METHOD_COUNT; ++i) register_method(&METHODS[i]);
}

static void end(void* data, GDExtensionInitializationLevel level) {
  (void)data;
  if (level != GDEXTENSION_INITIALIZATION_SCENE) return;
  if (engine) {
    godot.classdb_unregister_extension_class(godot.library, (GDExtensionConstStringNamePtr)&godot.class_name);
    carom_engine_destroy(engine, NULL), engine = NULL;
  }
  GDExtensionPtrDestructor done_with = godot.destroy[GDEXTENSION_VARIANT_TYPE_STRING_NAME];
  done_with((GDExtensionTypePtr)&godot.class_name), done_with((GDExtensionTypePtr)&godot.parent_name),
      done_with((GDExtensionTypePtr)&godot.empty_name);
  godot.destroy[TEXT]((GDExtensionTypePtr)&godot.empty_text);
}

// What the file carom.gdextension names.
#ifdef _WIN32
__declspec(dllexport)
#else
__attribute__((visibility("default")))
#endif
    GDExtensionBool carom_godot_init(GDExtensionInterfaceGetProcAddress find, GDExtensionClassLibraryPtr library,
                                     GDExtensionInitialization* to) {
#define FIND(type, name) \
  if (!(godot.name = (GDExtensionInterface##type)find(#name))) return 0;
  CALLED(FIND)
  godot.library = library;
  *to = (GDExtensionInitialization){
      .minimum_initialization_level = GDEXTENSION_INITIALIZATION_SCENE, .initialize = begin, .deinitialize = end};
  return 1;
}
