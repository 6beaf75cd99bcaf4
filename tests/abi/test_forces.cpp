// Drag, wind, force fields, springs, water, and the plan of effects, as a host sets and reads them: what it was told is
// what they are, what is refused changes nothing, and running out of memory is an error and no more.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <vector>

#include "bench.h"
#include "carom_test.h"

namespace {

const double kNan = NAN, kInf = INFINITY, kZero[3] = {0, 0, 0}, kUp[3] = {0, 1, 0};

carom_force_field_desc vortex() {
  carom_force_field_desc d;
  carom_force_field_desc_init(&d, sizeof d);
  d.kind = CAROM_FORCE_FIELD_VORTEX;
  d.position[0] = 1, d.half[1] = 20, d.strength = 3, d.pull = 1, d.lift = 0.5, d.reach = 30, d.core = 0.1,
  d.falloff = 1;
  d.user = 42;
  return d;
}

carom_spring_desc tie(const Bench& b) {
  carom_spring_desc d;
  carom_spring_desc_init(&d, sizeof d);
  d.body_a = b.bodies[0], d.body_b = b.bodies[2];
  d.anchor_a[1] = 0.25, d.rest = 1.5, d.stiffness = 200, d.damping = 3, d.only_pulls = 1, d.user = 43;
  return d;
}

carom_water lake() {
  carom_water w;
  carom_water_init(&w, sizeof w);
  w.level = 0.75, w.density = 1025, w.current[2] = 0.5, w.drag = 2;
  return w;
}

/// All of it. @return the first failure
int32_t enrich(Bench& b, carom_force_field* field, carom_spring* spring, carom_error* e) {
  const double wind[3] = {4, 0, 1};
  const carom_force_field_desc f = vortex();
  const carom_spring_desc s = tie(b);
  const carom_water w = lake();
  int32_t r = carom_body_set_drag(b.world, b.bodies[1], 0.1, 0.2, e);
  if (!r) r = carom_world_set_wind(b.world, wind, e);
  if (!r) r = carom_force_field_create(b.world, &f, field, e);
  if (!r) r = carom_body_set_force_field_mask(b.world, b.bodies[0], 6, e);
  if (!r) r = carom_spring_create(b.world, &s, spring, e);
  if (!r) r = carom_world_set_water(b.world, &w, e);
  if (!r) r = carom_body_set_effect(b.world, b.bodies[3], CAROM_EFFECT_GRAVITY, CAROM_MODE_FORBID, e);
  if (!r) r = carom_world_set_effect(b.world, CAROM_EFFECT_FRICTION, CAROM_MODE_FORBID, e);
  if (!r) r = carom_body_add_force_at(b.world, b.bodies[2], kUp, kZero, e);
  return r;
}

std::map<uint32_t, carom_plan_line> plan_of(carom_world* world) {
  uint64_t count = 0;
  assert_int_equal(carom_world_get_plan(world, nullptr, 0, 0, &count, nullptr), CAROM_OK);
  assert_int_equal(count, CAROM_STAGE_COUNT + CAROM_EFFECT_COUNT);
  std::vector<carom_plan_line> lines(count);
  assert_int_equal(carom_world_get_plan(world, lines.data(), sizeof lines[0], count, &count, nullptr), CAROM_OK);
  std::map<uint32_t, carom_plan_line> effects;
  for (const carom_plan_line& line : lines) {
    assert_true(std::strlen(line.name) > 2 && std::strlen(line.reason) > 4);
    if (line.effect == CAROM_PLAN_NO_EFFECT) {
      assert_string_equal(line.name, carom_stage_name(line.stage));
      continue;
    }
    assert_string_equal(line.name, carom_effect_name(line.effect));
    effects[line.effect] = line;
  }
  assert_int_equal(effects.size(), CAROM_EFFECT_COUNT);
  return effects;
}

}  // namespace

static void they_are_what_they_were_set_to(void**) {
  Bench b;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  carom_force_field field = 0;
  carom_spring spring = 0;
  double linear = 9, quadratic = 9, v[3];
  uint32_t mask = 0, there = 9, mode = 9;
  carom_water w = {};
  w.struct_size = sizeof w;
  assert_int_equal(carom_body_get_drag(b.world, b.bodies[1], &linear, &quadratic, nullptr), CAROM_OK);
  assert_int_equal(carom_body_get_force_field_mask(b.world, b.bodies[0], &mask, nullptr), CAROM_OK);
  assert_int_equal(carom_world_get_water(b.world, &w, &there, nullptr), CAROM_OK);
  assert_int_equal(carom_world_get_wind(b.world, v, nullptr), CAROM_OK);
  assert_true(linear == 0 && quadratic == 0 && mask == 1 && there == 0 && w.density == 1000 && w.normal[1] == 1 &&
              v[0] == 0);
  assert_int_equal(enrich(b, &field, &spring, nullptr), CAROM_OK);
  assert_int_equal(carom_body_get_drag(b.world, b.bodies[1], &linear, &quadratic, nullptr), CAROM_OK);
  assert_int_equal(carom_body_get_force_field_mask(b.world, b.bodies[0], &mask, nullptr), CAROM_OK);
  assert_int_equal(carom_world_get_water(b.world, &w, &there, nullptr), CAROM_OK);
  assert_int_equal(carom_world_get_wind(b.world, v, nullptr), CAROM_OK);
  assert_true(linear == 0.1 && quadratic == 0.2 && mask == 6 && there == 1 && v[0] == 4 && v[2] == 1);
  const carom_water want_w = lake();
  assert_memory_equal(&w, &want_w, sizeof w);
  carom_force_field_desc f = {};
  f.struct_size = sizeof f;
  assert_int_equal(carom_force_field_get(b.world, field, &f, nullptr), CAROM_OK);
  const carom_force_field_desc want_f = vortex();
  assert_memory_equal(&f, &want_f, sizeof f);
  carom_spring_desc s = {};
  s.struct_size = sizeof s;
  assert_int_equal(carom_spring_get(b.world, spring, &s, nullptr), CAROM_OK);
  const carom_spring_desc want_s = tie(b);
  assert_memory_equal(&s, &want_s, sizeof s);
  assert_int_equal(carom_body_get_effect(b.world, b.bodies[3], CAROM_EFFECT_GRAVITY, &mode, nullptr), CAROM_OK);
  assert_int_equal(mode, CAROM_MODE_FORBID);
  assert_int_equal(carom_world_get_effect(b.world, CAROM_EFFECT_FRICTION, &mode, nullptr), CAROM_OK);
  assert_int_equal(mode, CAROM_MODE_FORBID);
  assert_int_equal(carom_world_get_effect(b.world, CAROM_EFFECT_GRAVITY, &mode, nullptr), CAROM_OK);
  assert_int_equal(mode, CAROM_MODE_AS_NEEDED);

  // (0, 1.25, 0) to (1.5, 2, 0.25): sqrt(1.5^2 + 0.75^2 + 0.25^2), at rest.
  double length = 0, force = 0;
  assert_int_equal(carom_spring_get_state(b.world, spring, &length, &force, nullptr), CAROM_OK);
  assert_true(std::fabs(length - std::sqrt(2.875)) < 1e-15 && std::fabs(force - 200 * (length - 1.5)) < 1e-12);
  assert_int_equal(carom_spring_update(b.world, spring, 1, 10, 0, nullptr), CAROM_OK);
  assert_int_equal(carom_spring_get_state(b.world, spring, &length, &force, nullptr), CAROM_OK);
  assert_true(std::fabs(force - 10 * (length - 1)) < 1e-13);
  assert_int_equal(carom_force_field_update(b.world, field, &want_f, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 60, nullptr), CAROM_OK);
  assert_int_equal(carom_force_field_destroy(b.world, field, nullptr), CAROM_OK);
  assert_int_equal(carom_spring_destroy(b.world, spring, nullptr), CAROM_OK);
  assert_int_equal(carom_force_field_get(b.world, field, &f, nullptr), CAROM_E_STALE_HANDLE);
  assert_int_equal(carom_spring_get(b.world, spring, &s, nullptr), CAROM_E_STALE_HANDLE);
  assert_int_equal(carom_world_set_water(b.world, nullptr, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 5, nullptr), CAROM_OK);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/* A force at a point is the force and its torque. */
static void a_force_at_a_point_turns(void**) {
  uint64_t hash[2];
  for (int i = 0; i < 2; ++i) {
    Bench b;
    assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
    // Body 3 stands at (2.25, 2.5, 0.375).
    const double force[3] = {5, 0, 2}, point[3] = {2.25, 3, 0.375}, torque[3] = {1, 0, -2.5};
    assert_int_equal(i ? carom_body_add_force_at(b.world, b.bodies[3], force, point, nullptr)
                       : carom_body_add_force(b.world, b.bodies[3], force, torque, nullptr),
                     CAROM_OK);
    assert_int_equal(bench_steps(b.world, 5, nullptr), CAROM_OK);
    hash[i] = bench_hash(b.world);
    assert_int_equal(bench_free(&b), CAROM_OK);
  }
  assert_true(hash[0] == hash[1]);
}

/// A sum that overflows is refused and changes nothing: the body stands, may be saved, and comes back.
static void sums_that_overflow_are_refused(void**) {
  Bench b;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  const double most[3] = {0, 0, 1.7e308}, zero[3] = {0, 0, 0}, one[3] = {1, 0, 0}, far[3] = {0, 1e300, 0};
  carom_world* w = b.world;
  const carom_body body = b.bodies[3];
  assert_int_equal(carom_body_add_force(w, body, most, zero, nullptr), CAROM_OK);
  const std::uint64_t before = bench_hash(w);
  carom_error error = CAROM_ERROR_INIT;
  assert_int_equal(carom_body_add_force(w, body, most, zero, &error), CAROM_E_OUT_OF_RANGE);
  assert_true(std::strstr(error.message, "overflow") && error.argument == 3);
  assert_int_equal(carom_body_add_force_at(w, body, most, one, &error), CAROM_E_OUT_OF_RANGE);
  const double less[3] = {0, 0, -1e300};
  assert_int_equal(carom_body_add_force_at(w, body, less, far, &error), CAROM_E_OUT_OF_RANGE);  // the torque
  assert_int_equal(carom_body_add_impulse(w, body, most, far, &error), CAROM_E_OUT_OF_RANGE);
  assert_true(bench_hash(w) == before);
  const double back[3] = {0, 0, -1.7e308};
  assert_int_equal(carom_body_add_force(w, body, back, zero, nullptr), CAROM_OK);  // the sum is 0 again
  assert_int_equal(bench_steps(w, 5, nullptr), CAROM_OK);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void the_plan_tells_what_ran_and_what_did_not(void**) {
  Bench b;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  for (auto& [effect, line] : plan_of(b.world)) {
    assert_int_equal(line.runs, 0);
    assert_string_equal(line.reason, "no step yet");
  }
  carom_force_field field;
  carom_spring spring;
  assert_int_equal(enrich(b, &field, &spring, nullptr), CAROM_OK);
  assert_int_equal(carom_world_time_effects(b.world, 1, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 1, nullptr), CAROM_OK);
  auto plan = plan_of(b.world);
  assert_int_equal(plan[CAROM_EFFECT_GRAVITY].participants, BENCH_BODIES - 1);
  assert_int_equal(plan[CAROM_EFFECT_GRAVITY].wanted, BENCH_BODIES);
  assert_non_null(std::strstr(plan[CAROM_EFFECT_GRAVITY].reason, "3 of 4"));
  assert_int_equal(plan[CAROM_EFFECT_USER_FORCE].participants, 1);
  assert_int_equal(plan[CAROM_EFFECT_DRAG].participants, 1);
  assert_int_equal(plan[CAROM_EFFECT_WIND].participants, 1);
  assert_int_equal(plan[CAROM_EFFECT_FIELDS].participants, 3);  // the first has another mask
  assert_int_equal(plan[CAROM_EFFECT_SPRINGS].participants, 1);
  assert_int_equal(plan[CAROM_EFFECT_BUOYANCY].participants, 3);  // one ball is more than its width above the water
  assert_int_equal(plan[CAROM_EFFECT_FRICTION].runs, 0);
  assert_non_null(std::strstr(plan[CAROM_EFFECT_FRICTION].reason, "forbidden"));
  assert_int_equal(plan[CAROM_EFFECT_JOINTS].runs, 0);
  assert_non_null(std::strstr(plan[CAROM_EFFECT_JOINTS].reason, "no joint"));
  for (const uint32_t timed : {CAROM_EFFECT_GRAVITY, CAROM_EFFECT_DRAG, CAROM_EFFECT_SPRINGS})
    assert_true(plan[timed].timing == CAROM_TIME_OWN && plan[timed].seconds > 0 && plan[timed].evaluations > 0 &&
                plan[timed].bytes > 0);
  assert_int_equal(plan[CAROM_EFFECT_RESPONSE].timing, CAROM_TIME_IN_STAGE);
  assert_int_equal(carom_world_time_effects(b.world, 0, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 1, nullptr), CAROM_OK);
  plan = plan_of(b.world);
  assert_int_equal(plan[CAROM_EFFECT_GRAVITY].timing, CAROM_TIME_OFF);
  assert_int_equal(plan[CAROM_EFFECT_USER_FORCE].runs, 0);
  assert_true(carom_effect_name(CAROM_EFFECT_COUNT)[0] == '?');
  assert_int_equal(bench_free(&b), CAROM_OK);
}

static void what_is_refused_changes_nothing(void**) {
  Bench b, other;
  assert_int_equal(bench_make(&b, nullptr, nullptr), CAROM_OK);
  assert_int_equal(bench_make(&other, nullptr, nullptr), CAROM_OK);
  carom_force_field field = 0, made = 0, stale = 0;
  carom_spring spring = 0, foreign = 0;
  assert_int_equal(enrich(b, &field, &spring, nullptr), CAROM_OK);
  carom_force_field unused = 0;
  assert_int_equal(enrich(other, &unused, &foreign, nullptr), CAROM_OK);
  const carom_force_field_desc f = vortex();
  assert_int_equal(carom_force_field_create(b.world, &f, &stale, nullptr), CAROM_OK);
  assert_int_equal(carom_force_field_destroy(b.world, stale, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 40, nullptr), CAROM_OK);
  const uint64_t hash = bench_hash(b.world);
  carom_error e = CAROM_ERROR_INIT;
  const auto refused = [&](int32_t result, int32_t code, int argument) {
    if (result != code || e.argument != argument)
      print_error("%s argument %d (%s), wanted %s argument %d\n", carom_result_name(result), e.argument, e.message,
                  carom_result_name(code), argument);
    assert_int_equal(result, code);
    assert_int_equal(e.argument, argument);
    assert_true(std::strlen(e.message) > 8 && std::strlen(carom_result_remedy(code)) > 8);
    assert_true(bench_hash(b.world) == hash);
    e = CAROM_ERROR_INIT;
  };
  carom_world* w = b.world;
  const carom_body body = b.bodies[0];
  const double nan3[3] = {0, kNan, 0}, far3[3] = {0, 0, 2e6};
  double x, y;
  uint32_t u;
  refused(carom_body_add_force_at(w, body, nan3, kZero, &e), CAROM_E_NOT_FINITE, 3);
  refused(carom_body_add_force_at(w, body, kZero, nan3, &e), CAROM_E_NOT_FINITE, 4);
  refused(carom_body_add_force_at(w, body, nullptr, kZero, &e), CAROM_E_NULL_ARGUMENT, 3);
  refused(carom_body_add_force_at(w, spring, kUp, kZero, &e), CAROM_E_WRONG_KIND, 2);
  refused(carom_body_set_drag(w, body, -1, 0, &e), CAROM_E_OUT_OF_RANGE, 3);
  refused(carom_body_set_drag(w, body, kNan, 0, &e), CAROM_E_NOT_FINITE, 3);
  refused(carom_body_set_drag(w, body, 0, kInf, &e), CAROM_E_NOT_FINITE, 4);
  refused(carom_body_set_drag(w, b.ground_collider, 0, 0, &e), CAROM_E_WRONG_KIND, 2);
  refused(carom_body_get_drag(w, body, nullptr, &y, &e), CAROM_E_NULL_ARGUMENT, 3);
  refused(carom_body_get_drag(w, body, &x, nullptr, &e), CAROM_E_NULL_ARGUMENT, 4);
  refused(carom_world_set_wind(w, nan3, &e), CAROM_E_NOT_FINITE, 2);
  refused(carom_world_set_wind(w, far3, &e), CAROM_E_OUT_OF_RANGE, 2);
  refused(carom_world_set_wind(w, nullptr, &e), CAROM_E_NULL_ARGUMENT, 2);
  refused(carom_world_set_wind(nullptr, kUp, &e), CAROM_E_NULL_ARGUMENT, 1);
  refused(carom_world_get_wind(w, nullptr, &e), CAROM_E_NULL_ARGUMENT, 2);

  const auto bad_field = [&](int32_t code, auto&& change) {
    carom_force_field_desc d = vortex();
    change(d);
    refused(carom_force_field_create(w, &d, &made, &e), code, 2);
    e.argument = 0;
    assert_int_equal(carom_force_field_update(w, field, &d, &e), code);
    assert_int_equal(made, 0);
  };
  bad_field(CAROM_E_STRUCT_SIZE, [](auto& d) { d.struct_size = 3; });
  bad_field(CAROM_E_UNKNOWN_ENUM, [](auto& d) { d.kind = CAROM_FORCE_FIELD_COUNT; });
  bad_field(CAROM_E_UNSUPPORTED, [](auto& d) { d.is_force = 2; });
  bad_field(CAROM_E_UNSUPPORTED, [](auto& d) { d.reserved = 1; });
  bad_field(CAROM_E_NOT_FINITE, [](auto& d) { d.position[2] = NAN; });
  bad_field(CAROM_E_OUT_OF_RANGE, [](auto& d) { d.position[2] = 1e300; });
  bad_field(CAROM_E_NOT_UNIT, [](auto& d) { d.orientation[3] = 0.5; });
  bad_field(CAROM_E_OUT_OF_RANGE, [](auto& d) { d.half[0] = 0; });
  bad_field(CAROM_E_NOT_FINITE, [](auto& d) { d.half[1] = NAN; });
  bad_field(CAROM_E_NOT_FINITE, [](auto& d) { d.vector[0] = INFINITY; });
  bad_field(CAROM_E_NOT_FINITE, [](auto& d) { d.strength = NAN; });
  bad_field(CAROM_E_OUT_OF_RANGE, [](auto& d) { d.pull = 1e31; });
  bad_field(CAROM_E_NOT_FINITE, [](auto& d) { d.lift = INFINITY; });
  bad_field(CAROM_E_OUT_OF_RANGE, [](auto& d) { d.reference = 0; });
  bad_field(CAROM_E_OUT_OF_RANGE, [](auto& d) { d.core = -1; });
  bad_field(CAROM_E_OUT_OF_RANGE, [](auto& d) { d.reach = 0; });
  bad_field(CAROM_E_OUT_OF_RANGE, [](auto& d) { d.falloff = 9; });
  refused(carom_force_field_create(w, nullptr, &made, &e), CAROM_E_NULL_ARGUMENT, 2);
  refused(carom_force_field_create(w, &f, nullptr, &e), CAROM_E_NULL_ARGUMENT, 3);
  refused(carom_force_field_update(w, stale, &f, &e), CAROM_E_STALE_HANDLE, 2);
  refused(carom_force_field_destroy(w, stale, &e), CAROM_E_STALE_HANDLE, 2);
  refused(carom_force_field_destroy(w, spring, &e), CAROM_E_WRONG_KIND, 2);
  refused(carom_force_field_get(w, field, nullptr, &e), CAROM_E_NULL_ARGUMENT, 3);
  refused(carom_body_set_force_field_mask(w, field, 1, &e), CAROM_E_WRONG_KIND, 2);
  refused(carom_body_get_force_field_mask(w, body, nullptr, &e), CAROM_E_NULL_ARGUMENT, 3);

  const auto bad_spring = [&](int32_t code, auto&& change) {
    carom_spring_desc d = tie(b);
    change(d);
    refused(carom_spring_create(w, &d, &made, &e), code, 2);
    assert_int_equal(made, 0);
  };
  bad_spring(CAROM_E_STRUCT_SIZE, [](auto& d) { d.struct_size = 3; });
  bad_spring(CAROM_E_UNSUPPORTED, [](auto& d) { d.only_pulls = 2; });
  bad_spring(CAROM_E_WRONG_KIND, [&](auto& d) { d.body_a = b.colliders[0]; });
  bad_spring(CAROM_E_WRONG_WORLD, [&](auto& d) { d.body_b = other.bodies[0]; });
  bad_spring(CAROM_E_OUT_OF_RANGE, [](auto& d) { d.body_a = d.body_b; });
  bad_spring(CAROM_E_OUT_OF_RANGE, [](auto& d) { d.body_a = d.body_b = CAROM_NULL_HANDLE; });
  bad_spring(CAROM_E_OUT_OF_RANGE, [&](auto& d) { d.body_a = b.ground, d.body_b = CAROM_NULL_HANDLE; });
  bad_spring(CAROM_E_NOT_FINITE, [](auto& d) { d.anchor_b[1] = NAN; });
  bad_spring(CAROM_E_OUT_OF_RANGE, [](auto& d) { d.rest = -1; });
  bad_spring(CAROM_E_NOT_FINITE, [](auto& d) { d.stiffness = INFINITY; });
  bad_spring(CAROM_E_OUT_OF_RANGE, [](auto& d) { d.damping = -1; });
  const carom_spring_desc s = tie(b);
  refused(carom_spring_create(w, &s, nullptr, &e), CAROM_E_NULL_ARGUMENT, 3);
  refused(carom_spring_update(w, spring, -1, 1, 1, &e), CAROM_E_OUT_OF_RANGE, 3);
  refused(carom_spring_update(w, spring, 1, kNan, 1, &e), CAROM_E_NOT_FINITE, 4);
  refused(carom_spring_update(w, spring, 1, 1, -1, &e), CAROM_E_OUT_OF_RANGE, 5);
  refused(carom_spring_update(w, foreign, 1, 1, 1, &e), CAROM_E_WRONG_WORLD, 2);
  refused(carom_spring_get(w, spring, nullptr, &e), CAROM_E_NULL_ARGUMENT, 3);
  refused(carom_spring_get_state(w, spring, nullptr, &y, &e), CAROM_E_NULL_ARGUMENT, 3);
  refused(carom_spring_get_state(w, spring, &x, nullptr, &e), CAROM_E_NULL_ARGUMENT, 4);
  refused(carom_spring_destroy(w, field, &e), CAROM_E_WRONG_KIND, 2);
  refused(carom_spring_destroy(w, 0, &e), CAROM_E_INVALID_HANDLE, 2);

  const auto bad_water = [&](int32_t code, auto&& change) {
    carom_water d = lake();
    change(d);
    refused(carom_world_set_water(w, &d, &e), code, 2);
  };
  bad_water(CAROM_E_STRUCT_SIZE, [](auto& d) { d.struct_size = 3; });
  bad_water(CAROM_E_UNSUPPORTED, [](auto& d) { d.reserved = 3; });
  bad_water(CAROM_E_NOT_UNIT, [](auto& d) { d.normal[0] = 1; });
  bad_water(CAROM_E_NOT_FINITE, [](auto& d) { d.level = NAN; });
  bad_water(CAROM_E_OUT_OF_RANGE, [](auto& d) { d.density = 0; });
  bad_water(CAROM_E_OUT_OF_RANGE, [](auto& d) { d.density = 1e10; });
  bad_water(CAROM_E_NOT_FINITE, [](auto& d) { d.current[1] = NAN; });
  bad_water(CAROM_E_OUT_OF_RANGE, [](auto& d) { d.drag = -1; });
  carom_water water = lake();
  refused(carom_world_get_water(w, nullptr, &u, &e), CAROM_E_NULL_ARGUMENT, 2);
  refused(carom_world_get_water(w, &water, nullptr, &e), CAROM_E_NULL_ARGUMENT, 3);

  refused(carom_world_set_effect(w, CAROM_EFFECT_COUNT, 0, &e), CAROM_E_UNKNOWN_ENUM, 2);
  refused(carom_world_set_effect(w, 0, 3, &e), CAROM_E_UNKNOWN_ENUM, 3);
  refused(carom_world_get_effect(w, 0, nullptr, &e), CAROM_E_NULL_ARGUMENT, 3);
  refused(carom_world_get_effect(w, CAROM_EFFECT_COUNT, &u, &e), CAROM_E_UNKNOWN_ENUM, 2);
  refused(carom_body_set_effect(w, spring, 0, 0, &e), CAROM_E_WRONG_KIND, 2);
  refused(carom_body_set_effect(w, body, CAROM_EFFECT_COUNT, 0, &e), CAROM_E_UNKNOWN_ENUM, 3);
  refused(carom_body_set_effect(w, body, CAROM_EFFECT_PARTICLES, 1, &e), CAROM_E_UNSUPPORTED, 3);
  refused(carom_body_set_effect(w, body, CAROM_EFFECT_EVENTS, 1, &e), CAROM_E_UNSUPPORTED, 3);
  refused(carom_body_set_effect(w, body, 0, 3, &e), CAROM_E_UNKNOWN_ENUM, 4);
  refused(carom_body_get_effect(w, body, 0, nullptr, &e), CAROM_E_NULL_ARGUMENT, 4);
  refused(carom_world_time_effects(w, 2, &e), CAROM_E_OUT_OF_RANGE, 2);
  uint64_t n;
  carom_plan_line line;
  refused(carom_world_get_plan(w, &line, sizeof line, 1, nullptr, &e), CAROM_E_NULL_ARGUMENT, 5);
  refused(carom_world_get_plan(w, nullptr, sizeof line, 1, &n, &e), CAROM_E_NULL_ARGUMENT, 2);
  refused(carom_world_get_plan(w, &line, 4, 1, &n, &e), CAROM_E_BUFFER_TOO_SMALL, 3);
  assert_int_equal(bench_steps(b.world, 5, nullptr), CAROM_OK);
  assert_int_equal(bench_free(&other), CAROM_OK);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

/// A host's memory that ends at an allocation, and does not forget what it gave.
struct Purse {
  uint64_t asked = 0, ends_at = ~uint64_t(0), out = 0;
  carom_engine_desc desc() {
    carom_engine_desc d;
    carom_engine_desc_init(&d, sizeof d);
    d.alloc_user = this;
    d.alloc = [](void* user, uint64_t size, uint64_t alignment) -> void* {
      Purse& p = *static_cast<Purse*>(user);
      if (p.asked++ >= p.ends_at) return nullptr;
      ++p.out;
      return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment + (size ? 0 : alignment));
    };
    d.free = [](void* user, void* memory, uint64_t, uint64_t) {
      --static_cast<Purse*>(user)->out;
      std::free(memory);
    };
    return d;
  }
};

static void running_out_anywhere_is_an_error_and_no_more(void**) {
  uint64_t truth = 0;
  for (uint64_t k = 0; truth == 0; ++k) {
    Purse purse;
    const carom_engine_desc desc = purse.desc();
    Bench b;
    assert_int_equal(bench_make(&b, &desc, nullptr), CAROM_OK);
    assert_int_equal(bench_steps(b.world, 3, nullptr), CAROM_OK);
    double before[BENCH_BODIES][7], after[BENCH_BODIES][7];
    const auto read = [&](double to[BENCH_BODIES][7]) {
      assert_int_equal(
          carom_world_read(b.world, CAROM_FIELD_POSE, CAROM_SCALAR_F64, b.bodies, BENCH_BODIES, to, 0, nullptr),
          CAROM_OK);
    };
    read(before);
    carom_force_field field = 0;
    carom_spring spring = 0;
    purse.ends_at = purse.asked + k;
    int32_t r = enrich(b, &field, &spring, nullptr);
    if (r == CAROM_OK) r = carom_world_step(b.world, 1.0 / 64, nullptr);
    purse.ends_at = ~uint64_t(0);
    if (r != CAROM_OK) {
      assert_int_equal(r, CAROM_E_OUT_OF_MEMORY);
      read(after);
      assert_memory_equal(before, after, sizeof before);  // nobody has moved
    } else {
      truth = bench_hash(b.world);
      assert_true(k > 10);
    }
    assert_int_equal(bench_steps(b.world, 30, nullptr), CAROM_OK);
    assert_int_equal(bench_free(&b), CAROM_OK);
    assert_int_equal(purse.out, 0);
  }
}

static void steps_with_all_of_them_allocate_nothing_in_the_end(void**) {
  Purse purse;
  const carom_engine_desc desc = purse.desc();
  Bench b;
  assert_int_equal(bench_make(&b, &desc, nullptr), CAROM_OK);
  carom_force_field field;
  carom_spring spring;
  assert_int_equal(enrich(b, &field, &spring, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(b.world, 600, nullptr), CAROM_OK);
  const uint64_t before = purse.asked;
  assert_int_equal(bench_steps(b.world, 200, nullptr), CAROM_OK);
  assert_int_equal(purse.asked - before, 0);
  assert_int_equal(bench_free(&b), CAROM_OK);
}

int main(void) {
  const CMUnitTest tests[] = {
      cmocka_unit_test(they_are_what_they_were_set_to),
      cmocka_unit_test(a_force_at_a_point_turns),
      cmocka_unit_test(sums_that_overflow_are_refused),
      cmocka_unit_test(the_plan_tells_what_ran_and_what_did_not),
      cmocka_unit_test(what_is_refused_changes_nothing),
      cmocka_unit_test(running_out_anywhere_is_an_error_and_no_more),
      cmocka_unit_test(steps_with_all_of_them_allocate_nothing_in_the_end),
  };
  return cmocka_run_group_tests_name("abi/forces", tests, nullptr, nullptr);
}
