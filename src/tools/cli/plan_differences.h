// What effects cost that work within the loops of their stage (friction, limits, ...): such a loop has no place for a
// clock. From one state the world steps with the effect and without it.
#pragma once

#include <map>

#include "host/host.h"

namespace carom::tools {

struct Difference {
  double seconds;  // s a step: median with it less median without it; negative where its absence makes more work
  double
      spread;  // s: half the range in which the middle half of the steps with it fell; less is not to be told from none
};

/// By effect, for those of a plan that ran within their stage. The world is left in the state it had.
/// Everybody is awake in these steps, since forbidding wakes. A second step is timed: the first one makes a new plan.
/// @param plan     of the world's last step
/// @param seconds  s of wall clock to spend, about; never less than five steps of each kind
std::map<std::uint32_t, Difference> time_by_difference(World& world, double dt,
                                                       const std::vector<carom_plan_line>& plan, double seconds);

}  // namespace carom::tools
