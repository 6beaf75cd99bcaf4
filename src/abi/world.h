// What stands behind carom_world*: a carom::World, the engine it belongs to, and the gate that keeps its users apart.
#pragma once

#include <carom/world.h>

#include <atomic>

#include "abi/budget.h"
#include "abi/engine.h"
#include "abi/recorder.h"
#include "dynamics/world.h"

namespace carom::abi {

/// Many readers or one writer, never waiting: who comes at the wrong time is told BUSY.
class Gate {
 public:
  bool enter_shared() {
    std::int32_t users = users_.load(std::memory_order_relaxed);
    while (users >= 0)
      if (users_.compare_exchange_weak(users, users + 1, std::memory_order_acquire, std::memory_order_relaxed))
        return true;
    return false;
  }
  void leave_shared() { users_.fetch_sub(1, std::memory_order_release); }
  bool enter_alone() {
    std::int32_t unused = 0;
    return users_.compare_exchange_strong(unused, kAlone, std::memory_order_acquire, std::memory_order_relaxed);
  }
  void leave_alone() { users_.store(0, std::memory_order_release); }

 private:
  static constexpr std::int32_t kAlone = -1;
  std::atomic<std::int32_t> users_{0};  // readers inside, or kAlone: a writer or a step
};

}  // namespace carom::abi

struct carom_world {
  carom_world(carom_engine& owner, std::uint32_t owner_tag, const carom::Vec3& gravity, std::size_t capacity)
      : engine(owner),
        inner(carom::make_owned<carom::World>(&owner.memory, owner_tag, gravity, capacity, &owner.memory)) {
    inner->jobs = owner.jobs.get();
  }

  carom_engine& engine;
  /// Bytes that a snapshot takes, counted since the last change: twice as many, and one more for a whole one. 0: not counted.
  std::atomic<std::uint32_t> snapshot_size{0};
  carom::abi::Gate gate;
  carom::Owned<carom::World> inner;             // never null; a snapshot may put another in its place
  carom::Owned<carom::abi::Recorder> recorder;  // null: it is not recorded
  carom::Owned<carom::abi::Budget> budget;      // null: off
};

namespace carom::abi {

/// The world of a call, argument 1, open for reading until the end of the scope.
class Reading {
 public:
  Reading(Call& call, carom_world* world) {
    if (!present(call, 1, "world", world)) return;
    if (!world->gate.enter_shared()) {
      call.fail(CAROM_E_BUSY, 1, "another thread is stepping or changing this world");
      return;
    }
    world_ = world;
  }
  ~Reading() {
    if (world_) world_->gate.leave_shared();
  }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;
  explicit operator bool() const { return world_; }
  const World& operator*() const { return *world_->inner; }
  const World* operator->() const { return world_->inner.get(); }
  carom_engine& engine() const { return world_->engine; }
  /// 0: not known. Readers that count it at once say the same.
  std::uint64_t snapshot_size(bool whole) const {
    const std::uint32_t known = world_->snapshot_size.load(std::memory_order_relaxed);
    return (known & 1) == std::uint32_t(whole) ? known >> 1 : 0;
  }
  void know_snapshot_size(bool whole, std::uint64_t size) const {
    if (size >> 31 == 0)
      world_->snapshot_size.store(static_cast<std::uint32_t>(size << 1 | std::uint64_t(whole)),
                                  std::memory_order_relaxed);
  }

 private:
  carom_world* world_ = nullptr;
};

/// The body of a call, argument 2.
inline bool resolve_body(Call& call, const World& world, carom_body body) {
  return resolve(call, 2, "body", world.scene.bodies, body);
}

/// The world of a call, argument 1, closed to everybody else until the end of the scope.
class Changing {
 public:
  Changing(Call& call, carom_world* world) {
    if (!present(call, 1, "world", world)) return;
    if (!world->gate.enter_alone()) {
      call.fail(CAROM_E_BUSY, 1, "another thread is stepping, changing or reading this world");
      return;
    }
    world_ = world;
    world->snapshot_size.store(0, std::memory_order_relaxed);
  }
  ~Changing() {
    if (world_) world_->gate.leave_alone();
  }
  Changing(const Changing&) = delete;
  Changing& operator=(const Changing&) = delete;
  explicit operator bool() const { return world_; }
  World& operator*() const { return *world_->inner; }
  World* operator->() const { return world_->inner.get(); }
  carom_engine& engine() const { return world_->engine; }
  Recorder* recorder() const { return world_->recorder.get(); }
  void record(Owned<Recorder> recorder) const { world_->recorder = std::move(recorder); }
  void budget(Owned<Budget> budget) const { world_->budget = std::move(budget); }
  /// Another world in place of this one, which goes. Handles of the old one must not be about.
  void replace(Owned<World> world) const { world_->inner = std::move(world); }

 private:
  carom_world* world_ = nullptr;
};

/// Likewise, by a call that is written down if the world is being recorded, and if the call went well.
/// @param say  from record_calls.h
template <class Say>
class Recorded : public Changing {
 public:
  Recorded(Call& call, carom_world* world, const Say& say)
      : Changing(call, world), call_(call), say_(say), unwinding_(std::uncaught_exceptions()) {}
  ~Recorded() noexcept(false) {  // the host's function to write with may end the thread
    if (*this && recorder() && call_.ok() && std::uncaught_exceptions() == unwinding_ && !is_leaving())
      recorder()->call(say_);
  }

 private:
  Call& call_;
  Say say_;
  int unwinding_;
};

inline constexpr double kLongestStep = 1;      // s
inline constexpr double kShortestStep = 1e-9;  // s: below it forces = impulses / dt overflow sooner than anything moves

/// s
inline bool is_step(Call& call, int argument, double dt) {
  return in_range(call, argument, "dt", dt, kShortestStep, kLongestStep) ||
         call.advise("pass a step of 1e-9 s to 1 s; most scenes take 1/60 s");
}

/// Make a world of an engine, in which there is nothing, with a tag of its own. @return null: noted
carom_world* make_world(Call& call, carom_engine& engine, const Vec3& gravity, std::size_t body_capacity);
/// Make a world of the same engine that goes on as this one does, bit for bit. @return null: noted
carom_world* fork_world(Call& call, const Reading& world);
/// The end of a world that no call uses any more.
void destroy_world(carom_world* world);

}  // namespace carom::abi
