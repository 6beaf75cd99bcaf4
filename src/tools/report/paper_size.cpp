// Figure 2: how total time grows with the number of bodies, and what contact groups save.
#include <cmath>

#include "report/paper.h"
#include "report/plot.h"

namespace carom::report {
namespace {

struct Setting {
  const char* label;
  Crowd crowd;
  const char* search;
  const char* groups;
  int colour;
};
constexpr Setting kSettings[] = {{"heap: one group", kHeap, "severity_search=linear", "groups=off", 1},
                                 {"heap: groups", kHeap, "severity_search=linear", "groups=on", 0},
                                 {"heap: groups, heap search", kHeap, "severity_search=heap", "groups=on", 2},
                                 {"spread: one group", kSpread, "severity_search=linear", "groups=off", 4},
                                 {"spread: groups", kSpread, "severity_search=linear", "groups=on", 3}};

// Slope of log(time) against log(N) between two sizes.
double exponent(const Point& a, const Point& b) { return std::log(b.y / a.y) / std::log(b.x / a.x); }

std::vector<double> sizes_of(bool quick) {
  std::vector<double> sizes = {64, 128, 256, 512};
  // Beyond, the linear search takes minutes a curve.
  if (!quick) sizes.push_back(1024);
  return sizes;
}

constexpr double kClearGain = 1.25;  // a ratio that timing noise on a busy machine does not make

std::string judge(const std::string& crowd, const std::vector<Point>& one_group, const std::vector<Point>& groups) {
  double from = 0;
  for (std::size_t i = one_group.size(); i-- > 0 && one_group[i].y > kClearGain * groups[i].y;) from = one_group[i].x;
  const std::string gain = "Bodies in " + crowd + ": with the paper's linear search, contact groups make N = " +
                           short_number(one_group.back().x) + " " + number(one_group.back().y / groups.back().y) +
                           " times as fast";
  if (from == 0) return gain + ". No size shows the paper's clear gain (more than " + number(kClearGain) + " times).";
  return gain + "; the gain is clear (more than " + number(kClearGain) + " times) from N = " + short_number(from) +
         " on. Paper: from 512 on.";
}

}  // namespace

std::size_t size_runs(bool quick) { return std::size(kSettings) * sizes_of(quick).size(); }

Figure cost_of_size(PaperRun& run) {
  const std::vector<double> sizes = sizes_of(run.quick);
  const double seconds = run.quick ? 1.2 : 4;
  Figure figure;
  figure.heading = "Total time against the number of bodies";
  figure.file_name = "groups.svg";
  figure.table.title = figure.heading + ": ms a step";
  figure.table.header = {"N"};
  LinePlot plot;
  plot.title = figure.heading + ", with contact groups and without";
  plot.x = {"bodies", Scale::log, false, sizes};
  plot.y = {"total time, s", Scale::log, false, {}};
  plot.marks = {{512, "paper: clear gain of groups from here"}};
  plot.note = "falling, first " + short_number(seconds) +
              " s, in one heap or spread out; linear search as in the paper unless named";
  for (const double n : sizes) figure.table.rows.push_back({short_number(n)});
  std::vector<double> in_largest(sizes.size());
  for (const Setting& s : kSettings) {
    figure.table.header.push_back(s.label);
    Series series{s.label, {}, s.colour, false};
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      const auto told = [&](double done) {
        run.progress(std::string(s.label) + ", N = " + short_number(sizes[i]), done);
      };
      told(0);
      const Measured m =
          measure(run.engine, {"falling", s.crowd.settings(sizes[i]), {s.search, s.groups}, seconds}, told);
      series.points.push_back({sizes[i], m.run.total_seconds});
      figure.table.rows[i].push_back(number(m.ms()));
      if (&s == &kSettings[2]) in_largest[i] = m.contacts > 0 ? 100 * m.largest_group / m.contacts : 0;
    }
    plot.series.push_back(series);
  }
  // How much of all contact lies in one group bounds what groups can save.
  figure.table.header.push_back("heap: contacts in largest group, %");
  for (std::size_t i = 0; i < sizes.size(); ++i) figure.table.rows[i].push_back(number(in_largest[i]));
  figure.remarks.push_back(judge("one heap", plot.series[0].points, plot.series[1].points));
  figure.remarks.push_back(judge("many small heaps", plot.series[3].points, plot.series[4].points));
  figure.remarks.push_back(
      "Groups save what the search for the most severe contact would spend on contacts that have nothing to do with "
      "each "
      "other. In one heap nearly all contacts are in one group (last column) and there is nothing to save; the paper "
      "does "
      "not say how its bodies lay.");
  const auto slope = [&](int k) {
    const auto& p = plot.series[static_cast<std::size_t>(k)].points;
    return number(exponent(p[p.size() - 2], p.back()), 2);
  };
  figure.remarks.push_back("Between the two largest sizes time grows as N^" + slope(0) +
                           " in one heap with a linear search, N^" + slope(2) + " with a heap search, N^" + slope(4) +
                           " spread out, with groups and a linear search.");
  figure.drawing = draw(plot);
  return figure;
}

}  // namespace carom::report
