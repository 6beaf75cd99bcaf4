// What does not come to its end: a thread that a callback ends or that is cancelled, a buffer that is too small, a stride
// that leads out of memory, a stack that is small. The process goes on, and so do the engine and its worlds.
#include <pthread.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <vector>

#include "bench.h"
#include "carom_test.h"

namespace {

/// What the support function of the box does when it is called for the `left`th time from now.
enum class Way { returns, exits, throws };
std::atomic<int> left{0};
std::atomic<Way> way{Way::returns};

int32_t leaving_box(void* user, const double* p, uint64_t n, const double dir[3], double out[3]) {
  if (way != Way::returns && left.fetch_sub(1) == 1) {
    if (way == Way::exits) pthread_exit(nullptr);
    throw std::runtime_error("a callback throws");
  }
  return bench_box(user, p, n, dir, out);
}

/// Five boxes without a declared form, which fall on one another.
struct Heap {
  carom_engine* engine = nullptr;
  carom_world* world = nullptr;
  carom_shape box = 0;
  carom_body body[5] = {};

  explicit Heap(uint32_t threads = 0) {
    way = Way::returns;
    carom_plugin plugin;
    const double half[3] = {0.5, 0.5, 0.5};
    static carom_shape_plugin made;
    made = bench_plugin("test.leaving", bench_box_params, 3, nullptr, leaving_box);
    assert_int_equal(carom_engine_create(nullptr, &engine, nullptr), CAROM_OK);
    if (threads) {
      carom_jobs_desc jobs;
      carom_jobs_desc_init(&jobs, sizeof jobs);
      jobs.threads = threads;
      assert_int_equal(carom_engine_set_jobs(engine, &jobs, nullptr), CAROM_OK);
    }
    assert_int_equal(carom_plugin_register(engine, &made, &plugin, nullptr), CAROM_OK);
    assert_int_equal(carom_shape_create(engine, plugin, half, 3, &box, nullptr), CAROM_OK);
    assert_int_equal(carom_world_create(engine, nullptr, &world, nullptr), CAROM_OK);
    for (int i = 0; i < 5; ++i) {
      carom_body_desc d;
      carom_body_desc_init(&d, sizeof d);
      d.position[1] = 1.01 * i, d.position[0] = 0.05 * i;
      d.type = i ? CAROM_BODY_DYNAMIC : CAROM_BODY_STATIC;
      assert_int_equal(carom_body_create(world, &d, &body[i], nullptr), CAROM_OK);
      carom_collider_desc c;
      carom_collider_desc_init(&c, sizeof c);
      c.shape = box, c.density = 1000;
      carom_collider collider;
      assert_int_equal(carom_collider_create(world, body[i], &c, &collider, nullptr), CAROM_OK);
    }
  }
  ~Heap() {
    way = Way::returns;
    assert_int_equal(carom_world_destroy(world, nullptr), CAROM_OK);
    assert_int_equal(carom_engine_destroy(engine, nullptr), CAROM_OK);
  }
  void goes_on() const {
    way = Way::returns;
    double p[3];
    for (int i = 0; i < 20; ++i) assert_int_equal(carom_world_step(world, 1. / 60, nullptr), CAROM_OK);
    for (const carom_body b : body) {
      assert_int_equal(carom_body_get_pose(world, b, p, nullptr, nullptr), CAROM_OK);
      assert_true(std::isfinite(p[0] + p[1] + p[2]) && p[1] > -1 && p[1] < 6);
    }
    uint64_t size = 0;
    assert_int_equal(carom_world_save(world, CAROM_SNAPSHOT_WHOLE, nullptr, 0, &size, nullptr), CAROM_OK);
    carom_shape other;
    const double half[3] = {1, 1, 1};
    carom_plugin plugin;
    assert_int_equal(carom_plugin_find(engine, "test.leaving", &plugin, nullptr), CAROM_OK);
    assert_int_equal(carom_shape_create(engine, plugin, half, 3, &other, nullptr), CAROM_OK);
    assert_int_equal(carom_shape_destroy(engine, other, nullptr), CAROM_OK);
  }
};

void* step_on(void* heap) {
  for (int i = 0; i < 40; ++i) carom_world_step(static_cast<Heap*>(heap)->world, 1. / 60, nullptr);
  return heap;
}

void* run_thread(void* (*function)(void*), void* argument, std::size_t stack = 0) {
  pthread_attr_t attributes;
  pthread_t thread;
  void* result = nullptr;
  pthread_attr_init(&attributes);
  if (stack) assert_int_equal(pthread_attr_setstacksize(&attributes, stack), 0);
  assert_int_equal(pthread_create(&thread, &attributes, function, argument), 0);
  pthread_join(thread, &result);
  pthread_attr_destroy(&attributes);
  return result;
}

/// At whichever of its calls the support function ends the thread: in a bound, a pair, a sweep, with one thread or more.
void a_callback_ends_its_thread_and_nothing_else(void**) {
  for (const uint32_t threads : {0u, 3u})
    for (int at = 1; at < 4000; at = at * 3 / 2 + 1) {
      Heap heap(threads);
      left = at, way = Way::exits;
      run_thread(step_on, &heap);
      heap.goes_on();
    }
}

void a_callback_throws_and_the_call_says_so(void**) {
  for (const uint32_t threads : {0u, 3u})
    for (int at = 1; at < 4000; at = at * 3 + 1) {
      Heap heap(threads);
      left = at, way = Way::throws;
      int refused = 0;
      for (int i = 0; i < 40; ++i) {
        const int32_t r = carom_world_step(heap.world, 1. / 60, nullptr);
        refused += r == CAROM_E_INTERNAL;
        assert_true(r == CAROM_OK || r == CAROM_E_INTERNAL);
      }
      assert_true(left > 0 ? refused == 0 : refused == 1);
      heap.goes_on();
    }
}

void* step_for_ever(void* heap) {
  for (;;) carom_world_step(static_cast<Heap*>(heap)->world, 1. / 60, nullptr);
}
void* step_for_ever_at_risk(void* heap) {
  pthread_setcanceltype(PTHREAD_CANCEL_ASYNCHRONOUS, nullptr);
  return step_for_ever(heap);
}

/// Nothing in the loop but our call: it ends the thread, after the step.
void a_thread_that_is_cancelled_finishes_its_step(void**) {
  for (const auto loop : {step_for_ever, step_for_ever_at_risk})
    for (int i = 0; i < 5; ++i) {
      Heap heap;
      pthread_t thread;
      void* result = nullptr;
      assert_int_equal(pthread_create(&thread, nullptr, loop, &heap), 0);
      std::this_thread::sleep_for(std::chrono::milliseconds(3 * i));
      assert_int_equal(pthread_cancel(thread), 0);
      assert_int_equal(pthread_join(thread, &result), 0);
      assert_ptr_equal(result, PTHREAD_CANCELED);
      heap.goes_on();
    }
}

void a_buffer_that_is_too_small_stays_as_it_was(void**) {
  Heap heap;
  for (int i = 0; i < 30; ++i) carom_world_step(heap.world, 1. / 60, nullptr);
  for (const uint32_t flags : {CAROM_SNAPSHOT_STATE, CAROM_SNAPSHOT_WHOLE}) {
    uint64_t size = 0, needed = 0;
    assert_int_equal(carom_world_save(heap.world, flags, nullptr, 0, &size, nullptr), CAROM_OK);
    for (const uint64_t capacity : {size - 1, size - 9, size / 2, uint64_t(33), uint64_t(1), uint64_t(0)}) {
      std::vector<unsigned char> bytes(size, 0xA5);
      assert_int_equal(carom_world_save(heap.world, flags, bytes.data(), capacity, &needed, nullptr),
                       CAROM_E_BUFFER_TOO_SMALL);
      assert_true(needed == size);
      for (const unsigned char byte : bytes) assert_int_equal(byte, 0xA5);
    }
    std::vector<unsigned char> bytes(size, 0xA5);
    assert_int_equal(carom_world_save(heap.world, flags, bytes.data(), size, &needed, nullptr), CAROM_OK);
  }
}

void a_stride_that_leads_out_of_memory_is_refused(void**) {
  Heap heap;
  carom_error error = CAROM_ERROR_INIT;
  double numbers[64] = {};
  const carom_body two[2] = {heap.body[1], heap.body[2]};
  constexpr uint64_t kOne = 1;
  for (const uint64_t stride : {kOne << 63, ~uint64_t(7), kOne << 62, kOne << 40, kOne << 31}) {
    assert_int_equal(
        carom_world_read(heap.world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, two, 2, numbers, stride, &error),
        CAROM_E_OUT_OF_RANGE);
    assert_int_equal(error.argument, 7);
    assert_int_equal(
        carom_world_write(heap.world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, two, 2, numbers, stride, &error),
        CAROM_E_OUT_OF_RANGE);
    assert_int_equal(error.argument, 7);
    carom_particles set;
    assert_int_equal(carom_particles_create(heap.world, nullptr, &set, nullptr), CAROM_OK);
    assert_int_equal(carom_particles_add(heap.world, set, 2, CAROM_SCALAR_F64, numbers, stride, nullptr, 0, &error),
                     CAROM_E_OUT_OF_RANGE);
    assert_int_equal(error.argument, 6);
    uint64_t count = 0;
    carom_contact contact;
    assert_int_equal(carom_world_get_contacts(heap.world, &contact, stride, 1, &count, &error), CAROM_E_OUT_OF_RANGE);
    assert_int_equal(error.argument, 3);
  }
  for (const uint64_t n : {uint64_t(1) << 61, uint64_t(1) << 63, ~uint64_t(0)}) {
    assert_int_equal(carom_world_read(heap.world, CAROM_FIELD_POSITION, CAROM_SCALAR_F64, two, n, numbers, 0, &error),
                     CAROM_E_OUT_OF_RANGE);
    assert_int_equal(error.argument, 5);
  }
}

/// A stack of the least size that ABI.md states: half of it is left for the sanitizers' frames, which are larger.
#ifdef CAROM_SANITIZED
constexpr std::size_t kLeastStack = 2048 * 1024;
#else
constexpr std::size_t kLeastStack = 256 * 1024;
#endif

void* all_solvers(void* argument) {
  Heap& heap = *static_cast<Heap*>(argument);
  carom_dial_info info = {};
  info.struct_size = sizeof info;
  carom_dial_get_info(CAROM_DIAL_SOLVER, &info, nullptr);
  for (double solver = info.min; solver <= info.max; ++solver) {
    if (carom_world_set_dial(heap.world, CAROM_DIAL_SOLVER, solver, nullptr) != CAROM_OK) continue;
    for (int i = 0; i < 20; ++i)
      if (carom_world_step(heap.world, 1. / 60, nullptr) != CAROM_OK) return nullptr;
  }
  uint64_t size = 0;
  if (carom_world_save(heap.world, CAROM_SNAPSHOT_WHOLE, nullptr, 0, &size, nullptr) != CAROM_OK) return nullptr;
  std::vector<char> bytes(size);
  carom_world* copy = nullptr;
  if (carom_world_save(heap.world, CAROM_SNAPSHOT_WHOLE, bytes.data(), size, &size, nullptr) != CAROM_OK ||
      carom_world_restore(heap.world, bytes.data(), size, nullptr) != CAROM_OK ||
      carom_world_fork(heap.world, &copy, nullptr) != CAROM_OK || carom_world_destroy(copy, nullptr) != CAROM_OK)
    return nullptr;
  const double half[3] = {1, 2, 3}, zero[3] = {0, 0, 0}, up[3] = {0, 9, 0}, down[3] = {0, -1, 0}, q[4] = {0, 0, 0, 1};
  carom_plugin plugin;
  carom_shape shape;
  carom_cast cast = {};
  cast.struct_size = sizeof cast;
  if (carom_plugin_find(heap.engine, "test.leaving", &plugin, nullptr) != CAROM_OK ||
      carom_shape_create(heap.engine, plugin, half, 3, &shape, nullptr) != CAROM_OK ||
      carom_ray_cast(heap.engine, shape, zero, q, up, down, 100, nullptr, &cast, nullptr) != CAROM_OK ||
      carom_shape_cast(heap.engine, shape, up, q, down, heap.box, zero, q, nullptr, &cast, nullptr) != CAROM_OK ||
      carom_shape_destroy(heap.engine, shape, nullptr) != CAROM_OK)
    return nullptr;
  return argument;
}

void a_small_stack_is_enough(void**) {
  Heap heap;
  assert_ptr_equal(run_thread(all_solvers, &heap, kLeastStack), &heap);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_callback_ends_its_thread_and_nothing_else),
      cmocka_unit_test(a_callback_throws_and_the_call_says_so),
      cmocka_unit_test(a_thread_that_is_cancelled_finishes_its_step),
      cmocka_unit_test(a_buffer_that_is_too_small_stays_as_it_was),
      cmocka_unit_test(a_stride_that_leads_out_of_memory_is_refused),
      cmocka_unit_test(a_small_stack_is_enough),
  };
  return cmocka_run_group_tests_name("abi/leaving", tests, nullptr, nullptr);
}
