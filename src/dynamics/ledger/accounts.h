// Parts of the ledger: the account of one body, and what is entered in it.
#pragma once

#include "dynamics/body_state.h"
#include "dynamics/ledger/ledger.h"

namespace carom::dynamics {

/// Roundings that a account may add up, of the magnitude of its terms: some ten columns, each a difference of
/// velocities that is multiplied and added a few times.
inline constexpr Real kRoundings = 64 * kUnitRoundoff;

inline Ledger& ledger_of(const World& world) { return *world.ledger; }
inline bool is_dynamic(const World& world, std::uint32_t i) { return world.scene.inv_mass[i] > 0; }
/// m/s^2, what the potential is of.
inline Vec3 pull_on(const World& world, std::uint32_t i) {
  if (world.scene.modes.forbids(+EffectId::gravity, i)) return Vec3::zero();
  return world.scene.gravity_factor_of(i) * world.scene.gravity;
}
/// What a body has now.
Amount amount_now(const World& world, std::uint32_t i);

/// What a solver drove out of the finite world just now, and the next kick will find. Until then nothing is entered:
/// the ledger has it as its phase began.
bool is_lost(const World& world, std::uint32_t i);
/// Those of each_awake() whose numbers make sense.
template <class F>
void each_accounted(const World& world, F&& f) {
  each_awake(world, [&](std::uint32_t i) {
    if (!is_lost(world, i)) f(i);
  });
}

/// A body's phase begins with the state as it is.
void open_phase(const World& world, std::uint32_t i);
/// What velocities changed since the last account, into a column.
void see_kick(const World& world, std::uint32_t i, std::size_t column);
/// The phase of a body ends with the velocities that were seen last: enter its kicks. They stay.
void close_phase(const World& world, std::uint32_t i);
void clear_kicks(Ledger& l, std::uint32_t i);

bool is_as_seen(const World& world, std::uint32_t i);
/// All that changed since the last account, poses with it, under one cause; a new phase begins.
void account_change(const World& world, std::uint32_t i, Cause cause);
/// Whose state left the finite world in this stage: what its phase had entered so far makes no sense. It is entered.
bool was_lost(const World& world, std::uint32_t i);

/// Terms of a account, for the bound of its rounding.
/// @param speed, spin  m/s, rad/s: sums of magnitudes
void may_round(const World& world, std::uint32_t i, Real speed, Real spin);

// ---- particles.cpp ----
/// Take a set as it is.   @param host  what changed since the last time is a host's
void take_set(const World& world, std::uint32_t set, bool host);
/// What a step did to particles.
void account_flight(const World& world, const StepTime& time);

}  // namespace carom::dynamics
