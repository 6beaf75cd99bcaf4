// A scene as the page of src/site takes it: the world as it starts, as bytes, and what to say of it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "cli/commands.h"
#include "cli/scene_choice.h"

namespace carom::tools {

struct PackedScene {
  std::string file;     ///< "wall.world": a name, no path
  std::string content;  ///< of that file
  std::string truth;    ///< "" or true poses: packed_truth.h; the row says under which name they are to be written
  nlohmann::json row;   ///< of the page's index: names of bodies, camera, step, hashes

  void rename(const std::string& name);  ///< in file and row; of other letters than a-z, 0-9, - and _ becomes _
};

/// How many steps are taken for the hashes that stand beside the page's.
struct HashedSteps {
  std::uint64_t most = 240;
  double seconds = 1e9;  ///< of computing; then no more are taken
};

/// A scene of `carom list`, of a file, or as "accuracy/slide" one of `carom accuracy list`.   @throws Error
PackedScene packed_scene(const SceneChoice& choice, const HashedSteps& steps, Context& context);

/// A recorded session (`carom run --record`), as it is: the page makes its calls again.   @throws Error
PackedScene packed_recording(const std::string& path);
bool is_recording(const std::string& path);

}  // namespace carom::tools
