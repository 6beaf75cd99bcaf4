// An axis: from a value of the data to a place on the drawing, linear or logarithmic, and where its ticks stand.
#pragma once

#include <string>
#include <vector>

namespace carom::report {

enum class Scale { linear, log };

/// What an axis shall show; the range is widened to whole ticks.
struct AxisSpec {
  std::string label;
  Scale scale = Scale::linear;
  bool from_zero = true;      ///< linear axes only: 0 is on the axis
  std::vector<double> ticks;  ///< if given: exactly these ticks, and the range is theirs and the data's
};

struct Axis {
  Scale scale = Scale::linear;
  double low = 0;
  double high = 1;
  std::vector<double> ticks;

  /// Place of a value along the axis: 0 at `low`, 1 at `high`; linear in the value, or in its logarithm.
  /// On a log axis a value <= 0 stands at 0.
  double at(double value) const;
};

/// An axis that shows all of [min, max].
///   linear: ticks at 1, 2 or 5 times a power of ten, four to ten of them
///   log:    ticks at the powers of ten; with 1, 2, 5 in each decade if there are fewer than three
/// @param min, max  finite, any order; on a log axis both > 0 (a value <= 0 is taken for the other one, both: 1)
Axis fit_axis(const AxisSpec& spec, double min, double max);

}  // namespace carom::report
