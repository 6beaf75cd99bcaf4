// A table of moving boxes for tests of the broad phase: everything that the inside of an engine may do to it between
// steps.
#pragma once

#include <random>

#include "collision/broad/broad_phase.h"

namespace carom::test {

/// Numbers of our own making from mt19937_64 (whose bits the standard fixes; its distributions' it does not).
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : engine_(seed) {}
  Real unit() { return static_cast<Real>(engine_() >> 11) * 0x1p-53; }
  Real between(Real lo, Real hi) { return lo + (hi - lo) * unit(); }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }
  Vec3 in_cube(Real half) { return Vec3(between(-half, half), between(-half, half), between(-half, half)); }

 private:
  std::mt19937_64 engine_;
};

inline Aabb box_at(const Vec3& center, const Vec3& half) {
  Aabb box;
  box.lo = center - half, box.hi = center + half;
  return box;
}

struct BroadScene {
  explicit BroadScene(Memory* memory = std::pmr::get_default_resource()) : table(memory) {}

  /// Put a box, of a body of its own, into a slot; slots below it that were never used stay free.
  void put(std::uint32_t slot, const Aabb& box, bool movable = true) {
    if (slot >= table.slots()) {
      table.shape.resize(slot + 1, nullptr);
      table.body.resize(slot + 1);
      table.bounds.resize(slot + 1);
      table.movable.resize(slot + 1);
      table.disabled.resize(slot + 1);
    }
    table.body[slot] = slot;
    table.bounds[slot] = box;
    table.movable[slot] = movable;
    table.disabled[slot] = 0;
    const auto at = std::lower_bound(table.active.begin(), table.active.end(), slot);
    if (at == table.active.end() || *at != slot) table.active.insert(at, slot);
    ++generation;
  }

  void drop(std::uint32_t slot) {
    std::erase(table.active, slot);
    // What a free slot's box holds must not matter.
    table.bounds[slot] = box_at(Vec3::zero(), Vec3::constant(kInfinity));
    ++generation;
  }

  void shift(std::uint32_t slot, const Vec3& by) { table.bounds[slot].lo += by, table.bounds[slot].hi += by; }

  Colliders table;
  std::uint64_t generation = 1;
  BroadSettings settings;
};

}  // namespace carom::test
