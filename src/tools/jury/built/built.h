// Scenes that people build: families, each with sizes, masses, counts, friction and a step of its own by seed.
#pragma once

#include "jury/case.h"

namespace carom::tools::jury {

/// @param stage  empty
Case draw_built(std::uint64_t seed, Stage& stage);
/// Of which family a seed is: they take turns, so that a range of seeds has as many of each.
const char* family_of(std::uint64_t seed);
std::vector<std::string> all_families();

}  // namespace carom::tools::jury
