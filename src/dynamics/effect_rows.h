// Effects by number, and what a host says about them beyond what its scene calls for.
#pragma once

#include <array>

#include "core/memory.h"

namespace carom::dynamics {

/// What may happen in a step; as CAROM_EFFECT_*. What reads velocities comes before what does not, in each of the two
/// groups of force effects.
enum class EffectId : std::uint32_t {
  gyroscopic,
  linear_damping,
  angular_damping,
  gravity,
  user_force,
  user_torque,
  collision,
  friction,
  restitution,
  rolling_resistance,
  spinning_resistance,
  sleep,
  particles,
  filter,
  sensor,
  joints,
  scenery,
  continuous,
  surface_velocity,
  axis_locks,
  drag,
  wind,
  fields,
  springs,
  buoyancy,
  response,
  joint_limits,
  joint_motors,
  events,
  ledger,
  magnetism,
  count
};
/// Its place in tables.
constexpr std::size_t operator+(EffectId id) { return static_cast<std::size_t>(id); }
inline constexpr std::size_t kEffectCount = +EffectId::count;

/// As CAROM_MODE_*.
enum class EffectMode : std::uint8_t { as_needed, forbid, force };

/// A bit for each row.
using RowBits = std::uint64_t;
static_assert(kEffectCount <= 64, "a bit each");
inline constexpr RowBits row_bit(std::size_t row) { return RowBits(1) << row; }

/// What a host forbids and forces, for the world and for single bodies.
struct EffectModes {
  explicit EffectModes(Memory* m) : forbidden_of(m), forced_of(m) {}

  RowBits forbidden = 0, forced = 0;       // for the world
  RowBits forbidden_anywhere = 0;          // for the world, or for some body since the world was made
  Array<RowBits> forbidden_of, forced_of;  // by body slot; the first so many, nothing from there on

  EffectMode of_world(std::size_t row) const {
    if (forbidden & row_bit(row)) return EffectMode::forbid;
    return forced & row_bit(row) ? EffectMode::force : EffectMode::as_needed;
  }
  EffectMode of_body(std::size_t row, std::uint32_t body) const {
    if (body < forbidden_of.size() && forbidden_of[body] & row_bit(row)) return EffectMode::forbid;
    return body < forced_of.size() && forced_of[body] & row_bit(row) ? EffectMode::force : EffectMode::as_needed;
  }
  bool forbids(std::size_t row) const { return forbidden & row_bit(row); }
  bool forbids(std::size_t row, std::uint32_t body) const {
    return forbidden_anywhere & row_bit(row) && (forbids(row) || of_body(row, body) == EffectMode::forbid);
  }
  bool forces(std::size_t row, std::uint32_t body) const {
    return of_world(row) == EffectMode::force || of_body(row, body) == EffectMode::force;
  }
};

}  // namespace carom::dynamics
