// Ranges and ticks.
#include "report/axis.h"

#include <algorithm>
#include <cmath>

namespace carom::report {
namespace {

double round_step(double span) {
  const double raw = span / 5;
  const double decade = std::pow(10, std::floor(std::log10(raw)));
  const double lead = raw / decade;
  return (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10) * decade;
}

Axis linear(const AxisSpec& spec, double min, double max) {
  if (spec.from_zero) {
    min = std::min(min, 0.0);
    max = std::max(max, 0.0);
  }
  if (!(max > min)) max = min + 1;
  Axis axis{Scale::linear, min, max, {}};
  const double step = round_step(max - min);
  const double first = std::floor(min / step + 1e-9), last = std::ceil(max / step - 1e-9);
  for (double k = first; k <= last; ++k) axis.ticks.push_back(k * step);
  axis.low = axis.ticks.front();
  axis.high = axis.ticks.back();
  return axis;
}

Axis logarithmic(double min, double max) {
  if (!(min > 0)) min = max > 0 ? max : 1;
  if (!(max > 0)) max = min;
  const double first = std::floor(std::log10(min) + 1e-9),
               last = std::max(first + 1, std::ceil(std::log10(max) - 1e-9));
  Axis axis{Scale::log, std::pow(10, first), std::pow(10, last), {}};
  for (double k = first; k <= last; ++k) {
    axis.ticks.push_back(std::pow(10, k));
    if (last - first < 3 && k < last) {
      axis.ticks.push_back(2 * std::pow(10, k));
      axis.ticks.push_back(5 * std::pow(10, k));
    }
  }
  return axis;
}

}  // namespace

double Axis::at(double value) const {
  if (scale == Scale::linear) return (value - low) / (high - low);
  if (!(value > 0)) return 0;
  return std::log(value / low) / std::log(high / low);
}

Axis fit_axis(const AxisSpec& spec, double min, double max) {
  if (min > max) std::swap(min, max);
  if (!spec.ticks.empty()) {
    Axis axis{spec.scale, std::min(min, spec.ticks.front()), std::max(max, spec.ticks.back()), spec.ticks};
    if (spec.scale == Scale::log && !(axis.low > 0)) axis.low = spec.ticks.front();
    return axis;
  }
  return spec.scale == Scale::linear ? linear(spec, min, max) : logarithmic(min, max);
}

}  // namespace carom::report
