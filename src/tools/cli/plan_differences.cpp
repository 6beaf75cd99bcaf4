// Steps with an effect and steps without it, in turns, so that what else the machine does meets both.
#include "cli/plan_differences.h"

#include <algorithm>
#include <chrono>

namespace carom::tools {
namespace {

constexpr int kFewest = 5, kMost = 99;  // steps of a kind

bool works_in_stage(const carom_plan_line& line) {
  return line.effect != CAROM_PLAN_NO_EFFECT && line.runs && line.timing == CAROM_TIME_IN_STAGE;
}

/// Seconds of the second step from a state with an effect's mode set.
double second_step(World& world, double dt, const std::vector<char>& state, const carom_plan_line& line,
                   std::uint32_t mode) {
  world.restore(state, "the state before");
  world.set_effect(line.name, CAROM_MODE_FORBID);  // and back again: the same edit, who sleeps is woken
  world.set_effect(line.name, mode);
  world.step(dt);
  world.step(dt);
  return world.report().total_seconds;
}

/// The element at a share of the sorted values.
double at_share(std::vector<double>& values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

std::map<std::uint32_t, Difference> time_by_difference(World& world, double dt,
                                                       const std::vector<carom_plan_line>& plan, double seconds) {
  std::map<std::uint32_t, Difference> found;
  const auto effects = std::count_if(plan.begin(), plan.end(), works_in_stage);
  if (effects == 0) return found;
  const std::vector<char> state = world.save();
  for (const carom_plan_line& line : plan) {
    if (!works_in_stage(line)) continue;
    const auto end =
        std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds / static_cast<double>(effects));
    std::vector<double> with, without;
    for (int i = 0; i < kFewest || (i < kMost && std::chrono::steady_clock::now() < end); ++i) {
      with.push_back(second_step(world, dt, state, line, line.mode));
      without.push_back(second_step(world, dt, state, line, CAROM_MODE_FORBID));
    }
    const double spread = 0.5 * (at_share(with, 0.75) - at_share(with, 0.25));
    found[line.effect] = {at_share(with, 0.5) - at_share(without, 0.5), spread};
  }
  world.restore(state, "the state before");
  return found;
}

}  // namespace carom::tools
