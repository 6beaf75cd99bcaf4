// Where bodies of an accuracy scene ought to be at each step, as the page of src/site draws them beside where they are.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "cli/commands.h"
#include "scenes/scene.h"

namespace carom::tools {

/// "accuracy/slide": a scene of `carom accuracy list`, by a name that no scene of `carom list` has.
bool is_accuracy_scene(const std::string& name);
/// @throws Error
const Scene& accuracy_scene(const std::string& name);
/// "accuracy/slide" and all others whose truth is poses, in the order of the suite.
std::vector<std::string> scenes_with_true_poses(Context& context);

struct PackedTruth {
  std::string content;  ///< frames of poses: x, y, z, then x, y, z, w of the turn, NaN where none is known; F64
  nlohmann::json row;   ///< bodies, by index of the page's names; frames: one a step, or one that holds for all
};

/// @param stage, observer  filled, and not stepped yet   @return empty content where the scene knows no poses
PackedTruth packed_truth(const Stage& stage, Observer& observer, double dt, double seconds);

}  // namespace carom::tools
