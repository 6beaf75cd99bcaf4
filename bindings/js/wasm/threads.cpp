// What carom.threads.wasm has beside carom.wasm: one pool of threads for all engines of the module, and the few
// functions of libc that emscripten would write in JavaScript. bindings/js/src/threads.js starts the workers and calls
// carom_js_*.
#include <pthread.h>
#include <time.h>

#include <atomic>
#include <cstdint>
#include <cstring>
#include <memory_resource>
#include <system_error>

#include "abi/engine.h"
#include "abi/guard.h"
#include "core/job_pool.h"

namespace {

using carom::core::JobPool;
using carom::core::Jobs;

/// A shape that the main thread has loaded. Tables of functions are a thread's own, so each thread loads it too, before
/// it does its next part.
struct SideModule {
  std::atomic<SideModule*> next;
  std::uint32_t size, table_base;
  // its bytes follow
};
constinit SideModule none{};
constinit thread_local SideModule* last_known = &none;

JobPool* pool = nullptr;  // for good: workers end with the page or by force
std::atomic<bool> crashed{false};

}  // namespace

extern "C" {

double emscripten_get_now();   // ms, since a fixed moment
double emscripten_date_now();  // ms, since 1970
void carom_js_bring(const void* bytes, std::uint32_t size, std::uint32_t table_base);

}  // extern "C"

namespace {

/// What an engine of the module has for jobs.
class SharedJobs final : public Jobs {
 public:
  void run(Task task, void* context, std::uint32_t count, std::uint32_t grain) override {
    if (!pool) return task(context, 0, count);
    Loop loop{task, context};
    pool->run(
        [](void* given, std::uint32_t begin, std::uint32_t end) {
          while (SideModule* next = last_known->next.load(std::memory_order_acquire)) {
            carom_js_bring(next + 1, next->size, next->table_base);
            last_known = next;
          }
          const Loop& l = *static_cast<const Loop*>(given);
          l.task(l.context, begin, end);
        },
        &loop, count, grain);
  }

 private:
  struct Loop {
    Task task;
    void* context;
  };
};

}  // namespace

extern "C" {

/// Start the pool on `threads` threads, the caller's included. There must be as many idle workers.
/// @returns whether it runs
int carom_js_start(std::uint32_t threads) {
  try {
    pool = new JobPool(threads, carom::abi::mark_inside, std::pmr::get_default_resource());
  } catch (const std::system_error&) {
    return false;
  }
  return true;
}

/// From now on the stepping thread works alone: its workers may be ended.
void carom_js_stop() { pool = nullptr; }

/// A worker has left its work by a trap or an exception of JavaScript: nobody will end the loop it is in.
void carom_js_crashed() { crashed.store(true, std::memory_order_release); }

/// The pool calls it now and then while it waits. A step that waits for a part in vain traps, too, as it would have
/// without threads.
int sched_yield() {
  if (crashed.load(std::memory_order_acquire)) __builtin_trap();
  return 0;
}

/// Let a new engine's worlds step on the pool.   @returns whether there was memory for it
int carom_js_use(carom_engine* engine) {
  try {
    engine->jobs = carom::core::make_owned<Jobs, SharedJobs>(&engine->memory);
  } catch (const std::bad_alloc&) {
    return false;
  }
  return true;
}

/// Let the other threads know of a shape that the calling one has loaded, the only one that ever loads any.
/// @param side  SideModule with its bytes, from malloc; it stays
void carom_js_share(SideModule* side) {
  side->next.store(nullptr, std::memory_order_relaxed);
  last_known->next.store(side, std::memory_order_release);
  last_known = side;
}

/// Where a thread's stack begins; it grows down.
void* carom_js_stack_top(pthread_t thread) {
  pthread_attr_t about;
  void* lowest;
  std::size_t size;
  if (pthread_getattr_np(thread, &about) || pthread_attr_getstack(&about, &lowest, &size)) return nullptr;
  return static_cast<char*>(lowest) + size;
}

int _emscripten_default_pthread_stack_size() { return 1 << 20; }

/// Of more than some hundred bytes: one instruction.
void* emscripten_memcpy_big(void* to, const void* from, std::size_t bytes) { return __builtin_memcpy(to, from, bytes); }

int clock_gettime(clockid_t id, timespec* out) {
  const double now = id == CLOCK_REALTIME ? emscripten_date_now() : emscripten_get_now();
  out->tv_sec = static_cast<time_t>(now / 1000);
  out->tv_nsec = static_cast<long>((now - 1000.0 * static_cast<double>(out->tv_sec)) * 1e6);
  return 0;
}
int __clock_gettime(clockid_t id, timespec* out) { return clock_gettime(id, out); }

}  // extern "C"
