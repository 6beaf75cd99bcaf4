// The sections of a snapshot: what each holds of a world, by a tag that a reader may not know.
#pragma once

#include "dynamics/snapshot/bytes.h"
#include "dynamics/world.h"

namespace carom::dynamics::snapshot {

struct Section {
  std::uint32_t tag;
  const char* name;  // for messages
  void (*save)(Saver&, const World&);
  void (*check)(Checker&, const World&);
  void (*load)(Loader&, World&);
};

constexpr std::uint32_t tag_of(const char (&name)[5]) {
  return static_cast<std::uint32_t>(name[0]) | static_cast<std::uint32_t>(name[1]) << 8 |
         static_cast<std::uint32_t>(name[2]) << 16 | static_cast<std::uint32_t>(name[3]) << 24;
}

/// From a module with one description for all three: template <class Io, class W> static void go(Io&, W&).
template <class Module>
constexpr Section section(const char (&tag)[5], const char* name) {
  return {tag_of(tag), name, Module::template go<Saver, const World>, Module::template go<Checker, const World>,
          Module::template go<Loader, World>};
}

// What a snapshot needs of each module of a world. Loading wants the capacity that checking found out (reserve()).
extern const Section kBodies, kColliders, kDriven;  // bodies.cpp
extern const Section kPairs, kImpulses;             // pairs.cpp
extern const Section kSleepers, kHappenings;        // sleep.cpp
extern const Section kDials, kWater, kMaterials, kMaterialPairs, kFields, kSprings, kJoints, kTurns,
    kApart;                  // settings.cpp
extern const Section kSets;  // particles.cpp

/// Of a world's pair table, for loading.
void reserve_pairs(World& world, const Needs& needs);

}  // namespace carom::dynamics::snapshot
