// Performance profiles over the suite.
#include <algorithm>
#include <cmath>

#include "accuracy/page/figures.h"
#include "report/plot.h"

namespace carom::tools::accuracy {

std::string performance_profile(const std::vector<const SceneView*>& scenes, const std::vector<Solver>& solvers,
                                const std::string& title) {
  std::vector<std::vector<double>> costs(solvers.size());
  for (std::size_t s = 0; s < solvers.size(); ++s)
    for (const SceneView* scene : scenes)
      costs[s].push_back(cost_to_bound(*scene, solvers[s].engine, solvers[s].prefix));
  const auto ratios = profile_ratios(costs);
  double furthest = 10;
  for (const auto& list : ratios)
    if (!list.empty()) furthest = std::max(furthest, list.back());
  report::LinePlot plot;
  plot.title = title;
  plot.x = {"times the least cost that any of them takes", report::Scale::log, false, {}};
  plot.y = {"share of scenes within their bound, %", report::Scale::linear, true, {0, 20, 40, 60, 80, 100}};
  plot.dense = true;
  plot.note = std::to_string(scenes.size()) + " scenes; at any step from 1/30 to 1/960 s";
  for (std::size_t s = 0; s < solvers.size(); ++s) {
    report::Series series{solvers[s].name, {}, static_cast<int>(s) % 6, false};
    const auto share = [&](double tau) { return 100 * profile_at(ratios[s], scenes.size(), tau); };
    series.points.push_back({1, share(1)});
    for (const double tau : ratios[s]) {
      series.points.push_back({tau, series.points.back().y});
      series.points.push_back({tau, share(tau)});
    }
    series.points.push_back({furthest, series.points.back().y});
    plot.series.push_back(std::move(series));
  }
  return report::draw(plot);
}

}  // namespace carom::tools::accuracy
