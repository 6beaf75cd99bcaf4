// What a reader of the report can turn: filters, the order, a budget, the look. Mark-up, style and script.
#pragma once

#include <string>
#include <vector>

namespace carom::tools::accuracy {

/// A bar that stays in sight. `settings` are those that deserve a filter of their own: presets.
/// It finds what it filters by attributes: data-engine, data-name (of a setting), data-scene; what it sorts by
/// data-lead, in elements of class `sorted`; what it fills in by the table `budget-table`, from elements of class
/// `dot`.
std::string controls_markup(const std::vector<std::string>& engines, const std::vector<std::string>& settings,
                            const std::vector<std::string>& scenes);
std::string controls_style();
std::string controls_script();

/// The budget at which a page opens.
inline constexpr double kFirstBudget = 1e-4;  ///< s a frame at 60 Hz

}  // namespace carom::tools::accuracy
