// Error against step, small, side by side.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "accuracy/page/figures.h"
#include "accuracy/sweep/settings.h"
#include "report/axis.h"

namespace carom::tools::accuracy {
namespace {

using report::Anchor;
using report::Point;
using report::Svg;

constexpr int kColumns = 3;
constexpr double kPanelWidth = 290, kPanelHeight = 210, kHead = 44;  // px
constexpr double kLeft = 52, kRight = 272, kTop = 44, kFloor = 172;  // within a panel
constexpr double kLeast = 1e-16, kWorst = 1e3;

/// The setting of an engine that a panel shows: ours by default, the first one of others.
const Line* shown_line(const SceneView& scene, const std::string& engine) {
  for (const Line& line : scene.lines)
    if (line.engine == engine && (engine != kOurs || line.setting == kDefaultSetting)) return &line;
  return nullptr;
}

std::vector<std::pair<double, double>> steps_and_errors(const Line& line) {
  std::vector<std::pair<double, double>> list;
  for (const Row* row : line.rows)
    if (row->usable() && std::isfinite(row->errors[0]))
      list.emplace_back(row->dt, std::clamp(row->errors[0], kLeast, kWorst));
  return list;
}

void draw_panel(Svg& svg, Point corner, const SceneView& scene, const View& view) {
  double least = 1e300, most = 0;
  for (const std::string& engine : scene.engines())
    if (const Line* line = shown_line(scene, engine))
      for (const auto& [dt, error] : steps_and_errors(*line))
        least = std::min(least, error), most = std::max(most, error);
  if (least > most) least = 1e-3, most = 1;
  const report::Axis y = report::fit_axis({"", report::Scale::log, false, {}}, least, most);
  const double coarse = std::log(1.0 / 30), fine = std::log(1.0 / 960);
  const auto at = [&](double dt, double error) {
    return Point{corner.x + kRight - (std::log(dt) - coarse) / (fine - coarse) * (kRight - kLeft),
                 corner.y + kFloor - std::clamp(y.at(error), 0.0, 1.0) * (kFloor - kTop)};
  };
  svg.text({corner.x + kLeft, corner.y + 20}, Anchor::start, "title", scene.challenge->scene.name);
  const std::size_t every = (y.ticks.size() + 4) / 5;
  for (std::size_t i = 0; i < y.ticks.size(); ++i) {
    const double level = at(1.0 / 60, y.ticks[i]).y;
    if (i % every) continue;
    svg.line({corner.x + kLeft, level}, {corner.x + kRight, level}, "grid");
    svg.text({corner.x + kLeft - 6, level + 4}, Anchor::end, "soft", report::power_of_ten(y.ticks[i]));
  }
  for (const int rate : {30, 120, 480}) {
    const double x = at(1.0 / rate, y.low).x;
    svg.line({x, corner.y + kFloor}, {x, corner.y + kFloor + 4}, "axis");
    svg.text({x, corner.y + kFloor + 17}, Anchor::middle, "soft", "1/" + std::to_string(rate) + " s");
  }
  svg.line({corner.x + kLeft, corner.y + kFloor}, {corner.x + kRight, corner.y + kFloor}, "axis");
  std::vector<std::string> engines = scene.engines();
  std::reverse(engines.begin(), engines.end());  // ours on top
  for (const std::string& engine : engines) {
    const Line* line = shown_line(scene, engine);
    if (!line) continue;
    const auto data = steps_and_errors(*line);
    const int colour = view.colour.at(engine);
    std::vector<Point> path;
    for (const auto& [dt, error] : data) path.push_back(at(dt, error));
    if (path.empty()) continue;
    if (path.size() > 1) svg.polyline(path, report::series('s', colour) + (engine == kOurs ? "" : " thin"));
    for (const Point& p : path) svg.circle(p, engine == kOurs ? 3 : 2, report::series('f', colour) + " edge");
    if (engine != kOurs) continue;
    const Slope slope = fit_slope(data, kRounding);
    char text[48];
    if (slope.points >= 3) {
      const double first = 1.0 / 30, last = 1.0 / 960;
      svg.line(at(first, slope.at_1s * std::pow(first, slope.order)),
               at(last, slope.at_1s * std::pow(last, slope.order)), "ref");
      std::snprintf(text, sizeof text, "order %.1f", slope.order);
    } else {
      std::snprintf(text, sizeof text, "%s", most <= 1e-10 ? "rounding" : "no slope");
    }
    svg.text({corner.x + kRight, corner.y + 20}, Anchor::end, "reft order", text);
  }
}

}  // namespace

Svg order_plot(const std::vector<const SceneView*>& scenes, const View& view, const std::string& title) {
  const auto rows = (scenes.size() + kColumns - 1) / kColumns;
  Svg svg(kColumns * kPanelWidth, kHead + kPanelHeight * static_cast<double>(rows), title);
  svg.text({kLeft, 24}, Anchor::start, "title", title);
  for (std::size_t i = 0; i < scenes.size(); ++i)
    draw_panel(
        svg,
        {kPanelWidth * static_cast<double>(i % kColumns), kHead + kPanelHeight * static_cast<double>(i / kColumns)},
        *scenes[i], view);
  return svg;
}

}  // namespace carom::tools::accuracy
