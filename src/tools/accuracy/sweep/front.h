// What rows say when they are put side by side: who beats whom, by how much, and in which order errors fall.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "accuracy/sweep/rows.h"

namespace carom::tools::accuracy {

/// A run as a point: less is better in both.
struct Point {
  double cost = 0, error = 0;
};

/// Points that no other beats: none costs at most as much and errs less, or errs at most as much and costs less.
/// @return  indices, by cost; of equal points the first; points that are not finite are none
std::vector<std::size_t> pareto_front(const std::vector<Point>& points);

/// The least error for at most this cost; infinite where nothing is as cheap.   And the least cost for such an error.
double error_within(const std::vector<Point>& points, double cost);
double cost_within(const std::vector<Point>& points, double error);

/// How far a point of theirs is beyond our front: the factor by which it errs less at its cost, or costs less at its
/// error, whichever is smaller; 1 or less: it is not. Infinite: we have nothing as cheap, and nothing as exact.
double lead_of(const Point& theirs, const std::vector<Point>& ours);

/// The order in which errors fall with the step: least squares of log error over log step.
struct Slope {
  double order = 0, at_1s = 0;  ///< error = at_1s dt^order
  int points = 0;               ///< 0: fewer than three could be used
};
/// @param floor  errors at or below it are rounding, and left out
Slope fit_slope(const std::vector<std::pair<double, double>>& steps_and_errors, double floor);

/// Performance profiles (Dolan and More): what share of problems a solver solves within tau times the least cost that
/// any takes.   @param costs  [solver][problem]; infinite: not solved
/// @return  [solver] the ratios of problems that it solves, ascending; a problem that none solves counts for none
std::vector<std::vector<double>> profile_ratios(const std::vector<std::vector<double>>& costs);
/// Share of `problems` whose ratio is at most tau.
double profile_at(const std::vector<double>& ratios, std::size_t problems, double tau);

}  // namespace carom::tools::accuracy
