// What is got of an accuracy that is asked for, and what it costs beside the best fixed substeps.
#pragma once

#include <string>
#include <vector>

#include "accuracy/run.h"

namespace carom::tools::accuracy {

/// A scene at a tolerance.
struct Got {
  std::string scene, what, unit;
  double tolerance = 0;  ///< m or rad per second of motion
  double asked = 0;      ///< m or rad: over the run
  double got = 0;        ///< m or rad
  double ms = 0;         ///< of computing, per simulated second
  double fixed_ms = 0;   ///< of the cheapest fixed setting that errs no more; 0: none does
  std::string fixed;     ///< that setting
};

/// Scenes whose truth does not depend on dials, and whose error is a place or a turn.
std::vector<const Challenge*> scenes_to_ask();

/// @param tolerances  m and rad per second of motion   @param patience  s of computing a run   @throws Error
std::vector<Got> ask(Engine& engine, const Challenge& challenge, const std::vector<double>& tolerances,
                     double patience);

/// A pile at rest, a fast linkage and a flying top in one world, and the linkage alone.
struct Mixed {
  double tolerance = 0;
  double linkage_ms = 0, all_ms = 0;  ///< of computing, per simulated second: of the linkage alone; of all three
  double all_fixed_ms = 0;            ///< of all, with the substeps of the linkage for everybody
  double linkage_substeps = 0, pile_substeps = 0, top_substeps = 0;  ///< mean a step

  /// What a step took: substeps times stages of the order, of all runs.
  struct Step {
    double time = 0;  ///< s
    double pile = 0, linkage = 0, top = 0;
  };
  std::vector<Step> steps;
};
Mixed ask_mixed(Engine& engine, double tolerance, double seconds);
/// What each of the three took, step by step, as a drawing.
std::string draw_mixed(const Mixed& mixed);

}  // namespace carom::tools::accuracy
