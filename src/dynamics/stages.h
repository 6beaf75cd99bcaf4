// The stages of a step as one table: what runs, whose it is, what it reads and writes, how the ledger books it.
//
// step.cpp loops over it; the picture in ../README.md is made from it (tests/unit/dynamics/test_stages); a stage that
// moves bodies and has no booking does not compile; one that writes what it does not declare is found by StageWatch,
// which debug builds run.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "dynamics/ledger/ledger.h"

namespace carom::dynamics {

/// Parts of a world that outlive a step. What is made anew in each (the plan, rows, lanes, reports) is scratch, and is
/// not listed.
enum class Part : std::uint32_t {
  colliders,   // frames, bounds, which are disabled
  poses,       // x, q
  velocities,  // v, omega, momentum
  forces,      // of the host, for this step
  quarantine,
  sleep,       // who sleeps
  particles,
  joints,      // their impulses, and whether they are broken
  pairs,       // records of the pair table
  impulses,    // of contacts, which the next step starts from
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

struct StageEntry {
  std::string_view name, what;
  void (*run)(World&, const StepTime&);
  Stage stage;                        // as which a host sees its time; it runs if this has customers
  std::size_t effect = kEffectCount;  // of the one effect whose it is, if it is one's alone
  Parts reads{}, writes{};
  Booking booking = Booking::none;
  bool each_substep = false;
};

/// In the order in which they run; those of each substep stand together.
std::span<const StageEntry> stage_table();

/// A number for each part of a world: it changes, but for one chance in 2^64, where the part does.
std::array<std::uint64_t, kPartCount> prints_of(const World& world);

/// Run a stage and see what it changes: slow, for debug builds and tests.
/// @return  parts that it changed without declaring it
Parts run_watched(const StageEntry& entry, World& world, const StepTime& time);

}  // namespace carom::dynamics
