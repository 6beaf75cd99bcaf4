// Fronts, leads, slopes, profiles.
#include "accuracy/sweep/front.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::tools::accuracy {
namespace {
constexpr double kNever = std::numeric_limits<double>::infinity();
}

std::vector<std::size_t> pareto_front(const std::vector<Point>& points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (std::isfinite(points[i].cost) && std::isfinite(points[i].error)) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a].cost != points[b].cost ? points[a].cost < points[b].cost : points[a].error < points[b].error;
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (front.empty() || points[i].error < points[front.back()].error) front.push_back(i);
  return front;
}

double error_within(const std::vector<Point>& points, double cost) {
  double least = kNever;
  for (const Point& p : points)
    if (p.cost <= cost) least = std::min(least, p.error);
  return least;
}

double cost_within(const std::vector<Point>& points, double error) {
  double least = kNever;
  for (const Point& p : points)
    if (p.error <= error) least = std::min(least, p.cost);
  return least;
}

double lead_of(const Point& theirs, const std::vector<Point>& ours) {
  const double error = error_within(ours, theirs.cost), cost = cost_within(ours, theirs.error);
  if (error <= theirs.error) return error == theirs.error ? 1 : error / theirs.error;
  const double by_error = theirs.error > 0 ? error / theirs.error : kNever;
  return std::min(by_error, cost / theirs.cost);
}

Slope fit_slope(const std::vector<std::pair<double, double>>& steps_and_errors, double floor) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const auto& [dt, error] : steps_and_errors) {
    if (!(error > floor) || !std::isfinite(error)) continue;
    const double x = std::log(dt), y = std::log(error);
    ++n, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double spread = n * sxx - sx * sx;
  if (n < 3 || !(spread > 0)) return {};
  Slope slope;
  slope.order = (n * sxy - sx * sy) / spread;
  slope.at_1s = std::exp((sy - slope.order * sx) / n);
  slope.points = static_cast<int>(n);
  return slope;
}

std::vector<std::vector<double>> profile_ratios(const std::vector<std::vector<double>>& costs) {
  std::vector<std::vector<double>> ratios(costs.size());
  for (std::size_t p = 0; !costs.empty() && p < costs[0].size(); ++p) {
    double best = kNever;
    for (const auto& solver : costs) best = std::min(best, solver[p]);
    for (std::size_t s = 0; s < costs.size(); ++s)
      if (std::isfinite(costs[s][p])) ratios[s].push_back(best > 0 ? costs[s][p] / best : 1);
  }
  for (auto& list : ratios) std::sort(list.begin(), list.end());
  return ratios;
}

double profile_at(const std::vector<double>& ratios, std::size_t problems, double tau) {
  const auto solved = std::upper_bound(ratios.begin(), ratios.end(), tau) - ratios.begin();
  return problems ? static_cast<double>(solved) / static_cast<double>(problems) : 0;
}

}  // namespace carom::tools::accuracy
