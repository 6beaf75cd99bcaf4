// The report: findings first, then every diagram with how to read it, in one HTML file.
#pragma once

#include <string>

#include "accuracy/sweep/rows.h"

namespace carom::tools::accuracy {

/// What stands beside a sweep; empty: its section says how to get it.
struct Extras {
  struct Effect {
    std::string name, unit;     ///< "drag", "body"
    double ns = 0, spread = 0;  ///< a participant and step
  };
  struct Tolerance {
    std::string pair;          ///< "box on box"
    double tolerance = 0;      ///< asked for, relative
    double ns = 0, width = 0;  ///< of a query; m, of the bracket that it returns
  };
  std::vector<Effect> effects;
  std::vector<Tolerance> tolerances;
};

std::string report_page(const Sweep& sweep, const Extras& extras);

/// One diagram of a report as a drawing of its own: "wp:slide", "order:Joints", "map:massratio", "map:stack",
/// "profile:solvers", "profile:engines".   @throws Error that lists them
std::string report_drawing(const Sweep& sweep, const std::string& name);

}  // namespace carom::tools::accuracy
