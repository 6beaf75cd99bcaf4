// A world's state in few bytes: what of it differs from that of another world of the same structure.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/memory.h"
#include "dynamics/snapshot/snapshot.h"

namespace carom::batch {

/// A state that others are packed against. Sections are compared with the section of the same tag, word by word: most
/// numbers of a joint, and all that a host has set alike, are in one world as in the other.
class PackingBase {
 public:
  /// @param bytes  of save_state()
  explicit PackingBase(Array<std::byte> bytes);
  PackingBase(PackingBase&&) = default;
  PackingBase(const PackingBase&) = delete;
  PackingBase& operator=(const PackingBase&) = delete;

  /// @param bytes  [n] of save_state(), of a world of the same structure
  /// @param to     [capacity] filled if it is large enough   @return  bytes that it takes
  std::uint64_t pack(const std::byte* bytes, std::uint64_t n, std::byte* to, std::uint64_t capacity) const;
  /// The bytes that were packed, of Origin::own.
  void unpack(const Array<std::byte>& packed, Array<std::byte>& to) const;

 private:
  const SectionBytes* find(std::uint32_t tag) const;

  Array<std::byte> bytes_;
  Array<SectionBytes> sections_;
};

}  // namespace carom::batch
