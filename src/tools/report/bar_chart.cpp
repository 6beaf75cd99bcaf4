// Horizontal bars, with a dashed mark where another author's figure stands.
#include <algorithm>
#include <cmath>
#include <limits>

#include "report/plot.h"

namespace carom::report {
namespace {

constexpr double kWidth = 760, kTop = 46, kBar = 24, kPitch = 54, kFoot = 64, kRight = 96;
constexpr double kGlyphGap = 14;

double total(const BarRow& row) {
  double sum = 0;
  for (const BarPart& p : row.parts) sum += std::isfinite(p.value) ? p.value : 0;
  return sum;
}

struct Frame {
  Axis axis;
  double left, right;
  double at(double value) const { return left + std::clamp(axis.at(value), 0.0, 1.0) * (right - left); }
};

// One entry per name of a part, in order of appearance; none if there is only one, since the title says what it is.
double draw_legend(Svg& svg, const BarChart& chart, double left) {
  std::vector<const BarPart*> entries;
  for (const BarRow& row : chart.rows)
    for (const BarPart& part : row.parts)
      if (std::none_of(entries.begin(), entries.end(), [&](const BarPart* e) { return e->name == part.name; }))
        entries.push_back(&part);
  if (entries.size() < 2) return kTop;
  double x = left;
  for (const BarPart* e : entries) {
    svg.rect({x, kTop - 4}, 11, 11, series('f', e->colour));
    svg.text({x + 16, kTop + 6}, Anchor::start, "", e->name);
    x += 16 + text_width(e->name) + kGlyphGap;
  }
  return kTop + 24;
}

void draw_row(Svg& svg, const Frame& frame, const BarRow& row, double y) {
  svg.text({frame.left - 10, y + kBar / 2 + 4}, Anchor::end, "", row.label);
  double sum = 0, end = frame.left;
  for (const BarPart& part : row.parts) {
    if (!std::isfinite(part.value)) continue;
    sum += part.value;
    const double next = frame.at(sum);
    svg.rect({end, y}, std::max(0.0, next - end), kBar, series('f', part.colour) + " edge");
    end = next;
  }
  const double x = row.reference > 0 ? frame.at(row.reference) : frame.left;
  const bool in_the_way = x > end && x < end + 14 + text_width(row.value_label);
  svg.text({(in_the_way ? x : end) + 7, y + kBar / 2 + 4}, Anchor::start, "halo", row.value_label);
  if (row.reference <= 0) return;
  svg.line({x, y - 5}, {x, y + kBar + 5}, "under");
  svg.line({x, y - 5}, {x, y + kBar + 5}, "ref");
  svg.text({x, y + kBar + 16}, Anchor::middle, "reft", row.reference_label);
}

}  // namespace

std::string draw(const BarChart& chart) {
  double low = std::numeric_limits<double>::infinity(), high = 0, widest = 0;
  for (const BarRow& row : chart.rows) {
    for (const double v : {total(row), row.reference}) {
      if (!(v > 0) || !std::isfinite(v)) continue;
      low = std::min(low, v);
      high = std::max(high, v);
    }
    widest = std::max(widest, text_width(row.label));
  }
  if (high <= 0) low = high = 1;
  // A bar that ends at the low end of a log axis has no length: give the smallest one something to show.
  if (chart.value.scale == Scale::log) low /= 2;
  const Frame frame{fit_axis(chart.value, low, high), std::min(widest + 26, kWidth / 2), kWidth - kRight};
  const double height = kTop + 24 + kPitch * static_cast<double>(chart.rows.size()) + kFoot;
  Svg svg(kWidth, height, chart.title);
  svg.text({16, 26}, Anchor::start, "title", chart.title);
  const double first = draw_legend(svg, chart, frame.left);
  const double floor = first + kPitch * static_cast<double>(chart.rows.size());
  for (const double tick : frame.axis.ticks) {
    const double x = frame.at(tick);
    svg.line({x, first - 4}, {x, floor}, "grid");
    svg.text({x, floor + 16}, Anchor::middle, "soft", short_number(tick));
  }
  svg.line({frame.left, first - 4}, {frame.left, floor}, "axis");
  svg.text({(frame.left + frame.right) / 2, floor + 33}, Anchor::middle, "", chart.value.label);
  svg.text({16, floor + 54}, Anchor::start, "soft", chart.note);
  for (std::size_t i = 0; i < chart.rows.size(); ++i)
    draw_row(svg, frame, chart.rows[i], first + 6 + kPitch * static_cast<double>(i));
  return svg.document();
}

}  // namespace carom::report
