#include "dynamics/snapshot/frame.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

#include "dynamics/effects.h"
#include "dynamics/snapshot/structure_cache.h"

namespace carom::dynamics {
namespace snapshot {
namespace {

constexpr std::uint64_t kMagic = 0x504E534D4F524143;  // "CAROMSNP"
constexpr std::uint32_t kFormat = 1;                  // raised when older readers must not try
constexpr std::uint64_t kHeader = 32, kSectionHeader = 16;

struct Header {
  std::uint64_t magic = kMagic;
  std::uint32_t format = kFormat, reserved = 0;
  std::uint64_t size = 0;      // of all
  std::uint64_t checksum = 0;  // of what comes after the header
};
static_assert(sizeof(Header) == kHeader);
struct SectionHeader {
  std::uint32_t tag, reserved;
  std::uint64_t size;  // without this, and without the zeros up to a multiple of 8
};
static_assert(sizeof(SectionHeader) == kSectionHeader);

/// Four chains side by side, so that none waits for another.
std::uint64_t checksum(const std::byte* bytes, std::uint64_t n) {
  std::uint64_t chain[4] = {n, ~n, 0x9E3779B97F4A7C15ull, 0xBF58476D1CE4E5B9ull};
  std::uint64_t at = 0;
  const auto mix = [](std::uint64_t h, std::uint64_t word) {
    h = (h ^ word) * 0x9E3779B97F4A7C15ull;
    return h ^ h >> 32;
  };
  for (; at + 32 <= n; at += 32)
    for (std::uint64_t k = 0; k < 4; ++k) {
      std::uint64_t word;
      std::memcpy(&word, bytes + at + 8 * k, 8);
      chain[k] = mix(chain[k], word);
    }
  for (; at < n; ++at) chain[0] = mix(chain[0], static_cast<std::uint64_t>(bytes[at]));
  return mix(mix(mix(chain[0], chain[1]), chain[2]), chain[3]);
}

/// How far the world is; and whether the host changed the scene since it was planned, so that all pairs are asked anew.
struct Progress {
  template <class Io, class W>
  static void go(Io& io, W& world) {
    const std::uint64_t steps = io.value(world.report.steps);
    const Real time = io.real(world.report.time);
    const bool pending = yes_or_no(
        io, Io::saves && world.plan->revision != world.scene.revision && world.plan->restored != world.scene.revision);
    io.demand(time >= 0);
    if constexpr (Io::loads) {
      world.report = StepReport{};
      world.report.steps = steps, world.report.time = time;
      ++world.scene.revision, ++world.scene.collider_revision;
      world.plan->restored = pending ? 0 : world.scene.revision;
    }
  }
};

struct StructurePrint {
  template <class Io, class W>
  static void go(Io& io, W& world) {
    if constexpr (Io::saves)
      for (const KindPrint& kind : world.structure.of(world)) {
        io.value(kind.slots), io.value(kind.alive);
        io.value(kind.print);
      }
  }
};

bool check_structure(const World& world, const std::byte* begin, const std::byte* end, SnapshotFault& fault) {
  Needs needs(world.memory);
  Checker io(begin, end, begin == nullptr, needs);
  const Structure own = world.structure.of(world);
  for (std::size_t k = 0; k < kKinds; ++k) {
    KindPrint theirs;
    theirs.slots = io.value(0u), theirs.alive = io.value(0u);
    theirs.print = io.value(std::uint64_t(0));
    if (io.bad()) return refuse(fault, SnapshotFault::corrupt, "section structure is cut off");
    if (theirs == own[k]) continue;
    if (theirs.alive != own[k].alive)
      return refuse(fault, SnapshotFault::mismatch, "the snapshot is of a world with %u %s, this one has %u",
                    theirs.alive, kKindNames[k], own[k].alive);
    return refuse(fault, SnapshotFault::mismatch,
                  "the snapshot is of a world with other %s: as many (%u), but not alike, or made in another order",
                  kKindNames[k], theirs.alive);
  }
  return true;
}

/// One section after the other, @see save_section(); what is zeros alone is what a reader takes it for if it is absent.
class Writer {
 public:
  Writer(std::byte* to, std::uint64_t capacity) : io_(to, to ? capacity : 0), to_(to), capacity_(capacity) {
    io_.put(&header_, kHeader);
  }
  template <class Save>
  void section(std::uint32_t tag, Save&& save) {
    const std::uint64_t at = io_.size();
    SectionHeader s{tag, 0, 0};
    io_.put(&s, kSectionHeader);
    io_.begin_part();
    save(io_);
    if (!io_.marked()) return io_.shrink(at);
    s.size = io_.size() - at - kSectionHeader;
    io_.put_at(at, &s, kSectionHeader);
    io_.align();
  }
  void state(const World& world) {
    std::size_t count = 0;
    const Section* const* const all = sections(count);
    for (std::size_t k = 0; k < count; ++k) section(all[k]->tag, [&](Saver& io) { all[k]->save(io, world); });
  }
  std::uint64_t finish(Origin origin = Origin::host) {
    header_.size = io_.size();
    if (io_.size() > capacity_ || !to_) return io_.size();
    if (origin == Origin::host) header_.checksum = checksum(to_ + kHeader, io_.size() - kHeader);
    io_.put_at(0, &header_, kHeader);
    return io_.size();
  }

 private:
  Header header_;
  Saver io_;
  std::byte* to_;
  std::uint64_t capacity_;
};

}  // namespace

const Section* const* sections(std::size_t& n) {
  static constexpr Section kProgress = section<Progress>("STEP", "progress");
  static constexpr Section kStructure = section<StructurePrint>("STRU", "structure");
  static constexpr const Section* kAll[] = {&kStructure, &kHappenings,    &kDials,    &kBodies,  &kColliders,
                                            &kPairs,     &kImpulses,      &kSleepers, &kJoints,  &kTurns,
                                            &kMaterials, &kMaterialPairs, &kFields,   &kSprings, &kWater,
                                            &kApart,     &kSets,          &kDriven,   &kProgress};
  static_assert(std::size(kAll) <= kMostSections);
  n = std::size(kAll);
  return kAll;
}
bool is_structure(const Section& section) { return section.tag == tag_of("STRU"); }

bool refuse(SnapshotFault& fault, SnapshotFault::Kind kind, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(fault.text, sizeof fault.text, format, arguments);
  va_end(arguments);
  fault.kind = kind;
  return false;
}

bool find_sections(const std::byte* bytes, std::uint64_t n, Found& found, SnapshotFault& fault, Origin origin) {
  Header header;
  if (n < kHeader) return refuse(fault, SnapshotFault::corrupt, "%llu bytes are no snapshot", (unsigned long long)n);
  std::memcpy(&header, bytes, kHeader);
  if (header.magic != kMagic) return refuse(fault, SnapshotFault::corrupt, "the bytes do not begin as a snapshot does");
  if (header.format > kFormat)
    return refuse(fault, SnapshotFault::newer, "the snapshot has format %u, this library reads up to %u", header.format,
                  kFormat);
  if (header.size != n)
    return refuse(fault, SnapshotFault::corrupt, "the snapshot has %llu bytes, %llu are given",
                  (unsigned long long)header.size, (unsigned long long)n);
  if (header.format == 0 || header.reserved != 0 ||
      (origin == Origin::host && header.checksum != checksum(bytes + kHeader, n - kHeader)))
    return refuse(fault, SnapshotFault::corrupt, "the checksum of the snapshot is not that of its bytes");
  std::size_t count = 0;
  const Section* const* const all = sections(count);
  for (std::uint64_t at = kHeader; at < n;) {
    SectionHeader s;
    if (n - at < kSectionHeader) return refuse(fault, SnapshotFault::corrupt, "the snapshot ends within a section");
    std::memcpy(&s, bytes + at, kSectionHeader);
    at += kSectionHeader;
    if (s.size > n - at || s.size + (-s.size % 8) > n - at)
      return refuse(fault, SnapshotFault::corrupt, "the snapshot ends within a section");
    bool twice = false;
    for (std::size_t k = 0; k < count; ++k) {
      if (all[k]->tag != s.tag) continue;
      twice |= found.begin[k] != nullptr;
      found.begin[k] = bytes + at, found.end[k] = bytes + at + s.size;
    }
    for (std::size_t k = 0; k < kWholeSections; ++k) {
      if (kWhole[k].tag != s.tag) continue;
      twice |= found.whole_begin[k] != nullptr;
      found.whole_begin[k] = bytes + at, found.whole_end[k] = bytes + at + s.size;
    }
    if (twice) return refuse(fault, SnapshotFault::corrupt, "section %.4s is there twice", (const char*)&s.tag);
    at += s.size + (-s.size % 8);
  }
  return true;
}

bool check_structure_of(const World& world, const Found& found, bool built, SnapshotFault& fault) {
  std::size_t count = 0, k = 0;
  const Section* const* const all = sections(count);
  while (!is_structure(*all[k])) ++k;
  return (built && !found.begin[k]) || check_structure(world, found.begin[k], found.end[k], fault);
}

}  // namespace snapshot

std::uint64_t save_state(const World& world, std::byte* to, std::uint64_t capacity, Origin origin) {
  snapshot::Writer writer(to, capacity);
  writer.state(world);
  return writer.finish(origin);
}

bool next_section(const std::byte* bytes, std::uint64_t n, std::uint64_t& at, SectionBytes& out) {
  using namespace snapshot;
  if (at == 0) at = kHeader;
  if (at >= n) return false;
  SectionHeader s;
  std::memcpy(&s, bytes + at, kSectionHeader);
  out = {s.tag, bytes + at + kSectionHeader, s.size};
  at += kSectionHeader + s.size + (-s.size % 8);
  return true;
}

std::uint64_t put_header(std::byte* to, std::uint64_t n) {
  snapshot::Header header;
  header.size = n;
  std::memcpy(to, &header, snapshot::kHeader);
  return snapshot::kHeader;
}

std::uint64_t put_section_header(std::byte* to, std::uint32_t tag, std::uint64_t size) {
  const snapshot::SectionHeader s{tag, 0, size};
  std::memcpy(to, &s, snapshot::kSectionHeader);
  return snapshot::kSectionHeader;
}

std::uint64_t save_world(const World& world, const ShapeNames& names, std::byte* to, std::uint64_t capacity) {
  using namespace snapshot;
  Writer writer(to, capacity);
  for (std::size_t k = 0; k < kWholeSections; ++k)
    writer.section(kWhole[k].tag, [&](Saver& io) { save_whole(k, io, world, names); });
  writer.state(world);
  return writer.finish();
}

bool is_whole(const std::byte* bytes, std::uint64_t n) {
  snapshot::Found found;
  SnapshotFault fault;
  return snapshot::find_sections(bytes, n, found, fault) && found.is_whole();
}

}  // namespace carom::dynamics
