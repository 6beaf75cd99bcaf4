// For every effect a scene of which so many bodies call for it, and the others for nothing.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "world_builder.h"

namespace carom::bench {

struct Crowd {
  std::size_t row;               // of the table of effects
  std::string name;              // the effect's, and what its participants are like where that matters
  std::uint32_t bodies = 10000;  // 1,000 where contacts or joints are solved
  bool can_be_alone = true;      // false: who calls for it is everybody, or a single host
  std::function<void(test::TestWorld&, std::uint32_t bodies, std::uint32_t calling)> build;
  std::function<void(test::TestWorld&, std::uint32_t calling)> before_step = nullptr;  // what a host does in each
};

/// At least one for each row of the table.
std::vector<Crowd> crowds();

}  // namespace carom::bench
