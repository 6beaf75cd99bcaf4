// Presets: settings of all dials that trade accuracy for time, as points on the measured front.
#pragma once

#include <optional>

#include "dynamics/dials.h"

namespace carom::dynamics {

enum class Preset : std::uint32_t { fast, balanced, accurate, reference, count };
inline constexpr std::size_t kPresetCount = static_cast<std::size_t>(Preset::count);

const char* name_of(Preset preset);
/// What a preset sets a dial to; nothing for a dial that presets leave alone. Balanced is what a new world has.
std::optional<Real> preset_value(Preset preset, Dial dial);

}  // namespace carom::dynamics
