// Where a world is no longer as a snapshot says.
#include <algorithm>
#include <cstdio>

#include "dynamics/snapshot/frame.h"

namespace carom::dynamics {
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

}  // namespace carom::dynamics
