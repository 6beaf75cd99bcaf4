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
#include "dynamics/snapshot/whole.h"

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
  const std::byte* whole_begin[kWholeSections] = {};
  const std::byte* whole_end[kWholeSections] = {};

  bool is_whole() const { return whole_begin[0] != nullptr; }
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
  world.views.clear(), world.group_views.clear(), world.fault_views.clear();
  world.events->clear();
  c.rows.clear(), c.geometry.clear(), c.meetings.clear(), c.bouncing.clear(), c.impacts.clear(), c.resisting.clear();
  c.driven.clear(), c.surface.clear(), c.group_begin.clear(), c.group_rows.clear(), c.direct.clear();
}

}  // namespace
}  // namespace snapshot

namespace snapshot {
namespace {

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
    for (std::size_t k = 0; k < count; ++k)
      section(all[k]->tag, [&](Saver& io) { all[k]->save(io, world); });
  }
  std::uint64_t finish() {
    header_.size = io_.size();
    if (io_.size() > capacity_ || !to_) return io_.size();
    header_.checksum = checksum(to_ + kHeader, io_.size() - kHeader);
    io_.put_at(0, &header_, kHeader);
    return io_.size();
  }

 private:
  Header header_;
  Saver io_;
  std::byte* to_;
  std::uint64_t capacity_;
};

bool is_structure(const Section& section) { return section.tag == kStructureTag; }

/// Look at the state that is in the bytes, and make room for it.
bool check_state(World& world, Found& found, SnapshotFault& fault) {
  std::size_t count = 0;
  const Section* const* const all = sections(count);
  Needs needs(world.memory);
  std::size_t dials = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (is_structure(*all[k])) continue;
    if (all[k] == &kDials) dials = k;
    Checker io(found.begin[k], found.end[k], found.begin[k] == nullptr, needs);
    all[k]->check(io, world);
    if (io.bad()) return refuse(fault, SnapshotFault::corrupt, "section %s holds what no world does", all[k]->name);
  }
  if (!check_solver(world, found, dials, needs, fault)) return false;
  make_room_for(world, needs);
  return true;
}

/// What check_state() has looked at. Does not fail.
void load_state(World& world, Found& found) {
  std::size_t count = 0;
  const Section* const* const all = sections(count);
  for (std::size_t k = 0; k < count; ++k) {
    Loader io(found.begin[k], found.end[k], found.begin[k] == nullptr);
    all[k]->load(io, world);
  }
  forget_last_step(world);
}

/// @param built  the world was made of these bytes: it is as they say, where they don't say it twice
bool check_structure_of(const World& world, const Found& found, bool built, SnapshotFault& fault) {
  std::size_t count = 0, k = 0;
  const Section* const* const all = sections(count);
  while (!is_structure(*all[k])) ++k;
  return (built && !found.begin[k]) || check_structure(world, found.begin[k], found.end[k], fault);
}

}  // namespace
}  // namespace snapshot

std::uint64_t save_state(const World& world, std::byte* to, std::uint64_t capacity) {
  snapshot::Writer writer(to, capacity);
  writer.state(world);
  return writer.finish();
}

std::uint64_t save_world(const World& world, const ShapeNames& names, std::byte* to, std::uint64_t capacity) {
  using namespace snapshot;
  Writer writer(to, capacity);
  for (std::size_t k = 0; k < kWholeSections; ++k)
    writer.section(kWhole[k].tag, [&](Saver& io) { save_whole(k, io, world, names); });
  writer.state(world);
  return writer.finish();
}

bool restore_state(World& world, const std::byte* bytes, std::uint64_t n, SnapshotFault& fault) {
  using namespace snapshot;
  Found found;
  if (!find_sections(bytes, n, found, fault) || !check_structure_of(world, found, false, fault) ||
      !check_state(world, found, fault))
    return false;
  load_state(world, found);
  return true;
}

namespace snapshot {
namespace {

/// Sections that say most to whoever looks for what went wrong; the others follow in their own order.
constexpr const Section* kTelling[] = {&kBodies, &kPairs, &kJoints, &kSets, &kDials};

void name(const World& world, Item item, std::uint32_t a, std::uint32_t b, Difference& out) {
  const auto handle = [](const SlotPool& pool, std::uint32_t slot) { return pool.alive(slot) ? pool.handle(slot) : 0; };
  const Scene& s = world.scene;
  switch (item) {
    case Item::body:
      out.first = handle(s.bodies, a);
      break;
    case Item::pair:
      out.first = handle(s.collider_slots, a), out.second = handle(s.collider_slots, b);
      break;
    case Item::collider:
      out.first = handle(s.collider_slots, a);
      break;
    case Item::joint:
      out.first = handle(world.joints.slots, a);
      break;
    case Item::set:
      out.first = handle(world.particles.slots, a);
      break;
    case Item::field:
      out.first = handle(s.fields.slots, a);
      break;
    case Item::spring:
      out.first = handle(s.springs.slots, a);
      break;
    case Item::material:
      out.first = handle(s.material_slots, a);
      break;
    case Item::none:
      break;
  }
}

/// Where two sections are no longer the same, in the first. @return null: they are the same
const std::byte* parts_at(const Found& a, const Found& b, std::size_t k) {
  static constexpr std::byte kNothing{};
  if (!a.begin[k] || !b.begin[k]) return a.begin[k] == b.begin[k] ? nullptr : a.begin[k] ? a.begin[k] : &kNothing;
  const auto at = std::mismatch(a.begin[k], a.end[k], b.begin[k], b.end[k]);
  return at.first == a.end[k] && at.second == b.end[k] ? nullptr : at.first;
}

}  // namespace
}  // namespace snapshot

bool compare_state(const World& world, const std::byte* bytes, std::uint64_t n, Difference& out, SnapshotFault& fault) {
  using namespace snapshot;
  Found theirs, ours;
  if (!find_sections(bytes, n, theirs, fault) || !check_structure_of(world, theirs, false, fault)) return false;
  Array<std::byte> own(save_state(world, nullptr, 0), std::byte(0), world.memory);
  save_state(world, own.data(), own.size());
  if (!find_sections(own.data(), own.size(), ours, fault)) return false;
  std::size_t count = 0;
  const Section* const* const all = sections(count);
  Needs needs(world.memory);
  std::size_t best = std::size(kTelling) + 1;  // how telling the one is that gave its name
  bool differs[kMostSections] = {};
  for (std::size_t k = 0; k < count; ++k) {
    if (is_structure(*all[k])) continue;
    const std::byte* const place = parts_at(theirs, ours, k);
    Checker io(theirs.begin[k], theirs.end[k], theirs.begin[k] == nullptr, needs);
    io.watch(theirs.begin[k] ? place : nullptr);
    all[k]->check(io, world);
    if (io.bad()) return refuse(fault, SnapshotFault::corrupt, "section %s holds what no world does", all[k]->name);
    if (!place) continue;
    differs[k] = true;
    const auto rank = static_cast<std::size_t>(std::ranges::find(kTelling, all[k]) - std::begin(kTelling));
    if (rank >= best) continue;
    std::uint32_t a = 0, b = 0;
    out.first = out.second = 0;
    const Item item = io.item(a, b);
    name(world, item, a, b, out), best = rank;
  }
  std::size_t at = 0;
  const auto add = [&](const Section* section) {
    if (at < sizeof out.sections)
      at += static_cast<std::size_t>(
          std::snprintf(out.sections + at, sizeof out.sections - at, "%s%s", at ? ", " : "", section->name));
  };
  for (const Section* telling : kTelling)
    for (std::size_t k = 0; k < count; ++k)
      if (differs[k] && all[k] == telling) add(telling);
  for (std::size_t k = 0; k < count; ++k)
    if (differs[k] && std::ranges::find(kTelling, all[k]) == std::end(kTelling)) add(all[k]);
  return true;
}

bool is_whole(const std::byte* bytes, std::uint64_t n) {
  snapshot::Found found;
  SnapshotFault fault;
  return snapshot::find_sections(bytes, n, found, fault) && found.is_whole();
}

bool build_world(World& world, const std::byte* bytes, std::uint64_t n, ShapeMaker& shapes, SnapshotFault& fault) {
  using namespace snapshot;
  Found found;
  if (!find_sections(bytes, n, found, fault)) return false;
  Builder builder(world, shapes, fault);
  for (std::size_t k = 0; k < kWholeSections; ++k) {
    Needs none(world.memory);
    Checker io(found.whole_begin[k], found.whole_end[k], found.whole_begin[k] == nullptr, none);
    if (build_whole(k, io, builder)) continue;
    if (fault.kind != SnapshotFault::none) return false;
    return refuse(fault, SnapshotFault::corrupt, "section %s holds what no world does", kWhole[k].name);
  }
  // Where it is another, a shape is not what it was: its plugin has other code.
  if (!check_structure_of(world, found, true, fault) || !check_state(world, found, fault)) return false;
  load_state(world, found);
  return true;
}

}  // namespace carom
