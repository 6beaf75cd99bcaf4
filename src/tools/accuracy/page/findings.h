// What a report says in words: sentences made from the rows of a sweep, and how rows are chosen for them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "accuracy/page/figures.h"

namespace carom::tools::accuracy {

/// As printf.
std::string format(const char* pattern, ...) __attribute__((format(printf, 1, 2)));
/// A row's setting and step.
std::string at_text(const Row& row);
std::vector<const SceneView*> scenes_where(const View& view, const std::function<bool(const SceneView&)>& holds);
bool has_ours(const SceneView& scene);
bool has_bound(const SceneView& scene);
bool compared(const SceneView& scene);
const Row* default_row(const SceneView& scene);
/// The cheapest row of an engine (of all others, where it is empty) whose first error is within its bound.
const Row* cheapest_within(const SceneView& scene, const std::string& engine);
/// Sentences that a reader in a hurry needs, made from the rows.
std::vector<std::string> findings(const View& view);

}  // namespace carom::tools::accuracy
