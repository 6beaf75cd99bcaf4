// What a report measures for itself, where no file has it: costs of effects and of distances, through the C ABI.
#pragma once

#include "accuracy/page/report.h"

namespace carom::tools::accuracy {

/// Time of carom_shape_distance() and width of its bracket at tolerances from 1e-1 to 1e-13, on the generic path: pairs
/// of a few families, apart and in overlap. About a second.
std::vector<Extras::Tolerance> measure_tolerances(Engine& engine);

/// Costs of effects that the plan of a step times by themselves, in scenes of `carom list` that have participants for them.
std::vector<Extras::Effect> measure_effects(Engine& engine);

/// The table that `effect_costs --csv` writes.   @throws Error
std::vector<Extras::Effect> read_effects(const std::string& path);

}  // namespace carom::tools::accuracy
