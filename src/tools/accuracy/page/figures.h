// The drawings of a report, each as one SVG element.
#pragma once

#include "accuracy/page/view.h"
#include "report/svg.h"

namespace carom::tools::accuracy {

/// Log error against log cost: a line a setting, dots from coarse to fine steps, each engine's front in bold, budgets of
/// a frame at 60 Hz, and what fell in a lane at the top.
report::Svg work_precision(const SceneView& scene, const View& view);

/// Error against step with fitted slopes, a panel for each scene of a topic.
report::Svg order_plot(const std::vector<const SceneView*>& scenes, const View& view, const std::string& title);

/// Stands or fell: step against a knob of a scene, a panel for each engine and setting.
report::Svg stability_map(const Sweep& sweep, const std::string& scene, const std::string& knob,
                          const std::string& title);

/// Share of scenes whose bound is reached within tau times the least cost.   @param solvers  name, engine, prefix of
/// settings
struct Solver {
  std::string name, engine, prefix;
};
std::string performance_profile(const std::vector<const SceneView*>& scenes, const std::vector<Solver>& solvers,
                                const std::string& title);

/// The mark of a setting's solver: circle auto, square direct, triangle soft_step, diamond others.
report::Svg::Mark mark_of(const std::string& setting);

}  // namespace carom::tools::accuracy
