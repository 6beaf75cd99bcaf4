// Dials as a host sees them: the one table of the dynamics floor, and the proof that both number it alike.
#include <carom/dial.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "abi/check.h"
#include "dynamics/ccd/continuous.h"
#include "dynamics/constants.h"
#include "dynamics/dials.h"
#include "dynamics/presets.h"

namespace carom::abi {
namespace {

constexpr bool same(Dial inside, std::uint32_t outside) { return static_cast<std::uint32_t>(inside) == outside; }

static_assert(
    same(Dial::integrator, CAROM_DIAL_INTEGRATOR) && same(Dial::rotation, CAROM_DIAL_ROTATION) &&
    same(Dial::substeps, CAROM_DIAL_SUBSTEPS) && same(Dial::solver, CAROM_DIAL_SOLVER) &&
    same(Dial::velocity_iterations, CAROM_DIAL_VELOCITY_ITERATIONS) &&
    same(Dial::position_iterations, CAROM_DIAL_POSITION_ITERATIONS) &&
    same(Dial::velocity_tolerance, CAROM_DIAL_VELOCITY_TOLERANCE) &&
    same(Dial::position_tolerance, CAROM_DIAL_POSITION_TOLERANCE) &&
    same(Dial::restitution_speed, CAROM_DIAL_RESTITUTION_SPEED) &&
    same(Dial::severity_search, CAROM_DIAL_SEVERITY_SEARCH) && same(Dial::groups, CAROM_DIAL_GROUPS) &&
    same(Dial::broad_phase, CAROM_DIAL_BROAD_PHASE) && same(Dial::grid_cell, CAROM_DIAL_GRID_CELL) &&
    same(Dial::contact_distance, CAROM_DIAL_CONTACT_DISTANCE) && same(Dial::pair_routines, CAROM_DIAL_PAIR_ROUTINES) &&
    same(Dial::narrow_phase, CAROM_DIAL_NARROW_PHASE) && same(Dial::simplex, CAROM_DIAL_SIMPLEX) &&
    same(Dial::gjk_tolerance, CAROM_DIAL_GJK_TOLERANCE) && same(Dial::gjk_iterations, CAROM_DIAL_GJK_ITERATIONS) &&
    same(Dial::epa_iterations, CAROM_DIAL_EPA_ITERATIONS) && same(Dial::hybrid_margin, CAROM_DIAL_HYBRID_MARGIN) &&
    same(Dial::warm_separation, CAROM_DIAL_WARM_SEPARATION) && same(Dial::manifold, CAROM_DIAL_MANIFOLD) &&
    same(Dial::cache_distance, CAROM_DIAL_CACHE_DISTANCE) && same(Dial::warm_start, CAROM_DIAL_WARM_START) &&
    same(Dial::carry_over, CAROM_DIAL_CARRY_OVER) && same(Dial::sleep, CAROM_DIAL_SLEEP) &&
    same(Dial::sleep_speed, CAROM_DIAL_SLEEP_SPEED) && same(Dial::sleep_time, CAROM_DIAL_SLEEP_TIME) &&
    same(Dial::direct_sink, CAROM_DIAL_DIRECT_SINK) && same(Dial::direct_ratio, CAROM_DIAL_DIRECT_RATIO) &&
    same(Dial::direct_work, CAROM_DIAL_DIRECT_WORK) && same(Dial::hold_angle, CAROM_DIAL_HOLD_ANGLE) &&
    same(Dial::joint_frequency, CAROM_DIAL_JOINT_FREQUENCY) && same(Dial::joint_damping, CAROM_DIAL_JOINT_DAMPING) &&
    same(Dial::continuous, CAROM_DIAL_CONTINUOUS) && same(Dial::precision, CAROM_DIAL_PRECISION) &&
    same(Dial::joint_order, CAROM_DIAL_JOINT_ORDER) && same(Dial::accuracy_place, CAROM_DIAL_ACCURACY_PLACE) &&
    same(Dial::accuracy_turn, CAROM_DIAL_ACCURACY_TURN) &&
    same(Dial::accuracy_substeps, CAROM_DIAL_ACCURACY_SUBSTEPS) &&
    same(Dial::accuracy_work, CAROM_DIAL_ACCURACY_WORK) && same(Dial::keep_distance, CAROM_DIAL_KEEP_DISTANCE) &&
    same(Dial::count, CAROM_DIAL_COUNT));
static_assert(kSweepNone == CAROM_SWEEP_NONE && kSweepFlagged == CAROM_SWEEP_FLAGGED && kSweepFast == CAROM_SWEEP_FAST);
static_assert(static_cast<std::uint32_t>(Precision::in_float) == CAROM_PRECISION_FLOAT &&
              static_cast<std::uint32_t>(Precision::by_size) == CAROM_PRECISION_AUTO &&
              static_cast<std::uint32_t>(Precision::in_double) == CAROM_PRECISION_DOUBLE);
constexpr bool same(Preset inside, std::uint32_t outside) { return static_cast<std::uint32_t>(inside) == outside; }
static_assert(same(Preset::fast, CAROM_PRESET_FAST) && same(Preset::balanced, CAROM_PRESET_BALANCED) &&
              same(Preset::accurate, CAROM_PRESET_ACCURATE) && same(Preset::reference, CAROM_PRESET_REFERENCE) &&
              same(Preset::count, CAROM_PRESET_COUNT));
static_assert(DialRow::number == CAROM_DIAL_KIND_NUMBER && DialRow::integer == CAROM_DIAL_KIND_INTEGER &&
              DialRow::choice == CAROM_DIAL_KIND_CHOICE);

/// Letters to be added, left out or changed until one name is the other, of the first 40.
std::size_t letters_apart(std::string_view a, std::string_view b) {
  constexpr std::size_t kMost = 40;
  a = a.substr(0, kMost), b = b.substr(0, kMost);
  std::array<std::size_t, kMost + 1> row{};
  for (std::size_t k = 0; k <= b.size(); ++k) row[k] = k;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t corner = row[0];
    row[0] = i;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      const std::size_t changed = corner + (a[i - 1] != b[k - 1]);
      corner = row[k];
      row[k] = std::min({row[k] + 1, row[k - 1] + 1, changed});
    }
  }
  return row[b.size()];
}

const char* nearest_dial(const char* name) {
  const auto apart = [&](const DialRow& row) { return letters_apart(name, row.name); };
  return std::ranges::min_element(dial_table(), {}, apart)->name;
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_dial_get_info(uint32_t dial, carom_dial_info* info, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!known(call, 1, "dial", dial, kDialCount) || !fillable(call, 2, "info", info)) return;
    const DialRow& row = dial_table()[dial];
    carom_dial_info full{};
    full.dial = dial;
    full.kind = row.kind;
    full.choice_count = row.choice_count;
    full.name = row.name;
    full.unit = row.unit;
    full.summary = row.summary;
    full.choices = row.choices;
    full.min = row.min;
    full.max = row.max;
    full.initial = row.initial;
    write_struct(full, info);
  });
}

int32_t carom_dial_get_count(uint32_t* count) {
  if (!count) return CAROM_E_NULL_ARGUMENT;
  *count = static_cast<uint32_t>(kDialCount);
  return CAROM_OK;
}

int32_t carom_dial_find(const char* name, uint32_t* dial, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "name", name) || !present(call, 2, "dial", dial)) return;
    for (const DialRow& row : dial_table())
      if (std::strcmp(row.name, name) == 0) {
        *dial = static_cast<uint32_t>(row.dial);
        return;
      }
    for (const ConstantRow& row : constant_table())
      if (std::strcmp(row.name, name) == 0) {
        call.fail(CAROM_E_READ_ONLY, 1, "%s is no dial but a constant: %g", row.name, row.value);
        return;
      }
    call.fail(CAROM_E_NOT_FOUND, 1, "there is no dial \"%.120s\"; did you mean %s?", name, nearest_dial(name));
    call.advise(
        "names are those of carom/dial.h in small letters, without CAROM_DIAL_; carom_dial_get_info() gives them");
  });
}

int32_t carom_constant_get_count(uint32_t* count) {
  if (!count) return CAROM_E_NULL_ARGUMENT;
  *count = static_cast<uint32_t>(constant_table().size());
  return CAROM_OK;
}

int32_t carom_constant_get_info(uint32_t constant, carom_constant_info* info, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const auto table = constant_table();
    if (!known(call, 1, "constant", constant, static_cast<uint32_t>(table.size())) || !fillable(call, 2, "info", info))
      return;
    const ConstantRow& row = table[constant];
    carom_constant_info full{};
    full.constant = constant;
    full.name = row.name;
    full.unit = row.unit;
    full.reason = row.reason;
    full.consequence = row.consequence;
    full.value = row.value;
    write_struct(full, info);
  });
}

const char* carom_preset_name(uint32_t preset) {
  return preset < kPresetCount ? name_of(static_cast<Preset>(preset)) : "?";
}

int32_t carom_preset_get_dial(uint32_t preset, uint32_t dial, double* value, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!known(call, 1, "preset", preset, kPresetCount) || !known(call, 2, "dial", dial, kDialCount) ||
        !present(call, 3, "value", value))
      return;
    const std::optional<Real> set = preset_value(static_cast<Preset>(preset), static_cast<Dial>(dial));
    if (set)
      *value = *set;
    else
      call.fail(CAROM_E_NOT_FOUND, 2, "presets leave dial %s alone", dial_table()[dial].name);
  });
}

}  // extern "C"
