#include "accuracy/page/findings.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "accuracy/sweep/settings.h"

namespace carom::tools::accuracy {
namespace {

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

}  // namespace

std::string at_text(const Row& row) { return row.setting + ", " + step_text(row.dt); }

std::string format(const char* pattern, ...) {
  char text[1024];
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(text, sizeof text, pattern, arguments);
  va_end(arguments);
  return text;
}

std::vector<const SceneView*> scenes_where(const View& view, const std::function<bool(const SceneView&)>& holds) {
  std::vector<const SceneView*> list;
  for (const SceneView& scene : view.scenes)
    if (holds(scene)) list.push_back(&scene);
  return list;
}

bool has_ours(const SceneView& scene) {
  return std::any_of(scene.lines.begin(), scene.lines.end(), [](const Line& l) { return l.engine == kOurs; });
}
bool has_peers(const SceneView& scene) {
  return std::any_of(scene.lines.begin(), scene.lines.end(), [](const Line& l) { return l.engine != kOurs; });
}
bool has_bound(const SceneView& scene) { return std::isfinite(scene.challenge->metrics[0].bound); }
bool compared(const SceneView& scene) { return has_ours(scene) && has_peers(scene); }

const Row* default_row(const SceneView& scene) {
  for (const Line& line : scene.lines)
    if (line.engine == kOurs && line.setting == kDefaultSetting)
      for (const Row* row : line.rows)
        if (std::fabs(row->dt - 1.0 / 60) < 1e-9 && !row->left_out) return row;
  return nullptr;
}

const Row* cheapest_within(const SceneView& scene, const std::string& engine) {
  const Cloud cloud = cloud_of(scene, engine);
  const Row* best = nullptr;
  for (const Row* row : cloud.rows)
    if (row->errors[0] <= scene.challenge->metrics[0].bound && (!best || row->cost < best->cost)) best = row;
  return best;
}

std::vector<std::string> findings(const View& view) {
  std::vector<std::string> list;
  const auto ours = scenes_where(view, has_ours);
  std::vector<std::string> beyond, lost;
  std::size_t held = 0, reached = 0, judged = 0, ran = 0;
  std::vector<double> orders;
  for (const SceneView* scene : ours) {
    const Metric& metric = scene->challenge->metrics[0];
    if (const Row* row = default_row(*scene)) {
      ++ran;
      if (row->fell_at >= 0)
        lost.push_back(scene->challenge->scene.name);
      else if (row->errors[0] <= metric.bound)
        ++held;
    }
    if (!has_bound(*scene)) continue;
    ++judged;
    if (cheapest_within(*scene, kOurs))
      ++reached;
    else
      beyond.push_back(scene->challenge->scene.name);
  }
  list.push_back(format("At its defaults and 60 steps a second Carom is within the bound of %zu of %zu scenes%s.", held,
                        ran,
                        lost.empty() ? "; nothing that should stand falls" : ("; " + join(lost) + " fell").c_str()));
  list.push_back(format("With the best of its settings it reaches the bound of %zu of %zu scenes that have one%s.",
                        reached, judged, beyond.empty() ? "" : ("; not of " + join(beyond)).c_str()));
  const auto met = scenes_where(view, compared);
  if (!met.empty()) {
    std::vector<std::string> behind;
    std::size_t sooner = 0, only_us = 0, only_them = 0;
    for (const SceneView* scene : met) {
      const Lead lead = worst_lead(*scene);
      if (lead.ratio > kClearLead) behind.push_back(scene->challenge->scene.name + " (" + ratio_text(lead.ratio) + ")");
      const Row *a = cheapest_within(*scene, kOurs), *b = cheapest_within(*scene, "");
      if (a && b && a->cost <= b->cost) ++sooner;
      if (a && !b) ++only_us;
      if (b && !a) ++only_them;
    }
    list.push_back(
        format("On %zu of the %zu scenes that other engines ran too, no front of theirs is below Carom's at any "
               "cost%s.",
               met.size() - behind.size(), met.size(),
               behind.empty() ? "" : (". Somewhere below it on " + join(behind) + "; see the red rows").c_str()));
    list.push_back(
        format("Of these scenes Carom alone reaches the bound on %zu, others alone on %zu; where both do, Carom "
               "does so at less cost on %zu.",
               only_us, only_them, sooner));
  }
  for (const SceneView* scene : ours)
    for (const Line& line : scene->lines)
      if (line.engine == kOurs && line.setting == kDefaultSetting) {
        std::vector<std::pair<double, double>> data;
        for (const Row* row : line.rows)
          if (row->usable()) data.emplace_back(row->dt, row->errors[0]);
        const Slope slope = fit_slope(data, kRounding);
        if (slope.points >= 4) orders.push_back(slope.order);
      }
  if (!orders.empty()) {
    std::sort(orders.begin(), orders.end());
    list.push_back(
        format("Half the step is worth a factor of %.2g in error (median over %zu scenes at the defaults: order "
               "%.2g).",
               std::pow(2, orders[orders.size() / 2]), orders.size(), orders[orders.size() / 2]));
  }
  return list;
}

}  // namespace carom::tools::accuracy
