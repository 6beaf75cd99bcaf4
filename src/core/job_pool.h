// The threads of an engine whose host has none to lend.
//
// A loop is a word that all threads agree on by compare-and-swap: which loop it is, and the parts that no thread has
// taken yet. The caller takes from the front and the others from the back: with two threads each sees the same half of
// every loop over the same bodies, and finds them in its cache. A thread that comes late finds nothing to take; none
// waits for it. Between loops threads spin for as long as a step's loops are usually apart, then sleep.
#pragma once

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "core/jobs.h"
#include "core/leaving.h"
#include "core/memory.h"

namespace carom::core {

class JobPool final : public Jobs {
 public:
  /// @param threads   in all, the caller's included; 2 or more
  /// @param on_start  called first on each new thread
  /// @throws std::system_error if the system has no more threads
  JobPool(std::uint32_t threads, void (*on_start)(), Memory* memory) : on_start_(on_start), threads_(memory) {
    threads_.reserve(threads - 1);
    try {
      for (std::uint32_t i = 1; i < threads; ++i) threads_.emplace_back([this] { work(); });
    } catch (...) {
      stop();
      throw;
    }
  }
  ~JobPool() override { stop(); }
  JobPool(const JobPool&) = delete;
  JobPool& operator=(const JobPool&) = delete;

  /// Several worlds may step at once: who finds the pool at work does its loop alone.
  void run(Task task, void* context, std::uint32_t count, std::uint32_t grain) override {
    const std::unique_lock mine(in_use_, std::try_to_lock);
    if (!mine) return task(context, 0, count);
    // Parts are numbered in 16 bits.
    grain_ = std::max(grain, count / kMostParts + 1);
    const std::uint32_t parts = (count - 1) / grain_ + 1;
    task_ = task, context_ = context, count_ = count;
    done_.store(0, std::memory_order_relaxed);
    failed_.store(false, std::memory_order_relaxed);
    ++loop_;
    // In one order for all threads with what a thread does before it sleeps: it sees the word, or we see it.
    word_.store(make(loop_, 0, parts), std::memory_order_seq_cst);
    if (asleep_.load(std::memory_order_seq_cst) > 0) {
      { const std::lock_guard lock(bed_); }
      alarm_.notify_all();
    }
    try {
      while (take(true)) {
      }
    } catch (...) {  // others have parts in hand, of what ends with this call: none takes another
      const std::uint64_t left = word_.exchange(make(loop_, 0, 0), std::memory_order_acq_rel);
      if (anything_left(left)) done_.fetch_add((left & 0xFFFF) - (left >> 16 & 0xFFFF), std::memory_order_release);
      wait_for(parts);
      throw;
    }
    wait_for(parts);
    if (failed_.load(std::memory_order_relaxed)) throw CallbackLeft();
  }

 private:
  static constexpr std::uint32_t kMostParts = 0xFFFF;
  /// Turns of waiting until a thread sleeps (some 50 us), and until one whose work others have in hand lets them run.
  static constexpr int kSpins = 2000, kYield = 200;

  void wait_for(std::uint32_t parts) {
    for (int spins = 0; done_.load(std::memory_order_acquire) != parts; ++spins) pause(spins);
  }

  static std::uint64_t make(std::uint32_t loop, std::uint32_t front, std::uint32_t back) {
    return std::uint64_t(loop) << 32 | front << 16 | back;
  }
  static bool anything_left(std::uint64_t word) { return (word >> 16 & 0xFFFF) < (word & 0xFFFF); }

  static void pause(int spins) {
    if (spins % kYield == kYield - 1) return std::this_thread::yield();
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
  }

  /// Take a part and do it. The loop it belongs to is not over before its parts are done, so what run() wrote for it
  /// stands.
  bool take(bool front) {
    std::uint64_t word = word_.load(std::memory_order_acquire);
    std::uint32_t part;
    do {
      if (!anything_left(word)) return false;
      part = front ? word >> 16 & 0xFFFF : (word & 0xFFFF) - 1;
    } while (!word_.compare_exchange_weak(word, front ? word + (1 << 16) : word - 1, std::memory_order_acq_rel,
                                          std::memory_order_acquire));
    const std::uint32_t begin = part * grain_;
    try {
      task_(context_, begin, grain_ < count_ - begin ? begin + grain_ : count_);
    } catch (...) {
      failed_.store(true, std::memory_order_relaxed);
      done_.fetch_add(1, std::memory_order_release);
      throw;
    }
    done_.fetch_add(1, std::memory_order_release);
    return true;
  }

  void work() {
    on_start_();
    for (int spins = 0;; ++spins) {
      if (anything_left(word_.load(std::memory_order_acquire))) {
        std::fesetenv(FE_DFL_ENV);  // whatever a callback left in it
        try {
          while (take(false)) {
          }
        } catch (const ThreadExit&) {
          throw;  // the others go on without this thread
        } catch (...) {
        }
        spins = 0;
      }
      pause(spins);
      if (spins < kSpins) continue;
      std::unique_lock lock(bed_);
      asleep_.fetch_add(1, std::memory_order_seq_cst);
      alarm_.wait(lock, [&] { return ended_ || anything_left(word_.load(std::memory_order_seq_cst)); });
      asleep_.fetch_sub(1, std::memory_order_relaxed);
      if (ended_) return;
      spins = 0;
    }
  }

  void stop() {
    {
      const std::lock_guard lock(bed_);
      ended_ = true;
    }
    alarm_.notify_all();
    for (std::thread& t : threads_) t.join();
  }

  std::mutex in_use_;
  // Of the present loop; read by who has taken a part of it.
  Task task_ = nullptr;
  void* context_ = nullptr;
  std::uint32_t count_ = 0, grain_ = 1, loop_ = 0;
  alignas(64) std::atomic<std::uint64_t> word_{0};  // loop, first part that is left, one past the last
  alignas(64) std::atomic<std::uint32_t> done_{0};  // parts

  std::atomic<bool> failed_{false};                 // a part was not finished

  alignas(64) std::atomic<std::uint32_t> asleep_{0};
  std::mutex bed_;
  std::condition_variable alarm_;
  bool ended_ = false;  // under bed_

  void (*on_start_)();
  Array<std::thread> threads_;  // last: they use all of the above
};

}  // namespace carom::core
