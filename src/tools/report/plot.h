// Line plots and bar charts: ours in colour, another author's figures as dashed grey marks beside them.
#pragma once

#include <string>
#include <vector>

#include "report/axis.h"
#include "report/svg.h"

namespace carom::report {

struct Series {
  std::string name;           ///< written where the line ends
  std::vector<Point> points;  ///< data, in the axes' units; y upward
  int colour = 0;             ///< 0..5
  bool reference = false;     ///< another author's: grey and dashed
};

/// Another author's figure that is a place on the x axis: a dashed line up from it.
struct Mark {
  double x = 0;
  std::string label;  ///< written at its top
};

struct LinePlot {
  std::string title;
  AxisSpec x, y;
  std::vector<Series> series;
  std::vector<Mark> marks;
  std::string note;    ///< one line under the plot: conditions
  bool dense = false;  ///< points are so many that the line alone is drawn
};

/// Draw a line plot, 760 x 440 px. A point that is not finite, or <= 0 on a log axis, is left out.
std::string draw(const LinePlot& plot);

struct BarPart {
  std::string name;  ///< for the legend, shared by all rows
  double value = 0;
  int colour = 0;
};

/// One horizontal bar, made of parts laid end to end.
struct BarRow {
  std::string label;
  std::vector<BarPart> parts;
  std::string value_label;      ///< written after the bar
  double reference = 0;         ///< where the other author's mark stands; 0: there is none
  std::string reference_label;  ///< "paper 97 %"
};

struct BarChart {
  std::string title;
  AxisSpec value;
  std::vector<BarRow> rows;
  std::string note;
};

/// Draw horizontal bars, 760 px wide. On a log axis a bar begins at the axis' low end, so only bars of one part make
/// sense.
std::string draw(const BarChart& chart);

}  // namespace carom::report
