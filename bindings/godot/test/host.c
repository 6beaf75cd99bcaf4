// A stand-in for Godot: the functions of its interface that the extension calls, over values of its own. It loads the extension, calls
// each method as a script would (Variants) or as Godot's own code does (typed), and compares with the C interface.
// usage: host EXTENSION
#include <carom/carom.h>
#include <dlfcn.h>
#include <gdextension_interface.h>
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void failed(int line, const char* what) {
  fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, line, what);
  exit(1);
}
#define CHECK(it) ((it) ? (void)0 : failed(__LINE__, #it))

// ---- values, as large as Godot's: a Variant has 24 bytes, and what is larger lies elsewhere
enum {
  NIL,
  BOOL,
  INT,
  FLOAT,
  STRING,
  VECTOR3 = 9,
  TRANSFORM = 18,
  NAME = 21,
  DICTIONARY = 27,
  BYTES = 29,
  FLOATS = 32,
  DOUBLES = 33
};
static long alive;  // blocks of memory
static void* take(size_t n) { return ++alive, calloc(1, n + 1); }
static void give(void* p) { alive -= p != NULL, free(p); }

typedef struct {
  char* text;
} string;
typedef struct {
  void* unused;
  struct block {
    int64_t n;
    double data[];
  } * block;
} packed;
typedef struct {
  int64_t type;
  union {
    uint8_t truth;
    int64_t whole;
    double number;
    float vector[3];
    void* large;
  } it;
} variant;
typedef struct entry {
  struct entry* next;
  char* key;
  variant it;
} entry;
typedef struct {
  entry* first;
} dictionary;
_Static_assert(sizeof(variant) <= 24 && sizeof(packed) == 16, "as Godot's");

static size_t bytes_of(int type) {
  return type == BOOL ? 1 : type == VECTOR3 ? 12 : type == TRANSFORM ? 48 : type >= BYTES ? 16 : 8;
}
static size_t element(int type) { return type == BYTES ? 1 : type == FLOATS ? 4 : 8; }
static bool is_large(int type) { return type == STRING || type == TRANSFORM || type >= DICTIONARY; }

static void destroy_typed(int type, void* it);
static void destroy_variant(variant* v) {
  if (is_large((int)v->type)) destroy_typed((int)v->type, v->it.large), give(v->it.large);
  v->type = NIL;
}
static void destroy_typed(int type, void* it) {
  if (type == STRING || type == NAME) give(((string*)it)->text);
  if (type >= BYTES) give(((packed*)it)->block);
  if (type == DICTIONARY)
    for (entry *e = ((dictionary*)it)->first, *next; e; e = next)
      next = e->next, destroy_variant(&e->it), give(e->key), give(e);
}
static void copy_variant(variant* to, const variant* from);
static char* twin(const char* text) { return strcpy(take(strlen(text)), text); }
static void copy_typed(int type, void* to, const void* from) {
  memcpy(to, from, bytes_of(type));
  if (type == STRING) ((string*)to)->text = twin(((const string*)from)->text);
  if (type >= BYTES && ((const packed*)from)->block) {
    const size_t n = sizeof(struct block) + (size_t)((const packed*)from)->block->n * element(type);
    ((packed*)to)->block = memcpy(take(n), ((const packed*)from)->block, n);
  }
  if (type == DICTIONARY) {
    entry** at = &((dictionary*)to)->first;
    *at = NULL;
    for (const entry* e = ((const dictionary*)from)->first; e; e = e->next, at = &(*at)->next)
      *at = take(sizeof **at), (*at)->key = twin(e->key), copy_variant(&(*at)->it, &e->it);
  }
}
static void wrap_typed(int type, variant* to, const void* from) {
  to->type = type;
  if (is_large(type))
    copy_typed(type, to->it.large = take(bytes_of(type)), from);
  else
    memcpy(&to->it, from, bytes_of(type));
}
static void copy_variant(variant* to, const variant* from) {
  wrap_typed((int)from->type, to, is_large((int)from->type) ? from->it.large : &from->it);
}
static void unwrap_typed(int type, void* to, const variant* from) {
  if (type == FLOAT && from->type == INT)
    *(double*)to = (double)from->it.whole;
  else
    CHECK(from->type == type), copy_typed(type, to, is_large(type) ? from->it.large : (const void*)&from->it);
}
static void make_typed(int type, void* it) {
  memset(it, 0, bytes_of(type));
  if (type == STRING) ((string*)it)->text = twin("");
}

// ---- the interface
#define PER_TYPE(X) \
  X(BOOL) X(INT) X(FLOAT) X(STRING) X(VECTOR3) X(TRANSFORM) X(NAME) X(DICTIONARY) X(BYTES) X(FLOATS) X(DOUBLES)
#define FUNCTIONS(T)                                                                                               \
  static void wrap_##T(GDExtensionUninitializedVariantPtr v, GDExtensionTypePtr it) {                              \
    wrap_typed(T, (variant*)v, it);                                                                                \
  }                                                                                                                \
  static void unwrap_##T(GDExtensionUninitializedTypePtr it, GDExtensionVariantPtr v) {                            \
    unwrap_typed(T, it, (variant*)v);                                                                              \
  }                                                                                                                \
  static void make_##T(GDExtensionUninitializedTypePtr it, const GDExtensionConstTypePtr* none) {                  \
    (void)none, make_typed(T, it);                                                                                 \
  }                                                                                                                \
  static void destroy_##T(GDExtensionTypePtr it) { destroy_typed(T, it); }                                         \
  static void size_##T(GDExtensionTypePtr it, const GDExtensionConstTypePtr* a, GDExtensionTypePtr ret, int n) {   \
    (void)a, (void)n, *(int64_t*)ret = ((packed*)it)->block ? ((packed*)it)->block->n : 0;                         \
  }                                                                                                                \
  static void resize_##T(GDExtensionTypePtr it, const GDExtensionConstTypePtr* a, GDExtensionTypePtr ret, int n) { \
    CHECK(n == 1), give(((packed*)it)->block);                                                                     \
    const int64_t wanted = *(const int64_t*)a[0];                                                                  \
    struct block* b = ((packed*)it)->block = take(sizeof *b + (size_t)wanted * element(T));                        \
    b->n = wanted, *(int64_t*)ret = 0;                                                                             \
  }
PER_TYPE(FUNCTIONS)
#define CASE(kind, T) \
  case T:             \
    return kind##_##T;
#define TABLE(kind, returns, name)                   \
  static returns name(GDExtensionVariantType type) { \
    switch ((int)type) { PER_TYPE(kind) }            \
    return NULL;                                     \
  }
#define CASE_WRAP(T) CASE(wrap, T)
#define CASE_UNWRAP(T) CASE(unwrap, T)
TABLE(CASE_WRAP, GDExtensionVariantFromTypeConstructorFunc, from_type)
TABLE(CASE_UNWRAP, GDExtensionTypeFromVariantConstructorFunc, to_type)
#define CASE_MAKE(T) CASE(make, T)
static GDExtensionPtrConstructor constructor(GDExtensionVariantType type, int32_t which) {
  CHECK(which == 0);
  switch ((int)type) { PER_TYPE(CASE_MAKE) }
  return NULL;
}
#define CASE_DESTROY(T) CASE(destroy, T)
static GDExtensionPtrDestructor destructor(GDExtensionVariantType type) {
  if ((int)type < STRING || (int)type == VECTOR3 || (int)type == TRANSFORM) return NULL;  // as Godot's
  switch ((int)type) { PER_TYPE(CASE_DESTROY) }
  return NULL;
}
#define CASE_SIZE(T) CASE(size, T)
#define CASE_RESIZE(T) CASE(resize, T)
static GDExtensionPtrBuiltInMethod builtin(GDExtensionVariantType type, GDExtensionConstStringNamePtr name,
                                           GDExtensionInt hash) {
  const bool size = strcmp(((const string*)name)->text, "size") == 0;
  CHECK(size ? hash == 3173160232 : hash == 848867239 && strcmp(((const string*)name)->text, "resize") == 0);
  if (size) switch ((int)type) {
      PER_TYPE(CASE_SIZE)
    }
  switch ((int)type) { PER_TYPE(CASE_RESIZE) }
  return NULL;
}
static void new_string(GDExtensionUninitializedStringPtr to, const char* text) { ((string*)to)->text = twin(text); }
static void new_name(GDExtensionUninitializedStringNamePtr to, const char* text, GDExtensionBool is_static) {
  (void)is_static, ((string*)to)->text = twin(text);
}
static GDExtensionInt string_to(GDExtensionConstStringPtr from, char* to, GDExtensionInt most) {
  const size_t n = strlen(((const string*)from)->text);
  memcpy(to, ((const string*)from)->text, n < (size_t)most ? n : (size_t)most);  // without a zero, as Godot's
  return (GDExtensionInt)n;
}
static void variant_destroy(GDExtensionVariantPtr v) { destroy_variant((variant*)v); }
static GDExtensionVariantType type_of(GDExtensionConstVariantPtr v) {
  return (GDExtensionVariantType)((const variant*)v)->type;
}
static GDExtensionBool converts(GDExtensionVariantType from, GDExtensionVariantType to) {
  return from == to || ((int)from == INT && (int)to == FLOAT);
}
static void* data_of(const void* array, GDExtensionInt i) {
  CHECK(i == 0 && ((const packed*)array)->block->n > 0);
  return ((const packed*)array)->block->data;
}
static uint8_t* bytes_at(GDExtensionTypePtr a, GDExtensionInt i) { return data_of(a, i); }
static const uint8_t* bytes_at_const(GDExtensionConstTypePtr a, GDExtensionInt i) { return data_of(a, i); }
static float* floats_at(GDExtensionTypePtr a, GDExtensionInt i) { return data_of(a, i); }
static const double* doubles_at_const(GDExtensionConstTypePtr a, GDExtensionInt i) { return data_of(a, i); }
static variant* find_in(dictionary* d, const char* key, bool add) {
  entry** at = &d->first;
  for (; *at; at = &(*at)->next)
    if (strcmp((*at)->key, key) == 0) return &(*at)->it;
  if (!add) return NULL;
  *at = take(sizeof **at), (*at)->key = twin(key);
  return &(*at)->it;
}
static GDExtensionVariantPtr dictionary_at(GDExtensionTypePtr d, GDExtensionConstVariantPtr key) {
  CHECK(((const variant*)key)->type == STRING);
  return (GDExtensionVariantPtr)find_in((dictionary*)d, ((string*)((const variant*)key)->it.large)->text, true);
}
static char last_error[2048];
static void print_error(const char* what, const char* message, const char* function, const char* file, int32_t line,
                        GDExtensionBool editor) {
  (void)function, (void)file, (void)line, (void)editor;
  snprintf(last_error, sizeof last_error, "%s: %s", what, message);
}

static GDExtensionClassCreationInfo2 class_info;
static char class_name[64];
static void* instance;
static struct {
  char name[64];
  GDExtensionClassMethodInfo info;
  int returns, takes[8];
} methods[64];
static int method_count;
static void register_class(GDExtensionClassLibraryPtr l, GDExtensionConstStringNamePtr name,
                           GDExtensionConstStringNamePtr parent, const GDExtensionClassCreationInfo2* info) {
  CHECK((void*)l == (void*)&alive && strcmp(((const string*)parent)->text, "RefCounted") == 0 && info->is_exposed);
  strcpy(class_name, ((const string*)name)->text), class_info = *info;
}
static void register_method(GDExtensionClassLibraryPtr l, GDExtensionConstStringNamePtr name,
                            const GDExtensionClassMethodInfo* info) {
  CHECK((void*)l == (void*)&alive && strcmp(((const string*)name)->text, class_name) == 0 && info->has_return_value);
  strcpy(methods[method_count].name, ((const string*)info->name)->text), methods[method_count].info = *info;
  methods[method_count].returns = (int)info->return_value_info->type;
  for (uint32_t i = 0; i < info->argument_count; ++i) {
    methods[method_count].takes[i] = (int)info->arguments_info[i].type;
    CHECK(((const string*)info->arguments_info[i].name)->text[0] && info->arguments_metadata);
  }
  ++method_count;
}
static void unregister_class(GDExtensionClassLibraryPtr l, GDExtensionConstStringNamePtr name) {
  CHECK(l && strcmp(((const string*)name)->text, class_name) == 0), class_name[0] = 0;
}
static GDExtensionObjectPtr construct(GDExtensionConstStringNamePtr name) {
  CHECK(strcmp(((const string*)name)->text, "RefCounted") == 0);
  return (GDExtensionObjectPtr)&instance;
}
static void set_instance(GDExtensionObjectPtr object, GDExtensionConstStringNamePtr name,
                         GDExtensionClassInstancePtr it) {
  CHECK((void*)object == (void*)&instance && strcmp(((const string*)name)->text, class_name) == 0), instance = it;
}

static GDExtensionInterfaceFunctionPtr find(const char* name) {
#define KNOWS(text, function) \
  if (strcmp(name, text) == 0) return (GDExtensionInterfaceFunctionPtr)function;
  KNOWS("classdb_construct_object", construct)
  KNOWS("classdb_register_extension_class2", register_class)
  KNOWS("classdb_register_extension_class_method", register_method)
  KNOWS("classdb_unregister_extension_class", unregister_class)
  KNOWS("object_set_instance", set_instance)
  KNOWS("print_error_with_message", print_error)
  KNOWS("string_new_with_utf8_chars", new_string)
  KNOWS("string_to_utf8_chars", string_to)
  KNOWS("string_name_new_with_latin1_chars", new_name)
  KNOWS("variant_destroy", variant_destroy)
  KNOWS("variant_get_type", type_of)
  KNOWS("variant_can_convert_strict", converts)
  KNOWS("get_variant_from_type_constructor", from_type)
  KNOWS("get_variant_to_type_constructor", to_type)
  KNOWS("variant_get_ptr_constructor", constructor)
  KNOWS("variant_get_ptr_destructor", destructor)
  KNOWS("variant_get_ptr_builtin_method", builtin)
  KNOWS("packed_byte_array_operator_index", bytes_at)
  KNOWS("packed_byte_array_operator_index_const", bytes_at_const)
  KNOWS("packed_float32_array_operator_index", floats_at)
  KNOWS("packed_float64_array_operator_index_const", doubles_at_const)
  KNOWS("dictionary_operator_index", dictionary_at)
  return NULL;
}

// ---- a script
static int called;  // methods, each once
static bool was_called[64];
static variant call(const char* name, GDExtensionCallErrorType expected, int n, ...) {
  variant given[8], back = {0};
  GDExtensionConstVariantPtr at[8];
  va_list list;
  va_start(list, n);
  for (int i = 0; i < n; ++i) given[i] = va_arg(list, variant), at[i] = (GDExtensionConstVariantPtr)&given[i];
  va_end(list);
  int m = 0;
  while (m < method_count && strcmp(methods[m].name, name) != 0) ++m;
  CHECK(m < method_count);
  GDExtensionCallError error = {0};
  methods[m].info.call_func(methods[m].info.method_userdata, instance, at, n, (GDExtensionVariantPtr)&back, &error);
  CHECK(error.error == expected && back.type == (expected == GDEXTENSION_CALL_OK ? methods[m].returns : NIL));
  called += !was_called[m] && expected == GDEXTENSION_CALL_OK, was_called[m] |= expected == GDEXTENSION_CALL_OK;
  for (int i = 0; i < n; ++i) destroy_variant(&given[i]);
  return back;
}
#define RUN(name, n, ...) call(name, GDEXTENSION_CALL_OK, n, ##__VA_ARGS__)
static variant whole(uint64_t n) { return (variant){INT, {.whole = (int64_t)n}}; }
static variant number(double x) { return (variant){FLOAT, {.number = x}}; }
static variant vec(double x, double y, double z) {
  return (variant){VECTOR3, {.vector = {(float)x, (float)y, (float)z}}};
}
static variant text(const char* it) {
  variant v;
  wrap_typed(STRING, &v, &(string){(char*)it});
  return v;
}
static variant doubles(int n, ...) {
  packed* p = take(sizeof *p);
  p->block = take(sizeof *p->block + (size_t)n * 8), p->block->n = n;
  va_list list;
  va_start(list, n);
  for (int i = 0; i < n; ++i) p->block->data[i] = va_arg(list, double);
  va_end(list);
  return (variant){DOUBLES, {.large = p}};
}
static variant place(double x, double y, double z, double turn, double scale) {  // about z
  const float s = (float)(scale * sin(turn)), c = (float)(scale * cos(turn));
  const float t[12] = {c, -s, 0, s, c, 0, 0, 0, (float)scale, (float)x, (float)y, (float)z};
  variant v;
  wrap_typed(TRANSFORM, &v, t);
  return v;
}
static double y_of(uint64_t body) {
  variant t = RUN("get_body_transform", 1, whole(body));
  const float y = ((float*)t.it.large)[10];
  destroy_variant(&t);
  return y;
}
static uint64_t hash(void) { return (uint64_t)RUN("hash", 0).it.whole; }
static void go(int steps) {
  for (int i = 0; i < steps; ++i) CHECK(RUN("step", 1, number(1.0 / 60)).it.truth);
}

// The hello in C.
static uint64_t hash_of_c(void) {
  carom_engine* engine;
  carom_world* world;
  carom_body_desc desc;
  carom_body body;
  uint64_t h = 0;
  const double ground[] = {0, 1, 0, 0}, radius = 0.5, origin[3] = {0}, above[] = {0, 3, 0};
  (void)desc;
  CHECK(carom_engine_create(NULL, &engine, NULL) == 0 && carom_world_create(engine, NULL, &world, NULL) == 0);
  CHECK(carom_body_create_named(world, CAROM_BODY_STATIC, "half_space", ground, 4, origin, &body, NULL) == 0);
  CHECK(carom_body_create_named(world, CAROM_BODY_DYNAMIC, "sphere", &radius, 1, above, &body, NULL) == 0);
  for (int i = 0; i < 180; ++i) carom_world_step(world, 1.0 / 60, NULL);
  carom_world_hash(world, &h, NULL);
  carom_world_destroy(world, NULL), carom_engine_destroy(engine, NULL);
  return h;
}

int main(int n, char** words) {
  CHECK(n == 2);
  void* file = dlopen(words[1], RTLD_NOW);
  if (!file) return fprintf(stderr, "%s\n", dlerror()), 1;
  GDExtensionInitializationFunction init = (GDExtensionInitializationFunction)dlsym(file, "carom_godot_init");
  GDExtensionInitialization to = {0};
  CHECK(init && init(find, (GDExtensionClassLibraryPtr)&alive, &to));
  for (int level = 0; level <= (int)GDEXTENSION_INITIALIZATION_SCENE; ++level)
    to.initialize(to.userdata, (GDExtensionInitializationLevel)level);
  CHECK(strcmp(class_name, "CaromWorld") == 0 && method_count > 0);
  class_info.create_instance_func(class_info.class_userdata);
  CHECK(instance && !last_error[0]);

  // The hello of the page, and C's bits.
  const uint64_t ground = (uint64_t)RUN("add_body", 4, whole(CAROM_BODY_STATIC), text("half_space"),
                                        doubles(4, 0., 1., 0., 0.), place(0, 0, 0, 0, 1))
                              .it.whole;
  const uint64_t ball =
      (uint64_t)RUN("add_body", 4, whole(CAROM_BODY_DYNAMIC), text("sphere"), doubles(1, 0.5), place(0, 3, 0, 0, 1))
          .it.whole;
  go(180);
  printf("after 3 s the ball lies at y = %.3f m\n", y_of(ball));
  CHECK(hash() == hash_of_c());

  // Rollback: what was done otherwise is undone, to the bit.
  variant saved = RUN("save", 0), again;
  CHECK(RUN("set_velocity", 3, whole(ball), vec(1, 2, 0), vec(0, 0, 3)).it.truth);
  variant v = RUN("get_linear_velocity", 1, whole(ball)), w = RUN("get_angular_velocity", 1, whole(ball));
  CHECK(v.it.vector[0] == 1 && v.it.vector[1] == 2 && w.it.vector[2] == 3);
  go(30);
  const uint64_t moved = hash();
  copy_variant(&again, &saved);
  CHECK(RUN("restore", 1, again).it.truth && hash() == hash_of_c());
  CHECK(RUN("set_velocity", 3, whole(ball), vec(1, 2, 0), vec(0, 0, 3)).it.truth);
  go(30);
  CHECK(hash() == moved);
  CHECK(RUN("restore", 1, saved).it.truth);

  // Rays: of the ball, and past it of the ground, and of nothing.
  variant hit = RUN("intersect_ray", 2, vec(0, 5, 0), vec(0, -5, 0));
  dictionary* d = hit.it.large;
  CHECK((uint64_t)find_in(d, "body", false)->it.whole == ball &&
        fabs(find_in(d, "fraction", false)->it.number - 0.4) < 1e-3);
  CHECK(fabsf(find_in(d, "position", false)->it.vector[1] - 1) < 1e-2f &&
        find_in(d, "normal", false)->it.vector[1] > 0.999f);
  destroy_variant(&hit);
  hit = RUN("intersect_ray", 2, vec(3, 5, 0), vec(3, -5, 0));
  CHECK((uint64_t)find_in(hit.it.large, "body", false)->it.whole == ground);
  destroy_variant(&hit);
  hit = RUN("intersect_ray", 2, vec(3, 5, 0), vec(3, 6, 0));
  CHECK(!((dictionary*)hit.it.large)->first);
  destroy_variant(&hit);

  // A scaled and turned frame: its rotation is taken. Two shapes on one body.
  const uint64_t block = (uint64_t)RUN("add_body", 4, whole(CAROM_BODY_DYNAMIC), text("box"),
                                       doubles(3, 0.5, 0.25, 0.25), place(5, 4, 0, 0.5, 2))
                             .it.whole;
  CHECK(RUN("add_shape", 4, whole(block), text("sphere"), doubles(1, 0.2), place(0.5, 0, 0, 0, 1)).it.truth);
  variant t = RUN("get_body_transform", 1, whole(block));
  const float* m = t.it.large;
  CHECK(fabs(m[0] - cos(0.5)) < 1e-6 && fabs(m[3] - sin(0.5)) < 1e-6 && fabs(m[1] + sin(0.5)) < 1e-6 && m[8] == 1 &&
        m[9] == 5);
  destroy_variant(&t);
  for (int axis = 0; axis < 4; ++axis) {  // each of the four ways to a quaternion, there and back
    const double c = -0.9, s = sqrt(1 - c * c);
    const float turns[4][9] = {{1, 0, 0, 0, (float)c, (float)-s, 0, (float)s, (float)c},
                               {(float)c, 0, (float)s, 0, 1, 0, (float)-s, 0, (float)c},
                               {(float)c, (float)-s, 0, (float)s, (float)c, 0, 0, 0, 1},
                               {1, 0, 0, 0, 1, 0, 0, 0, 1}};
    float frame[12] = {0};
    memcpy(frame, turns[axis], sizeof turns[axis]);
    variant turned;
    wrap_typed(TRANSFORM, &turned, frame);
    CHECK(RUN("set_body_transform", 2, whole(block), turned).it.truth);
    t = RUN("get_body_transform", 1, whole(block));
    for (int i = 0; i < 12; ++i) CHECK(fabsf(((float*)t.it.large)[i] - frame[i]) < 1e-6f);
    destroy_variant(&t);
  }
  variant all = RUN("get_transforms", 0);
  packed* rows = all.it.large;
  CHECK(rows->block->n == 36 && fabs(((float*)rows->block->data)[12 + 7] - y_of(ball)) < 1e-6);
  destroy_variant(&all);
  CHECK(RUN("destroy_body", 1, whole(block)).it.truth);

  // A motor turns a rod at 1 rad/s about the axis of its hinge, until a limit.
  const uint64_t rod = (uint64_t)RUN("add_body", 4, whole(CAROM_BODY_DYNAMIC), text("box"), doubles(3, 0.5, 0.05, 0.05),
                                     place(10.5, 9, 0, 0, 1))
                           .it.whole;
  const float along_z[12] = {0, 0, -1, 0, 1, 0, 1, 0, 0, 10, 9, 0};  // its x axis is the world's z axis
  variant frame;
  wrap_typed(TRANSFORM, &frame, along_z);
  const uint64_t hinge = (uint64_t)RUN("add_joint", 4, whole(CAROM_JOINT_HINGE), whole(0), whole(rod), frame).it.whole;
  CHECK(hinge &&
        RUN("set_joint_motor", 4, whole(hinge), whole(CAROM_COORDINATE_TWIST), number(1), number(200)).it.truth);
  CHECK(RUN("set_joint_limit", 4, whole(hinge), whole(CAROM_COORDINATE_TWIST), whole(-1), whole(1))
            .it.truth);  // a whole number is one, too
  go(30);
  CHECK(fabs(y_of(rod) - 9 - 0.5 * sin(0.5)) < 0.02);
  go(120);
  CHECK(fabs(y_of(rod) - 9 - 0.5 * sin(1)) < 0.02);
  CHECK(RUN("add_force", 3, whole(ball), vec(0, 1e4, 0), vec(0, 0, 0)).it.truth);
  go(1);
  v = RUN("get_linear_velocity", 1, whole(ball));
  CHECK(v.it.vector[1] > 0.1f);
  CHECK(RUN("set_dial", 2, text("substeps"), whole(5)).it.truth);

  // As Godot's own code calls: typed.
  for (int i = 0; i < method_count; ++i)
    if (strcmp(methods[i].name, "get_linear_velocity") == 0) {
      float out[3] = {0};
      const GDExtensionConstTypePtr in[] = {(GDExtensionConstTypePtr)&ball};
      methods[i].info.ptrcall_func(methods[i].info.method_userdata, instance, in, (GDExtensionTypePtr)out);
      CHECK(memcmp(out, v.it.vector, sizeof out) == 0);
    }

  // What is wrong is told, with a remedy, and changes nothing.
  CHECK(!last_error[0]);
  const uint64_t before = hash();
  CHECK(
      RUN("add_body", 4, whole(CAROM_BODY_DYNAMIC), text("no_such_shape"), doubles(0), place(0, 0, 0, 0, 1)).it.whole ==
      0);
  CHECK(strstr(last_error, "no_such_shape") && strstr(last_error, ". Remedy: "));
  last_error[0] = 0;
  CHECK(!RUN("step", 1, number(NAN)).it.truth && strstr(last_error, "NOT_FINITE"));
  CHECK(!RUN("set_dial", 2, text("no_such_dial"), number(1)).it.truth && strstr(last_error, "no_such_dial"));
  CHECK(!RUN("destroy_body", 1, whole(block)).it.truth && strstr(last_error, "STALE_HANDLE"));
  variant none = {BYTES, {.large = take(16)}};
  CHECK(!RUN("restore", 1, none).it.truth && strstr(last_error, "CORRUPT"));
  call("step", GDEXTENSION_CALL_ERROR_TOO_FEW_ARGUMENTS, 0);
  call("step", GDEXTENSION_CALL_ERROR_TOO_MANY_ARGUMENTS, 2, number(1), number(1));
  call("step", GDEXTENSION_CALL_ERROR_INVALID_ARGUMENT, 1, text("soon"));
  CHECK(hash() == before);

  CHECK(called == method_count);
  class_info.free_instance_func(class_info.class_userdata, instance);
  for (int level = (int)GDEXTENSION_INITIALIZATION_SCENE; level >= 0; --level)
    to.deinitialize(to.userdata, (GDExtensionInitializationLevel)level);
  CHECK(!class_name[0] && alive == 0);
  printf("%d methods\n", method_count);
  return 0;
}
