// The plan of a step (carom/plan.h) for people and programs: what ran, for whom, at what cost; what did not, and why.
#pragma once

#include <carom/carom.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/plan_differences.h"

namespace carom::tools {

using Differences = std::map<std::uint32_t, Difference>;

/// Three tables: stages, effects that ran, effects that were left out.
/// @param differences  times of those that work within a stage; of others the stage is named
std::string plan_text(const std::vector<carom_plan_line>& plan, const Differences& differences = {});
nlohmann::json plan_json(const std::vector<carom_plan_line>& plan, const Differences& differences = {});

}  // namespace carom::tools
