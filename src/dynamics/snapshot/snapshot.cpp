// The frame of a snapshot: header, sections one after the other, checksum; and the order of restoring: look at all,
// make room, then change.
#include "dynamics/snapshot/snapshot.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

#include "dynamics/contact/contact.h"
#include "dynamics/events/events.h"
#include "dynamics/sleep/sleep.h"
#include "dynamics/snapshot/section.h"
#include "dynamics/snapshot/structure.h"

namespace carom {
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

constexpr std::uint32_t kStructureTag = tag_of("STRU");

/// In the order in which they are loaded: who slept is told to who listens, so those come first.
const Section* const* sections(std::size_t& n) {
  static constexpr Section kProgress = section<Progress>("STEP", "progress");
  static constexpr Section kStructure = section<StructurePrint>("STRU", "structure");
  static constexpr const Section* kAll[] = {&kStructure, &kHappenings, &kDials,  &kBodies,    &kColliders, &kPairs,
                                            &kImpulses,  &kSleepers,   &kJoints, &kMaterials, &kFields,    &kSprings,
                                            &kWater,     &kApart,      &kSets,   &kProgress};
  n = std::size(kAll);
  return kAll;
}
constexpr std::size_t kMostSections = 16;

bool refuse(SnapshotFault& fault, SnapshotFault::Kind kind, const char* format, ...)
    __attribute__((format(printf, 3, 4)));
bool refuse(SnapshotFault& fault, SnapshotFault::Kind kind, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(fault.text, sizeof fault.text, format, arguments);
  va_end(arguments);
  fault.kind = kind;
  return false;
}

/// Where the sections that this library knows are in the bytes.
struct Found {
  const std::byte* begin[kMostSections] = {};
  const std::byte* end[kMostSections] = {};
};

bool find_sections(const std::byte* bytes, std::uint64_t n, Found& found, SnapshotFault& fault) {
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
  if (header.format == 0 || header.reserved != 0 || header.checksum != checksum(bytes + kHeader, n - kHeader))
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
    for (std::size_t k = 0; k < count; ++k) {
      if (all[k]->tag != s.tag) continue;
      if (found.begin[k]) return refuse(fault, SnapshotFault::corrupt, "section %s is there twice", all[k]->name);
      found.begin[k] = bytes + at, found.end[k] = bytes + at + s.size;
    }
    at += s.size + (-s.size % 8);
  }
  return true;
}

/// Whether a world is of the structure that a snapshot is of.
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

/// Solver severity knows no joints and no locks; the boundary refuses them, and so do snapshots.
bool check_solver(const World& world, Found& found, std::size_t dials, const Needs& needs, SnapshotFault& fault) {
  Needs none(world.memory);
  Checker io(found.begin[dials], found.end[dials], found.begin[dials] == nullptr, none);
  const std::uint64_t n = io.count(0, sizeof(Real));
  Real solver = Dials()[Dial::solver];
  for (std::uint64_t k = 0; k < n; ++k) {
    const Real value = io.value(Real(0));
    if (k == static_cast<std::uint64_t>(Dial::solver)) solver = value;
  }
  const bool knows = solver != 0 || (!needs.locks && world.joints.slots.alive_count() == 0);
  return knows || refuse(fault, SnapshotFault::corrupt, "solver severity knows no joints and no locks");
}

/// Sparse arrays that begin to be used get an entry for all: what they stand for stays the same.
template <class T>
void widen(Array<T>& a, std::size_t n, const T& value, bool used) {
  if (used && a.size() < n) a.resize(n, value);
}

/// All that may run out of memory. What the world holds stays as it is.
void make_room_for(World& world, const Needs& n) {
  Scene& s = world.scene;
  Sleep& z = *world.sleep;
  Events& e = *world.events;
  const std::size_t bodies = s.bodies.slots(), colliders = s.colliders.slots();
  widen(s.gravity_factor, bodies, Real(1), n.gravity_factor);
  if (n.locks && s.locks.size() < bodies) {
    s.given_locks.reserve(bodies), s.locks.reserve(bodies);
    s.given_locks.resize(bodies, 0), s.locks.resize(bodies, 0);
  }
  widen(s.drag, bodies, Drag{}, n.drag);
  widen(s.fields.mask, bodies, 1u, n.field_mask);
  widen(s.modes.forbidden_of, bodies, RowBits(0), n.modes), widen(s.modes.forced_of, bodies, RowBits(0), n.modes);
  widen(s.colliders.filter, colliders, Filter(), n.filter);
  widen(s.colliders.sensor, colliders, std::uint8_t(0), n.sensor);
  widen(s.surface, colliders, SurfaceVelocity{}, n.surface);
  make_room_for_pairs(world, n);
  world.contacts->old.reserve(n.old);
  const std::size_t sleepers = n.sleepers;
  z.asleep.reserve(sleepers), z.parked.reserve(sleepers), z.ring.reserve(sleepers), z.calm.reserve(sleepers);
  z.anchor_x.reserve(sleepers), z.anchor_q.reserve(sleepers), z.radius.reserve(sleepers), z.rows.reserve(sleepers);
  z.kept_first.reserve(sleepers), z.root.reserve(sleepers), z.restless.reserve(sleepers);
  if (sleepers > 0) z.fallen.reserve(std::max(bodies, n.fallen)), z.woken.reserve(std::max(bodies, n.woken));
  z.stirred.reserve(n.stirred), z.rejoined.reserve(n.rejoined);
  z.kept.reserve(n.kept), z.kept_free.reserve(z.kept.capacity());
  e.touching.reserve(n.touching), e.within.reserve(n.within), e.slept.reserve(std::max(e.slept.size(), n.slept));
  world.plan->faulty.reserve(n.faulty);
  s.apart.make_room(n.apart), s.joined.make_room(n.unbroken);
  for (const Needs::Set& need : n.sets) {
    ParticleSet& p = world.particles.set[need.slot];
    world.particles.reserve(need.slot, need.particles);
    if (need.weighed) p.mass.reserve(need.particles);
  }
}

/// What the last step left for who asks is not of the state that is put back.
void forget_last_step(World& world) {
  Contacts& c = *world.contacts;
  world.contact_views.clear(), world.group_views.clear(), world.fault_views.clear();
  world.events->clear();
  c.rows.clear(), c.geometry.clear(), c.meetings.clear(), c.bouncing.clear(), c.impacts.clear(), c.resisting.clear();
  c.driven.clear(), c.surface.clear(), c.group_begin.clear(), c.group_rows.clear(), c.direct.clear();
}

}  // namespace
}  // namespace snapshot

std::uint64_t save_state(const World& world, std::byte* to, std::uint64_t capacity) {
  using namespace snapshot;
  Saver io(to, to ? capacity : 0);
  Header header;
  io.put(&header, kHeader);
  std::size_t count = 0;
  const Section* const* const all = sections(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint64_t at = io.size();
    SectionHeader s{all[k]->tag, 0, 0};
    io.put(&s, kSectionHeader);
    io.begin_part();
    all[k]->save(io, world);
    if (!io.marked()) {  // zeros: what a reader takes it for if it is absent
      io.shrink(at);
      continue;
    }
    s.size = io.size() - at - kSectionHeader;
    io.put_at(at, &s, kSectionHeader);
    io.align();
  }
  header.size = io.size();
  if (io.size() > capacity || !to) return io.size();
  header.checksum = checksum(to + kHeader, io.size() - kHeader);
  io.put_at(0, &header, kHeader);
  return io.size();
}

bool restore_state(World& world, const std::byte* bytes, std::uint64_t n, SnapshotFault& fault) {
  using namespace snapshot;
  Found found;
  if (!find_sections(bytes, n, found, fault)) return false;
  std::size_t count = 0;
  const Section* const* const all = sections(count);
  Needs needs(world.memory);
  std::size_t dials = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (all[k]->tag == kStructureTag) {
      if (!check_structure(world, found.begin[k], found.end[k], fault)) return false;
      continue;
    }
    if (all[k] == &kDials) dials = k;
    Checker io(found.begin[k], found.end[k], found.begin[k] == nullptr, needs);
    all[k]->check(io, world);
    if (io.bad()) return refuse(fault, SnapshotFault::corrupt, "section %s holds what no world does", all[k]->name);
  }
  if (!check_solver(world, found, dials, needs, fault)) return false;
  make_room_for(world, needs);
  // From here on nothing fails.
  for (std::size_t k = 0; k < count; ++k) {
    Loader io(found.begin[k], found.end[k], found.begin[k] == nullptr);
    all[k]->load(io, world);
  }
  forget_last_step(world);
  return true;
}

}  // namespace carom
