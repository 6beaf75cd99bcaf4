// Scenes that the S-table alone has, beside those of `carom list`.
#pragma once

#include "scenes/scene.h"

namespace carom::bench {

/// pyramids, dominoes, dolls, or a scene of the library.   @throws Error with the names there are
const tools::Scene& find_scene(const std::string& name);

}  // namespace carom::bench
