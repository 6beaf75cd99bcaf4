// The dials of a world: one table of names, bounds and defaults, one struct of their values.
#pragma once

#include <array>
#include <cstdint>

#include "core/vec.h"

namespace carom::dynamics {

/// Same numbers as CAROM_DIAL_* (a static_assert in src/abi/dial.cpp holds them together).
enum class Dial : std::uint32_t {
  integrator,
  rotation,
  substeps,
  solver,
  velocity_iterations,
  position_iterations,
  velocity_tolerance,
  position_tolerance,
  restitution_speed,
  severity_search,
  groups,
  broad_phase,
  grid_cell,
  contact_distance,
  pair_routines,
  narrow_phase,
  simplex,
  gjk_tolerance,
  gjk_iterations,
  epa_iterations,
  hybrid_margin,
  warm_separation,
  manifold,
  cache_distance,
  warm_start,
  carry_over,
  contact_frequency,
  contact_damping,
  push_speed,
  sleep,
  sleep_speed,
  sleep_time,
  direct_sink,
  direct_ratio,
  direct_work,
  hold_angle,
  joint_frequency,
  joint_damping,
  continuous,
  precision,
  joint_order,
  accuracy_place,
  accuracy_turn,
  accuracy_substeps,
  accuracy_work,
  keep_distance,
  count
};
inline constexpr std::size_t kDialCount = static_cast<std::size_t>(Dial::count);

/// Values of Dial::precision.
enum class Precision : std::uint32_t { in_float, by_size, in_double };

struct DialRow {
  Dial dial;
  enum Kind : std::uint32_t { number, integer, choice } kind;
  const char* name;
  const char* unit;
  const char* summary;
  const char* const* choices;  // [choice_count], cheap to exact where there is such an order
  std::uint32_t choice_count;
  Real min, max, initial;
};

/// The one table. Feeds setters, bounds, command line and docs.
const std::array<DialRow, kDialCount>& dial_table();

/// Values, by Dial. Read through the typed accessors where a stage is planned, never in a body loop.
struct Dials {
  std::array<Real, kDialCount> value;
  Dials();  // every dial at its initial value
  Real operator[](Dial d) const { return value[static_cast<std::size_t>(d)]; }
  Real& operator[](Dial d) { return value[static_cast<std::size_t>(d)]; }
  std::uint32_t choice(Dial d) const { return static_cast<std::uint32_t>((*this)[d]); }
  int whole(Dial d) const { return static_cast<int>((*this)[d]); }
};

}  // namespace carom::dynamics
