// Every argument of every call: what is wrong with it comes back as the right code, with the argument's number, a message
// and a remedy, and nothing has changed. The same with and without an error object.
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "bench.h"
#include "carom_test.h"

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
const double kZero[3] = {0, 0, 0}, kOne[3] = {1, 0, 0}, kNan3[3] = {0, kNan, 0}, kInf3[3] = {0, 0, -kInf};
const double kUpright[4] = {0, 0, 0, 1}, kLong[4] = {0, 0, 0, 1.00001}, kNan4[4] = {0, 0, 0, kNan}, kZero4[4] = {};

struct Row {
  const char* what;
  int32_t code;
  int32_t argument;
  int32_t (*call)(Bench& b, carom_error* e);
};

carom_body_desc body_desc() {
  carom_body_desc d;
  carom_body_desc_init(&d, sizeof d);
  return d;
}
int32_t create_body(Bench& b, const carom_body_desc& d, carom_error* e) {
  carom_body out;
  return carom_body_create(b.world, &d, &out, e);
}
carom_collider_desc collider_desc(const Bench& b) {
  carom_collider_desc d;
  carom_collider_desc_init(&d, sizeof d);
  d.shape = b.ball;
  return d;
}
int32_t create_collider(Bench& b, const carom_collider_desc& d, carom_error* e) {
  carom_collider out;
  return carom_collider_create(b.world, b.bodies[0], &d, &out, e);
}
carom_material_desc material_desc() {
  carom_material_desc d;
  carom_material_desc_init(&d, sizeof d);
  return d;
}
int32_t create_material(Bench& b, const carom_material_desc& d, carom_error* e) {
  carom_material out;
  return carom_material_create(b.world, &d, &out, e);
}
int32_t create_world(Bench& b, const carom_world_desc& d, carom_error* e) {
  carom_world* out = nullptr;
  return carom_world_create(b.engine, &d, &out, e);
}
carom_world_desc world_desc() {
  carom_world_desc d;
  carom_world_desc_init(&d, sizeof d);
  return d;
}
int32_t create_shape(Bench& b, carom_plugin plugin, std::vector<double> params, carom_error* e) {
  carom_shape out;
  return carom_shape_create(b.engine, plugin, params.data(), params.size(), &out, e);
}
int32_t measure(Bench& b, const double* pa, const double* qa, const double* pb, const double* qb,
                const carom_distance_desc* d, carom_error* e) {
  carom_distance result = {};
  result.struct_size = sizeof result;
  return carom_shape_distance(b.engine, b.ball, pa, qa, b.crate, pb, qb, d, &result, e);
}
/// One pair, changed by `f`.
int32_t measure_pairs(Bench& b, void (*spoil)(Bench& b, carom_pairs&), carom_error* e,
                      const carom_distance_desc* d = nullptr, uint64_t stride = sizeof(carom_distance)) {
  carom_distance result = {};
  carom_pairs p = {};
  p.struct_size = sizeof p;
  p.count = 1;
  p.shapes_a = &b.ball, p.shapes_b = &b.crate;
  p.positions_a = p.positions_b = kZero, p.orientations_a = p.orientations_b = kUpright;
  spoil(b, p);
  return carom_pairs_distance(b.engine, &p, d, &result, stride, e);
}
void as_it_is(Bench&, carom_pairs&) {}
carom_distance_desc distance_desc() {
  carom_distance_desc d;
  carom_distance_desc_init(&d, sizeof d);
  return d;
}

template <class Desc>
Desc with(Desc d, void (*change)(Desc&)) {
  change(d);
  return d;
}

int32_t set_jobs_of_new_engine(void (*change)(carom_jobs_desc&), carom_error* e) {
  carom_engine* engine = nullptr;
  if (const int32_t r = carom_engine_create(nullptr, &engine, e)) return r;
  carom_jobs_desc desc;
  carom_jobs_desc_init(&desc, sizeof desc);
  change(desc);
  const int32_t r = carom_engine_set_jobs(engine, &desc, e);
  carom_engine_destroy(engine, nullptr);
  return r;
}

// clang-format off
const Row kEngine[] = {
    {"layout", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_abi_check(nullptr, e); }},
    {"layout: no version", CAROM_E_OUT_OF_RANGE, 1, [](Bench&, carom_error* e) { return carom_abi_check("carom_error 0 576 struct\n", e); }},
    {"layout: older", CAROM_E_UNSUPPORTED, 1, [](Bench&, carom_error* e) { return carom_abi_check("carom 99.0.0\n", e); }},
    {"engine out", CAROM_E_NULL_ARGUMENT, 2, [](Bench&, carom_error* e) { return carom_engine_create(nullptr, nullptr, e); }},
    {"alloc without free", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) {
       carom_engine_desc d;
       carom_engine_desc_init(&d, sizeof d);
       d.alloc = [](void*, uint64_t, uint64_t) -> void* { return nullptr; };
       carom_engine* out = nullptr;
       return carom_engine_create(&d, &out, e);
     }},
    {"engine reserved", CAROM_E_UNSUPPORTED, 1, [](Bench&, carom_error* e) {
       carom_engine_desc d;
       carom_engine_desc_init(&d, sizeof d);
       d.reserved = 1;
       carom_engine* out = nullptr;
       return carom_engine_create(&d, &out, e);
     }},
    {"jobs: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_engine_set_jobs(nullptr, nullptr, e); }},
    {"jobs: worlds are alive", CAROM_E_IN_USE, 1, [](Bench& b, carom_error* e) { return carom_engine_set_jobs(b.engine, nullptr, e); }},
    {"jobs: too many threads", CAROM_E_OUT_OF_RANGE, 2, [](Bench&, carom_error* e) {
       return set_jobs_of_new_engine([](carom_jobs_desc& d) { d.threads = 257; }, e);
     }},
    {"jobs: two kinds of threads", CAROM_E_OUT_OF_RANGE, 2, [](Bench&, carom_error* e) {
       return set_jobs_of_new_engine([](carom_jobs_desc& d) {
         d.threads = 2;
         d.run = [](void*, carom_job_fn, void*, uint32_t) {};
       }, e);
     }},
    {"jobs: size", CAROM_E_STRUCT_SIZE, 2, [](Bench&, carom_error* e) {
       return set_jobs_of_new_engine([](carom_jobs_desc& d) { d.struct_size = 9; }, e);
     }},
    {"destroy no engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_engine_destroy(nullptr, e); }},
    {"destroy engine of a world", CAROM_E_IN_USE, 1, [](Bench& b, carom_error* e) { return carom_engine_destroy(b.engine, e); }},
    {"load: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_plugin_load(nullptr, "/x", &b.sphere, e); }},
    {"load: path", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return carom_plugin_load(b.engine, nullptr, &b.sphere, e); }},
    {"load: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_plugin_load(b.engine, "/x", nullptr, e); }},
    {"load: relative path", CAROM_E_PLUGIN_PATH, 2, [](Bench& b, carom_error* e) { return carom_plugin_load(b.engine, "sphere.so", &b.sphere, e); }},
    {"load: empty path", CAROM_E_PLUGIN_PATH, 2, [](Bench& b, carom_error* e) { return carom_plugin_load(b.engine, "", &b.sphere, e); }},
    {"load: nothing there", CAROM_E_PLUGIN_PATH, 2, [](Bench& b, carom_error* e) { return carom_plugin_load(b.engine, "/nowhere/none.so", &b.sphere, e); }},
    {"load: a folder", CAROM_E_PLUGIN_PATH, 2, [](Bench& b, carom_error* e) { return carom_plugin_load(b.engine, CAROM_SOURCE_DIR, &b.sphere, e); }},
    {"load: not a shared object", CAROM_E_PLUGIN_LOAD, 2, [](Bench& b, carom_error* e) { return carom_plugin_load(b.engine, CAROM_SOURCE_DIR "/include/carom/base.h", &b.sphere, e); }},
    {"register: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_plugin_register(nullptr, &b.box_plugin, &b.sphere, e); }},
    {"register: description", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return carom_plugin_register(b.engine, nullptr, &b.sphere, e); }},
    {"register: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_plugin_register(b.engine, &b.box_plugin, nullptr, e); }},
    {"register twice", CAROM_E_ALREADY_EXISTS, 2, [](Bench& b, carom_error* e) { carom_plugin out; return carom_plugin_register(b.engine, &b.box_plugin, &out, e); }},
    {"standard shapes: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_plugins_register_standard(nullptr, e); }},
    {"unload: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_plugin_unload(nullptr, b.sphere, e); }},
    {"unload in use", CAROM_E_IN_USE, 2, [](Bench& b, carom_error* e) { return carom_plugin_unload(b.engine, b.sphere, e); }},
    {"find: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_plugin_find(nullptr, "test.box", &b.box, e); }},
    {"find: id", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return carom_plugin_find(b.engine, nullptr, &b.box, e); }},
    {"find: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_plugin_find(b.engine, "test.box", nullptr, e); }},
    {"find: unknown", CAROM_E_NOT_FOUND, 2, [](Bench& b, carom_error* e) { return carom_plugin_find(b.engine, "no.such", &b.box, e); }},
    {"describe: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { const carom_shape_plugin* p; return carom_plugin_describe(nullptr, b.box, &p, e); }},
    {"describe: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_plugin_describe(b.engine, b.box, nullptr, e); }},
};
// clang-format on

// clang-format off
const Row kShape[] = {
    {"shape: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { double r = 1; return carom_shape_create(nullptr, b.sphere, &r, 1, &b.ball, e); }},
    {"shape: params", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { carom_shape s; return carom_shape_create(b.engine, b.sphere, nullptr, 1, &s, e); }},
    {"shape: out", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { double r = 1; return carom_shape_create(b.engine, b.sphere, &r, 1, nullptr, e); }},
    {"shape: too few", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { return create_shape(b, b.box, {1, 1}, e); }},
    {"shape: too many", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { return create_shape(b, b.sphere, {1, 1}, e); }},
    {"shape: none", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { return create_shape(b, b.sphere, {}, e); }},
    {"shape: nan", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return create_shape(b, b.box, {1, kNan, 1}, e); }},
    {"shape: inf", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return create_shape(b, b.box, {kInf, 1, 1}, e); }},
    {"shape: below the bound", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { return create_shape(b, b.sphere, {-1}, e); }},
    {"shape: above the bound", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { return create_shape(b, b.sphere, {1001}, e); }},
    {"half-space: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_shape_create_half_space(nullptr, kOne, 0, &b.floor, e); }},
    {"half-space: normal", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return carom_shape_create_half_space(b.engine, nullptr, 0, &b.floor, e); }},
    {"half-space: nan", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return carom_shape_create_half_space(b.engine, kNan3, 0, &b.floor, e); }},
    {"half-space: zero normal", CAROM_E_NOT_UNIT, 2, [](Bench& b, carom_error* e) { return carom_shape_create_half_space(b.engine, kZero, 0, &b.floor, e); }},
    {"half-space: offset", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return carom_shape_create_half_space(b.engine, kOne, kInf, &b.floor, e); }},
    {"half-space: out", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { return carom_shape_create_half_space(b.engine, kOne, 0, nullptr, e); }},
    {"hull of: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { carom_shape s; return carom_shape_create_hull_of(nullptr, &b.ball, 1, nullptr, nullptr, nullptr, 0, &s, e); }},
    {"hull of: parts", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { carom_shape s; return carom_shape_create_hull_of(b.engine, nullptr, 1, nullptr, nullptr, nullptr, 0, &s, e); }},
    {"hull of: half-space", CAROM_E_UNSUPPORTED, 2, [](Bench& b, carom_error* e) { carom_shape s; return carom_shape_create_hull_of(b.engine, &b.floor, 1, nullptr, nullptr, nullptr, 0, &s, e); }},
    {"hull of: none", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { carom_shape s; return carom_shape_create_hull_of(b.engine, &b.ball, 0, nullptr, nullptr, nullptr, 0, &s, e); }},
    {"hull of: position", CAROM_E_NOT_FINITE, 4, [](Bench& b, carom_error* e) { carom_shape s; return carom_shape_create_hull_of(b.engine, &b.ball, 1, kNan3, nullptr, nullptr, 0, &s, e); }},
    {"hull of: scale", CAROM_E_OUT_OF_RANGE, 6, [](Bench& b, carom_error* e) { carom_shape s; return carom_shape_create_hull_of(b.engine, &b.ball, 1, nullptr, nullptr, kZero, 0, &s, e); }},
    {"hull of: radius", CAROM_E_OUT_OF_RANGE, 7, [](Bench& b, carom_error* e) { carom_shape s; return carom_shape_create_hull_of(b.engine, &b.ball, 1, nullptr, nullptr, nullptr, -1, &s, e); }},
    {"hull of: out", CAROM_E_NULL_ARGUMENT, 8, [](Bench& b, carom_error* e) { return carom_shape_create_hull_of(b.engine, &b.ball, 1, nullptr, nullptr, nullptr, 0, nullptr, e); }},
    {"parts: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { uint64_t n = 0; return carom_shape_get_parts(nullptr, b.ball, nullptr, nullptr, nullptr, nullptr, &n, nullptr, e); }},
    {"parts: count", CAROM_E_NULL_ARGUMENT, 7, [](Bench& b, carom_error* e) { return carom_shape_get_parts(b.engine, b.ball, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, e); }},
    {"destroy shape: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_shape_destroy(nullptr, b.ball, e); }},
    {"destroy shape in use", CAROM_E_IN_USE, 2, [](Bench& b, carom_error* e) { return carom_shape_destroy(b.engine, b.ball, e); }},
    {"info: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { carom_shape_info i = {}; i.struct_size = sizeof i; return carom_shape_get_info(nullptr, b.ball, &i, e); }},
    {"info: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_shape_get_info(b.engine, b.ball, nullptr, e); }},
    {"info: struct_size", CAROM_E_STRUCT_SIZE, 3, [](Bench& b, carom_error* e) { carom_shape_info i = {}; return carom_shape_get_info(b.engine, b.ball, &i, e); }},
    {"params: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { double p[3]; uint64_t n = 3; return carom_shape_get_params(nullptr, b.crate, p, &n, e); }},
    {"params: dst", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { uint64_t n = 3; return carom_shape_get_params(b.engine, b.crate, nullptr, &n, e); }},
    {"params: count", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { double p[3]; return carom_shape_get_params(b.engine, b.crate, p, nullptr, e); }},
    {"params: capacity", CAROM_E_BUFFER_TOO_SMALL, 4, [](Bench& b, carom_error* e) { double p[2]; uint64_t n = 2; return carom_shape_get_params(b.engine, b.crate, p, &n, e); }},
    {"support: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { double p[3]; return carom_shape_support(nullptr, b.ball, kOne, 1, p, e); }},
    {"support: dirs", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { double p[3]; return carom_shape_support(b.engine, b.ball, nullptr, 1, p, e); }},
    {"support: nan", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { double p[3]; return carom_shape_support(b.engine, b.ball, kNan3, 1, p, e); }},
    {"support: zero", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { double p[3]; return carom_shape_support(b.engine, b.ball, kZero, 1, p, e); }},
    {"support: points", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { return carom_shape_support(b.engine, b.ball, kOne, 1, nullptr, e); }},
    {"support: half-space", CAROM_E_UNSUPPORTED, 2, [](Bench& b, carom_error* e) { double p[3]; return carom_shape_support(b.engine, b.floor, kOne, 1, p, e); }},
};
// clang-format on

// clang-format off
const Row kWorld[] = {
    {"world: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { carom_world* w; return carom_world_create(nullptr, nullptr, &w, e); }},
    {"world: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_world_create(b.engine, nullptr, nullptr, e); }},
    {"world: gravity nan", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return create_world(b, with<carom_world_desc>(world_desc(), [](auto& d) { d.gravity[2] = kNan; }), e); }},
    {"world: gravity range", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return create_world(b, with<carom_world_desc>(world_desc(), [](auto& d) { d.gravity[0] = -1.1e6; }), e); }},
    {"world: capacity", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return create_world(b, with<carom_world_desc>(world_desc(), [](auto& d) { d.body_capacity = ~uint64_t(0); }), e); }},
    {"world: reserved", CAROM_E_UNSUPPORTED, 2, [](Bench& b, carom_error* e) { return create_world(b, with<carom_world_desc>(world_desc(), [](auto& d) { d.reserved = 7; }), e); }},
    {"destroy no world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_world_destroy(nullptr, e); }},
    {"step: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_world_step(nullptr, 0.01, e); }},
    {"step: 0", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return carom_world_step(b.world, 0, e); }},
    {"step: subnormal", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return carom_world_step(b.world, 4e-310, e); }},
    {"step: below 1 ns", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return carom_world_step(b.world, 9.9e-10, e); }},
    {"step: -0", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return carom_world_step(b.world, -0.0, e); }},
    {"step: negative", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return carom_world_step(b.world, -0.01, e); }},
    {"step: long", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return carom_world_step(b.world, 1.5, e); }},
    {"step: nan", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return carom_world_step(b.world, kNan, e); }},
    {"step: inf", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return carom_world_step(b.world, kInf, e); }},
    {"dial: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_world_set_dial(nullptr, 0, 0, e); }},
    {"dial: unknown", CAROM_E_UNKNOWN_ENUM, 2, [](Bench& b, carom_error* e) { return carom_world_set_dial(b.world, CAROM_DIAL_COUNT, 0, e); }},
    {"dial: nan", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return carom_world_set_dial(b.world, CAROM_DIAL_GRID_CELL, kNan, e); }},
    {"dial: below", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { return carom_world_set_dial(b.world, CAROM_DIAL_GRID_CELL, -1, e); }},
    {"dial: half a choice", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { return carom_world_set_dial(b.world, CAROM_DIAL_INTEGRATOR, 0.5, e); }},
    {"dial: no such choice", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { return carom_world_set_dial(b.world, CAROM_DIAL_INTEGRATOR, 4, e); }},
    {"get dial: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { double v; return carom_world_get_dial(nullptr, 0, &v, e); }},
    {"get dial: unknown", CAROM_E_UNKNOWN_ENUM, 2, [](Bench& b, carom_error* e) { double v; return carom_world_get_dial(b.world, 1000, &v, e); }},
    {"get dial: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_world_get_dial(b.world, 0, nullptr, e); }},
    {"gravity: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_world_set_gravity(nullptr, kOne, e); }},
    {"gravity: null", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return carom_world_set_gravity(b.world, nullptr, e); }},
    {"gravity: nan", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return carom_world_set_gravity(b.world, kNan3, e); }},
    {"gravity: range", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { const double g[3] = {0, 0, 2e6}; return carom_world_set_gravity(b.world, g, e); }},
    {"get gravity: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { double g[3]; return carom_world_get_gravity(nullptr, g, e); }},
    {"get gravity: out", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return carom_world_get_gravity(b.world, nullptr, e); }},
    {"report: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { carom_step_report r = {}; r.struct_size = sizeof r; return carom_world_get_report(nullptr, &r, e); }},
    {"report: out", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return carom_world_get_report(b.world, nullptr, e); }},
    {"report: struct_size", CAROM_E_STRUCT_SIZE, 2, [](Bench& b, carom_error* e) { carom_step_report r = {}; return carom_world_get_report(b.world, &r, e); }},
    {"contacts: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint64_t n; return carom_world_get_contacts(nullptr, nullptr, 0, 0, &n, e); }},
    {"contacts: dst", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { uint64_t n; return carom_world_get_contacts(b.world, nullptr, sizeof(carom_contact), 1, &n, e); }},
    {"contacts: stride", CAROM_E_BUFFER_TOO_SMALL, 3, [](Bench& b, carom_error* e) { uint64_t n; carom_contact c; return carom_world_get_contacts(b.world, &c, 4, 1, &n, e); }},
    {"contacts: count", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { return carom_world_get_contacts(b.world, nullptr, 0, 0, nullptr, e); }},
    {"groups: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint64_t n; return carom_world_get_groups(nullptr, nullptr, 0, 0, &n, e); }},
    {"groups: dst", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { uint64_t n; return carom_world_get_groups(b.world, nullptr, sizeof(carom_group), 1, &n, e); }},
    {"groups: stride", CAROM_E_BUFFER_TOO_SMALL, 3, [](Bench& b, carom_error* e) { uint64_t n; carom_group c; return carom_world_get_groups(b.world, &c, 4, 1, &n, e); }},
    {"groups: count", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { return carom_world_get_groups(b.world, nullptr, 0, 0, nullptr, e); }},
    {"save: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint64_t n; return carom_world_save(nullptr, 0, nullptr, 0, &n, e); }},
    {"save: flags", CAROM_E_UNSUPPORTED, 2, [](Bench& b, carom_error* e) { uint64_t n; return carom_world_save(b.world, 1u << 31, nullptr, 0, &n, e); }},
    {"save: buffer", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { uint64_t n; return carom_world_save(b.world, 0, nullptr, 8, &n, e); }},
    {"save: capacity", CAROM_E_BUFFER_TOO_SMALL, 4, [](Bench& b, carom_error* e) { uint64_t n; char c[8]; return carom_world_save(b.world, 0, c, 8, &n, e); }},
    {"save: needed", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { return carom_world_save(b.world, 0, nullptr, 0, nullptr, e); }},
    {"restore: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_world_restore(nullptr, "", 1, e); }},
    {"restore: bytes", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return carom_world_restore(b.world, nullptr, 1, e); }},
    {"restore: no bytes", CAROM_E_CORRUPT, 2, [](Bench& b, carom_error* e) { return carom_world_restore(b.world, "", 0, e); }},
    {"restore: other bytes", CAROM_E_CORRUPT, 2, [](Bench& b, carom_error* e) { return carom_world_restore(b.world, "these bytes are no snapshot of anything", 39, e); }},
    {"compare: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { carom_difference d = {}; d.struct_size = sizeof d; return carom_world_compare(nullptr, "", 1, &d, e); }},
    {"compare: bytes", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { carom_difference d = {}; d.struct_size = sizeof d; return carom_world_compare(b.world, nullptr, 1, &d, e); }},
    {"compare: no snapshot", CAROM_E_CORRUPT, 2, [](Bench& b, carom_error* e) { carom_difference d = {}; d.struct_size = sizeof d; return carom_world_compare(b.world, "nothing", 7, &d, e); }},
    {"compare: difference", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { return carom_world_compare(b.world, "nothing", 7, nullptr, e); }},
    {"compare: struct_size", CAROM_E_STRUCT_SIZE, 4, [](Bench& b, carom_error* e) { carom_difference d = {}; return carom_world_compare(b.world, "nothing", 7, &d, e); }},
    {"fork: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { carom_world* w; return carom_world_fork(nullptr, &w, e); }},
    {"fork: copy", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return carom_world_fork(b.world, nullptr, e); }},
    {"translate: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { uint64_t h; return carom_world_translate_handles(nullptr, &b.material, 1, &h, e); }},
    {"translate: handles", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { uint64_t h; return carom_world_translate_handles(b.world, nullptr, 1, &h, e); }},
    {"translate: a shape", CAROM_E_WRONG_KIND, 2, [](Bench& b, carom_error* e) { uint64_t h; return carom_world_translate_handles(b.world, &b.ball, 1, &h, e); }},
    {"translate: out", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { return carom_world_translate_handles(b.world, &b.material, 1, nullptr, e); }},
    {"record: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_world_record_begin(nullptr, 0, [](void*, const void*, uint64_t) { return 0; }, nullptr, e); }},
    {"record: flags", CAROM_E_UNSUPPORTED, 2, [](Bench& b, carom_error* e) { return carom_world_record_begin(b.world, 2, [](void*, const void*, uint64_t) { return 0; }, nullptr, e); }},
    {"record: write", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_world_record_begin(b.world, 0, nullptr, nullptr, e); }},
    {"record: full", CAROM_E_WRITE_FAILED, 0, [](Bench& b, carom_error* e) { return carom_world_record_begin(b.world, 0, [](void*, const void*, uint64_t) { return 1; }, nullptr, e); }},
    {"record end: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_world_record_end(nullptr, e); }},
    {"record end: none", CAROM_E_NOT_FOUND, 1, [](Bench& b, carom_error* e) { return carom_world_record_end(b.world, e); }},
    {"accuracy: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_world_set_accuracy(nullptr, nullptr, e); }},
    {"accuracy read: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint32_t n; carom_accuracy a = {}; a.struct_size = sizeof a; return carom_world_get_accuracy(nullptr, &a, &n, e); }},
    {"accuracy read: out", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { uint32_t n; return carom_world_get_accuracy(b.world, nullptr, &n, e); }},
    {"accuracy read: present", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { carom_accuracy a = {}; a.struct_size = sizeof a; return carom_world_get_accuracy(b.world, &a, nullptr, e); }},
    {"growth: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { carom_growth g = {}; g.struct_size = sizeof g; return carom_world_measure_growth(nullptr, 0.01, 1, &g, e); }},
    {"growth: no step", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { carom_growth g = {}; g.struct_size = sizeof g; return carom_world_measure_growth(b.world, 0, 1, &g, e); }},
    {"growth: not a step", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { carom_growth g = {}; g.struct_size = sizeof g; return carom_world_measure_growth(b.world, NAN, 1, &g, e); }},
    {"growth: no steps", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { carom_growth g = {}; g.struct_size = sizeof g; return carom_world_measure_growth(b.world, 0.01, 0, &g, e); }},
    {"growth: out", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { return carom_world_measure_growth(b.world, 0.01, 1, nullptr, e); }},
    {"growth: size", CAROM_E_STRUCT_SIZE, 4, [](Bench& b, carom_error* e) { carom_growth g = {}; return carom_world_measure_growth(b.world, 0.01, 1, &g, e); }},
    {"islands: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint64_t n; return carom_world_get_islands(nullptr, nullptr, 0, 0, &n, e); }},
    {"islands: stride", CAROM_E_BUFFER_TOO_SMALL, 3, [](Bench& b, carom_error* e) { uint64_t n; carom_island i; return carom_world_get_islands(b.world, &i, 4, 1, &n, e); }},
    {"ledger on: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_world_enable_ledger(nullptr, 1, e); }},
    {"ledger on: on", CAROM_E_UNKNOWN_ENUM, 2, [](Bench& b, carom_error* e) { return carom_world_enable_ledger(b.world, 2, e); }},
    {"ledger: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint64_t n; return carom_world_get_ledger(nullptr, nullptr, 0, 0, &n, e); }},
    {"ledger: dst", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { uint64_t n; return carom_world_get_ledger(b.world, nullptr, sizeof(carom_ledger_entry), 1, &n, e); }},
    {"ledger: stride", CAROM_E_BUFFER_TOO_SMALL, 3, [](Bench& b, carom_error* e) { uint64_t n; carom_ledger_entry l; return carom_world_get_ledger(b.world, &l, 4, 1, &n, e); }},
    {"ledger: count", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { return carom_world_get_ledger(b.world, nullptr, 0, 0, nullptr, e); }},
    {"ledger state: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { carom_ledger_state s = {}; s.struct_size = sizeof s; return carom_world_get_ledger_state(nullptr, &s, e); }},
    {"ledger state: out", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return carom_world_get_ledger_state(b.world, nullptr, e); }},
    {"ledger state: struct_size", CAROM_E_STRUCT_SIZE, 2, [](Bench& b, carom_error* e) { carom_ledger_state s = {}; return carom_world_get_ledger_state(b.world, &s, e); }},
    {"residuals: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { carom_residuals r = {}; r.struct_size = sizeof r; return carom_world_get_residuals(nullptr, &r, e); }},
    {"residuals: out", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return carom_world_get_residuals(b.world, nullptr, e); }},
    {"residuals: struct_size", CAROM_E_STRUCT_SIZE, 2, [](Bench& b, carom_error* e) { carom_residuals r = {}; return carom_world_get_residuals(b.world, &r, e); }},
    {"set budget: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_world_set_budget(nullptr, 0, 0, 0, e); }},
    {"set budget: negative", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return carom_world_set_budget(b.world, -1e-3, 1, 4, e); }},
    {"set budget: nan", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return carom_world_set_budget(b.world, NAN, 1, 4, e); }},
    {"set budget: minutes", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return carom_world_set_budget(b.world, 60, 1, 4, e); }},
    {"set budget: none", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { return carom_world_set_budget(b.world, 1e-3, 0, 4, e); }},
    {"set budget: crossed", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { return carom_world_set_budget(b.world, 1e-3, 5, 4, e); }},
    {"set budget: most", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { return carom_world_set_budget(b.world, 1e-3, 1, 65, e); }},
    {"get budget: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { double s; uint32_t n, m; return carom_world_get_budget(nullptr, &s, &n, &m, e); }},
    {"get budget: seconds", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { uint32_t n, m; return carom_world_get_budget(b.world, nullptr, &n, &m, e); }},
    {"get budget: fewest", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { double s; uint32_t m; return carom_world_get_budget(b.world, &s, nullptr, &m, e); }},
    {"get budget: most", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { double s; uint32_t n; return carom_world_get_budget(b.world, &s, &n, nullptr, e); }},
    {"faults: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint64_t n; return carom_world_get_faults(nullptr, nullptr, 0, 0, &n, e); }},
    {"faults: dst", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { uint64_t n; return carom_world_get_faults(b.world, nullptr, sizeof(carom_fault), 1, &n, e); }},
    {"faults: stride", CAROM_E_BUFFER_TOO_SMALL, 3, [](Bench& b, carom_error* e) { uint64_t n; carom_fault f; return carom_world_get_faults(b.world, &f, 0, 1, &n, e); }},
    {"faults: count", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { return carom_world_get_faults(b.world, nullptr, 0, 0, nullptr, e); }},
    {"hash: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint64_t h; return carom_world_hash(nullptr, &h, e); }},
    {"hash: out", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return carom_world_hash(b.world, nullptr, e); }},
    {"preset: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_world_set_preset(nullptr, 0, e); }},
    {"preset: unknown", CAROM_E_UNKNOWN_ENUM, 2, [](Bench& b, carom_error* e) { return carom_world_set_preset(b.world, CAROM_PRESET_COUNT, e); }},
    {"preset's dial: unknown preset", CAROM_E_UNKNOWN_ENUM, 1, [](Bench&, carom_error* e) { double v; return carom_preset_get_dial(CAROM_PRESET_COUNT, 0, &v, e); }},
    {"preset's dial: unknown dial", CAROM_E_UNKNOWN_ENUM, 2, [](Bench&, carom_error* e) { double v; return carom_preset_get_dial(0, CAROM_DIAL_COUNT, &v, e); }},
    {"preset's dial: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench&, carom_error* e) { return carom_preset_get_dial(0, CAROM_DIAL_SUBSTEPS, nullptr, e); }},
    {"preset's dial: left alone", CAROM_E_NOT_FOUND, 2, [](Bench&, carom_error* e) { double v; return carom_preset_get_dial(0, CAROM_DIAL_SLEEP, &v, e); }},
    {"dial info: unknown", CAROM_E_UNKNOWN_ENUM, 1, [](Bench&, carom_error* e) { carom_dial_info i = {}; i.struct_size = sizeof i; return carom_dial_get_info(CAROM_DIAL_COUNT, &i, e); }},
    {"dial info: out", CAROM_E_NULL_ARGUMENT, 2, [](Bench&, carom_error* e) { return carom_dial_get_info(0, nullptr, e); }},
    {"dial info: struct_size", CAROM_E_STRUCT_SIZE, 2, [](Bench&, carom_error* e) { carom_dial_info i = {}; return carom_dial_get_info(0, &i, e); }},
    {"dial find: name", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint32_t d; return carom_dial_find(nullptr, &d, e); }},
    {"dial find: out", CAROM_E_NULL_ARGUMENT, 2, [](Bench&, carom_error* e) { return carom_dial_find("solver", nullptr, e); }},
    {"dial find: unknown", CAROM_E_NOT_FOUND, 1, [](Bench&, carom_error* e) { uint32_t d; return carom_dial_find("charm", &d, e); }},
    {"dial find: a constant", CAROM_E_READ_ONLY, 1, [](Bench&, carom_error* e) { uint32_t d; return carom_dial_find("direct_impact_share", &d, e); }},
    {"constant info: unknown", CAROM_E_UNKNOWN_ENUM, 1, [](Bench&, carom_error* e) { uint32_t n; carom_constant_get_count(&n); carom_constant_info i = {}; i.struct_size = sizeof i; return carom_constant_get_info(n, &i, e); }},
    {"constant info: out", CAROM_E_NULL_ARGUMENT, 2, [](Bench&, carom_error* e) { return carom_constant_get_info(0, nullptr, e); }},
    {"constant info: struct_size", CAROM_E_STRUCT_SIZE, 2, [](Bench&, carom_error* e) { carom_constant_info i = {}; return carom_constant_get_info(0, &i, e); }},
};
// clang-format on

// clang-format off
const Row kBody[] = {
    {"body: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { carom_body o; auto d = body_desc(); return carom_body_create(nullptr, &d, &o, e); }},
    {"body: desc", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { carom_body o; return carom_body_create(b.world, nullptr, &o, e); }},
    {"body: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { auto d = body_desc(); return carom_body_create(b.world, &d, nullptr, e); }},
    {"body: struct_size", CAROM_E_STRUCT_SIZE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.struct_size = 4; }), e); }},
    {"body: type", CAROM_E_UNKNOWN_ENUM, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.type = 3; }), e); }},
    {"body: fields", CAROM_E_UNSUPPORTED, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.fields = 32; }), e); }},
    {"body: reserved", CAROM_E_UNSUPPORTED, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.reserved = 1; }), e); }},
    {"body: position", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.position[1] = kInf; }), e); }},
    {"body: orientation nan", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.orientation[0] = kNan; }), e); }},
    {"body: orientation long", CAROM_E_NOT_UNIT, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.orientation[3] = 1 + 2e-6; }), e); }},
    {"body: orientation zero", CAROM_E_NOT_UNIT, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.orientation[3] = 0; }), e); }},
    {"body: orientation huge", CAROM_E_NOT_UNIT, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.orientation[3] = 1e300; }), e); }},
    {"body: velocity", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.linear_velocity[0] = kNan; }), e); }},
    {"body: spin", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.angular_velocity[2] = -kInf; }), e); }},
    {"body: static with velocity", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.type = CAROM_BODY_STATIC; d.linear_velocity[0] = 1; }), e); }},
    {"body: static with spin", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.type = CAROM_BODY_STATIC; d.angular_velocity[0] = 1; }), e); }},
    {"body: massless", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.fields = CAROM_BODY_FIELD_MASS; }), e); }},
    {"body: negative mass", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.fields = CAROM_BODY_FIELD_MASS; d.mass = -1; }), e); }},
    {"body: nan mass", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.fields = CAROM_BODY_FIELD_MASS; d.mass = kNan; }), e); }},
    {"body: centre without mass", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.fields = CAROM_BODY_FIELD_CENTER; }), e); }},
    {"body: inertia without mass", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.fields = CAROM_BODY_FIELD_INERTIA; }), e); }},
    {"body: nan centre", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.fields = 3; d.mass = 1; d.center[0] = kNan; }), e); }},
    {"body: nan inertia", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.fields = 5; d.mass = 1; d.inertia[4] = kNan; }), e); }},
    {"body: asymmetric inertia", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.fields = 5; d.mass = 1; d.inertia[0] = d.inertia[4] = d.inertia[8] = 1; d.inertia[1] = 0.1; }), e); }},
    {"body: indefinite inertia", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.fields = 5; d.mass = 1; d.inertia[0] = d.inertia[4] = d.inertia[8] = 1; d.inertia[1] = d.inertia[3] = 2; }), e); }},
    {"body: flat inertia", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.fields = 5; d.mass = 1; d.inertia[0] = d.inertia[4] = 1; }), e); }},
    {"body: damping", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.linear_damping = -1; }), e); }},
    {"body: spin damping", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return create_body(b, with<carom_body_desc>(body_desc(), [](auto& d) { d.angular_damping = kNan; }), e); }},
    {"destroy body: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_body_destroy(nullptr, b.bodies[0], e); }},
    {"get body: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { auto d = body_desc(); return carom_body_get(nullptr, b.bodies[0], &d, e); }},
    {"get body: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_body_get(b.world, b.bodies[0], nullptr, e); }},
    {"get body: struct_size", CAROM_E_STRUCT_SIZE, 3, [](Bench& b, carom_error* e) { auto d = body_desc(); d.struct_size = 0; return carom_body_get(b.world, b.bodies[0], &d, e); }},
    {"pose: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_body_set_pose(nullptr, b.bodies[0], kZero, kUpright, e); }},
    {"pose: position", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_body_set_pose(b.world, b.bodies[0], nullptr, kUpright, e); }},
    {"pose: orientation", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { return carom_body_set_pose(b.world, b.bodies[0], kZero, nullptr, e); }},
    {"pose: nan", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return carom_body_set_pose(b.world, b.bodies[0], kNan3, kUpright, e); }},
    {"pose: nan turn", CAROM_E_NOT_FINITE, 4, [](Bench& b, carom_error* e) { return carom_body_set_pose(b.world, b.bodies[0], kZero, kNan4, e); }},
    {"pose: long", CAROM_E_NOT_UNIT, 4, [](Bench& b, carom_error* e) { return carom_body_set_pose(b.world, b.bodies[0], kZero, kLong, e); }},
    {"velocity: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_body_set_velocity(nullptr, b.bodies[0], kZero, kZero, e); }},
    {"velocity: linear", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_body_set_velocity(b.world, b.bodies[0], nullptr, kZero, e); }},
    {"velocity: angular", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { return carom_body_set_velocity(b.world, b.bodies[0], kZero, nullptr, e); }},
    {"velocity: inf", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return carom_body_set_velocity(b.world, b.bodies[0], kInf3, kZero, e); }},
    {"velocity: nan", CAROM_E_NOT_FINITE, 4, [](Bench& b, carom_error* e) { return carom_body_set_velocity(b.world, b.bodies[0], kZero, kNan3, e); }},
    {"velocity of a static body", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { return carom_body_set_velocity(b.world, b.ground, kOne, kZero, e); }},
    {"spin of a static body", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { return carom_body_set_velocity(b.world, b.ground, kZero, kOne, e); }},
    {"asleep: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { uint32_t a; return carom_body_is_asleep(nullptr, b.bodies[0], &a, e); }},
    {"asleep: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_body_is_asleep(b.world, b.bodies[0], nullptr, e); }},
    {"wake: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_body_wake(nullptr, b.bodies[0], e); }},
    {"force: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_body_add_force(nullptr, b.bodies[0], kZero, kZero, e); }},
    {"force: null", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_body_add_force(b.world, b.bodies[0], nullptr, kZero, e); }},
    {"torque: null", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { return carom_body_add_force(b.world, b.bodies[0], kZero, nullptr, e); }},
    {"force: nan", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return carom_body_add_force(b.world, b.bodies[0], kNan3, kZero, e); }},
    {"torque: inf", CAROM_E_NOT_FINITE, 4, [](Bench& b, carom_error* e) { return carom_body_add_force(b.world, b.bodies[0], kZero, kInf3, e); }},
    {"impulse: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_body_add_impulse(nullptr, b.bodies[0], kZero, kZero, e); }},
    {"impulse: null", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_body_add_impulse(b.world, b.bodies[0], nullptr, kZero, e); }},
    {"impulse point: null", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { return carom_body_add_impulse(b.world, b.bodies[0], kZero, nullptr, e); }},
    {"impulse: nan", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return carom_body_add_impulse(b.world, b.bodies[0], kNan3, kZero, e); }},
    {"impulse point: nan", CAROM_E_NOT_FINITE, 4, [](Bench& b, carom_error* e) { return carom_body_add_impulse(b.world, b.bodies[0], kZero, kNan3, e); }},
};
// clang-format on

// clang-format off
const Row kCollider[] = {
    {"material: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { carom_material o; auto d = material_desc(); return carom_material_create(nullptr, &d, &o, e); }},
    {"material: desc", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { carom_material o; return carom_material_create(b.world, nullptr, &o, e); }},
    {"material: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { auto d = material_desc(); return carom_material_create(b.world, &d, nullptr, e); }},
    {"material: friction", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return create_material(b, with<carom_material_desc>(material_desc(), [](auto& d) { d.friction = -0.1; }), e); }},
    {"material: friction nan", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return create_material(b, with<carom_material_desc>(material_desc(), [](auto& d) { d.friction = kNan; }), e); }},
    {"material: restitution", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return create_material(b, with<carom_material_desc>(material_desc(), [](auto& d) { d.restitution = 1.1; }), e); }},
    {"material: mix", CAROM_E_UNKNOWN_ENUM, 2, [](Bench& b, carom_error* e) { return create_material(b, with<carom_material_desc>(material_desc(), [](auto& d) { d.friction_mix = 5; }), e); }},
    {"material: other mix", CAROM_E_UNKNOWN_ENUM, 2, [](Bench& b, carom_error* e) { return create_material(b, with<carom_material_desc>(material_desc(), [](auto& d) { d.restitution_mix = 99; }), e); }},
    {"material: reserved", CAROM_E_UNSUPPORTED, 2, [](Bench& b, carom_error* e) { return create_material(b, with<carom_material_desc>(material_desc(), [](auto& d) { d.reserved = 1; }), e); }},
    {"update material: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { auto d = material_desc(); return carom_material_update(nullptr, b.material, &d, e); }},
    {"update material: desc", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_material_update(b.world, b.material, nullptr, e); }},
    {"update material: friction", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { auto d = material_desc(); d.friction = 1001; return carom_material_update(b.world, b.material, &d, e); }},
    {"continuous: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_body_set_continuous(nullptr, b.bodies[0], 0, e); }},
    {"continuous: body", CAROM_E_WRONG_KIND, 2, [](Bench& b, carom_error* e) { return carom_body_set_continuous(b.world, b.colliders[0], 0, e); }},
    {"continuous: mode", CAROM_E_UNKNOWN_ENUM, 3, [](Bench& b, carom_error* e) { return carom_body_set_continuous(b.world, b.bodies[0], 3, e); }},
    {"enabled: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_body_set_enabled(nullptr, b.bodies[0], 0, e); }},
    {"enabled: body", CAROM_E_WRONG_KIND, 2, [](Bench& b, carom_error* e) { return carom_body_set_enabled(b.world, b.colliders[0], 0, e); }},
    {"enabled: value", CAROM_E_UNKNOWN_ENUM, 3, [](Bench& b, carom_error* e) { return carom_body_set_enabled(b.world, b.bodies[0], 2, e); }},
    {"is enabled: body", CAROM_E_INVALID_HANDLE, 2, [](Bench& b, carom_error* e) { uint32_t m; return carom_body_is_enabled(b.world, 0, &m, e); }},
    {"is enabled: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_body_is_enabled(b.world, b.bodies[0], nullptr, e); }},
    {"get continuous: body", CAROM_E_INVALID_HANDLE, 2, [](Bench& b, carom_error* e) { uint32_t m; return carom_body_get_continuous(b.world, 0, &m, e); }},
    {"get continuous: mode", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_body_get_continuous(b.world, b.bodies[0], nullptr, e); }},
    {"resistance: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_material_set_resistance(nullptr, b.material, 0, 0, e); }},
    {"resistance: rolling", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { return carom_material_set_resistance(b.world, b.material, -1, 0, e); }},
    {"resistance: rolling, too much", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { return carom_material_set_resistance(b.world, b.material, 1001, 0, e); }},
    {"resistance: spinning nan", CAROM_E_NOT_FINITE, 4, [](Bench& b, carom_error* e) { return carom_material_set_resistance(b.world, b.material, 0, kNan, e); }},
    {"get resistance: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { double r, s; return carom_material_get_resistance(nullptr, b.material, &r, &s, e); }},
    {"get resistance: rolling", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { double s; return carom_material_get_resistance(b.world, b.material, nullptr, &s, e); }},
    {"get resistance: spinning", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { double r; return carom_material_get_resistance(b.world, b.material, &r, nullptr, e); }},
    {"pair: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_material_set_pair(nullptr, b.material, b.material, nullptr, e); }},
    {"pair: first", CAROM_E_INVALID_HANDLE, 2, [](Bench& b, carom_error* e) { return carom_material_set_pair(b.world, 0, b.material, nullptr, e); }},
    {"pair: second", CAROM_E_INVALID_HANDLE, 3, [](Bench& b, carom_error* e) { return carom_material_set_pair(b.world, b.material, 0, nullptr, e); }},
    {"pair: friction", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { const double s[4] = {1001, 0, 0, 0}; return carom_material_set_pair(b.world, b.material, b.material, s, e); }},
    {"pair: restitution", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { const double s[4] = {1, 1.5, 0, 0}; return carom_material_set_pair(b.world, b.material, b.material, s, e); }},
    {"pair: rolling", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { const double s[4] = {1, 0, -1, 0}; return carom_material_set_pair(b.world, b.material, b.material, s, e); }},
    {"pair: spinning nan", CAROM_E_NOT_FINITE, 4, [](Bench& b, carom_error* e) { const double s[4] = {1, 0, 0, kNan}; return carom_material_set_pair(b.world, b.material, b.material, s, e); }},
    {"get pair: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { double s[4]; return carom_material_get_pair(nullptr, b.material, b.material, s, e); }},
    {"get pair: first", CAROM_E_INVALID_HANDLE, 2, [](Bench& b, carom_error* e) { double s[4]; return carom_material_get_pair(b.world, 0, b.material, s, e); }},
    {"get pair: second", CAROM_E_INVALID_HANDLE, 3, [](Bench& b, carom_error* e) { double s[4]; return carom_material_get_pair(b.world, b.material, 0, s, e); }},
    {"get pair: surface", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { return carom_material_get_pair(b.world, b.material, b.material, nullptr, e); }},
    {"destroy material: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_material_destroy(nullptr, b.material, e); }},
    {"destroy material in use", CAROM_E_IN_USE, 2, [](Bench& b, carom_error* e) { return carom_material_destroy(b.world, b.material, e); }},
    {"collider: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { carom_collider o; auto d = collider_desc(b); return carom_collider_create(nullptr, b.bodies[0], &d, &o, e); }},
    {"collider: desc", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { carom_collider o; return carom_collider_create(b.world, b.bodies[0], nullptr, &o, e); }},
    {"collider: out", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { auto d = collider_desc(b); return carom_collider_create(b.world, b.bodies[0], &d, nullptr, e); }},
    {"collider: reserved", CAROM_E_UNSUPPORTED, 3, [](Bench& b, carom_error* e) { return create_collider(b, with<carom_collider_desc>(collider_desc(b), [](auto& d) { d.reserved = 1; }), e); }},
    {"collider: position", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return create_collider(b, with<carom_collider_desc>(collider_desc(b), [](auto& d) { d.position[0] = kNan; }), e); }},
    {"collider: orientation", CAROM_E_NOT_UNIT, 3, [](Bench& b, carom_error* e) { return create_collider(b, with<carom_collider_desc>(collider_desc(b), [](auto& d) { d.orientation[0] = 1; }), e); }},
    {"collider: density", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { return create_collider(b, with<carom_collider_desc>(collider_desc(b), [](auto& d) { d.density = -1; }), e); }},
    {"collider: density inf", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return create_collider(b, with<carom_collider_desc>(collider_desc(b), [](auto& d) { d.density = kInf; }), e); }},
    {"collider: half-space that moves", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { auto d = collider_desc(b); d.shape = b.floor; return create_collider(b, d, e); }},
    {"destroy collider: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_collider_destroy(nullptr, b.colliders[0], e); }},
    {"get collider: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { auto d = collider_desc(b); carom_body o; return carom_collider_get(nullptr, b.colliders[0], &d, &o, e); }},
    {"get collider: desc", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { carom_body o; return carom_collider_get(b.world, b.colliders[0], nullptr, &o, e); }},
    {"get collider: body", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { auto d = collider_desc(b); return carom_collider_get(b.world, b.colliders[0], &d, nullptr, e); }},
};
// clang-format on

// clang-format off
const Row kBulk[] = {
    {"bodies: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint64_t n; return carom_world_get_bodies(nullptr, nullptr, 0, &n, e); }},
    {"bodies: count", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { return carom_world_get_bodies(b.world, nullptr, 0, nullptr, e); }},
    {"read: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { double o[7]; return carom_world_read(nullptr, 0, 1, b.bodies, 1, o, 0, e); }},
    {"read: field", CAROM_E_UNKNOWN_ENUM, 2, [](Bench& b, carom_error* e) { double o[7]; return carom_world_read(b.world, CAROM_FIELD_COUNT, 1, b.bodies, 1, o, 0, e); }},
    {"read: scalar", CAROM_E_UNKNOWN_ENUM, 3, [](Bench& b, carom_error* e) { double o[7]; return carom_world_read(b.world, 0, 2, b.bodies, 1, o, 0, e); }},
    {"read: n", CAROM_E_OUT_OF_RANGE, 5, [](Bench& b, carom_error* e) { double o[7]; return carom_world_read(b.world, 0, 1, nullptr, 1, o, 0, e); }},
    {"read: dst", CAROM_E_NULL_ARGUMENT, 6, [](Bench& b, carom_error* e) { return carom_world_read(b.world, 0, 1, b.bodies, 1, nullptr, 0, e); }},
    {"read: stride", CAROM_E_BUFFER_TOO_SMALL, 7, [](Bench& b, carom_error* e) { double o[7]; return carom_world_read(b.world, CAROM_FIELD_POSE, 1, b.bodies, 1, o, 55, e); }},
    {"write: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_world_write(nullptr, 0, 1, b.bodies, 1, kZero, 0, e); }},
    {"write: field", CAROM_E_UNKNOWN_ENUM, 2, [](Bench& b, carom_error* e) { return carom_world_write(b.world, 77, 1, b.bodies, 1, kZero, 0, e); }},
    {"write: read-only", CAROM_E_UNSUPPORTED, 2, [](Bench& b, carom_error* e) { return carom_world_write(b.world, CAROM_FIELD_MASS, 1, b.bodies, 1, kOne, 0, e); }},
    {"write: centre", CAROM_E_UNSUPPORTED, 2, [](Bench& b, carom_error* e) { return carom_world_write(b.world, CAROM_FIELD_CENTER, 1, b.bodies, 1, kOne, 0, e); }},
    {"write: scalar", CAROM_E_UNKNOWN_ENUM, 3, [](Bench& b, carom_error* e) { return carom_world_write(b.world, 0, 9, b.bodies, 1, kZero, 0, e); }},
    {"write: n", CAROM_E_OUT_OF_RANGE, 5, [](Bench& b, carom_error* e) { return carom_world_write(b.world, 0, 1, nullptr, 2, kZero, 0, e); }},
    {"write: src", CAROM_E_NULL_ARGUMENT, 6, [](Bench& b, carom_error* e) { return carom_world_write(b.world, 0, 1, b.bodies, 1, nullptr, 0, e); }},
    {"write: stride", CAROM_E_BUFFER_TOO_SMALL, 7, [](Bench& b, carom_error* e) { return carom_world_write(b.world, 0, 1, b.bodies, 1, kZero, 8, e); }},
    {"write: second is nan", CAROM_E_NOT_FINITE, 6, [](Bench& b, carom_error* e) { const double p[6] = {9, 9, 9, 9, kNan, 9}; return carom_world_write(b.world, 0, 1, b.bodies, 2, p, 0, e); }},
    {"write: second is not unit", CAROM_E_NOT_UNIT, 6, [](Bench& b, carom_error* e) { const double q[8] = {1, 0, 0, 0, 0, 0, 0, 0.9}; return carom_world_write(b.world, CAROM_FIELD_ORIENTATION, 1, b.bodies, 2, q, 0, e); }},
    {"write: float nan", CAROM_E_NOT_FINITE, 6, [](Bench& b, carom_error* e) { const float v[3] = {0, static_cast<float>(kNan), 0}; return carom_world_write(b.world, CAROM_FIELD_LINEAR_VELOCITY, 0, b.bodies, 1, v, 0, e); }},
    {"write: velocity of a static body", CAROM_E_OUT_OF_RANGE, 6, [](Bench& b, carom_error* e) { const double v[6] = {0, 0, 0, 0, 0, 1}; return carom_world_write(b.world, CAROM_FIELD_VELOCITY, 1, &b.ground, 1, v, 0, e); }},
    {"write joints: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_world_write_joints(nullptr, CAROM_JOINT_BULK_TARGET, 1, &b.joint, 1, kZero, 0, e); }},
    {"write joints: field", CAROM_E_UNKNOWN_ENUM, 2, [](Bench& b, carom_error* e) { return carom_world_write_joints(b.world, CAROM_JOINT_BULK_COUNT, 1, nullptr, 0, kZero, 0, e); }},
    {"write joints: read-only", CAROM_E_UNSUPPORTED, 2, [](Bench& b, carom_error* e) { return carom_world_write_joints(b.world, CAROM_JOINT_BULK_EFFORT, 1, nullptr, 0, kZero, 0, e); }},
    {"write joints: scalar", CAROM_E_UNKNOWN_ENUM, 3, [](Bench& b, carom_error* e) { return carom_world_write_joints(b.world, CAROM_JOINT_BULK_TARGET, 2, nullptr, 0, kZero, 0, e); }},
    {"write joints: n", CAROM_E_OUT_OF_RANGE, 5, [](Bench& b, carom_error* e) { return carom_world_write_joints(b.world, CAROM_JOINT_BULK_TARGET, 1, nullptr, 77, kZero, 0, e); }},
    {"write joints: a body", CAROM_E_WRONG_KIND, 4, [](Bench& b, carom_error* e) { return carom_world_write_joints(b.world, CAROM_JOINT_BULK_TARGET, 1, b.bodies, 1, kZero, 0, e); }},
    {"write joints: src", CAROM_E_NULL_ARGUMENT, 6, [](Bench& b, carom_error* e) { return carom_world_write_joints(b.world, CAROM_JOINT_BULK_TARGET, 1, b.bodies, 1, nullptr, 0, e); }},
    {"write joints: stride", CAROM_E_BUFFER_TOO_SMALL, 7, [](Bench& b, carom_error* e) { return carom_world_write_joints(b.world, CAROM_JOINT_BULK_MOTOR, 1, b.bodies, 1, kZero, 8, e); }},
    {"tree: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { uint64_t n; return carom_tree_get_coordinates(nullptr, b.bodies[0], nullptr, 0, 0, &n, e); }},
    {"tree: a joint", CAROM_E_INVALID_HANDLE, 2, [](Bench& b, carom_error* e) { uint64_t n; return carom_tree_get_coordinates(b.world, 0, nullptr, 0, 0, &n, e); }},
    {"tree: ground", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { uint64_t n; return carom_tree_get_coordinates(b.world, b.ground, nullptr, 0, 0, &n, e); }},
    {"tree: dst", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { uint64_t n; return carom_tree_get_coordinates(b.world, b.bodies[0], nullptr, sizeof(carom_tree_coordinate), 1, &n, e); }},
    {"tree: stride", CAROM_E_BUFFER_TOO_SMALL, 4, [](Bench& b, carom_error* e) { uint64_t n; carom_tree_coordinate c; return carom_tree_get_coordinates(b.world, b.bodies[0], &c, 4, 1, &n, e); }},
    {"tree: count", CAROM_E_NULL_ARGUMENT, 6, [](Bench& b, carom_error* e) { return carom_tree_get_coordinates(b.world, b.bodies[0], nullptr, 0, 0, nullptr, e); }},
    {"tree speeds: n", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { double v[7]; return carom_tree_get_speeds(b.world, b.bodies[0], v, 7, e); }},
    {"tree speeds: speeds", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_tree_get_speeds(b.world, b.bodies[0], nullptr, 6, e); }},
    {"tree forces: speeds", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { double v[6]; const double u[6] = {0, 0, 0, 0, 0, kNan}; return carom_tree_get_forces(b.world, b.bodies[0], u, nullptr, v, 6, e); }},
    {"tree forces: accelerations", CAROM_E_NOT_FINITE, 4, [](Bench& b, carom_error* e) { double v[6]; const double a[6] = {0, 0, 0, 0, 0, kInf}; return carom_tree_get_forces(b.world, b.bodies[0], nullptr, a, v, 6, e); }},
    {"tree forces: too large", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { double v[6]; const double u[6] = {0, 0, 0, 1e200, 2e200, 1e200}; return carom_tree_get_forces(b.world, b.bodies[3], u, nullptr, v, 6, e); }},
    {"tree forces: forces", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { return carom_tree_get_forces(b.world, b.bodies[0], nullptr, nullptr, nullptr, 6, e); }},
    {"tree forces: n", CAROM_E_OUT_OF_RANGE, 6, [](Bench& b, carom_error* e) { double v[6]; return carom_tree_get_forces(b.world, b.bodies[0], nullptr, nullptr, v, 0, e); }},
    {"tree mass: n", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { double v[36]; return carom_tree_get_mass(b.world, b.bodies[0], v, 36, e); }},
    {"tree mass: mass", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_tree_get_mass(b.world, b.bodies[0], nullptr, 6, e); }},
};
// clang-format on

// clang-format off
const Row kQuery[] = {
    {"distance: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { carom_distance r = {}; r.struct_size = sizeof r; return carom_shape_distance(nullptr, b.ball, kZero, kUpright, b.ball, kZero, kUpright, nullptr, &r, e); }},
    {"distance: position_a", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return measure(b, nullptr, kUpright, kZero, kUpright, nullptr, e); }},
    {"distance: orientation_a", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { return measure(b, kZero, nullptr, kZero, kUpright, nullptr, e); }},
    {"distance: position_b", CAROM_E_NULL_ARGUMENT, 6, [](Bench& b, carom_error* e) { return measure(b, kZero, kUpright, nullptr, kUpright, nullptr, e); }},
    {"distance: orientation_b", CAROM_E_NULL_ARGUMENT, 7, [](Bench& b, carom_error* e) { return measure(b, kZero, kUpright, kZero, nullptr, nullptr, e); }},
    {"distance: nan", CAROM_E_NOT_FINITE, 6, [](Bench& b, carom_error* e) { return measure(b, kZero, kUpright, kNan3, kUpright, nullptr, e); }},
    {"distance: inf", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return measure(b, kInf3, kUpright, kZero, kUpright, nullptr, e); }},
    {"distance: long", CAROM_E_NOT_UNIT, 4, [](Bench& b, carom_error* e) { return measure(b, kZero, kLong, kZero, kUpright, nullptr, e); }},
    {"distance: zero turn", CAROM_E_NOT_UNIT, 7, [](Bench& b, carom_error* e) { return measure(b, kZero, kUpright, kZero, kZero4, nullptr, e); }},
    {"distance: simplex", CAROM_E_UNKNOWN_ENUM, 8, [](Bench& b, carom_error* e) { auto d = distance_desc(); d.simplex = 3; return measure(b, kZero, kUpright, kZero, kUpright, &d, e); }},
    {"distance: narrow", CAROM_E_UNKNOWN_ENUM, 8, [](Bench& b, carom_error* e) { auto d = distance_desc(); d.narrow_phase = 2; return measure(b, kZero, kUpright, kZero, kUpright, &d, e); }},
    {"distance: routines", CAROM_E_UNKNOWN_ENUM, 8, [](Bench& b, carom_error* e) { auto d = distance_desc(); d.pair_routines = 2; return measure(b, kZero, kUpright, kZero, kUpright, &d, e); }},
    {"distance: tolerance", CAROM_E_OUT_OF_RANGE, 8, [](Bench& b, carom_error* e) { auto d = distance_desc(); d.tolerance = 0; return measure(b, kZero, kUpright, kZero, kUpright, &d, e); }},
    {"distance: tolerance nan", CAROM_E_NOT_FINITE, 8, [](Bench& b, carom_error* e) { auto d = distance_desc(); d.tolerance = kNan; return measure(b, kZero, kUpright, kZero, kUpright, &d, e); }},
    {"distance: margin", CAROM_E_OUT_OF_RANGE, 8, [](Bench& b, carom_error* e) { auto d = distance_desc(); d.hybrid_margin = -1; return measure(b, kZero, kUpright, kZero, kUpright, &d, e); }},
    {"distance: gjk cap", CAROM_E_OUT_OF_RANGE, 8, [](Bench& b, carom_error* e) { auto d = distance_desc(); d.gjk_iterations = 0; return measure(b, kZero, kUpright, kZero, kUpright, &d, e); }},
    {"distance: epa cap", CAROM_E_OUT_OF_RANGE, 8, [](Bench& b, carom_error* e) { auto d = distance_desc(); d.epa_iterations = 100000000; return measure(b, kZero, kUpright, kZero, kUpright, &d, e); }},
    {"distance: result", CAROM_E_NULL_ARGUMENT, 9, [](Bench& b, carom_error* e) { return carom_shape_distance(b.engine, b.ball, kZero, kUpright, b.ball, kZero, kUpright, nullptr, nullptr, e); }},
    {"distance: result size", CAROM_E_STRUCT_SIZE, 9, [](Bench& b, carom_error* e) { carom_distance r = {}; return carom_shape_distance(b.engine, b.ball, kZero, kUpright, b.ball, kZero, kUpright, nullptr, &r, e); }},
    {"distance: half-spaces", CAROM_E_UNSUPPORTED, 5, [](Bench& b, carom_error* e) { carom_distance r = {}; r.struct_size = sizeof r; return carom_shape_distance(b.engine, b.floor, kZero, kUpright, b.floor, kZero, kUpright, nullptr, &r, e); }},
    {"device: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { carom_device* d = nullptr; return carom_device_create(nullptr, 0, &d, e); }},
    {"device: device", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_device_create(b.engine, 0, nullptr, e); }},
    {"device: close", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_device_destroy(nullptr, e); }},
    {"device: info", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { carom_device_info i = {}; i.struct_size = sizeof i; return carom_device_get_info(nullptr, &i, e); }},
    {"device: pairs", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_device_pairs_distance(nullptr, nullptr, nullptr, nullptr, 0, e); }},
    {"pairs: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_pairs_distance(nullptr, nullptr, nullptr, nullptr, 0, e); }},
    {"pairs: pairs", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return carom_pairs_distance(b.engine, nullptr, nullptr, nullptr, 0, e); }},
    {"pairs: size", CAROM_E_STRUCT_SIZE, 2, [](Bench& b, carom_error* e) { return measure_pairs(b, [](Bench&, carom_pairs& p) { p.struct_size = 3; }, e); }},
    {"pairs: reserved", CAROM_E_UNSUPPORTED, 2, [](Bench& b, carom_error* e) { return measure_pairs(b, [](Bench&, carom_pairs& p) { p.reserved = 1; }, e); }},
    {"pairs: count", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return measure_pairs(b, [](Bench&, carom_pairs& p) { p.count = (1 << 24) + 1; }, e); }},
    {"pairs: shapes_a", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return measure_pairs(b, [](Bench&, carom_pairs& p) { p.shapes_a = nullptr; }, e); }},
    {"pairs: positions_b", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return measure_pairs(b, [](Bench&, carom_pairs& p) { p.positions_b = nullptr; }, e); }},
    {"pairs: orientations_a", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return measure_pairs(b, [](Bench&, carom_pairs& p) { p.orientations_a = nullptr; }, e); }},
    {"pairs: short stride", CAROM_E_BUFFER_TOO_SMALL, 2, [](Bench& b, carom_error* e) { return measure_pairs(b, [](Bench&, carom_pairs& p) { p.position_a_stride = 23; }, e); }},
    {"pairs: long stride", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return measure_pairs(b, [](Bench&, carom_pairs& p) { p.shape_b_stride = ~uint64_t(0); }, e); }},
    {"pairs: nan", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return measure_pairs(b, [](Bench&, carom_pairs& p) { p.positions_b = kNan3; }, e); }},
    {"pairs: long turn", CAROM_E_NOT_UNIT, 2, [](Bench& b, carom_error* e) { return measure_pairs(b, [](Bench&, carom_pairs& p) { p.orientations_a = kLong; }, e); }},
    {"pairs: a body for a shape", CAROM_E_WRONG_KIND, 2, [](Bench& b, carom_error* e) { return measure_pairs(b, [](Bench& of, carom_pairs& p) { p.shapes_a = &of.ground; }, e); }},
    {"pairs: half-spaces", CAROM_E_UNSUPPORTED, 2, [](Bench& b, carom_error* e) { return measure_pairs(b, [](Bench& of, carom_pairs& p) { p.shapes_a = p.shapes_b = &of.floor; }, e); }},
    {"pairs: tolerance", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { auto d = distance_desc(); d.tolerance = 0; return measure_pairs(b, as_it_is, e, &d); }},
    {"pairs: dst", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { carom_pairs p = {}; p.struct_size = sizeof p; p.count = 1; p.shapes_a = p.shapes_b = &b.ball; p.positions_a = p.positions_b = kZero; p.orientations_a = p.orientations_b = kUpright; return carom_pairs_distance(b.engine, &p, nullptr, nullptr, sizeof(carom_distance), e); }},
    {"pairs: stride", CAROM_E_BUFFER_TOO_SMALL, 5, [](Bench& b, carom_error* e) { return measure_pairs(b, as_it_is, e, nullptr, 4); }},
    {"pairs: endless stride", CAROM_E_OUT_OF_RANGE, 5, [](Bench& b, carom_error* e) { return measure_pairs(b, as_it_is, e, nullptr, ~uint64_t(0)); }},
};
// clang-format on

carom_cast fresh_cast() {
  carom_cast r = {};
  r.struct_size = sizeof r;
  return r;
}
carom_cast_desc cast_desc() {
  carom_cast_desc d;
  carom_cast_desc_init(&d, sizeof d);
  return d;
}
carom_motion motion() {
  carom_motion m;
  carom_motion_init(&m, sizeof m);
  return m;
}
int32_t ray(Bench& b, const double* p, const double* q, const double* o, const double* d, double max,
            const carom_cast_desc* desc, carom_error* e) {
  carom_cast r = fresh_cast();
  return carom_ray_cast(b.engine, b.ball, p, q, o, d, max, desc, &r, e);
}
int32_t move(Bench& b, const double* pa, const double* qa, const double* m, const double* pb, const double* qb,
             const carom_cast_desc* desc, carom_error* e) {
  carom_cast r = fresh_cast();
  return carom_shape_cast(b.engine, b.ball, pa, qa, m, b.crate, pb, qb, desc, &r, e);
}
int32_t impact(Bench& b, carom_shape s, const carom_motion& ma, carom_shape t, const carom_motion& mb, double duration,
               carom_error* e) {
  carom_cast r = fresh_cast();
  return carom_shape_time_of_impact(b.engine, s, &ma, t, &mb, duration, nullptr, &r, e);
}
int32_t overlap(Bench& b, const double* pa, const double* qa, const double* pb, const double* qb, carom_error* e) {
  carom_overlap r = {};
  r.struct_size = sizeof r;
  return carom_shape_overlap(b.engine, b.ball, pa, qa, b.crate, pb, qb, nullptr, &r, e);
}
/// One ray against one shape, changed by `f(rays, hits)`.
template <class F>
int32_t batch(Bench& b, F&& f, carom_error* e) {
  double origin[3] = {0, 3, 0}, direction[3] = {0, -1, 0}, time = 0;
  carom_rays rays = {};
  rays.struct_size = sizeof rays;
  rays.scalar = CAROM_SCALAR_F64;
  rays.count = 1;
  rays.origins = origin;
  rays.directions = direction;
  carom_ray_hits hits = {};
  hits.struct_size = sizeof hits;
  hits.scalar = CAROM_SCALAR_F64;
  hits.times = &time;
  f(rays, hits);
  return carom_rays_cast(b.engine, &b.ball, kZero, kUpright, 1, &rays, nullptr, &hits, e);
}

// clang-format off
const Row kCast[] = {
    {"ray: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { auto r = fresh_cast(); return carom_ray_cast(nullptr, b.ball, kZero, kUpright, kZero, kOne, 1, nullptr, &r, e); }},
    {"ray: position", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return ray(b, nullptr, kUpright, kZero, kOne, 1, nullptr, e); }},
    {"ray: position nan", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return ray(b, kNan3, kUpright, kZero, kOne, 1, nullptr, e); }},
    {"ray: orientation", CAROM_E_NOT_UNIT, 4, [](Bench& b, carom_error* e) { return ray(b, kZero, kLong, kZero, kOne, 1, nullptr, e); }},
    {"ray: origin", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { return ray(b, kZero, kUpright, nullptr, kOne, 1, nullptr, e); }},
    {"ray: origin nan", CAROM_E_NOT_FINITE, 5, [](Bench& b, carom_error* e) { return ray(b, kZero, kUpright, kNan3, kOne, 1, nullptr, e); }},
    {"ray: direction", CAROM_E_NULL_ARGUMENT, 6, [](Bench& b, carom_error* e) { return ray(b, kZero, kUpright, kZero, nullptr, 1, nullptr, e); }},
    {"ray: direction inf", CAROM_E_NOT_FINITE, 6, [](Bench& b, carom_error* e) { return ray(b, kZero, kUpright, kZero, kInf3, 1, nullptr, e); }},
    {"ray: max", CAROM_E_OUT_OF_RANGE, 7, [](Bench& b, carom_error* e) { return ray(b, kZero, kUpright, kZero, kOne, -1, nullptr, e); }},
    {"ray: max nan", CAROM_E_NOT_FINITE, 7, [](Bench& b, carom_error* e) { return ray(b, kZero, kUpright, kZero, kOne, kNan, nullptr, e); }},
    {"ray: iterations", CAROM_E_OUT_OF_RANGE, 8, [](Bench& b, carom_error* e) { auto d = cast_desc(); d.iterations = 0; return ray(b, kZero, kUpright, kZero, kOne, 1, &d, e); }},
    {"ray: too many iterations", CAROM_E_OUT_OF_RANGE, 8, [](Bench& b, carom_error* e) { auto d = cast_desc(); d.iterations = 10001; return ray(b, kZero, kUpright, kZero, kOne, 1, &d, e); }},
    {"ray: tolerance", CAROM_E_OUT_OF_RANGE, 8, [](Bench& b, carom_error* e) { auto d = cast_desc(); d.tolerance = 0; return ray(b, kZero, kUpright, kZero, kOne, 1, &d, e); }},
    {"ray: target", CAROM_E_OUT_OF_RANGE, 8, [](Bench& b, carom_error* e) { auto d = cast_desc(); d.target = -1; return ray(b, kZero, kUpright, kZero, kOne, 1, &d, e); }},
    {"ray: flags", CAROM_E_UNSUPPORTED, 8, [](Bench& b, carom_error* e) { auto d = cast_desc(); d.flags = CAROM_ASK_SENSORS; return ray(b, kZero, kUpright, kZero, kOne, 1, &d, e); }},
    {"ray: reserved", CAROM_E_UNSUPPORTED, 8, [](Bench& b, carom_error* e) { auto d = cast_desc(); d.reserved = 1; return ray(b, kZero, kUpright, kZero, kOne, 1, &d, e); }},
    {"ray: target nan", CAROM_E_NOT_FINITE, 8, [](Bench& b, carom_error* e) { auto d = cast_desc(); d.target = kNan; return ray(b, kZero, kUpright, kZero, kOne, 1, &d, e); }},
    {"ray: result", CAROM_E_NULL_ARGUMENT, 9, [](Bench& b, carom_error* e) { return carom_ray_cast(b.engine, b.ball, kZero, kUpright, kZero, kOne, 1, nullptr, nullptr, e); }},
    {"ray: result size", CAROM_E_STRUCT_SIZE, 9, [](Bench& b, carom_error* e) { carom_cast r = {}; return carom_ray_cast(b.engine, b.ball, kZero, kUpright, kZero, kOne, 1, nullptr, &r, e); }},
    {"cast: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { auto r = fresh_cast(); return carom_shape_cast(nullptr, b.ball, kZero, kUpright, kOne, b.ball, kZero, kUpright, nullptr, &r, e); }},
    {"cast: position_a", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return move(b, nullptr, kUpright, kOne, kZero, kUpright, nullptr, e); }},
    {"cast: orientation_a", CAROM_E_NOT_UNIT, 4, [](Bench& b, carom_error* e) { return move(b, kZero, kZero4, kOne, kZero, kUpright, nullptr, e); }},
    {"cast: motion", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { return move(b, kZero, kUpright, nullptr, kZero, kUpright, nullptr, e); }},
    {"cast: motion nan", CAROM_E_NOT_FINITE, 5, [](Bench& b, carom_error* e) { return move(b, kZero, kUpright, kNan3, kZero, kUpright, nullptr, e); }},
    {"cast: position_b", CAROM_E_NOT_FINITE, 7, [](Bench& b, carom_error* e) { return move(b, kZero, kUpright, kOne, kInf3, kUpright, nullptr, e); }},
    {"cast: orientation_b", CAROM_E_NULL_ARGUMENT, 8, [](Bench& b, carom_error* e) { return move(b, kZero, kUpright, kOne, kZero, nullptr, nullptr, e); }},
    {"cast: desc", CAROM_E_OUT_OF_RANGE, 9, [](Bench& b, carom_error* e) { auto d = cast_desc(); d.tolerance = -1; return move(b, kZero, kUpright, kOne, kZero, kUpright, &d, e); }},
    {"cast: result", CAROM_E_NULL_ARGUMENT, 10, [](Bench& b, carom_error* e) { return carom_shape_cast(b.engine, b.ball, kZero, kUpright, kOne, b.ball, kZero, kUpright, nullptr, nullptr, e); }},
    {"cast: half-spaces", CAROM_E_UNSUPPORTED, 6, [](Bench& b, carom_error* e) { auto r = fresh_cast(); return carom_shape_cast(b.engine, b.floor, kZero, kUpright, kOne, b.floor, kZero, kUpright, nullptr, &r, e); }},
    {"impact: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { auto r = fresh_cast(); auto m = motion(); return carom_shape_time_of_impact(nullptr, b.ball, &m, b.ball, &m, 1, nullptr, &r, e); }},
    {"impact: motion_a", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { auto r = fresh_cast(); auto m = motion(); return carom_shape_time_of_impact(b.engine, b.ball, nullptr, b.ball, &m, 1, nullptr, &r, e); }},
    {"impact: motion_b", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { auto r = fresh_cast(); auto m = motion(); return carom_shape_time_of_impact(b.engine, b.ball, &m, b.ball, nullptr, 1, nullptr, &r, e); }},
    {"impact: motion size", CAROM_E_STRUCT_SIZE, 3, [](Bench& b, carom_error* e) { auto m = motion(); m.struct_size = 4; return impact(b, b.ball, m, b.ball, motion(), 1, e); }},
    {"impact: reserved", CAROM_E_UNSUPPORTED, 3, [](Bench& b, carom_error* e) { auto m = motion(); m.reserved = 1; return impact(b, b.ball, m, b.ball, motion(), 1, e); }},
    {"impact: position", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { auto m = motion(); m.position[2] = kNan; return impact(b, b.ball, m, b.ball, motion(), 1, e); }},
    {"impact: orientation", CAROM_E_NOT_UNIT, 5, [](Bench& b, carom_error* e) { auto m = motion(); m.orientation[0] = 1; return impact(b, b.ball, motion(), b.ball, m, 1, e); }},
    {"impact: center", CAROM_E_NOT_FINITE, 5, [](Bench& b, carom_error* e) { auto m = motion(); m.center[0] = kInf; return impact(b, b.ball, motion(), b.ball, m, 1, e); }},
    {"impact: velocity", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { auto m = motion(); m.linear_velocity[0] = kInf; return impact(b, b.ball, m, b.ball, motion(), 1, e); }},
    {"impact: angular velocity", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { auto m = motion(); m.angular_velocity[1] = kNan; return impact(b, b.ball, m, b.ball, motion(), 1, e); }},
    {"impact: duration", CAROM_E_OUT_OF_RANGE, 6, [](Bench& b, carom_error* e) { return impact(b, b.ball, motion(), b.ball, motion(), -1, e); }},
    {"impact: duration nan", CAROM_E_NOT_FINITE, 6, [](Bench& b, carom_error* e) { return impact(b, b.ball, motion(), b.ball, motion(), kNan, e); }},
    {"impact: half-spaces", CAROM_E_UNSUPPORTED, 4, [](Bench& b, carom_error* e) { return impact(b, b.floor, motion(), b.floor, motion(), 1, e); }},
    {"impact: half-space that turns", CAROM_E_UNSUPPORTED, 5, [](Bench& b, carom_error* e) { auto m = motion(); m.angular_velocity[1] = 1; return impact(b, b.ball, motion(), b.floor, m, 1, e); }},
    {"impact: result", CAROM_E_NULL_ARGUMENT, 8, [](Bench& b, carom_error* e) { auto m = motion(); return carom_shape_time_of_impact(b.engine, b.ball, &m, b.ball, &m, 1, nullptr, nullptr, e); }},
    {"overlap: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { carom_overlap r = {}; r.struct_size = sizeof r; return carom_shape_overlap(nullptr, b.ball, kZero, kUpright, b.ball, kZero, kUpright, nullptr, &r, e); }},
    {"overlap: position_a", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return overlap(b, kNan3, kUpright, kZero, kUpright, e); }},
    {"overlap: orientation_a", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { return overlap(b, kZero, nullptr, kZero, kUpright, e); }},
    {"overlap: position_b", CAROM_E_NULL_ARGUMENT, 6, [](Bench& b, carom_error* e) { return overlap(b, kZero, kUpright, nullptr, kUpright, e); }},
    {"overlap: orientation_b", CAROM_E_NOT_UNIT, 7, [](Bench& b, carom_error* e) { return overlap(b, kZero, kUpright, kZero, kLong, e); }},
    {"overlap: result", CAROM_E_STRUCT_SIZE, 9, [](Bench& b, carom_error* e) { carom_overlap r = {}; return carom_shape_overlap(b.engine, b.ball, kZero, kUpright, b.ball, kZero, kUpright, nullptr, &r, e); }},
    {"overlap: half-spaces", CAROM_E_UNSUPPORTED, 5, [](Bench& b, carom_error* e) { carom_overlap r = {}; r.struct_size = sizeof r; return carom_shape_overlap(b.engine, b.floor, kZero, kUpright, b.floor, kZero, kUpright, nullptr, &r, e); }},
    {"rays: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_rays_cast(nullptr, &b.ball, kZero, kUpright, 1, nullptr, nullptr, nullptr, e); }},
    {"rays: shapes", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return carom_rays_cast(b.engine, nullptr, kZero, kUpright, 1, nullptr, nullptr, nullptr, e); }},
    {"rays: positions", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_rays_cast(b.engine, &b.ball, nullptr, kUpright, 1, nullptr, nullptr, nullptr, e); }},
    {"rays: orientations", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { return carom_rays_cast(b.engine, &b.ball, kZero, nullptr, 1, nullptr, nullptr, nullptr, e); }},
    {"rays: rays", CAROM_E_NULL_ARGUMENT, 6, [](Bench& b, carom_error* e) { return carom_rays_cast(b.engine, &b.ball, kZero, kUpright, 1, nullptr, nullptr, nullptr, e); }},
    {"rays: size", CAROM_E_STRUCT_SIZE, 6, [](Bench& b, carom_error* e) { return batch(b, [](carom_rays& r, carom_ray_hits&) { r.struct_size = 0; }, e); }},
    {"rays: scalar", CAROM_E_UNKNOWN_ENUM, 6, [](Bench& b, carom_error* e) { return batch(b, [](carom_rays& r, carom_ray_hits&) { r.scalar = 2; }, e); }},
    {"rays: origins", CAROM_E_NULL_ARGUMENT, 6, [](Bench& b, carom_error* e) { return batch(b, [](carom_rays& r, carom_ray_hits&) { r.origins = nullptr; }, e); }},
    {"rays: directions", CAROM_E_NULL_ARGUMENT, 6, [](Bench& b, carom_error* e) { return batch(b, [](carom_rays& r, carom_ray_hits&) { r.directions = nullptr; }, e); }},
    {"rays: stride", CAROM_E_BUFFER_TOO_SMALL, 6, [](Bench& b, carom_error* e) { return batch(b, [](carom_rays& r, carom_ray_hits&) { r.origin_stride = 23; }, e); }},
    {"rays: hits", CAROM_E_NULL_ARGUMENT, 8, [](Bench& b, carom_error* e) { carom_rays r = {}; r.struct_size = sizeof r; return carom_rays_cast(b.engine, &b.ball, kZero, kUpright, 1, &r, nullptr, nullptr, e); }},
    {"rays: hits size", CAROM_E_STRUCT_SIZE, 8, [](Bench& b, carom_error* e) { return batch(b, [](carom_rays&, carom_ray_hits& h) { h.struct_size = 7; }, e); }},
    {"rays: hits scalar", CAROM_E_UNKNOWN_ENUM, 8, [](Bench& b, carom_error* e) { return batch(b, [](carom_rays&, carom_ray_hits& h) { h.scalar = 9; }, e); }},
    {"rays: time stride", CAROM_E_BUFFER_TOO_SMALL, 8, [](Bench& b, carom_error* e) { return batch(b, [](carom_rays&, carom_ray_hits& h) { h.time_stride = 4; }, e); }},
    {"rays: record stride", CAROM_E_BUFFER_TOO_SMALL, 8, [](Bench& b, carom_error* e) { return batch(b, [](carom_rays&, carom_ray_hits& h) { h.record_stride = 4; }, e); }},
    {"rays: a position nan", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { carom_rays r = {}; r.struct_size = sizeof r; carom_ray_hits h = {}; h.struct_size = sizeof h; return carom_rays_cast(b.engine, &b.ball, kNan3, kUpright, 1, &r, nullptr, &h, e); }},
    {"rays: an orientation", CAROM_E_NOT_UNIT, 4, [](Bench& b, carom_error* e) { carom_rays r = {}; r.struct_size = sizeof r; carom_ray_hits h = {}; h.struct_size = sizeof h; return carom_rays_cast(b.engine, &b.ball, kZero, kLong, 1, &r, nullptr, &h, e); }},
    {"rays: desc", CAROM_E_OUT_OF_RANGE, 7, [](Bench& b, carom_error* e) { auto d = cast_desc(); d.target = 2e9; carom_rays r = {}; r.struct_size = sizeof r; carom_ray_hits h = {}; h.struct_size = sizeof h; return carom_rays_cast(b.engine, &b.ball, kZero, kUpright, 1, &r, &d, &h, e); }},
};
// clang-format on

// clang-format off
const Row kParticles[] = {
    {"particles: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { carom_particles s; return carom_particles_create(nullptr, nullptr, &s, e); }},
    {"particles: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_particles_create(b.world, nullptr, nullptr, e); }},
    {"particles: size", CAROM_E_STRUCT_SIZE, 2, [](Bench& b, carom_error* e) { carom_particles_desc d; carom_particles_desc_init(&d, sizeof d); d.struct_size = 5; carom_particles s; return carom_particles_create(b.world, &d, &s, e); }},
    {"particles: reserved", CAROM_E_UNSUPPORTED, 2, [](Bench& b, carom_error* e) { carom_particles_desc d; carom_particles_desc_init(&d, sizeof d); d.reserved = 1; carom_particles s; return carom_particles_create(b.world, &d, &s, e); }},
    {"particles: gravity_factor", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { carom_particles_desc d; carom_particles_desc_init(&d, sizeof d); d.gravity_factor = -1001; carom_particles s; return carom_particles_create(b.world, &d, &s, e); }},
    {"particles: gravity_factor nan", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { carom_particles_desc d; carom_particles_desc_init(&d, sizeof d); d.gravity_factor = kNan; carom_particles s; return carom_particles_create(b.world, &d, &s, e); }},
    {"particles: damping", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { carom_particles_desc d; carom_particles_desc_init(&d, sizeof d); d.linear_damping = -1; carom_particles s; return carom_particles_create(b.world, &d, &s, e); }},
    {"particles: damping inf", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { carom_particles_desc d; carom_particles_desc_init(&d, sizeof d); d.linear_damping = kInf; carom_particles s; return carom_particles_create(b.world, &d, &s, e); }},
    {"particles: mass", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { carom_particles_desc d; carom_particles_desc_init(&d, sizeof d); d.mass = 0; carom_particles s; return carom_particles_create(b.world, &d, &s, e); }},
    {"particles: mass nan", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { carom_particles_desc d; carom_particles_desc_init(&d, sizeof d); d.mass = kNan; carom_particles s; return carom_particles_create(b.world, &d, &s, e); }},
    {"particles: capacity", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { carom_particles_desc d; carom_particles_desc_init(&d, sizeof d); d.capacity = ~uint64_t(0); carom_particles s; return carom_particles_create(b.world, &d, &s, e); }},
    {"particles: destroy: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_particles_destroy(nullptr, b.particles, e); }},
    {"particles: get: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { carom_particles_desc d; carom_particles_desc_init(&d, sizeof d); return carom_particles_get(nullptr, b.particles, &d, e); }},
    {"particles: get: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_particles_get(b.world, b.particles, nullptr, e); }},
    {"particles: get: size", CAROM_E_STRUCT_SIZE, 3, [](Bench& b, carom_error* e) { carom_particles_desc d; carom_particles_desc_init(&d, sizeof d); d.struct_size = 4; return carom_particles_get(b.world, b.particles, &d, e); }},
    {"particles: update: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { carom_particles_desc d; carom_particles_desc_init(&d, sizeof d); return carom_particles_update(nullptr, b.particles, &d, e); }},
    {"particles: update: size", CAROM_E_STRUCT_SIZE, 3, [](Bench& b, carom_error* e) { carom_particles_desc d; carom_particles_desc_init(&d, sizeof d); d.struct_size = 9; return carom_particles_update(b.world, b.particles, &d, e); }},
    {"particles: update: mass", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { carom_particles_desc d; carom_particles_desc_init(&d, sizeof d); d.mass = -1; d.linear_damping = 7; return carom_particles_update(b.world, b.particles, &d, e); }},
    {"particles: count: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { uint64_t n; return carom_particles_get_count(nullptr, b.particles, &n, e); }},
    {"particles: count: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_particles_get_count(b.world, b.particles, nullptr, e); }},
    {"particles: add: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_particles_add(nullptr, b.particles, 1, 1, kZero, 0, nullptr, 0, e); }},
    {"particles: add: scalar", CAROM_E_UNKNOWN_ENUM, 4, [](Bench& b, carom_error* e) { return carom_particles_add(b.world, b.particles, 1, 2, kZero, 0, nullptr, 0, e); }},
    {"particles: add: positions", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { return carom_particles_add(b.world, b.particles, 1, 1, nullptr, 0, kZero, 0, e); }},
    {"particles: add: nan", CAROM_E_NOT_FINITE, 5, [](Bench& b, carom_error* e) { const double x[6] = {1, 2, 3, 4, 5, kNan}; return carom_particles_add(b.world, b.particles, 2, 1, x, 0, nullptr, 0, e); }},
    {"particles: add: float inf", CAROM_E_NOT_FINITE, 5, [](Bench& b, carom_error* e) { const float x[3] = {1, static_cast<float>(kInf), 3}; return carom_particles_add(b.world, b.particles, 1, 0, x, 0, nullptr, 0, e); }},
    {"particles: add: far", CAROM_E_OUT_OF_RANGE, 5, [](Bench& b, carom_error* e) { const double x[3] = {1e15, 1e15, 0}; return carom_particles_add(b.world, b.particles, 1, 1, x, 0, nullptr, 0, e); }},
    {"particles: add: very far", CAROM_E_OUT_OF_RANGE, 5, [](Bench& b, carom_error* e) { const double x[3] = {0, -1e300, 0}; return carom_particles_add(b.world, b.particles, 1, 1, x, 0, nullptr, 0, e); }},
    {"particles: add: position stride", CAROM_E_BUFFER_TOO_SMALL, 6, [](Bench& b, carom_error* e) { return carom_particles_add(b.world, b.particles, 1, 1, kZero, 23, nullptr, 0, e); }},
    {"particles: add: velocity nan", CAROM_E_NOT_FINITE, 7, [](Bench& b, carom_error* e) { return carom_particles_add(b.world, b.particles, 1, 1, kZero, 0, kNan3, 0, e); }},
    {"particles: add: fast", CAROM_E_OUT_OF_RANGE, 7, [](Bench& b, carom_error* e) { const double v[3] = {0, 1.1e9, 0}; return carom_particles_add(b.world, b.particles, 1, 1, kZero, 0, v, 0, e); }},
    {"particles: add: velocity stride", CAROM_E_BUFFER_TOO_SMALL, 8, [](Bench& b, carom_error* e) { return carom_particles_add(b.world, b.particles, 1, 0, kZero, 0, kZero, 8, e); }},
    {"particles: add: too many", CAROM_E_LIMIT, 3, [](Bench& b, carom_error* e) { return carom_particles_add(b.world, b.particles, uint64_t(1) << 31, 1, kZero, 0, nullptr, 0, e); }},
    {"particles: add: far too many", CAROM_E_LIMIT, 3, [](Bench& b, carom_error* e) { return carom_particles_add(b.world, b.particles, ~uint64_t(0), 1, kZero, 0, nullptr, 0, e); }},
    {"particles: remove: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_particles_remove(nullptr, b.particles, nullptr, 5, e); }},
    {"particles: remove: beyond", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { const uint32_t i[3] = {0, 1, 5}; return carom_particles_remove(b.world, b.particles, i, 3, e); }},
    {"particles: remove: twice", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { const uint32_t i[3] = {0, 1, 1}; return carom_particles_remove(b.world, b.particles, i, 3, e); }},
    {"particles: remove: not ascending", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { const uint32_t i[3] = {0, 3, 2}; return carom_particles_remove(b.world, b.particles, i, 3, e); }},
    {"particles: remove: n", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { return carom_particles_remove(b.world, b.particles, nullptr, 4, e); }},
    {"particles: read: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { double o[15]; return carom_particles_read(nullptr, b.particles, 0, 1, nullptr, 5, o, 0, e); }},
    {"particles: read: field", CAROM_E_UNKNOWN_ENUM, 3, [](Bench& b, carom_error* e) { double o[15]; return carom_particles_read(b.world, b.particles, CAROM_FIELD_COUNT, 1, nullptr, 5, o, 0, e); }},
    {"particles: read: orientation", CAROM_E_UNSUPPORTED, 3, [](Bench& b, carom_error* e) { double o[15]; return carom_particles_read(b.world, b.particles, CAROM_FIELD_ORIENTATION, 1, nullptr, 5, o, 0, e); }},
    {"particles: read: scalar", CAROM_E_UNKNOWN_ENUM, 4, [](Bench& b, carom_error* e) { double o[15]; return carom_particles_read(b.world, b.particles, 0, 2, nullptr, 5, o, 0, e); }},
    {"particles: read: index", CAROM_E_OUT_OF_RANGE, 5, [](Bench& b, carom_error* e) { const uint32_t i = 5; double o[3]; return carom_particles_read(b.world, b.particles, 0, 1, &i, 1, o, 0, e); }},
    {"particles: read: n", CAROM_E_OUT_OF_RANGE, 6, [](Bench& b, carom_error* e) { double o[15]; return carom_particles_read(b.world, b.particles, 0, 1, nullptr, 4, o, 0, e); }},
    {"particles: read: dst", CAROM_E_NULL_ARGUMENT, 7, [](Bench& b, carom_error* e) { return carom_particles_read(b.world, b.particles, 0, 1, nullptr, 5, nullptr, 0, e); }},
    {"particles: read: stride", CAROM_E_BUFFER_TOO_SMALL, 8, [](Bench& b, carom_error* e) { double o[15]; return carom_particles_read(b.world, b.particles, 0, 1, nullptr, 5, o, 16, e); }},
    {"particles: write: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { const uint32_t i[2] = {3, 1}; return carom_particles_write(nullptr, b.particles, 0, 1, i, 1, kZero, 0, e); }},
    {"particles: write: field", CAROM_E_UNKNOWN_ENUM, 3, [](Bench& b, carom_error* e) { const uint32_t i[2] = {3, 1}; return carom_particles_write(b.world, b.particles, 77, 1, i, 1, kZero, 0, e); }},
    {"particles: write: centre", CAROM_E_UNSUPPORTED, 3, [](Bench& b, carom_error* e) { const uint32_t i[2] = {3, 1}; return carom_particles_write(b.world, b.particles, CAROM_FIELD_CENTER, 1, i, 1, kZero, 0, e); }},
    {"particles: write: scalar", CAROM_E_UNKNOWN_ENUM, 4, [](Bench& b, carom_error* e) { const uint32_t i[2] = {3, 1}; return carom_particles_write(b.world, b.particles, 0, 9, i, 1, kZero, 0, e); }},
    {"particles: write: index", CAROM_E_OUT_OF_RANGE, 5, [](Bench& b, carom_error* e) { const uint32_t i = 0xFFFFFFFFu; return carom_particles_write(b.world, b.particles, 0, 1, &i, 1, kZero, 0, e); }},
    {"particles: write: n", CAROM_E_OUT_OF_RANGE, 6, [](Bench& b, carom_error* e) { return carom_particles_write(b.world, b.particles, 0, 1, nullptr, 1, kZero, 0, e); }},
    {"particles: write: src", CAROM_E_NULL_ARGUMENT, 7, [](Bench& b, carom_error* e) { const uint32_t i[2] = {3, 1}; return carom_particles_write(b.world, b.particles, 0, 1, i, 2, nullptr, 0, e); }},
    {"particles: write: second is nan", CAROM_E_NOT_FINITE, 7, [](Bench& b, carom_error* e) { const uint32_t i[2] = {3, 1}; const double x[6] = {9, 9, 9, 9, 9, kNan}; return carom_particles_write(b.world, b.particles, 0, 1, i, 2, x, 0, e); }},
    {"particles: write: second is far", CAROM_E_OUT_OF_RANGE, 7, [](Bench& b, carom_error* e) { const uint32_t i[2] = {3, 1}; const double x[6] = {9, 9, 9, 9, 9, 2e15}; return carom_particles_write(b.world, b.particles, 0, 1, i, 2, x, 0, e); }},
    {"particles: write: second is fast", CAROM_E_OUT_OF_RANGE, 7, [](Bench& b, carom_error* e) { const uint32_t i[2] = {3, 1}; const double x[6] = {9, 9, 9, 9, 9, 2e9}; return carom_particles_write(b.world, b.particles, CAROM_FIELD_LINEAR_VELOCITY, 1, i, 2, x, 0, e); }},
    {"particles: write: second weighs nothing", CAROM_E_OUT_OF_RANGE, 7, [](Bench& b, carom_error* e) { const uint32_t i[2] = {3, 1}; const double m[2] = {9, 0}; return carom_particles_write(b.world, b.particles, CAROM_FIELD_MASS, 1, i, 2, m, 0, e); }},
    {"particles: write: second weighs nan", CAROM_E_NOT_FINITE, 7, [](Bench& b, carom_error* e) { const uint32_t i[2] = {3, 1}; const double m[2] = {9, kNan}; return carom_particles_write(b.world, b.particles, CAROM_FIELD_MASS, 1, i, 2, m, 0, e); }},
    {"particles: write: stride", CAROM_E_BUFFER_TOO_SMALL, 8, [](Bench& b, carom_error* e) { const uint32_t i[2] = {3, 1}; return carom_particles_write(b.world, b.particles, 0, 1, i, 1, kZero, 8, e); }},
    {"particles: quarantined: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { uint64_t n; return carom_particles_get_quarantined(nullptr, b.particles, nullptr, 0, &n, e); }},
    {"particles: quarantined: indices", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { uint64_t n; return carom_particles_get_quarantined(b.world, b.particles, nullptr, 1, &n, e); }},
    {"particles: quarantined: count", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { return carom_particles_get_quarantined(b.world, b.particles, nullptr, 0, nullptr, e); }},
    {"particles: sets: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint64_t n; return carom_world_get_particles(nullptr, nullptr, 0, &n, e); }},
    {"particles: sets: count", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { return carom_world_get_particles(b.world, nullptr, 0, nullptr, e); }},
};
// clang-format on

carom_query_desc query_desc() {
  carom_query_desc d;
  carom_query_desc_init(&d, sizeof d);
  return d;
}
int32_t ask_ray(Bench& b, const carom_query_desc& d, carom_error* e) {
  carom_world_hit hit;
  return carom_world_cast_ray(b.world, kZero, kOne, 1, &d, &hit, sizeof hit, e);
}
/// A good batch of one ray, but for what is done to it.
int32_t ask_rays(Bench& b, void (*spoil)(carom_rays&, carom_world_hits&), carom_error* e) {
  carom_rays r = {};
  r.struct_size = sizeof r;
  r.scalar = CAROM_SCALAR_F64;
  r.count = 1;
  r.origins = kZero;
  r.directions = kOne;
  carom_world_hits h = {};
  h.struct_size = sizeof h;
  h.scalar = CAROM_SCALAR_F64;
  double time[3];
  h.times = time;
  spoil(r, h);
  return carom_world_cast_rays(b.world, &r, CAROM_WANT_FIRST, nullptr, &h, e);
}
/// Likewise of one moving shape.
int32_t ask_shapes(Bench& b, void (*spoil)(Bench&, carom_query_shapes&), carom_error* e) {
  carom_query_shapes s = {};
  s.struct_size = sizeof s;
  s.scalar = CAROM_SCALAR_F64;
  s.count = 1;
  s.shapes = &b.ball;
  s.positions = kZero;
  s.orientations = kUpright;
  s.motions = kOne;
  spoil(b, s);
  carom_world_hit hit;
  return carom_world_cast_shapes(b.world, &s, CAROM_WANT_FIRST, nullptr, &hit, 0, e);
}
carom_query_shapes one_point() {
  carom_query_shapes s = {};
  s.struct_size = sizeof s;
  s.scalar = CAROM_SCALAR_F64;
  s.count = 1;
  s.positions = kZero;
  s.motions = kOne;
  return s;
}
carom_rays one_ray() {
  carom_rays r = {};
  r.struct_size = sizeof r;
  r.scalar = CAROM_SCALAR_F64;
  r.count = 1;
  r.origins = kZero;
  r.directions = kOne;
  return r;
}

// clang-format off
const Row kWorldQuery[] = {
    {"ray: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { carom_world_hit h; return carom_world_cast_ray(nullptr, kZero, kOne, 1, nullptr, &h, sizeof h, e); }},
    {"ray: origin", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { carom_world_hit h; return carom_world_cast_ray(b.world, nullptr, kOne, 1, nullptr, &h, sizeof h, e); }},
    {"ray: origin nan", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { carom_world_hit h; return carom_world_cast_ray(b.world, kNan3, kOne, 1, nullptr, &h, sizeof h, e); }},
    {"ray: direction inf", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { carom_world_hit h; return carom_world_cast_ray(b.world, kZero, kInf3, 1, nullptr, &h, sizeof h, e); }},
    {"ray: max", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { carom_world_hit h; return carom_world_cast_ray(b.world, kZero, kOne, -1, nullptr, &h, sizeof h, e); }},
    {"ray: max nan", CAROM_E_NOT_FINITE, 4, [](Bench& b, carom_error* e) { carom_world_hit h; return carom_world_cast_ray(b.world, kZero, kOne, kNan, nullptr, &h, sizeof h, e); }},
    {"ray: desc size", CAROM_E_STRUCT_SIZE, 5, [](Bench& b, carom_error* e) { auto d = query_desc(); d.struct_size = 3; return ask_ray(b, d, e); }},
    {"ray: flags", CAROM_E_UNSUPPORTED, 5, [](Bench& b, carom_error* e) { auto d = query_desc(); d.flags = 8; return ask_ray(b, d, e); }},
    {"ray: reserved", CAROM_E_UNSUPPORTED, 5, [](Bench& b, carom_error* e) { auto d = query_desc(); d.reserved = 1; return ask_ray(b, d, e); }},
    {"ray: tolerance", CAROM_E_OUT_OF_RANGE, 5, [](Bench& b, carom_error* e) { auto d = query_desc(); d.tolerance = 0; return ask_ray(b, d, e); }},
    {"ray: target", CAROM_E_OUT_OF_RANGE, 5, [](Bench& b, carom_error* e) { auto d = query_desc(); d.target = -1; return ask_ray(b, d, e); }},
    {"ray: target nan", CAROM_E_NOT_FINITE, 5, [](Bench& b, carom_error* e) { auto d = query_desc(); d.target = kNan; return ask_ray(b, d, e); }},
    {"ray: iterations", CAROM_E_OUT_OF_RANGE, 5, [](Bench& b, carom_error* e) { auto d = query_desc(); d.iterations = 0; return ask_ray(b, d, e); }},
    {"ray: ignore", CAROM_E_WRONG_KIND, 5, [](Bench& b, carom_error* e) { auto d = query_desc(); d.ignore = b.colliders[0]; return ask_ray(b, d, e); }},
    {"ray: hit", CAROM_E_NULL_ARGUMENT, 6, [](Bench& b, carom_error* e) { return carom_world_cast_ray(b.world, kZero, kOne, 1, nullptr, nullptr, sizeof(carom_world_hit), e); }},
    {"ray: size", CAROM_E_BUFFER_TOO_SMALL, 7, [](Bench& b, carom_error* e) { carom_world_hit h; return carom_world_cast_ray(b.world, kZero, kOne, 1, nullptr, &h, 4, e); }},
    {"rays: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_world_cast_rays(nullptr, nullptr, 0, nullptr, nullptr, e); }},
    {"rays: rays", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return carom_world_cast_rays(b.world, nullptr, 0, nullptr, nullptr, e); }},
    {"rays: scalar", CAROM_E_UNKNOWN_ENUM, 2, [](Bench& b, carom_error* e) { return ask_rays(b, [](carom_rays& r, carom_world_hits&) { r.scalar = 2; }, e); }},
    {"rays: directions", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return ask_rays(b, [](carom_rays& r, carom_world_hits&) { r.directions = nullptr; }, e); }},
    {"rays: stride", CAROM_E_BUFFER_TOO_SMALL, 2, [](Bench& b, carom_error* e) { return ask_rays(b, [](carom_rays& r, carom_world_hits&) { r.direction_stride = 8; }, e); }},
    {"rays: want", CAROM_E_UNKNOWN_ENUM, 3, [](Bench& b, carom_error* e) { const carom_rays r = one_ray(); carom_world_hits h = {}; h.struct_size = sizeof h; return carom_world_cast_rays(b.world, &r, 2, nullptr, &h, e); }},
    {"rays: desc", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { auto d = query_desc(); d.target = 2e9; const carom_rays r = one_ray(); carom_world_hits h = {}; h.struct_size = sizeof h; return carom_world_cast_rays(b.world, &r, 0, &d, &h, e); }},
    {"rays: hits", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { const carom_rays r = one_ray(); return carom_world_cast_rays(b.world, &r, 0, nullptr, nullptr, e); }},
    {"rays: hits size", CAROM_E_STRUCT_SIZE, 5, [](Bench& b, carom_error* e) { return ask_rays(b, [](carom_rays&, carom_world_hits& h) { h.struct_size = 7; }, e); }},
    {"rays: time stride", CAROM_E_BUFFER_TOO_SMALL, 5, [](Bench& b, carom_error* e) { return ask_rays(b, [](carom_rays&, carom_world_hits& h) { h.time_stride = 4; }, e); }},
    {"all rays: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint64_t n; return carom_world_cast_rays_all(nullptr, nullptr, nullptr, nullptr, 0, 0, &n, e); }},
    {"all rays: rays", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { uint64_t n; return carom_world_cast_rays_all(b.world, nullptr, nullptr, nullptr, 0, 0, &n, e); }},
    {"all rays: dst", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { const carom_rays r = one_ray(); uint64_t n; return carom_world_cast_rays_all(b.world, &r, nullptr, nullptr, 0, 1, &n, e); }},
    {"all rays: stride", CAROM_E_BUFFER_TOO_SMALL, 5, [](Bench& b, carom_error* e) { const carom_rays r = one_ray(); carom_world_hit h; uint64_t n; return carom_world_cast_rays_all(b.world, &r, nullptr, &h, 7, 1, &n, e); }},
    {"all rays: count", CAROM_E_NULL_ARGUMENT, 7, [](Bench& b, carom_error* e) { const carom_rays r = one_ray(); return carom_world_cast_rays_all(b.world, &r, nullptr, nullptr, 0, 0, nullptr, e); }},
    {"shapes: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_world_cast_shapes(nullptr, nullptr, 0, nullptr, nullptr, 0, e); }},
    {"shapes: shapes", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return carom_world_cast_shapes(b.world, nullptr, 0, nullptr, nullptr, 0, e); }},
    {"shapes: size", CAROM_E_STRUCT_SIZE, 2, [](Bench& b, carom_error* e) { return ask_shapes(b, [](Bench&, carom_query_shapes& s) { s.struct_size = 1; }, e); }},
    {"shapes: scalar", CAROM_E_UNKNOWN_ENUM, 2, [](Bench& b, carom_error* e) { return ask_shapes(b, [](Bench&, carom_query_shapes& s) { s.scalar = 7; }, e); }},
    {"shapes: positions", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return ask_shapes(b, [](Bench&, carom_query_shapes& s) { s.positions = nullptr; }, e); }},
    {"shapes: motions", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return ask_shapes(b, [](Bench&, carom_query_shapes& s) { s.motions = nullptr; }, e); }},
    {"shapes: motion stride", CAROM_E_BUFFER_TOO_SMALL, 2, [](Bench& b, carom_error* e) { return ask_shapes(b, [](Bench&, carom_query_shapes& s) { s.motion_stride = 8; }, e); }},
    {"shapes: position nan", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return ask_shapes(b, [](Bench&, carom_query_shapes& s) { s.positions = kNan3; }, e); }},
    {"shapes: orientation", CAROM_E_NOT_UNIT, 2, [](Bench& b, carom_error* e) { return ask_shapes(b, [](Bench&, carom_query_shapes& s) { s.orientations = kLong; }, e); }},
    {"shapes: motion inf", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return ask_shapes(b, [](Bench&, carom_query_shapes& s) { s.motions = kInf3; }, e); }},
    {"shapes: half-space", CAROM_E_UNSUPPORTED, 2, [](Bench& b, carom_error* e) { return ask_shapes(b, [](Bench& o, carom_query_shapes& s) { s.shapes = &o.floor; }, e); }},
    {"shapes: want", CAROM_E_UNKNOWN_ENUM, 3, [](Bench& b, carom_error* e) { const carom_query_shapes s = one_point(); carom_world_hit h; return carom_world_cast_shapes(b.world, &s, 9, nullptr, &h, 0, e); }},
    {"shapes: desc", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { auto d = query_desc(); d.iterations = 20000; const carom_query_shapes s = one_point(); carom_world_hit h; return carom_world_cast_shapes(b.world, &s, 0, &d, &h, 0, e); }},
    {"shapes: dst", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { const carom_query_shapes s = one_point(); return carom_world_cast_shapes(b.world, &s, 0, nullptr, nullptr, 0, e); }},
    {"shapes: stride", CAROM_E_BUFFER_TOO_SMALL, 6, [](Bench& b, carom_error* e) { const carom_query_shapes s = one_point(); carom_world_hit h; return carom_world_cast_shapes(b.world, &s, 0, nullptr, &h, 9, e); }},
    {"all shapes: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint64_t n; return carom_world_cast_shapes_all(nullptr, nullptr, nullptr, nullptr, 0, 0, &n, e); }},
    {"all shapes: count", CAROM_E_NULL_ARGUMENT, 7, [](Bench& b, carom_error* e) { const carom_query_shapes s = one_point(); return carom_world_cast_shapes_all(b.world, &s, nullptr, nullptr, 0, 0, nullptr, e); }},
    {"overlap: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint64_t n; return carom_world_overlap_shapes(nullptr, nullptr, nullptr, nullptr, 0, 0, &n, e); }},
    {"overlap: dst", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { const carom_query_shapes s = one_point(); uint64_t n; return carom_world_overlap_shapes(b.world, &s, nullptr, nullptr, 0, 2, &n, e); }},
    {"nearest: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_world_find_nearest(nullptr, nullptr, 1, nullptr, nullptr, 0, e); }},
    {"nearest: reach", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { const carom_query_shapes s = one_point(); carom_world_hit h; return carom_world_find_nearest(b.world, &s, -1, nullptr, &h, 0, e); }},
    {"nearest: reach nan", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { const carom_query_shapes s = one_point(); carom_world_hit h; return carom_world_find_nearest(b.world, &s, kNan, nullptr, &h, 0, e); }},
    {"nearest: dst", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { const carom_query_shapes s = one_point(); return carom_world_find_nearest(b.world, &s, 1, nullptr, nullptr, 0, e); }},
};
// clang-format on

carom_character_desc character_desc() {
  carom_character_desc d;
  carom_character_desc_init(&d, sizeof d);
  return d;
}
carom_character character(const Bench& b) {
  carom_character c;
  carom_character_init(&c, sizeof c);
  c.shape = b.ball;
  c.position[1] = 10;
  return c;
}
int32_t move_character(Bench& b, void (*spoil)(Bench&, carom_character_desc&, carom_character&), carom_error* e) {
  carom_character_desc d = character_desc();
  carom_character c = character(b);
  spoil(b, d, c);
  return carom_character_move(b.world, &d, &c, kOne, 0, 0.01, e);
}
// clang-format off
const Row kCharacters[] = {
    {"character: engine", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { carom_character c = character(b); return carom_character_set_shape(nullptr, b.world, nullptr, &c, b.ball, nullptr, e); }},
    {"character: world", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { carom_character c = character(b); return carom_character_set_shape(b.engine, nullptr, nullptr, &c, b.ball, nullptr, e); }},
    {"character: character", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { return carom_character_set_shape(b.engine, b.world, nullptr, nullptr, b.ball, nullptr, e); }},
    {"character: half-space", CAROM_E_UNSUPPORTED, 5, [](Bench& b, carom_error* e) { carom_character c = character(b); return carom_character_set_shape(b.engine, b.world, nullptr, &c, b.floor, nullptr, e); }},
    {"character: shape", CAROM_E_INVALID_HANDLE, 5, [](Bench& b, carom_error* e) { carom_character c = character(b); return carom_character_set_shape(b.engine, b.world, nullptr, &c, 0, nullptr, e); }},
    {"move: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { carom_character c = character(b); return carom_character_move(nullptr, nullptr, &c, kOne, 0, 0.01, e); }},
    {"move: size", CAROM_E_STRUCT_SIZE, 2, [](Bench& b, carom_error* e) { return move_character(b, [](Bench&, carom_character_desc& d, carom_character&) { d.struct_size = 7; }, e); }},
    {"move: flags", CAROM_E_UNSUPPORTED, 2, [](Bench& b, carom_error* e) { return move_character(b, [](Bench&, carom_character_desc& d, carom_character&) { d.flags = 8; }, e); }},
    {"move: up", CAROM_E_NOT_UNIT, 2, [](Bench& b, carom_error* e) { return move_character(b, [](Bench&, carom_character_desc& d, carom_character&) { d.up[1] = 2; }, e); }},
    {"move: slope", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return move_character(b, [](Bench&, carom_character_desc& d, carom_character&) { d.max_slope = -0.1; }, e); }},
    {"move: skin", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return move_character(b, [](Bench&, carom_character_desc& d, carom_character&) { d.skin = 0; }, e); }},
    {"move: step nan", CAROM_E_NOT_FINITE, 2, [](Bench& b, carom_error* e) { return move_character(b, [](Bench&, carom_character_desc& d, carom_character&) { d.step_up = kNan; }, e); }},
    {"move: body", CAROM_E_WRONG_KIND, 2, [](Bench& b, carom_error* e) { return move_character(b, [](Bench& o, carom_character_desc& d, carom_character&) { d.body = o.colliders[0]; }, e); }},
    {"move: character", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_character_move(b.world, nullptr, nullptr, kOne, 0, 0.01, e); }},
    {"move: no shape", CAROM_E_INVALID_HANDLE, 3, [](Bench& b, carom_error* e) { return move_character(b, [](Bench&, carom_character_desc&, carom_character& c) { c.shape = 0; }, e); }},
    {"move: a body as shape", CAROM_E_WRONG_KIND, 3, [](Bench& b, carom_error* e) { return move_character(b, [](Bench& o, carom_character_desc&, carom_character& c) { c.shape = o.ground; }, e); }},
    {"move: half-space", CAROM_E_UNSUPPORTED, 3, [](Bench& b, carom_error* e) { return move_character(b, [](Bench& o, carom_character_desc&, carom_character& c) { c.shape = o.floor; }, e); }},
    {"move: position nan", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return move_character(b, [](Bench&, carom_character_desc&, carom_character& c) { c.position[2] = kNan; }, e); }},
    {"move: ground", CAROM_E_UNKNOWN_ENUM, 3, [](Bench& b, carom_error* e) { return move_character(b, [](Bench&, carom_character_desc&, carom_character& c) { c.ground = 3; }, e); }},
    {"move: ground body", CAROM_E_WRONG_KIND, 3, [](Bench& b, carom_error* e) { return move_character(b, [](Bench& o, carom_character_desc&, carom_character& c) { c.ground = CAROM_GROUND_FIRM, c.ground_body = o.ball; }, e); }},
    {"move: walk", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { carom_character c = character(b); return carom_character_move(b.world, nullptr, &c, nullptr, 0, 0.01, e); }},
    {"move: walk inf", CAROM_E_NOT_FINITE, 4, [](Bench& b, carom_error* e) { carom_character c = character(b); return carom_character_move(b.world, nullptr, &c, kInf3, 0, 0.01, e); }},
    {"move: jump", CAROM_E_OUT_OF_RANGE, 5, [](Bench& b, carom_error* e) { carom_character c = character(b); return carom_character_move(b.world, nullptr, &c, kOne, -1, 0.01, e); }},
    {"move: dt", CAROM_E_OUT_OF_RANGE, 6, [](Bench& b, carom_error* e) { carom_character c = character(b); return carom_character_move(b.world, nullptr, &c, kOne, 0, 2, e); }},
    {"push: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { const carom_character c = character(b); return carom_character_push(nullptr, nullptr, &c, 0.01, e); }},
    {"push: character", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_character_push(b.world, nullptr, nullptr, 0.01, e); }},
    {"push: contacts", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { carom_character c = character(b); c.contact_count = 9; return carom_character_push(b.world, nullptr, &c, 0.01, e); }},
    {"push: dt", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { const carom_character c = character(b); return carom_character_push(b.world, nullptr, &c, 0, e); }},
    {"move body: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { const carom_character c = character(b); return carom_character_move_body(nullptr, nullptr, &c, 0.01, e); }},
    {"move body: desc", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { const carom_character c = character(b); return carom_character_move_body(b.world, nullptr, &c, 0.01, e); }},
    {"move body: none", CAROM_E_INVALID_HANDLE, 2, [](Bench& b, carom_error* e) { const carom_character c = character(b); const carom_character_desc d = character_desc(); return carom_character_move_body(b.world, &d, &c, 0.01, e); }},
    {"move body: dynamic", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { const carom_character c = character(b); carom_character_desc d = character_desc(); d.body = b.bodies[0]; return carom_character_move_body(b.world, &d, &c, 0.01, e); }},
};
// clang-format on

struct Drive {
  carom_vehicle_desc desc;
  carom_wheel_desc wheel_descs[2];
  carom_vehicle_input input;
  carom_vehicle vehicle;
  carom_wheel wheels[2];
  uint64_t n = 2;
  double dt = 0.01;
};
int32_t drive(Bench& b, void (*spoil)(Bench&, Drive&), carom_error* e) {
  Drive d;
  carom_vehicle_desc_init(&d.desc, sizeof d.desc);
  carom_vehicle_input_init(&d.input, sizeof d.input);
  carom_vehicle_init(&d.vehicle, sizeof d.vehicle);
  for (int i = 0; i < 2; ++i)
    carom_wheel_desc_init(&d.wheel_descs[i], sizeof d.wheel_descs[i]),
        carom_wheel_init(&d.wheels[i], sizeof d.wheels[i]);
  d.desc.chassis = b.bodies[0];
  spoil(b, d);
  return carom_vehicle_drive(b.world, &d.desc, d.wheel_descs, d.n, &d.input, &d.vehicle, d.wheels, d.dt, e);
}
// clang-format off
const Row kVehicles[] = {
    {"drive: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_vehicle_drive(nullptr, nullptr, nullptr, 1, nullptr, nullptr, nullptr, 0.01, e); }},
    {"drive: desc", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { return carom_vehicle_drive(b.world, nullptr, nullptr, 1, nullptr, nullptr, nullptr, 0.01, e); }},
    {"drive: flags", CAROM_E_UNSUPPORTED, 2, [](Bench& b, carom_error* e) { return drive(b, [](Bench&, Drive& d) { d.desc.flags = 4; }, e); }},
    {"drive: chassis", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return drive(b, [](Bench& o, Drive& d) { d.desc.chassis = o.ground; }, e); }},
    {"drive: none", CAROM_E_INVALID_HANDLE, 2, [](Bench& b, carom_error* e) { return drive(b, [](Bench&, Drive& d) { d.desc.chassis = 0; }, e); }},
    {"drive: axes", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return drive(b, [](Bench&, Drive& d) { d.desc.forward[1] = 1, d.desc.forward[2] = 0; }, e); }},
    {"drive: gears", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return drive(b, [](Bench&, Drive& d) { d.desc.gear_count = 9; }, e); }},
    {"drive: curve", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return drive(b, [](Bench&, Drive& d) { d.desc.torque_speeds[2] = d.desc.torque_speeds[1]; }, e); }},
    {"drive: max speed", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return drive(b, [](Bench&, Drive& d) { d.desc.max_speed = 50; }, e); }},
    {"drive: wheel descs", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { carom_vehicle_desc d; carom_vehicle_desc_init(&d, sizeof d); return carom_vehicle_drive(b.world, &d, nullptr, 1, nullptr, nullptr, nullptr, 0.01, e); }},
    {"drive: sizes differ", CAROM_E_STRUCT_SIZE, 3, [](Bench& b, carom_error* e) { return drive(b, [](Bench&, Drive& d) { d.wheel_descs[1].struct_size -= 8; }, e); }},
    {"drive: radius", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { return drive(b, [](Bench&, Drive& d) { d.wheel_descs[1].radius = 0; }, e); }},
    {"drive: stiffness", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return drive(b, [](Bench&, Drive& d) { d.wheel_descs[0].stiffness = kNan; }, e); }},
    {"drive: partner", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { return drive(b, [](Bench&, Drive& d) { d.wheel_descs[0].anti_roll_partner = 2; }, e); }},
    {"drive: wheel's shape", CAROM_E_UNSUPPORTED, 3, [](Bench& b, carom_error* e) { return drive(b, [](Bench& o, Drive& d) { d.wheel_descs[0].shape = o.floor; }, e); }},
    {"drive: n", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { return drive(b, [](Bench&, Drive& d) { d.n = 0; }, e); }},
    {"drive: many", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { return drive(b, [](Bench&, Drive& d) { d.n = 17; }, e); }},
    {"drive: throttle", CAROM_E_OUT_OF_RANGE, 5, [](Bench& b, carom_error* e) { return drive(b, [](Bench&, Drive& d) { d.input.throttle = 1.1; }, e); }},
    {"drive: gear", CAROM_E_OUT_OF_RANGE, 5, [](Bench& b, carom_error* e) { return drive(b, [](Bench&, Drive& d) { d.input.gear = 6; }, e); }},
    {"drive: state", CAROM_E_NOT_FINITE, 6, [](Bench& b, carom_error* e) { return drive(b, [](Bench&, Drive& d) { d.vehicle.engine_speed = kInf; }, e); }},
    {"drive: wheel", CAROM_E_NOT_FINITE, 7, [](Bench& b, carom_error* e) { return drive(b, [](Bench&, Drive& d) { d.wheels[1].spin = kNan; }, e); }},
    {"drive: dt", CAROM_E_OUT_OF_RANGE, 8, [](Bench& b, carom_error* e) { return drive(b, [](Bench&, Drive& d) { d.dt = 0.2; }, e); }},
};
// clang-format on

// clang-format off
const Row kEvents[] = {
    {"gravity factor: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_body_set_gravity_factor(nullptr, b.bodies[0], 1, e); }},
    {"gravity factor: nan", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return carom_body_set_gravity_factor(b.world, b.bodies[0], kNan, e); }},
    {"gravity factor: inf", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return carom_body_set_gravity_factor(b.world, b.bodies[0], -kInf, e); }},
    {"get gravity factor: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { double f; return carom_body_get_gravity_factor(nullptr, b.bodies[0], &f, e); }},
    {"get gravity factor: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_body_get_gravity_factor(b.world, b.bodies[0], nullptr, e); }},
    {"attribute info: unknown", CAROM_E_UNKNOWN_ENUM, 1, [](Bench&, carom_error* e) { carom_attribute_info i = {}; i.struct_size = sizeof i; return carom_attribute_get_info(CAROM_ATTRIBUTE_COUNT, &i, e); }},
    {"attribute info: out", CAROM_E_NULL_ARGUMENT, 2, [](Bench&, carom_error* e) { return carom_attribute_get_info(0, nullptr, e); }},
    {"attribute info: struct_size", CAROM_E_STRUCT_SIZE, 2, [](Bench&, carom_error* e) { carom_attribute_info i = {}; return carom_attribute_get_info(0, &i, e); }},
    {"attribute: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { const double v[4] = {}; return carom_body_set_attribute(nullptr, b.bodies[0], 0, v, e); }},
    {"attribute: unknown", CAROM_E_UNKNOWN_ENUM, 3, [](Bench& b, carom_error* e) { const double v[4] = {}; return carom_body_set_attribute(b.world, b.bodies[0], CAROM_ATTRIBUTE_COUNT, v, e); }},
    {"attribute: value", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { return carom_body_set_attribute(b.world, b.bodies[0], 0, nullptr, e); }},
    {"attribute: nan", CAROM_E_NOT_FINITE, 4, [](Bench& b, carom_error* e) { const double v[4] = {kNan}; return carom_body_set_attribute(b.world, b.bodies[0], 0, v, e); }},
    {"attribute: out of range", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { const double v[4] = {0, -1}; return carom_body_set_attribute(b.world, b.bodies[0], CAROM_ATTRIBUTE_DRAG, v, e); }},
    {"attribute: surplus", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { const double v[4] = {1, 0, 1}; return carom_body_set_attribute(b.world, b.bodies[0], CAROM_ATTRIBUTE_DRAG, v, e); }},
    {"attribute: a fraction", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { const double v[4] = {1.5}; return carom_body_set_attribute(b.world, b.bodies[0], CAROM_ATTRIBUTE_LOCKS, v, e); }},
    {"attribute: static", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { const double v[4] = {1}; return carom_body_set_attribute(b.world, b.ground, CAROM_ATTRIBUTE_LOCKS, v, e); }},
    {"get attribute: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { double v[4]; return carom_body_get_attribute(nullptr, b.bodies[0], 0, v, e); }},
    {"get attribute: unknown", CAROM_E_UNKNOWN_ENUM, 3, [](Bench& b, carom_error* e) { double v[4]; return carom_body_get_attribute(b.world, b.bodies[0], CAROM_ATTRIBUTE_COUNT, v, e); }},
    {"get attribute: out", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { return carom_body_get_attribute(b.world, b.bodies[0], 0, nullptr, e); }},
    {"locks: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_body_set_locks(nullptr, b.bodies[0], 1, e); }},
    {"locks: bits", CAROM_E_UNSUPPORTED, 3, [](Bench& b, carom_error* e) { return carom_body_set_locks(b.world, b.bodies[0], 64, e); }},
    {"locks: static", CAROM_E_OUT_OF_RANGE, 2, [](Bench& b, carom_error* e) { return carom_body_set_locks(b.world, b.ground, 1, e); }},
    {"locks: severity", CAROM_E_UNSUPPORTED, 3, [](Bench& b, carom_error* e) {
       const int32_t r = carom_world_set_dial(b.world, CAROM_DIAL_SOLVER, CAROM_SOLVER_SEVERITY, nullptr);
       const int32_t refused = r ? r : carom_body_set_locks(b.world, b.bodies[0], 1, e);
       carom_world_set_dial(b.world, CAROM_DIAL_SOLVER, CAROM_SOLVER_AUTO, nullptr);
       return refused; }},
    {"get locks: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { uint32_t m; return carom_body_get_locks(nullptr, b.bodies[0], &m, e); }},
    {"get locks: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_body_get_locks(b.world, b.bodies[0], nullptr, e); }},
    {"surface: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_collider_set_surface_velocity(nullptr, b.colliders[0], kZero, kZero, e); }},
    {"surface: linear", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_collider_set_surface_velocity(b.world, b.colliders[0], nullptr, kZero, e); }},
    {"surface: linear nan", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return carom_collider_set_surface_velocity(b.world, b.colliders[0], kNan3, kZero, e); }},
    {"surface: angular", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { return carom_collider_set_surface_velocity(b.world, b.colliders[0], kZero, nullptr, e); }},
    {"surface: angular inf", CAROM_E_NOT_FINITE, 4, [](Bench& b, carom_error* e) { return carom_collider_set_surface_velocity(b.world, b.colliders[0], kZero, kInf3, e); }},
    {"surface: too fast", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { const double v[3] = {0, 1.1e6, 0}; return carom_collider_set_surface_velocity(b.world, b.colliders[0], v, kZero, e); }},
    {"get surface: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { double v[3], w[3]; return carom_collider_get_surface_velocity(nullptr, b.colliders[0], v, w, e); }},
    {"get surface: linear", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { double w[3]; return carom_collider_get_surface_velocity(b.world, b.colliders[0], nullptr, w, e); }},
    {"get surface: angular", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { double v[3]; return carom_collider_get_surface_velocity(b.world, b.colliders[0], v, nullptr, e); }},
    {"filter: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_collider_set_filter(nullptr, b.colliders[0], 1, 1, 0, e); }},
    {"filter: category", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { uint64_t m; int32_t g; return carom_collider_get_filter(b.world, b.colliders[0], nullptr, &m, &g, e); }},
    {"filter: mask", CAROM_E_NULL_ARGUMENT, 4, [](Bench& b, carom_error* e) { uint64_t c; int32_t g; return carom_collider_get_filter(b.world, b.colliders[0], &c, nullptr, &g, e); }},
    {"filter: group", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { uint64_t c, m; return carom_collider_get_filter(b.world, b.colliders[0], &c, &m, nullptr, e); }},
    {"body filter: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_body_set_filter(nullptr, b.bodies[0], 1, 1, 0, e); }},
    {"apart: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_body_ignore_collision(nullptr, b.bodies[0], b.bodies[1], 1, e); }},
    {"apart: itself", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { return carom_body_ignore_collision(b.world, b.bodies[0], b.bodies[0], 1, e); }},
    {"apart: 2", CAROM_E_OUT_OF_RANGE, 4, [](Bench& b, carom_error* e) { return carom_body_ignore_collision(b.world, b.bodies[0], b.bodies[1], 2, e); }},
    {"sensor: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench& b, carom_error* e) { return carom_collider_set_sensor(nullptr, b.colliders[0], 1, e); }},
    {"sensor: 2", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { return carom_collider_set_sensor(b.world, b.colliders[0], 2, e); }},
    {"sensor: out", CAROM_E_NULL_ARGUMENT, 3, [](Bench& b, carom_error* e) { return carom_collider_is_sensor(b.world, b.colliders[0], nullptr, e); }},
    {"events: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { return carom_world_collect_events(nullptr, 0, 0, e); }},
    {"events: kinds", CAROM_E_UNSUPPORTED, 2, [](Bench& b, carom_error* e) { return carom_world_collect_events(b.world, 32, 0, e); }},
    {"events: speed", CAROM_E_OUT_OF_RANGE, 3, [](Bench& b, carom_error* e) { return carom_world_collect_events(b.world, 7, -1, e); }},
    {"events: speed nan", CAROM_E_NOT_FINITE, 3, [](Bench& b, carom_error* e) { return carom_world_collect_events(b.world, 7, kNan, e); }},
    {"joint events: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint64_t n; return carom_world_get_joint_events(nullptr, nullptr, 0, 0, &n, e); }},
    {"joint events: dst", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { uint64_t n; return carom_world_get_joint_events(b.world, nullptr, sizeof(carom_joint_event), 1, &n, e); }},
    {"joint events: stride", CAROM_E_BUFFER_TOO_SMALL, 3, [](Bench& b, carom_error* e) { carom_joint_event v; uint64_t n; return carom_world_get_joint_events(b.world, &v, 3, 1, &n, e); }},
    {"joint events: count", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { return carom_world_get_joint_events(b.world, nullptr, 0, 0, nullptr, e); }},
    {"fault events: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint64_t n; return carom_world_get_fault_events(nullptr, nullptr, 0, 0, &n, e); }},
    {"fault events: dst", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { uint64_t n; return carom_world_get_fault_events(b.world, nullptr, sizeof(carom_fault_event), 1, &n, e); }},
    {"fault events: stride", CAROM_E_BUFFER_TOO_SMALL, 3, [](Bench& b, carom_error* e) { carom_fault_event v; uint64_t n; return carom_world_get_fault_events(b.world, &v, 3, 1, &n, e); }},
    {"fault events: count", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { return carom_world_get_fault_events(b.world, nullptr, 0, 0, nullptr, e); }},
    {"contact events: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint64_t n; return carom_world_get_contact_events(nullptr, nullptr, 0, 0, &n, e); }},
    {"contact events: dst", CAROM_E_NULL_ARGUMENT, 2, [](Bench& b, carom_error* e) { uint64_t n; return carom_world_get_contact_events(b.world, nullptr, 0, 1, &n, e); }},
    {"contact events: stride", CAROM_E_BUFFER_TOO_SMALL, 3, [](Bench& b, carom_error* e) { uint64_t n; carom_contact_event x; return carom_world_get_contact_events(b.world, &x, 4, 1, &n, e); }},
    {"contact events: count", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { return carom_world_get_contact_events(b.world, nullptr, 0, 0, nullptr, e); }},
    {"sensor events: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint64_t n; return carom_world_get_sensor_events(nullptr, nullptr, 0, 0, &n, e); }},
    {"sensor events: count", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { return carom_world_get_sensor_events(b.world, nullptr, 0, 0, nullptr, e); }},
    {"sleep events: world", CAROM_E_NULL_ARGUMENT, 1, [](Bench&, carom_error* e) { uint64_t n; return carom_world_get_sleep_events(nullptr, nullptr, 0, 0, &n, e); }},
    {"sleep events: count", CAROM_E_NULL_ARGUMENT, 5, [](Bench& b, carom_error* e) { return carom_world_get_sleep_events(b.world, nullptr, 0, 0, nullptr, e); }},
};
// clang-format on

template <std::size_t N>
void each_is_refused(const Row (&rows)[N]) {
  Bench b;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  assert_int_equal(bench_particles(&b, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 40, nullptr), CAROM_OK);  // something has touched something
  const Bench before = b;
  const uint64_t hash = bench_hash(b.world);
  for (const Row& row : rows) {
    carom_error e = CAROM_ERROR_INIT;
    const int32_t result = row.call(b, &e);
    if (result != row.code || e.argument != row.argument)
      print_error("%s: %s, argument %d (%s), wanted %s, argument %d\n", row.what, carom_result_name(result), e.argument,
                  e.message, carom_result_name(row.code), row.argument);
    assert_int_equal(result, row.code);
    assert_int_equal(e.code, row.code);
    assert_int_equal(e.argument, row.argument);
    assert_true(std::strlen(e.message) > 8);
    assert_true(std::strlen(e.remedy) > 8);
    assert_int_equal(row.call(b, nullptr), row.code);
    assert_true(bench_hash(b.world) == hash);
    assert_memory_equal(&b, &before, sizeof b);  // nothing written to an output
  }
  // And the world goes on as one that nobody disturbed.
  Bench other;
  assert_int_equal(bench_make(&other, nullptr, nullptr), CAROM_OK);
  assert_int_equal(bench_particles(&other, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(other.world, 80, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 40, nullptr), CAROM_OK);
  assert_true(bench_hash(b.world) == bench_hash(other.world));
  assert_int_equal(bench_free(&other), CAROM_OK);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

void every_wrong_argument_of_engines_and_plugins_is_refused(void**) { each_is_refused(kEngine); }
void every_wrong_argument_of_shapes_is_refused(void**) { each_is_refused(kShape); }
void every_wrong_argument_of_worlds_and_dials_is_refused(void**) { each_is_refused(kWorld); }
void every_wrong_argument_of_bodies_is_refused(void**) { each_is_refused(kBody); }
void every_wrong_argument_of_materials_and_colliders_is_refused(void**) { each_is_refused(kCollider); }
void every_wrong_argument_of_bulk_calls_is_refused(void**) { each_is_refused(kBulk); }
void every_wrong_argument_of_queries_is_refused(void**) { each_is_refused(kQuery); }
void every_wrong_argument_of_casts_is_refused(void**) { each_is_refused(kCast); }
void every_wrong_argument_of_particles_is_refused(void**) { each_is_refused(kParticles); }
void every_wrong_argument_of_world_queries_is_refused(void**) { each_is_refused(kWorldQuery); }
void every_wrong_argument_of_filters_and_events_is_refused(void**) { each_is_refused(kEvents); }
void every_wrong_argument_of_characters_is_refused(void**) { each_is_refused(kCharacters); }
void every_wrong_argument_of_vehicles_is_refused(void**) { each_is_refused(kVehicles); }

void every_result_has_its_own_name_and_a_remedy(void**) {
  std::set<std::string> names;
  for (int32_t code = CAROM_E_READ_ONLY; code <= CAROM_OK; ++code) {
    const std::string name = carom_result_name(code);
    assert_true(name.rfind("CAROM_", 0) == 0 && name != "CAROM_E_?");
    assert_true(names.insert(name).second);
    assert_true(std::strlen(carom_result_remedy(code)) > 8);
  }
  for (int32_t code : {1, CAROM_E_READ_ONLY - 1, INT32_MAX, INT32_MIN}) {
    assert_string_equal(carom_result_name(code), "CAROM_E_?");
    assert_non_null(carom_result_remedy(code));
  }
}

void calls_without_an_error_object_refuse_null_too(void**) {
  uint32_t v;
  assert_int_equal(carom_version(nullptr, &v, &v), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_version(&v, nullptr, &v), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_version(&v, &v, nullptr), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_engine_desc_init(nullptr, sizeof(carom_engine_desc)), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_world_desc_init(nullptr, sizeof(carom_world_desc)), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_material_desc_init(nullptr, sizeof(carom_material_desc)), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_body_desc_init(nullptr, sizeof(carom_body_desc)), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_collider_desc_init(nullptr, sizeof(carom_collider_desc)), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_distance_desc_init(nullptr, sizeof(carom_distance_desc)), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_cast_desc_init(nullptr, sizeof(carom_cast_desc)), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_motion_init(nullptr, sizeof(carom_motion)), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_particles_desc_init(nullptr, sizeof(carom_particles_desc)), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_query_desc_init(nullptr, sizeof(carom_query_desc)), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_dial_get_count(nullptr), CAROM_E_NULL_ARGUMENT);
  assert_int_equal(carom_constant_get_count(nullptr), CAROM_E_NULL_ARGUMENT);
}

void a_flat_shape_on_a_body_without_mass_has_no_volume(void**) {
  Bench b;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  const double tile[3] = {1, 0, 1};
  carom_shape flat;
  assert_int_equal(carom_shape_create(b.engine, b.box, tile, 3, &flat, nullptr), CAROM_OK);
  carom_collider_desc d = collider_desc(b);
  d.shape = flat;
  carom_error e = CAROM_ERROR_INIT;
  assert_int_equal(create_collider(b, d, &e), CAROM_E_NO_VOLUME);
  assert_int_equal(e.argument, 3);
  d.density = 0;
  assert_int_equal(create_collider(b, d, nullptr), CAROM_OK);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

void an_error_object_that_is_none_is_refused_and_left_alone(void**) {
  carom_error e = CAROM_ERROR_INIT;
  e.struct_size = 4;
  e.code = 77;
  carom_engine* engine = nullptr;
  assert_int_equal(carom_engine_create(nullptr, &engine, &e), CAROM_E_STRUCT_SIZE);
  assert_null(engine);
  assert_int_equal(e.code, 77);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(every_wrong_argument_of_engines_and_plugins_is_refused),
      cmocka_unit_test(every_wrong_argument_of_shapes_is_refused),
      cmocka_unit_test(every_wrong_argument_of_worlds_and_dials_is_refused),
      cmocka_unit_test(every_wrong_argument_of_bodies_is_refused),
      cmocka_unit_test(every_wrong_argument_of_materials_and_colliders_is_refused),
      cmocka_unit_test(every_wrong_argument_of_bulk_calls_is_refused),
      cmocka_unit_test(every_wrong_argument_of_queries_is_refused),
      cmocka_unit_test(every_wrong_argument_of_casts_is_refused),
      cmocka_unit_test(every_wrong_argument_of_particles_is_refused),
      cmocka_unit_test(every_wrong_argument_of_world_queries_is_refused),
      cmocka_unit_test(every_wrong_argument_of_filters_and_events_is_refused),
      cmocka_unit_test(every_wrong_argument_of_characters_is_refused),
      cmocka_unit_test(every_wrong_argument_of_vehicles_is_refused),
      cmocka_unit_test(every_result_has_its_own_name_and_a_remedy),
      cmocka_unit_test(calls_without_an_error_object_refuse_null_too),
      cmocka_unit_test(a_flat_shape_on_a_body_without_mass_has_no_volume),
      cmocka_unit_test(an_error_object_that_is_none_is_refused_and_left_alone),
  };
  return cmocka_run_group_tests_name("abi/errors", tests, nullptr, nullptr);
}
