// The stages of a step as one table: function, effect, what it reads and writes, how the ledger accounts for it.
//
// step.cpp loops over it; the picture in ../README.md is made from it (tests/unit/dynamics/test_stages). A stage is a
// function of a const World, the time, and the parts that it writes; what it writes is read off its parameters. One
// that moves bodies and has no account does not compile; one that takes a mutable World does not either. Who writes a
// part all the same, by a way round, is found by run_watched(), which debug builds use.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "dynamics/ledger/ledger.h"

namespace carom::dynamics {

/// What a stage function takes of a world, by the type of a parameter: the world to read, a part or some to write, the
/// time. That is all it can write, so that it is what it declares.
template <class A>
struct Taken;
template <>
struct Taken<const World&> {
  static constexpr Parts writes{};
  static const World& from(World& world, const StepTime&) { return world; }
};
template <>
struct Taken<const StepTime&> {
  static constexpr Parts writes{};
  static const StepTime& from(World&, const StepTime& time) { return time; }
};
template <class P>
struct Taken<P&> {
  static_assert(!std::is_same_v<P, World>, "a stage receives what it writes, not a mutable World");
  static constexpr Parts writes = kPartOf<P>;
  static P& from(World& world, const StepTime&) { return part_of<P>(world); }
};
template <class... P>
struct Taken<Writes<P...>> {
  static constexpr Parts writes = (Parts() | ... | kPartOf<P>);
  static Writes<P...> from(World& world, const StepTime&) { return Writes<P...>(world); }
};

/// How often a stage runs where substeps go by island, @see accuracy/README.md
enum class ByIsland : std::uint8_t {
  no,     // once, for all
  too,    // once, and in each pass for its islands
  alone,  // in each pass alone
};

struct StageEntry {
  std::string_view name, what;
  void (*run)(World&, const StepTime&) = nullptr;
  Stage stage{};                      // as which a host sees its time; it runs if this has participants
  std::size_t effect = kEffectCount;  // the effect that it belongs to, if it is one's alone
  Parts reads{};                      // declared: const World& gives them all
  Parts writes{};                     // derived from the function, @see stage()
  LedgerAccount account = LedgerAccount::none;
  bool each_substep = false;
  ByIsland by_island = ByIsland::no;  // of those that do not run in each substep
};

/// What a stage function makes of an entry: how it runs, and what it writes.
template <class... A>
consteval Parts writes_of(void (*)(A...)) {
  return (Parts() | ... | Taken<A>::writes);
}
template <auto function>
struct Runs;
template <class... A, void (*function)(A...)>
struct Runs<function> {
  static void run(World& world, const StepTime& time) { function(Taken<A>::from(world, time)...); }
};
template <auto function>
consteval StageEntry stage(StageEntry entry) {
  entry.run = Runs<function>::run;
  entry.writes = writes_of(function);
  return entry;
}

/// In the order in which they run; those of each substep stand together.
std::span<const StageEntry> stage_table();

/// A number for each part of a world: it changes, but for one chance in 2^64, where the part does.
std::array<std::uint64_t, kPartCount> prints_of(const World& world);

/// Run a stage and see what it changes: slow, for debug builds and tests.
/// @return  parts that it changed and was not given
Parts run_watched(const StageEntry& entry, World& world, const StepTime& time);

}  // namespace carom::dynamics
