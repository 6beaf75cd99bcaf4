// After a restore every scene goes on as it did, bit for bit: in the world that was saved, in another one that was
// made by the same calls, in one that was built of a whole snapshot by an engine that knows no scene, and in a fork;
// whatever solver, broad phase and number of threads.
#include <carom/batch.h>
#include <carom/snapshot.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "carom_test.h"
#include "scenes/run.h"
#include "sliced.h"

using namespace carom::tools;
using Bytes = std::vector<unsigned char>;

static std::string own_path;

static Bytes save(carom_world* world, std::uint32_t flags = CAROM_SNAPSHOT_STATE) {
  std::uint64_t size = 0, again = 0;
  assert_int_equal(carom_world_save(world, flags, nullptr, 0, &size, nullptr), CAROM_OK);
  Bytes bytes(size);
  assert_int_equal(carom_world_save(world, flags, bytes.data(), size, &again, nullptr), CAROM_OK);
  assert_true(size == again);
  return bytes;
}
static Bytes save(const Stage& stage) { return save(stage.world.get()); }

static void restore(carom_world* world, const Bytes& bytes) {
  carom_error error = CAROM_ERROR_INIT;
  const int32_t result = carom_world_restore(world, bytes.data(), bytes.size(), &error);
  if (result != CAROM_OK) print_error("%s\n", error.message);
  assert_int_equal(result, CAROM_OK);
}
static void restore(Stage& stage, const Bytes& bytes) { restore(stage.world.get(), bytes); }

static std::vector<std::uint64_t> hashes(carom_world* world, double dt, int steps) {
  std::vector<std::uint64_t> all;
  for (int k = 0; k < steps; ++k) {
    std::uint64_t hash = 0;
    assert_int_equal(carom_world_step(world, dt, nullptr), CAROM_OK);
    assert_int_equal(carom_world_hash(world, &hash, nullptr), CAROM_OK);
    all.push_back(hash);
  }
  return all;
}
static std::vector<std::uint64_t> hashes(Stage& stage, double dt, int steps) {
  return hashes(stage.world.get(), dt, steps);
}

struct Case {
  const char* scene;
  std::vector<std::pair<std::string, double>> knobs;
  std::vector<const char*> dials;
  int before = 40, after = 120;  // steps
  std::uint32_t events = 0;
  std::uint32_t threads = 1;
};

static std::string name_of(const Case& c) {
  std::string name = c.scene;
  for (const char* dial : c.dials) name += std::string(" ") + dial;
  return name;
}

/// Set up as the case says, and nothing stepped.
struct Room {
  explicit Room(const Case& c)
      : engine(PluginPath({CAROM_PLUGIN_DIR})), stage((engine.set_threads(c.threads), engine)) {
    const Scene& scene = find_scene(c.scene);
    dt = scene.dt;
    observer = build(scene, {c.knobs, ""}, stage);
    for (const char* dial : c.dials) stage.world.set_dial(dial);
    if (c.events) assert_int_equal(carom_world_collect_events(stage.world.get(), c.events, 1.0, nullptr), CAROM_OK);
  }
  Engine engine;
  Stage stage;
  std::unique_ptr<Observer> observer;
  double dt;
};

static bool same(const Case& c, const char* where, const std::vector<std::uint64_t>& a,
                 const std::vector<std::uint64_t>& b) {
  for (std::size_t k = 0; k < a.size(); ++k)
    if (a[k] != b[k]) {
      print_error("%s, %s: step %zu after the restore is another\n", name_of(c).c_str(), where, k + 1);
      return false;
    }
  return true;
}

/// A world of an engine that has plugins and nothing else, made of a whole snapshot.
struct Elsewhere {
  explicit Elsewhere(std::uint32_t threads, const Bytes& bytes)
      : engine(PluginPath({CAROM_PLUGIN_DIR})), world((engine.set_threads(threads), engine)) {
    for (const auto& plugin : engine.path().all()) engine.plugin(plugin.first);
    restore(world.get(), bytes);
  }
  Engine engine;
  World world;
};

/// Of the second of three copies, whose states are packed and unpacked in some steps and not in others.
static std::uint64_t hash_in_a_batch(Room& room, int steps) {
  carom_batch* batch = nullptr;
  std::uint64_t first = 0, hash[3] = {};
  assert_int_equal(carom_batch_create(room.engine.get(), &batch, nullptr), CAROM_OK);
  assert_int_equal(carom_batch_add_worlds(batch, room.stage.world.get(), 3, &first, nullptr), CAROM_OK);
  for (int left = steps, part = 1; left > 0; left -= part, part = std::min(left, part % 5 + 1))
    assert_int_equal(
        carom_batch_step(batch, nullptr, room.dt, static_cast<std::uint32_t>(std::min(left, part)), nullptr, nullptr),
        CAROM_OK);
  assert_int_equal(carom_batch_get_hashes(batch, hash, 3, nullptr), CAROM_OK);
  assert_int_equal(carom_batch_destroy(batch, nullptr), CAROM_OK);
  assert_true(hash[0] == hash[1] && hash[2] == hash[1]);
  return hash[1];
}

/// @param room  as it was saved, with what comes then
static int is_the_same_elsewhere(const Case& c, Room& room, const std::vector<std::uint64_t>& onward) {
  const Bytes state = save(room.stage), whole = save(room.stage.world.get(), CAROM_SNAPSHOT_WHOLE);
  const std::uint64_t then = room.stage.world.hash();
  int wrong = 0;
  const auto complain = [&](const char* what) { ++wrong, print_error("%s: %s\n", name_of(c).c_str(), what); };
  {
    Elsewhere other(c.threads, whole);
    if (save(other.world.get()) != state) complain("what was built of a whole snapshot has another state");
    if (save(other.world.get(), CAROM_SNAPSHOT_WHOLE) != whole) complain("saved whole again, the bytes are others");
    wrong += !same(c, "built of a whole snapshot", onward, hashes(other.world.get(), room.dt, c.after));
  }
  if (hash_in_a_batch(room, c.after) != onward.back()) complain("a copy in a batch has gone on otherwise");
  carom_world* copy = nullptr;
  assert_int_equal(carom_world_fork(room.stage.world.get(), &copy, nullptr), CAROM_OK);
  if (save(copy, CAROM_SNAPSHOT_WHOLE) != whole) complain("a fork has another state");
  const auto part = hashes(copy, room.dt, c.after / 2);
  wrong += !same(c, "fork", {onward.begin(), onward.begin() + c.after / 2}, part);
  if (room.stage.world.hash() != then || save(room.stage.world.get(), CAROM_SNAPSHOT_WHOLE) != whole)
    complain("a fork has changed the world that it is of");
  assert_int_equal(carom_world_destroy(copy, nullptr), CAROM_OK);
  return wrong;
}

static int goes_on(Case c) {
  c.after = std::min(c.after, carom::test::sliced(1000, c.after > 200 ? 250 : 40, 40));
  Room room(c);
  hashes(room.stage, room.dt, c.before);
  const Bytes bytes = save(room.stage);
  const std::uint64_t then = room.stage.world.hash();
  const auto onward = hashes(room.stage, room.dt, c.after);
  restore(room.stage, bytes);
  int wrong = room.stage.world.hash() != then;
  if (wrong) print_error("%s: the hash after the restore is another\n", name_of(c).c_str());
  const Bytes again = save(room.stage);
  if (again != bytes) ++wrong, print_error("%s: saved again, the bytes are others\n", name_of(c).c_str());
  wrong += !same(c, "same world", onward, hashes(room.stage, room.dt, c.after));
  restore(room.stage, bytes);
  wrong += is_the_same_elsewhere(c, room, onward);
  wrong += !same(c, "forked world", onward, hashes(room.stage, room.dt, c.after));
  Room other(c);
  restore(other.stage, bytes);
  wrong += other.stage.world.hash() != then;
  wrong += !same(c, "other world", onward, hashes(other.stage, other.dt, c.after));
  // And within a trajectory that is already another's.
  restore(other.stage, bytes);
  hashes(other.stage, other.dt, c.after / 3);
  const Bytes third = save(other.stage);
  restore(room.stage, third);
  wrong += !same(c, "twice", {onward.begin() + c.after / 3, onward.end()},
                 hashes(room.stage, room.dt, c.after - c.after / 3));
  return wrong;
}

static const std::vector<Case>& small_scenes() {
  static const std::vector<Case> cases = {
      {"seesaw", {}, {}, 100, 60},
      {"catapult", {}, {}, 100, 30},
      {"falling", {{"n", 100}}, {}},
      {"particles", {{"n", 3000}}, {}, 40, 40},
      {"bunnies", {{"n", 4}}, {}, 40, 60},
      {"pyramid", {{"n", 6}}, {}},
      {"stacks", {{"n", 2}, {"height", 6}}, {}},
      {"wall", {}, {}, 60, 60},
      {"quoits", {{"n", 2}, {"parts", 1}}, {}},
      {"ragdoll", {{"n", 1}}, {}, 60, 200},
      {"sleepers", {{"n", 20}}, {"sleep=on"}, 200, 200},
      {"bullet", {}, {}, 3, 100},
      {"net", {{"n", 8}}, {}},
      {"terrain", {{"n", 30}}, {}},
      {"conveyor", {}, {}},
      {"weather", {}, {}, 40, 100},
  };
  return cases;
}

static void every_scene_goes_on_as_it_did(void**) {
  int wrong = 0;
  for (const Scene& scene : all_scenes()) {
    bool known = false;
    for (const Case& c : small_scenes()) known |= scene.name == c.scene;
    if (!known) ++wrong, print_error("no case for scene %s\n", scene.name.c_str());
  }
  for (const Case& c : small_scenes()) wrong += goes_on(c);
  assert_int_equal(wrong, 0);
}

static void so_it_does_under_every_solver(void**) {
  int wrong = 0;
  for (const char* solver : {"solver=severity", "solver=soft_step", "solver=direct"})
    for (const char* scene : {"falling", "ragdoll", "stacks", "conveyor"}) {
      const std::string name = scene, which = solver;
      if (which == "solver=severity" && name == "ragdoll") continue;  // it knows no joints
      Case c{scene, {}, {solver}, 70, 60};
      if (name == "falling") c.knobs = {{"n", 50}};
      if (name == "ragdoll") c.knobs = {{"n", 1}};
      if (name == "stacks") c.knobs = {{"n", 2}, {"height", 4}};
      wrong += goes_on(c);
    }
  assert_int_equal(wrong, 0);
}

static void so_it_does_whatever_the_dials(void**) {
  const std::vector<Case> cases = {
      {"falling", {{"n", 60}}, {"broad_phase=sweep_and_prune", "integrator=rk4"}, 90, 60},
      {"falling", {{"n", 60}}, {"broad_phase=grid", "pair_routines=off"}, 90, 60},
      {"falling", {{"n", 60}}, {"broad_phase=tree", "pair_routines=off", "carry_over=0.01"}, 90, 60},
      {"falling", {{"n", 60}}, {"manifold=cache", "rotation=splitting_4"}, 90, 60},
      {"falling", {{"n", 60}}, {"manifold=clip", "integrator=velocity_verlet"}, 90, 60},
      {"falling", {{"n", 60}}, {"sleep=on", "sleep_time=0.2", "sleep_speed=0.5"}, 150, 150},
      {"falling", {{"n", 60}}, {"sleep=on", "sleep_time=0.1", "sleep_speed=2"}, 120, 200, 31},
      {"terrain", {{"n", 30}}, {"sleep=on", "sleep_time=0.2", "sleep_speed=0.5"}, 150, 150},
      {"ragdoll", {{"n", 1}}, {"sleep=on", "sleep_time=0.2", "sleep_speed=0.5"}, 150, 150},
      {"weather", {}, {"sleep=on", "sleep_time=0.2", "sleep_speed=0.5"}, 100, 100},
      {"stacks", {{"n", 2}, {"height", 8}}, {"warm_start=off"}, 60, 60},
      {"net", {{"n", 8}}, {"integrator=velocity_verlet", "solver=direct"}, 60, 60},
      {"bullet", {}, {"solver=soft_step", "sleep=on"}, 6, 60},
  };
  int wrong = 0;
  for (const Case& c : cases) wrong += goes_on(c);
  assert_int_equal(wrong, 0);
}

static void it_goes_on_for_long(void**) {
  int wrong = 0;
  wrong += goes_on({"falling", {{"n", 40}}, {}, 60, 1000});
  wrong += goes_on({"ragdoll", {{"n", 1}}, {}, 60, 1000});
  wrong += goes_on({"stacks", {{"n", 2}, {"height", 6}}, {"solver=direct"}, 60, 1000});
  wrong += goes_on({"falling", {{"n", 40}}, {"sleep=on"}, 200, 1000});
  assert_int_equal(wrong, 0);
}

static void threads_do_not_matter(void**) {
  Case c{"falling", {{"n", 300}}, {"sleep=on", "sleep_time=0.3", "sleep_speed=0.5"}, 150, 150};
  Room one(c);
  hashes(one.stage, one.dt, c.before);
  const Bytes bytes = save(one.stage);
  const auto onward = hashes(one.stage, one.dt, c.after);
  for (const std::uint32_t threads : {2u, 4u}) {
    c.threads = threads;
    Room room(c);
    hashes(room.stage, room.dt, c.before);
    assert_true(save(room.stage) == bytes);
    restore(room.stage, bytes);
    assert_int_equal(is_the_same_elsewhere(c, room, onward), 0);
    assert_true(same(c, "threads", onward, hashes(room.stage, room.dt, c.after)));
    restore(room.stage, bytes);
    assert_true(same(c, "threads", onward, hashes(room.stage, room.dt, c.after)));
  }
}

static const Case kAgain{"falling", {{"n", 60}}, {"sleep=on", "sleep_time=0.2", "sleep_speed=0.5"}, 150, 100};

/// The part of another process: read a snapshot, go on, print every hash.
static int go_on_from(const char* path) {
  std::ifstream file(path, std::ios::binary);
  const Bytes bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  Room room(kAgain);
  if (carom_world_restore(room.stage.world.get(), bytes.data(), bytes.size(), nullptr) != CAROM_OK) return 1;
  for (const std::uint64_t hash : hashes(room.stage, room.dt, kAgain.after))
    std::printf("%016llx\n", static_cast<unsigned long long>(hash));
  return 0;
}

static void nor_does_the_process(void**) {
  Room room(kAgain);
  hashes(room.stage, room.dt, kAgain.before);
  const Bytes bytes = save(room.stage);
  char path[] = "/tmp/carom_snapshot_XXXXXX";
  const int fd = mkstemp(path);
  assert_true(fd >= 0 && write(fd, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()));
  close(fd);
  const auto onward = hashes(room.stage, room.dt, kAgain.after);
  std::FILE* other = popen((own_path + " " + path).c_str(), "r");
  assert_non_null(other);
  std::vector<std::uint64_t> theirs;
  unsigned long long hash;
  while (std::fscanf(other, "%llx", &hash) == 1) theirs.push_back(hash);
  assert_int_equal(pclose(other), 0);
  std::remove(path);
  assert_true(theirs == onward);
}

/// A body takes less than 256 bytes while it falls.
static void it_is_small(void**) {
  Case c{"falling", {{"n", 1000}}, {}};
  Room room(c);
  hashes(room.stage, room.dt, 5);
  const double each = static_cast<double>(save(room.stage).size()) / 1000;
  std::printf("  %.1f bytes for a body that falls\n", each);
  assert_true(each < 256);
}

/// Argument: a snapshot to go on from, in place of the tests.
int main(int argc, char** argv) {
  if (argc > 1) return go_on_from(argv[1]);
  own_path = std::filesystem::read_symlink("/proc/self/exe").string() + " snapshot";
  const CMUnitTest tests[] = {
      cmocka_unit_test(every_scene_goes_on_as_it_did),
      cmocka_unit_test(so_it_does_under_every_solver),
      cmocka_unit_test(so_it_does_whatever_the_dials),
      cmocka_unit_test(it_goes_on_for_long),
      cmocka_unit_test(threads_do_not_matter),
      cmocka_unit_test(nor_does_the_process),
      cmocka_unit_test(it_is_small),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
