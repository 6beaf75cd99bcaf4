// Dials x step sizes: every entry (an engine at a setting) on every scene it takes part in, from coarse steps to fine
// ones, until a budget of time is spent.
#pragma once

#include <functional>

#include "accuracy/run.h"
#include "accuracy/sweep/rows.h"
#include "accuracy/sweep/settings.h"

namespace carom::tools::accuracy {

/// An engine at a setting.
struct Entry {
  std::string engine, setting;
  std::function<bool(const Challenge&)> takes_part;
  std::vector<std::string> dials;                       ///< of Carom
  std::function<std::unique_ptr<Mover>(Stage&)> mover;  ///< of another engine
};
/// Carom at every setting of the table that matters to a scene.
std::vector<Entry> carom_entries();

struct SweepPlan {
  std::vector<const Challenge*> scenes;
  std::vector<Entry> entries;
  std::vector<double> steps;  ///< s, from coarse to fine
  double seconds = 600;       ///< of the wall clock, for all of it; what does not fit is left out, finest steps first
  double most_per_run = 20;   ///< s of computing, beyond which a run is left out
  bool maps = true;           ///< also where a column stands: its height, its mass ratio
};

struct Progress {
  std::string what;     ///< "slide: Carom, auto, 4 substeps, 1/240 s"
  double done = 0;      ///< of the budget or of the work, whichever is further on, 0 to 1
  double seconds_left;  ///< at most
};

/// @param tell  called before each run; may be empty   @throws Error
Sweep sweep(Engine& engine, const SweepPlan& plan, const std::function<void(const Progress&)>& tell);

}  // namespace carom::tools::accuracy
