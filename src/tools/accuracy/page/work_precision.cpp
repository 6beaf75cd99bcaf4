// The work-precision diagram.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "accuracy/page/figures.h"
#include "accuracy/sweep/settings.h"
#include "report/axis.h"

namespace carom::tools::accuracy {
namespace {

using report::Anchor;
using report::Svg;

constexpr double kWidth = 880, kHeight = 470, kLeft = 74, kRight = 726, kTop = 74, kFloor = 412;  // px
constexpr double kLane = 60;      // px from the top: where those stand that fell
constexpr double kWorst = 1e3;    // larger errors are drawn here: further off is no news
constexpr double kLeast = 1e-16;  // and smaller ones here

struct Frame {
  report::Axis x, y;
  report::Point at(double cost, double error) const {
    return {kLeft + x.at(cost) * (kRight - kLeft), kFloor - y.at(std::clamp(error, kLeast, kWorst)) * (kFloor - kTop)};
  }
};

bool drawn(const Row& row) { return !row.left_out && row.cost > 0; }
bool stood(const Row& row) { return row.usable() && std::isfinite(row.errors[0]); }

Frame frame_of(const SceneView& scene) {
  double low = 1e300, high = 0, least = 1e300, most = 0;
  for (const Line& line : scene.lines)
    for (const Row* row : line.rows) {
      if (!drawn(*row)) continue;
      low = std::min(low, row->cost), high = std::max(high, row->cost);
      if (!stood(*row)) continue;
      const double error = std::clamp(row->errors[0], kLeast, kWorst);
      least = std::min(least, error), most = std::max(most, error);
    }
  if (low > high) low = 1e-3, high = 1;
  if (least > most) least = 1e-6, most = 1;
  const report::AxisSpec spec{"", report::Scale::log, false, {}};
  return {report::fit_axis(spec, low, high), report::fit_axis(spec, least, most)};
}

std::string attribute(const char* name, const std::string& value) {
  return std::string(" data-") + name + "=\"" + report::escape(value) + "\"";
}
std::string exact(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}
/// What the page's script shows beside the pointer, and what a test finds again.
std::string data_of(const Row& row, const Metric& metric) {
  return attribute("setting", row.engine + ": " + row.setting) + attribute("dt", exact(row.dt)) +
         attribute("cost", exact(row.cost)) + attribute("error", exact(row.errors[0])) +
         attribute("tip", row.engine + ": " + row.setting + "|" + step_text(row.dt) + "|" +
                              (row.fell_at >= 0 ? "fell" : "error " + error_text(row.errors[0], metric)) + "|" +
                              frame_text(row.cost) + " a frame");
}

/// What filters and the budget of the page go by.
std::string data_of(const Line& line) {
  std::string data = attribute("engine", line.engine) + attribute("name", line.setting);
  if (line.engine != kOurs) return data;
  if (const std::string preset = preset_of(line.setting); !preset.empty()) data += attribute("preset", preset);
  return data + attribute("dials", options_of(line.setting));
}

void draw_axes(Svg& svg, const Frame& f, const Metric& metric) {
  for (std::size_t i = 0; i < f.y.ticks.size(); ++i) {
    const double y = f.at(f.x.low, f.y.ticks[i]).y;
    if (f.y.ticks[i] < kLeast || f.y.ticks[i] > kWorst) continue;
    svg.line({kLeft, y}, {kRight, y}, "grid");
    if (f.y.ticks.size() < 12 || i % 2 == 0)
      svg.text({kLeft - 8, y + 4}, Anchor::end, "soft", report::power_of_ten(f.y.ticks[i]));
  }
  for (const double tick : f.x.ticks) {
    const double x = f.at(tick, f.y.low).x;
    svg.line({x, kFloor}, {x, kFloor + 5}, "axis");
    svg.text({x, kFloor + 19}, Anchor::middle, "soft", report::power_of_ten(tick));
  }
  svg.line({kLeft, kFloor}, {kRight, kFloor}, "axis");
  svg.text({(kLeft + kRight) / 2, kFloor + 40}, Anchor::middle, "", "seconds of computing per simulated second");
  svg.text_upward({18, (kTop + kFloor) / 2}, "", metric.what + (metric.unit.empty() ? "" : ", " + metric.unit));
  for (const double ms : {0.1, 1.0, 2.0}) {  // of a frame at 60 Hz
    const double cost = 60e-3 * ms;
    if (cost < f.x.low || cost > f.x.high) continue;
    const double x = f.at(cost, f.y.low).x;
    svg.line({x, kTop - 26}, {x, kFloor}, "ref");
    svg.text({x, kTop - 30},
             ms == 1   ? Anchor::end
             : ms == 2 ? Anchor::start
                       : Anchor::middle,
             "reft halo", ms == 1 ? "1 " : report::short_number(ms) + " ms a frame");
  }
  if (metric.bound >= f.y.low && metric.bound <= f.y.high) {
    const double y = f.at(f.x.low, metric.bound).y;
    svg.line({kLeft, y}, {kRight, y}, "ref");
    svg.text({kRight - 6, y - 5}, Anchor::end, "reft halo", "bound");
  }
}

/// A lane above the axes for runs that fell, blew up or lost their bodies.
void draw_fallen(Svg& svg, const SceneView& scene, const Frame& f, const View& view) {
  bool any = false;
  for (const Line& line : scene.lines) {
    svg.open_group("", data_of(line));
    for (const Row* row : line.rows) {
      if (!drawn(*row) || stood(*row)) continue;
      any = true;
      svg.mark(Svg::Mark::cross, {f.at(row->cost, 1).x, kLane}, 3,
               report::series('s', view.colour.at(line.engine)) + " fell", data_of(*row, scene.challenge->metrics[0]));
    }
    svg.close();
  }
  if (any) svg.text({kLeft - 8, kLane + 4}, Anchor::end, "soft", "fell");
}

void draw_line(Svg& svg, const SceneView& scene, const Line& line, const Frame& f, const View& view) {
  const int colour = view.colour.at(line.engine);
  std::vector<report::Point> path;
  for (const Row* row : line.rows)
    if (drawn(*row) && stood(*row)) path.push_back(f.at(row->cost, row->errors[0]));
  svg.open_group("setting", data_of(line));
  if (path.size() > 1) svg.polyline(path, report::series('s', colour) + " thin");
  for (const Row* row : line.rows)
    if (drawn(*row) && stood(*row))
      svg.mark(mark_of(line.setting), f.at(row->cost, row->errors[0]), 2.8, report::series('f', colour) + " edge dot",
               data_of(*row, scene.challenge->metrics[0]));
  svg.close();
}

struct Label {
  double y;
  std::string text;
  int colour;
};

/// Names beside the ends of fronts, pushed apart.
void draw_labels(Svg& svg, std::vector<Label> labels) {
  std::stable_sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.y < b.y; });
  double below = kFloor + 4;
  for (std::size_t i = 1; i < labels.size(); ++i) labels[i].y = std::max(labels[i].y, labels[i - 1].y + 16);
  for (std::size_t i = labels.size(); i-- > 0;) labels[i].y = std::min(labels[i].y, below), below = labels[i].y - 16;
  for (const Label& label : labels) {
    svg.open_group("", attribute("engine", label.text));
    svg.text({kRight + 12, label.y}, Anchor::start, report::series('t', label.colour) + " label", label.text);
    svg.close();
  }
}

/// Names of presets beside their dots at 60 Hz, and a ring about the defaults.
void draw_presets(Svg& svg, const SceneView& scene, const Frame& f) {
  for (const Line& line : scene.lines) {
    const std::string preset = preset_of(line.setting);
    if (line.engine != kOurs || preset.empty()) continue;
    for (const Row* row : line.rows) {
      if (std::fabs(row->dt - 1.0 / 60) > 1e-9 || !drawn(*row) || !stood(*row)) continue;
      const report::Point at = f.at(row->cost, row->errors[0]);
      svg.open_group("", data_of(line));
      if (line.setting == kDefaultSetting) svg.mark(Svg::Mark::circle, at, 7, "ring");
      svg.text({at.x + 9, at.y - 7}, Anchor::start, "halo tiny",
               line.setting == kDefaultSetting ? preset + ": the defaults at 60 Hz" : preset);
      svg.close();
    }
  }
}

}  // namespace

Svg::Mark mark_of(const std::string& setting) {
  if (setting.starts_with("auto")) return Svg::Mark::circle;
  if (setting.starts_with("direct")) return Svg::Mark::square;
  if (setting.starts_with("soft_step")) return Svg::Mark::triangle;
  if (setting.starts_with("severity")) return Svg::Mark::diamond;
  return Svg::Mark::circle;
}

Svg work_precision(const SceneView& scene, const View& view) {
  const Challenge& c = *scene.challenge;
  const Frame f = frame_of(scene);
  Svg svg(kWidth, kHeight, c.scene.name + ": error against cost");
  svg.text({kLeft, 24}, Anchor::start, "title", c.scene.name);
  svg.text({kLeft + report::text_width(c.scene.name, 15) + 16, 24}, Anchor::start, "soft", c.scene.summary);
  draw_axes(svg, f, c.metrics[0]);
  draw_fallen(svg, scene, f, view);
  std::vector<Label> labels;
  std::vector<std::string> engines = scene.engines();
  std::reverse(engines.begin(), engines.end());
  for (const std::string& engine : engines) {
    const Cloud cloud = cloud_of(scene, engine);
    std::vector<report::Point> path;
    for (const std::size_t i : cloud.front()) path.push_back(f.at(cloud.points[i].cost, cloud.rows[i]->errors[0]));
    if (path.empty()) {
      labels.push_back({kLane + 4, engine, view.colour.at(engine)});
      continue;
    }
    if (path.size() > 1) {
      svg.open_group("", attribute("engine", engine));
      svg.polyline(path, report::series('s', view.colour.at(engine)) + " bold front");
      svg.close();
    }
    labels.push_back({path.back().y + 4, engine, view.colour.at(engine)});
  }
  for (const bool ours : {false, true})  // ours on top, dots above fronts
    for (const Line& line : scene.lines)
      if ((line.engine == kOurs) == ours) draw_line(svg, scene, line, f, view);
  draw_labels(svg, std::move(labels));
  draw_presets(svg, scene, f);
  return svg;
}

}  // namespace carom::tools::accuracy
