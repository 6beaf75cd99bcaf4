// Triangle meshes and height fields: their contacts, which take the place of the narrow phase's for pairs that have
// one.
#pragma once

#include "collision/scenery/meet.h"
#include "dynamics/effects.h"

namespace carom::dynamics {

namespace scenery {
/// Colliders of meshes and height fields that the broad phase goes through.
void find(const Scene& scene, const State& state, Participants& participants);
}  // namespace scenery

/// What is kept between steps, made with the first participant.
struct SceneryContacts {
  explicit SceneryContacts(Memory* m) : pair_finder(m), of_pair(m), patches(m), runs(m), order(m) {}

  SceneryPairFinder pair_finder;
  /// A pair of this step, and what was found of it.
  struct OfPair {
    std::uint32_t place, places;  // in the pair table
    std::uint32_t first, count;   // in patches
    bool kept;                    // nothing was asked: the patches of the last step still hold
  };
  Array<OfPair> of_pair;
  Array<SceneryPatch> patches;
  Array<PairTable::Run> runs;
  Array<std::uint32_t> order;  // beside patches: those of each pair in the order of its records
};

/// Manifolds of all pairs with scenery, and as many records of each as it has patches.
void meet_scenery(const World& world, PairTable& pairs, NarrowReport& report, const NarrowSettings& settings);

/// A pair with scenery, and where its colliders stand.
struct SceneryFrames {
  const Pair& pair;
  const Frame &a, &b;
};

/// Points of the patch that looks one way, where the two stand within a step. A fault leaves none.
/// @param normal  unit, world, from A to B
void meet_patch(const World& world, NarrowReport& report, const NarrowSettings& settings, const SceneryFrames& at,
                const Vec3& normal, Manifold& manifold);

/// Whether a shape touches scenery as the narrow phase would find. A fault counts as a touch.
bool touches_scenery(const World& world, NarrowReport& report, const NarrowSettings& settings, const Pair& pair);

}  // namespace carom::dynamics
