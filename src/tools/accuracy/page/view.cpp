// Rows by scene, engine and setting.
#include "accuracy/page/view.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "report/svg.h"

namespace carom::tools::accuracy {
namespace {

Line& line_for(SceneView& scene, const Row& row) {
  for (Line& line : scene.lines)
    if (line.engine == row.engine && line.setting == row.setting) return line;
  scene.lines.push_back({row.engine, row.setting, {}});
  return scene.lines.back();
}

std::string text_of(const char* pattern, double value) {
  char text[48];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

}  // namespace

std::vector<std::string> SceneView::engines() const {
  std::vector<std::string> names;
  for (const Line& line : lines)
    if (std::find(names.begin(), names.end(), line.engine) == names.end()) names.push_back(line.engine);
  return names;
}

Cloud cloud_of(const SceneView& scene, const std::string& engine) {
  Cloud cloud;
  for (const Line& line : scene.lines) {
    if (engine.empty() ? line.engine == kOurs : line.engine != engine) continue;
    for (const Row* row : line.rows) {
      if (!row->usable() || !std::isfinite(row->errors[0])) continue;
      cloud.points.push_back({row->cost, std::max(row->errors[0], kRounding)});
      cloud.rows.push_back(row);
    }
  }
  return cloud;
}

Lead worst_lead(const SceneView& scene) {
  const Cloud ours = cloud_of(scene, kOurs), theirs = cloud_of(scene, "");
  Lead worst;
  for (const std::size_t i : theirs.front()) {
    const Point& p = theirs.points[i];
    const double bound = scene.challenge->metrics[0].bound;
    if (bound > 0 && p.error > kNoSolution * bound) continue;
    const double ratio = lead_of(p, ours.points);
    if (worst.theirs && ratio <= worst.ratio) continue;
    worst = {ratio, theirs.rows[i], error_within(ours.points, p.cost), cost_within(ours.points, p.error)};
  }
  return worst;
}

View view_of(const Sweep& sweep) {
  View view;
  for (const Challenge& challenge : all_challenges()) {
    SceneView scene{&challenge, {}};
    for (const Row& row : sweep.rows)
      if (row.scene == challenge.scene.name && row.knobs.empty()) line_for(scene, row).rows.push_back(&row);
    for (Line& line : scene.lines)
      std::stable_sort(line.rows.begin(), line.rows.end(), [](const Row* a, const Row* b) { return a->dt > b->dt; });
    if (!scene.lines.empty()) view.scenes.push_back(std::move(scene));
  }
  view.engines = {kOurs};
  for (const Row& row : sweep.rows)
    if (std::find(view.engines.begin(), view.engines.end(), row.engine) == view.engines.end())
      view.engines.push_back(row.engine);
  for (std::size_t i = 0; i < view.engines.size(); ++i)
    view.colour[view.engines[i]] = i == 0 ? 0 : 1 + static_cast<int>(i - 1) % 5;
  return view;
}

double cost_to_bound(const SceneView& scene, const std::string& engine, const std::string& setting_prefix) {
  double least = std::numeric_limits<double>::infinity();
  for (const Line& line : scene.lines) {
    if (line.engine != engine || !line.setting.starts_with(setting_prefix)) continue;
    for (const Row* row : line.rows)
      if (row->usable() && row->errors[0] <= scene.challenge->metrics[0].bound) least = std::min(least, row->cost);
  }
  return least;
}

std::string step_text(double dt) { return text_of("1/%.4g s", 1 / dt); }

std::string frame_text(double cost) {
  if (!std::isfinite(cost)) return "-";
  const double ms = 1e3 * cost / 60;
  return ms < 0.1 ? text_of("%.2g µs", 1e3 * ms) : text_of("%.2g ms", ms);
}

std::string error_text(double error, const Metric& metric) {
  if (!std::isfinite(error)) return "none";
  return text_of("%.2g", error) + (metric.unit.empty() ? "" : " " + metric.unit);
}

std::string ratio_text(double ratio) {
  if (!std::isfinite(ratio)) return "beyond reach";
  return (ratio < 100 ? text_of("%.2g", ratio) : ratio < 1e6 ? report::number(ratio, 2) : text_of("%.0e", ratio)) + "×";
}

}  // namespace carom::tools::accuracy
