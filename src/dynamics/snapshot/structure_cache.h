// The structure of a world: what there is in it, as against how that stands and what is set of it. Two worlds that were
// made by the same calls have the same, in whatever process.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "core/memory.h"

namespace carom::dynamics {

class World;

namespace snapshot {

/// What there is of one kind: slots, how many of them are in use, and a number made of all that does not change.
struct KindPrint {
  std::uint32_t slots = 0, alive = 0;
  std::uint64_t print = 0;
  bool operator==(const KindPrint&) const = default;
};
inline constexpr std::size_t kKinds = 7;
inline constexpr const char* kKindNames[kKinds] = {"bodies",        "colliders", "materials", "joints",
                                                   "particle sets", "fields",    "springs"};
using Structure = std::array<KindPrint, kKinds>;

}  // namespace snapshot

/// Of a world, as of its last change: found out by whoever asks first, and nothing but a pointer until then.
class StructureCache {
 public:
  snapshot::Structure of(const World& world) const;
  void forget(Memory* memory);  // the world's; before it goes

 private:
  struct Known;
  mutable std::atomic<Known*> known_{nullptr};
};

}  // namespace carom::dynamics
