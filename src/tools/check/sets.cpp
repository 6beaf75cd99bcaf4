// Directions and parameter sets that a plugin is tried with.
#include "check/sets.h"

#include <algorithm>
#include <cmath>

#include "scenes/random.h"

namespace carom::tools {
namespace {

/// A parameter drawn log-uniformly from the sizes that scenes use, inside its bounds; 0 now and then where it is legal.
double draw(const carom_param& bounds, Random& random) {
  const double size = std::pow(10.0, random.between(-3, 3));
  if (bounds.min > 0) return std::clamp(size, bounds.min, bounds.max);
  if (bounds.min <= 0 && bounds.max >= 0 && random.unit() < 0.1) return 0;
  const bool negative = bounds.max <= 0 || (bounds.min < 0 && random.unit() < 0.5);
  return std::clamp(negative ? -size : size, bounds.min, bounds.max);
}

const carom_param& bounds_of(const carom_shape_plugin& plugin, std::size_t index) {
  if (index < plugin.param_count) return plugin.params[index];
  const std::size_t tail = plugin.param_tail_group;
  return plugin.params[plugin.param_count - tail + (index - plugin.param_count) % tail];
}

}  // namespace

std::vector<Direction> trial_directions(std::size_t count) {
  std::vector<Direction> list;
  auto add = [&](double x, double y, double z) {
    const double length = std::sqrt(x * x + y * y + z * z);
    if (length > 0) list.push_back({x / length, y / length, z / length});
  };
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) add(x, y, z);
  for (double tilt : {1e-3, 1e-9})  // where a face, an edge or a rim hands over to its neighbour
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (double sign : {-1.0, 1.0})
        for (std::size_t other = 1; other < 3; ++other)
          for (double side : {-tilt, tilt}) {
            Direction d = {0, 0, 0};
            d[axis] = sign;
            d[(axis + other) % 3] = side;
            add(d[0], d[1], d[2]);
          }
  Random random(7);
  while (list.size() < count) {
    const Eigen::Vector3d d = random.direction();
    add(d.x(), d.y(), d.z());
  }
  return list;
}

bool keeps_rules(const carom_shape_plugin& plugin, const std::vector<double>& params) {
  if (plugin.struct_size < sizeof plugin) return true;  // of a time before there were rules
  for (std::uint32_t k = 0; k < plugin.rule_count; ++k) {
    const carom_param_rule& rule = plugin.rules[k];
    double sum = 0;
    for (std::uint32_t i = 0; i < rule.term_count; ++i) sum += rule.weight[i] * params[rule.param[i]];
    if (!(sum <= rule.most)) return false;
  }
  return true;
}

std::vector<std::vector<double>> trial_params(const carom_shape_plugin& plugin, std::size_t* ordinary) {
  Random random(11);
  std::vector<std::vector<double>> sets;
  const std::size_t tail = plugin.param_tail_group;
  auto fill = [&](std::size_t groups, auto&& value) {
    std::vector<double> set;
    for (std::size_t i = 0; i < plugin.param_count + groups * tail; ++i) set.push_back(value(bounds_of(plugin, i)));
    for (int again = 0; again < 1000 && !keeps_rules(plugin, set); ++again)  // drawn until its rules hold
      for (std::size_t i = 0; i < set.size(); ++i) set[i] = draw(bounds_of(plugin, i), random);
    if (keeps_rules(plugin, set)) sets.push_back(std::move(set));
  };
  const std::size_t fewest = tail && plugin.param_tail_min > 1 ? plugin.param_tail_min - 1 : 0;
  auto more = [&] { return tail ? fewest + 3 + static_cast<std::size_t>(random.bits() % 20) : 0; };
  // Coordinates that repeat would all be one point if every parameter were 1, so those are drawn.
  fill(more(), [&](const carom_param& p) { return tail ? draw(p, random) : std::clamp(1.0, p.min, p.max); });
  if (plugin.param_count == 0) {
    *ordinary = sets.size();
    return sets;
  }
  for (int i = 0; i < 9; ++i) fill(more(), [&](const carom_param& p) { return draw(p, random); });
  *ordinary = sets.size();
  const double huge = 1e12;  // m: bounds may be open; sizes beyond this mean nothing
  fill(fewest, [&](const carom_param& p) { return std::max(p.min, -huge); });
  fill(fewest, [&](const carom_param& p) { return std::min(p.max, huge); });
  for (int i = 0; i < 2; ++i)
    fill(fewest,
         [&](const carom_param& p) { return random.unit() < 0.5 ? std::max(p.min, -huge) : std::min(p.max, huge); });
  return sets;
}

}  // namespace carom::tools
