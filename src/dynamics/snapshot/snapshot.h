// Snapshots: the state of a world as bytes, and back. @see README.md
#pragma once

#include <cstddef>
#include <cstdint>

namespace carom {

class World;

/// Why bytes are refused. Then nothing of the world has changed.
struct SnapshotFault {
  enum Kind { none, corrupt, newer, mismatch } kind = none;
  char text[200] = {0};
};

/// All that a step reads and that is not structure, and what a host can set without changing structure. May be called
/// by several threads at once, while nobody changes the world.
/// @param to  [capacity] filled if it is large enough
/// @return    bytes that it takes
std::uint64_t save_state(const World& world, std::byte* to, std::uint64_t capacity);

/// Put back what save_state() took from this world, or from another of the same structure. From here on both go on
/// alike, bit for bit. Lists and residuals of the last step are empty until the next one.
/// @throw std::bad_alloc  then nothing has changed
bool restore_state(World& world, const std::byte* bytes, std::uint64_t n, SnapshotFault& fault);

}  // namespace carom
