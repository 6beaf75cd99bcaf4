// Recorded sessions: done again they come out the same, in another engine, on other threads; where something was changed,
// the step, the call and the body that are named are those that were changed.
#include <carom/record.h>

#include <algorithm>
#include <cstring>

#include "carom_test.h"
#include "replay/replay.h"
#include "replay/script.h"
#include "scenes/run.h"

using namespace carom::tools;
using replay::Outcome;
using Bytes = std::vector<std::byte>;

static int32_t keep(void* to, const void* bytes, uint64_t size) {
  auto& all = *static_cast<Bytes*>(to);
  const auto* const from = static_cast<const std::byte*>(bytes);
  all.insert(all.end(), from, from + size);
  return 0;
}

static void begin(carom_world* world, Bytes& to, std::uint32_t flags = CAROM_RECORD_HASHES) {
  assert_int_equal(carom_world_record_begin(world, flags, keep, &to, nullptr), CAROM_OK);
}

static Outcome replayed(const Bytes& bytes, std::uint32_t threads = 1) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  engine.set_threads(threads);
  engine.load_all();
  return replay::play(engine.get(), bytes);
}

/// A session in which bodies, shapes and joints come and go, bulk writes and particles among them.
struct Session {
  Session(std::uint32_t flags, double push = 1) : engine(PluginPath({CAROM_PLUGIN_DIR})), stage(engine) {
    build(find_scene("falling"), {{{"n", 20}}, ""}, stage);
    carom_world* const w = stage.world.get();
    steps(10);
    begin(w, bytes, flags);
    steps(5);
    Call call;
    carom_body_desc desc;
    carom_body_desc_init(&desc, sizeof desc);
    desc.position[1] = 9, desc.user = 5;
    call.done(carom_body_create(w, &desc, &late, call), "late body");
    carom_collider_desc part;
    carom_collider_desc_init(&part, sizeof part);
    part.shape = engine.shape("cylinder", {0.3, 0.4});  // a shape that the world did not know
    carom_collider collider;
    call.done(carom_collider_create(w, late, &part, &collider, call), "late collider");
    const double up[3] = {0, 1, 0}, spin[3] = {0, 3, 0}, tilted[3] = {0, 0.6, 0.8};
    part.shape = engine.half_space(tilted, -30);
    carom_body wall;
    desc.type = CAROM_BODY_STATIC;
    call.done(carom_body_create(w, &desc, &wall, call), "a wall");
    call.done(carom_collider_create(w, wall, &part, &collider, call), "a wall");
    steps(5);
    const double velocity[3] = {push, 2, 0};
    call.done(carom_body_set_velocity(w, late, velocity, spin, call), "a push");
    steps(5);
    carom_joint_desc joint;
    carom_joint_desc_init(&joint, sizeof joint);
    joint.body_a = late, joint.body_b = CAROM_NULL_HANDLE, joint.position_b[1] = 9;
    carom_joint made;
    call.done(carom_joint_create(w, &joint, &made, call), "a joint");
    joint.kind = CAROM_JOINT_HINGE, joint.fields = CAROM_JOINT_WORLD_FRAME;
    carom_joint hinge;
    call.done(carom_joint_create(w, &joint, &hinge, call), "a hinge");
    const double motors[2][4] = {{1, 40, 3, 99}, {1, 2, 8, 99}};
    const carom_joint twice[2] = {hinge, hinge};
    call.done(carom_world_write_joints(w, CAROM_JOINT_BULK_MOTOR, CAROM_SCALAR_F64, twice, 2, motors, 32, call),
              "motors");
    // Bulk, with gaps between records.
    std::vector<carom_body> bodies = stage.world.bodies();
    bodies.resize(3);
    float wide[3 * 4] = {1, 2, 3, 99, 4, 5, 6, 99, 7, 8, 9, 99};
    call.done(carom_world_write(w, CAROM_FIELD_LINEAR_VELOCITY, CAROM_SCALAR_F32, &bodies[0], 0, wide, 16, call),
              "none");
    for (carom_body& body : bodies) body = late;
    call.done(carom_world_write(w, CAROM_FIELD_LINEAR_VELOCITY, CAROM_SCALAR_F32, bodies.data(), 3, wide, 16, call),
              "bulk");
    carom_particles set;
    const double at[6] = {1, 5, 1, 2, 5, 2};
    call.done(carom_particles_create(w, nullptr, &set, call), "particles");
    call.done(carom_particles_add(w, set, 2, CAROM_SCALAR_F64, at, 0, nullptr, 0, call), "particles");
    steps(5);
    const std::uint32_t gone = 0;
    call.done(carom_particles_remove(w, set, &gone, 1, call), "particles");
    std::uint64_t size = 0;
    call.done(carom_world_save(w, 0, nullptr, 0, &size, call), "a state");
    std::vector<char> state(size);
    call.done(carom_world_save(w, 0, state.data(), size, &size, call), "a state");
    steps(5);
    assert_int_equal(carom_body_set_velocity(w, 12345, up, up, nullptr), CAROM_E_INVALID_HANDLE);  // is not written
    call.done(carom_world_restore(w, state.data(), size, call), "back");
    call.done(carom_joint_destroy(w, made, call), "no joint");
    call.done(carom_joint_destroy(w, hinge, call), "no hinge");
    call.done(carom_world_write_joints(w, CAROM_JOINT_BULK_MOTOR, CAROM_SCALAR_F64, nullptr, 0, nullptr, 0, call),
              "no motors");
    call.done(carom_body_destroy(w, wall, call), "no wall");
    steps(10);
    call.done(carom_world_record_end(w, call), "the end");
    hash = stage.world.hash();
  }
  void steps(int n) {
    for (int k = 0; k < n; ++k) stage.world.step(1.0 / 60), ++taken;
  }
  Engine engine;
  Stage stage;
  Bytes bytes;
  carom_body late = CAROM_NULL_HANDLE;
  std::uint64_t hash = 0, taken = 0;
};

static void a_session_comes_out_the_same(void**) {
  for (const std::uint32_t flags : {CAROM_RECORD_HASHES, CAROM_RECORD_STATES}) {
    Session session(flags);
    for (const std::uint32_t threads : {1u, 3u}) {
      const Outcome outcome = replayed(session.bytes, threads);
      if (outcome.parting)
        print_error("parts at step %llu: %s %s\n", (unsigned long long)outcome.parting->step,
                    outcome.parting->sections.c_str(), outcome.parting->refused.c_str());
      assert_true(!outcome.parting && outcome.ended);
      assert_true(outcome.steps == session.taken - 10);
      assert_true(outcome.calls > outcome.steps + 10);
    }
  }
}

/// Where a number of a call stands in the bytes: the first time that they have it. (States after it may have it, too.)
static std::size_t place_of(const Bytes& bytes, double number) {
  std::size_t at = 0;
  while (at + 8 <= bytes.size() && std::memcmp(&bytes[at], &number, 8) != 0) ++at;
  assert_true(at + 8 <= bytes.size());
  return at;
}

static void what_was_changed_is_named(void**) {
  const double push = 0.7310585786300049;
  Session session(CAROM_RECORD_STATES, push);
  Bytes bytes = session.bytes;
  const double other = push * (1 + 1e-15);  // one bit or a few
  std::memcpy(&bytes[place_of(bytes, push)], &other, 8);
  const Outcome outcome = replayed(bytes);
  assert_true(outcome.parting.has_value());
  const replay::Parting& p = *outcome.parting;
  assert_int_equal(p.step, 21);  // ten before the recording, five, five, and the first with the push
  assert_true(outcome.steps == 11);
  assert_int_equal(p.calls.size(), 2);
  assert_true(p.calls[0].rfind("carom_body_set_velocity(body=body ", 0) == 0);
  assert_true(p.calls[0].find("body " + std::to_string(session.late & 0xFFFFFF) + ",") != std::string::npos);
  assert_true(p.calls[1].rfind("carom_world_step(", 0) == 0);
  assert_true(p.sections.rfind("bodies", 0) == 0);
  assert_true((p.first & 0xFFFFFFFFFFFull) == (session.late & 0xFFFFFFFFFFFull) && p.second == 0);
  assert_true(std::any_of(p.details.begin(), p.details.end(), [](const std::string& d) {
    return d.rfind("linear velocity: recorded (0.7310585786300", 0) == 0;
  }));
  // Without states the step and the calls are still named.
  Session brief(CAROM_RECORD_HASHES, push);
  bytes = brief.bytes;
  std::memcpy(&bytes[place_of(bytes, push)], &other, 8);
  const Outcome less = replayed(bytes);
  assert_true(less.parting && less.parting->step == 21 && less.parting->calls == p.calls &&
              less.parting->sections.empty());
}

static void a_recording_that_is_cut_off_is_played_as_far_as_it_goes(void**) {
  Session session(CAROM_RECORD_HASHES);
  std::size_t played = 0;
  for (std::size_t n = session.bytes.size(); n > session.bytes.size() / 2; n -= 997) {
    const Bytes cut(session.bytes.begin(), session.bytes.begin() + static_cast<std::ptrdiff_t>(n));
    const Outcome outcome = replayed(cut);
    assert_true(!outcome.parting && (n == session.bytes.size()) == outcome.ended);
    ++played;
  }
  assert_true(played > 3);
  for (const std::size_t n : {std::size_t(0), std::size_t(15), std::size_t(40)}) {
    const Bytes cut(session.bytes.begin(), session.bytes.begin() + static_cast<std::ptrdiff_t>(n));
    bool refused = false;
    try {
      replayed(cut);
    } catch (const Error& e) {
      refused = !e.remedy.empty();
    }
    assert_true(refused);
  }
}

static int32_t full(void* left, const void*, uint64_t size) {
  auto& room = *static_cast<std::int64_t*>(left);
  room -= static_cast<std::int64_t>(size);
  return room < 0 ? 28 : 0;
}

static void a_disk_that_is_full_stops_the_recording_alone(void**) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine), same(engine);
  build(find_scene("falling"), {{{"n", 10}}, ""}, stage);
  build(find_scene("falling"), {{{"n", 10}}, ""}, same);
  carom_world* const w = stage.world.get();
  std::int64_t left = 20000;
  carom_error error = CAROM_ERROR_INIT;
  assert_int_equal(carom_world_record_begin(w, CAROM_RECORD_STATES, full, &left, &error), CAROM_OK);
  assert_int_equal(carom_world_record_begin(w, 0, full, &left, &error), CAROM_E_IN_USE);
  for (int k = 0; k < 30; ++k) stage.world.step(1.0 / 60), same.world.step(1.0 / 60);
  assert_true(left < 0 && stage.world.hash() == same.world.hash());
  assert_int_equal(carom_world_record_end(w, &error), CAROM_E_WRITE_FAILED);
  assert_int_equal(carom_world_record_end(w, &error), CAROM_E_NOT_FOUND);
  left = 100;
  assert_int_equal(carom_world_record_begin(w, 0, full, &left, &error), CAROM_E_WRITE_FAILED);
  assert_int_equal(carom_world_record_end(w, &error), CAROM_E_NOT_FOUND);
  assert_int_equal(carom_world_record_begin(w, 8, full, &left, &error), CAROM_E_UNSUPPORTED);
  assert_int_equal(carom_world_record_begin(w, 0, nullptr, &left, &error), CAROM_E_NULL_ARGUMENT);
}

struct Meter {
  std::int64_t left = -1, failed = 0;  // allocations until one fails; negative: never
};
static void* metered(void* user, uint64_t size, uint64_t alignment) {
  auto& m = *static_cast<Meter*>(user);
  if (m.left == 0) return m.left = -1, ++m.failed, nullptr;
  if (m.left > 0) --m.left;
  void* p = nullptr;
  return posix_memalign(&p, std::max<std::size_t>(alignment, sizeof(void*)), size) ? nullptr : p;
}

/// Whatever runs out of memory while a world is recorded, a call or its record: calls that fail are made again; then the
/// recording is whole, and comes out the same, or says that it is not.
static void memory_may_run_out_while_recording(void**) {
  int whole = 0, broken = 0, refused = 0;
  for (std::int64_t k = 0;; k += 1 + k / 16) {  // closer where calls are refused, which comes first
    Meter meter;
    carom_engine_desc desc;
    carom_engine_desc_init(&desc, sizeof desc);
    desc.alloc = metered, desc.alloc_user = &meter;
    desc.free = [](void*, void* p, uint64_t, uint64_t) { std::free(p); };
    Engine engine(PluginPath({CAROM_PLUGIN_DIR}), &desc);
    Stage stage(engine);
    build(find_scene("falling"), {{{"n", 4}}, ""}, stage);
    const carom_shape shape = engine.shape("cylinder", {0.3, 0.4});
    carom_world* const w = stage.world.get();
    for (int i = 0; i < 3; ++i) stage.world.step(1.0 / 60);
    Bytes bytes;
    begin(w, bytes, CAROM_RECORD_STATES);
    meter.left = k;
    const auto insist = [&](auto&& call) {
      if (const int32_t r = call(); r != CAROM_OK) {
        assert_int_equal(r, CAROM_E_OUT_OF_MEMORY);
        ++refused;
        assert_int_equal(call(), CAROM_OK);
      }
    };
    carom_body body;
    carom_body_desc about;
    carom_body_desc_init(&about, sizeof about);
    about.position[1] = 7;
    carom_collider_desc part;
    carom_collider_desc_init(&part, sizeof part);
    part.shape = shape;
    carom_collider collider;
    insist([&] { return carom_body_create(w, &about, &body, nullptr); });
    insist([&] { return carom_collider_create(w, body, &part, &collider, nullptr); });
    for (int i = 0; i < 8; ++i) insist([&] { return carom_world_step(w, 1.0 / 60, nullptr); });
    const bool done = meter.failed == 0;
    meter.left = -1;
    const int32_t end = carom_world_record_end(w, nullptr);
    if (end == CAROM_OK) {
      ++whole;
      const Outcome outcome = replayed(bytes);
      assert_true(!outcome.parting && outcome.ended);
    } else {
      ++broken;
      assert_int_equal(end, CAROM_E_OUT_OF_MEMORY);
      assert_true(!done);
    }
    if (done) break;
  }
  std::printf("  %d recordings whole, %d broken off; %d calls refused\n", whole, broken, refused);
  assert_true(whole > 5 && broken > 5 && refused > 5);
}

/// What differs is named by kind and handle, too, where it is no body.
static void worlds_are_compared(void**) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  Stage stage(engine);
  build(find_scene("ragdoll"), {{{"n", 1}}, ""}, stage);
  carom_world* const w = stage.world.get();
  for (int k = 0; k < 60; ++k) stage.world.step(1.0 / 60);
  std::uint64_t size = 0;
  assert_int_equal(carom_world_save(w, 0, nullptr, 0, &size, nullptr), CAROM_OK);
  std::vector<char> state(size);
  assert_int_equal(carom_world_save(w, 0, state.data(), size, &size, nullptr), CAROM_OK);
  carom_difference d = {};
  d.struct_size = sizeof d;
  assert_int_equal(carom_world_compare(w, state.data(), size, &d, nullptr), CAROM_OK);
  assert_true(d.differs == 0 && d.first == 0 && d.sections[0] == 0);
  const double up[3] = {0, 1, 0}, gravity[3] = {0, -9, 0};
  const std::vector<carom_body> bodies = stage.world.bodies();
  assert_int_equal(carom_world_set_gravity(w, gravity, nullptr), CAROM_OK);
  assert_int_equal(carom_world_compare(w, state.data(), size, &d, nullptr), CAROM_OK);
  assert_true(d.differs == 1 && d.first == 0);
  assert_string_equal(d.sections, "dials, progress");  // the next step plans anew
  assert_int_equal(carom_body_add_force(w, bodies[7], up, up, nullptr), CAROM_OK);
  assert_int_equal(carom_world_compare(w, state.data(), size, &d, nullptr), CAROM_OK);
  assert_true(d.first == bodies[7] && d.second == 0);
  assert_string_equal(d.sections, "bodies, dials, progress");
  state[size / 2] ^= 1;
  assert_int_equal(carom_world_compare(w, state.data(), size, &d, nullptr), CAROM_E_CORRUPT);
  Stage other(engine);
  assert_int_equal(carom_world_save(other.world.get(), 0, nullptr, 0, &size, nullptr), CAROM_OK);
  state.resize(size);
  assert_int_equal(carom_world_save(other.world.get(), 0, state.data(), size, &size, nullptr), CAROM_OK);
  assert_int_equal(carom_world_compare(w, state.data(), size, &d, nullptr), CAROM_E_MISMATCH);
}

/// Every scene, from its first step on.
static void scenes_come_out_the_same(void**) {
  for (const Scene& scene : all_scenes()) {
    if (scene.name == "catapult" || scene.name == "bunnies")
      continue;  // hulls of thousands of vertices: long, and no other calls
    Bytes bytes;
    {
      Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
      Stage stage(engine);
      begin(stage.world.get(), bytes);  // of an empty world: all that the scene does is in it
      Settings settings;
      for (const Knob& knob : scene.knobs)
        if (knob.name == "n") settings.values.emplace_back("n", std::min(knob.initial, std::max(knob.min, 8.0)));
      build(scene, settings, stage);
      for (int k = 0; k < 20; ++k) stage.world.step(scene.dt);
    }
    const Outcome outcome = replayed(bytes);
    if (outcome.parting)
      print_error("%s parts at step %llu: %s\n", scene.name.c_str(), (unsigned long long)outcome.parting->step,
                  outcome.parting->refused.c_str());
    assert_true(!outcome.parting && outcome.ended && outcome.steps == 20);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_session_comes_out_the_same),
      cmocka_unit_test(what_was_changed_is_named),
      cmocka_unit_test(a_recording_that_is_cut_off_is_played_as_far_as_it_goes),
      cmocka_unit_test(a_disk_that_is_full_stops_the_recording_alone),
      cmocka_unit_test(memory_may_run_out_while_recording),
      cmocka_unit_test(worlds_are_compared),
      cmocka_unit_test(scenes_come_out_the_same),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
