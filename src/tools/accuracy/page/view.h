// Rows of a sweep as a reader asks for them: by scene, by engine, by setting; and the numbers that findings are made of.
#pragma once

#include <limits>
#include <map>

#include "accuracy/sweep/front.h"
#include "accuracy/sweep/rows.h"

namespace carom::tools::accuracy {

/// Errors below this are rounding: who is nearer to zero there is nearer by luck.
inline constexpr double kRounding = 1e-12;
/// Times its bound, an error that is no solution: a chain whose links of 1 m gape by 0.6 m. Cheap as it may be, it
/// leads nowhere.
inline constexpr double kNoSolution = 1000;
/// A lead smaller than this is within what times differ by from run to run.
inline constexpr double kClearLead = 1.25;
inline constexpr const char* kOurs = "Carom";

/// One engine at one setting, on one scene: rows from coarse steps to fine ones.
struct Line {
  std::string engine, setting;
  std::vector<const Row*> rows;
};

struct SceneView {
  const Challenge* challenge;
  std::vector<Line> lines;
  std::vector<std::string> engines() const;  ///< in order of appearance
};

/// Rows as points, with what they are made of: of usable rows alone, their first error, not below kRounding.
struct Cloud {
  std::vector<Point> points;
  std::vector<const Row*> rows;
  std::vector<std::size_t> front() const { return pareto_front(points); }
};
/// @param engine  "": all but ours
Cloud cloud_of(const SceneView& scene, const std::string& engine);

/// Where somebody else's front is below ours, and where that is worst.
struct Lead {
  double ratio = 1;  ///< lead_of()
  const Row* theirs = nullptr;
  double our_error = 0;  ///< at their cost; infinite: we have nothing as cheap
  double our_cost = 0;   ///< at their error; infinite: we have nothing as exact
};
Lead worst_lead(const SceneView& scene);

/// A whole report's worth.
struct View {
  std::vector<SceneView> scenes;      ///< in the order of the suite, rows without knobs
  std::vector<std::string> engines;   ///< ours first
  std::map<std::string, int> colour;  ///< 0..5, of engines
};
/// @param sweep  must outlive the view
View view_of(const Sweep& sweep);

/// Least cost at which the first error is within its bound, s/s; infinite: never.
double cost_to_bound(const SceneView& scene, const std::string& engine, const std::string& setting_prefix = "");

/// "1/60"; "0.35 ms"; "3.1e-05 m".
std::string step_text(double dt);
std::string frame_text(double cost);  ///< of a frame at 60 Hz
std::string error_text(double error, const Metric& metric);
std::string ratio_text(double ratio);

}  // namespace carom::tools::accuracy
