// Which steps a column survives.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "accuracy/page/figures.h"

namespace carom::tools::accuracy {
namespace {

using report::Anchor;
using report::Svg;

constexpr int kColumns = 3;
constexpr double kCellWidth = 36, kCellHeight = 22, kLeft = 54, kTop = 34, kHead = 44, kGap = 20;  // px

struct Panel {
  std::string engine, setting;
  std::vector<const Row*> rows;
};

std::string sink_text(double sink) {
  if (!std::isfinite(sink)) return "?";
  if (sink < kRounding) return "0";
  char text[16];
  std::snprintf(text, sizeof text, "%.0e", sink);
  std::string s = text;  // "3e-05" to "3e-5"
  const auto zero = s.find("e-0");
  if (zero != std::string::npos) s.erase(zero + 2, 1);
  return s;
}

}  // namespace

Svg stability_map(const Sweep& sweep, const std::string& scene, const std::string& knob, const std::string& title) {
  std::vector<Panel> panels;
  std::set<double> values, steps;
  for (const Row& row : sweep.rows) {
    if (row.scene != scene || row.knobs.size() != 1 || row.knobs[0].first != knob) continue;
    auto panel = std::find_if(panels.begin(), panels.end(),
                              [&](const Panel& p) { return p.engine == row.engine && p.setting == row.setting; });
    if (panel == panels.end()) panel = panels.insert(panels.end(), {row.engine, row.setting, {}});
    panel->rows.push_back(&row);
    values.insert(row.knobs[0].second), steps.insert(row.dt);
  }
  const std::vector<double> up(values.begin(), values.end()), across(steps.rbegin(), steps.rend());
  const double panel_width = kLeft + kCellWidth * static_cast<double>(across.size()) + kGap;
  const double panel_height = kTop + kCellHeight * static_cast<double>(up.size()) + 40;
  const auto rows = std::max<std::size_t>(1, (panels.size() + kColumns - 1) / kColumns);
  Svg svg(std::max(880.0, kColumns * panel_width), kHead + panel_height * static_cast<double>(rows), title);
  svg.text({kLeft, 24}, Anchor::start, "title", title);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Panel& panel = panels[i];
    const double x0 = panel_width * static_cast<double>(i % kColumns) + kLeft;
    const double y0 = kHead + panel_height * static_cast<double>(i / kColumns) + kTop;
    svg.text({x0, y0 - 22}, Anchor::start, "", panel.engine);
    svg.text({x0, y0 - 8}, Anchor::start, "soft", panel.setting);
    for (const Row* row : panel.rows) {
      const auto column = std::find(across.begin(), across.end(), row->dt) - across.begin();
      const auto level = std::find(up.begin(), up.end(), row->knobs[0].second) - up.begin();
      const double x = x0 + kCellWidth * static_cast<double>(column);
      const double y = y0 + kCellHeight * static_cast<double>(static_cast<long>(up.size()) - 1 - level);
      const report::Point middle{x + kCellWidth / 2, y + kCellHeight / 2};
      const double sink = row->errors.empty() ? 0 : row->errors[0];
      if (row->left_out) {
        svg.rect({x, y}, kCellWidth, kCellHeight, "cell none");
        svg.text({middle.x, middle.y + 4}, Anchor::middle, "soft", "-");
      } else if (row->fell_at >= 0) {
        svg.rect({x, y}, kCellWidth, kCellHeight, "cell lost");
        svg.mark(Svg::Mark::cross, middle, 4, "bad");
      } else {
        const int shade = sink > 1e-2 ? 0 : sink > 1e-3 ? 1 : sink > 1e-4 ? 2 : 3;
        svg.rect({x, y}, kCellWidth, kCellHeight, "cell held" + std::to_string(shade));
        svg.text({middle.x, middle.y + 4}, Anchor::middle, "tiny", sink_text(sink));
      }
    }
    for (std::size_t k = 0; k < up.size(); ++k)
      svg.text({x0 - 6, y0 + kCellHeight * (static_cast<double>(up.size() - k) - 0.5) + 4}, Anchor::end, "soft",
               report::power_of_ten(up[k]));
    for (std::size_t k = 0; k < across.size(); ++k)
      svg.text(
          {x0 + kCellWidth * (static_cast<double>(k) + 0.5), y0 + kCellHeight * static_cast<double>(up.size()) + 15},
          Anchor::middle, "soft", std::to_string(static_cast<int>(std::lround(1 / across[k]))));
    svg.text({x0, y0 + kCellHeight * static_cast<double>(up.size()) + 29}, Anchor::start, "tiny soft",
             "steps a second");
  }
  return svg;
}

}  // namespace carom::tools::accuracy
