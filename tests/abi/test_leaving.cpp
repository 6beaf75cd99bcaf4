// What does not come to its end: a thread that a callback ends or that is cancelled, a buffer that is too small, a stride
// that leads out of memory, a stack that is small. The process goes on, and so do the engine and its worlds.
#include <pthread.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <set>
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

  explicit Heap(uint32_t threads = 0, const carom_engine_desc* desc = nullptr) {
    way = Way::returns;
    carom_plugin plugin;
    const double half[3] = {0.5, 0.5, 0.5};
    static carom_shape_plugin made;
    made = bench_plugin("test.leaving", bench_box_params, 3, nullptr, leaving_box);
    assert_int_equal(carom_engine_create(desc, &engine, nullptr), CAROM_OK);
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

/// All that read a few numbers, of each kind of thing.
void read_all(const Heap& heap, const carom_body body) {
  carom_world* const w = heap.world;
  double v[9], linear, angular;
  uint32_t word;
  uint64_t count;
  carom_body_desc desc;
  carom_body_desc_init(&desc, sizeof desc);
  assert_int_equal(carom_body_get(w, body, &desc, nullptr), CAROM_OK);
  assert_int_equal(carom_body_get_pose(w, body, v, v + 3, nullptr), CAROM_OK);
  assert_int_equal(carom_body_get_velocity(w, body, v, v + 3, nullptr), CAROM_OK);
  assert_int_equal(carom_body_get_mass(w, body, nullptr, nullptr, v, nullptr), CAROM_OK);
  assert_int_equal(carom_body_get_type(w, body, &word, nullptr), CAROM_OK);
  assert_int_equal(carom_body_get_damping(w, body, &linear, &angular, nullptr), CAROM_OK);
  assert_int_equal(carom_body_get_user(w, body, &count, nullptr), CAROM_OK);
  assert_int_equal(carom_body_get_gravity_factor(w, body, &linear, nullptr), CAROM_OK);
  assert_int_equal(carom_body_get_locks(w, body, &word, nullptr), CAROM_OK);
  assert_int_equal(carom_body_get_drag(w, body, &linear, &angular, nullptr), CAROM_OK);
  assert_int_equal(carom_body_get_force_field_mask(w, body, &word, nullptr), CAROM_OK);
  assert_int_equal(carom_body_get_attribute(w, body, 0, v, nullptr), CAROM_OK);
  assert_int_equal(carom_body_get_continuous(w, body, &word, nullptr), CAROM_OK);
  assert_int_equal(carom_body_get_effect(w, body, CAROM_EFFECT_GRAVITY, &word, nullptr), CAROM_OK);
  assert_int_equal(carom_body_is_asleep(w, body, &word, nullptr), CAROM_OK);
  assert_int_equal(carom_body_is_enabled(w, body, &word, nullptr), CAROM_OK);
  carom_collider collider;
  assert_int_equal(carom_body_get_colliders(w, body, &collider, 1, &count, nullptr), CAROM_OK);
  carom_collider_desc piece;
  carom_collider_desc_init(&piece, sizeof piece);
  carom_body of;
  uint64_t mask;
  int32_t group;
  assert_int_equal(carom_collider_get(w, collider, &piece, &of, nullptr), CAROM_OK);
  assert_int_equal(carom_collider_get_surface_velocity(w, collider, v, v + 3, nullptr), CAROM_OK);
  assert_int_equal(carom_collider_get_filter(w, collider, &count, &mask, &group, nullptr), CAROM_OK);
  assert_int_equal(carom_collider_is_sensor(w, collider, &word, nullptr), CAROM_OK);
  carom_water water;
  carom_water_init(&water, sizeof water);
  assert_int_equal(carom_world_get_gravity(w, v, nullptr), CAROM_OK);
  assert_int_equal(carom_world_get_wind(w, v, nullptr), CAROM_OK);
  assert_int_equal(carom_world_get_water(w, &water, &word, nullptr), CAROM_OK);
  assert_int_equal(carom_world_get_dial(w, CAROM_DIAL_SOLVER, v, nullptr), CAROM_OK);
  assert_int_equal(carom_world_get_effect(w, CAROM_EFFECT_GRAVITY, &word, nullptr), CAROM_OK);
}

std::atomic<int> read_before_the_end{0};
void* read_and_step(void* argument) {
  const Heap& heap = *static_cast<Heap*>(argument);
  pthread_cancel(pthread_self());
  for (int i = 0; i < 100; ++i, ++read_before_the_end) read_all(heap, heap.body[i % 5]);
  carom_world_step(heap.world, 1. / 60, nullptr);
  return argument;  // it does not come here
}
/// Of a thread that is cancelled already: what reads goes on, the step is the end of it, and is done.
void what_reads_does_not_look_whether_it_is_cancelled(void**) {
  Heap heap;
  read_before_the_end = 0;
  assert_ptr_equal(run_thread(read_and_step, &heap), PTHREAD_CANCELED);
  assert_int_equal(read_before_the_end, 100);
  carom_step_report report = {};
  report.struct_size = sizeof report;
  assert_int_equal(carom_world_get_report(heap.world, &report, nullptr), CAROM_OK);
  assert_int_equal(report.steps, 1);
  heap.goes_on();
}

/// Threads that read are cancelled at any time, while another one does nothing but read.
void* read_for_ever(void* argument) {
  const Heap& heap = *static_cast<Heap*>(argument);
  for (int i = 0;; ++i) {
    read_all(heap, heap.body[i % 5]);
    pthread_testcancel();
  }
}
void readers_that_are_cancelled_leave_the_world_to_others(void**) {
  for (int i = 0; i < 8; ++i) {
    Heap heap;
    pthread_t thread[3];
    for (pthread_t& t : thread) assert_int_equal(pthread_create(&t, nullptr, read_for_ever, &heap), 0);
    std::this_thread::sleep_for(std::chrono::microseconds(300 * i));
    for (const pthread_t t : thread) assert_int_equal(pthread_cancel(t), 0);
    for (const pthread_t t : thread) assert_int_equal(pthread_join(t, nullptr), 0);
    heap.goes_on();
  }
}

std::atomic<int> asked{0};
void* counted_alloc(void*, uint64_t size, uint64_t alignment) {
  ++asked;
  return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}
void counted_free(void*, void* p, uint64_t, uint64_t) {
  ++asked;
  std::free(p);
}
/// Nothing of the host's is called, so there is nothing that could end the thread.
void what_reads_asks_for_no_memory(void**) {
  carom_engine_desc desc;
  carom_engine_desc_init(&desc, sizeof desc);
  desc.alloc = counted_alloc, desc.free = counted_free;
  Heap heap(0, &desc);
  for (int i = 0; i < 40; ++i) assert_int_equal(carom_world_step(heap.world, 1. / 60, nullptr), CAROM_OK);
  const int before = asked;
  assert_true(before > 0);
  for (const carom_body body : heap.body) read_all(heap, body);
  assert_int_equal(asked, before);
}

/// A size is remembered until something changes: after each change it is what the bytes take.
void a_size_is_that_of_the_state(void**) {
  Heap heap;
  carom_world* const w = heap.world;
  std::vector<uint64_t> seen;
  std::vector<unsigned char> old;
  const auto check = [&] {
    for (const uint32_t flags : {CAROM_SNAPSHOT_WHOLE, CAROM_SNAPSHOT_STATE}) {
      uint64_t size = 0, again = 0, needed = 0;
      assert_int_equal(carom_world_save(w, flags, nullptr, 0, &size, nullptr), CAROM_OK);
      std::vector<unsigned char> bytes(size, 0xA5);
      assert_int_equal(carom_world_save(w, flags, bytes.data(), size - 1, &again, nullptr), CAROM_E_BUFFER_TOO_SMALL);
      assert_true(again == size && bytes == std::vector<unsigned char>(size, 0xA5));
      assert_int_equal(carom_world_save(w, flags, bytes.data(), size, &needed, nullptr), CAROM_OK);
      assert_true(needed == size);
      carom_world* fork = nullptr;  // it knows nothing of what was counted here
      assert_int_equal(carom_world_fork(w, &fork, nullptr), CAROM_OK);
      assert_int_equal(carom_world_save(fork, flags, nullptr, 0, &needed, nullptr), CAROM_OK);
      assert_int_equal(carom_world_destroy(fork, nullptr), CAROM_OK);
      assert_true(needed == size);
      if (flags == CAROM_SNAPSHOT_STATE) seen.push_back(size), old = bytes;
    }
  };
  check();
  for (int i = 0; i < 12; ++i) {
    assert_int_equal(carom_world_step(w, 1. / 60, nullptr), CAROM_OK);
    check();
  }
  carom_body body;
  carom_body_desc d;
  carom_body_desc_init(&d, sizeof d);
  const std::vector<unsigned char> before = old;
  d.linear_drag = 1;
  d.position[0] = 50;
  assert_int_equal(carom_body_set_drag(w, heap.body[2], 1, 2, nullptr), CAROM_OK);
  check();
  assert_int_equal(carom_world_restore(w, before.data(), before.size(), nullptr), CAROM_OK);
  check();
  assert_true(old.size() == before.size());
  assert_int_equal(carom_body_create(w, &d, &body, nullptr), CAROM_OK);
  check();
  assert_int_equal(carom_body_destroy(w, body, nullptr), CAROM_OK);
  check();
  const double p[3] = {0, 30, 0}, q[4] = {0, 0, 0, 1};
  for (int i = 1; i < 5; ++i) {  // pairs go
    assert_int_equal(carom_body_set_pose(w, heap.body[i], p, q, nullptr), CAROM_OK);
    assert_int_equal(carom_world_step(w, 1. / 60, nullptr), CAROM_OK);
    check();
  }
  assert_true(std::set<uint64_t>(seen.begin(), seen.end()).size() > 3);
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
      cmocka_unit_test(what_reads_does_not_look_whether_it_is_cancelled),
      cmocka_unit_test(readers_that_are_cancelled_leave_the_world_to_others),
      cmocka_unit_test(what_reads_asks_for_no_memory),
      cmocka_unit_test(a_size_is_that_of_the_state),
      cmocka_unit_test(a_buffer_that_is_too_small_stays_as_it_was),
      cmocka_unit_test(a_stride_that_leads_out_of_memory_is_refused),
      cmocka_unit_test(a_small_stack_is_enough),
  };
  return cmocka_run_group_tests_name("abi/leaving", tests, nullptr, nullptr);
}
