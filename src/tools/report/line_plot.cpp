// Line plots, labelled where the lines end.
#include <algorithm>
#include <cmath>
#include <limits>

#include "report/plot.h"

namespace carom::report {
namespace {

constexpr double kWidth = 760, kHeight = 440, kTop = 46, kBottom = 74, kLeft = 74;
constexpr double kLabelHeight = 15;  // px: two labels nearer than this would touch

bool drawable(const Point& p, const LinePlot& plot) {
  return std::isfinite(p.x) && std::isfinite(p.y) && (plot.x.scale == Scale::linear || p.x > 0) &&
         (plot.y.scale == Scale::linear || p.y > 0);
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void add(double v) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
  bool empty() const { return low > high; }
};

struct Frame {
  Axis x, y;
  double right;
  Point at(const Point& data) const {
    return {kLeft + x.at(data.x) * (right - kLeft), kHeight - kBottom - y.at(data.y) * (kHeight - kBottom - kTop)};
  }
};

void draw_axes(Svg& svg, const Frame& frame, const LinePlot& plot) {
  const double floor = kHeight - kBottom;
  for (const double tick : frame.y.ticks) {
    const double y = frame.at({frame.x.low, tick}).y;
    svg.line({kLeft, y}, {frame.right, y}, "grid");
    svg.text({kLeft - 8, y + 4}, Anchor::end, "soft", short_number(tick));
  }
  for (const double tick : frame.x.ticks) {
    const double x = frame.at({tick, frame.y.low}).x;
    svg.line({x, floor}, {x, floor + 5}, "axis");
    svg.text({x, floor + 19}, Anchor::middle, "soft", short_number(tick));
  }
  svg.line({kLeft, floor}, {frame.right, floor}, "axis");
  svg.text({(kLeft + frame.right) / 2, floor + 38}, Anchor::middle, "", plot.x.label);
  svg.text_upward({20, (kTop + floor) / 2}, "", plot.y.label);
  svg.text({kLeft, kHeight - 12}, Anchor::start, "soft", plot.note);
}

struct Label {
  double y;
  const Series* series;
};

// Push labels apart from the top down, then back up from the floor, so that none leaves the plot.
void spread(std::vector<Label>& labels) {
  std::stable_sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.y < b.y; });
  for (std::size_t i = 1; i < labels.size(); ++i) labels[i].y = std::max(labels[i].y, labels[i - 1].y + kLabelHeight);
  double below = kHeight - kBottom;
  for (std::size_t i = labels.size(); i-- > 0;) {
    labels[i].y = std::min(labels[i].y, below);
    below = labels[i].y - kLabelHeight;
  }
}

}  // namespace

std::string draw(const LinePlot& plot) {
  Range xs, ys;
  double widest = 0;
  for (const Series& s : plot.series) {
    widest = std::max(widest, text_width(s.name));
    for (const Point& p : s.points) {
      if (!drawable(p, plot)) continue;
      xs.add(p.x);
      ys.add(p.y);
    }
  }
  if (xs.empty()) xs = ys = {1, 1};
  const Frame frame{fit_axis(plot.x, xs.low, xs.high), fit_axis(plot.y, ys.low, ys.high),
                    std::max(kWidth / 2, kWidth - widest - 24)};
  Svg svg(kWidth, kHeight, plot.title);
  svg.text({kLeft, 26}, Anchor::start, "title", plot.title);
  draw_axes(svg, frame, plot);
  for (const Mark& m : plot.marks) {
    const Point foot = frame.at({m.x, frame.y.low}), top = frame.at({m.x, frame.y.high});
    svg.line(foot, top, "ref");
    svg.text({top.x - 6, top.y + 14}, Anchor::end, "reft halo", m.label);
  }
  std::vector<Label> labels;
  for (const Series& s : plot.series) {
    std::vector<Point> path;
    for (const Point& p : s.points)
      if (drawable(p, plot)) path.push_back(frame.at(p));
    if (path.empty()) continue;
    svg.polyline(path, s.reference ? "ref" : series('s', s.colour));
    if (!s.reference && !plot.dense)
      for (const Point& p : path) svg.circle(p, 3.2, series('f', s.colour) + " edge");
    labels.push_back({path.back().y + 4, &s});
  }
  spread(labels);
  for (const Label& l : labels)
    svg.text({frame.right + 8, l.y}, Anchor::start, l.series->reference ? "reft" : series('t', l.series->colour),
             l.series->name);
  return svg.document();
}

}  // namespace carom::report
