// The plan of a step (carom/plan.h) for people and programs: what ran, for whom, at what cost; what did not, and why.
#pragma once

#include <carom/carom.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace carom::tools {

/// Three tables: stages, effects that ran, effects that were left out.
std::string plan_text(const std::vector<carom_plan_line>& plan);
nlohmann::json plan_json(const std::vector<carom_plan_line>& plan);

}  // namespace carom::tools
