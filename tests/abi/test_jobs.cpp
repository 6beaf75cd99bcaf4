// Steps shared by several threads: same bits for any number of them, whoever lends them and however he deals out the
// parts. (The thread sanitizer's run of this test is half the point of it.)
#include <atomic>
#include <thread>
#include <vector>

#include "bench.h"
#include "carom_test.h"

namespace {

/// Enough bodies that loops over them are shared: boxes and balls that fall into a heap, some of them bouncing, by a
/// lift.
struct Heap {
  Bench b;

  explicit Heap(const carom_jobs_desc* jobs) {
    b = {};
    assert_int_equal(carom_engine_create(nullptr, &b.engine, nullptr), CAROM_OK);
    assert_int_equal(carom_engine_set_jobs(b.engine, jobs, nullptr), CAROM_OK);
    assert_int_equal(bench_shapes(&b, nullptr), CAROM_OK);
    assert_int_equal(carom_world_create(b.engine, nullptr, &b.world, nullptr), CAROM_OK);
    carom_material_desc rubber;
    carom_material_desc_init(&rubber, sizeof rubber);
    rubber.restitution = 0.5;
    carom_material material;
    carom_body body;
    carom_collider collider;
    assert_int_equal(carom_material_create(b.world, &rubber, &material, nullptr), CAROM_OK);
    const auto add = [&](carom_shape shape, uint32_t type, double x, double y, double z, bool bounces) {
      assert_int_equal(bench_body(b.world, shape, bounces ? material : 0, type, x, y, z, &body, &collider, nullptr),
                       CAROM_OK);
    };
    add(b.floor, CAROM_BODY_STATIC, 0, 0, 0, false);
    add(b.crate, CAROM_BODY_KINEMATIC, 2, 0.3, 2, false);
    const double velocity[3] = {0.2, 0.1, 0}, spin[3] = {0, 0.5, 0};
    assert_int_equal(carom_body_set_velocity(b.world, body, velocity, spin, nullptr), CAROM_OK);
    assert_int_equal(carom_collider_set_surface_velocity(b.world, collider, velocity, spin, nullptr), CAROM_OK);
    for (int i = 0; i < 600; ++i)
      add(i % 3 ? b.crate : b.ball, CAROM_BODY_DYNAMIC, i % 10 * 0.9, 0.6 + 0.8 * (i / 100),
          i / 10 % 10 * 1.3 + 0.01 * i, i % 5 == 0);
    std::vector<double> places(3 * 20000);
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = 1e-3 * static_cast<double>(i * i % 10007);
    assert_int_equal(carom_particles_create(b.world, nullptr, &b.particles, nullptr), CAROM_OK);
    assert_int_equal(
        carom_particles_add(b.world, b.particles, 20000, CAROM_SCALAR_F64, places.data(), 0, places.data(), 0, nullptr),
        CAROM_OK);
  }
  /// Some of the crates and balls, each along and about one axis; others weigh half.
  void lock_some() {
    std::vector<carom_body> bodies(602);
    uint64_t count = 0;
    assert_int_equal(carom_world_get_bodies(b.world, bodies.data(), bodies.size(), &count, nullptr), CAROM_OK);
    assert_int_equal(count, bodies.size());
    for (std::size_t i = 2; i < bodies.size(); i += 7)
      assert_int_equal(carom_body_set_locks(b.world, bodies[i], 1u << i % 3 | 8u << i % 2, nullptr), CAROM_OK);
    for (std::size_t i = 3; i < bodies.size(); i += 11)
      assert_int_equal(carom_body_set_gravity_factor(b.world, bodies[i], 0.5, nullptr), CAROM_OK);
  }
  ~Heap() {
    assert_int_equal(carom_world_destroy(b.world, nullptr), CAROM_OK);
    assert_int_equal(carom_engine_destroy(b.engine, nullptr), CAROM_OK);
  }
};

constexpr uint32_t kSolvers[] = {CAROM_SOLVER_SEVERITY, CAROM_SOLVER_SOFT_STEP};

uint64_t hash_after(uint32_t solver, const carom_jobs_desc* jobs, uint32_t precision = CAROM_PRECISION_DOUBLE) {
  Heap heap(jobs);
  assert_int_equal(carom_world_set_dial(heap.b.world, CAROM_DIAL_PRECISION, precision, nullptr), CAROM_OK);
  assert_int_equal(carom_world_set_dial(heap.b.world, CAROM_DIAL_SOLVER, solver, nullptr), CAROM_OK);
  if (solver != CAROM_SOLVER_SEVERITY) {
    assert_int_equal(carom_world_set_dial(heap.b.world, CAROM_DIAL_SUBSTEPS, 2, nullptr), CAROM_OK);
    heap.lock_some();
  }
  assert_int_equal(bench_steps(heap.b.world, 40, nullptr), CAROM_OK);
  carom_step_report report;
  report.struct_size = sizeof report;
  assert_int_equal(carom_world_get_report(heap.b.world, &report, nullptr), CAROM_OK);
  assert_true(report.contact_points > 1000);  // all loops are long enough to be shared
  return bench_hash(heap.b.world);
}

carom_jobs_desc pool_of(uint32_t threads) {
  carom_jobs_desc desc;
  carom_jobs_desc_init(&desc, sizeof desc);
  desc.threads = threads;
  return desc;
}

void the_number_of_threads_does_not_change_a_bit(void**) {
  for (const uint32_t solver : kSolvers)
    for (const uint32_t precision : {CAROM_PRECISION_DOUBLE, CAROM_PRECISION_FLOAT}) {
      if (solver == CAROM_SOLVER_SEVERITY && precision == CAROM_PRECISION_FLOAT) continue;  // knows of none
      const uint64_t alone = hash_after(solver, nullptr, precision);
      for (const uint32_t threads : {2u, 4u}) {
        const carom_jobs_desc desc = pool_of(threads);
        assert_true(hash_after(solver, &desc, precision) == alone);
      }
    }
}

/// Ways in which a host may deal out parts, the last of them against the rules.
void backwards(void*, carom_job_fn job, void* context, uint32_t count) {
  while (count-- > 0) job(context, count, count + 1);
}
void on_new_threads(void* user, carom_job_fn job, void* context, uint32_t count) {
  ++*static_cast<std::atomic<int>*>(user);
  const uint32_t half = count / 2;
  std::thread other([&] { job(context, half, count); });
  job(context, 0, half);
  other.join();
}
void twice_and_too_far(void*, carom_job_fn job, void* context, uint32_t count) {
  job(context, count / 2, 0xFFFFFFFFu);
  job(context, 0, count);
}
void not_at_all(void*, carom_job_fn, void*, uint32_t) {}

void however_a_host_deals_out_the_parts_the_bits_are_the_same(void**) {
  const uint64_t alone = hash_after(CAROM_SOLVER_SOFT_STEP, nullptr);
  std::atomic<int> loops{0};
  for (const auto run : {backwards, on_new_threads, twice_and_too_far, not_at_all}) {
    carom_jobs_desc desc = pool_of(0);
    desc.run = run;
    desc.user = &loops;
    assert_true(hash_after(CAROM_SOLVER_SOFT_STEP, &desc) == alone);
  }
  assert_true(loops > 40 * 10);  // tens a step
}

void worlds_that_step_at_once_share_a_pool_without_waiting(void**) {
  const carom_jobs_desc desc = pool_of(3);
  const uint64_t alone = hash_after(CAROM_SOLVER_SOFT_STEP, nullptr, CAROM_PRECISION_AUTO);
  Heap first(&desc);
  std::atomic<int> wrong{0};
  const auto run = [&] {
    Bench b = first.b;  // its shapes
    wrong += carom_world_create(b.engine, nullptr, &b.world, nullptr) != CAROM_OK;
    wrong += bench_bodies(&b, nullptr) != CAROM_OK;
    for (int i = 0; i < 200; ++i) wrong += carom_world_step(b.world, 1.0 / 60, nullptr) != CAROM_OK;
    wrong += carom_world_destroy(b.world, nullptr) != CAROM_OK;
  };
  std::thread other(run);
  assert_int_equal(carom_world_set_dial(first.b.world, CAROM_DIAL_SOLVER, CAROM_SOLVER_SOFT_STEP, nullptr), CAROM_OK);
  assert_int_equal(carom_world_set_dial(first.b.world, CAROM_DIAL_SUBSTEPS, 2, nullptr), CAROM_OK);
  first.lock_some();
  assert_int_equal(bench_steps(first.b.world, 40, nullptr), CAROM_OK);
  other.join();
  assert_true(bench_hash(first.b.world) == alone);
  assert_int_equal(wrong, 0);
}

/// Boxes of a plugin, dropped on the heap in a layer of 14 x 14.
void drop_on(Heap& heap, const carom_shape_plugin& plugin, double y) {
  const double half[3] = {0.3, 0.3, 0.3};
  carom_plugin handle;
  carom_shape shape;
  carom_body body;
  carom_collider collider;
  assert_int_equal(carom_plugin_register(heap.b.engine, &plugin, &handle, nullptr), CAROM_OK);
  assert_int_equal(carom_shape_create(heap.b.engine, handle, half, 3, &shape, nullptr), CAROM_OK);
  for (int i = 0; i < 196; ++i)
    assert_int_equal(
        bench_body(heap.b.world, shape, 0, CAROM_BODY_DYNAMIC, i % 14, y, i / 14, &body, &collider, nullptr), CAROM_OK);
}

/// A call from a part, or from the callback itself.
struct Reentrant {
  carom_world* world = nullptr;
  std::atomic<int> calls{0}, refused{0};
} reentrant;

int32_t calling_support(void*, const double* params, uint64_t count, const double dir[3], double out[3]) {
  if (reentrant.world) {
    uint64_t hash;
    ++reentrant.calls;
    reentrant.refused += carom_world_hash(reentrant.world, &hash, nullptr) == CAROM_E_REENTRANT;
  }
  return bench_box(nullptr, params, count, dir, out);
}

void calls_from_a_part_are_reentrant_on_every_thread(void**) {
  const carom_jobs_desc desc = pool_of(4);
  Heap heap(&desc);
  drop_on(heap, bench_plugin("test.calls", bench_box_params, 3, nullptr, calling_support), 6);
  reentrant.world = heap.b.world;
  assert_int_equal(bench_steps(heap.b.world, 5, nullptr), CAROM_OK);
  reentrant.world = nullptr;
  assert_true(reentrant.calls > 1000);
  assert_int_equal(reentrant.refused, reentrant.calls);
}

struct Caller {
  std::thread::id stepping;
  std::atomic<int> here{0}, elsewhere{0};
} caller;

int32_t noting_support(void*, const double* params, uint64_t count, const double dir[3], double out[3]) {
  ++(std::this_thread::get_id() == caller.stepping ? caller.here : caller.elsewhere);
  return bench_box(nullptr, params, count, dir, out);
}

void a_shape_of_the_host_thread_is_asked_there_alone(void**) {
  const carom_jobs_desc desc = pool_of(4);
  caller.stepping = std::this_thread::get_id();
  carom_shape_plugin plugin = bench_plugin("test.host", bench_box_params, 3, nullptr, noting_support);
  plugin.flags = CAROM_PLUGIN_HOST_THREAD;
  uint64_t hashes[2];
  for (int shared = 0; shared < 2; ++shared) {
    Heap heap(shared ? &desc : nullptr);
    drop_on(heap, plugin, 5.5);
    caller.here = 0;
    assert_int_equal(bench_steps(heap.b.world, 20, nullptr), CAROM_OK);
    assert_true(caller.here > 1000);
    hashes[shared] = bench_hash(heap.b.world);
  }
  assert_int_equal(caller.elsewhere, 0);
  assert_true(hashes[0] == hashes[1]);
}

/// Misbehaves in one octant, but only once a world runs.
std::atomic<bool> lying{false};
int32_t lying_support(void*, const double* params, uint64_t count, const double dir[3], double out[3]) {
  if (lying && dir[0] > 0 && dir[1] < 0 && dir[2] > 0) return 7;
  return bench_box(nullptr, params, count, dir, out);
}

struct Told {
  carom_fault faults[8] = {};
  uint64_t count = 0, hash = 0;

  explicit Told(uint32_t threads) {
    const carom_jobs_desc desc = pool_of(threads);
    Heap heap(&desc);
    drop_on(heap, bench_plugin("test.invalid_plugin", bench_box_params, 3, nullptr, lying_support), 5.5);
    drop_on(heap, bench_plugin("test.invalid_plugin2", bench_box_params, 3, nullptr, lying_support), 5.9);
    lying = true;
    for (int i = 0; i < 20 && count == 0; ++i) {
      assert_int_equal(bench_steps(heap.b.world, 1, nullptr), CAROM_OK);
      assert_int_equal(carom_world_get_faults(heap.b.world, faults, sizeof *faults, 8, &count, nullptr), CAROM_OK);
    }
    lying = false;
    hash = bench_hash(heap.b.world);
  }
};

void faults_are_told_in_the_same_order_by_any_number_of_threads(void**) {
  const Told alone(1), shared(4);
  assert_true(alone.count > 0 && alone.count <= 8 && alone.count == shared.count);
  for (uint64_t i = 0; i < alone.count; ++i)
    for (int k = 0; k < 3; ++k) {
      assert_true(alone.faults[i].dir[k] == shared.faults[i].dir[k]);
      assert_true(alone.faults[i].out[k] == shared.faults[i].out[k]);
    }
  assert_true(alone.hash == shared.hash);
}

void pools_come_and_go_before_the_first_world(void**) {
  carom_engine* engine = nullptr;
  assert_int_equal(carom_engine_create(nullptr, &engine, nullptr), CAROM_OK);
  for (const uint32_t threads : {2u, 4u, 1u, 3u, 0u, 256u}) {
    const carom_jobs_desc desc = pool_of(threads);
    assert_int_equal(carom_engine_set_jobs(engine, &desc, nullptr), CAROM_OK);
  }
  assert_int_equal(carom_engine_set_jobs(engine, nullptr, nullptr), CAROM_OK);
  assert_int_equal(carom_engine_destroy(engine, nullptr), CAROM_OK);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(the_number_of_threads_does_not_change_a_bit),
      cmocka_unit_test(however_a_host_deals_out_the_parts_the_bits_are_the_same),
      cmocka_unit_test(worlds_that_step_at_once_share_a_pool_without_waiting),
      cmocka_unit_test(calls_from_a_part_are_reentrant_on_every_thread),
      cmocka_unit_test(a_shape_of_the_host_thread_is_asked_there_alone),
      cmocka_unit_test(faults_are_told_in_the_same_order_by_any_number_of_threads),
      cmocka_unit_test(pools_come_and_go_before_the_first_world),
  };
  return cmocka_run_group_tests_name("abi/jobs", tests, nullptr, nullptr);
}
