// Runs a scene with given dials and adds up what the step reports say: the raw material of every figure.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "scenes/run.h"

namespace carom::report {

struct RunSpec {
  std::string scene;               ///< "falling"
  tools::Settings settings;        ///< knobs of the scene
  std::vector<std::string> dials;  ///< "broad_phase=grid"; set after the scene is built
  double seconds = 0;              ///< simulated; 0: what the scene suggests
};

/// A run's summary, and means over its steps.
struct Measured {
  tools::RunSummary run;
  double contacts = 0;       ///< contact points
  double largest_group = 0;  ///< contact points in the largest contact group
  double broad_pairs = 0;    ///< pairs that the broad phase reported

  double share(std::uint32_t stage) const { return run.stage_seconds[stage] / run.total_seconds; }
  double ms() const { return 1e3 * run.total_seconds / static_cast<double>(run.steps); }  ///< a step, mean
  double ms(std::uint32_t stage) const { return ms() * share(stage); }                    ///< a step's stage, mean
};

/// Told how far a run is, 0..1, a few times a second at most.
using Progress = std::function<void(double)>;

/// Build the scene in a world of its own and run it. A run that took less than half a second is repeated twice and the
/// fastest is kept: the same input does the same work, so only the machine's other business differs.
/// @throws tools::Error (scene, knob, dial or plugin missing; a step failed)
Measured measure(tools::Engine& engine, const RunSpec& spec, const Progress& progress);

}  // namespace carom::report
