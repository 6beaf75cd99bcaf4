// Batches: a world among many does what it would do alone, to the bit; what goes in and comes out; starts, masses, faults,
// lack of memory; and who may call at which time.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <vector>

#include "bench.h"
#include "carom_test.h"

namespace {

constexpr double kStep = 1.0 / 64;
constexpr uint64_t kWorlds = 7;

/// A world in which bodies fall, topple, sleep, and hang on a hinge.
struct Scene {
  Bench b;
  explicit Scene(const carom_engine_desc* desc = nullptr, const carom_jobs_desc* jobs = nullptr) {
    std::memset(&b, 0, sizeof b);
    assert_int_equal(carom_engine_create(desc, &b.engine, nullptr), CAROM_OK);
    if (jobs) assert_int_equal(carom_engine_set_jobs(b.engine, jobs, nullptr), CAROM_OK);
    assert_int_equal(bench_shapes(&b, nullptr), CAROM_OK);
    assert_int_equal(carom_world_create(b.engine, nullptr, &b.world, nullptr), CAROM_OK);
    assert_int_equal(carom_world_set_dial(b.world, CAROM_DIAL_SLEEP, 1, nullptr), CAROM_OK);
    assert_int_equal(bench_bodies(&b, nullptr), CAROM_OK);
    assert_int_equal(bench_joint(&b, nullptr), CAROM_OK);
    assert_int_equal(bench_particles(&b, nullptr), CAROM_OK);
    assert_int_equal(bench_steps(b.world, 3, nullptr), CAROM_OK);
  }
  ~Scene() { assert_int_equal(bench_free(&b), CAROM_OK); }
};

struct Batch {
  carom_batch* batch = nullptr;
  uint64_t n = 0;
  explicit Batch(const Scene& scene, uint64_t worlds = kWorlds) : n(worlds) {
    uint64_t first = 1;
    assert_int_equal(carom_batch_create(scene.b.engine, &batch, nullptr), CAROM_OK);
    assert_int_equal(carom_batch_add_worlds(batch, scene.b.world, worlds, &first, nullptr), CAROM_OK);
    assert_int_equal(first, 0);
  }
  ~Batch() { assert_int_equal(carom_batch_destroy(batch, nullptr), CAROM_OK); }

  uint32_t column(uint32_t source, uint32_t field, uint32_t when, const std::vector<uint64_t>& things, double* data,
                  const double* rays = nullptr, uint64_t world = 0) {
    carom_batch_column d;
    carom_batch_column_init(&d, sizeof d);
    d.source = source, d.field = field, d.when = when, d.data = data, d.rays = rays, d.world = world;
    d.handles = things.empty() ? nullptr : things.data(), d.n = things.empty() ? 1 : things.size();
    uint32_t number = 99;
    carom_error e = CAROM_ERROR_INIT;
    const int32_t r = carom_batch_add_column(batch, &d, &number, &e);
    if (r != CAROM_OK) print_error("%s\n", e.message);
    assert_int_equal(r, CAROM_OK);
    return number;
  }
  uint64_t step(uint32_t steps = 1, const uint8_t* mask = nullptr) {
    uint64_t stopped = 99;
    assert_int_equal(carom_batch_step(batch, mask, kStep, steps, &stopped, nullptr), CAROM_OK);
    return stopped;
  }
  std::vector<uint64_t> hashes() {
    std::vector<uint64_t> found(n);
    assert_int_equal(carom_batch_get_hashes(batch, found.data(), n, nullptr), CAROM_OK);
    return found;
  }
};

/// What world k is given: a push in each of `steps` steps.
double push_of(uint64_t k, int step, int i) { return std::sin(1.0 + 3.0 * double(k) + 0.7 * step + 1.3 * i) * 8; }

/// The same on a world of its own.
uint64_t alone(const Scene& scene, uint64_t k, int steps) {
  carom_world* world = nullptr;
  assert_int_equal(carom_world_fork(scene.b.world, &world, nullptr), CAROM_OK);
  carom_body own[2] = {scene.b.bodies[0], scene.b.bodies[3]};
  assert_int_equal(carom_world_translate_handles(world, own, 2, own, nullptr), CAROM_OK);
  for (int s = 0; s < steps; ++s) {
    double force[2][6] = {};
    for (int i = 0; i < 3; ++i) force[0][i] = push_of(k, s, i), force[1][i] = -push_of(k, s, i + 1);
    assert_int_equal(carom_world_write(world, CAROM_FIELD_FORCE, CAROM_SCALAR_F64, own, 2, force, 0, nullptr),
                     CAROM_OK);
    assert_int_equal(bench_steps(world, 1, nullptr), CAROM_OK);
  }
  const uint64_t hash = bench_hash(world);
  assert_int_equal(carom_world_destroy(world, nullptr), CAROM_OK);
  return hash;
}

/// Hashes of worlds `from` up to `from` + n, of pushes that belong to their numbers.
std::vector<uint64_t> pushed(const Scene& scene, uint64_t from, uint64_t n, int steps, bool reversed = false) {
  Batch batch(scene, n);
  std::vector<double> force(n * 12);
  batch.column(CAROM_COLUMN_BODIES, CAROM_FIELD_FORCE, CAROM_WHEN_BEFORE_STEP, {scene.b.bodies[0], scene.b.bodies[3]},
               force.data());
  for (int s = 0; s < steps; ++s) {
    for (uint64_t k = 0; k < n; ++k)
      for (int i = 0; i < 3; ++i) {
        const uint64_t of = from + (reversed ? n - 1 - k : k);
        force[12 * k + uint64_t(i)] = push_of(of, s, i), force[12 * k + 6 + uint64_t(i)] = -push_of(of, s, i + 1);
      }
    assert_int_equal(batch.step(), 0);
  }
  std::vector<uint64_t> found = batch.hashes();
  if (reversed) std::reverse(found.begin(), found.end());
  return found;
}

constexpr int kSteps = 150;  // until some sleep

void each_world_does_what_it_would_do_alone(void**) {
  const Scene scene;
  std::vector<uint64_t> want;
  for (uint64_t k = 0; k < kWorlds; ++k) want.push_back(alone(scene, k, kSteps));
  assert_true(pushed(scene, 0, kWorlds, kSteps) == want);
  assert_true(pushed(scene, 0, kWorlds, kSteps, true) == want);
  for (uint64_t k = 0; k < kWorlds; ++k) assert_true(pushed(scene, k, 1, kSteps) == std::vector<uint64_t>{want[k]});
}

void backwards(void*, carom_job_fn job, void* context, uint32_t count) {
  while (count-- > 0) job(context, count, count + 1);
}
void twice_and_too_far(void*, carom_job_fn job, void* context, uint32_t count) {
  job(context, count / 2, 0xFFFFFFFFu);
  job(context, 0, count);
}
void not_at_all(void*, carom_job_fn, void*, uint32_t) {}
void on_new_threads(void*, carom_job_fn job, void* context, uint32_t count) {
  std::vector<std::thread> threads;
  for (uint32_t i = 0; i < count; ++i) threads.emplace_back([=] { job(context, i, i + 1); });
  for (std::thread& t : threads) t.join();
}

void threads_change_no_bit(void**) {
  std::vector<uint64_t> want;
  {
    const Scene scene;
    want = pushed(scene, 0, kWorlds, 60);
  }
  carom_jobs_desc jobs;
  for (const uint32_t threads : {2u, 3u, 5u}) {
    carom_jobs_desc_init(&jobs, sizeof jobs);
    jobs.threads = threads;
    const Scene scene(nullptr, &jobs);
    assert_true(pushed(scene, 0, kWorlds, 60) == want);
  }
  for (const auto run : {backwards, twice_and_too_far, not_at_all, on_new_threads}) {
    carom_jobs_desc_init(&jobs, sizeof jobs);
    jobs.run = run;
    const Scene scene(nullptr, &jobs);
    assert_true(pushed(scene, 0, kWorlds, 60) == want);
  }
}

/// So many that a part of the loop has several.
void hundreds_of_worlds(void**) {
  std::vector<uint64_t> want;
  for (const uint32_t threads : {1u, 3u}) {
    carom_jobs_desc jobs;
    carom_jobs_desc_init(&jobs, sizeof jobs);
    jobs.threads = threads;
    const Scene scene(nullptr, &jobs);
    Batch batch(scene, 700);
    std::vector<double> speed(700 * 3);
    for (std::size_t k = 0; k < speed.size(); ++k) speed[k] = std::sin(0.37 * double(k)) * 3;
    const uint32_t column = batch.column(CAROM_COLUMN_BODIES, CAROM_FIELD_LINEAR_VELOCITY, CAROM_WHEN_ON_CALL,
                                         {scene.b.bodies[2]}, speed.data());
    assert_int_equal(carom_batch_write(batch.batch, &column, 1, nullptr, nullptr), CAROM_OK);
    batch.step(6);
    const std::vector<uint64_t> found = batch.hashes();
    if (want.empty()) want = found;
    assert_true(found == want && found[0] != found[1] && found[698] != found[699]);
  }
}

void worlds_of_two_structures(void**) {
  const Scene scene;
  Batch batch(scene, 3);
  carom_world* small = nullptr;
  carom_body ball;
  carom_collider collider;
  assert_int_equal(carom_world_create(scene.b.engine, nullptr, &small, nullptr), CAROM_OK);
  assert_int_equal(bench_body(small, scene.b.ball, 0, CAROM_BODY_DYNAMIC, 0, 5, 0, &ball, &collider, nullptr),
                   CAROM_OK);
  uint64_t first = 0;
  assert_int_equal(carom_batch_add_worlds(batch.batch, small, 2, &first, nullptr), CAROM_OK);
  assert_int_equal(first, 3);
  batch.n = 5;
  double place[2][3] = {}, others[3][3] = {};
  batch.column(CAROM_COLUMN_BODIES, CAROM_FIELD_POSITION, CAROM_WHEN_AFTER_STEP, {ball}, place[0], nullptr, 4);
  batch.column(CAROM_COLUMN_BODIES, CAROM_FIELD_POSITION, CAROM_WHEN_AFTER_STEP, {scene.b.bodies[1]}, others[0]);
  assert_int_equal(batch.step(10), 0);
  assert_int_equal(bench_steps(small, 10, nullptr), CAROM_OK);
  assert_int_equal(bench_steps(scene.b.world, 10, nullptr), CAROM_OK);
  const std::vector<uint64_t> hash = batch.hashes();
  assert_true(hash[0] == bench_hash(scene.b.world) && hash[2] == hash[0]);
  assert_true(hash[3] == bench_hash(small) && hash[4] == hash[3]);
  double at[3];
  assert_int_equal(carom_world_read(small, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, &ball, 1, at, 0, nullptr), CAROM_OK);
  assert_memory_equal(place[0], at, sizeof at);
  assert_memory_equal(place[1], at, sizeof at);
  assert_int_equal(carom_world_destroy(small, nullptr), CAROM_OK);
  assert_int_equal(carom_shape_destroy(scene.b.engine, scene.b.ball, nullptr), CAROM_E_IN_USE);
  assert_int_equal(batch.step(), 0);  // without the world that it is a copy of
}

void masks_and_starts(void**) {
  const Scene scene;
  Batch batch(scene, 4);
  double place[4][3] = {};
  batch.column(CAROM_COLUMN_BODIES, CAROM_FIELD_POSITION, CAROM_WHEN_AFTER_STEP, {scene.b.bodies[1]}, place[0]);
  const std::vector<uint64_t> begin = batch.hashes();
  const uint8_t some[4] = {0, 1, 0, 1};
  batch.step(20, some);
  std::vector<uint64_t> now = batch.hashes();
  assert_true(now[0] == begin[0] && now[2] == begin[2] && now[1] != begin[1] && now[3] == now[1]);
  assert_true(place[0][1] == 0 && place[1][1] > 0);  // rows of others are left alone
  uint64_t size = 0;
  assert_int_equal(carom_batch_save(batch.batch, 1, nullptr, 0, &size, nullptr), CAROM_OK);
  std::vector<char> bytes(size);
  assert_int_equal(carom_batch_save(batch.batch, 1, bytes.data(), size, &size, nullptr), CAROM_OK);
  uint32_t start = 0;
  assert_int_equal(carom_batch_add_start(batch.batch, 0, bytes.data(), size, &start, nullptr), CAROM_OK);
  assert_int_equal(start, 1);
  batch.step(20, some);
  const uint32_t starts[4] = {1, 0, 0, 1};
  const uint8_t all_but_one[4] = {1, 1, 0, 1};
  assert_int_equal(carom_batch_reset(batch.batch, all_but_one, starts, nullptr), CAROM_OK);
  const std::vector<uint64_t> after = batch.hashes();
  assert_true(after[0] == now[1] && after[1] == begin[1] && after[2] == begin[2] && after[3] == now[1]);
  assert_true(place[0][1] == place[3][1] && place[1][1] > place[3][1]);  // rows are told anew
  // The snapshot is one of the world that was copied: both go on alike.
  assert_int_equal(carom_world_restore(scene.b.world, bytes.data(), size, nullptr), CAROM_OK);
  assert_true(bench_hash(scene.b.world) == after[0]);
  batch.step(30);
  assert_int_equal(bench_steps(scene.b.world, 30, nullptr), CAROM_OK);
  assert_true(batch.hashes()[0] == bench_hash(scene.b.world));
}

/// Gravity, friction, masses, poses of scenery, gains: of each world its own, as if they were set there.
void parameters_of_each_world(void**) {
  const Scene scene;
  const Bench& b = scene.b;
  Batch batch(scene, 3);
  double gravity[3][3] = {{0, -9.81, 0}, {0, -1.6, 0}, {1, -9.81, 0.5}}, mass[3] = {2, 0.5, 31}, material[3][2] = {},
         ground[3][7], motor[3][3] = {{1, 0.5, 1}, {1, -0.5, 2}, {0, 0, 0}};
  double usual = 0;
  assert_int_equal(carom_world_read(b.world, CAROM_FIELD_MASS, CAROM_SCALAR_F64, &b.bodies[3], 1, &usual, 0, nullptr),
                   CAROM_OK);
  mass[1] = usual;
  for (int k = 0; k < 3; ++k) {
    material[k][0] = 0.1 + 0.3 * k, material[k][1] = 0.2 * k;
    const double tilt[7] = {0, -0.1 * k, 0, 0, 0, std::sin(0.05 * k), std::cos(0.05 * k)};
    std::copy(tilt, tilt + 7, ground[k]);
  }
  const uint32_t columns[5] = {
      batch.column(CAROM_COLUMN_GRAVITY, 0, CAROM_WHEN_ON_CALL, {}, gravity[0]),
      batch.column(CAROM_COLUMN_MASSES, 0, CAROM_WHEN_ON_CALL, {b.bodies[3]}, mass),
      batch.column(CAROM_COLUMN_MATERIALS, 0, CAROM_WHEN_ON_CALL, {b.material}, material[0]),
      batch.column(CAROM_COLUMN_BODIES, CAROM_FIELD_POSE, CAROM_WHEN_ON_CALL, {b.ground}, ground[0]),
      batch.column(CAROM_COLUMN_JOINTS, CAROM_JOINT_BULK_MOTOR, CAROM_WHEN_ON_CALL, {b.joint}, motor[0])};
  assert_int_equal(carom_batch_write(batch.batch, columns, 5, nullptr, nullptr), CAROM_OK);
  batch.step(80);
  std::vector<uint64_t> want;
  for (uint64_t k = 0; k < 3; ++k) {
    carom_world* world = nullptr;
    assert_int_equal(carom_world_fork(b.world, &world, nullptr), CAROM_OK);
    uint64_t own[4] = {b.bodies[3], b.material, b.ground, b.joint};
    assert_int_equal(carom_world_translate_handles(world, own, 4, own, nullptr), CAROM_OK);
    carom_material_desc desc;
    carom_material_desc_init(&desc, sizeof desc);
    desc.friction = material[k][0], desc.restitution = material[k][1];
    assert_int_equal(carom_world_set_gravity(world, gravity[k], nullptr), CAROM_OK);
    if (k != 1) assert_int_equal(carom_body_set_mass(world, own[0], mass[k], nullptr, nullptr, nullptr), CAROM_OK);
    assert_int_equal(carom_material_update(world, own[1], &desc, nullptr), CAROM_OK);
    assert_int_equal(carom_world_write(world, CAROM_FIELD_POSE, CAROM_SCALAR_F64, &own[2], 1, ground[k], 0, nullptr),
                     CAROM_OK);
    assert_int_equal(
        carom_world_write_joints(world, CAROM_JOINT_BULK_MOTOR, CAROM_SCALAR_F64, &own[3], 1, motor[k], 0, nullptr),
        CAROM_OK);
    assert_int_equal(bench_steps(world, 80, nullptr), CAROM_OK);
    want.push_back(bench_hash(world));
    assert_int_equal(carom_world_destroy(world, nullptr), CAROM_OK);
  }
  assert_true(batch.hashes() == want);
  // Masses stay through a reset, and are read back.
  assert_int_equal(carom_batch_reset(batch.batch, nullptr, nullptr, nullptr), CAROM_OK);
  const double kept[3] = {mass[0], mass[1], mass[2]};
  double after[3] = {};
  batch.column(CAROM_COLUMN_MASSES, 0, CAROM_WHEN_AFTER_STEP, {b.bodies[3]}, after);
  assert_int_equal(carom_batch_reset(batch.batch, nullptr, nullptr, nullptr), CAROM_OK);
  assert_memory_equal(after, kept, sizeof after);
  mass[0] = mass[1] = mass[2] = 0;
  assert_int_equal(carom_batch_read(batch.batch, &columns[1], 1, nullptr, nullptr), CAROM_OK);
  assert_memory_equal(mass, kept, sizeof mass);
  batch.step(5);
}

void what_is_refused_changes_nothing(void**) {
  const Scene scene;
  Batch batch(scene, 3);
  double force[3][6] = {}, place[3][1] = {}, mass[3] = {1, 1, 1}, broken[3] = {};
  const std::vector<uint64_t> of = {scene.b.bodies[0]};
  batch.column(CAROM_COLUMN_BODIES, CAROM_FIELD_FORCE, CAROM_WHEN_BEFORE_STEP, of, force[0]);
  const uint32_t joint =
      batch.column(CAROM_COLUMN_JOINTS, CAROM_JOINT_BULK_POSITION, CAROM_WHEN_ON_CALL, {scene.b.joint}, place[0]);
  const uint32_t masses = batch.column(CAROM_COLUMN_MASSES, 0, CAROM_WHEN_ON_CALL, of, mass);
  const uint32_t read_only =
      batch.column(CAROM_COLUMN_JOINTS, CAROM_JOINT_BULK_BROKEN, CAROM_WHEN_ON_CALL, {scene.b.joint}, broken);
  const std::vector<uint64_t> before = batch.hashes();
  carom_error e = CAROM_ERROR_INIT;
  force[2][4] = std::nan("");
  assert_int_equal(carom_batch_step(batch.batch, nullptr, kStep, 1, nullptr, &e), CAROM_E_NOT_FINITE);
  assert_non_null(std::strstr(e.message, "world 2, column 0"));
  const uint8_t others[3] = {1, 1, 0};
  assert_int_equal(carom_batch_step(batch.batch, others, kStep, 1, nullptr, &e), CAROM_OK);  // it is not asked
  assert_int_equal(carom_batch_reset(batch.batch, nullptr, nullptr, nullptr), CAROM_OK);
  force[2][4] = 0;
  place[1][0] = 1e20;
  assert_int_equal(carom_batch_write(batch.batch, &joint, 1, nullptr, &e), CAROM_E_OUT_OF_RANGE);
  assert_non_null(std::strstr(e.message, "world 1"));
  place[1][0] = 0, mass[2] = 0;
  const uint32_t both[2] = {joint, masses};
  assert_int_equal(carom_batch_write(batch.batch, both, 2, nullptr, &e), CAROM_E_OUT_OF_RANGE);
  assert_int_equal(carom_batch_write(batch.batch, &read_only, 1, nullptr, &e), CAROM_E_UNSUPPORTED);
  const uint32_t starts[3] = {0, 1, 0};
  assert_int_equal(carom_batch_reset(batch.batch, nullptr, starts, &e), CAROM_E_OUT_OF_RANGE);
  assert_true(batch.hashes() == before);
}

/// A joint that broke in one world can't be moved there: no world is changed, and the world is named.
void a_move_that_one_world_forbids(void**) {
  const Scene scene;
  carom_world* world = nullptr;
  assert_int_equal(carom_world_fork(scene.b.world, &world, nullptr), CAROM_OK);
  carom_joint own = scene.b.joint;
  assert_int_equal(carom_world_translate_handles(world, &own, 1, &own, nullptr), CAROM_OK);
  carom_joint_state state = {};
  state.struct_size = sizeof state;
  carom_joint_desc weak;
  carom_joint_desc_init(&weak, sizeof weak);
  // The same structure, with a joint that a pull of 1 N breaks.
  assert_int_equal(carom_joint_get(world, own, &weak, nullptr), CAROM_OK);
  assert_int_equal(carom_joint_destroy(world, own, nullptr), CAROM_OK);
  weak.break_force = 1;
  assert_int_equal(carom_joint_create(world, &weak, &own, nullptr), CAROM_OK);
  carom_batch* batch = nullptr;
  uint64_t first;
  assert_int_equal(carom_batch_create(scene.b.engine, &batch, nullptr), CAROM_OK);
  assert_int_equal(carom_batch_add_worlds(batch, world, 3, &first, nullptr), CAROM_OK);
  carom_body body = scene.b.bodies[0];
  assert_int_equal(carom_world_translate_handles(world, &body, 1, &body, nullptr), CAROM_OK);
  double force[3][6] = {}, place[3] = {0.1, 0.1, 0.1};
  force[1][1] = 1e4;
  carom_batch_column d;
  carom_batch_column_init(&d, sizeof d);
  d.source = CAROM_COLUMN_BODIES, d.field = CAROM_FIELD_FORCE, d.when = CAROM_WHEN_BEFORE_STEP, d.handles = &body;
  d.n = 1, d.data = force;
  assert_int_equal(carom_batch_add_column(batch, &d, nullptr, nullptr), CAROM_OK);
  d.source = CAROM_COLUMN_JOINTS, d.field = CAROM_JOINT_BULK_POSITION, d.when = CAROM_WHEN_ON_CALL, d.handles = &own;
  d.data = place;
  uint32_t column = 0;
  assert_int_equal(carom_batch_add_column(batch, &d, &column, nullptr), CAROM_OK);
  const uint8_t middle[3] = {0, 1, 0}, others[3] = {1, 0, 1};
  assert_int_equal(carom_batch_step(batch, middle, kStep, 1, nullptr, nullptr), CAROM_OK);
  uint64_t before[3], after[3];
  assert_int_equal(carom_batch_get_hashes(batch, before, 3, nullptr), CAROM_OK);
  carom_error e = CAROM_ERROR_INIT;
  assert_int_equal(carom_batch_write(batch, &column, 1, nullptr, &e), CAROM_E_UNSUPPORTED);
  assert_non_null(std::strstr(e.message, "world 1"));
  assert_non_null(std::strstr(e.message, "broken"));
  assert_int_equal(carom_batch_get_hashes(batch, after, 3, nullptr), CAROM_OK);
  assert_memory_equal(before, after, sizeof before);
  assert_int_equal(carom_batch_write(batch, &column, 1, others, &e), CAROM_OK);
  assert_int_equal(carom_batch_destroy(batch, nullptr), CAROM_OK);
  assert_int_equal(carom_world_destroy(world, nullptr), CAROM_OK);
}

void a_fault_stops_its_world_and_no_other(void**) {
  const Scene scene;
  Batch batch(scene, 4), calm(scene, 4);
  double speed[4][3] = {};
  speed[2][0] = 1e12;  // beyond what a step allows
  const uint32_t column =
      batch.column(CAROM_COLUMN_BODIES, CAROM_FIELD_LINEAR_VELOCITY, CAROM_WHEN_ON_CALL, {scene.b.bodies[1]}, speed[0]);
  const uint8_t third[4] = {0, 0, 1, 0};
  assert_int_equal(carom_batch_write(batch.batch, &column, 1, third, nullptr), CAROM_OK);
  assert_int_equal(batch.step(3), 1);
  const std::vector<uint64_t> stopped = batch.hashes();
  double force[4][6] = {};
  batch.column(CAROM_COLUMN_BODIES, CAROM_FIELD_FORCE, CAROM_WHEN_BEFORE_STEP, {scene.b.bodies[0]}, force[0]);
  force[2][0] = std::nan("");  // of a world that does not step: not asked
  assert_int_equal(batch.step(3), 1);
  force[2][0] = 0;
  calm.step(6);
  const std::vector<uint64_t> now = batch.hashes(), want = calm.hashes();
  assert_true(now[2] == stopped[2] && now[0] == want[0] && now[1] == want[1] && now[3] == want[3]);
  uint32_t why[4];
  assert_int_equal(carom_batch_get_stopped(batch.batch, why, 4, nullptr), CAROM_OK);
  assert_true(why[0] == CAROM_STOPPED_NO && why[2] == CAROM_STOPPED_FAULT && why[3] == CAROM_STOPPED_NO);
  carom_fault faults[2] = {};
  uint64_t count = 0;
  assert_int_equal(carom_batch_get_faults(batch.batch, 2, faults, sizeof *faults, 2, &count, nullptr), CAROM_OK);
  assert_int_equal(count, 1);
  assert_int_equal(faults[0].kind, CAROM_FAULT_BODY_STATE);
  assert_true(faults[0].body == scene.b.bodies[1]);
  assert_int_equal(carom_batch_get_faults(batch.batch, 1, faults, sizeof *faults, 2, &count, nullptr), CAROM_OK);
  assert_int_equal(count, 0);
  assert_int_equal(carom_batch_reset(batch.batch, third, nullptr, nullptr), CAROM_OK);
  assert_int_equal(batch.step(6), 0);
  assert_true(batch.hashes()[2] == want[2]);
}

/// A ball at rest bears on the ground with its weight, and a ray down from it is as long as it is high.
void contact_forces_and_rays(void**) {
  const Scene scene;
  Batch batch(scene, 2);
  carom_world* world = nullptr;
  carom_body ball, ground;
  carom_collider collider;
  assert_int_equal(carom_world_create(scene.b.engine, nullptr, &world, nullptr), CAROM_OK);
  assert_int_equal(bench_body(world, scene.b.floor, 0, CAROM_BODY_STATIC, 0, 0, 0, &ground, &collider, nullptr),
                   CAROM_OK);
  assert_int_equal(bench_body(world, scene.b.ball, 0, CAROM_BODY_DYNAMIC, 0, 0.5, 0, &ball, &collider, nullptr),
                   CAROM_OK);
  uint64_t first = 0;
  assert_int_equal(carom_batch_add_worlds(batch.batch, world, 2, &first, nullptr), CAROM_OK);
  double force[2][2][3], distance[2][3], time[2], mass, place[2][3];
  const double rays[21] = {0, 0, 0, 0, -1, 0, 10, 3, 4, 0, 0, -2, 0, 5, 0, 9, 0, 0, 1, 0, 8};
  batch.column(CAROM_COLUMN_CONTACT_FORCES, 0, CAROM_WHEN_AFTER_STEP, {ball, ground}, force[0][0], nullptr, first);
  batch.column(CAROM_COLUMN_RAYS, 0, CAROM_WHEN_AFTER_STEP, {ball, 0, 0}, distance[0], rays, first);
  batch.column(CAROM_COLUMN_TIME, 0, CAROM_WHEN_AFTER_STEP, {}, time, nullptr, first);
  batch.column(CAROM_COLUMN_BODIES, CAROM_FIELD_POSITION, CAROM_WHEN_AFTER_STEP, {ball}, place[0], nullptr, first);
  batch.step(192);
  assert_int_equal(carom_world_read(world, CAROM_FIELD_MASS, CAROM_SCALAR_F64, &ball, 1, &mass, 0, nullptr), CAROM_OK);
  assert_true(std::fabs(force[1][0][1] - 9.81 * mass) < 1e-6 * mass &&
              std::fabs(force[1][1][1] + 9.81 * mass) < 1e-6 * mass);
  assert_true(std::fabs(distance[1][0] - place[1][1]) < 1e-9);  // 1e-9: half-spaces are met within rounding
  assert_true(std::fabs(distance[0][1] - 2) < 1e-9 && distance[0][2] == 8);
  assert_true(std::fabs(time[1] - 192 * kStep) < 1e-12);
  assert_int_equal(carom_world_destroy(world, nullptr), CAROM_OK);
}

// ---- memory ----

struct Memory {
  std::atomic<long> left{-1};  // allocations until one fails; below 0: none does
};
void* allocate(void* user, uint64_t size, uint64_t alignment) {
  auto& memory = *static_cast<Memory*>(user);
  if (memory.left >= 0 && memory.left-- == 0) return nullptr;
  return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}
void release(void*, void* p, uint64_t, uint64_t) { std::free(p); }

/// Whichever allocation fails, a world is as before the step or as after it, and a call says so.
void lack_of_memory(void**) {
  Memory memory;
  carom_engine_desc desc;
  carom_engine_desc_init(&desc, sizeof desc);
  desc.alloc = allocate, desc.free = release, desc.alloc_user = &memory;
  const Scene scene(&desc);
  int refused = 0, stopped_once = 0;
  for (long k = 0; k < 400; ++k) {
    Batch batch(scene, 2);
    double place[2][3];
    const uint32_t column =
        batch.column(CAROM_COLUMN_BODIES, CAROM_FIELD_POSITION, CAROM_WHEN_ON_CALL, {scene.b.bodies[0]}, place[0]);
    const std::vector<uint64_t> before =
        k % 2 ? batch.hashes() : std::vector<uint64_t>{};  // with a real world, or without
    uint64_t stopped = 0;
    memory.left = k;
    const int32_t r = carom_batch_step(batch.batch, nullptr, kStep, 1, &stopped, nullptr);
    const bool used = memory.left < 0;
    memory.left = -1;
    assert_true(r == CAROM_OK || r == CAROM_E_OUT_OF_MEMORY);
    refused += r != CAROM_OK, stopped_once += r == CAROM_OK && stopped > 0;
    const std::vector<uint64_t> after = batch.hashes();
    uint32_t why[2];
    assert_int_equal(carom_batch_get_stopped(batch.batch, why, 2, nullptr), CAROM_OK);
    for (std::size_t w = 0; w < 2 && k % 2; ++w)
      assert_true((after[w] == before[w]) == (r != CAROM_OK || why[w] == CAROM_STOPPED_MEMORY));
    memory.left = k % 23;
    const int32_t wrote = carom_batch_write(batch.batch, &column, 0, nullptr, nullptr);
    const int32_t reset = carom_batch_reset(batch.batch, nullptr, nullptr, nullptr);
    memory.left = -1;
    assert_true(wrote == CAROM_OK || wrote == CAROM_E_OUT_OF_MEMORY);
    assert_true(reset == CAROM_OK || reset == CAROM_E_OUT_OF_MEMORY);
    if (!used) break;
  }
  assert_true(refused > 0 && stopped_once > 3);
  for (long k = 0; k < 400; ++k) {  // what adds fails whole
    Batch batch(scene, 1);
    uint64_t first = 99;
    double gravity[3];
    carom_batch_column d;
    carom_batch_column_init(&d, sizeof d);
    d.source = CAROM_COLUMN_GRAVITY, d.n = 1, d.data = gravity;
    memory.left = k;
    const int32_t worlds = carom_batch_add_worlds(batch.batch, scene.b.world, 3, &first, nullptr);
    const int32_t column = worlds ? CAROM_OK : carom_batch_add_column(batch.batch, &d, nullptr, nullptr);
    const bool used = memory.left < 0;
    memory.left = -1;
    carom_batch_info info = {};
    info.struct_size = sizeof info;
    assert_int_equal(carom_batch_get_info(batch.batch, &info, nullptr), CAROM_OK);
    assert_int_equal(info.worlds, worlds ? 1 : 4);
    assert_int_equal(info.columns, worlds || column ? 0 : 1);
    batch.n = info.worlds;
    batch.step();
    if (!used) break;
  }
}

// ---- the wrong time ----

struct Nosy {
  carom_batch* batch = nullptr;
  std::atomic<int> reentrant{0}, busy{0}, others{0};
} nosy;

int32_t nosy_support(void*, const double* params, uint64_t count, const double dir[3], double out[3]) {
  if (nosy.batch) {
    uint32_t stopped[2];
    const int32_t here = carom_batch_get_stopped(nosy.batch, stopped, 2, nullptr);
    ++(here == CAROM_E_REENTRANT ? nosy.reentrant : nosy.others);
    if (nosy.busy + nosy.others < 3)
      std::thread([&] {
        const int32_t there = carom_batch_get_stopped(nosy.batch, stopped, 2, nullptr);
        ++(there == CAROM_E_BUSY ? nosy.busy : nosy.others);
      }).join();
  }
  return bench_box(nullptr, params, count, dir, out);
}

void calls_at_the_wrong_time(void**) {
  const Scene scene;
  const double half[3] = {0.3, 0.3, 0.3};
  const carom_shape_plugin plugin = bench_plugin("test.nosy", bench_box_params, 3, nullptr, nosy_support);
  carom_plugin handle;
  carom_shape shape;
  carom_body body;
  carom_collider collider;
  assert_int_equal(carom_plugin_register(scene.b.engine, &plugin, &handle, nullptr), CAROM_OK);
  assert_int_equal(carom_shape_create(scene.b.engine, handle, half, 3, &shape, nullptr), CAROM_OK);
  assert_int_equal(bench_body(scene.b.world, shape, 0, CAROM_BODY_DYNAMIC, 0, 0.3, 3, &body, &collider, nullptr),
                   CAROM_OK);
  Batch batch(scene, 2);
  nosy.batch = batch.batch;
  assert_int_equal(batch.step(3), 0);
  nosy.batch = nullptr;
  assert_true(nosy.reentrant > 3 && nosy.busy == 3 && nosy.others == 0);
  assert_int_equal(carom_engine_destroy(scene.b.engine, nullptr), CAROM_E_IN_USE);
}

/// Support functions of HOST_THREAD plugins are called on the calling thread, whatever threads the engine has.
std::thread::id caller;
std::atomic<int> elsewhere{0};
int32_t bound_support(void*, const double* params, uint64_t count, const double dir[3], double out[3]) {
  elsewhere += std::this_thread::get_id() != caller;
  return bench_box(nullptr, params, count, dir, out);
}
void host_thread_shapes_stay_on_the_calling_thread(void**) {
  caller = std::this_thread::get_id();
  carom_jobs_desc jobs;
  carom_jobs_desc_init(&jobs, sizeof jobs);
  jobs.threads = 3;
  const Scene scene(nullptr, &jobs);
  const double half[3] = {0.3, 0.3, 0.3};
  carom_shape_plugin plugin = bench_plugin("test.bound", bench_box_params, 3, nullptr, bound_support);
  plugin.flags = CAROM_PLUGIN_HOST_THREAD;
  carom_plugin handle;
  carom_shape shape;
  carom_body body;
  carom_collider collider;
  assert_int_equal(carom_plugin_register(scene.b.engine, &plugin, &handle, nullptr), CAROM_OK);
  assert_int_equal(carom_shape_create(scene.b.engine, handle, half, 3, &shape, nullptr), CAROM_OK);
  Batch batch(scene, 40);
  assert_int_equal(bench_body(scene.b.world, shape, 0, CAROM_BODY_DYNAMIC, 0, 0.3, 3, &body, &collider, nullptr),
                   CAROM_OK);
  uint64_t first;
  assert_int_equal(carom_batch_add_worlds(batch.batch, scene.b.world, 40, &first, nullptr), CAROM_OK);
  batch.n = 80;
  assert_int_equal(batch.step(5), 0);
  assert_int_equal(elsewhere, 0);
  const std::vector<uint64_t> hash = batch.hashes();
  assert_true(hash[0] == hash[39] && hash[40] == hash[79] && hash[0] != hash[40]);
}

void random_numbers_follow_from_their_keys(void**) {
  const uint64_t keys[9] = {5, 0, 0, 5, 1, 0, 5, 0, 1};
  double all[3][5], one[2];
  assert_int_equal(carom_random_fill(CAROM_RANDOM_NORMAL, keys, 3, 5, all[0], nullptr), CAROM_OK);
  assert_int_equal(carom_random_fill(CAROM_RANDOM_NORMAL, keys + 3, 1, 2, one, nullptr), CAROM_OK);
  assert_memory_equal(one, all[1], sizeof one);
  assert_true(all[0][0] != all[1][0] && all[0][0] != all[2][0] && all[1][0] != all[2][0]);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(each_world_does_what_it_would_do_alone),
      cmocka_unit_test(threads_change_no_bit),
      cmocka_unit_test(hundreds_of_worlds),
      cmocka_unit_test(worlds_of_two_structures),
      cmocka_unit_test(masks_and_starts),
      cmocka_unit_test(parameters_of_each_world),
      cmocka_unit_test(what_is_refused_changes_nothing),
      cmocka_unit_test(a_move_that_one_world_forbids),
      cmocka_unit_test(a_fault_stops_its_world_and_no_other),
      cmocka_unit_test(contact_forces_and_rays),
      cmocka_unit_test(lack_of_memory),
      cmocka_unit_test(calls_at_the_wrong_time),
      cmocka_unit_test(host_thread_shapes_stay_on_the_calling_thread),
      cmocka_unit_test(random_numbers_follow_from_their_keys),
  };
  return cmocka_run_group_tests_name("abi/batch", tests, nullptr, nullptr);
}
