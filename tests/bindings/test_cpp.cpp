// carom.hpp: the scene of scene.c with the same bits, a shape that is a lambda, failures, arrays, and nothing that is not given back.
// usage: bindings_cpp (tests, with $CAROM_SCENE and $CAROM_PLUGIN_PATH), bindings_cpp scene (hashes, as other hosts print them)
#include <atomic>
#include <cinttypes>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "carom_test.h"
#include "scene.hpp"

const char* without_exceptions();

namespace {

const std::initializer_list<carom_param> kTop = {{"radius", "m", 1e-9, 1e8}, {"half_height", "m", 1e-9, 1e8}};

template <class F>
carom_error failure(F f) {
  try {
    f();
  } catch (const carom::Error& e) {
    assert_non_null(std::strstr(e.what(), ". Remedy: "));
    assert_string_not_equal(e.details.remedy, "");
    return e.details;
  }
  assert_string_equal("it did not fail", "");
  return {};
}

void print_scene() {
  auto engine = carom::Engine::create();
  const carom_shape tops[] = {engine.shape("template", {0.35, 0.4}),
                              engine.shape(engine.plugin("test.top", kTop, top_support), {0.35, 0.4})};
  for (const carom_shape top : tops)
    for (const std::uint64_t hash : scene_hashes(engine, top)) std::printf("%016" PRIx64 "\n", hash);
}

}  // namespace

static void same_bits_as_in_c(void**) {
  FILE* pipe = popen("\"$CAROM_SCENE\" \"$CAROM_PLUGIN_PATH\"", "r");
  assert_non_null(pipe);
  std::array<std::uint64_t, 3> of_c;
  for (auto& hash : of_c) assert_int_equal(std::fscanf(pipe, "%" SCNx64, &hash), 1);
  assert_int_equal(pclose(pipe), 0);
  auto engine = carom::Engine::create();
  std::atomic<int> calls = 0;
  const auto kind =
      engine.plugin("test.top", kTop, [&](auto params, const auto& d) { return ++calls, top_support(params, d); });
  assert_true(scene_hashes(engine, engine.shape("template", {0.35, 0.4})) == of_c);
  const int before = calls;
  assert_true(scene_hashes(engine, engine.shape(kind, {0.35, 0.4})) == of_c);
  assert_true(calls > before + 1000);  // the scene really asked it
  assert_true(scene_hashes(engine, engine.shape(kind, {0.35, 0.41})) != of_c);
}

static void failures_have_a_remedy(void**) {
  auto engine = carom::Engine::create();
  auto world = engine.world();
  assert_int_equal(failure([&] { engine.shape("no_such_shape", {}); }).code, CAROM_E_NOT_FOUND);
  assert_int_equal(failure([&] { engine.shape("sphere", {-1.0}); }).code, CAROM_E_OUT_OF_RANGE);
  assert_int_equal(failure([&] { world.step(2); }).argument, 2);
  const auto ball = world.body(engine.shape("sphere", {0.5}));
  ball.destroy();
  assert_int_equal(failure([&] { ball.position(); }).code, CAROM_E_STALE_HANDLE);
  assert_int_equal(failure([&] { world.body(CAROM_NULL_HANDLE); }).code, CAROM_E_INVALID_HANDLE);
  assert_true(world.bodies().empty());  // the body without its collider is gone, too
  // A support function that throws, or that is none, is refused.
  const auto bad = [&](const char* id, carom::Support support) {
    return failure([&] { engine.plugin(id, {}, support); }).code;
  };
  assert_int_equal(bad("test.throws", [](auto, const auto&) -> carom::Vec3 { throw std::runtime_error("no"); }),
                   CAROM_E_PLUGIN_INVALID);
  assert_int_equal(bad("test.dent",
                       [](auto, const auto& d) {
                         return carom::Vec3{-d[0], d[1], d[2]};
                       }),
                   CAROM_E_PLUGIN_INVALID);
}

static void failures_as_values(void**) {
  const char* why = without_exceptions();
  assert_string_equal(why ? why : "", "");
}

static void arrays_of_bodies(void**) {
  auto engine = carom::Engine::create();
  auto world = engine.world();
  const auto shape = engine.shape("sphere", {0.5});
  std::vector<carom::Body> made;
  for (int i = 0; i < 100; i++) made.push_back(world.body(shape, {.position = {2.0 * i, 1, 0}}));
  std::vector<carom::Vec3> positions(100);
  std::vector<carom::Pose> poses(100);
  std::vector<std::array<float, 3>> floats(100);
  world.positions(positions), world.poses(poses), world.read(CAROM_FIELD_POSITION, floats);
  const auto handles = world.bodies();
  for (int i = 0; i < 100; i++) {
    assert_true(handles[i] == made[i].handle() && positions[i] == made[i].position() &&
                poses[i].position == positions[i]);
    assert_true(floats[i][0] == 2.0f * float(i) && poses[i].orientation[3] == 1);
  }
  const carom::Vec3 up[] = {{0, 9, 0}};
  world.write(CAROM_FIELD_POSITION, up, std::span(handles).first(1));
  assert_true(made[0].position() == up[0]);
  assert_int_equal(failure([&] { world.positions(std::span(positions).first(99)); }).code, CAROM_E_OUT_OF_RANGE);
  assert_int_equal(failure([&] { world.read(CAROM_FIELD_POSITION, positions, std::span(handles).first(2)); }).code,
                   CAROM_E_OUT_OF_RANGE);
  std::vector<double> thin(100);
  assert_int_equal(failure([&] { world.read(CAROM_FIELD_POSITION, thin); }).code, CAROM_E_BUFFER_TOO_SMALL);
}

static void a_copy_and_saved_bytes_go_on_alike(void**) {
  auto engine = carom::Engine::create();
  auto world = engine.world();
  world.ground();
  world.body(engine.shape("box", {0.5, 0.5, 0.5}), {.position = {0, 0.7, 0}, .angular_velocity = {1, 2, 3}});
  const auto saved = world.save();
  auto copy = world.fork();
  const auto run = [](carom::World& w) {
    for (int i = 0; i < 30; i++) w.step(1.0 / 60);
    return w.hash();
  };
  const auto after = run(world);
  assert_true(!world.contacts().empty() && run(copy) == after);
  world.restore(saved);
  assert_true(run(world) == after);
}

/// 65,535 engines and worlds may be alive in a process: more than that were made here, and given back.
static void nothing_is_left_alive(void**) {
  for (int i = 0; i < 33000; i++) {
    auto engine = carom::Engine::create();
    auto world = engine.world();
    engine = {};  // the world keeps what it stands on
    if (i % 1000 == 0) world.step(0.01), world = carom::World();
  }
}

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "scene") == 0) {
    try {
      print_scene();
      return 0;
    } catch (const carom::Error& e) {
      std::fprintf(stderr, "%s\n", e.what());
      return 1;
    }
  }
  const CMUnitTest tests[] = {
      cmocka_unit_test(same_bits_as_in_c),
      cmocka_unit_test(failures_have_a_remedy),
      cmocka_unit_test(failures_as_values),
      cmocka_unit_test(arrays_of_bodies),
      cmocka_unit_test(a_copy_and_saved_bytes_go_on_alike),
      cmocka_unit_test(nothing_is_left_alive),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
