// Handles and the slots behind them.
//
// A handle carries kind, owner tag, generation and slot, so that a stale, foreign or mistaken one is told apart from a
// good one in every build:    63..60 kind | 59..44 owner tag | 43..24 generation | 23..0 slot
#pragma once

#include <cstdint>

#include "core/invalid.h"
#include "core/memory.h"

namespace carom::core {

using Handle = std::uint64_t;

enum class Kind : std::uint32_t {
  none = 0,
  plugin = 1,
  shape = 2,
  material = 3,
  body = 4,
  collider = 5,
  particles = 6,
  joint = 7,
  field = 8,
  spring = 9,
  last = spring
};
enum class HandleFault { none, invalid, stale, wrong_kind, wrong_owner };

inline constexpr std::uint32_t kSlotBits = 24, kGenerationBits = 20, kTagBits = 16;
inline constexpr std::uint32_t kMaxSlots = 1u << kSlotBits;
inline constexpr std::uint32_t kMaxGeneration = (1u << kGenerationBits) - 1;

/// The handle of the same slot and generation that another owner issues.
inline constexpr Handle with_tag(Handle h, std::uint32_t tag) {
  constexpr Handle kTag = ((Handle(1) << kTagBits) - 1) << (kGenerationBits + kSlotBits);
  return (h & ~kTag) | static_cast<Handle>(tag) << (kGenerationBits + kSlotBits);
}
inline constexpr std::uint32_t handle_slot(Handle h) { return static_cast<std::uint32_t>(h & (kMaxSlots - 1)); }

/// Which slots are taken, and what generation each is in. The objects themselves live in arrays of their owner, indexed
/// by slot. A slot whose generation is used up (2^19 - 1 lives) is retired rather than reused, so no handle ever comes back.
class SlotPool {
 public:
  SlotPool(Kind kind, std::uint32_t tag, Memory* memory) : kind_(kind), tag_(tag), generation_(memory), free_(memory) {}

  /// Take a slot. @return its handle, or 0 when all 2^24 are taken. Freed slots come back last in, first out.
  Handle take() {
    std::uint32_t slot;
    if (!free_.empty()) {
      slot = free_.back();
      free_.pop_back();
    } else {
      slot = static_cast<std::uint32_t>(generation_.size());
      if (slot >= kMaxSlots) return 0;
      if (free_.capacity() <= slot)
        free_.reserve(2 * (static_cast<std::size_t>(slot) + 8));  // release() never allocates
      generation_.push_back(0);
    }
    generation_[slot] += 1;  // odd: alive
    ++alive_, ++changes_;
    return handle(slot);
  }

  void release(std::uint32_t slot) {
    generation_[slot] += 1;  // even: free
    --alive_, ++changes_;
    if (is_waiting(generation_[slot])) free_.push_back(slot);
  }

  bool alive(std::uint32_t slot) const { return slot < generation_.size() && (generation_[slot] & 1); }

  Handle handle(std::uint32_t slot) const {
    return (static_cast<Handle>(kind_) << 60) | (static_cast<Handle>(tag_) << 44) |
           (static_cast<Handle>(generation_[slot]) << kSlotBits) | slot;
  }

  HandleFault check(Handle h) const {
    const auto kind = static_cast<std::uint32_t>(h >> 60);
    const auto tag = static_cast<std::uint32_t>(h >> 44) & 0xFFFFu;
    const auto generation = static_cast<std::uint32_t>(h >> kSlotBits) & kMaxGeneration;
    const auto slot = handle_slot(h);
    if (h == 0 || kind == 0 || kind > static_cast<std::uint32_t>(Kind::last)) return HandleFault::invalid;
    if (kind != static_cast<std::uint32_t>(kind_)) return HandleFault::wrong_kind;
    if (tag != tag_) return HandleFault::wrong_owner;
    if (slot >= generation_.size() || generation > generation_[slot] || !(generation & 1)) return HandleFault::invalid;
    return generation == generation_[slot] ? HandleFault::none : HandleFault::stale;
  }

  std::uint32_t tag() const { return tag_; }
  /// Slots taken and released so far.
  std::uint32_t changes() const { return changes_; }
  /// What stands in a slot is another thing now.
  void mark_change() { ++changes_; }
  /// Which slots have lived how often, and which comes next.
  template <class H>
  void add_to(H& hash) const {
    for (const std::uint32_t g : generation_) hash.add(std::uint64_t(g));
    for (const std::uint32_t slot : free_) hash.add(std::uint64_t(slot));
  }
  const Array<std::uint32_t>& generations() const { return generation_; }  // by slot; odd: alive
  const Array<std::uint32_t>& free_slots() const { return free_; }         // the last is the next to be taken
  /// Become what another pool was, by what these two said of it. There is nothing in this one.
  /// @return  false: no pool was ever like that; then nothing has changed
  bool adopt(const Array<std::uint32_t>& generations, const Array<std::uint32_t>& free) {
    if (generations.size() > kMaxSlots || !generation_.empty()) return false;
    std::size_t waiting = 0;
    std::uint32_t alive = 0;
    for (const std::uint32_t g : generations) {
      if (g == 0 || g >= kMaxGeneration) return false;
      alive += g & 1, waiting += is_waiting(g);
    }
    if (free.size() != waiting) return false;
    Array<std::uint8_t> seen(generations.size(), 0, generation_.get_allocator());
    for (const std::uint32_t slot : free) {
      if (slot >= generations.size() || seen[slot] || !is_waiting(generations[slot])) return false;
      seen[slot] = 1;
    }
    generation_.reserve(generations.size()), free_.reserve(generations.size());
    generation_.assign(generations.begin(), generations.end()), free_.assign(free.begin(), free.end());
    alive_ = alive, ++changes_;
    return true;
  }
  std::uint32_t slots() const { return static_cast<std::uint32_t>(generation_.size()); }
  std::uint32_t alive_count() const { return alive_; }
  void reserve(std::size_t n) { generation_.reserve(n), free_.reserve(n); }

 private:
  /// Free, and not retired.
  static bool is_waiting(std::uint32_t generation) { return !(generation & 1) && generation + 1 < kMaxGeneration; }

  Kind kind_;
  std::uint32_t tag_;
  std::uint32_t alive_ = 0;
  std::uint32_t changes_ = 0;  // modulo 2^32
  Array<std::uint32_t> generation_;
  Array<std::uint32_t> free_;
};

}  // namespace carom::core
