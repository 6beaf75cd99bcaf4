// The frame of a snapshot: header, sections one after the other, checksum.
#pragma once

#include "dynamics/snapshot/section.h"
#include "dynamics/snapshot/snapshot.h"
#include "dynamics/snapshot/whole.h"

namespace carom::dynamics::snapshot {

inline constexpr std::size_t kMostSections = 24;
/// In the order in which they are loaded: who slept is told to who listens, so those come first.
const Section* const* sections(std::size_t& n);
bool is_structure(const Section& section);

/// Always false.
bool refuse(SnapshotFault& fault, SnapshotFault::Kind kind, const char* format, ...)
    __attribute__((format(printf, 3, 4)));

/// Where the sections that this library knows are in the bytes.
struct Found {
  const std::byte* begin[kMostSections] = {};
  const std::byte* end[kMostSections] = {};
  const std::byte* whole_begin[kWholeSections] = {};
  const std::byte* whole_end[kWholeSections] = {};

  bool is_whole() const { return whole_begin[0] != nullptr; }
};
/// @return false: the bytes are no snapshot, or not all of it
bool find_sections(const std::byte* bytes, std::uint64_t n, Found& found, SnapshotFault& fault,
                   Origin origin = Origin::host);

/// Whether a world is of the structure that a snapshot is of.
/// @param built  the world was made of these bytes: it is as they say, where they don't say it twice
bool check_structure_of(const World& world, const Found& found, bool built, SnapshotFault& fault);

}  // namespace carom::dynamics::snapshot
