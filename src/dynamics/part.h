// The parts of a world that stages write, as types: what is to write one is given it, and none is given the World.
//
// A stage reads by `const World&`, and no part of it changes through that: parts stand in the World by value, or as
// Kept. What is made anew in each step (the plan, rows, lanes) hangs on an Owned, and may be written through a const
// World; so may the ledger, which reads and changes nothing.
#pragma once

#include <type_traits>

#include "dynamics/world.h"

namespace carom::dynamics {

/// Parts of a world that outlive a step.
enum class Part : std::uint32_t {
  colliders,   // frames, bounds, which are disabled, the poses they were placed by
  poses,       // x, q
  velocities,  // v, omega, momentum
  forces,      // of the host, for this step
  quarantine,
  sleep,   // who sleeps, what is kept of them, and for how long bodies have been slow
  memory,  // what solvers remember of bodies
  particles,
  joints,     // their impulses, whether they are broken, whom they keep from touching
  pairs,      // records of the pair table
  impulses,   // of contacts, which the next step starts from
  events,     // who touched, was within and slept in the last step, and what is told of this one
  revisions,  // raised where somebody is taken out
  count
};
inline constexpr std::size_t kPartCount = static_cast<std::size_t>(Part::count);
const char* part_name(Part part);

/// A set of parts.
struct Parts {
  std::uint32_t bits = 0;
  constexpr Parts() = default;
  constexpr Parts(Part part) : bits(1u << static_cast<std::uint32_t>(part)) {}  // one part is a set
  friend constexpr Parts operator|(Parts a, Parts b) { return a |= b; }
  constexpr Parts& operator|=(Parts o) { return bits |= o.bits, *this; }
  constexpr bool has(Part part) const { return bits & Parts(part).bits; }
  constexpr bool meets(Parts o) const { return bits & o.bits; }
  constexpr Parts without(Parts o) const {
    o.bits = bits & ~o.bits;
    return o;
  }
};

constexpr Parts operator|(Part a, Part b) { return Parts(a) | Parts(b); }

/// Which part a type is. What has none outlives no step, or is a report: what a host reads of it.
template <class T>
inline constexpr Parts kPartOf = Parts();
template <>
inline constexpr Parts kPartOf<Colliders> = Part::colliders;
template <>
inline constexpr Parts kPartOf<PlacedPoses> = Part::colliders;
template <>
inline constexpr Parts kPartOf<Poses> = Part::poses;
template <>
inline constexpr Parts kPartOf<Velocities> = Part::velocities;
template <>
inline constexpr Parts kPartOf<HostForces> = Part::forces;
template <>
inline constexpr Parts kPartOf<Quarantine> = Part::quarantine;
template <>
inline constexpr Parts kPartOf<SleepFlags> = Part::sleep;
template <>
inline constexpr Parts kPartOf<Sleep> = Part::sleep;
template <>
inline constexpr Parts kPartOf<SolverMemory> = Part::memory;
template <>
inline constexpr Parts kPartOf<Particles> = Part::particles;
template <>
inline constexpr Parts kPartOf<Joints> = Part::joints;
template <>
inline constexpr Parts kPartOf<PairCounts> = Part::joints;
template <>
inline constexpr Parts kPartOf<PairTable> = Part::pairs;
template <>
inline constexpr Parts kPartOf<Impulses> = Part::impulses;
template <>
inline constexpr Parts kPartOf<Events> = Part::events;
template <>
inline constexpr Parts kPartOf<Revisions> = Part::revisions;

/// Where a world has it.
template <class T>
T& part_of(World& world) {
  static_assert(!std::is_same_v<T, State> && !std::is_same_v<T, Scene>, "parts of it, not all");
  if constexpr (std::is_base_of_v<T, State>)
    return world.state;
  else if constexpr (std::is_same_v<T, Colliders>)
    return world.scene.colliders;
  else if constexpr (std::is_same_v<T, Revisions>)
    return world.scene;
  else if constexpr (std::is_same_v<T, SpringLoads>)
    return world.scene.springs;
  else if constexpr (std::is_same_v<T, Floats>)
    return world.scene.water;
  else if constexpr (std::is_same_v<T, Sleep>)
    return *world.sleep;
  else if constexpr (std::is_same_v<T, Particles>)
    return world.particles;
  else if constexpr (std::is_same_v<T, Joints>)
    return world.joints;
  else if constexpr (std::is_same_v<T, PairCounts>)
    return world.scene.joined;
  else if constexpr (std::is_same_v<T, PairTable>)
    return world.pairs;
  else if constexpr (std::is_same_v<T, Impulses>)
    return world.impulses;
  else if constexpr (std::is_same_v<T, Events>)
    return *world.events;
  else if constexpr (std::is_same_v<T, StepReport>)
    return world.report;
  else if constexpr (std::is_same_v<T, FaultViews>)
    return world.fault_views;
  else if constexpr (std::is_same_v<T, GroupViews>)
    return world.group_views;
  else if constexpr (std::is_same_v<T, BroadPhases>)
    return world.broad;
  else {
    static_assert(std::is_same_v<T, Owned<MeanMotion>>, "no part of a world");
    return world.mean_motion;
  }
}

/// Leave to write some parts: for functions that many stages call, which hand parts on. It turns into each of its
/// parts, and into leave to write fewer. As large as a reference, whatever it gives.
template <class... P>
class Writes {
 public:
  explicit Writes(World& world) : world_(&world) {}
  template <class... Q>
  requires((Writes<Q...>::template gives<P>() && ...)) Writes(const Writes<Q...>& more) : world_(more.world_) {}

  template <class T>
  static constexpr bool gives() {
    return (std::is_same_v<T, P> || ...);
  }
  template <class T>
  requires(gives<T>()) operator T&() const { return part_of<T>(*world_); }

 private:
  template <class...>
  friend class Writes;
  World* world_;
};

}  // namespace carom::dynamics
