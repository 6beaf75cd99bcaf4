// Second differences by windows of a second each.
#include "jury/jitter.h"

#include <algorithm>

namespace carom::tools::jury {

double Jitters::step(std::size_t member, const Member& of, const State& state, double dt) {
  Window& w = windows_[member];
  const Vec center = state.position + state.orientation * of.center;
  const double arm = of.size / 2;
  const Points now = {center, center + state.orientation * Vec(arm, 0, 0), center + state.orientation * Vec(0, arm, 0)};
  if (w.steps == 0 && w.last.empty()) w.first = now;
  double moved = 0, second = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    moved = std::max(moved, (now[i] - w.first[i]).norm());
    if (w.last.size() == 2) second = std::max(second, (now[i] - 2 * w.last[1][i] + w.last[0][i]).norm());
  }
  w.stays = w.stays && moved < std::min(0.03, 0.1 * of.size);
  if (w.last.size() == 2) w.last.erase(w.last.begin());
  w.last.push_back(now);
  w.shaken += second, w.time += dt, ++w.steps;
  if (w.time < 1 - dt / 2) return 0;
  const double mean = w.stays ? w.shaken / static_cast<double>(w.steps) : 0;
  const double shakes = std::min(mean, w.before);
  w.before = mean;
  w.first = now, w.time = w.shaken = 0, w.steps = 0, w.stays = true;
  return shakes;
}

}  // namespace carom::tools::jury
