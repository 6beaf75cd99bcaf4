// Contacts of the last step as a host sees them: made for the first who asks, since most hosts never do.
#pragma once

#include <atomic>
#include <cstdint>

#include "core/memory.h"
#include "core/vec.h"

namespace carom::dynamics {

class World;

struct ContactView {
  std::uint32_t collider_a, collider_b;   // slots
  Vec3 point, normal;                     // m, world; unit, world, A to B
  Real separation;                        // m
  Real normal_impulse, friction_impulse;  // N s over the step
};

class ContactViews {
 public:
  explicit ContactViews(Memory* m) : list_(m) {}

  // ---- by a writer, alone ----
  /// There will be so many at most. Allocates.
  void reserve(std::size_t count) { list_.reserve(count); }
  /// Of a list that is clear.
  void give_back() { list_.shrink_to_fit(); }
  /// A step has ended, and its rows tell of its contacts. They are made of those and of the poses: who moves a body or
  /// takes a collider away asks for them first.
  void expect() { state_.store(kDue, std::memory_order_relaxed); }
  void clear() {
    list_.clear();
    state_.store(kMade, std::memory_order_relaxed);
  }
  /// A collider has gone.
  void remove(std::uint32_t collider) {
    std::erase_if(list_, [&](const ContactView& v) { return v.collider_a == collider || v.collider_b == collider; });
  }

  // ---- by readers, any number at a time ----
  /// Whoever comes first makes them, others wait for it. Allocates nothing.   @return ascending by collider pair
  const Array<ContactView>& of(const World& world);

 private:
  enum : std::uint8_t { kMade, kDue, kBeingMade };
  Array<ContactView> list_;
  std::atomic<std::uint8_t> state_{kMade};
};

}  // namespace carom::dynamics
