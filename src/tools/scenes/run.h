// Runs a stage and measures it: steps per second, time per stage, where everything ended.
#pragma once

#include <functional>

#include "scenes/scene.h"

namespace carom::tools {

/// What a run cost and left behind.
struct RunSummary {
  std::uint64_t steps = 0;
  double simulated = 0;                                 ///< s
  double min_rate = 0, average_rate = 0, max_rate = 0;  ///< steps/s: slowest step, all steps, fastest step
  double total_seconds = 0;                             ///< s of computing, by the library's own clock
  std::vector<double> stage_seconds;                    ///< s, by CAROM_STAGE_*
  carom_step_report last{};                             ///< of the last step
  std::uint64_t most_contact_points = 0;
  double worst_penetration = 0;                             ///< m, over all steps
  std::uint64_t wedged_groups = 0, rejected_solutions = 0;  ///< over all steps
  std::uint64_t faults = 0;                                 ///< of shapes, over all steps
  std::vector<carom_fault> first_faults;                    ///< of the first step that had any
  std::uint64_t hash = 0;                                   ///< of the end state
  carom_growth growth{};                                    ///< from the beginning; no steps: not measured
};

/// Step until `seconds` are simulated (at least one step).
/// @param dt    s   @param each  called after every step, with its report; return false to stop early; may be empty
RunSummary simulate(Stage& stage, Observer* observer, double seconds, double dt,
                    const std::function<bool(const carom_step_report&)>& each = {});

/// Where the dynamic bodies of one kind ended.
struct KindSummary {
  std::string kind;
  std::size_t count = 0, moving = 0, escaped = 0, not_finite = 0;
  double low = 0, mean = 0, high = 0;  ///< m, y of the origins that are finite
  double fastest = 0;                  ///< m/s
};

/// One row per kind, in order of first appearance. A body moves if it is faster than 0.05 m/s.
std::vector<KindSummary> where_it_ended(const Stage& stage);

}  // namespace carom::tools
