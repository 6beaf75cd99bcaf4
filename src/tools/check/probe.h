// Puts a shape plugin on trial: thousands of directions of every length through its support function.
#pragma once

#include <string>
#include <vector>

#include "check/verdict.h"

namespace carom::tools {

struct ProbeRequest {
  std::string path;            ///< absolute
  std::vector<double> params;  ///< the shape to judge; empty: several sets within the plugin's bounds
  bool params_given = false;
};

/// Judge the plugin; findings, progress and the call in flight go to the verdict as they come. Runs in a child process.
/// What is asked of every call: success; finite; the same bits again, also with several threads asking; as far along
/// the direction whatever the direction's length; and no other point farther along it, which over all pairs is exactly
/// the condition that the points come from one convex set.
void probe(Verdict& verdict, const ProbeRequest& request);

}  // namespace carom::tools
