// Panels, and the hull of projected points.
#include "report/filmstrip.h"

#include <algorithm>

namespace carom::report {
namespace {

constexpr double kWidth = 900, kMargin = 14, kTop = 44, kCaption = 22, kFoot = 34;

}  // namespace

std::string draw(const Filmstrip& strip) {
  const int columns = std::max(1, strip.columns);
  const int rows = (static_cast<int>(strip.panels.size()) + columns - 1) / columns;
  const double width = (kWidth - kMargin * (columns + 1)) / columns;
  const double scale = width / (strip.right - strip.left);
  const double height = scale * (strip.top - strip.bottom);
  Svg svg(kWidth, kTop + rows * (height + kCaption) + kFoot, strip.title);
  svg.text({kMargin, 26}, Anchor::start, "title", strip.title);
  for (std::size_t i = 0; i < strip.panels.size(); ++i) {
    const Panel& panel = strip.panels[i];
    const Point corner{kMargin + static_cast<double>(static_cast<int>(i) % columns) * (width + kMargin),
                       kTop + static_cast<double>(static_cast<int>(i) / columns) * (height + kCaption)};
    const auto place = [&](Point p) {
      return Point{corner.x + scale * (p.x - strip.left), corner.y + height - scale * (p.y - strip.bottom)};
    };
    svg.open_clip(corner, width, height);
    svg.line(place({strip.left, strip.ground}), place({strip.right, strip.ground}), "axis");
    for (const Outline& outline : panel.outlines) {
      std::vector<Point> points;
      for (const Point& p : outline.points) points.push_back(place(p));
      svg.polygon(points, series('f', outline.colour) + (outline.ghost ? " ghost" : " edge"));
    }
    svg.close();
    svg.text({corner.x + 2, corner.y + height + 15}, Anchor::start, "soft", panel.caption);
  }
  svg.text({kMargin, kTop + rows * (height + kCaption) + 20}, Anchor::start, "soft", strip.note);
  return svg.document();
}

// Andrew's monotone chain.
std::vector<Point> hull(std::vector<Point> points) {
  if (points.size() < 3) return points;
  std::sort(points.begin(), points.end(), [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  const auto turn = [](Point a, Point b, Point c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); };
  std::vector<Point> chain;
  for (int side = 0; side < 2; ++side) {
    const std::size_t floor = chain.size();
    for (const Point& p : points) {
      while (chain.size() >= floor + 2 && turn(chain[chain.size() - 2], chain.back(), p) <= 0) chain.pop_back();
      chain.push_back(p);
    }
    chain.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return chain;
}

}  // namespace carom::report
